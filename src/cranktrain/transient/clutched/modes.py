"""Which way things go on from an instant: clutch locked or slipping, crank held or moving."""

import math
from typing import Any, NamedTuple

from cranktrain.transient.clutched.equation import (
    HANDED_ON,
    N_PRESS_ROW,
    ActingPress,
    PressPhase,
    firm_acceleration,
)
from cranktrain.transient.clutched.step import Derive
from cranktrain.transient.equation import Kernels

_LOOKS = 64


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


class AtRest(NamedTuple):
    """What a crank at rest that is to set off in a sense would have to move: inertia and load. [kg·m², N·m]"""

    sense: float
    inertia: float
    load: float


def both_ways(kernels: Kernels, angle: float, acting: ActingPress) -> tuple[AtRest, AtRest]:
    """Forward and back."""
    at = min(max(angle, acting.phase.low), acting.phase.high)
    forward, back = (kernels.machine(at, 0.0, sense, acting.press.machine) for sense in (1.0, -1.0))
    return AtRest(1.0, forward[0], forward[2]), AtRest(-1.0, back[0], back[2])


def urge(time: float, at_rest: AtRest, acting: ActingPress) -> float:
    """Acceleration in a sense of a crank at rest, against what the brake holds; below 0 it stays. [rad/s²]"""
    press, phase = acting
    sense, inertia, load = at_rest
    since = time - phase.start
    grip = phase.way * press.clutch.torque * (phase.clutch_level + phase.clutch_slope * since)
    hold = press.brake.static_torque * (phase.brake_level + phase.brake_slope * since) * sense
    on_crank = hold * press.brake_on_crank
    grown, _, count = firm_acceleration(grip - hold + on_crank, sense, inertia, load + on_crank, press.behind)
    return grown * sense if count == 0 else -math.inf


def sense_from_rest(time: float, ways: tuple[AtRest, AtRest], acting: ActingPress) -> float:
    """Which way a crank at rest sets off: 1 forward, −1 back, 0 held. docs/theory/clutched-drive, eq. (30.5)."""
    return next((way.sense for way in ways if urge(time, way, acting) > 0), 0.0)


def set_off_at(time: float, until: float, ways: tuple[AtRest, AtRest], acting: ActingPress) -> float:
    """When a crank that is held sets off, infinite if not before `until`; the courses are lines up to there. [s]"""
    n_changing = (acting.phase.clutch_slope != 0) + (acting.phase.brake_slope != 0)
    if not math.isfinite(until) or not n_changing:
        return math.inf
    # if one of them alone changes, what urges the crank either way only grows or only falls
    n_looks, before = 1 if n_changing == 1 else _LOOKS, time
    for look in range(1, n_looks + 1):
        at = time + (until - time) * look / n_looks
        if sense_from_rest(at, ways, acting) != 0:
            while before < (middle := 0.5 * (before + at)) < at:
                if sense_from_rest(middle, ways, acting) != 0:
                    at = middle
                else:
                    before = middle
            return at
        before = at
    return math.inf
