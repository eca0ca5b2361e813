"""Evenness: the work that a machine's torque stores within a cycle, and the speed over a cycle that comes of it."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.catalogue import quantity
from cranktrain.checks import Check
from cranktrain.language import N_, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.speed import Speed, SteadySpeed
from cranktrain.motion import Array
from cranktrain.numerics import Extreme, spectral_derivative
from cranktrain.numerics.harmonics import TURN
from cranktrain.numerics.periodic import PeriodicCurve, combined, fourier_integral, plus
from cranktrain.questions.evenness.applied_torque import AppliedTorque
from cranktrain.questions.evenness.excess_work import ExcessWork, excess_against, excess_of
from cranktrain.questions.evenness.load_curve import LoadTorque
from cranktrain.questions.evenness.mean_speed import has_mean, quadratic_coefficient
from cranktrain.questions.evenness.spec import GivenFlywheel, ShaftLoad
from cranktrain.questions.evenness.speed_law import (
    TorqueLaw,
    given_torque,
    motor,
    quadratic_load,
    speed_under_law,
    together,
)
from cranktrain.questions.evenness.speed_over_cycle import SpeedOverCycle, chosen_speed, steady_speed
from cranktrain.questions.forces.loaded import MechanismTorques
from cranktrain.questions.torque.sources import TorqueSources
from cranktrain.record import record
from cranktrain.wording import Names, number

_CURVE = ("crank_angle",)
_THEORY = "docs/theory/evenness"
_MOTION_LIMIT = 0.1
"""Of the equation of motion, for each radian of the grid's step: torques with jumps leave a tenth of that."""
_UNLIKELY = 0.5
"""Coefficient of fluctuation from which a flywheel is doubted."""
_LAST_ORDERS = 0.1
"""Share of the upper half of a grid's orders in a torque that the grid shows."""
_ROUNDING = 1e-9
"""Of the energy of all that turns; work of less within a cycle is rounding, or as good as none."""


@record
class FlywheelMoment:
    """GD² of the moving parts."""

    flywheel_moment: Array = quantity(
        "GD²", "kg*m^2", _CURVE, N_("Flywheel moment of all moving parts, four times their reduced inertia"), _THEORY
    )


def flywheel_moment(torques: MechanismTorques) -> FlywheelMoment:
    """GD² = 4 J."""
    return FlywheelMoment(4 * torques.reduced_inertia)


@record
class ShaftWork:
    """Work of the torque without inertia, less that of a load that is given as a curve.

    Attributes
    ----------
    excess : ExcessWork
        Its curve from the first point of the grid. [rad, J]
    inertia : PeriodicCurve
        J of the moving parts. [kg·m²]
    """

    excess: ExcessWork
    inertia: PeriodicCurve
    excess_work: Array = quantity(
        "A", "J", _CURVE, N_("Work of that torque, less that of a given load curve, less its mean"), _THEORY
    )
    largest_excess_work: Array = quantity(
        "ΔA", "J", (), N_("Largest excess work: from the least to the most that is stored within a cycle"), _THEORY
    )

    def answer(self, _names: Names, design: int) -> str:
        """Say the largest excess work."""
        return _("Largest excess work {work} within a cycle.").format(
            work=number(float(self.largest_excess_work[design]), "J")
        )


def shaft_work(
    applied: AppliedTorque,
    sources: TorqueSources,
    given: LoadTorque | None,
    torques: MechanismTorques,
    crank_angle: CrankAngle,
) -> ShaftWork:
    """Work of what drives the shaft less what the load curve takes, over the cycle.

    Notes
    -----
    At the grid's points it is by quadrature between events.
    docs/theory/evenness, eqs. (17.2) and (17.17).
    """
    work = sources.applied_work(crank_angle.shown, crank_angle.cycle)
    mean = np.sum(sources.mean(crank_angle.cycle), axis=-1)
    slope = applied.applied_torque - mean[..., np.newaxis]
    excess = excess_of(applied.by.work(work, slope, crank_angle.cycle), mean)
    if given is not None:
        excess = excess_against(excess, given.work, given.load_factor, given.mean)
    return ShaftWork(
        excess=excess,
        inertia=applied.by.curve(torques.reduced_inertia, crank_angle.cycle),
        excess_work=excess.work.samples,
        largest_excess_work=excess.difference,
    )


@record
class RunningSpeed:
    """Speed of the shaft over the cycle, with the flywheel that there is; load says against what, as answers begin."""

    load: str
    crank_speed: Array = quantity("ω", "rad/s", _CURVE, N_("Speed of the crank over the cycle"), _THEORY)
    crank_acceleration: Array = quantity("ε", "rad/s^2", _CURVE, N_("Angular acceleration of the crank"), _THEORY)
    coefficient_of_fluctuation: Array = quantity(
        "δ", "1", (), N_("Coefficient of fluctuation: largest less smallest speed over the mean"), _THEORY
    )
    mean_speed_over_time: Array = quantity(
        "ω_t", "rad/s", (), N_("Mean speed over time, as a counter of revolutions shows it"), _THEORY
    )
    mean_speed_over_angle: Array = quantity("ω_φ", "rad/s", (), N_("Mean speed over the crank angle"), _THEORY)
    mean_speed_of_extremes: Array = quantity(
        "ω_a", "rad/s", (), N_("Half the sum of largest and smallest speed"), _THEORY
    )
    largest_crank_speed: Array = quantity("ω_M", "rad/s", (), N_("Largest speed of the crank"), _THEORY)
    largest_crank_speed_at: Array = quantity("φ(ω_M)", "deg", (), N_("Crank angle of the largest speed"), _THEORY)
    smallest_crank_speed: Array = quantity("ω_m", "rad/s", (), N_("Smallest speed of the crank"), _THEORY)
    smallest_crank_speed_at: Array = quantity("φ(ω_m)", "deg", (), N_("Crank angle of the smallest speed"), _THEORY)
    checks: tuple[Check, ...] = ()
    flags: tuple[str, ...] = ()

    def answer(self, _names: Names, design: int) -> str:
        """Say the speed's bounds, its coefficient of fluctuation and its means."""
        if np.isnan(self.coefficient_of_fluctuation[design]):
            return ""
        return _(
            "{load} the shaft runs at {least} to {most}, coefficient of fluctuation {delta};"
            " mean {time} over time, {middle} of the extremes."
        ).format(
            load=self.load,
            least=_speed(self.smallest_crank_speed[design]),
            most=_speed(self.largest_crank_speed[design]),
            delta=f"{float(self.coefficient_of_fluctuation[design]):.4g}",
            time=_speed(self.mean_speed_over_time[design]),
            middle=_speed(self.mean_speed_of_extremes[design]),
        )


def running_speed(
    load: ShaftLoad,
    flywheel: GivenFlywheel,
    applied: AppliedTorque,
    given: LoadTorque | None,
    work: ShaftWork,
    torques: MechanismTorques,
    speed: Speed,
    crank_angle: CrankAngle,
) -> RunningSpeed:
    """Speed over the cycle under the load, or of the motor, that the file gives.

    Notes
    -----
    docs/theory/evenness, eqs. (17.4), (17.5) and (17.11).
    """
    inertia = plus(work.inertia, flywheel.inertia)
    found = _found(load, applied, work, inertia, speed.value[:, 0, 0])
    slope = torques.reduced_inertia_slope
    taken = 0.0 if given is None else given.load_torque
    torque = applied.applied_torque - taken + found.balancing
    running = found.speed
    return RunningSpeed(
        load=_load_words(load, has_curve=given is not None, is_free=bool(np.all(found.is_free))),
        crank_speed=running.speed,
        crank_acceleration=(torque - slope * running.speed**2 / 2) / inertia.samples,
        coefficient_of_fluctuation=running.fluctuation(load.mean),
        mean_speed_over_time=running.means.time,
        mean_speed_over_angle=running.means.angle,
        mean_speed_of_extremes=running.means.extremes,
        largest_crank_speed=running.largest.value[:, 0],
        largest_crank_speed_at=_shown(running.largest, crank_angle),
        smallest_crank_speed=running.smallest.value[:, 0],
        smallest_crank_speed_at=_shown(running.smallest, crank_angle),
        checks=(_motion_check(running.speed, inertia.samples, slope, found.work),),
        flags=tuple(_flags(load, work, found)),
    )


class _Found(NamedTuple):
    """Speed; the torque that balances the machine, and the work of all torques [N·m, J]; what is left of a departure.

    A load that does not depend on the speed lets a small departure stay after a cycle: 1. is_free: whether a load was
    to fix the speed and does not, shape (design,).
    """

    speed: SpeedOverCycle
    balancing: Array
    work: PeriodicCurve
    multiplier: Array
    is_free: NDArray[np.bool_]


def _found(load: ShaftLoad, applied: AppliedTorque, work: ShaftWork, inertia: PeriodicCurve, wanted: Array) -> _Found:
    """Steady running, by the energy alone or under a law."""
    left = work.excess.mean_excess[:, np.newaxis]
    cycle = inertia.cycle
    # The slope of the work's series: what it gives back when it is integrated by orders is the work itself.
    torque = left + spectral_derivative(work.excess.work.samples) * (TURN / cycle)
    has_load = has_mean(torque, inertia.samples, wanted)
    torque = torque - np.where(has_load[:, np.newaxis], 0.0, left)
    is_free = load.is_quadratic & ~has_load
    if load.motor is None and (not load.is_quadratic or np.all(is_free)):
        steady = steady_speed(work.excess, inertia, wanted, load.mean).speed
        return _Found(steady, -left, work.excess.work, np.ones(1), is_free)
    law = _law(load, torque, inertia, wanted)
    under = speed_under_law(together(given_torque(torque), law), inertia.samples, cycle, applied.by.curve)
    speed, multiplier = under.speed, under.multiplier
    balancing = under.torque - torque
    if np.any(is_free):
        # Of several designs some may have no mean: their energy is free, as under a constant load.
        speed = chosen_speed(is_free, steady_speed(work.excess, inertia, wanted, load.mean).speed, speed)
        balancing, multiplier = np.where(is_free[:, np.newaxis], -left, balancing), np.where(is_free, 1.0, multiplier)
    whole = combined(work.excess.work, np.ones(1), applied.by.integral(balancing, cycle))
    return _Found(speed, balancing, whole, multiplier, is_free)


def _law(load: ShaftLoad, torque: Array, inertia: PeriodicCurve, wanted: Array) -> TorqueLaw:
    """What balances the machine's own torque, as it depends on the speed."""
    if load.motor is not None:
        return motor(load.motor.no_load_speed[:, np.newaxis], load.motor.stiffness[:, np.newaxis])
    found = quadratic_coefficient(torque, inertia.samples, wanted, inertia.cycle, load.mean)
    return quadratic_load(found[:, np.newaxis])


def _shown(extreme: Extreme, crank_angle: CrankAngle) -> Array:
    """Where an extreme is, counted as the grid counts, shape (design,). [rad]"""
    return crank_angle.counted(extreme.angle[..., np.newaxis] + crank_angle.zero, crank_angle.cycle)[:, 0, 0]


def _motion_check(speed: Array, inertia: Array, slope: Array, work: PeriodicCurve) -> Check:
    """Compare the work of the torques with that of the inertia, whose ε is of the series of ω², and with J′."""
    cycle = work.cycle
    acceleration = spectral_derivative(speed**2) * (np.pi / cycle)
    of_inertia = slope * speed**2 / 2
    left = fourier_integral(inertia * acceleration + of_inertia, cycle).samples
    energy = inertia * speed**2 / 2
    # Torques that do no work within the cycle leave the energy that moving parts hand over at a constant speed.
    spread, handed_over = _range(work.samples), _range(inertia) * np.mean(speed**2, axis=-1) / 2
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
    reasons = np.where(says_something, grid, nothing)
    return Check(
        "motion",
        _("Work of Jε + ½J′ω², with the speed that was found, against that of all torques, relative to its range"),
        np.where(closes, np.where(runs & is_shown & says_something, residual, np.inf), np.nan),
        limit,
        tuple(np.where(runs, reasons, _("needs steady running")).tolist()),
    )


def _range(curve: Array) -> Array:
    return np.max(curve, axis=-1) - np.min(curve, axis=-1)


def _is_shown(torque: Array) -> NDArray[np.bool_]:
    """Whether a grid shows the orders of a torque: one that shows the last ones only says nothing of the others."""
    orders = np.abs(np.fft.rfft(torque, axis=-1))[..., 1:]
    return np.sum(orders[..., orders.shape[-1] // 2 :], axis=-1) <= _LAST_ORDERS * np.sum(orders, axis=-1)


def _load_words(load: ShaftLoad, *, has_curve: bool, is_free: bool) -> str:
    """Say what balances the machine, as a sentence begins."""
    if load.motor is not None:
        return _("Driven by its motor")
    if load.is_quadratic and not is_free:
        return (
            _("Against the load curve and a load that rises with the speed squared")
            if has_curve
            else _("Against a load that rises with the speed squared")
        )
    if has_curve:
        return _("Against the load curve")
    return _("Without a load") if is_free else _("Against a constant torque")


def _flags(load: ShaftLoad, work: ShaftWork, found: _Found) -> Iterator[str]:
    """Mind a load that fixes no speed, a shaft that would stop, a load that nothing drives, and unstable running."""
    speed = found.speed
    is_known = np.isfinite(work.largest_excess_work)
    if np.any(is_known & found.is_free):
        yield _(
            "There is no mean torque for a load that rises with the speed to take: nothing fixes the mean speed,"
            " and the declared one is kept."
        )
    if np.any(is_known & ~np.isfinite(speed.means.time)):
        if load.motor is not None:
            yield _(
                "No steady running: the motor cannot carry the shaft through the cycle; a flywheel or a motor more."
            )
        elif load.is_quadratic and np.any(~found.is_free & (work.excess.mean_excess <= 0)):
            yield _("No steady running: a load that rises with the speed is for a machine that gives work.")
        else:
            yield _("No steady running at this speed: flywheel and moving parts are too light to carry the shaft.")
    if np.any(speed.fluctuation(load.mean) > _UNLIKELY):
        yield _("Within a cycle the speed changes by more than half of its mean: is the flywheel right?")
    if np.any(found.multiplier > 1):
        yield _("The running is not stable: a small departure from it grows.")


def _speed(value: float) -> str:
    """Write a speed."""
    return number(float(value), "rpm")


def steady_speed(running: RunningSpeed) -> SteadySpeed:
    """Give the speed that is found for a second run."""
    return SteadySpeed(
        running.crank_speed, running.crank_acceleration, running.mean_speed_over_time, reasons=running.flags
    )
