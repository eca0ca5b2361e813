"""The equation of motion in time, with the account of its energy."""

from collections.abc import Callable
from copy import deepcopy
from functools import cache
from types import FunctionType
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from cranktrain.linkage import compiled
from cranktrain.transient.compiling import quick
from cranktrain.transient.gearing import Gearing
from cranktrain.transient.law import OneStage, accelerated, in_one_stage, lines_of
from cranktrain.transient.step import BESIDE, N_STATE, Derive

Machine: TypeAlias = Callable[[float, float, float, Any], tuple[float, float, float, float]]
"""(crank angle, speed, sense, numbers) → J, J′, torque that the load takes at the crank, x′ of what is driven.

The sense is that of a motion which may be about to begin: dry friction takes its sign from it, not from the speed.
"""
Motor: TypeAlias = Callable[[float, float, Any], float]
"""(speed at its own shaft, time, numbers) → torque. [N·m]"""

ANGLE, SPEED, MOTOR_WORK, LOAD_WORK, LOST_WORK, HEAT = range(N_STATE)
"""Components of the state."""


class BrakePlace(NamedTuple):
    """Where a brake sits: 1 of one on the crank, 0 of one on the motor's shaft; and at rest it holds so much more."""

    on_crank: float = 0.0
    holds: float = 1.0


AT_MOTOR = BrakePlace()


class DriveTrain(NamedTuple):
    """What the equation is made of: numbers of machine, motor and brake for their kernels; the gearing; the brake."""

    machine: Any
    motor: Any
    brake: Any
    gearing: Gearing
    place: BrakePlace = AT_MOTOR


def no_heat(_speed: float, _time: float, _numbers: Any) -> float:
    """Power that heats a motor of which nothing is known. [W]"""
    return 0.0


def no_motor(_speed: float, _time: float, _numbers: Any) -> float:
    """Torque of a motor that is switched off. [N·m]"""
    return 0.0


def no_brake(_time: float, _numbers: Any) -> float:
    """Torque of a brake that is not there. [N·m]"""
    return 0.0


def no_memory(_angle: float, _numbers: Any) -> None:
    """What a machine carries on that remembers nothing."""


class Kernels(NamedTuple):
    """Kernels that a transient is made of.

    Attributes
    ----------
    machine : Machine
    motor : Motor
    heat : Motor
        Power that heats the motor. [W]
    brake : callable
        (time, numbers) → torque against the motion at the shaft on which it sits. [N·m]
    settle : callable, optional
        (crank angle, numbers of the machine) → None: lets a machine that remembers, such as gas in a chamber, carry on
        what it does, in an array (plain: a list) among its numbers. Asked at the start and at the end of every step,
        never within; a run changes a copy of the numbers.
    """

    machine: Machine
    motor: Motor
    heat: Motor
    brake: Callable[[float, Any], float]
    settle: Callable[[float, Any], None] = no_memory


class TrainNumbers(NamedTuple):
    """A `DriveTrain` as the loop takes it: its one stage, or none, as plain numbers; of several the lines of torques.

    Every array costs a call of the loop seven words to pass on.
    """

    machine: Any
    motor: Any
    brake: Any
    place: BrakePlace
    one: OneStage
    rows: Any


def train_of(drive: DriveTrain, kernels: Kernels, is_compiled: bool) -> TrainNumbers:
    """Prepare a drive for a run: with a memory of its own, and without Numba with lists, which are quicker there."""
    machine = drive.machine
    if kernels.settle is not no_memory:
        machine = np.array(machine) if type(machine) is np.ndarray else deepcopy(machine)
    rows = lines_of(drive.gearing)
    return TrainNumbers(
        machine,
        drive.motor,
        drive.brake,
        drive.place,
        in_one_stage(drive.gearing),
        rows if is_compiled else rows.tolist(),
    )


@cache
def untimed(kernel: Callable[[float, Any], float]) -> Motor:
    """Motor of a kernel of speed and numbers alone; the same one for the same kernel."""

    def torque(speed: float, _time: float, numbers: Any) -> float:
        return own(speed, numbers)

    own = kernel
    return torque


def time_form(kernels: Kernels, law: Any) -> Derive:
    """Join the kernels to the slopes of the state by time, x′ beside. docs/theory/transient, eqs. (26.9), (26.10)."""
    machine, motor, heat, brake, _ = kernels

    def derive(
        time: float,
        angle: float,
        speed: float,
        sense: float,
        bound: float,
        slopes: Any,
        place: int,
        train: TrainNumbers,
    ) -> tuple[float, float]:
        seen = bound if sense * (angle - bound) > 0 else angle
        inertia, first, load, output = machine(seen, speed, sense, train.machine)
        ratio = train.one.ratio
        at_motor = speed * ratio
        # float: what NumPy gives to plain Python makes all that follows slow
        inertia, load, torque = float(inertia), float(load), float(motor(at_motor, time, train.motor))
        braked = brake(time, train.brake) * sense
        on_crank = braked * train.place.on_crank
        drag = braked - on_crank
        needed = load + 0.5 * float(first) * speed * speed + on_crank
        grown, taken = law(torque - drag, sense, inertia, needed, train.one, train.rows)
        slopes[place] = speed
        slopes[place + 1] = grown
        slopes[place + 2] = torque * at_motor
        slopes[place + 3] = load * speed if inertia == inertia else inertia
        slopes[place + 4] = (taken + on_crank) * speed + drag * at_motor
        slopes[place + 5] = float(heat(at_motor, time, train.motor))
        slopes[place + BESIDE] = output
        return speed, grown

    return derive


def is_open(slopes: Any, place: int) -> bool:
    """Whether there are no slopes because links do not close, rather than gearing jams: the load has no power."""
    return slopes[place + LOAD_WORK] != slopes[place + LOAD_WORK]


class Joined(NamedTuple):
    """Slopes by time, and the kernels, plain or compiled."""

    derive: Derive
    kernels: Kernels


@cache
def joined(kernels: Kernels, is_compiled: bool) -> Joined:
    """Join kernels once: compiled with Numba, or as they are. One made elsewhere by Numba is taken as it is."""
    if not is_compiled:
        return Joined(time_form(kernels, accelerated), kernels)
    own = Kernels(*(_as_kernel(each) for each in kernels))
    return Joined(quick(time_form(own, quick(accelerated, within=True))), own)


def _as_kernel(kernel: Any) -> Any:
    """Compile a kernel; of an untimed motor the kernel within, as all kernels of the package are."""
    return compiled(kernel) if isinstance(kernel, FunctionType) and kernel.__closure__ is None else quick(kernel)
