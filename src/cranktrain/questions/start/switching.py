"""Kernels of a start that is not compiled: a motor with its switch, a brake that comes on."""

from functools import cache
from typing import Any, NamedTuple

from cranktrain.motors import DeclaredMotor
from cranktrain.transient.equation import Kernels, Motor, no_heat, no_motor, untimed
from cranktrain.transient.floats import in_floats
from cranktrain.transient.reduced import reduced_machine, settle


class Switching(NamedTuple):
    """A motor with its switch: its numbers; when it is switched off and reversed; when the run began. [s]"""

    motor: Any
    off: float
    back: float
    since: float


@cache
def switched(kernel: Motor, is_even: bool) -> Motor:
    """A motor that is switched off or reversed, or what is even in its sense, as its heat."""

    def at(speed: float, time: float, numbers: Switching) -> float:
        now = time + numbers.since
        if now >= numbers.off:
            return 0.0
        if now < numbers.back:
            return own(speed, now, numbers.motor)
        turned = own(-speed, now - numbers.back, numbers.motor)
        return turned if is_even else -turned

    own = kernel
    return at


class Braking(NamedTuple):
    """A brake: its torque while it slips, when that begins, and in which time it rises. [N·m, s]"""

    torque: float
    begins: float
    rise_time: float


def braking(time: float, brake: Braking) -> float:
    """Torque of a brake while it slips, in a line from nothing. docs/theory/drive, eq. (25.23). [N·m]"""
    since = time - brake.begins
    if since < 0:
        return 0.0
    return brake.torque if since >= brake.rise_time else brake.torque * since / brake.rise_time


def start_kernels(motor: DeclaredMotor | None) -> Kernels:
    """Kernels of a run that is not compiled."""
    if motor is None:
        return Kernels(in_floats(reduced_machine), no_motor, no_heat, braking, in_floats(settle))
    torque = in_floats(motor.law.kernel)
    timed = torque if motor.law.is_timed else untimed(torque)
    heat = no_heat if motor.heat is None else in_floats(motor.heat)
    return Kernels(in_floats(reduced_machine), switched(timed, False), switched(heat, True), braking, in_floats(settle))
