"""A wanted motion over its period: pieces one after another, each with its law."""

import itertools
from typing import NamedTuple

import numpy as np
from numpy.polynomial import Polynomial
from numpy.typing import NDArray

from cranktrain.layout.wish.laws import Law, Moved, polynomial_law
from cranktrain.motion import Array
from cranktrain.numerics.spline import periodic_powers


class Piece(NamedTuple):
    """A part of a wanted motion: from one position to another in a time; without a law it stands.

    Attributes
    ----------
    start, span : float
        [s]
    begin, rise : float
        Where it begins, and by how much it goes on. [m or rad]
    law : Law or None
    number : int
        Which one of the file's it is, from 0.
    """

    start: float
    span: float
    begin: float
    rise: float
    law: Law | None
    number: int = 0

    @property
    def speeds(self) -> tuple[float, float]:
        """With which it begins and ends. [m/s or rad/s]"""
        if self.law is None:
            return 0.0, 0.0
        scale = self.rise / self.span
        return float(self.law.start[1]) * scale, float(self.law.end[1]) * scale


class WantedMotion(NamedTuple):
    """Position of what the crank drives over time, with a period.

    Attributes
    ----------
    pieces : tuple of Piece
        One after another, from time 0.
    period : float
        [s]
    zero : float
        What the file's clock shows then. [s]
    cubics : Array, shape (4, piece), or None
        Of a table, what all its pieces are by powers of the time from their starts.
    """

    pieces: tuple[Piece, ...]
    period: float
    zero: float = 0.0
    cubics: Array | None = None

    def scaled(self, factor: float, shift: float) -> "WantedMotion":
        """The motion with all positions times a factor, and a shift."""
        pieces = (one._replace(begin=factor * one.begin + shift, rise=factor * one.rise) for one in self.pieces)
        cubics = None if self.cubics is None else self.cubics * factor + shift * np.eye(4)[:, :1]
        return self._replace(pieces=tuple(pieces), cubics=cubics)


def moved(wanted: WantedMotion, time: Array) -> Moved:
    """Position of a wanted motion and its first three derivatives at times, shape (n,). [m or rad, …/s, …/s², …/s³]"""
    place, since = _pieces_at(wanted, time)
    if wanted.cubics is not None:
        return _of_cubics(wanted.cubics[:, place], since)
    found = np.zeros((4, *np.shape(time)))
    for n, piece in enumerate(wanted.pieces):
        own = place == n
        if np.any(own):
            found[:, own] = in_piece(piece, since[own])
    return Moved(found[0], found[1], found[2], found[3])


def position(wanted: WantedMotion, time: Array) -> Array:
    """Position of a wanted motion alone, as `moved` has it: what looks for a time asks for nothing else. [m or rad]"""
    place, since = _pieces_at(wanted, time)
    if wanted.cubics is not None:
        return _of_cubics(wanted.cubics[:, place], since).value
    found = np.zeros(np.shape(time))
    for n, piece in enumerate(wanted.pieces):
        own = place == n
        if np.any(own):
            way = 0.0 if piece.law is None else piece.law.way(since[own] / piece.span)
            found[own] = piece.begin + piece.rise * way
    return found


def _pieces_at(wanted: WantedMotion, time: Array) -> tuple[NDArray[np.intp], Array]:
    """Which piece times are in, and how long it has lasted then. [s]"""
    within = np.mod(time, wanted.period)
    starts: Array = np.array([piece.start for piece in wanted.pieces])
    after = np.searchsorted(starts, within, side="right")
    place: NDArray[np.intp] = np.clip(after - 1, 0, len(starts) - 1)
    return place, within - starts[place]


def _of_cubics(powers: Array, x: Array) -> Moved:
    """Values and derivatives of cubics, each at its own time."""
    a, b, c, d = powers
    value = a + x * (b + x * (c + x * d))
    return Moved(value, b + x * (2 * c + 3 * x * d), 2 * c + 6 * x * d, 6 * d)


def in_piece(piece: Piece, time: Array) -> Moved:
    """Position and derivatives within a piece, at times from its start."""
    if piece.law is None:
        still = np.zeros_like(time)
        return Moved(still + piece.begin, still, still, still)
    whole, rise, span = piece.law.shape(time / piece.span), piece.rise, piece.span
    return Moved(
        piece.begin + rise * whole.value,
        rise / span * whole.first,
        rise / span**2 * whole.second,
        rise / span**3 * whole.third,
    )


def from_pieces(pieces: tuple[Piece, ...]) -> WantedMotion:
    """Put pieces one after another; what stands several times in a row stands once."""
    found: list[Piece] = []
    for piece in pieces:
        if found and piece.law is None and found[-1].law is None:
            found[-1] = found[-1]._replace(span=found[-1].span + piece.span)
        else:
            found.append(piece)
    return WantedMotion(tuple(found), found[-1].start + found[-1].span)


def through_positions(times: Array, positions: Array, period: float) -> WantedMotion:
    """Lay the periodic cubic spline through positions, cut where it turns round.

    Parameters
    ----------
    times, positions : Array, shape (n,)
        Rising within one period; at least three. [s; m or rad]
    period : float
        [s]
    """
    spans = np.diff(times, append=times[0] + period)
    pieces: list[Piece] = []
    rows = zip(times, spans, periodic_powers(times, positions, period).T, strict=True)
    for number, (start, span, powers) in enumerate(rows):
        own = _cut(float(start - times[0]), float(span), Polynomial(powers))
        pieces += [piece._replace(number=number) for piece in own]
    return WantedMotion(tuple(pieces), period, float(times[0]), np.stack([_powers(piece) for piece in pieces], axis=1))


def _powers(piece: Piece) -> Array:
    """Powers of a cubic piece by the time from its start."""
    series = np.zeros(4) if piece.law is None else piece.law.start
    return piece.rise * series / piece.span ** np.arange(4) + piece.begin * np.eye(4)[0]


def _cut(start: float, span: float, cubic: Polynomial) -> list[Piece]:
    """Pieces of a cubic between its ends and its turning points, at which the linear term is none."""
    roots: NDArray[np.complex128] = np.asarray(cubic.deriv().roots(), dtype=np.complex128)
    # A turning point at a point of the table is its end, and no cut.
    turns = sorted(float(r.real) for r in roots.tolist() if r.imag == 0 and 1e-9 * span < r.real < (1 - 1e-9) * span)
    ends = [0.0, *turns, span]
    near = [bool(np.any(np.abs(roots - end) <= 1e-9 * span)) for end in ends]
    return [
        _cubic_piece(start, low, high, cubic, turns_at=(near[n], near[n + 1]))
        for n, (low, high) in enumerate(itertools.pairwise(ends))
    ]


def _cubic_piece(start: float, low: float, high: float, cubic: Polynomial, *, turns_at: tuple[bool, bool]) -> Piece:
    """Part of a cubic from one time to another."""
    span = high - low
    # The arithmetic of polynomials leaves highest powers out that are 0.
    forth, back = np.zeros((2, 4))
    for series, moved_to in ((forth, Polynomial([low, span])), (back, Polynomial([high, -span]))):
        own = cubic(moved_to).coef
        series[: len(own)] = own
    back = -back
    rise = float(np.sum(forth[1:]))
    for series, turns in zip((forth, back), turns_at, strict=True):
        series[0] = 0.0
        series[1] = 0.0 if turns else series[1]
    if not np.any(forth[1:]):
        return Piece(start + low, span, float(cubic(low)), 0.0, None)
    scale = rise if rise != 0 else 1.0
    law = polynomial_law(forth / scale)._replace(end=back / scale)
    return Piece(start + low, span, float(cubic(low)), scale, law)
