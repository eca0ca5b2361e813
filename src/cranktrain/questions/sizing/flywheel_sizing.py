"""A flywheel on a shaft of the drive with which the motor gives no more than is wanted, or the crank runs as evenly."""

from collections.abc import Callable
from functools import cache
from typing import NamedTuple

import numpy as np

from cranktrain.language import N_, Words, _
from cranktrain.layout.drive.declared import DeclaredDrive
from cranktrain.motion import Array
from cranktrain.motors import DeclaredMotor
from cranktrain.numerics.roots import bracketed_roots
from cranktrain.questions.drive.settling import settled
from cranktrain.questions.drive.steady_cycle import speed_range
from cranktrain.questions.drive.steady_drive import SteadyDrive
from cranktrain.questions.drive.steady_turn import DriveInTurn
from cranktrain.questions.reduction.machines import ReducedMachines
from cranktrain.questions.reduction.static_torques import StaticTorques
from cranktrain.questions.sizing.motor_checks import mean_inertia
from cranktrain.questions.sizing.parts import WantedFlywheel
from cranktrain.questions.sizing.peaky_load import PeakyLoad, SlipLine, recovered_inertia
from cranktrain.record import record
from cranktrain.references import THEORY_OF_DRIVES as _THEORY
from cranktrain.references import THEORY_OF_TRANSIENTS as _TRANSIENTS
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import Flagged, flags_of_designs
from cranktrain.transient.gearing import (
    Gearing,
    overall_ratio,
    turning_inertia,
    with_inertia,
)

_MOST = 1e7
"""In parts of the inertia that is there: above it no flywheel is looked for."""
_CLOSE = 1e-11
"""In parts of the flywheel: how near it is found."""


@record
class DriveFlywheel(Flagged):
    """Flywheel for a wanted largest torque of the motor, or a wanted evenness; infinite where none is large enough."""

    needed_inertia: Array = quantity(
        "J_F", "kg*m^2", (), N_("Moment of inertia of the flywheel that is to be added on its shaft"), _THEORY, "25.39"
    )
    formula_inertia: Array = quantity(
        "J_F,rec",
        "kg*m^2",
        (),
        N_("The same by the formula for one peak after a full recovery"),
        _THEORY,
        "25.35, 25.36",
    )
    formula_error: Array = quantity(
        "Δ_F",
        "1",
        (),
        N_("Error of that formula, relative"),
        _THEORY,
        "25.35, 25.36, 25.39",
    )
    peak_with_flywheel: Array = quantity(
        "M_F,max", "N*m", (), N_("Largest torque of the motor with it"), _THEORY, "25.39"
    )
    rms_with_flywheel: Array = quantity(
        "M_F,rms", "N*m", (), N_("Root mean square of the motor's torque over time with it"), _THEORY, "25.39"
    )
    rms_without_flywheel: Array = quantity("M_0,rms", "N*m", (), N_("The same without it"), _TRANSIENTS, "26.5")
    fluctuation_with_flywheel: Array = quantity(
        "δ_F", "1", (), N_("Coefficient of fluctuation of the crank's speed with it"), _THEORY, "25.39"
    )


_N_FACTS = 7


class _Running(NamedTuple):
    """Largest and rms torque of the motor, and fluctuation."""

    peak: float
    rms: float
    fluctuation: float


def drive_flywheel(
    drive: DeclaredDrive,
    motor: DeclaredMotor,
    machines: ReducedMachines,
    static: StaticTorques,
    steady: SteadyDrive,
    wanted: WantedFlywheel,
) -> DriveFlywheel:
    """Find the flywheel over steady cycles, with the machine's inertia over the turn and the motor's own curve.

    Notes
    -----
    docs/theory/drive, eqs. (25.36) and (25.39).
    """
    rows: list[tuple[float, ...]] = []
    flags: list[list[Words]] = []
    for design, gearing in enumerate(drive.gearings):
        flags.append([])
        turning = DriveInTurn(machines.each[design], motor.of_design(design), design, gearing)
        torque, evenness = float(wanted.largest_torque[design]), float(wanted.fluctuation[design])

        def excess(
            inertia: float, turning: DriveInTurn = turning, limits: tuple[float, float] = (torque, evenness)
        ) -> float:
            found = _running(turning, machines, wanted.shaft, inertia)
            return found.peak / limits[0] - 1 if np.isfinite(limits[0]) else found.fluctuation / limits[1] - 1

        there = _at_shaft(
            turning_inertia(gearing) + mean_inertia(machines.each[design], machines.cycle), gearing, wanted
        )
        if there <= 0:
            flags[-1].append(_("No flywheel is sought: nothing of the machine or its drive has inertia yet."))
            rows.append((np.nan,) * _N_FACTS)
            continue
        needed = least_inertia(excess, there)
        if not np.isfinite(needed):
            flags[-1].append(
                _("No flywheel is large enough: the load's mean asks for more, or the motor does not carry it.")
            )
        own = _running(turning, machines, wanted.shaft, needed if np.isfinite(needed) else 0.0)
        formula = formula_inertia(
            static, float(steady.cycle_time[design]), motor, design=design, allowed=torque
        ) - _at_motor(there, gearing, wanted)
        formula = max(formula, 0.0) * _turned(gearing, wanted.shaft) ** 2 if not np.isnan(formula) else np.nan
        error = formula / needed - 1 if needed > 0 else np.nan
        rows.append(
            (needed, formula, error, own.peak, own.rms, float(steady.rms_motor_torque[design]), own.fluctuation)
        )
    return DriveFlywheel(*np.array(rows).T, flags=flags_of_designs(flags))


def _turned(gearing: Gearing, shaft: int) -> float:
    """Turns of the motor for one of a shaft."""
    return float(np.prod(gearing.ratio[:shaft]))


def _at_shaft(at_crank: float, gearing: Gearing, wanted: WantedFlywheel) -> float:
    """Inertia at the crank, reduced to the flywheel's shaft. [kg·m²]"""
    return at_crank * (_turned(gearing, wanted.shaft) / overall_ratio(gearing)) ** 2


def _at_motor(at_shaft: float, gearing: Gearing, wanted: WantedFlywheel) -> float:
    """Inertia at the flywheel's shaft, reduced to the motor's. [kg·m²]"""
    return at_shaft / _turned(gearing, wanted.shaft) ** 2


def _running(turning: DriveInTurn, machines: ReducedMachines, shaft: int, inertia: float) -> _Running:
    """Steady running with a flywheel; infinite where there is none."""
    gearing = with_inertia(turning.gearing, shaft, inertia)
    at, found = settled(turning._replace(gearing=gearing), machines)
    if found is None:
        return _Running(np.inf, np.nan, np.inf)
    peak = at.largest_torque(found)
    if np.isnan(peak):  # so near to a stall that it stands still between two points
        return _Running(np.inf, np.nan, np.inf)
    mean = machines.cycle / found.period
    rms = float(np.sqrt(found.over_time(at.motor_torque(found.speed) ** 2)))
    return _Running(peak, rms, speed_range(found) / mean)


def least_inertia(excess: Callable[[float], float], there: float) -> float:
    """Least inertia with which nothing is in excess: 0 where none is needed, infinite where none is enough. [kg·m²]"""
    over = cache(excess)  # each value takes a steady cycle
    if over(0.0) <= 0:
        return 0.0
    low, high = 0.0, 0.25 * there
    while over(high) > 0:
        low, high = high, 4 * high
        if high > _MOST * there:
            return np.inf
    stalls = np.isinf(over(low))  # no chord leads from there
    while stalls and high - low > _CLOSE * high:
        middle = 0.5 * (low + high)
        if over(middle) > 0:
            low, stalls = middle, np.isinf(over(middle))
        else:
            high = middle
    if stalls:
        return high
    return float(bracketed_roots(np.vectorize(over, otypes=[float]), np.array([low]), np.array([high]))[0])


def formula_inertia(
    static: StaticTorques, period: float, motor: DeclaredMotor, *, design: int, allowed: float
) -> float:
    """Inertia of all at the motor by the formula, for two levels with the extremes and the mean of the static torque.

    Parameters
    ----------
    static : StaticTorques
    period : float
        Of the steady cycle. [s]
    motor : DeclaredMotor
    design : int
        Of the static torques, and of the motor.
    allowed : float
        Largest torque of the motor. [N·m]

    Returns
    -------
    float
        NaN where the motor has no rated slip. [kg·m²]

    Notes
    -----
    docs/theory/drive, eq. (25.36).
    """
    most, least, mean = (
        float(one[design, 0])
        for one in (static.largest_static_torque.value, static.smallest_static_torque.value, static.mean_static_torque)
    )
    top, rating = float(motor.top_speed[design]), motor.rating
    if np.isnan(rating.torque[design]) or not np.isfinite(top) or most <= least or np.isnan(allowed):
        return np.nan
    share = (mean - least) / (most - least)
    load = PeakyLoad(*(np.asarray(one) for one in (most, share * period, least, (1 - share) * period)))
    line = SlipLine(rating.torque[design], np.asarray(motor.rated_slip(design)), np.asarray(top))
    return float(recovered_inertia(load, line, np.asarray(allowed)))
