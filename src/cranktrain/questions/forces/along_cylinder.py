"""What acts on pistons along their cylinders beside gas and inertia: loads of the file, and weight."""

import numpy as np

from cranktrain.language import N_
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.loads import Loads
from cranktrain.layout.masses import Masses
from cranktrain.layout.mechanisms import Pistons
from cranktrain.motion import Array
from cranktrain.numerics.nested import put
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.forces.rods_in_pistons import RodsOnGrid
from cranktrain.questions.forces.solved_cycle import SolvedCycle
from cranktrain.questions.motion.rods import on_rods
from cranktrain.record import record
from cranktrain.references import THEORY_OF_FORCES as _THEORY
from cranktrain.saying.catalogue import quantity

_CURVE = ("piston", "crank_angle")


@record
class PistonLoads:
    """Loads on the pistons of rods."""

    load_force: Array = quantity(
        "F", "N", _CURVE, N_("Force of loads on the piston along the cylinder, toward the shaft"), _THEORY, "13.30"
    )


@record
class PistonWeights:
    """Weight of the pistons of rods."""

    weight_force: Array = quantity(
        "G",
        "N",
        _CURVE,
        N_("Weight of piston and the rod's reciprocating share along the cylinder, toward the shaft"),
        _THEORY,
        "13.30",
    )


def are_loaded(pistons: Pistons, loads: Loads | None) -> bool:
    """Whether a load may act on a piston that hangs on a rod."""
    return loads is not None and any(load.is_slider for load in loads.each) and on_rods(pistons)


def are_heavy(pistons: Pistons, masses: Masses | None) -> bool:
    """Whether anything weighs on a piston that hangs on a rod."""
    batches = () if masses is None else masses.batches
    return on_rods(pistons) and any((part != 0.0).any() for made in batches for part in made.gravity)


def piston_loads(pistons: Pistons, loaded: LoadedMachine, solved: SolvedCycle, crank_angle: CrankAngle) -> PistonLoads:
    """Part of the loads that is along the cylinders; docs/theory/forces, eq. (13.30)."""
    found = _unknown(pistons, crank_angle)
    for batch, one in zip(loaded.mechanisms.batches, solved.batches, strict=True):
        if batch.kind.has_rod and batch.kind.output.is_slider:
            all_of, of_gas = (batch.kind.dynamics.by_link(loads)["slider"] for loads in (one.loads, one.pressed))
            put([found], loaded.carriers.piston[batch.index], [of_gas.x - all_of.x])
    return PistonLoads(found)


def piston_weights(pistons: Pistons, rods: RodsOnGrid, crank_angle: CrankAngle) -> PistonWeights:
    """Part of the weight that is along the cylinders; docs/theory/forces, eq. (13.30)."""
    found = _unknown(pistons, crank_angle)
    for one, _forces in rods.each:
        put([found], one.piston, [-one.reciprocating * one.gravity.x])
    return PistonWeights(found)


def _unknown(pistons: Pistons, crank_angle: CrankAngle) -> Array:
    """Curves of all pistons of which those without a rod have none, shape (design, piston, n)."""
    return np.full((len(crank_angle.zero), len(pistons.names), crank_angle.shown.size), np.nan)
