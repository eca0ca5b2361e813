"""Specific pressures of crank pins and main bearings: load over diameter and width."""

from collections.abc import Callable

import numpy as np

from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.questions.crankshaft.parts import DeclaredCrankshaft, DeclaredCrankshafts
from cranktrain.questions.crankshaft.results.main_bearing_loads import MainBearingLoads
from cranktrain.questions.crankshaft.shaft_layout import ShaftLayouts
from cranktrain.questions.forces.crank_pins import CrankPinLoads
from cranktrain.questions.wear.pin_wear import CrankPinWear
from cranktrain.record import record
from cranktrain.references import THEORY_OF_CRANKSHAFT as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import StageResult

_PIN, _BEARING = ("mechanism",), ("bearing_method", "bearing")


@record
class CrankPinPressures(StageResult):
    """Specific pressure of the rods' bearings on their crank pins; NaN where no width is given."""

    largest_crankpin_pressure: Array = quantity(
        "p_P,max",
        "Pa",
        _PIN,
        N_("Largest specific pressure of the rod's bearing on the crank pin"),
        _THEORY,
        "24.48",
        worst="largest",
    )
    mean_crankpin_pressure: Array = quantity(
        "p_P,m", "Pa", _PIN, N_("Mean specific pressure of the rod's bearing on the crank pin"), _THEORY, "24.48"
    )


@record
class MainBearingPressures(StageResult):
    """Specific pressure of the main bearings, by each method; NaN where no width is given."""

    largest_bearing_pressure: Array = quantity(
        "p_max", "Pa", _BEARING, N_("Largest specific pressure of the main bearing"), _THEORY, "24.48", worst="largest"
    )
    mean_bearing_pressure: Array = quantity(
        "p_m", "Pa", _BEARING, N_("Mean specific pressure of the main bearing"), _THEORY, "24.48"
    )


def specific_pressure(load: Array, diameter: Array, width: Array) -> Array:
    """Load over diameter and width, elementwise; docs/theory/crankshaft, eq. (24.48). [Pa]

    Examples
    --------
    20 kN on 50 mm by 25 mm:

    >>> round(float(specific_pressure(np.array(20e3), np.array(0.05), np.array(0.025))))
    16000000
    """
    return load / (diameter * width)


def have_rod_widths(declared: DeclaredCrankshafts | None) -> bool | str:
    """Whether the width of any rod's bearing is given."""
    return _given(declared, lambda shaft: shaft.rod_bearing_width, N_("[crankshaft] rod_bearing_width"))


def have_bearing_widths(declared: DeclaredCrankshafts | None) -> bool | str:
    """Whether the width of any main bearing is given."""
    return _given(declared, lambda shaft: shaft.bearing_width, N_("[crankshaft] bearing_width"))


def crank_pin_pressures(layouts: ShaftLayouts, loads: CrankPinLoads, wear: CrankPinWear) -> CrankPinPressures:
    """Pressures of all rods on pins of the declared crankshafts; of one with two side rods, those of each."""
    largest = loads.largest_crankpin_load.value
    per_load = np.full(largest.shape, np.nan)
    for layout in layouts.each:
        mechanism, pin = layout.rods
        declared = layout.declared
        by_rod = specific_pressure(
            declared.share[pin], declared.pin[:, pin, 0], declared.rod_bearing_width[:, np.newaxis]
        )
        for member in np.unique(mechanism).tolist():
            per_load[:, member] = np.max(by_rod[:, mechanism == member], axis=1)
    return CrankPinPressures(largest * per_load, wear.mean_crankpin_load * per_load)


def main_bearing_pressures(declared: DeclaredCrankshafts, loads: MainBearingLoads) -> MainBearingPressures:
    """Pressures of all main bearings; docs/theory/crankshaft, eq. (24.48)."""
    diameter = np.concatenate([shaft.at_bearings for shaft in declared.each], axis=1)[:, np.newaxis]
    width = np.concatenate([shaft.bearing_width for shaft in declared.each], axis=1)[:, np.newaxis]
    largest, mean = loads.largest_bearing_load.value, loads.mean_bearing_load
    return MainBearingPressures(*(specific_pressure(load, diameter, width) for load in (largest, mean)))


def _given(
    declared: DeclaredCrankshafts | None, width: Callable[[DeclaredCrankshaft], Array], needs: str
) -> bool | str:
    """Whether a width is given of any crankshaft; what the file would have to say."""
    if declared is None:
        return DeclaredCrankshafts.needs
    return True if any(np.any(np.isfinite(width(shaft))) for shaft in declared.each) else needs
