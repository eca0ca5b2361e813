"""The equation of motion in time, with the account of its energy."""

from collections.abc import Callable
from functools import cache
from types import FunctionType
from typing import Any, NamedTuple, TypeAlias

from cranktrain.linkage import compiled
from cranktrain.motion import Array
from cranktrain.questions.drive.running.compiling import quick
from cranktrain.questions.drive.running.gearing import Gearing, acceleration, overall_ratio
from cranktrain.questions.drive.running.step import Derive

Machine: TypeAlias = Callable[[float, float, float, Any], tuple[float, float, float, float]]
"""(crank angle, speed, sense, numbers) → J, J′, torque that the load takes at the crank, x′ of what is driven.

The sense is that of a motion which may be about to begin: dry friction takes its sign from it, not from the speed.
"""
Motor: TypeAlias = Callable[[float, float, Any], float]
"""(speed at its own shaft, time, numbers) → torque. [N·m]"""

ANGLE, SPEED, MOTOR_WORK, LOAD_WORK, LOST_WORK, HEAT = range(6)
"""Components of the state."""
N_STATE = 6
OPEN, JAMMED = 1, 2
"""Why there is no acceleration: links do not close; none or several satisfy the law of the gearing."""


class DriveTrain(NamedTuple):
    """What the equation is made of: numbers of machine, motor and brake for their kernels; and the gearing."""

    machine: Any
    motor: Any
    brake: Any
    gearing: Gearing


class Kernels(NamedTuple):
    """Kernels that a transient is made of.

    Attributes
    ----------
    machine : Machine
    motor : Motor
    heat : Motor
        Power that heats the motor. [W]
    brake : callable
        (time, numbers) → torque against the motion at the motor's shaft, up to which it holds at rest too. [N·m]
    """

    machine: Machine
    motor: Motor
    heat: Motor
    brake: Callable[[float, Any], float]


def no_heat(_speed: float, _time: float, _numbers: Any) -> float:
    """Power that heats a motor of which nothing is known. [W]"""
    return 0.0


def no_motor(_speed: float, _time: float, _numbers: Any) -> float:
    """Torque of a motor that is switched off. [N·m]"""
    return 0.0


def no_brake(_time: float, _numbers: Any) -> float:
    """Torque of a brake that is not there. [N·m]"""
    return 0.0


@cache
def untimed(kernel: Callable[[float, Any], float]) -> Motor:
    """Motor of a kernel of speed and numbers alone; the same one for the same kernel."""

    def torque(speed: float, _time: float, numbers: Any) -> float:
        return own(speed, numbers)

    own = kernel
    return torque


def time_form(kernels: Kernels, law: Any, ratio_of: Any) -> Derive:
    """Join the kernels to the slopes of the state by time. docs/theory/transient, eqs. (26.8) and (26.9)."""
    machine, motor, heat, brake = kernels

    def derive(time: float, state: Array, slopes: Array, sense: float, drive: DriveTrain) -> int:
        angle, speed = state[0], state[1]
        inertia, first, load, _ = machine(angle, speed, sense, drive.machine)
        at_motor = speed * ratio_of(drive.gearing)
        torque = motor(at_motor, time, drive.motor)
        drag = brake(time, drive.brake) * sense
        grown, taken, count = law(torque - drag, sense, inertia, load + 0.5 * first * speed * speed, drive.gearing)
        slopes[0] = speed
        slopes[1] = grown
        slopes[2] = torque * at_motor
        slopes[3] = load * speed
        slopes[4] = taken * speed + drag * at_motor
        slopes[5] = heat(at_motor, time, drive.motor)
        if count != 0:
            return 1 if inertia * load != inertia * load else 2
        return 0

    return derive


class Joined(NamedTuple):
    """Slopes by time, and the kernels, plain or compiled."""

    derive: Derive
    kernels: Kernels


@cache
def joined(kernels: Kernels, is_compiled: bool) -> Joined:
    """Join kernels once: compiled with Numba, or as they are. One made elsewhere by Numba is taken as it is."""
    if not is_compiled:
        return Joined(time_form(kernels, acceleration, overall_ratio), kernels)
    own = Kernels(*(_as_kernel(each) for each in kernels))
    return Joined(quick(time_form(own, compiled(acceleration), compiled(overall_ratio))), own)


def _as_kernel(kernel: Any) -> Any:
    """Compile a kernel; of an untimed motor the kernel within, as all kernels of the package are."""
    return compiled(kernel) if isinstance(kernel, FunctionType) and kernel.__closure__ is None else quick(kernel)
