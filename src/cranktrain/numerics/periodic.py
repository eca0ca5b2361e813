"""Periodic curves between the points of their grid, by series, spline or pieces, with slope and integral."""

from collections.abc import Callable, Sequence
from functools import partial
from itertools import zip_longest
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import Extremes, turning_points
from cranktrain.numerics.harmonics import TURN, harmonics, phasor
from cranktrain.numerics.piecewise import PiecePlaces, mean_shares, piece_extremes, quintics
from cranktrain.numerics.polynomials import polynomial, polynomial_value
from cranktrain.numerics.products import product


class PeriodicCurve(NamedTuple):
    """A periodic curve, known at equal steps and to be asked anywhere.

    Attributes
    ----------
    cycle : float
        Its period. [rad]
    samples : Array, shape (..., n)
        Values at 0, cycle/n, …
    motion : callable
        Value and first two derivatives at angles (k,) or (..., k).
    pieces : Array, shape (power, ..., n), or None
        Of a curve of polynomials, from each sample to the next: their coefficients, by powers of the share of the step.
    between : PiecePlaces or None
        Of pieces that are not from sample to sample, shape (power, ..., design, piece), where each begins: there the
        curve may have corners.
    """

    cycle: float
    samples: Array
    motion: Callable[[Array], Coefficient]
    pieces: Array | None = None
    between: PiecePlaces | None = None

    @property
    def angle(self) -> Array:
        """Angles of the samples, shape (n,). [rad]"""
        return cycle_grid(self.samples.shape[-1], self.cycle)

    def value(self, angle: Array) -> Array:
        """Value at angles (k,) or (..., k)."""
        return self.motion(angle).value

    def slope(self, angle: Array) -> Array:
        """Derivative at angles (k,) or (..., k)."""
        return self.motion(angle).first

    def each(self, share: Array) -> Coefficient:
        """Value and derivatives at a share of each of the pieces between nodes, shape (..., design, piece)."""
        return self.among(None)(share)

    def among(self, chosen: NDArray[np.bool_] | None) -> Callable[[Array], Coefficient]:
        """As `each`, of those pieces that are chosen of that shape, or of one with more axes before it; None for all.

        Values of shape (n_chosen,).
        """
        assert self.pieces is not None
        assert self.between is not None
        pieces, width = self.pieces, self.between.width
        if chosen is not None:
            pieces = np.broadcast_to(pieces, (len(pieces), *chosen.shape))[:, chosen]
            width = np.broadcast_to(width, chosen.shape)[chosen]
        safe = np.where(width > 0, width, 1.0)

        def motion(share: Array) -> Coefficient:
            found = polynomial(pieces, share)
            return Coefficient(found.value, found.first / safe, found.second / safe**2)

        return motion


Interpolation = Callable[[Array, float], PeriodicCurve]
"""From samples at equal steps over a cycle, endpoint excluded, and the cycle, to a curve."""


def cycle_grid(n_points: int, cycle: float = TURN) -> Array:
    """One cycle in equal steps, endpoint excluded. [rad]"""
    return np.arange(n_points, dtype=np.float64) * (cycle / n_points)


def fourier_curve(samples: Array, cycle: float = TURN) -> PeriodicCurve:
    """Curve through samples (..., n) by their Fourier series: exact for a smooth one."""
    series = harmonics(samples, cycle)
    turned = 1j * series.order
    derivatives = np.stack([turned**n * series.vectors for n in range(3)], axis=-1)

    def motion(angle: Array) -> Coefficient:
        waves = phasor(angle[..., np.newaxis] * series.order)
        return Coefficient(*np.moveaxis(product(waves, derivatives).real, -1, 0))

    return PeriodicCurve(cycle, samples, motion)


def fourier_integral(samples: Array, cycle: float = TURN) -> PeriodicCurve:
    """Integral of samples (..., n) less their mean, from φ = 0, by their Fourier series.

    Notes
    -----
    Each order divided by ik: no rule of quadrature has a part in it. docs/theory/evenness, eq. (17.3).
    """
    n_points = samples.shape[-1]
    order = np.arange(n_points // 2 + 1, dtype=float) * (TURN / cycle)
    moving = order > 0
    if n_points % 2 == 0:
        moving[-1] = False  # the highest cosine's integral is seen only at its zeros
    factor = np.where(moving, -1j / np.where(moving, order, 1.0), 0.0)
    integral = np.fft.irfft(np.fft.rfft(samples, axis=-1) * factor, n_points, axis=-1)
    return fourier_curve(integral - integral[..., :1], cycle)


def spline_curve(samples: Array, cycle: float = TURN) -> PeriodicCurve:
    """Periodic cubic spline through samples (..., n): for a curve with kinks, which a series would ring at.

    Notes
    -----
    The slopes at the nodes solve s₋ + 4s + s₊ = 3(y₊ − y₋)/h, a circulant system, through its Fourier transform.
    """
    return _by_pieces(_cubics(samples), cycle)


def hermite_curve(samples: Array, slopes: Array, cycle: float = TURN) -> PeriodicCurve:
    """Cubics through samples (..., n) with given slopes (..., n) there: continuous with its slope."""
    return _by_pieces(_between(samples, slopes * (cycle / samples.shape[-1])), cycle)


def quintic_curve(known: Coefficient, cycle: float) -> PeriodicCurve:
    """Quintics through values and two derivatives at equal steps, shape (..., n)."""
    after = Coefficient(*(np.roll(part, -1, axis=-1) for part in known))
    return _by_pieces(quintics(after, known, np.asarray(cycle / known.value.shape[-1])), cycle)


def spline_integral(samples: Array, cycle: float = TURN) -> PeriodicCurve:
    """Integral of samples (..., n) less their mean, from φ = 0, exact for their periodic cubic spline."""
    step = cycle / samples.shape[-1]
    cubics = _cubics(samples - np.mean(samples, axis=-1, keepdims=True))
    risen = np.stack([step * part / power for power, part in enumerate(cubics, 1)])
    ends = np.cumsum(np.sum(risen, axis=0), axis=-1)
    starts = np.concatenate([np.zeros_like(ends[..., :1]), ends[..., :-1]], axis=-1)
    return _by_pieces(np.concatenate([starts[np.newaxis], risen]), cycle)


def plus(one: PeriodicCurve, constant: Array) -> PeriodicCurve:
    """The curve raised by a constant of shape (...)."""
    raised = np.asarray(constant)[..., np.newaxis]
    if one.pieces is not None and one.between is not None:
        first, *others = one.pieces
        powers = np.stack(np.broadcast_arrays(first + raised, *others))
        return piecewise_curve(powers, one.between, one.samples + raised, one.cycle)

    def motion(angle: Array) -> Coefficient:
        value, first, second = one.motion(angle)
        return Coefficient(value + raised, first, second)

    return PeriodicCurve(one.cycle, one.samples + raised, motion)


def combined(one: PeriodicCurve, factor: Array, other: PeriodicCurve) -> PeriodicCurve:
    """The first curve plus a factor, shape (...), times the second; both on one grid."""
    times = np.asarray(factor)[..., np.newaxis]
    if one.pieces is not None and other.pieces is not None and one.between is other.between:
        powers = zip_longest(one.pieces, other.pieces, fillvalue=np.zeros(()))
        whole = np.stack(np.broadcast_arrays(*(part + times * added for part, added in powers)))
        if one.between is None:
            return _by_pieces(whole, one.cycle)
        return piecewise_curve(whole, one.between, one.samples + times * other.samples, one.cycle)

    def motion(angle: Array) -> Coefficient:
        parts = zip(one.motion(angle), other.motion(angle), strict=True)
        return Coefficient(*(part + times * added for part, added in parts))

    return PeriodicCurve(one.cycle, one.samples + times * other.samples, motion)


def times(one: PeriodicCurve, factor: Array) -> PeriodicCurve:
    """A factor, shape (...), times the curve."""
    by = np.asarray(factor)[..., np.newaxis]
    if one.pieces is not None and one.between is None:
        return _by_pieces(by * one.pieces, one.cycle)

    def motion(angle: Array) -> Coefficient:
        return Coefficient(*(by * part for part in one.motion(angle)))

    return PeriodicCurve(one.cycle, by * one.samples, motion)


def curves_by_design(curves: Sequence[PeriodicCurve]) -> PeriodicCurve:
    """Curves of designs, samples (n,), as one of samples (design, n), at angles (k,) or (..., design, k)."""
    if len(curves) == 1:
        return curves[0]

    def motion(angle: Array) -> Coefficient:
        own = np.broadcast_to(angle, np.broadcast_shapes(angle.shape, (len(curves), 1)))
        found = [curve.motion(own[..., i, :]) for i, curve in enumerate(curves)]
        return Coefficient(*(np.stack(parts, axis=-2) for parts in zip(*found, strict=True)))

    return PeriodicCurve(curves[0].cycle, np.stack([curve.samples for curve in curves]), motion)


def curve_extremes(one: PeriodicCurve) -> Extremes:
    """Smallest and largest value over the cycle, refined between the samples, and at corners; shapes (..., 1)."""
    if one.between is not None:
        return piece_extremes(one.among, one.between)
    return turning_points(one.motion, one.samples, one.angle)


def mean_samples(*curves: PeriodicCurve) -> tuple[list[Array], Array | None]:
    """Values of curves whose means are theirs, and the weights, of sum 1; None where all weigh the same.

    Equal steps for what is smooth or a spline; Gauss's points in every piece for curves of pieces that begin alike.
    """
    between = curves[0].between
    if between is None or any(one.between is not between for one in curves):
        return [one.samples for one in curves], None
    shares, weight = mean_shares()
    pieces = [one.pieces for one in curves if one.pieces is not None]
    values = [np.concatenate([polynomial_value(powers, share) for share in shares], axis=-1) for powers in pieces]
    width = between.width / curves[0].cycle
    return values, np.concatenate([part * width for part in weight], axis=-1)


def piecewise_curve(coefficients: Array, between: PiecePlaces, samples: Array, cycle: float) -> PeriodicCurve:
    """Curve of polynomials of pieces that begin anywhere.

    Parameters
    ----------
    coefficients : Array, shape (power, ..., design, piece)
        By powers of the share of the piece.
    between : PiecePlaces
    samples : Array, shape (..., design, n)
        The curve in equal steps over the cycle.
    cycle : float
        [rad]

    Returns
    -------
    PeriodicCurve
    """
    return PeriodicCurve(cycle, samples, partial(_on_pieces, coefficients, between, cycle), coefficients, between)


def _on_pieces(coefficients: Array, between: PiecePlaces, cycle: float, angle: Array) -> Coefficient:
    """Value and derivatives of polynomials of pieces at any angle."""
    starts, width = between
    n_designs, n_pieces = starts.shape
    # One search for all designs: the period of each lies behind that of the one before.
    behind: Array = cycle * np.arange(n_designs, dtype=np.float64)[:, np.newaxis]
    line, start, wide = (np.ravel(part) for part in (starts + behind, starts, width))
    lead = coefficients.shape[1:-2]
    flat = coefficients.reshape(len(coefficients), -1, n_designs * n_pieces)
    own = np.mod(np.broadcast_to(angle, np.broadcast_shapes(angle.shape, (*lead, n_designs, 1))), cycle)
    # Of an angle that is NaN any piece will do, as its share is NaN.
    last: NDArray[np.intp] = n_pieces * np.arange(1, n_designs + 1, dtype=np.intp)[:, np.newaxis] - 1
    found = np.asarray(np.searchsorted(line, own + behind, side="right"), dtype=np.intp) - 1
    place: NDArray[np.intp] = np.clip(found, last - (n_pieces - 1), last)
    share = (own - start[place]) / wide[place]
    rows = place.reshape(flat.shape[1], -1)
    powers = np.stack([np.take_along_axis(part, rows, axis=-1).reshape(place.shape) for part in flat])
    value, first, second = polynomial(powers, share)
    return Coefficient(value, first / wide[place], second / wide[place] ** 2)


def _cubics(samples: Array) -> Array:
    """Coefficients of the periodic cubic spline in each piece, by powers of the share of the step, (4, ..., n)."""
    n_points = samples.shape[-1]
    turn = np.arange(n_points // 2 + 1, dtype=float) * (TURN / n_points)
    # In parts of the step.
    transfer = 3j * np.sin(turn) / (2 + np.cos(turn))
    return _between(samples, np.fft.irfft(transfer * np.fft.rfft(samples, axis=-1), n_points, axis=-1))


def _between(samples: Array, slope: Array) -> Array:
    """Coefficients of the cubics from node to node with given values, and slopes in parts of the step, (4, ..., n)."""
    rise, slope_after = np.roll(samples, -1, axis=-1) - samples, np.roll(slope, -1, axis=-1)
    return np.stack([samples, slope, 3 * rise - 2 * slope - slope_after, slope + slope_after - 2 * rise])


def _by_pieces(coefficients: Array, cycle: float) -> PeriodicCurve:
    """Curve of polynomials, one from each node to the next; coefficients (power, ..., n) as `_cubics` has them."""
    return PeriodicCurve(cycle, coefficients[0], partial(_on_steps, coefficients, cycle), coefficients)


def _on_steps(coefficients: Array, cycle: float, angle: Array) -> Coefficient:
    """Value and derivatives of polynomials of equal pieces at any angle."""
    n_points = coefficients.shape[-1]
    step = cycle / n_points
    flat = coefficients.reshape(len(coefficients), -1)
    starts = np.arange(0, flat.shape[-1], n_points, dtype=np.intp)
    rows = starts.reshape((*coefficients.shape[1:-1], 1))
    place = np.floor(angle / step)
    share = angle / step - place
    # Of an angle that is NaN any piece will do, as its share is NaN.
    found = polynomial(flat[:, np.fmax(np.mod(place, n_points), 0.0).astype(np.intp) + rows], share)
    return Coefficient(found.value, found.first / step, found.second / step**2)
