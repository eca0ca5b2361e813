"""The smallest circle round a closed curve in the plane."""

from collections.abc import Callable, Sequence
from itertools import combinations
from typing import NamedTuple

import numpy as np

from cranktrain.loads.harmonics import ComplexArray
from cranktrain.motion import Array
from cranktrain.numerics import largest, turn_grid

_ROUNDING = 1e-13
"""What lies outside by less, in parts of the radius, lies on the circle."""
_ENOUGH = 1e-9
"""By how much of the radius the curve may lie outside in the end."""
_MOST_STEPS = 60


class Circle(NamedTuple):
    """Centre, x + iy, and radius of a circle."""

    centre: complex
    radius: float


def smallest_circle(curve: Callable[[Array], ComplexArray]) -> Circle:
    """Smallest circle that holds a closed curve.

    Parameters
    ----------
    curve : callable
        From angles (..., k) over a turn to points x + iy of the same shape; one curve.

    Returns
    -------
    Circle
        Its radius to 1e-9 of itself: the points where it touches are refined between the grid's.

    Notes
    -----
    Exchange: the smallest circle round a few points of the curve, then the point of the curve farthest outside joins
    them, until none is outside. Two or three points hold it.
    """
    grid = turn_grid()
    samples = curve(grid)
    held: list[complex] = [complex(samples[0])]
    circle = Circle(held[0], 0.0)
    for _ in range(_MOST_STEPS):
        centre = circle.centre

        def distance(angle: Array, centre: complex = centre) -> Array:
            return np.abs(curve(angle) - centre)

        far = largest(distance, samples=np.abs(samples - centre), grid=grid)
        if float(far.value[0]) <= circle.radius * (1 + _ENOUGH):
            break
        circle, held = _round_points([*held, complex(curve(far.angle)[0])])
    return circle


def _round_points(points: Sequence[complex]) -> tuple[Circle, list[complex]]:
    """Smallest circle round at most four points, and those that hold it."""
    scale = max(abs(point) for point in points)
    found: list[tuple[Circle, list[complex]]] = []
    for n_held in (2, 3):
        for chosen in combinations(points, n_held):
            circle = _through(chosen)
            if all(abs(point - circle.centre) <= circle.radius + _ROUNDING * scale for point in points):
                found.append((circle, list(chosen)))
    return min(found, key=lambda one: one[0].radius)


def _through(points: Sequence[complex]) -> Circle:
    """Circle with two points as a diameter, or through three."""
    if len(points) == 2:
        return Circle((points[0] + points[1]) / 2, abs(points[1] - points[0]) / 2)
    first, b, c = points[0], points[1] - points[0], points[2] - points[0]
    across = 2 * (b.real * c.imag - b.imag * c.real)
    if across == 0:
        return Circle(first, float("inf"))
    centre = 1j * (c * abs(b) ** 2 - b * abs(c) ** 2) / -across
    return Circle(first + centre, abs(centre))
