"""What turns round, by the root of its distance from there: smooth and well conditioned through a dead centre."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.polynomial import chebyshev

from cranktrain.layout.wish.laws import by_powers, leading
from cranktrain.motion import Array, Coefficient

_DEGREE = 18
_WIDEST, _NARROWEST = 0.4, 0.01
_CLOSE = 2e-14
"""Of x″: what its polynomial about a dead centre may miss."""
_MOST_STEPS = 12


class TurnOfWish(NamedTuple):
    """Distance from a turning point, |q − q_d| = uᵐ·P(u/reach), by how far in angle or time it is away.

    Attributes
    ----------
    order : int
        m.
    series : Array, shape (power,)
        Of P.
    reach : float
        Up to which |u| it holds. [rad or s]
    """

    order: int
    series: Array
    reach: float


class Root(NamedTuple):
    """Root of the distance, and its first two derivatives by u."""

    value: Array
    first: Array
    second: Array


def root_of_distance(turning: TurnOfWish, away: Array) -> Root:
    """Give s = u^{m/2} √P at distances u, shape (n,) and not below 0.

    docs/theory/servo, eq. (29.4).
    """
    n = turning.order / 2
    share = away / turning.reach
    slopes = _slopes(turning.series)
    value, first, second = (
        by_powers(series, share) / turning.reach**order
        for order, series in enumerate((turning.series, slopes, _slopes(slopes)))
    )
    root = np.sqrt(value)
    slope = first / (2 * root)
    bend = (second - 2 * slope**2) / (2 * root)
    ahead = n * (n - 1)
    curved = 0.0 if ahead == 0 else ahead * away ** (n - 2) * root
    return Root(
        away**n * root,
        n * away ** (n - 1) * root + away**n * slope,
        curved + 2 * n * away ** (n - 1) * slope + away**n * bend,
    )


def _slopes(series: Array) -> Array:
    """Coefficients of the derivative of Σ cₖxᵏ."""
    return np.arange(1, series.size) * series[1:] if series.size > 1 else np.zeros(1)


def away_at(turning: TurnOfWish, root: Array) -> Array:
    """Distance u ≥ 0 at which the root is this, shape (n,) and not below 0; beyond the reach it may be anything."""
    m = turning.order
    target = root ** (2 / m)
    away: Array = np.minimum(leading_away(turning, root), turning.reach)
    slopes = _slopes(turning.series)
    for _ in range(_MOST_STEPS):
        share: Array = away / turning.reach
        inner: Array = np.maximum(by_powers(turning.series, share), 1e-300)
        factor = inner ** (1 / m)
        slope: Array = factor * (1 + share * by_powers(slopes, share) / (m * inner))
        step: Array = (away * factor - target) / slope
        away = np.clip(away - step, 0.0, 2 * turning.reach)
        if np.all(np.abs(step) <= 1e-16 * turning.reach):
            break
    return away


def leading_away(turning: TurnOfWish, root: Array) -> Array:
    """The same by the leading power alone, which holds for any reach where the distance is small."""
    return (root**2 / turning.series[0]) ** (1 / turning.order)


def mirrored(turning: TurnOfWish) -> TurnOfWish:
    """Look from a turning point the other way."""
    return turning._replace(series=turning.series * (-1.0) ** np.arange(turning.series.size))


def of_series(series: Array, rise: float, span: float, reach: float) -> TurnOfWish:
    """Turning of a law from its power series over a span of time, on the way that `rise` measures.

    It holds for a share of the span.
    """
    order = leading(series)
    own = abs(rise) * np.sign(series[order]) * series[order:]
    return TurnOfWish(order, own * reach ** np.arange(own.size) / span**order, reach * span)


def about_dead_centre(motion: Callable[[Array], Coefficient], angle: float) -> TurnOfWish:
    """Turning of an output about its dead centre, from a polynomial through x″ there.

    x − x_d = δ² ∫(1 − u) x″(φ_d + uδ) du: no difference of near numbers. docs/theory/servo, eq. (29.5).
    """
    nodes = np.cos(np.pi * (np.arange(_DEGREE + 1) + 0.5) / (_DEGREE + 1))
    looks = np.array([-0.97, -0.53, 0.11, 0.62, 0.98])
    reach = _WIDEST
    while True:
        values = motion(angle + reach * np.append(nodes, looks)).second
        fitted = chebyshev.chebfit(nodes, values[: nodes.size], _DEGREE)
        missed = np.max(np.abs(chebyshev.chebval(looks, fitted) - values[nodes.size :]))
        if missed <= _CLOSE * np.max(np.abs(values)) or reach <= _NARROWEST:
            break
        reach *= 0.7
    series = chebyshev.cheb2poly(fitted)
    k = np.arange(series.size)
    return TurnOfWish(2, np.sign(series[0]) * series / ((k + 1) * (k + 2)), reach)
