"""The walk of a run through its phases."""

import math
from dataclasses import replace

import numpy as np

from cranktrain.motion import Array
from cranktrain.transient.clutched.courses import commanded
from cranktrain.transient.clutched.equation import (
    ANGLE,
    HANDED_ON,
    LINKS_DO_NOT_CLOSE,
    N_PRESS_ROW,
    N_PRESS_STATE,
    SPEED,
    WHEEL,
    Press,
    press_form,
)
from cranktrain.transient.clutched.idling import idle_slopes
from cranktrain.transient.clutched.modes import static_margin
from cranktrain.transient.clutched.passings import LOOKS, least_within, states_within
from cranktrain.transient.clutched.phases import Ahead, ahead_of
from cranktrain.transient.clutched.runs import (
    ALL_PASSED,
    ANGLE_PASSED,
    AT_STAND,
    COMMAND,
    GEAR_STUCK,
    LINKS_BREAK_OPEN,
    LOCKED,
    LOOSE,
    STEPS_EXHAUSTED,
    STEPS_VANISH,
    WHEEL_RECOVERED,
    WHEEL_STALLS,
    Moment,
    PressEvent,
    PressPlan,
    PressRun,
    account,
)
from cranktrain.transient.clutched.step import Slopes, error_of, no_slopes, take_step
from cranktrain.transient.clutched.watches import (
    LOOSENS,
    MEETS,
    PASSES_COMMAND,
    PASSES_JUMP,
    PASSES_WANTED,
    RECOVERS,
    STALLS,
    STANDS,
    Stepped,
    Watch,
    first_met,
    watches_of,
)
from cranktrain.transient.equation import Kernels
from cranktrain.transient.transient import LARGEST_TURN, time_over

_BEYOND = 1e-3
"""Of the way to an angle at which the load jumps: so far beyond it a step is to end, so that it is met."""
_MOST_AT_ONCE = 50
_LEAST_WIDTH = 1e-15


def run_press(kernels: Kernels, press: Press, start: Moment, plan: PressPlan) -> PressRun:
    """Run a press from a moment until something ends it.

    Parameters
    ----------
    kernels : Kernels
        Of machine, motor and its heat; the brake is the press's own.
    press : Press
    start : Moment
        As `at_rest` or `turning` gives it, or one of another run.
    plan : PressPlan

    Returns
    -------
    PressRun

    Notes
    -----
    docs/theory/clutched-drive, eqs. (30.1) to (30.9). Events to rounding, as ends of steps.
    """
    walk = _Walk(kernels, press, start, plan)
    reason = walk.to_end()
    own = walk.kernels
    residual, supplied = account(own, press, start.state, walk.now.state)
    return PressRun(
        reason, start, walk.now, tuple(walk.events), np.array(walk.times), np.array(walk.states), tuple(walk.stepped),
        walk.lowest, residual, supplied, walk.n_steps,
    )  # fmt: skip


class _Walk:
    """Where a run is, and what it has met."""

    def __init__(self, kernels: Kernels, press: Press, start: Moment, plan: PressPlan) -> None:
        self.derive, self.kernels = press_form(kernels), kernels
        self.press, self.plan, self.now = press, plan, start
        self.events: list[PressEvent] = []
        self.times, self.states, self.stepped = [start.time], [start.state], list[Array]()
        self.lowest = float(start.state[WHEEL])
        self.scale = max(abs(self.lowest), abs(float(start.state[SPEED]) * press.ratio)) or 1.0
        self.scales = (self.scale, 1.0, self.scale / press.ratio)
        self.n_steps, self.n_at_once, self.is_loosened = 0, 0, False
        self.wanted = [angle for angle in plan.passed if angle > start.state[ANGLE]]
        self.slopes, self.trial, self.beside = no_slopes(N_PRESS_ROW), no_slopes(N_PRESS_ROW), [0.0] * N_PRESS_ROW

    def to_end(self) -> int:
        """Go from phase to phase; the reason of the end."""
        while self.n_at_once <= _MOST_AT_ONCE:
            ahead = ahead_of(self.derive, self.kernels, self.press, self.now, self.plan, must_slip=self.is_loosened)
            self.is_loosened = False
            for kind in ahead.happened:
                self._note(kind)
            reason = self._along(ahead) if ahead.reason is None else ahead.reason
            if reason is not None:
                return reason
        return STEPS_EXHAUSTED

    def _along(self, ahead: Ahead) -> int | None:
        """Step through a phase; a reason if it ends the run."""
        trouble = self.derive(self.now.time, self.now.state.tolist(), self.slopes[0], ahead.sense, ahead.acting)
        if trouble:
            return _reason_of(trouble)
        watches = watches_of(ahead, self.now, self.plan, self.wanted, self.scale)
        width = self._first_width(ahead.until)
        while self.n_steps < self.plan.most_steps:
            if self._waits_idling(ahead):
                return None
            width = min(width, self._largest_width(ahead))
            is_last = self.now.time + width * (1 + 1e-9) >= ahead.until
            width = ahead.until - self.now.time if is_last else width
            state, trouble = self._step(self.slopes, width, ahead)
            error = self._error(width)
            self.n_steps += 1
            if trouble or not error <= 1:
                width *= max(0.1, 0.9 * error**-0.2) if trouble == 0 and error == error else 0.1
                if width < _LEAST_WIDTH * max(self.now.time, 1e-3):
                    return _reason_of(trouble)
                continue
            slopes = np.array(self.slopes)[:, :N_PRESS_STATE]
            step = Stepped(self.now.state, slopes, width, self._spares_at_ends(width, ahead))
            met = first_met(
                watches,
                step,
                lambda part: self._again(part, ahead),
                lambda time, state: self._spare(time, state, ahead),
            )
            if met is not None:
                return self._meet(*met, ahead)
            self._watch_lowest(width, slopes)
            self._move(ahead.until if is_last else self.now.time + width, np.array(state), slopes)
            if is_last:
                return None
            self.slopes[0] = list(self.slopes[6])
            width *= min(10.0, 0.9 * max(error, 1e-10) ** -0.2)
        return STEPS_EXHAUSTED

    def _waits_idling(self, ahead: Ahead) -> bool:
        """Wait in one step until the phase ends, where the flywheel idles."""
        now, closeness = self.now, self.plan.tolerance * self.scale
        found = idle_slopes(self.derive, ahead, now.time, now.state, closeness)
        if found is None:
            return False
        self.n_steps += 1
        state = now.state + (ahead.until - now.time) * found
        self._move(ahead.until, state, np.tile(found, (len(self.slopes), 1)))
        return True

    def _first_width(self, until: float) -> float:
        grown = max(abs(self.slopes[0][WHEEL]), abs(self.slopes[0][SPEED]) * self.press.ratio)
        return min(until - self.now.time, 1e-2 * self.scale / grown if grown > 0 else math.inf, 1e-2)

    def _largest_width(self, ahead: Ahead) -> float:
        """In which the crank turns by no more than it may in a step, and reaches the next angle of a jump. [s]"""
        angle, speed = (float(self.now.state[part]) for part in (ANGLE, SPEED))
        sense, grown, phase = ahead.sense, self.slopes[0][SPEED], ahead.acting.phase
        until_jump = (phase.high - angle if sense > 0 else angle - phase.low) * (1 + _BEYOND) if sense else math.inf
        most = time_over(LARGEST_TURN, abs(speed), abs(grown))
        return min(most, time_over(until_jump, abs(speed), sense * grown)) if until_jump > 0 else most

    def _step(self, slopes: Slopes, width: float, ahead: Ahead) -> tuple[list[float], int]:
        now = self.now
        return take_step(self.derive, now.time, width, now.state.tolist(), slopes, ahead.sense, ahead.acting)

    def _again(self, width: float, ahead: Ahead) -> list[float]:
        """State behind a shorter step from the same beginning."""
        self.trial[0] = self.slopes[0]
        return self._step(self.trial, width, ahead)[0]

    def _spare(self, time: float, state: list[float], ahead: Ahead) -> float:
        self.derive(self.now.time + time, state, self.beside, ahead.sense, ahead.acting)
        return static_margin(self.now.time + time, self.beside[HANDED_ON], ahead.acting)

    def _spares_at_ends(self, width: float, ahead: Ahead) -> tuple[float, float]:
        """What a locked clutch could hand on besides, at both ends of a step. [N·m]"""
        start, end = self.slopes[0][HANDED_ON], self.slopes[-1][HANDED_ON]
        return static_margin(self.now.time, start, ahead.acting), static_margin(
            self.now.time + width, end, ahead.acting
        )

    def _error(self, width: float) -> float:
        """Of the step just made, in parts of what is allowed; NaN where one component has none."""
        errors = [error_of(self.slopes, width, part) / scale for part, scale in enumerate(self.scales)]
        return (max(errors) if sum(errors) < math.inf else math.nan) / self.plan.tolerance

    def _meet(self, watch: Watch, width: float, ahead: Ahead) -> int | None:
        """Go to an event, and do what it brings; a reason if it ends the run."""
        state, slopes = self.now.state.copy(), np.zeros((1, N_PRESS_STATE))
        if width > 0:
            state = np.array(self._step(self.slopes, width, ahead)[0])
            slopes = np.array(self.slopes)[:, :N_PRESS_STATE]
            self._watch_lowest(width, slopes)
        is_stalled = watch.kind == STALLS or (watch.kind == STANDS and ahead.acting.phase.is_locked)
        if watch.kind == STANDS or is_stalled:
            state[WHEEL if watch.kind == STALLS else SPEED] = 0.0
        if is_stalled:
            state[WHEEL] = self.lowest = 0.0
        elif watch.kind == MEETS:
            state[WHEEL] = self.press.ratio * state[SPEED]
        self._move(self.now.time + width, state, slopes)
        if is_stalled:
            return WHEEL_STALLS
        if watch.kind == RECOVERS:
            return WHEEL_RECOVERED
        self._bring(watch.kind, ahead.sense)
        is_through = watch.kind == PASSES_WANTED and not self.wanted and self.plan.ends_when_passed
        return ALL_PASSED if is_through else None

    def _bring(self, kind: int, sense: float) -> None:
        """What an event changes. That a clutch that has met locks, or slips on, the next phase finds."""
        if kind == STANDS:
            self._note(AT_STAND)
        elif kind == LOOSENS:
            self.is_loosened = True
        elif kind == PASSES_JUMP:
            self.now = replace(self.now, piece=self.now.piece + int(sense))
        elif kind == PASSES_WANTED:
            self.wanted.pop(0)
            self._note(ANGLE_PASSED)
        elif kind == PASSES_COMMAND:
            self.now = stopping(self.now, self.press)
            self._note(COMMAND)

    def _watch_lowest(self, width: float, slopes: Array) -> None:
        begun, grown = float(self.now.state[WHEEL]), slopes[:, WHEEL]
        if begun + 2 * width * float(grown.min()) < self.lowest:
            speeds = states_within(self.now.state, slopes, width, LOOKS)[:, WHEEL]
            self.lowest = min(self.lowest, least_within(speeds))

    def _move(self, time: float, state: Array, slopes: Array) -> None:
        self.n_at_once = self.n_at_once + 1 if time <= self.now.time else 0
        self.now = replace(self.now, time=time, state=state)
        self.times.append(time)
        self.states.append(state)
        self.stepped.append(slopes)

    def _note(self, kind: int) -> None:
        if kind in (LOCKED, LOOSE):
            self.now = replace(self.now, is_locked=kind == LOCKED)
        self.events.append(PressEvent(kind, self.now))


def _reason_of(trouble: int) -> int:
    """Why no step is possible."""
    if trouble == 0:
        return STEPS_VANISH
    return LINKS_BREAK_OPEN if trouble == LINKS_DO_NOT_CLOSE else GEAR_STUCK


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
