"""Crank pins over the cycle: mean loads, wear of pins and of the rods' bearings on them, places for oil holes."""

import numpy as np

from cranktrain.language import N_
from cranktrain.linkage import Crank
from cranktrain.linkage.forces import crank_link
from cranktrain.motion import Array
from cranktrain.numerics.nested import put
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.forces.pin_load import PinLoad, RodBearingLoad, pin_load, rod_bearing_load
from cranktrain.questions.wear.cycle_points import CyclePoints
from cranktrain.record import record
from cranktrain.references import THEORY_OF_CRANKSHAFT as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import StageResult

_FACT, _RAYS = ("mechanism",), ("mechanism", "ray")


@record
class CrankPinWear(StageResult):
    """Means over the cycle of what rods and crank pins do to each other; NaN for what has no rod on a crank pin."""

    mean_crankpin_load: Array = quantity("R_m", "N", _FACT, N_("Mean size of the crank pin's load"), _THEORY, "24.45")
    crankpin_wear: Array = quantity(
        "W",
        "N",
        _RAYS,
        N_("Mean load on each ray of the crank pin, from its outermost point in the sense of rotation"),
        _THEORY,
        "24.46, 24.47",
    )
    crankpin_oil_hole: Array = quantity(
        "γ_h",
        "rad",
        _FACT,
        N_("Place for the oil hole of the crank pin, from its outermost point in the sense of rotation"),
        _THEORY,
        "24.46, 24.47",
    )
    rod_bearing_wear: Array = quantity(
        "W_S",
        "N",
        _RAYS,
        N_("Mean load on each ray of the rod's bearing, from the rod's line in the sense of rotation"),
        _THEORY,
        "24.46, 24.47",
    )


def crank_pin_wear(loaded: LoadedMachine, points: CyclePoints) -> CrankPinWear:
    """Means and wear of all crank pins, by quadrature between events.

    Notes
    -----
    docs/theory/crankshaft, eqs. (24.46) and (24.47).
    """
    shape = (len(points.angle), len(loaded.mechanisms.names), points.angle.shape[-1])
    pins, shells = (np.full((2, *shape), np.nan) for _both in range(2))
    for batch, solved in zip(loaded.mechanisms.batches, points.solved, strict=True):
        joint = batch.kind.dynamics.joint("crank_pin")
        if joint is None:
            continue
        on_rod = solved.forces.joints[joint]
        radius: Array = np.hypot(solved.motion.pin.x.value, solved.motion.pin.y.value)[..., :1]
        put(PinLoad(*pins), batch.index, pin_load(on_rod, crank_link(solved.motion.pin, Crank(radius))))
        if batch.kind.dynamics.reactions[joint].on == "rod":
            put(RodBearingLoad(*shells), batch.index, rod_bearing_load(on_rod, solved.motion.rod))
    for each in (pins, shells):
        each[:, loaded.unheld] = np.nan
    radial, tangential = pins
    # The rod presses the pin where its load comes from, and its own bearing where the pin's load on it goes to.
    pin, shell = points.wear((radial, -tangential), tuple(shells))
    return CrankPinWear(
        mean_crankpin_load=points.mean_size(radial, tangential),
        crankpin_wear=pin.rays,
        crankpin_oil_hole=pin.hole,
        rod_bearing_wear=shell.rays,
    )
