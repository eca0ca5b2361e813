"""The equation of motion of a press with a clutch and a brake, by its phase."""

from functools import cache
from typing import Any, NamedTuple

from cranktrain.linkage import compiled
from cranktrain.motion import Array
from cranktrain.questions.drive.clutched.courses import Grip
from cranktrain.questions.drive.running.compiling import quick
from cranktrain.questions.drive.running.equation import Kernels, joined
from cranktrain.questions.drive.running.gearing import Gearing, acceleration, stages
from cranktrain.questions.drive.running.step import Derive

WHEEL, ANGLE, SPEED, MOTOR_WORK, LOAD_WORK, CLUTCH_HEAT, BRAKE_HEAT, LOST_WORK, MOTOR_HEAT = range(9)
"""Components of the state: speed of the flywheel, angle and speed of the crank, and what work became of since."""
N_PRESS_STATE, N_PRESS_FED = 9, 3
LINKS_DO_NOT_CLOSE, GEAR_HAS_NO_ANSWER = 1, 2
"""Why there is no acceleration."""


class Press(NamedTuple):
    """Numbers of a press.

    Attributes
    ----------
    machine, motor
        For their kernels.
    motor_ratio : float
        Speed of the motor over that of the flywheel. [1]
    wheel_inertia : float
        Of all that turns with the clutch's driving side, the motor by the square of its ratio. [kg·m²]
    driven_inertia : float
        Of what turns with its driven side before the gear. [kg·m²]
    ratio : float
        Speed of the clutch's driven side over that of the crank. [1]
    forward, backward : float
        Efficiency of that gear toward the crank and back. [1]
    clutch, brake : Grip
    brake_on_crank : float
        1 of a brake on the crankshaft, 0 of one on the clutch's driven side.
    """

    machine: Any
    motor: Any
    motor_ratio: float
    wheel_inertia: float
    driven_inertia: float
    ratio: float
    forward: float
    backward: float
    clutch: Grip
    brake: Grip
    brake_on_crank: float


class Phase(NamedTuple):
    """Between two events, where all is smooth.

    Attributes
    ----------
    start : float
        From which the courses count. [s]
    clutch_level, clutch_slope, brake_level, brake_slope : float
        Of their courses, which are lines here. [1, 1/s]
    way : float
        Sign of the clutch's slip, flywheel less crank.
    is_locked : bool
    low, high : float
        Crank angles between which the load has no jump; beyond, what holds there goes on. [rad]
    gearing : Gearing
        Of what the crank takes along: the clutch's driven side, locked the flywheel too.
    """

    start: float
    clutch_level: float
    clutch_slope: float
    brake_level: float
    brake_slope: float
    way: float
    is_locked: bool
    low: float
    high: float
    gearing: Gearing


class Acting(NamedTuple):
    """A press in a phase."""

    press: Press
    phase: Phase


def free_gearing(press: Press) -> Gearing:
    """From the clutch's driven side to the crank."""
    return stages(press.driven_inertia, (press.ratio, press.forward, press.backward, 0.0, 0.0))


def locked_gearing(press: Press) -> Gearing:
    """The same with the flywheel and motor on it."""
    return free_gearing(press)._replace(motor_inertia=float(press.driven_inertia + press.wheel_inertia))


def press_form(kernels: Kernels, law: Any) -> Derive:
    """Join the kernels to the slopes of the state by time; a sense of 0 is a crank that is held.

    docs/theory/clutched-drive, eqs. (30.1), (30.2) and (30.8).
    """
    machine, motor, heat, _ = kernels

    def derive(time: float, state: Array, slopes: Array, sense: float, acting: Acting) -> int:
        press, phase = acting.press, acting.phase
        speed, since = state[2], time - phase.start
        angle = min(max(state[1], phase.low), phase.high)
        inertia, first, load, _ = machine(angle, speed, sense, press.machine)
        at_motor = state[0] * press.motor_ratio
        driving = motor(at_motor, time, press.motor) * press.motor_ratio
        grip = phase.way * press.clutch.torque * (phase.clutch_level + phase.clutch_slope * since)
        drag = press.brake.torque * (phase.brake_level + phase.brake_slope * since) * sense
        at_clutch = drag * (1.0 - press.brake_on_crank)
        at_crank = drag * press.brake_on_crank
        grown, taken, count = 0.0, 0.0, 0
        if sense != 0:
            entering = driving if phase.is_locked else grip
            facing = load + 0.5 * first * speed * speed + at_crank
            grown, taken, count = law(entering - at_clutch, sense, inertia, facing, phase.gearing)
        slopes[0] = press.ratio * grown if phase.is_locked else (driving - grip) / press.wheel_inertia
        slopes[1] = speed
        slopes[2] = grown
        slopes[3] = driving * state[0]
        slopes[4] = load * speed
        slopes[5] = 0.0 if phase.is_locked else grip * (state[0] - press.ratio * speed)
        slopes[6] = (at_clutch * press.ratio + at_crank) * speed
        slopes[7] = taken * speed
        slopes[8] = heat(at_motor, time, press.motor)
        if count != 0:
            return 1 if inertia * load != inertia * load else 2
        return 0

    return derive


@cache
def joined_press(kernels: Kernels, is_compiled: bool) -> tuple[Derive, Kernels]:
    """Join kernels once, compiled with Numba or as they are: slopes by time, and the kernels."""
    if not is_compiled:
        return press_form(kernels, acceleration), kernels
    own = joined(kernels, True).kernels
    return quick(press_form(own, compiled(acceleration))), own


def kinetic_energy(kernels: Kernels, press: Press, state: Array) -> float:
    """Of the flywheel, the clutch's driven side, the crank and all that it moves. [J]"""
    inertia = kernels.machine(float(state[1]), float(state[2]), 1.0, press.machine)[0]
    behind = inertia + press.driven_inertia * press.ratio**2
    return float(0.5 * press.wheel_inertia * state[0] ** 2 + 0.5 * behind * state[2] ** 2)
