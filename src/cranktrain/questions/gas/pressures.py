"""Pressure of the gas over the cycle, its force on every piston, and, whatever the grid, its work and its peak."""

from collections.abc import Iterator
from dataclasses import field

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_, Words
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import Extreme, around_zero, in_windows, largest_between
from cranktrain.questions.cylinders.travel import CylinderTravel
from cranktrain.questions.cylinders.volumes import RATIO, SweptVolumes
from cranktrain.questions.gas.chambers import GasInChambers
from cranktrain.questions.gas.events import GasEvents
from cranktrain.questions.motion.dead_centres import ANGLE_ROUNDING
from cranktrain.questions.motion.pistons import PistonMotion
from cranktrain.record import record
from cranktrain.references import THEORY_OF_FORCES as _FORCES
from cranktrain.references import THEORY_OF_GAS as _THEORY
from cranktrain.saying.catalogue import extreme, quantity
from cranktrain.saying.checks import Flagged, Limit, flagged

_CHAMBER = ("chamber",)
_CURVE = ("chamber", "crank_angle")


# Heywood, Internal Combustion Engine Fundamentals, ch. 2.2: 8 to 12 with spark ignition, 12 to 24 in diesels.
_ENGINE_RATIO = Limit(
    30.0,
    "",
    N_("A compression ratio of {value} is more than any engine has, 24 in diesels: is its decimal point right?"),
)
# The largest firing pressures of production engines, of large diesels, are 25 to 30 MPa.
_PEAK_PRESSURE = Limit(
    40e6,
    "MPa",
    N_("A pressure of {value} is more than engines bear: are charge, compression ratio and pressure unit right?"),
)


@record
class GasPressures(Flagged):
    """Pressure of the gas, and what it does; cycle is that of the gas. [rad]"""

    gas_pressure: Array = quantity(
        "p", "Pa", _CURVE, N_("Absolute pressure in the chamber"), _THEORY, "14.4, 14.12, 14.16, 14.22"
    )
    gas_pressure_slope: Array = quantity(
        "p′",
        "Pa/rad",
        _CURVE,
        N_("Derivative of the pressure by the crank angle, where it does not jump"),
        _THEORY,
        "14.24",
    )
    gas_force: Array = quantity(
        "P_g",
        "N",
        ("piston", "crank_angle"),
        N_("Force of the gas less ambient pressure, toward the shaft"),
        _FORCES,
        "13.30",
    )
    indicated_work: Array = quantity("W_i", "J", _CHAMBER, N_("Work of the gas over a cycle, ∮p dV"), _THEORY, "14.8")
    indicated_mean_pressure: Array = quantity(
        "p_i",
        "Pa",
        _CHAMBER,
        N_("Indicated mean effective pressure: work over swept volume"),
        _THEORY,
        "14.8",
        line="{indicated_work} / {swept_volume}",
    )
    cycle: float = field(kw_only=True)

    def work_over(self, crank_angle: CrankAngle) -> Array:
        """Work of the gas over a cycle of the machine, one of its own or two, shape (design, chamber). [J]"""
        return self.indicated_work * round(crank_angle.cycle / self.cycle)


@record
class PeakPressures(Flagged):
    """Where the pressure of the gas is largest, and where it rises most."""

    peak_pressure: Extreme = extreme(
        "p_max",
        "Pa",
        _CHAMBER,
        N_("Largest pressure"),
        N_("Crank angle of the largest pressure"),
        _THEORY,
        "14.4, 14.12, 14.16, 14.22",
        worst="largest",
        of="gas_pressure",
    )
    peak_pressure_after: Array = quantity(
        "α(p_max)",
        "deg",
        _CHAMBER,
        N_("Largest pressure after the least volume"),
        _THEORY,
        "14.4, 14.12, 14.16, 14.22",
        worst="largest",
    )
    steepest_pressure_rise: Extreme = extreme(
        "p′_max",
        "Pa/rad",
        _CHAMBER,
        N_("Largest rise of the pressure by the crank angle, where it does not jump"),
        N_("Crank angle of the largest rise of the pressure"),
        _THEORY,
        "14.24",
    )


def gas_pressures(
    gas: GasInChambers, swept: SweptVolumes, crank_angle: CrankAngle, motion: PistonMotion
) -> GasPressures:
    """Pressure over the cycle, its force, and, whatever the grid, its work; docs/theory/gas, eq. (14.8)."""
    phi = crank_angle.angle
    displacement = motion.piston_displacement
    volume = gas.volume_by(Coefficient(gas.tops - displacement.value, -displacement.first, -displacement.second))
    pressure, slope = gas.pressure_and_slope(phi, volume)
    # In closed form, or exactly over what was laid through samples.
    work = gas.by_chamber((one, one.fluid.work(one.ready, one.rooms)) for one in gas.fillings)
    return GasPressures(
        cycle=gas.cycle,
        gas_pressure=pressure,
        gas_pressure_slope=slope,
        gas_force=gas.force(pressure),
        indicated_work=work,
        indicated_mean_pressure=work / swept.swept_volume,
        unlikely=tuple(_unlikely_ratios(gas, work > 0)),
    )


def _unlikely_ratios(gas: GasInChambers, fires: NDArray[np.bool_]) -> Iterator[Words]:
    """Flags of ratios that no engine has, of chambers that give work, shape (design, chamber)."""
    ratio = (gas.limits.largest / gas.limits.smallest)[..., 0]
    # What no machine at all has is flagged where the ratio is found.
    yield from flagged(_ENGINE_RATIO, np.where(fires & (ratio <= RATIO.most), ratio, np.nan))


def peak_pressures(
    gas: GasInChambers,
    events: GasEvents,
    travel: CylinderTravel,
    pressures: GasPressures,
    crank_angle: CrankAngle,
) -> PeakPressures:
    """Peaks of pressure and of its rise, whatever the grid; docs/theory/gas, eq. (14.24)."""
    firing, _opposite = gas.dead_centres(travel)

    def shown(after: Array) -> Array:
        return crank_angle.counted((firing + after)[..., np.newaxis], gas.cycle)[..., 0]

    curves = np.stack([pressures.gas_pressure, pressures.gas_pressure_slope])
    crest, rise = _largest(gas, events, firing, crank_angle, curves)
    return PeakPressures(
        peak_pressure=Extreme(shown(crest.angle), crest.value),
        peak_pressure_after=crest.angle,
        steepest_pressure_rise=Extreme(shown(rise.angle), rise.value),
        unlikely=tuple(flagged(_PEAK_PRESSURE, np.where(pressures.indicated_work > 0, crest.value, np.nan))),
    )


def _largest(
    gas: GasInChambers, events: GasEvents, firing: Array, crank_angle: CrankAngle, curves: Array
) -> Iterator[Extreme]:
    """Largest pressure and steepest rise in chambers, of which the curves are given, shape (design, chamber).

    At an angle after the dead centre at firing.
    """
    places = gas.distinct
    n_rows, zero = len(gas.firing) * len(places), crank_angle.zero

    def own(which: NDArray[np.intp], shown: Array) -> Array:
        """They in the distinct chambers at their own angles, shape (p, k)."""
        curve, row = np.divmod(which, n_rows)
        asked, slot = in_windows(row, shown, n_rows)
        phi = asked.reshape(len(gas.firing), len(places), -1) + zero
        found = gas.at_own(phi, places, lambda angle: gas.pressure_and_slope(angle, gas.volume(angle)))
        return found.reshape(len(curves), *asked.shape)[curve, row, slot]

    found = largest_between(own, crank_angle.shown, curves[:, :, places], events.angle[:, places] - zero)
    after = around_zero(found.angle + zero[..., 0] - firing[:, places])
    after = np.where(np.abs(after) <= ANGLE_ROUNDING, 0.0, after)
    design = np.arange(len(gas.firing))[:, np.newaxis]
    return (
        Extreme(*(part[design, gas.among_distinct] for part in one)) for one in zip(after, found.value, strict=True)
    )
