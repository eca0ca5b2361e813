"""Laws of loads: how large one is by the speed, the crank angle or the travel of its point, of all designs."""

from typing import NamedTuple, TypeAlias

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics.harmonics import TURN
from cranktrain.numerics.polyline import Polyline, polyline_value

_SAME = 1e-9
"""Angles closer than this are one. [rad]"""


class LoadState(NamedTuple):
    """What a law may ask for, arrays of shape (design, 1, n).

    Attributes
    ----------
    shown : Array
        Crank angle as it is shown. [rad]
    travel : Array
        Of the load's point or link from where it is least. [m or rad]
    speed : Array
        Of that, less than 0 on the way back. [m/s or rad/s]
    """

    shown: Array
    travel: Array
    speed: Array


class BySpeed(NamedTuple):
    """A size at a speed, which goes with a power of it; the power 0 is a constant. Shape (design, 1, 1)."""

    size: Array
    at: Array
    exponent: Array

    def value(self, state: LoadState) -> Array:
        """Size, shape (design, 1, n)."""
        return self.size * (np.abs(state.speed) / self.at) ** self.exponent


class ByAngle(NamedTuple):
    """Straight lines from crank angle to crank angle as it is shown, round a turn or two. Shape (design, point)."""

    angles: Array
    values: Array

    @property
    def polylines(self) -> tuple[Polyline, ...]:
        """The lines of each design."""
        return tuple(_round(*rows) for rows in zip(self.angles, self.values, strict=True))

    def value(self, state: LoadState) -> Array:
        """Size, shape (design, 1, n)."""
        shown = np.broadcast_to(state.shown, state.speed.shape)
        return np.stack([polyline_value(*rows) for rows in zip(self.polylines, shown, strict=True)])

    def kinks(self, cycle: float) -> Array:
        """Crank angles as they are shown at which it may have kinks within a cycle, shape (design, kink). [rad]"""
        turns = np.arange(0.0, cycle - TURN / 2, TURN)
        return (self.angles[:, np.newaxis] + turns[:, np.newaxis]).reshape(len(self.angles), -1)

    def misses(self, cycle: float) -> Array:
        """By how much the lines may miss a smooth curve at each of these, in parts of the largest size."""
        return np.stack([_at_kinks(*rows) for rows in zip(self.polylines, self.kinks(cycle), strict=True)])


class ByTravel(NamedTuple):
    """Straight lines over the travel from where it is least, on the way out and on the way back.

    Shape (design, point).
    """

    places: Array
    out: Array
    back: Array

    def value(self, state: LoadState) -> Array:
        """Size, shape (design, 1, n)."""
        rows = zip(state.travel, self.places, self.out, self.back, strict=True)
        ways = [(_between(s, places, out), _between(s, places, back)) for s, places, out, back in rows]
        return np.where(state.speed >= 0, np.stack([out for out, _ in ways]), np.stack([back for _, back in ways]))

    @property
    def most(self) -> float:
        """Largest size of all."""
        return float(np.max(np.abs(np.concatenate([self.out, self.back], axis=-1))))

    @property
    def misses(self) -> Array:
        """By how much the lines may miss a smooth curve at each place, in parts of the largest size, on either way."""
        ends = ((0, 0), (1, 1))
        at = np.pad(self.places, ends, mode="reflect", reflect_type="odd")
        return np.maximum(*(_misses(at, np.pad(size, ends, mode="edge")) for size in (self.out, self.back)))


def _between(at: Array, places: Array, values: Array) -> Array:
    """Straight lines from place to place; beyond the ends the last value."""
    return np.asarray(np.interp(at, places, values), dtype=np.float64)


def _misses(at: Array, values: Array) -> Array:
    """By how much lines may miss a smooth curve through their points, at all but the first and the last of these.

    A smooth curve bends away from its chord of the length h by h²/8 times its second derivative, which is the lines'
    change of slope over h. In parts of the largest value; without any, 0.
    """
    bend = np.diff(np.diff(values) / np.diff(at))
    largest = np.max(np.abs(values), axis=-1, keepdims=True)
    misses = np.abs(bend) * (at[..., 2:] - at[..., :-2]) / 16
    return np.divide(misses, largest, out=np.zeros_like(misses), where=largest > 0)


def _at_kinks(curve: Polyline, kinks: Array) -> Array:
    """Misses of lines round a period at angles as they are shown; infinite where no point of theirs lies."""
    angles, values, period = curve
    around = np.concatenate([angles[-1:] - period, angles, angles[:1] + period])
    misses = _misses(around, np.concatenate([values[-1:], values, values[:1]]))
    turned = np.mod(kinks + _SAME, period) - _SAME
    at = np.minimum(np.searchsorted(angles, turned), angles.size - 1)
    return np.where(np.abs(angles[at] - turned) <= _SAME, misses[at], np.inf)


def is_over_two_turns(first: float, last: float) -> bool:
    """Whether rising crank angles reach farther than a turn: then they go round two. [rad]"""
    return last - first > TURN + _SAME


def _round(angles: Array, values: Array) -> Polyline:
    """Lines round a turn or two, in whose last angle the first one may stand again."""
    period = 2 * TURN if is_over_two_turns(float(angles[0]), float(angles[-1])) else TURN
    turned, kept = np.unique(np.mod(angles + _SAME, period) - _SAME, return_index=True)
    is_new = np.diff(turned, append=np.inf) > _SAME
    return Polyline(turned[is_new], values[kept][is_new], period)


Law: TypeAlias = BySpeed | ByAngle | ByTravel
