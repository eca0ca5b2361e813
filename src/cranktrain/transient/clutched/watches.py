"""What may end a step early, and where in the step it does."""

import math
from collections.abc import Callable
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from cranktrain.motion import Array
from cranktrain.transient.clutched.equation import N_PRESS_FED
from cranktrain.transient.clutched.passings import FEW_LOOKS, LOOKS, fallen_at, first_fall, states_within
from cranktrain.transient.clutched.phases import Ahead
from cranktrain.transient.clutched.runs import Moment, PressPlan, piece_ends
from cranktrain.transient.clutched.step import INTERPOLANT

_BESIDE = 1e-6
"""Of a step: an event within it is no nearer to its ends, and its slope is taken over so much."""
_MOST_STEPS = 16

STANDS, STALLS, MEETS, LOOSENS, PASSES_JUMP, PASSES_COMMAND, PASSES_WANTED, RECOVERS = range(8)
"""The crank or the flywheel comes to a stand; clutch's sides meet or part; angles; the flywheel's speed."""

Spare: TypeAlias = Callable[[float, Any], float]
"""(time within the step, state) → what a locked clutch could hand on besides. [N·m]"""


class Watch(NamedTuple):
    """What falls below 0 at an event: weights of flywheel's speed, angle and speed of the crank, less a level.

    Without weights it is what a locked clutch could hand on besides. What is below 0 by `rounding` is 0.
    """

    kind: int
    weights: tuple[float, float, float] | None
    level: float
    rounding: float


class Stepped(NamedTuple):
    """A step just made.

    Attributes
    ----------
    state : Array
        At its beginning.
    slopes : Array
        Of its stages.
    width : float
        [s]
    spares : tuple of float
        What a locked clutch could hand on besides, at the beginning and at the end. [N·m]
    """

    state: Array
    slopes: Array
    width: float
    spares: tuple[float, float]

    @property
    def begun(self) -> list[float]:
        """Components that feed back, at the beginning."""
        return self.state[:N_PRESS_FED].tolist()

    @property
    def fed(self) -> list[list[float]]:
        """Their slopes of all stages."""
        return self.slopes[:, :N_PRESS_FED].tolist()


def watches_of(ahead: Ahead, now: Moment, plan: PressPlan, wanted: list[float], scale: float) -> list[Watch]:
    """What is to be watched in a phase; `wanted` are angles whose moments are, `scale` is of the flywheel's speed."""
    press, phase = ahead.acting
    speed, turn = 1e-13 * scale, 1e-14
    found = [Watch(STALLS, (1.0, 0.0, 0.0), 0.0, speed)]
    if ahead.sense == 0:
        if math.isfinite(plan.wheel_speed):
            found.append(Watch(RECOVERS, (-1.0, 0.0, 0.0), -plan.wheel_speed, speed))
    else:
        found.append(Watch(STANDS, (0.0, 0.0, ahead.sense), 0.0, speed / press.ratio))
        end = piece_ends(now.piece, plan.jumps)[int(ahead.sense > 0)]
        if math.isfinite(end):
            found.append(Watch(PASSES_JUMP, (0.0, -ahead.sense, 0.0), -ahead.sense * end, turn))
        if math.isfinite(plan.command_angle) and not now.is_stopping:
            found.append(Watch(PASSES_COMMAND, (0.0, -1.0, 0.0), -plan.command_angle, turn))
        if wanted:
            found.append(Watch(PASSES_WANTED, (0.0, -1.0, 0.0), -wanted[0], turn))
    if phase.is_locked:
        found.append(Watch(LOOSENS, None, 0.0, 1e-13 * press.clutch.static_torque))
    elif phase.way != 0 and (phase.clutch_level > 0 or phase.clutch_slope > 0):
        found.append(Watch(MEETS, (phase.way, 0.0, -phase.way * press.ratio), 0.0, speed))
    return found


def first_met(
    watches: list[Watch], step: Stepped, again: Callable[[float], list[float]], spare: Spare
) -> tuple[Watch, float] | None:
    """First event of a step, and how far from its beginning it is; None if there is none.

    Where one may be is seen on the step's interpolant; where it is, on steps of that length, `again`, which are of a
    higher order.
    """
    found: tuple[Watch, float] | None = None
    for watch in watches:
        bracket = None if _stays(watch, step, spare) else _seen_fall(watch, step, spare)
        if bracket is None or (found is not None and bracket[0] * step.width > found[1]):
            continue
        at = _settled(watch, step, again, spare, bracket)
        if at is not None and (found is None or at < found[1]):
            found = watch, at
    return found


def margin(watch: Watch, time: float, state: list[float], spare: Spare) -> float:
    """What is watched, at a state."""
    if watch.weights is None:
        return spare(time, state)
    wheel, angle, speed = watch.weights
    return wheel * state[0] + angle * state[1] + speed * state[2] - watch.level


def _stays(watch: Watch, step: Stepped, spare: Spare) -> bool:
    """Whether what is watched stays above 0 even if it falls twice as fast as at the stage where it does so most."""
    if watch.weights is None:
        return False
    wheel, angle, speed = watch.weights
    fastest = min(wheel * a + angle * b + speed * c for a, b, c in step.fed)
    return margin(watch, 0.0, step.begun, spare) + 2 * step.width * min(fastest, 0.0) > 0


def _spares(parts: Array, step: Stepped, spare: Spare) -> Array:
    """What a locked clutch could hand on besides, at parts of a step. [N·m]"""
    states = states_within(step.state, step.slopes, step.width, parts).tolist()
    at_ends = {0.0: step.spares[0], 1.0: step.spares[1]}
    return np.array(
        [
            at_ends[part] if part in at_ends else spare(part * step.width, state)
            for part, state in zip(parts.tolist(), states, strict=True)
        ]
    )


def _seen_fall(watch: Watch, step: Stepped, spare: Spare) -> tuple[float, float] | None:
    """Bracket of what falls below 0 in a step, by its interpolant."""

    def curve(parts: Array) -> Array:
        if watch.weights is None:
            return _spares(parts, step, spare)
        return states_within(step.state, step.slopes, step.width, parts) @ np.array(watch.weights) - watch.level

    looks = FEW_LOOKS if watch.weights is None else LOOKS
    return first_fall(curve, looks, curve(looks), watch.rounding)


def _settled(
    watch: Watch, step: Stepped, again: Callable[[float], list[float]], spare: Spare, bracket: tuple[float, float]
) -> float | None:
    """How far into a step what is watched passes 0; None if the step itself does not see it."""

    def at(part: float) -> float:
        return margin(watch, part, again(part), spare)

    near = _near(watch, step, spare, bracket)
    if near is not None and (found := _by_secants(at, *near, watch.rounding)) is not None:
        return found
    for end in (bracket[1] * step.width, step.width):
        if at(end) < 0:
            return fallen_at(at, bracket[0] * step.width, end, watch.rounding)
    return None


def _near(watch: Watch, step: Stepped, spare: Spare, bracket: tuple[float, float]) -> tuple[float, float] | None:
    """Where the step's interpolant sees what is watched pass 0, and its slope there.

    None where it only touches 0, or at an end of the step.
    """
    begun = step.begun
    rates = (step.width * step.slopes[:, :N_PRESS_FED].T @ INTERPOLANT).tolist()

    def curve(part: float) -> float:
        there = [
            y + part * (a + part * (b + part * (c + part * d))) for y, (a, b, c, d) in zip(begun, rates, strict=True)
        ]
        return margin(watch, part * step.width, there, spare)

    if not curve(bracket[1]) < 0:
        return None
    part = fallen_at(curve, *bracket, watch.rounding)
    slope = (curve(part) - curve(part - _BESIDE)) / (_BESIDE * step.width)
    is_within = _BESIDE < part < 1 - _BESIDE
    return (step.width * part, slope) if is_within and slope < 0 else None


def _by_secants(at: Callable[[float], float], near: float, slope: float, rounding: float) -> float | None:
    """Where a curve passes 0, by secants from the slope of another that is next to it; None if they come to no end."""
    before = math.nan
    for _ in range(_MOST_STEPS):
        value = at(near)
        if abs(value) <= rounding:
            return near
        slope = slope if math.isnan(before) else slope * (before - value) / before
        if not slope < 0:
            return None
        before, near = value, near - value / slope
        if not 0 < near < math.inf:
            return None
    return None
