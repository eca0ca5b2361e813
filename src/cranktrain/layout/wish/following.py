"""A crank that makes a wanted motion: where it is at a time, how fast at an angle; or it swings between two angles."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.layout.wish.stroke import DeadCentre, Output
from cranktrain.layout.wish.turning import (
    Root,
    TurnOfWish,
    away_at,
    leading_away,
    mirrored,
    of_series,
    root_of_distance,
)
from cranktrain.layout.wish.wanted import Piece, WantedMotion, moved, position
from cranktrain.motion import Array
from cranktrain.numerics import bracketed_roots
from cranktrain.numerics.harmonics import TURN

_BLURRED = 1e-11
"""Of the stroke: so near a dead centre a difference of positions is mostly rounding, and a turning's series is not."""


class CrankMotion(NamedTuple):
    """How a crank moves, each of shape (n,): [s, rad, rad/s, rad/s²]."""

    time: Array
    angle: Array
    speed: Array
    acceleration: Array


class End(NamedTuple):
    """Where a stroke leaves a dead centre (side 1) or comes to one (side −1), by angle and by time.

    Both turnings count away from there, into the stroke.
    """

    side: float
    angle: float
    time: float
    of_angle: TurnOfWish
    of_time: TurnOfWish


class Stroke(NamedTuple):
    """A way from one dead centre to the other."""

    begin: End
    end: End


class Following(NamedTuple):
    """A wanted motion that an output can make.

    Attributes
    ----------
    output : Output
    wanted : WantedMotion
        Scaled to the stroke.
    strokes : tuple of Stroke
        From the high dead centre to the low one, and back: angles and times go on rising.
    """

    output: Output
    wanted: WantedMotion
    strokes: tuple[Stroke, Stroke]

    @property
    def dwells(self) -> tuple[tuple[float, float], ...]:
        """Crank angle and duration of every rest. [rad, s]"""
        found: list[tuple[float, float]] = []
        for piece in self.wanted.pieces:
            if piece.law is None:
                at = crank_at(self, np.array([piece.start + 0.5 * piece.span])).angle
                found.append((float(np.mod(at[0], TURN)), piece.span))
        return tuple(found)


def corners(made: Following) -> Array:
    """Crank angles where one piece goes over into another, and ε may jump, shape (corner,). [rad]"""
    times = np.array([piece.start for piece in made.wanted.pieces])
    return np.unique(np.mod(crank_at(made, times).angle, TURN))


def following(output: Output, wanted: WantedMotion, high: tuple[int, int], low: tuple[int, int]) -> Following:
    """Put a wanted motion to an output.

    Parameters
    ----------
    output : Output
    wanted : WantedMotion
        That has its extremes where the output has its dead centres.
    high, low : tuple of int
        Pieces by which it comes to its highest and to its lowest position, and by which it leaves them.
    """
    down = _stroke(wanted, (output.high, output.low), high[1], low[0], late=0.0)
    turned = down.end.angle
    back = DeadCentre(down.begin.angle + TURN, output.high.position, output.high.turning)
    up = _stroke(wanted, (output.low._replace(angle=turned), back), low[1], high[0], late=down.end.time)
    return Following(output, wanted, (down, up))


def _stroke(wanted: WantedMotion, ways: tuple[DeadCentre, DeadCentre], first: int, last: int, *, late: float) -> Stroke:
    """A stroke by the pieces with which it begins and ends, after a time."""
    leaving, coming = wanted.pieces[first], wanted.pieces[last]
    start = _after(leaving.start, late, wanted.period)
    end = _after(coming.start + coming.span, start, wanted.period)
    begin_angle = ways[0].angle
    end_angle = begin_angle + float(np.mod(ways[1].angle - begin_angle, TURN))
    return Stroke(
        End(1.0, begin_angle, start, ways[0].turning, _of_piece(leaving, at_end=False)),
        End(-1.0, end_angle, end, mirrored(ways[1].turning), _of_piece(coming, at_end=True)),
    )


def _after(time: float, other: float, period: float) -> float:
    """A time of the period that is not before another."""
    late = float(np.mod(time - other, period))
    return other + (0.0 if period - late < 1e-12 * period else late)


def _of_piece(piece: Piece, *, at_end: bool) -> TurnOfWish:
    if piece.law is None:
        raise AssertionError
    return of_series(piece.law.end if at_end else piece.law.start, piece.rise, piece.span, piece.law.reach)


def crank_at(made: Following, time: Array) -> CrankMotion:
    """Where the crank is at times, shape (n,), and how it moves.

    Notes
    -----
    Away from the dead centres φ by x(φ) = x(t), ω = ẋ/x′, ε = (ẍ − x″ω²)/x′; about them by the roots of the distances.
    docs/theory/servo, eqs. (29.3) to (29.6).
    """
    down, up = made.strokes
    turns = np.floor((time - down.begin.time) / made.wanted.period)
    own = time - turns * made.wanted.period
    found = np.empty((3, *time.shape))
    for stroke, until in ((down, up.begin), (up, None)):
        ends = np.inf if until is None else until.time
        chosen = (own >= stroke.begin.time) & (own < ends) if stroke is down else own >= stroke.begin.time
        found[:, chosen] = _by_time(made, stroke, own[chosen])
    return CrankMotion(time, found[0] + turns * TURN, found[1], found[2])


def _by_time(made: Following, stroke: Stroke, time: Array) -> Array:
    """Angle, speed and acceleration at times within a stroke, or in the rest after it."""
    inner = np.clip(time, stroke.begin.time, stroke.end.time)
    whole = moved(made.wanted, inner)
    low, high = (np.full(inner.shape, end.angle) for end in stroke)
    low, high = low + 1e-9, high - 1e-9
    angle = bracketed_roots(lambda phi: made.output.motion(phi).value - whole.value, low, high)
    found = np.stack([angle, *_away(made, angle, whole.first, whole.second)])
    for end in stroke:
        away = end.side * (inner - end.time)
        blurred = _is_blurred(made, end, whole.value)
        of_time = root_of_distance(end.of_time, np.clip(away, 0.0, np.where(blurred, np.inf, end.of_time.reach)))
        turned = away_at(end.of_angle, of_time.value)
        near = ((away <= end.of_time.reach) | blurred) & (turned <= end.of_angle.reach)
        about = np.stack([end.angle + end.side * turned, *_about(end, of_time, turned)])
        found = np.where(near, about, found)
    found[1:, time > stroke.end.time] = 0.0
    return found


def _is_blurred(made: Following, end: End, position: Array) -> NDArray[np.bool_]:
    """Whether positions are those of a dead centre, but for little more than rounding.

    A table may turn round so shortly before or after one of its points that the turning's own piece ends there.
    """
    centre = made.output.motion(np.array([end.angle])).value
    return np.abs(position - centre) <= _BLURRED * made.output.stroke


def _away(made: Following, angle: Array, first: Array, second: Array) -> tuple[Array, Array]:
    """Speed and acceleration away from dead centres."""
    place = made.output.motion(angle)
    with np.errstate(divide="ignore", invalid="ignore"):
        speed = first / place.first
        return speed, (second - place.second * speed**2) / place.first


def _about(end: End, of_time: Root, turned: Array) -> tuple[Array, Array]:
    """Speed and acceleration about a dead centre, |δ| from it."""
    of_angle = root_of_distance(end.of_angle, np.clip(turned, 0.0, end.of_angle.reach))
    speed = of_time.first / of_angle.first
    return speed, end.side * (of_time.second - of_angle.second * speed**2) / of_angle.first


def crank_by_angle(made: Following, angle: Array) -> CrankMotion:
    """When the crank is at angles, shape (n,), and how it moves there; where it rests, as it comes to rest.

    Notes
    -----
    docs/theory/servo, eqs. (29.3) to (29.6).
    """
    down, up = made.strokes
    turns = np.floor((angle - down.begin.angle) / TURN)
    own = angle - turns * TURN
    is_down: NDArray[np.bool_] = own < up.begin.angle
    found = np.empty((3, *angle.shape))
    for stroke, chosen in ((down, is_down), (up, ~is_down)):
        found[:, chosen] = _by_angle(made, stroke, own[chosen])
    return CrankMotion(found[0] + turns * made.wanted.period, angle, found[1], found[2])


def _by_angle(made: Following, stroke: Stroke, angle: Array) -> Array:
    """Time, speed and acceleration at angles within a stroke."""
    place = made.output.motion(angle)
    low, high = (np.full(angle.shape, end.time) for end in stroke)
    time = bracketed_roots(lambda at: position(made.wanted, at) - place.value, low, high)
    whole = moved(made.wanted, np.where(np.isfinite(time), time, low))
    found = np.stack([time, *_away(made, angle, whole.first, whole.second)])
    for end in stroke:
        turned = end.side * (angle - end.angle)
        root = root_of_distance(end.of_angle, np.clip(turned, 0.0, end.of_angle.reach))
        away = away_at(end.of_time, root.value)
        near = (turned <= end.of_angle.reach) & (away <= end.of_time.reach)
        # Beyond a short reach the leading power says it all, as near as that.
        blurred = _is_blurred(made, end, place.value) & ~near
        away = np.where(blurred, leading_away(end.of_time, root.value), np.minimum(away, end.of_time.reach))
        near |= blurred
        of_time = root_of_distance(end.of_time, away)
        about = np.stack([end.time + end.side * away, *_about(end, of_time, turned)])
        found = np.where(near, about, found)
    return found


class Rocking(NamedTuple):
    """A wanted motion within the stroke of an output, on the half turn behind its high dead centre."""

    output: Output
    wanted: WantedMotion


def rocking_crank(made: Rocking, time: Array) -> CrankMotion:
    """Where a rocking crank is at times, shape (n,), and how it moves; its speed changes sign.

    Notes
    -----
    ω = ẋ/x′, ε = (ẍ − x″ω²)/x′, with x′ never 0. docs/theory/servo, eq. (29.3).
    """
    whole = moved(made.wanted, time)
    low = made.output.high.angle
    high = low + np.mod(made.output.low.angle - low, TURN)
    ends = (np.full(time.shape, end) for end in (low, high))
    angle = bracketed_roots(lambda phi: made.output.motion(phi).value - whole.value, *ends)
    place = made.output.motion(angle)
    speed = whole.first / place.first
    return CrankMotion(time, angle, speed, (whole.second - place.second * speed**2) / place.first)
