"""The equation of motion of a press with a clutch and a brake, by its phase."""

from typing import Any, NamedTuple, cast

import numpy as np

from cranktrain.motion import Array
from cranktrain.transient.clutched.courses import Grip
from cranktrain.transient.clutched.step import Derive
from cranktrain.transient.equation import Kernels
from cranktrain.transient.gearing import NONE, Gearing, acceleration, overall_ratio, turning_inertia

WHEEL, ANGLE, SPEED, MOTOR_WORK, LOAD_WORK, CLUTCH_HEAT, BRAKE_HEAT, LOST_WORK, MOTOR_HEAT = range(9)
"""Components of the state: speed of the flywheel, angle and speed of the crank, and what work became of since."""
N_PRESS_STATE, N_PRESS_FED = 9, 3
HANDED_ON = N_PRESS_STATE
"""Where in a row of slopes the torque stands that the clutch hands on, beside them. [N·m]"""
N_PRESS_ROW = N_PRESS_STATE + 1
LINKS_DO_NOT_CLOSE, GEAR_HAS_NO_ANSWER = 1, 2
"""Why there is no acceleration."""
_ROUNDING = 1e-12
_HELD = (0.0, 0.0, 0.0, 0.0)


class Press(NamedTuple):
    """Numbers of a press, as `press_of` puts them together.

    Attributes
    ----------
    machine, motor
        For their kernels.
    before, behind : Gearing
        From the motor to the clutch's driving side, the flywheel with it; and from its driven side, whose own inertia
        stands for the motor's, to the crank.
    locked : Gearing
        Both as one, as the clutch joins them.
    motor_ratio, ratio : float
        Speed of the motor over that of the flywheel, and of the clutch's driven side over that of the crank. [1]
    clutch, brake : Grip
    brake_on_crank : float
        1 of a brake on the crankshaft, 0 of one on the clutch's driven side.
    """

    machine: Any
    motor: Any
    before: Gearing
    behind: Gearing
    locked: Gearing
    motor_ratio: float
    ratio: float
    clutch: Grip
    brake: Grip
    brake_on_crank: float


def press_of(
    machine: Any, motor: Any, before: Gearing, behind: Gearing, clutch: Grip, brake: Grip, *, brake_on_crank: bool
) -> Press:
    """Put the numbers of a press together; fields as of `Press`, stages in lists, which are the quickest here.

    Where no stage stands behind the clutch, it sits on the crankshaft, and so does the brake.
    """
    before, behind = _listed(before), _listed(behind)
    numbers = [[*one, *other] for one, other in zip(before[1:], behind[1:], strict=True)]
    motor_inertia, inertia, n_before = before.motor_inertia, numbers[-1], len(before.ratio)
    if n_before:
        inertia[n_before - 1] += behind.motor_inertia
    else:
        motor_inertia += behind.motor_inertia
    locked = Gearing(float(motor_inertia), *(cast(Array, part) for part in numbers))
    motor_ratio, ratio = float(overall_ratio(before)), float(overall_ratio(behind))
    on_crank = 1.0 if brake_on_crank or not len(behind.ratio) else 0.0
    return Press(machine, motor, before, behind, locked, motor_ratio, ratio, clutch, brake, on_crank)


def _listed(gearing: Gearing) -> Gearing:
    """Gearing with its stages in lists."""
    return Gearing(gearing.motor_inertia, *(cast(Array, np.asarray(part).tolist()) for part in gearing[1:]))


class PressPhase(NamedTuple):
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


class ActingPress(NamedTuple):
    """A press in a phase."""

    press: Press
    phase: PressPhase


def needed_torque(grown: float, sense: float, inertia: float, facing: float, gearing: Gearing) -> float:
    """Torque that must enter a gearing for an acceleration of the crank behind it. [N·m]

    docs/theory/transient, eq. (26.5).
    """
    passed, overall = inertia * grown + facing, 1.0
    for stage in range(len(gearing.ratio) - 1, -1, -1):
        passed += gearing.inertia[stage] * overall * grown
        part = 1.0 / gearing.forward[stage] if passed * sense > 0 else gearing.backward[stage]
        passed = passed * part / gearing.ratio[stage] + gearing.drag[stage] * sense
        overall *= gearing.ratio[stage]
    return passed + gearing.motor_inertia * overall * grown


def firm_acceleration(
    torque: float, sense: float, inertia: float, load: float, gearing: Gearing
) -> tuple[float, float, int]:
    """As `gearing.acceleration`, where a stage hands on nothing, too: there rounding lets neither of its signs fit.

    An open clutch without inertia behind it leaves a gear that idles. A torque that differs by rounding then has one.
    """
    grown, taken, count = acceleration(torque, sense, inertia, load, gearing)
    if count == NONE:
        overall = 1.0
        for ratio in gearing.ratio:
            overall *= ratio
        beside = _ROUNDING * (abs(torque) + abs(load) / overall)
        grown, taken, count = acceleration(torque + beside, sense, inertia, load, gearing)
        if count == NONE:
            grown, taken, count = acceleration(torque - beside, sense, inertia, load, gearing)
    return grown, taken, count


def _braked(gearing: Gearing, stage: int, torque: float) -> Gearing:
    """Gearing with a torque more that a stage takes at its input."""
    drag = list(gearing.drag)
    if stage < len(drag):
        drag[stage] += torque
    return Gearing(
        gearing.motor_inertia, gearing.ratio, gearing.forward, gearing.backward, cast(Array, drag), gearing.inertia
    )


def press_form(kernels: Kernels) -> Derive:
    """Join the kernels to the slopes of the state by time; a sense of 0 is a crank that is held.

    Beside the slopes it leaves what the clutch hands on. docs/theory/clutched-drive, eqs. (30.1), (30.2) and (30.8).
    """
    machine, motor, heat = kernels[:3]

    def derive(time: float, state: Any, slopes: Any, sense: float, acting: ActingPress) -> int:
        press, phase = acting.press, acting.phase
        wheel, speed, since = state[0], state[2], time - phase.start
        angle = min(max(state[1], phase.low), phase.high)
        # beside a crank that is held the machine does nothing
        inertia, first, load, _ = machine(angle, speed, sense, press.machine) if sense else _HELD
        at_motor = wheel * press.motor_ratio
        driving = motor(at_motor, time, press.motor)
        grip = phase.way * press.clutch.torque * (phase.clutch_level + phase.clutch_slope * since)
        drag = press.brake.torque * (phase.brake_level + phase.brake_slope * since)
        on_crank = drag * press.brake_on_crank
        on_clutch = drag - on_crank
        facing = load + 0.5 * first * speed * speed + on_crank * sense
        grown, taken, lost, count = 0.0, 0.0, 0.0, 0
        if phase.is_locked:
            gearing = _braked(press.locked, len(press.before.ratio), on_clutch) if on_clutch else press.locked
            grown, taken, count = firm_acceleration(driving, sense, inertia, facing, gearing)
            slopes[0] = press.ratio * grown
            # what the brake takes is not the gears' loss
            lost = taken * speed - on_clutch * press.ratio * sense * speed
            slopes[5] = 0.0
            slopes[HANDED_ON] = needed_torque(grown, sense, inertia, facing, press.behind) + on_clutch * sense
        else:
            slopes[0], taken, count = firm_acceleration(driving, 1.0, 0.0, grip, press.before)
            lost = taken * wheel
            if sense != 0 and count == 0:
                grown, taken, count = firm_acceleration(grip - on_clutch * sense, sense, inertia, facing, press.behind)
                lost += taken * speed
            slopes[5] = grip * (wheel - press.ratio * speed)
            slopes[HANDED_ON] = grip
        slopes[1] = speed
        slopes[2] = grown
        slopes[3] = driving * at_motor
        slopes[4] = load * speed
        slopes[6] = (on_clutch * press.ratio + on_crank) * sense * speed
        slopes[7] = lost
        slopes[8] = heat(at_motor, time, press.motor)
        if count != 0:
            return 1 if inertia * load != inertia * load else 2
        return 0

    return derive


def kinetic_energy(kernels: Kernels, press: Press, state: Array) -> float:
    """Of the flywheel, the clutch's driven side, the crank and all that it moves. [J]"""
    inertia = kernels.machine(float(state[1]), float(state[2]), 1.0, press.machine)[0]
    wheel, behind = turning_inertia(press.before), inertia + turning_inertia(press.behind)
    return float(0.5 * wheel * state[0] ** 2 + 0.5 * behind * state[2] ** 2)
