"""Laws of motion from rest to rest or from turning to turning: share of the way over share of the time."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.polynomial import Polynomial

from cranktrain.motion import Array

_TERMS = 26
"""Powers after which the series of a cosine over half a turn has nothing left."""


class Moved(NamedTuple):
    """Something by time and its first three derivatives, each of shape (n,)."""

    value: Array
    first: Array
    second: Array
    third: Array


class Law(NamedTuple):
    """How a way is made: share of the way over share of the time.

    Attributes
    ----------
    shape : callable
        From shares of the time, shape (n,), to `Moved`.
    way : callable
        The same without derivatives.
    start, end : Array, shape (power,)
        Its power series from the start; and of what is left, 1 − y, by what is left of the time.
    reach : float
        Share of the time, from each end, in which they hold to rounding.
    """

    shape: Callable[[Array], Moved]
    way: Callable[[Array], Array]
    start: Array
    end: Array
    reach: float = 0.5

    @property
    def orders(self) -> tuple[int, int]:
        """Power with which it leaves the start and comes to the end."""
        return leading(self.start), leading(self.end)


def leading(series: Array) -> int:
    """Lowest power of a series that is there, beside the constant; 0 if none is."""
    size = np.abs(series[1:])
    there = np.flatnonzero(size > 1e-9 * np.max(size, initial=0.0))
    return int(there[0]) + 1 if there.size else 0


def by_powers(series: Array, x: Array) -> Array:
    """Σ cₖxᵏ, by Horner's scheme; series of shape (power,)."""
    *lower, highest = series.tolist()
    found: Array = highest + x * 0.0
    for coefficient in reversed(lower):
        found = coefficient + found * x
    return found


def polynomial_law(series: Array) -> Law:
    """Law y = Σ cₖsᵏ with y(0) = 0 and y(1) = 1; eq. (29.2) has those that are known by their powers."""
    whole = Polynomial(series)
    parts = [series, *(np.asarray(whole.deriv(order).coef, dtype=np.float64) for order in (1, 2, 3))]
    shape, way = partial(_by_derivatives, parts), partial(by_powers, series)
    mirrored: Polynomial = whole(Polynomial([1.0, -1.0]))
    end = np.zeros(len(series))
    end[1 : len(mirrored.coef)] = -mirrored.coef[1:]
    # What powers leave of one another in the other end's series is rounding.
    return Law(shape, way, series, np.where(np.abs(end) < 1e-12 * np.max(np.abs(series)), 0.0, end))


def _by_derivatives(parts: Sequence[Array], share: Array) -> Moved:
    """Value and derivatives, each by its own powers."""
    return Moved(*(by_powers(part, share) for part in parts))


def _series_law(shape: Callable[[Array], Moved], series: Array) -> Law:
    """Law that comes to its end as it leaves its start."""
    return Law(shape, partial(_value_of, shape), series, series)


def _value_of(shape: Callable[[Array], Moved], share: Array) -> Array:
    """Value alone."""
    return shape(share).value


def _harmonic(share: Array) -> Moved:
    cos, sin = np.cos(np.pi * share), np.sin(np.pi * share)
    return Moved(0.5 * (1 - cos), 0.5 * np.pi * sin, 0.5 * np.pi**2 * cos, -0.5 * np.pi**3 * sin)


def _cycloidal(share: Array) -> Moved:
    turn = 2 * np.pi
    cos, sin = np.cos(turn * share), np.sin(turn * share)
    return Moved(share - sin / turn, 1 - cos, turn * sin, turn**2 * cos)


def _modified_sine(share: Array) -> Moved:
    """Quarter of a fast sine, half of a slow one, and a quarter again."""
    is_end = (share < 0.125) | (share > 0.875)
    rate = np.where(is_end, 4 * np.pi, 4 * np.pi / 3)
    lead = np.where(is_end, 0.0, np.pi / 3)
    height = np.where(is_end, 1.0, 9.0)
    base = np.where(share < 0.125, 0.0, np.where(share > 0.875, 4.0, 2.0))
    cos, sin = np.cos(rate * share + lead), np.sin(rate * share + lead)
    scale = 1 / (4 + np.pi)
    wave = scale * height / 4
    return Moved(
        scale * (base + np.pi * share) - wave * sin,
        scale * np.pi - wave * rate * cos,
        wave * rate**2 * sin,
        wave * rate**3 * cos,
    )


def _wave_series(rate: float, *, is_cosine: bool) -> Array:
    """Coefficients of cos or sin of rate·s."""
    powers = np.arange(_TERMS)
    factorials = np.cumprod(np.maximum(powers, 1).astype(float))
    signs = np.array([1.0, 0.0, -1.0, 0.0] if is_cosine else [0.0, 1.0, 0.0, -1.0])
    return signs[powers % 4] * rate**powers / factorials


def _harmonic_series() -> Array:
    series = -0.5 * _wave_series(np.pi, is_cosine=True)
    series[0] = 0.0
    return series


def _sine_series(rate: float, slope: float, height: float) -> Array:
    """Series of slope·s − height·sin(rate·s), in which the first powers cancel."""
    series = -height * _wave_series(rate, is_cosine=False)
    series[1] = 0.0 if abs(slope + series[1]) < 1e-12 * slope else slope + series[1]
    return series


def _linear(share: Array) -> Moved:
    return Moved(share, np.ones_like(share), np.zeros_like(share), np.zeros_like(share))


_LINE = _series_law(_linear, np.array([0.0, 1.0]))

LAWS: dict[str, Law] = {
    "4-5-6-7": polynomial_law(np.array([0.0, 0, 0, 0, 35, -84, 70, -20])),
    "5-6-7-8-9": polynomial_law(np.array([0.0, 0, 0, 0, 0, 126, -420, 540, -315, 70])),
    "3-4-5": polynomial_law(np.array([0.0, 0, 0, 10, -15, 6])),
    "cycloidal": _series_law(_cycloidal, _sine_series(2 * np.pi, 1.0, 1 / (2 * np.pi))),
    "modified sine": _series_law(_modified_sine, _sine_series(4 * np.pi, np.pi / (4 + np.pi), 1 / (4 * (4 + np.pi)))),
    "harmonic": _series_law(_harmonic, _harmonic_series()),
    "constant velocity": _LINE,
}
"""By their names in a machine file; docs/theory/servo, eq. (29.2)."""
FROM_DEAD_CENTRE = 4
"""Least power with which a way may leave a dead centre after a dwell."""
NEAREST = "4-5-6-7"
"""Law that begins with it."""
