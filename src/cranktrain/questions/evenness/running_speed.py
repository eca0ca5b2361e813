"""Speed of the shaft over the cycle, with the flywheel that there is, under its load or with its motor."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_, Words, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.question import Applies
from cranktrain.layout.speed import DrivenSpeed, Speed, SteadySpeed
from cranktrain.motion import Array
from cranktrain.numerics import Extreme, spectral_derivative
from cranktrain.numerics.periodic import PeriodicCurve, fourier_integral, plus
from cranktrain.questions.evenness.shaft_torque import AppliedTorque, LoadTorque, of_steady_running
from cranktrain.questions.evenness.shaft_work import ShaftWork
from cranktrain.questions.evenness.spec import Balancing, DrivenByMotor, GivenFlywheel
from cranktrain.questions.evenness.speed_over_cycle import Mean
from cranktrain.questions.evenness.steady_running import SteadyRunning, steady_running
from cranktrain.questions.forces.mechanism_torques import MechanismTorques
from cranktrain.record import record
from cranktrain.references import THEORY_OF_EVENNESS as _THEORY
from cranktrain.saying.catalogue import extreme, quantity
from cranktrain.saying.checks import Check, Checked, Flagged

_CURVE = ("crank_angle",)
_UNLIKELY = 0.5
"""Coefficient of fluctuation from which a flywheel is flagged."""

_MOTION_LIMIT = 0.1
"""Of the equation of motion, for each radian of the grid's step: torques with jumps leave a tenth of that."""
_LAST_ORDERS = 0.1
"""Share of the upper half of a grid's orders in a torque that the grid shows."""
_ROUNDING = 1e-9
"""Of the energy of all that turns; work of less within a cycle is rounding, or as good as none."""


@record
class RunningSpeed(Checked, Flagged):
    """Speed of the shaft over the cycle, with the flywheel that there is."""

    crank_speed: Array = quantity(
        "ω", "rad/s", _CURVE, N_("Speed of the crank over the cycle"), _THEORY, "17.4, 17.11", shown="rpm"
    )
    crank_acceleration: Array = quantity(
        "ε", "rad/s^2", _CURVE, N_("Angular acceleration of the crank"), _THEORY, "17.1"
    )
    coefficient_of_fluctuation: Array = quantity(
        "δ", "1", (), N_("Coefficient of fluctuation: largest less smallest speed over the mean"), _THEORY, "17.5"
    )
    mean_speed_over_time: Array = quantity(
        "ω_t",
        "rad/s",
        (),
        N_("Mean speed over time, as a counter of revolutions shows it"),
        _THEORY,
        "17.5",
        shown="rpm",
    )
    mean_speed_over_angle: Array = quantity(
        "ω_φ", "rad/s", (), N_("Mean speed over the crank angle"), _THEORY, "17.5", shown="rpm"
    )
    mean_speed_of_extremes: Array = quantity(
        "ω_a",
        "rad/s",
        (),
        N_("Half the sum of largest and smallest speed"),
        _THEORY,
        "17.5",
        shown="rpm",
        line="({largest_crank_speed} + {smallest_crank_speed}) / 2",
    )
    largest_crank_speed: Extreme = extreme(
        "ω_M",
        "rad/s",
        (),
        N_("Largest speed of the crank"),
        N_("Crank angle of the largest speed"),
        _THEORY,
        "17.4, 17.11",
        shown="rpm",
        of="crank_speed",
    )
    smallest_crank_speed: Extreme = extreme(
        "ω_m",
        "rad/s",
        (),
        N_("Smallest speed of the crank"),
        N_("Crank angle of the smallest speed"),
        _THEORY,
        "17.4, 17.11",
        shown="rpm",
        of="crank_speed",
    )


def runs_steadily(
    balancing: Balancing | None, flywheel: GivenFlywheel | None, driven: DrivenByMotor | None, speed: Speed | None
) -> Applies:
    """Whether there is a motor that gives the machine its speed, or a flywheel and what balances it."""
    steadily = of_steady_running(balancing, speed)
    if driven is not None:
        return steadily is True or balancing is None or steadily
    if steadily is not True and balancing is not None:
        return steadily
    needs = [part.needs for part, given in ((Balancing, balancing), (GivenFlywheel, flywheel)) if given is None]
    return tuple(needs) or True


def running_speed(
    balancing: Balancing | None,
    flywheel: GivenFlywheel | None,
    driven: DrivenSpeed | None,
    applied: AppliedTorque | None,
    given: LoadTorque | None,
    work: ShaftWork | None,
    torques: MechanismTorques,
    speed: Speed,
    crank_angle: CrankAngle,
) -> RunningSpeed:
    """Speed over the cycle under the loads, and of the motor, that the file gives.

    Notes
    -----
    docs/theory/evenness, eqs. (17.4), (17.5) and (17.11).
    """
    mean = "time" if balancing is None else balancing.mean
    if driven is not None:
        return _with_motor(driven, mean)
    assert balancing is not None
    assert flywheel is not None
    assert applied is not None
    assert work is not None
    inertia = plus(work.inertia, flywheel.inertia)
    found = steady_running(balancing, given, work, inertia, speed.value[:, 0, 0])
    slope = torques.reduced_inertia_slope
    even = 0.0 if given is None else given.even
    torque = applied.applied_torque - even + found.besides
    running = found.speed
    return RunningSpeed(
        crank_speed=running.speed,
        crank_acceleration=(torque - slope * running.speed**2 / 2) / inertia.samples,
        coefficient_of_fluctuation=running.fluctuation(balancing.mean),
        mean_speed_over_time=running.means.time,
        mean_speed_over_angle=running.means.angle,
        mean_speed_of_extremes=running.means.extremes,
        largest_crank_speed=_shown(running.largest, crank_angle),
        smallest_crank_speed=_shown(running.smallest, crank_angle),
        checks=(_motion_check(running.speed, inertia.samples, slope, found.work),),
        flags=tuple(_flags(balancing.mean, given, work, found)),
    )


def _with_motor(driven: DrivenSpeed, mean: Mean) -> RunningSpeed:
    """Speed that the motor gives the machine; what is to be minded stands with that."""
    of_extremes = (driven.largest.value + driven.smallest.value) / 2
    means = {"time": driven.over_time, "angle": driven.over_angle, "extremes": of_extremes}
    return RunningSpeed(
        crank_speed=driven.speed,
        crank_acceleration=driven.acceleration,
        coefficient_of_fluctuation=(driven.largest.value - driven.smallest.value) / means[mean],
        mean_speed_over_time=driven.over_time,
        mean_speed_over_angle=driven.over_angle,
        mean_speed_of_extremes=of_extremes,
        largest_crank_speed=driven.largest,
        smallest_crank_speed=driven.smallest,
    )


def _shown(found: Extreme, crank_angle: CrankAngle) -> Extreme:
    """Extreme whose angle is counted as the grid counts, shape (design,). [rad]"""
    angle = crank_angle.counted(found.angle[..., np.newaxis] + crank_angle.zero, crank_angle.cycle)
    return Extreme(angle[:, 0, 0], found.value[:, 0])


def _flags(mean: Mean, given: LoadTorque | None, work: ShaftWork, found: SteadyRunning) -> Iterator[Words]:
    """Flag a load that fixes no speed, a shaft that would stop, a load that nothing drives, and unstable running."""
    speed, rises = found.speed, given is not None and given.shape is not None
    is_known = np.isfinite(work.largest_excess_work)
    if np.any(is_known & found.is_free):
        yield _(
            "There is no mean torque for a load that rises with the speed to take: nothing fixes the mean speed,"
            " and the declared one is kept."
        )
    if np.any(is_known & ~np.isfinite(speed.means.time)):
        if rises and np.any(~found.is_free & (work.excess.mean_excess <= 0)):
            yield _("No steady running: a load that rises with the speed is for a machine that gives work.")
        else:
            yield _("No steady running at this speed: flywheel and moving parts are too light to carry the shaft.")
    if np.any(speed.fluctuation(mean) > _UNLIKELY):
        yield _("Within a cycle the speed changes by more than half of its mean: is the flywheel right?")
    if np.any(found.multiplier > 1):
        yield _("The running is not stable: a small departure from it grows.")


def for_second_run(running: RunningSpeed) -> SteadySpeed:
    """Give the speed that is found for a second run."""
    return SteadySpeed(
        running.crank_speed, running.crank_acceleration, running.mean_speed_over_time, reasons=running.flags
    )


def _motion_check(speed: Array, inertia: Array, slope: Array, work: PeriodicCurve) -> Check:
    """Compare the work of the torques with that of the inertia, whose ε is of the series of ω², and with J′."""
    cycle = work.cycle
    acceleration = spectral_derivative(speed**2) * (np.pi / cycle)
    of_inertia = slope * speed**2 / 2
    left = fourier_integral(inertia * acceleration + of_inertia, cycle).samples
    energy = inertia * speed**2 / 2
    # Torques that do no work within the cycle leave the energy that moving parts hand over at a constant speed.
    spread: Array = np.ptp(work.samples, axis=-1)
    handed_over: Array = np.ptp(inertia, axis=-1) * np.mean(speed**2, axis=-1) / 2
    least = _ROUNDING * np.max(energy, axis=-1)
    works = spread > least
    scale = np.where(works, spread, handed_over)
    says_something = ~(scale <= least)
    residual = np.max(np.abs(left - work.samples), axis=-1) / np.where(says_something, scale, 1.0)
    # A shaft that hardly turns where J is least has a sharper speed than its torques.
    by_torque = np.where(works, _is_shown(work.slope(work.angle)), _is_shown(of_inertia))
    limit = _MOTION_LIMIT * float(work.angle[1])
    is_shown = by_torque & ((residual <= limit) | _is_shown(acceleration))
    closes, runs = (np.all(np.isfinite(curve), axis=-1) for curve in (inertia, speed))
    grid, nothing = (
        _("has torques that whole degrees do not show"),
        _("has nothing to compare: the work of a cycle is rounding beside the energy"),
    )
    return Check(
        "motion",
        _("Work of Jε + ½J′ω², with the speed that was found, against that of all torques, relative to its range"),
        np.where(closes, np.where(runs & is_shown & says_something, residual, np.inf), np.nan),
        limit,
        tuple(
            (grid if says else nothing) if is_running else _("needs steady running")
            for is_running, says in zip(runs.tolist(), says_something.tolist(), strict=True)
        ),
    )


def _is_shown(torque: Array) -> NDArray[np.bool_]:
    """Whether a grid shows the orders of a torque: one that shows the last ones only says nothing of the others."""
    orders = np.abs(np.fft.rfft(torque, axis=-1))[..., 1:]
    return np.sum(orders[..., orders.shape[-1] // 2 :], axis=-1) <= _LAST_ORDERS * np.sum(orders, axis=-1)
