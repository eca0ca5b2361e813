"""What motors can do for a moment and at standstill, by their curves: laws say which of these is theirs."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import _
from cranktrain.motion import Array
from cranktrain.motors.declared import LONG_SINCE, DeclaredMotor
from cranktrain.motors.law import BriefLimits
from cranktrain.numerics.ties import first_largest
from cranktrain.wording import number

_N_SPEEDS = 20_001
_ROUNDING = 1e-9


def curve_limits(motor: DeclaredMotor, design: int) -> BriefLimits:
    """The largest torque of its curve, and the least before that."""
    running = _running(motor, design)
    return BriefLimits(float(np.max(running)), _least_before_largest(running))


def peak_limits(motor: DeclaredMotor, design: int, peak: float, time: float = LONG_SINCE) -> BriefLimits:
    """The same of a motor whose largest torque is one of its numbers; its start at a time since it was switched on."""
    starting = curve(motor, design, _speeds_up(motor, design), time)
    return BriefLimits(peak, _least_before_largest(starting))


def star_limits(motor: DeclaredMotor, design: int) -> BriefLimits:
    """Of a motor that starts otherwise than it runs: the start as it is switched on."""
    return peak_limits(motor, design, float(np.max(_running(motor, design))), 0.0)


def ramped_limits(motor: DeclaredMotor, design: int) -> BriefLimits:
    """Of a motor that starts with its largest torque, as its field begins slowly."""
    largest = float(np.max(_running(motor, design)))
    return BriefLimits(largest, largest)


def start_limits(motor: DeclaredMotor, design: int, unknown: str) -> BriefLimits:
    """Of a motor whose start alone is known: why its largest torque is not."""
    return BriefLimits(start=_least_before_largest(_running(motor, design)), unknown=unknown)


def beyond_measured(motor: DeclaredMotor, design: int, speed: Array) -> Iterator[str]:
    """Say that a motor by points runs at speeds beyond them; nothing of a motor by a formula. [rad/s]"""
    measured = motor.measured_speeds(design)
    if measured is None:
        return
    least, most = measured
    if np.max(speed) > most * (1 + _ROUNDING) or np.min(speed) < least - _ROUNDING * most:
        said = _("The motor runs beyond its table, {least} to {most}: there it has the torque of the last point.")
        yield said.format(least=number(least, "rpm"), most=number(most, "rpm"))


def curve(motor: DeclaredMotor, design: int, speeds: Array, time: float = LONG_SINCE) -> Array:
    """Torque of one design at speeds, shape (n,). [N·m]"""
    return motor.torque(np.broadcast_to(speeds, (motor.n_designs, speeds.size)), time)[design]


def _running(motor: DeclaredMotor, design: int) -> Array:
    return curve(motor, design, _speeds_up(motor, design))


def _speeds_up(motor: DeclaredMotor, design: int) -> Array:
    """Speeds from standstill up to the highest one that matters. [rad/s]"""
    top, measured = float(motor.top_speed[design]), motor.measured_speeds(design)
    if not np.isfinite(top):
        top = float(motor.rating.speed[design]) if measured is None else measured[1]
    return np.linspace(0.0, top, _N_SPEEDS)


def _least_before_largest(torque: Array) -> float:
    return float(np.min(torque[: first_largest(torque) + 1]))
