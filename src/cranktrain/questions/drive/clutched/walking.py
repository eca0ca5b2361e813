"""The walk of a run through its phases."""

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.questions.drive.clutched.courses import commanded, piece_from
from cranktrain.questions.drive.clutched.equation import (
    ANGLE,
    LINKS_DO_NOT_CLOSE,
    N_PRESS_FED,
    N_PRESS_STATE,
    SPEED,
    WHEEL,
    Acting,
    Phase,
    Press,
    free_gearing,
    joined_press,
    locked_gearing,
)
from cranktrain.questions.drive.clutched.modes import locked_or_slipping, sense_from_rest, set_off_at, static_margin
from cranktrain.questions.drive.clutched.passings import FEW_LOOKS, fallen_at, first_fall, least_within, states_within
from cranktrain.questions.drive.clutched.runs import (
    ANGLE_PASSED,
    AT_STAND,
    COMMAND,
    GEAR_STUCK,
    LINKS_BREAK_OPEN,
    LOCKED,
    LOOSE,
    NOTHING_MOVES,
    OFF,
    RESTS,
    SLIDES,
    SLIPS_ON,
    STEPS_EXHAUSTED,
    TIME_IS_OVER,
    WHEEL_RECOVERED,
    WHEEL_STALLS,
    Moment,
    PressEvent,
    PressPlan,
    PressRun,
    account,
    piece_ends,
)
from cranktrain.questions.drive.running.compiling import quick
from cranktrain.questions.drive.running.equation import Kernels
from cranktrain.questions.drive.running.step import take_step
from cranktrain.questions.drive.running.tableau import ERRORS

_STAND, _STALL, _MEET, _LOOSEN, _JUMP, _COMMANDED, _PASSED, _RECOVERED = range(8)
"""What may end a step early."""
_LARGEST_TURN = 2 * math.pi / 50
_MOST_AT_ONCE = 50
_LEAST_WIDTH = 1e-15
_BESIDE = 1e-11
"""So far from a jump of the load it is asked for, on the side of the phase. [rad]"""


class _Watch(NamedTuple):
    """What falls below 0 at an event, as weights of flywheel's speed, angle and speed of the crank, and a level.

    Without weights it is what a locked clutch could hand on besides.
    """

    kind: int
    weights: tuple[float, float, float] | None
    level: float
    rounding: float


def run_press(
    kernels: Kernels, press: Press, start: Moment, plan: PressPlan, *, is_compiled: bool = True
) -> PressRun:
    """Run a press from a moment until something ends it.

    Parameters
    ----------
    kernels : Kernels
        Of machine, motor and its heat; the brake is the press's own.
    press : Press
    start : Moment
        As `at_rest` or `turning` gives it, or one of another run.
    plan : PressPlan
    is_compiled : bool, optional
        By Numba, which takes a while once.

    Returns
    -------
    PressRun

    Notes
    -----
    docs/theory/clutched-drive, eqs. (30.1) to (30.9). Events to rounding, as ends of steps.
    """
    walk = _Walk(kernels, press, start, plan, is_compiled)
    reason = walk.to_end()
    own = walk.kernels
    residual, supplied = account(own, press, start.state, walk.now.state)
    return PressRun(
        reason, start, walk.now, tuple(walk.events), np.array(walk.times), np.array(walk.states), walk.lowest,
        residual, supplied, walk.n_steps,
    )  # fmt: skip


class _Walk:
    """Where a run is, and what it has met."""

    def __init__(self, kernels: Kernels, press: Press, start: Moment, plan: PressPlan, is_compiled: bool) -> None:
        self.derive, self.kernels = joined_press(kernels, is_compiled)
        self.take: Any = quick(take_step) if is_compiled else take_step
        self.press, self.plan, self.now = press, plan, start
        self.events: list[PressEvent] = []
        self.times, self.states = [start.time], [start.state]
        self.lowest = float(start.state[WHEEL])
        self.scale = max(abs(self.lowest), abs(float(start.state[SPEED]) * press.ratio)) or 1.0
        self.n_steps, self.n_at_once = 0, 0
        self.is_loosened = False
        self.passed = [angle for angle in plan.passed if angle > start.state[ANGLE]]
        self.slopes, self.trial = np.zeros((7, N_PRESS_STATE)), np.zeros((7, N_PRESS_STATE))

    def to_end(self) -> int:
        """Go from phase to phase; the reason of the end."""
        while True:
            if self.n_at_once > _MOST_AT_ONCE or self.n_steps >= self.plan.most_steps:
                return STEPS_EXHAUSTED
            acting, sense, until, reason = self._phase()
            if reason is None:
                reason = self._along(acting, sense, until)
            if reason is not None:
                return reason

    def _phase(self) -> tuple[Acting, float, float, int | None]:
        """What goes on from now, how long at most, and the reason if nothing does."""
        now, press = self.now, self.press
        clutch, brake = piece_from(now.clutch, now.time), piece_from(now.brake, now.time)
        until = min(clutch.end, brake.end, self.plan.end_time)
        low, high = piece_ends(now.piece, self.plan.jumps)
        slip = 0.0 if now.is_locked else float(now.state[WHEEL] - press.ratio * now.state[SPEED])
        gearing = locked_gearing(press) if now.is_locked else free_gearing(press)
        phase = Phase(
            now.time, clutch.level, clutch.slope, brake.level, brake.slope, float(np.sign(slip)), now.is_locked,
            low + _BESIDE, high - _BESIDE, gearing,
        )  # fmt: skip
        sense, is_gripping = float(np.sign(now.state[SPEED])), clutch.level > 0 or clutch.slope > 0
        if now.time >= self.plan.end_time:
            return Acting(press, phase), sense, until, self._reason_of_time(is_gripping)
        if slip == 0 and sense != 0 and is_gripping:
            trial = Acting(press, phase)
            phase = locked_or_slipping(
                self.derive, self.kernels, now.time, now.state, sense, trial, must_slip=self.is_loosened
            )
        else:
            phase = phase._replace(is_locked=False, gearing=free_gearing(press))
        self.is_loosened = False
        if phase.is_locked != now.is_locked:
            self._note(LOCKED if phase.is_locked else LOOSE, is_locked=phase.is_locked)
        if sense == 0:
            return self._from_rest(Acting(press, phase), until, is_gripping)
        return Acting(press, phase), sense, until, None

    def _from_rest(self, acting: Acting, until: float, is_gripping: bool) -> tuple[Acting, float, float, int | None]:
        """Set off, wait, or end."""
        now, plan = self.now, self.plan
        angle = float(now.state[ANGLE])
        sense = sense_from_rest(self.kernels, now.time, angle, acting)
        if sense != 0:
            is_final = not math.isfinite(piece_from(now.brake, now.time).end)
            if now.is_stopping and is_final and not is_gripping:
                return acting, sense, until, SLIDES
            self._note(OFF)
            return acting, sense, until, None
        courses_end = min(piece_from(course, now.time).end for course in (now.clutch, now.brake))
        off = set_off_at(self.kernels, now.time, min(until, courses_end), angle, acting)
        if math.isfinite(off):
            return acting, 0.0, off, None
        if plan.ends_at_rest and not math.isfinite(courses_end):
            return acting, 0.0, until, RESTS if now.is_stopping else SLIPS_ON if is_gripping else NOTHING_MOVES
        if plan.ends_at_rest and now.is_stopping and not is_gripping:
            return acting, 0.0, until, RESTS
        return acting, 0.0, until, None

    def _reason_of_time(self, is_gripping: bool) -> int:
        if self.now.is_stopping and self.now.state[SPEED] != 0 and not math.isfinite(
            piece_from(self.now.brake, self.now.time).end
        ):  # fmt: skip
            return SLIDES
        is_slipping = is_gripping and not self.now.is_locked and not self.now.is_stopping
        return SLIPS_ON if is_slipping else TIME_IS_OVER

    def _watches(self, acting: Acting, sense: float) -> list[_Watch]:
        """What is to be watched in a phase."""
        press, plan, phase = self.press, self.plan, acting.phase
        speed, turn = 1e-13 * self.scale, 1e-14
        found = [_Watch(_STALL, (1.0, 0.0, 0.0), 0.0, speed)]
        if sense == 0:
            if math.isfinite(plan.wheel_speed):
                found.append(_Watch(_RECOVERED, (-1.0, 0.0, 0.0), -plan.wheel_speed, speed))
        else:
            found.append(_Watch(_STAND, (0.0, 0.0, sense), 0.0, speed / press.ratio))
            ahead = piece_ends(self.now.piece, plan.jumps)[int(sense > 0)]
            if math.isfinite(ahead):
                found.append(_Watch(_JUMP, (0.0, -sense, 0.0), -sense * ahead, turn))
            if math.isfinite(plan.command_angle) and not self.now.is_stopping:
                found.append(_Watch(_COMMANDED, (0.0, -1.0, 0.0), -plan.command_angle, turn))
            if self.passed:
                found.append(_Watch(_PASSED, (0.0, -1.0, 0.0), -self.passed[0], turn))
        if phase.is_locked:
            found.append(_Watch(_LOOSEN, None, 0.0, 1e-13 * press.clutch.static_torque))
        elif phase.way != 0 and (phase.clutch_level > 0 or phase.clutch_slope > 0):
            found.append(_Watch(_MEET, (phase.way, 0.0, -phase.way * press.ratio), 0.0, speed))
        return found

    def _along(self, acting: Acting, sense: float, until: float) -> int | None:
        """Step through a phase; a reason if it ends the run."""
        trouble = self.derive(self.now.time, self.now.state, self.slopes[0], sense, acting)
        if trouble:
            return LINKS_BREAK_OPEN if trouble == LINKS_DO_NOT_CLOSE else GEAR_STUCK
        watches, width = self._watches(acting, sense), self._first_width(until)
        while True:
            if self.n_steps >= self.plan.most_steps:
                return STEPS_EXHAUSTED
            speed, grown = abs(float(self.now.state[SPEED])), abs(float(self.slopes[0, SPEED]))
            reach = speed + math.sqrt(speed * speed + 2 * grown * _LARGEST_TURN)
            width = min(width, 2 * _LARGEST_TURN / reach if reach > 0 else math.inf)
            is_last = self.now.time + width * (1 + 1e-9) >= until
            width = until - self.now.time if is_last else width
            ahead, trouble = self._step(self.slopes, width, acting, sense)
            error = self._error(self.slopes, width)
            self.n_steps += 1
            if trouble or not error <= 1:
                width *= max(0.1, 0.9 * error**-0.2) if trouble == 0 and error == error else 0.1
                if width < _LEAST_WIDTH * max(self.now.time, 1e-3):
                    if not trouble:
                        return STEPS_EXHAUSTED
                    return LINKS_BREAK_OPEN if trouble == LINKS_DO_NOT_CLOSE else GEAR_STUCK
                continue
            met = self._met(watches, width, acting, sense)
            if met is not None:
                return self._meet(*met, acting, sense)
            self._watch_lowest(width)
            self._move(until if is_last else self.now.time + width, ahead)
            if is_last:
                return None
            self.slopes[0] = self.slopes[6]
            width *= min(5.0, 0.9 * max(error, 1e-10) ** -0.2)

    def _first_width(self, until: float) -> float:
        grown = float(np.max(np.abs(self.slopes[0, [WHEEL, SPEED]]) * [1.0, self.press.ratio]))
        return min(until - self.now.time, 1e-3 * self.scale / grown if grown > 0 else math.inf, 1e-2)

    def _step(self, slopes: Array, width: float, acting: Acting, sense: float) -> tuple[Array, int]:
        ahead = np.zeros(N_PRESS_STATE)
        trouble = self.take(
            self.derive, self.now.time, width, self.now.state, slopes, N_PRESS_FED, ahead, sense, acting
        )
        return ahead, trouble

    def _error(self, slopes: Array, width: float) -> float:
        errors = np.abs(width * (ERRORS @ slopes[:, :N_PRESS_FED]))
        scales = np.array([self.scale, 1.0, self.scale / self.press.ratio])
        return float(np.max(errors / scales)) / self.plan.tolerance

    def _met(
        self, watches: list[_Watch], width: float, acting: Acting, sense: float
    ) -> tuple[_Watch, float, Array] | None:
        """First event of a step, how far it is, and the state there."""
        found: list[tuple[float, _Watch, Array]] = []
        for watch in watches:
            curve = self._curve(watch, width, acting, sense)
            few = () if watch.weights is not None else (FEW_LOOKS,)
            bracket = first_fall(curve, watch.rounding, *few)
            if bracket is None:
                continue
            reached: dict[float, Array] = {}

            def margin(part: float, watch: _Watch = watch, reached: dict[float, Array] = reached) -> float:
                self.trial[0] = self.slopes[0]
                reached[part], _ = self._step(self.trial, part, acting, sense)
                return self._margin(watch, self.now.time + part, reached[part], acting, sense)

            low, high = bracket[0] * width, bracket[1] * width
            # the step itself is of a higher order than its interpolant, which may see the event a little early
            high = high if margin(high) < 0 else width
            if margin(high) < 0:
                at = fallen_at(margin, low, high)
                margin(at)
                found.append((at, watch, reached[at]))
        if not found:
            return None
        at, watch, state = min(found, key=lambda one: one[0])
        return watch, at, state

    def _curve(self, watch: _Watch, width: float, acting: Acting, sense: float) -> Callable[[Array], Array]:
        """What is watched, over the parts of the step just made."""
        base, slopes = self.now.state, self.slopes
        if watch.weights is not None:
            weights = np.array(watch.weights)
            return lambda parts: states_within(base, slopes, width, parts) @ weights - watch.level

        def spare(parts: Array) -> Array:
            states = np.zeros((len(parts), N_PRESS_STATE))
            states[:, :N_PRESS_FED] = states_within(base, slopes, width, parts)
            return np.array(
                [self._margin(watch, self.now.time + part * width, state, acting, sense)
                 for part, state in zip(parts, states, strict=True)]
            )  # fmt: skip

        return spare

    def _margin(self, watch: _Watch, time: float, state: Array, acting: Acting, sense: float) -> float:
        if watch.weights is not None:
            return float(np.dot(watch.weights, state[:N_PRESS_FED])) - watch.level
        return static_margin(self.derive, self.kernels, time, state, sense, acting)

    def _meet(self, watch: _Watch, width: float, state: Array, acting: Acting, sense: float) -> int | None:
        """Go to an event and do what it brings."""
        self.trial[0] = self.slopes[0]
        self._step(self.slopes, width, acting, sense) if width > 0 else None
        self._watch_lowest(width)
        time, press = self.now.time + width, self.press
        if watch.kind == _STAND:
            state[SPEED] = 0.0
            if acting.phase.is_locked:
                state[WHEEL] = 0.0
        elif watch.kind == _STALL:
            state[WHEEL] = 0.0
        elif watch.kind == _MEET:
            state[WHEEL] = press.ratio * state[SPEED]
        self._move(time, state)
        return self._done(watch.kind, acting, sense)

    def _done(self, kind: int, acting: Acting, sense: float) -> int | None:
        if kind == _STALL or (kind == _STAND and acting.phase.is_locked):
            self.lowest = 0.0
            return WHEEL_STALLS
        if kind == _RECOVERED:
            return WHEEL_RECOVERED
        if kind == _STAND:
            self._note(AT_STAND)
        elif kind == _LOOSEN:
            self.is_loosened = True
        elif kind == _JUMP:
            self.now = replace(self.now, piece=self.now.piece + int(sense))
        elif kind == _PASSED:
            self.passed.pop(0)
            self._note(ANGLE_PASSED)
        elif kind == _COMMANDED:
            self.now = stopping(self.now, self.press)
            self._note(COMMAND)
        return None

    def _watch_lowest(self, width: float) -> None:
        base, slopes = self.now.state, self.slopes
        least = least_within(lambda parts: states_within(base, slopes, width, parts)[:, WHEEL])
        self.lowest = min(self.lowest, least)

    def _move(self, time: float, state: Array) -> None:
        self.n_at_once = self.n_at_once + 1 if time <= self.now.time else 0
        self.now = replace(self.now, time=time, state=state)
        self.times.append(time)
        self.states.append(state)

    def _note(self, kind: int, *, is_locked: bool | None = None) -> None:
        if is_locked is not None:
            self.now = replace(self.now, is_locked=is_locked)
        self.events.append(PressEvent(kind, self.now))


def stopping(moment: Moment, press: Press) -> Moment:
    """Moment at which the command to stop is given: the clutch lets go, the brake comes on."""
    return replace(
        moment,
        clutch=commanded(moment.clutch, press.clutch, moment.time, is_on=False),
        brake=commanded(moment.brake, press.brake, moment.time, is_on=True),
        is_stopping=True,
    )


def starting(moment: Moment, press: Press) -> Moment:
    """Moment at which the command to start is given: the clutch comes on, the brake lets go."""
    return replace(
        moment,
        clutch=commanded(moment.clutch, press.clutch, moment.time, is_on=True),
        brake=commanded(moment.brake, press.brake, moment.time, is_on=False),
        is_stopping=False,
    )
