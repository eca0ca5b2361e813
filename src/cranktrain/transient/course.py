"""Where a run stands: all that its next step depends on, in arrays, or in lists for a run that is not compiled."""

from typing import Any, NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.transient.step import N_STATE, ROW

TIME, SENSE, WIDTH, OUTPUT, FASTEST, BOUND, INERTIA_BEFORE, INERTIA_AFTER = range(8)
"""Places in `Course.here`: time; sense of the motion, 0 at rest; width of the next step, 0 where nothing is known of
it; x′ of what is driven when it last was not 0; greatest speed; crank angle beyond which nothing may be looked at; the
machine's inertia at the start of the run and where it stands."""
STEPS, MARKS, REVERSALS, SAMPLE, BREAK, IS_FRESH, ENDS = range(7)
"""Places in `Course.counts`: of steps, events and reversals; next sample and break; whether a phase is to begin; how
many ends of steps were written down in the last call."""


class Course(NamedTuple):
    """Where a run stands, and what its steps are computed in.

    Attributes
    ----------
    here : Array, shape (8,)
    counts : Array, shape (7,)
    state, ahead, trial : Array, shape (6,)
        At the beginning of a step, at its end, and at an event within.
    slopes, again : Array, shape (7 · 7,)
        Of the stages of a step, row after row with x′ of what is driven at its end, and of one that was shortened to an
        event.
    """

    here: Any
    counts: Any
    state: Any
    ahead: Any
    trial: Any
    slopes: Any
    again: Any


def course_from(start: Array, is_compiled: bool) -> Course:
    """A run that is to begin."""
    course = room_for_a_course()
    put_at_start(course, start)
    return course if is_compiled else Course(*(each.tolist() for each in course))


def room_for_a_course() -> Course:
    """Arrays in which a run stands."""
    state, ahead, trial = np.zeros((3, N_STATE))
    slopes, again = np.zeros((2, 7 * ROW))
    return Course(np.zeros(8), np.zeros(7, dtype=np.int64), state, ahead, trial, slopes, again)


def put_at_start(course: Any, start: Any) -> None:
    """Let a run begin in a state."""
    for place in range(len(course.here)):
        course.here[place] = 0.0
    for place in range(len(course.counts)):
        course.counts[place] = 0
    for part in range(N_STATE):
        course.state[part] = start[part]
    course.here[SENSE] = 1.0 if start[1] > 0 else -1.0 if start[1] < 0 else 0.0
    course.here[FASTEST] = abs(start[1])
    course.counts[IS_FRESH] = 1


def copied(course: Course) -> Course:
    """The same, which further steps leave as it is."""
    return Course(*(each.copy() for each in course))


def go_ahead(course: Any, time: float, ahead: Any) -> None:
    """Put a run at a later time into a state."""
    course.here[TIME] = time
    for part in range(N_STATE):
        course.state[part] = ahead[part]
    course.here[FASTEST] = max(course.here[FASTEST], abs(ahead[1]))


def note(course: Any, marks: Any, kind: int, time: float, angle: float, speed: float) -> None:
    """Write down an event where there is room."""
    row = course.counts[MARKS]
    if row < len(marks):
        marks[row, 0] = kind
        marks[row, 1] = time
        marks[row, 2] = angle
        marks[row, 3] = speed
        course.counts[MARKS] = row + 1
