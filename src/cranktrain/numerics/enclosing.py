"""The smallest circle round a closed curve in the plane."""

from collections.abc import Callable, Sequence
from itertools import combinations
from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics import largest, turn_grid
from cranktrain.numerics.harmonics import ComplexArray
from cranktrain.numerics.ties import falling

_ENOUGH = 1e-9
"""By how much of the radius the curve may lie outside in the end."""
_SAME = 1e-5
"""Points nearer than this to each other, in parts of the radius, are one touch: the newer one is the better."""
_HIDDEN = 5e-3
"""How much of the radius a peak may rise above the samples beside it."""
_MOST_PEAKS = 6
_MOST_STEPS = 60


class EnclosingCircle(NamedTuple):
    """Centre, x + iy, and radius of a circle."""

    centre: complex
    radius: float


def smallest_circle(curve: Callable[[Array], ComplexArray]) -> EnclosingCircle:
    """Smallest circle that holds a closed curve.

    Parameters
    ----------
    curve : callable
        From angles (..., k) over a turn to points x + iy of the same shape; one curve.

    Returns
    -------
    EnclosingCircle
        Its radius to 1e-9 of itself: the points where it touches are refined between the grid's.

    Notes
    -----
    Exchange: the smallest circle round a few points of the curve, then the curve's points farthest outside join them,
    until none is outside. Two or three points hold it.
    """
    samples = curve(turn_grid())
    held: list[complex] = [complex(samples[0])]
    circle = EnclosingCircle(held[0], 0.0)
    for _ in range(_MOST_STEPS):
        outside = _outside(curve, samples, circle)
        if not outside:
            break
        near = _SAME * abs(outside[0] - circle.centre)
        old = [point for point in held if all(abs(point - new) > near for new in outside)]
        circle, held = _round_points([*outside, *old])
    return circle


def _outside(curve: Callable[[Array], ComplexArray], samples: ComplexArray, circle: EnclosingCircle) -> list[complex]:
    """Where the curve bulges out of a circle farthest, at most so many points, refined between the samples."""
    grid = turn_grid()

    def distance(angle: Array) -> Array:
        return np.abs(curve(angle) - circle.centre)

    far = np.abs(samples - circle.centre)
    before, after = np.roll(far, 1), np.roll(far, -1)
    peaks = np.flatnonzero((far >= before) & (far > after) & (far > circle.radius * (1 - _HIDDEN)))
    points: list[complex] = []
    for peak in peaks[falling(far[peaks])][:_MOST_PEAKS]:
        # Three points of the grid are enough for one peak: among all of them `largest` would look at the two highest.
        window = grid[peak] + grid[1] * np.array([-1.0, 0.0, 1.0])
        top = largest(distance, grid=window, samples=np.array([before[peak], far[peak], after[peak]]))
        if float(top.value[0]) > circle.radius * (1 + _ENOUGH):
            points.append(complex(curve(top.angle)[0]))
    return points


def _round_points(points: Sequence[complex]) -> tuple[EnclosingCircle, list[complex]]:
    """Smallest circle round a few points, and those that hold it: of all circles' centres the nearest to all."""
    best, held = EnclosingCircle(points[0], float("inf")), list(points)
    for n_held in (2, 3):
        for chosen in combinations(points, n_held):
            centre = _centre(chosen)
            radius = max(abs(point - centre) for point in points)
            if radius < best.radius:
                best, held = EnclosingCircle(centre, radius), list(chosen)
    return best, held


def _centre(points: Sequence[complex]) -> complex:
    """Middle between two points, or centre of the circle through three."""
    if len(points) == 2:
        return (points[0] + points[1]) / 2
    first, b, c = points[0], points[1] - points[0], points[2] - points[0]
    across = 2 * (b.real * c.imag - b.imag * c.real)
    if across == 0:
        return complex(np.inf)  # three on a line: two of them hold the circle
    return first + 1j * (b * abs(c) ** 2 - c * abs(b) ** 2) / across
