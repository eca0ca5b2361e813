"""Rod loads: what piston rod, crosshead pin and connecting rod bear over the cycle, and the largest of either sense."""

from collections.abc import Sequence
from functools import partial

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.mechanisms import Pistons
from cranktrain.motion import Array
from cranktrain.numerics import Extreme
from cranktrain.numerics.nested import put
from cranktrain.questions.cylinders.volumes import Chambers
from cranktrain.questions.forces.events import ForceEvents
from cranktrain.questions.forces.loaded_machine import LoadedMachine, SolvedBatch
from cranktrain.questions.forces.peaks import MachineCurves, largest_together
from cranktrain.questions.forces.piston_formulas import inertia_force
from cranktrain.questions.forces.rods_in_pistons import rods_in_pistons
from cranktrain.questions.forces.solved_cycle import SolvedCycle
from cranktrain.questions.motion.rods import on_rods
from cranktrain.questions.rod_load.declared import DeclaredRodLoads
from cranktrain.record import record
from cranktrain.references import THEORY_OF_FORCES as _THEORY
from cranktrain.saying.catalogue import extreme, quantity
from cranktrain.saying.checks import StageResult
from cranktrain.saying.labels import Titles

PLACES = ("gas", "piston_rod", "crosshead_pin", "crank_pin")
"""The gas load alone; along the cylinder in the piston rod and in the crosshead pin; along the connecting rod."""
PLACE_TITLES: Titles = {
    "gas": N_("gas alone"),
    "piston_rod": N_("piston rod"),
    "crosshead_pin": N_("crosshead pin"),
    "crank_pin": N_("crank pin"),
}
GAS, PISTON_ROD, CROSSHEAD_PIN, CRANK_PIN = range(len(PLACES))
_FACT = ("rod_load_place", "piston")


def have_rod_loads(pistons: Pistons, declared: DeclaredRodLoads | None, chambers: Chambers | None) -> bool | str:
    """Whether there are piston rods: in double-acting cylinders with gas, or asked for."""
    if declared is None:
        return DeclaredRodLoads.needs
    is_double_acting = chambers is not None and chambers.are_double_acting
    return on_rods(pistons) and (declared.is_asked or is_double_acting or DeclaredRodLoads.needs)


@record
class RodLoadCurves(MachineCurves):
    """Rod loads that there are, in compression, and then the same in tension: of which place and which piston each is.

    Attributes
    ----------
    place, piston : array of int, shape (curve,)
    whole : Array, shape (design, place, piston, n)
        On the grid, positive in compression; NaN for what there is not.
    """

    place: NDArray[np.intp]
    piston: NDArray[np.intp]
    whole: Array


def rod_load_curves(
    pistons: Pistons, declared: DeclaredRodLoads, loaded: LoadedMachine, solved: SolvedCycle
) -> RodLoadCurves:
    """Rod loads on the grid, and anywhere between; docs/theory/forces, eqs. (13.55) and (13.56)."""
    whole = _loads(declared, len(pistons.names), loaded, solved.batches)
    place, piston = np.nonzero(~np.all(np.isnan(whole), axis=(0, -1)))
    pick = partial(_either_way, declared, whole.shape[2], loaded, (place, piston))
    rows = np.tile(loaded.carriers.driven[piston], 2)
    return RodLoadCurves(rows, _with_opposites(whole[:, place, piston]), pick, place, piston, whole)


def _either_way(
    declared: DeclaredRodLoads,
    n_pistons: int,
    loaded: LoadedMachine,
    own: tuple[NDArray[np.intp], NDArray[np.intp]],
    batches: Sequence[SolvedBatch],
) -> Array:
    """Loads that there are, by place and piston, and the same in tension, shape (design, curve, n)."""
    return _with_opposites(_loads(declared, n_pistons, loaded, batches)[:, own[0], own[1]])


def _with_opposites(loads: Array) -> Array:
    return np.concatenate([loads, -loads], axis=1)


def _loads(declared: DeclaredRodLoads, n_pistons: int, loaded: LoadedMachine, batches: Sequence[SolvedBatch]) -> Array:
    """Loads at all places, shape (design, place, piston, n)."""
    rods = list(rods_in_pistons(loaded, batches))
    found = np.full((len(declared.crosshead), len(PLACES), n_pistons, rods[0].motion.slider.value.shape[-1]), np.nan)
    for one in rods:
        slider, piston = one.motion.slider, one.piston
        carried = one.piston_mass - declared.crosshead[:, piston, np.newaxis]
        in_rod = -one.on_piston.x + inertia_force(slider, carried, one.drive) - carried * one.gravity.x
        put(found.swapaxes(0, 1), piston, (-one.of_gas.x, in_rod, one.pins[1].x, one.forces.at_crank))
        if loaded.gas is None:
            found[:, GAS, piston] = np.nan
        if not one.is_on_pin:
            found[:, CRANK_PIN, piston] = np.nan
    return found


@record
class RodLoads(StageResult):
    """Rod loads of every piston: of the gas alone, and of gas and inertia in rod and pins."""

    rod_load: Array = quantity(
        "F",
        "N",
        (*_FACT, "crank_angle"),
        N_("Rod load, positive in compression; along the cylinder, at the crank pin along the connecting rod"),
        _THEORY,
        "13.55, 13.56",
    )
    largest_rod_compression: Extreme = extreme(
        "F_c",
        "N",
        _FACT,
        N_("Largest rod load in compression"),
        N_("Crank angle of the largest rod load in compression"),
        _THEORY,
        "13.55, 13.56",
        worst="largest",
        of="rod_load",
    )
    largest_rod_tension: Extreme = extreme(
        "F_t",
        "N",
        _FACT,
        N_("Largest rod load in tension"),
        N_("Crank angle of the largest rod load in tension"),
        _THEORY,
        "13.55, 13.56",
        worst="largest",
        of="rod_load",
    )


def rod_loads(
    pistons: Pistons, curves: RodLoadCurves, loaded: LoadedMachine, events: ForceEvents, crank_angle: CrankAngle
) -> RodLoads:
    """Largest loads of either sense, as roots between events; 0 where there is none."""
    (peak,) = largest_together(loaded, events, crank_angle, [curves])
    found = np.full((2, 2, len(curves.whole), len(PLACES), len(pistons.names)), np.nan)
    is_any = peak.value > 0
    for part, values in enumerate((np.where(is_any, peak.angle, np.nan), np.where(is_any, peak.value, 0.0))):
        for sense, own in enumerate(np.split(values, 2, axis=1)):
            found[sense, part][:, curves.place, curves.piston] = own
    return RodLoads(curves.whole, *(Extreme(*own) for own in found), labels={"rod_load_place": PLACES})
