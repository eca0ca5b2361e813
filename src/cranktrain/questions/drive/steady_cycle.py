"""The steady cycle of a machine with its motor: the speed over the crank angle with which a cycle ends as it began."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.polynomial import legendre

from cranktrain.motion import Array
from cranktrain.record import record

_N_NODES = 12
_WIDEST = 2 * np.pi / 48
_MOST_STEPS = 60
_SETTLED = 1e-11
"""Of ω²: after such a step of Newton's method the next one is less than rounding."""
_TRIED = np.linspace(1e-9, 1 - 1e-9, 129)
"""Places in a piece at which its largest value is looked for: beside its ends, where loads jump."""
_NEAR = 1e-7
"""In parts of ω²: of the difference by which slopes are taken."""

_GROWN = np.stack([np.asarray(legendre.legint(row, lbnd=-1), dtype=np.float64) for row in np.eye(_N_NODES)], axis=1)
"""Series of the integrals of Legendre's polynomials from −1 on."""


def _rule() -> tuple[Array, Array, Array]:
    """Gauss's nodes in 0…1; integrals from 0 to each of them, and to 1, of what is known there; its Legendre series."""
    nodes = legendre.leggauss(_N_NODES)[0]
    fitted = np.asarray(np.linalg.inv(legendre.legvander(nodes, _N_NODES - 1)), dtype=np.float64)
    ends = np.append(nodes, 1.0)
    integrals = legendre.legvander(ends, _N_NODES) @ _GROWN
    return (nodes + 1) / 2, integrals @ fitted / 2, fitted


_NODES, _INTEGRALS, _FITTED = _rule()
_TO_TRIED = legendre.legvander(2 * _TRIED - 1, _N_NODES) @ _GROWN @ _FITTED / 2
"""From what is known at the nodes of a piece to its integrals from there to the places tried, in parts of the piece."""


class CyclePieces(NamedTuple):
    """Pieces of a cycle between its corners: their starts and widths, shape (piece,) [rad]."""

    start: Array
    width: Array

    @property
    def nodes(self) -> Array:
        """Angles at which the equation is met, shape (piece · node,). [rad]"""
        return np.ravel(self.start[:, np.newaxis] + self.width[:, np.newaxis] * _NODES)

    def mean(self, values: Array) -> Array:
        """Mean over the angle of values at the nodes, shape (..., piece · node) → (...)."""
        return np.sum(self.of_each(values), axis=-1) / np.sum(self.width)

    def of_each(self, values: Array) -> Array:
        """Integral over each piece of values at the nodes, shape (..., piece · node) → (..., piece)."""
        return values.reshape(*values.shape[:-1], len(self.start), _N_NODES) @ _INTEGRALS[-1] * self.width


@record
class SpeedOverTurn:
    """Speed over a cycle that repeats itself.

    Attributes
    ----------
    mesh : CyclePieces
    half_square : Array, shape (piece · node,)
        ω²/2 at the nodes. [rad²/s²]
    at_start : Array, shape (piece,)
        The same where pieces begin. [rad²/s²]
    acceleration : Array, shape (piece · node,)
        [rad/s²]
    multiplier : float
        What is left after a cycle of a small departure of ω²: below 1 the running is stable.
    """

    mesh: CyclePieces
    half_square: Array
    at_start: Array
    acceleration: Array
    multiplier: float

    @property
    def speed(self) -> Array:
        """At the nodes, shape (piece · node,). [rad/s]"""
        return np.sqrt(2 * self.half_square)

    @property
    def period(self) -> float:
        """[s]"""
        return float(self.mesh.mean(1 / self.speed) * np.sum(self.mesh.width))

    def over_time(self, values: Array) -> Array:
        """Mean over the time of values at the nodes, shape (..., piece · node) → (...)."""
        slowness = 1 / self.speed
        return self.mesh.mean(values * slowness) / self.mesh.mean(slowness)

    def at(self, angle: Array) -> Array:
        """Speed at any crank angles of the cycle, shape (n,). [rad/s]"""
        start, width = self.mesh.start, self.mesh.width
        along = np.mod(angle - start[0], np.sum(width)) + start[0]
        piece = np.sum(along[:, np.newaxis] >= start[1:], axis=1)
        place = (along - start[piece]) / width[piece]
        slopes = self.acceleration.reshape(-1, _N_NODES)[piece]
        series = np.asarray(legendre.legvander(2 * place - 1, _N_NODES), dtype=np.float64)
        grown = np.sum((series @ _GROWN) * (slopes @ _FITTED.T), axis=1) / 2
        return np.sqrt(2 * (self.at_start[piece] + width[piece] * grown))


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
    start, width = found.mesh.start[:, np.newaxis], found.mesh.width[:, np.newaxis]
    with np.errstate(invalid="ignore"):
        grown = width * (found.acceleration.reshape(-1, _N_NODES) @ _TO_TRIED.T)
        speed = np.sqrt(2 * (found.at_start[:, np.newaxis] + grown))
    values = curve(np.ravel(start + width * _TRIED), np.ravel(speed)).reshape(speed.shape)
    return _top(values)


def _top(values: Array) -> float:
    """Largest value of smooth pieces, by a parabola through the largest sample and those beside it."""
    row, place = np.unravel_index(np.argmax(values), values.shape)
    if not 0 < place < values.shape[1] - 1:
        return float(values[row, place])
    before, here, behind = values[row, place - 1 : place + 2].tolist()
    bend = before - 2 * here + behind
    return here - (behind - before) ** 2 / (8 * bend) if bend < 0 else here


def speed_range(found: SpeedOverTurn) -> float:
    """Largest speed over a cycle less the smallest. [rad/s]"""
    return sum(largest_over_turn(found, lambda _angle, speed, sign=sign: sign * speed) for sign in (1.0, -1.0))


def mesh_of(cycle: float, corners: Array) -> CyclePieces:
    """Pieces of a cycle, none wider than a forty-eighth of a turn, that end at all corners; NaN is none. [rad]"""
    own = np.mod(corners[np.isfinite(corners)], cycle)
    ends = np.unique(np.concatenate([np.linspace(0.0, cycle, round(cycle / _WIDEST) + 1), own]))
    ends = ends[np.append(True, np.diff(ends) > 1e-9)]
    ends[-1] = cycle
    return CyclePieces(ends[:-1], np.diff(ends))


def speed_over_turn(
    acceleration: Callable[[Array], Array], mesh: CyclePieces, first_speed: float | Array
) -> SpeedOverTurn | None:
    """Find the cycle that repeats itself, near a constant speed or another cycle.

    Parameters
    ----------
    acceleration : callable
        Of the crank at the nodes of the mesh, by the speeds there, shape (n,). [rad/s → rad/s²]
    mesh : CyclePieces
    first_speed : float, or Array of shape (n,)
        At the nodes. [rad/s]

    Returns
    -------
    SpeedOverTurn or None
        None where there is none: the shaft would stop within the cycle.

    Notes
    -----
    docs/theory/reduced-machine, eqs. (31.6) to (31.8): ω²/2 has the slope ε by the angle. Newton's method on Gauss's
    points of all pieces, so that a motor may be as stiff as it likes.
    """
    half = np.full(len(mesh.start) * _N_NODES, 0.5 * np.square(first_speed))
    for _ in range(_MOST_STEPS):
        with np.errstate(all="ignore"):
            now = acceleration(np.sqrt(2 * half))
            near = acceleration(np.sqrt(2 * half * (1 + _NEAR)))
        slope = (near - now) / (half * _NEAR)
        if not np.all(np.isfinite(slope)):
            return None
        better, at_start, _, multiplier = _linear_cycle(slope, now - slope * half, mesh)
        if not np.all(np.isfinite(better)):
            return None
        # A step that would stop the shaft goes part of the way.
        better = np.clip(better, half / 4, half * 4)
        move = np.max(np.abs(better - half) / half)
        half = better
        if move < _SETTLED:
            return SpeedOverTurn(mesh, half, at_start, acceleration(np.sqrt(2 * half)), multiplier)
    return None


def _linear_cycle(slope: Array, rest: Array, mesh: CyclePieces) -> tuple[Array, Array, Array, float]:
    """Periodic solution of y′ = a y + b: at the nodes, where pieces begin, its slope; and its multiplier."""
    # Solved for the slopes, each row by its own size: where a is large, as behind a stiff motor, y would lose digits.
    width = mesh.width[:, np.newaxis]
    a, b = (part.reshape(-1, _N_NODES) for part in (slope, rest))
    size = 1 / (1 + width * np.abs(a))
    system = size[..., np.newaxis] * (np.eye(_N_NODES) - (width * a)[..., np.newaxis] * _INTEGRALS[:-1])
    solved = np.asarray(np.linalg.solve(system, np.stack([size * a, size * b], axis=-1)), dtype=np.float64)
    of_start, of_rest = solved[..., 0], solved[..., 1]
    grows, gains = 1 + mesh.width * (of_start @ _INTEGRALS[-1]), mesh.width * (of_rest @ _INTEGRALS[-1])
    product, total = 1.0, 0.0  # of the cycle so far
    for factor, gain in zip(grows.tolist(), gains.tolist(), strict=True):
        product, total = product * factor, total * factor + gain
    starts = [total / (1 - product)]
    for factor, gain in zip(grows[:-1].tolist(), gains[:-1].tolist(), strict=True):
        starts.append(starts[-1] * factor + gain)
    at_start = np.array(starts)
    slopes = of_start * at_start[:, np.newaxis] + of_rest
    found = at_start[:, np.newaxis] + width * (slopes @ _INTEGRALS[:-1].T)
    return np.ravel(found), at_start, np.ravel(slopes), product
