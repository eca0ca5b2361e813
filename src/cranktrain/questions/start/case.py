"""One design of a machine with its motor, ready to start; and its kernels where it is not compiled."""

from functools import cache, cached_property
from typing import Any, NamedTuple

import numpy as np

from cranktrain.errors import InputError
from cranktrain.motion import Array
from cranktrain.motors import DeclaredMotor
from cranktrain.questions.start.parts import StartOrders
from cranktrain.record import record
from cranktrain.transient.equation import BrakePlace, Kernels, Motor, no_heat, no_motor, untimed
from cranktrain.transient.floats import in_floats
from cranktrain.transient.gearing import Gearing
from cranktrain.transient.reduced import ReducedMachine, reduced_machine, settle


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


def start_kernels(motor: DeclaredMotor | None, *, is_compiled: bool = False) -> Kernels:
    """Kernels of a run, for plain numbers unless it is one that will be compiled."""
    ready: Any = _as_it_is if is_compiled else in_floats
    machine, carried = ready(reduced_machine), ready(settle)
    if motor is None:
        return Kernels(machine, no_motor, no_heat, braking, carried)
    torque = ready(motor.law.kernel)
    timed = torque if motor.law.is_timed else untimed(torque)
    heat = no_heat if motor.heat is None else ready(motor.heat)
    return Kernels(machine, switched(timed, False), switched(heat, True), braking, carried)


def _as_it_is(kernel: Any) -> Any:
    return kernel


@record
class StartCase:
    """One design, ready to start.

    Attributes
    ----------
    machine : ReducedMachine
    corners : Array
        φ of its loads' corners. [rad]
    rows : Array
        φ of rows of long load curves that are next to no corners. [rad]
    cycle : float
        After which these come again. [rad]
    gearing : Gearing
    motor : DeclaredMotor or None
        Of this design alone.
    start : StartOrders
    interval_text : str
        As the file has it, nothing without one.
    brake : Braking
        From its command on: `begins` is its delay.
    place : BrakePlace
    chambers : tuple of str
        Names of those of a compressor.
    zero : float
        φ where the shown crank angle is 0. [rad]
    steady_speed, cycle_time : float
        Mean speed of the crank in steady running, and the time of a cycle; NaN without it, and where its orders end
        the run otherwise. [rad/s, s]
    """

    machine: ReducedMachine
    corners: Array
    rows: Array
    cycle: float
    gearing: Gearing
    motor: DeclaredMotor | None
    start: StartOrders
    interval_text: str
    brake: Braking
    place: BrakePlace
    chambers: tuple[str, ...]
    zero: float
    steady_speed: float
    cycle_time: float

    @cached_property
    def motor_numbers(self) -> Any:
        """Of the motor, plain, as its kernels take them; nothing without one."""
        return () if self.motor is None else self.motor.row(0)

    @cached_property
    def is_to_settle(self) -> bool:
        """Whether it ends where it runs as it will."""
        return bool(np.isfinite(self.steady_speed))


@record
class StartCases:
    """All designs, each ready to start, or why it is not."""

    each: tuple[StartCase | InputError, ...]
