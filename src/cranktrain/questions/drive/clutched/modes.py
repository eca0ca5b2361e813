"""Which way things go on from an instant: clutch locked or slipping, crank held or moving."""

import math
from typing import Any

from cranktrain.questions.drive.clutched.equation import (
    HANDED_ON,
    N_PRESS_ROW,
    ActingPress,
    PressPhase,
    firm_acceleration,
)
from cranktrain.questions.drive.clutched.step import Derive
from cranktrain.questions.drive.running.equation import Kernels

_LOOKS = 64
_HALVINGS = 80


def static_margin(time: float, handed_on: float, acting: ActingPress) -> float:
    """By how much a locked clutch could hand on more than it does; below 0 it breaks loose. [N·m]

    docs/theory/clutched-drive, eq. (30.4).
    """
    phase = acting.phase
    level = phase.clutch_level + phase.clutch_slope * (time - phase.start)
    return acting.press.clutch.static_torque * level - abs(handed_on)


def locked_or_slipping(
    derive: Derive, time: float, state: Any, sense: float, acting: ActingPress, *, must_slip: bool
) -> PressPhase:
    """Phase of a clutch whose sides turn alike: locked, or slipping the way that it is driven beyond what it holds.

    It must slip where it has just broken loose: there what it hands on is what it holds, to rounding.
    """
    press, phase = acting.press, acting.phase
    locked = phase._replace(is_locked=True)
    trial, slopes = ActingPress(press, locked), [0.0] * N_PRESS_ROW
    derive(time, state, slopes, sense, trial)
    if not must_slip and static_margin(time, slopes[HANDED_ON], trial) >= 0:
        return locked
    return phase._replace(is_locked=False, way=math.copysign(1.0, slopes[HANDED_ON]))


def urge(kernels: Kernels, time: float, angle: float, sense: float, acting: ActingPress) -> float:
    """Acceleration in a sense of a crank at rest, against what the brake holds; below 0 it stays. [rad/s²]"""
    press, phase = acting.press, acting.phase
    since = time - phase.start
    at = min(max(angle, phase.low), phase.high)
    inertia, _, load, _ = kernels.machine(at, 0.0, sense, press.machine)
    grip = phase.way * press.clutch.torque * (phase.clutch_level + phase.clutch_slope * since)
    hold = press.brake.static_torque * (phase.brake_level + phase.brake_slope * since) * sense
    on_crank = hold * press.brake_on_crank
    grown, _, count = firm_acceleration(grip - hold + on_crank, sense, inertia, load + on_crank, press.behind)
    return grown * sense if count == 0 else -math.inf


def sense_from_rest(kernels: Kernels, time: float, angle: float, acting: ActingPress) -> float:
    """Which way a crank at rest sets off: 1 forward, −1 back, 0 held. docs/theory/clutched-drive, eq. (30.5)."""
    return next((sense for sense in (1.0, -1.0) if urge(kernels, time, angle, sense, acting) > 0), 0.0)


def set_off_at(kernels: Kernels, time: float, until: float, angle: float, acting: ActingPress) -> float:
    """When a crank that is held sets off, infinite if not before `until`; the courses are lines up to there. [s]"""
    if not math.isfinite(until):
        return math.inf
    before = time
    for look in range(1, _LOOKS + 1):
        at = time + (until - time) * look / _LOOKS
        if sense_from_rest(kernels, at, angle, acting) != 0:
            for _ in range(_HALVINGS):
                middle = 0.5 * (before + at)
                if sense_from_rest(kernels, middle, angle, acting) != 0:
                    at = middle
                else:
                    before = middle
            return at
        before = at
    return math.inf
