"""A run of a press from a moment to its end: steps, and the events between which all is smooth."""

import math
from bisect import bisect_right
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.record import record
from cranktrain.transient.clutched.courses import PRESSED, RELEASED, GripCourse
from cranktrain.transient.clutched.equation import ANGLE, N_PRESS_STATE, SPEED, WHEEL, Press, kinetic_energy
from cranktrain.transient.clutched.step import INTERPOLANT
from cranktrain.transient.equation import Kernels
from cranktrain.transient.runs import TOO_FAST

(
    RESTS, WHEEL_STALLS, SLIPS_ON, SLIDES, NOTHING_MOVES, WHEEL_RECOVERED, TIME_IS_OVER, STEPS_EXHAUSTED,
    LINKS_BREAK_OPEN, GEAR_STUCK, ALL_PASSED, STEPS_VANISH,
) = range(12)  # fmt: skip
"""Why a run of a press ended."""
PRESS_REASONS = {
    RESTS: N_("the crank rests, held by the brake or by the load itself"),
    WHEEL_STALLS: N_("the load brings the flywheel to a stand: neither it nor the motor is enough"),
    SLIPS_ON: N_("the clutch is too weak: it slips on for ever"),
    SLIDES: N_("the brake is too weak to stop the crank or to hold it: it slides"),
    NOTHING_MOVES: N_("the crank is held from the start, and nothing pulls any more"),
    WHEEL_RECOVERED: N_("the flywheel has its speed again"),
    TIME_IS_OVER: N_("the time asked for is over"),
    STEPS_EXHAUSTED: N_("it takes more steps than allowed"),
    STEPS_VANISH: TOO_FAST,
    LINKS_BREAK_OPEN: N_("the links do not close"),
    ALL_PASSED: N_("it has passed all angles that are asked for"),
    GEAR_STUCK: N_(
        "the gear jams: it cannot be driven back (as below an efficiency of 50 %), and no one acceleration fits its"
        " losses; a better efficiency, or more inertia before the gear, helps"
    ),
}
"""Sentences, not yet translated."""

COMMAND, LOCKED, LOOSE, AT_STAND, OFF, ANGLE_PASSED = range(6)
"""What happens on the way: the command to stop, the clutch locks, breaks loose, the crank comes to rest, sets off."""


@record
class Moment:
    """A press at an instant, from which a run can go on.

    Attributes
    ----------
    time : float
        [s]
    state : Array, shape (9,)
        As `equation` names its components.
    is_locked : bool
    clutch, brake : GripCourse
        With the commands given so far.
    piece : int
        Which part between two angles at which the load jumps the crank is in, counted on through all turns.
    is_stopping : bool
        Whether the command to stop was given.
    """

    time: float
    state: Array
    is_locked: bool
    clutch: GripCourse
    brake: GripCourse
    piece: int
    is_stopping: bool


class PressPlan(NamedTuple):
    """What is asked of a run.

    Attributes
    ----------
    end_time : float
        [s]
    command_angle : float
        Crank angle at which the clutch is let go and the brake put on; infinite for never. [rad]
    jumps : tuple of float, ascending from 0 up to below 2π
        Crank angles at which the load has a jump or a kink. [rad]
    passed : tuple of float, ascending
        Crank angles of which the moment is wanted. [rad]
    wheel_speed : float
        At which a crank at rest waits no longer for the flywheel; infinite where nobody asks. [rad/s]
    ends_at_rest : bool
    ends_when_passed : bool
        With the last of these angles.
    tolerance : float
        Error of a step, of the angle in rad and of the speeds in parts of the flywheel's at the start.
    most_steps : int
    """

    end_time: float
    command_angle: float = math.inf
    jumps: tuple[float, ...] = ()
    passed: tuple[float, ...] = ()
    wheel_speed: float = math.inf
    ends_at_rest: bool = True
    ends_when_passed: bool = False
    tolerance: float = 1e-10
    most_steps: int = 100_000


@record
class PressEvent:
    """Something on the way, one of `COMMAND`, …, with the moment just behind it."""

    kind: int
    moment: Moment


@record
class PressRun:
    """What became of a run.

    Attributes
    ----------
    reason : int
        A key of `PRESS_REASONS`.
    start, end : Moment
    events : tuple of PressEvent
        In the order of their times.
    times : Array, shape (n,)
        Of all steps. [s]
    states : Array, shape (n, 9)
    slopes : tuple of Array, shape (7, 9)
        Of the stages of each step, by which there are states within it; an event at the end of a step has one row.
    lowest_speed : float
        Of the flywheel. [rad/s]
    residual, supplied : float
        Kinetic energy less what was given and taken, and the work by which to judge it. [J]
        docs/theory/clutched-drive, eq. (30.9).
    n_steps : int
    """

    reason: int
    start: Moment
    end: Moment
    events: tuple[PressEvent, ...]
    times: Array
    states: Array
    slopes: tuple[Array, ...]
    lowest_speed: float
    residual: float
    supplied: float
    n_steps: int

    def of_kind(self, kind: int) -> tuple[PressEvent, ...]:
        """Events of one kind."""
        return tuple(event for event in self.events if event.kind == kind)

    def at(self, times: Array) -> Array:
        """States at times of the run, shape (n, 9), by the interpolant of each step."""
        steps = np.clip(np.searchsorted(self.times, times, side="right") - 1, 0, len(self.slopes) - 1)
        return np.array([self._within(step, time) for step, time in zip(steps, times, strict=True)]).reshape(
            len(times), N_PRESS_STATE
        )

    def _within(self, step: int, time: float) -> Array:
        """State within a step."""
        begun, width = self.times[step], self.times[step + 1] - self.times[step]
        if not width > 0:
            return self.states[step]
        part = (time - begun) / width
        return self.states[step] + width * (part ** np.arange(1, 5) @ INTERPOLANT.T @ self.slopes[step])


def piece_of(angle: float, jumps: tuple[float, ...]) -> int:
    """Count the part between two angles of jumps in which a crank angle lies."""
    if not jumps:
        return 0
    turns, rest = divmod(angle, 2 * math.pi)
    return int(turns) * len(jumps) + bisect_right(jumps, rest) - 1


def piece_ends(piece: int, jumps: tuple[float, ...]) -> tuple[float, float]:
    """Crank angles between which a part lies. [rad]"""
    if not jumps:
        return -math.inf, math.inf
    low, high = (divmod(index, len(jumps)) for index in (piece, piece + 1))
    return tuple(jumps[at] + 2 * math.pi * turns for turns, at in (low, high))  # pyright: ignore[reportReturnType]


def at_rest(wheel_speed: float, angle: float, jumps: tuple[float, ...] = ()) -> Moment:
    """Press with a turning flywheel and a crank at rest, the clutch let go and the brake on."""
    state = np.zeros(N_PRESS_STATE)
    state[WHEEL], state[ANGLE] = wheel_speed, angle
    return Moment(0.0, state, False, RELEASED, PRESSED, piece_of(angle, jumps), False)


def turning(press: Press, crank_speed: float, angle: float, jumps: tuple[float, ...] = ()) -> Moment:
    """Press that runs on with its clutch locked and its brake let go."""
    begun = at_rest(press.ratio * crank_speed, angle, jumps)
    begun.state[SPEED] = crank_speed
    return replace(begun, is_locked=True, clutch=PRESSED, brake=RELEASED)


def account(kernels: Kernels, press: Press, before: Array, after: Array) -> tuple[float, float]:
    """Residual of the energy between two states, and the work by which to judge it. [J]"""
    kinetic = [kinetic_energy(kernels, press, state) for state in (before, after)]
    work = after[3:8] - before[3:8]
    return float(kinetic[1] - kinetic[0] - work[0] + work[1:].sum()), float(max(*kinetic, np.abs(work).sum()))
