"""The steady cycle of a machine with its motor: the speed over the crank angle with which a cycle ends as it began."""

from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics.products import product
from cranktrain.numerics.roots import bracketed_roots
from cranktrain.questions.reduction.cycle_pieces import N_NODES, CyclePieces, pieces_together, to_integrals
from cranktrain.record import record

_TRIED = np.linspace(1e-9, 1 - 1e-9, 129)
"""Places in a piece at which its largest value is looked for: beside its ends, where loads jump."""
_TO_TRIED = to_integrals(_TRIED)
_LOOKED = np.linspace(0.0, 1.0, 33)
"""Places in a piece between which its speed may pass a level."""
_TO_LOOKED = to_integrals(_LOOKED)


@record
class SpeedOverTurn:
    """Speed over a cycle that repeats itself.

    Attributes
    ----------
    mesh : CyclePieces
    base : float
        A value of ω²/2 near which the cycle runs: beside it the departures of very even running keep their figures.
        [rad²/s²]
    departure : Array, shape (piece · node,)
        ω²/2 at the nodes, less the base. [rad²/s²]
    at_start : Array, shape (piece,)
        The same where pieces begin. [rad²/s²]
    acceleration : Array, shape (piece · node,)
        [rad/s²]
    multiplier : float
        What is left after a cycle of a small departure of ω²: below 1 the running is stable.
    """

    mesh: CyclePieces
    base: float
    departure: Array
    at_start: Array
    acceleration: Array
    multiplier: float

    @property
    def speed(self) -> Array:
        """At the nodes, shape (piece · node,). [rad/s]"""
        return np.sqrt(2 * (self.base + self.departure))

    @property
    def period(self) -> float:
        """[s]"""
        return float(self.mesh.mean(1 / self.speed) * np.sum(self.mesh.width))

    def over_time(self, values: Array) -> Array:
        """Mean over the time of values at the nodes, shape (..., piece · node) → (...)."""
        slowness = 1 / self.speed
        return self.mesh.mean(values * slowness) / self.mesh.mean(slowness)

    def grown(self, integrals: Array) -> Array:
        """ω²/2 less the base at places of every piece, by `to_integrals`, shape (piece, place). [rad²/s²]"""
        return _grown(self.at_start, self.mesh.width, self.acceleration, integrals)

    def in_piece(self, piece: NDArray[np.intp], place: Array) -> Array:
        """ω²/2 less the base at a place 0…1 of a piece, shapes (n,). [rad²/s²]"""
        slopes = self.acceleration.reshape(-1, N_NODES)[piece]
        return self.at_start[piece] + self.mesh.width[piece] * np.sum(to_integrals(place) * slopes, axis=1)

    def at(self, angle: Array) -> Array:
        """Speed at any crank angles of the cycle, shape (n,). [rad/s]"""
        start, width = self.mesh.start, self.mesh.width
        along = np.mod(angle - start[0], np.sum(width)) + start[0]
        piece = np.asarray(np.searchsorted(start[1:], along, side="right"), dtype=np.intp)
        return np.sqrt(2 * (self.base + self.in_piece(piece, (along - start[piece]) / width[piece])))


class CyclesTogether(NamedTuple):
    """Cycles of designs on as many pieces each, as of `SpeedOverTurn`; every array begins with the design."""

    mesh: CyclePieces
    base: Array
    departure: Array
    at_start: Array
    acceleration: Array

    @property
    def speed(self) -> Array:
        """At the nodes, shape (design, piece · node). [rad/s]"""
        return np.sqrt(2 * (self.base + self.departure))

    def grown(self, integrals: Array) -> Array:
        """As of each, shape (design, piece, place)."""
        return _grown(self.at_start, self.mesh.width, self.acceleration, integrals)


def cycles_together(found: Sequence[SpeedOverTurn]) -> CyclesTogether:
    """Cycles on as many pieces each."""
    return CyclesTogether(
        pieces_together([one.mesh for one in found]),
        np.array([[one.base] for one in found]),
        np.stack([one.departure for one in found]),
        np.stack([one.at_start for one in found]),
        np.stack([one.acceleration for one in found]),
    )


def _grown(at_start: Array, width: Array, acceleration: Array, integrals: Array) -> Array:
    """ω²/2 less the base at places of every piece, shape (..., piece, place). [rad²/s²]"""
    slopes = acceleration.reshape(*width.shape, N_NODES)
    return at_start[..., np.newaxis] + width[..., np.newaxis] * product(slopes, integrals.T)


def largest_over_turn(found: SpeedOverTurn, curve: Callable[[Array, Array], Array]) -> float:
    """Largest value over a cycle of what is smooth between the ends of its pieces, and may jump there.

    Parameters
    ----------
    found : SpeedOverTurn
    curve : callable
        From crank angles and the speeds there, shape (n,), to values. [rad, rad/s]

    Returns
    -------
    float
        NaN where it stands still between two nodes.
    """
    with np.errstate(invalid="ignore"):
        speed = np.sqrt(2 * (found.base + found.grown(_TO_TRIED)))
    return _top(curve(found.mesh.at(_TRIED), np.ravel(speed)).reshape(speed.shape))


def _top(values: Array) -> float:
    """Largest value of smooth pieces, by a parabola through the largest sample and those beside it."""
    row, place = np.unravel_index(np.argmax(values), values.shape)
    if not 0 < place < values.shape[1] - 1:
        return float(values[row, place])
    before, here, behind = values[row, place - 1 : place + 2].tolist()
    bend = before - 2 * here + behind
    return here - (behind - before) ** 2 / (8 * bend) if bend < 0 else here


def speed_range(found: SpeedOverTurn) -> float:
    """Largest speed over a cycle less the smallest; NaN where it stands still between two nodes. [rad/s]"""
    departure, base = found.grown(_TO_TRIED), np.sqrt(2 * found.base)
    with np.errstate(invalid="ignore"):
        beyond = 2 * departure / (base + np.sqrt(2 * (found.base + departure)))
    return _top(beyond) + _top(-beyond)


def passings(found: Sequence[SpeedOverTurn], levels: Sequence[Array]) -> Iterator[Array]:
    """Crank angles at which ω²/2 passes any of some levels, to rounding, in their order, of each design.

    Parameters
    ----------
    found : sequence of SpeedOverTurn
        On as many pieces each.
    levels : sequence of Array, shape (n,)
        [rad²/s²]

    Yields
    ------
    Array, shape (k,)
        [rad]
    """
    cycles = cycles_together(found)
    curves = cycles.base[..., np.newaxis] + cycles.grown(_TO_LOOKED)
    least, most = np.min(curves, axis=(1, 2)).tolist(), np.max(curves, axis=(1, 2)).tolist()
    for one, curve, low, high, of_one in zip(found, curves, least, most, levels, strict=True):
        own = [level for level in of_one.tolist() if low < level < high]
        each = [_passings(one, curve - level, level) for level in own]
        yield np.sort(np.concatenate(each)) if each else np.empty(0)


def _passings(found: SpeedOverTurn, over: Array, level: float) -> Array:
    """Crank angles at which one level is passed: inside pieces, and between two of them."""
    start, width = found.mesh.start, found.mesh.width
    is_over = over > 0
    row, place = np.nonzero(is_over[:, :-1] != is_over[:, 1:])
    low, high = _LOOKED[place], _LOOKED[place + 1]
    touched, left, middle, right = _touches(over)
    row = np.concatenate([row, touched, touched])
    low, high = np.concatenate([low, left, middle]), np.concatenate([high, middle, right])
    at = bracketed_roots(lambda where: found.base + found.in_piece(row, where) - level, low, high)
    between = start[is_over[:, 0] != np.roll(is_over[:, -1], 1)]
    inside = start[row] + width[row] * at
    return np.concatenate([inside[np.isfinite(inside)], between])


def _touches(over: Array) -> tuple[NDArray[np.intp], Array, Array, Array]:
    """Pieces in which a curve comes back between two samples, and the places before, at and after its top there."""
    before, here, after = over[:, :-2], over[:, 1:-1], over[:, 2:]
    bend = before - 2 * here + after
    with np.errstate(divide="ignore", invalid="ignore"):
        aside = 0.5 * (before - after) / bend
        top = here - (after - before) ** 2 / (8 * bend)
    is_alike = (before > 0) == (here > 0), (after > 0) == (here > 0)
    row, place = np.nonzero(is_alike[0] & is_alike[1] & (np.abs(aside) < 1) & ((top > 0) != (here > 0)))
    apart = _LOOKED[1]
    return row, _LOOKED[place], _LOOKED[place + 1] + aside[row, place] * apart, _LOOKED[place + 2]
