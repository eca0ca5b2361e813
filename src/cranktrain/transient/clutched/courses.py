"""How far a clutch or brake is pressed on over time: in straight pieces, by commands."""

import math
from typing import NamedTuple

from cranktrain.record import record


class Grip(NamedTuple):
    """A clutch or a brake.

    Attributes
    ----------
    torque, static_torque : float
        While its sides slip, and up to which it holds them together, pressed on fully. [N·m]
    delay, rise_time : float
        From the command until the torque begins, and from there to the full one, in a line. [s]
    release_delay, fall_time : float
        The same of letting go. [s]
    """

    torque: float
    static_torque: float
    delay: float = 0.0
    rise_time: float = 0.0
    release_delay: float = 0.0
    fall_time: float = 0.0


@record
class GripCourse:
    """How far it is pressed on, from 0 to 1, as corners joined by lines; two at one time are a jump.

    Attributes
    ----------
    times : tuple of float, ascending
        [s]
    levels : tuple of float
        [1]
    """

    times: tuple[float, ...]
    levels: tuple[float, ...]


@record
class CoursePiece:
    """A piece from a time on: level there and slope, until a time. [1, 1/s, s]"""

    level: float
    slope: float
    end: float


RELEASED = GripCourse((0.0,), (0.0,))
PRESSED = GripCourse((0.0,), (1.0,))


def piece_from(course: GripCourse, time: float) -> CoursePiece:
    """Piece that begins at a time, or in which it lies: of a jump what is behind it.

    Examples
    --------
    >>> piece_from(commanded(RELEASED, Grip(900.0, 900.0, 0.125, 0.25), 0.0, is_on=True), 0.25)
    CoursePiece(level=0.5, slope=4.0, end=0.375)
    """
    times, levels = course.times, course.levels
    behind = next((index for index, corner in enumerate(times) if corner > time), len(times))
    if behind == 0:
        return CoursePiece(levels[0], 0.0, times[0])
    if behind == len(times):
        return CoursePiece(levels[-1], 0.0, math.inf)
    slope = (levels[behind] - levels[behind - 1]) / (times[behind] - times[behind - 1])
    return CoursePiece(levels[behind - 1] + slope * (time - times[behind - 1]), slope, times[behind])


def commanded(course: GripCourse, grip: Grip, time: float, *, is_on: bool) -> GripCourse:
    """Course with a command at a time, to press on or to let go: until its delay is over it goes on as before.

    From there the level goes from what it is to 1 or 0 with the slope of the rise or fall.
    docs/theory/clutched-drive, eq. (30.3).
    """
    delay, span, aim = (grip.delay, grip.rise_time, 1.0) if is_on else (grip.release_delay, grip.fall_time, 0.0)
    begin = time + delay
    kept = [(at, level) for at, level in zip(course.times, course.levels, strict=True) if at <= begin]
    level = piece_from(course, begin).level
    corners = [*kept, (begin, level), (begin + span * abs(aim - level), aim)]
    return GripCourse(tuple(at for at, _ in corners), tuple(level for _, level in corners))
