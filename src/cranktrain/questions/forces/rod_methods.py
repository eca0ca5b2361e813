"""Rods replaced by masses, as textbooks do: by how much side force and torque are off, by method."""

import numpy as np

from cranktrain.language import N_
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.mechanisms import Pistons
from cranktrain.linkage.forces import WEIGHTLESS, Wrench, work
from cranktrain.motion import Array
from cranktrain.numerics.harmonics import TURN
from cranktrain.numerics.periodic import cycle_grid
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.forces.peaks import relative
from cranktrain.questions.forces.piston_forces import direct_batches
from cranktrain.questions.forces.rod_masses import ROD_METHODS
from cranktrain.questions.forces.solved_cycle import SolvedCycle
from cranktrain.record import record
from cranktrain.references import THEORY_OF_FORCES as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import StageResult

_FACT = ("rod_method", "piston")
_EXACT = list(ROD_METHODS).index("exact")


@record
class RodMethods(StageResult):
    """Errors of rods replaced by masses, in parts of the exact peak; 0 where a method is exact.

    NaN for pistons that hang on no crank pin, and where the replacement cannot have the rod's centroid.
    """

    side_force_error: Array = quantity(
        "ΔN",
        "1",
        _FACT,
        N_("Largest error of the guide's force, at whole degrees, with the rod replaced by the method's masses"),
        _THEORY,
        "13.37",
    )
    driving_torque_error: Array = quantity(
        "ΔM",
        "1",
        _FACT,
        N_("Largest error of the piston's driving torque, at whole degrees, with the rod so replaced"),
        _THEORY,
        "13.37",
    )


def rod_methods(pistons: Pistons, loaded: LoadedMachine, solved: SolvedCycle, crank_angle: CrankAngle) -> RodMethods:
    """Errors of every method against the rigid rod in steps of 1°, in parts of the peaks of the cycle.

    Over one turn, as all turns are alike at constant speed; else over the cycle.

    Notes
    -----
    All methods have the rod's mass and centroid, so that they differ by a couple on the rod alone: it presses the guide
    with −C/(L cos θ) and turns the crank by Cθ′. docs/theory/forces, eq. (13.37).
    """
    shape = (len(loaded.speed.value), len(ROD_METHODS), len(pistons.names))
    side, torque = np.full((2, *shape), np.nan)
    n_turns = 1 if loaded.speed.curve is None else round(crank_angle.cycle / TURN)
    angle = cycle_grid(360 * n_turns, n_turns * TURN)
    drive = loaded.speed.drive(angle)
    for place, batch in direct_batches(loaded):
        size = batch.members.geometry
        rod = batch.kind.motion(angle + batch.members.phase, size).rod
        body = batch.kind.dynamics.by_link(loaded.masses.batches[place].bodies)["rod"]
        forces = solved.batches[place].forces
        guide_place = batch.kind.dynamics.joint("guide")
        assert guide_place is not None  # of each piston that is driven directly
        piston = loaded.carriers.piston[batch.index]
        found = [method(rod, body, size.rod_length, drive, WEIGHTLESS) for method in ROD_METHODS.values()]
        exact = found[_EXACT]
        off = [Wrench(*(np.subtract(one, true) for one, true in zip(wrench, exact, strict=True))) for wrench in found]
        across = np.stack([one.moment for one in off], axis=1) / (size.rod_length * rod.cos)[:, np.newaxis]
        turning = np.stack([work(rod, one) for one in off], axis=1)
        side[:, :, piston] = relative(across, forces.joints[guide_place].y[:, np.newaxis])
        torque[:, :, piston] = relative(turning, forces.driving_torque[:, np.newaxis])
    return RodMethods(side, torque, labels={"rod_method": tuple(ROD_METHODS)})
