"""Shapes of machine parts, in the draughtsman's habit: bars with eyes, pistons in hatched walls, pivots, arrows. [mm]

Only lengths between pins and bores are to scale; the outlines are schematic.
"""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.motion import Array
from cranktrain.plans.stroke_lines import Along, unit
from cranktrain.plans.vectors import angle_of
from cranktrain.viz.paper.sketch import Circle, Fill, Line

HATCH = 1.3
"""Between ticks of a hatch, on paper. [mm]"""


def bar(start: Array, end: Array, widths: tuple[float, float], fill: Fill, order: int) -> Line:
    """Tapered bar between two pins."""
    along = (end - start) / np.hypot(*(end - start))
    across = np.array([-along[1], along[0]])
    corners = (
        start + widths[0] / 2 * across,
        end + widths[1] / 2 * across,
        end - widths[1] / 2 * across,
        start - widths[0] / 2 * across,
    )
    return Line(np.stack(corners, axis=1), "LINKS", "rod", order, is_closed=True, fill=fill)


def eye(centre: Array, outer: float, bore: float, fill: Fill, order: int) -> Iterator[Circle]:
    """Eye of a rod with the pin in it."""
    yield Circle(centre, outer, "LINKS", "rod", order, fill)
    yield Circle(centre, bore, "LINKS", "rod", order, "paper")


def hatch(start: Array, end: Array, outward: Array, scale: float) -> Line:
    """Ticks at 45° along a line, on the side to which `outward` points."""
    length = float(np.hypot(*(end - start)))
    along = (end - start) / length
    feet = np.arange(0.5 * HATCH * scale, length, HATCH * scale)
    tick = 0.9 * HATCH * scale * (outward - along)
    points = start[:, np.newaxis, np.newaxis] + along[:, np.newaxis, np.newaxis] * feet[:, np.newaxis]
    points = points + np.stack([np.zeros(2), tick, np.full(2, np.nan)], axis=1)[:, np.newaxis, :]
    return Line(points.reshape(2, -1), "GUIDES", "hatch", 2)


def walls(
    frame: Along,
    bore: float,
    span: tuple[float, float],
    scale: float,
    *,
    has_head: bool,
    ports: Sequence[tuple[float, float]] = (),
) -> Iterator[Line]:
    """Cylinder walls between two places along the axis, and the head across the far one, hatched on their outside.

    `ports` are gaps in the walls: from where to where along the axis, in order.
    """
    places = [span[0], *(place for port in ports for place in port), span[1]]
    found = [
        (frame.path((start, side * bore / 2), (end, side * bore / 2)), side * frame.across)
        for side in (-1.0, 1.0)
        for start, end in zip(places[::2], places[1::2], strict=True)
    ]
    if has_head:
        found.append((frame.path((span[1], -bore / 2), (span[1], bore / 2)), frame.along))
    for wall, outside in found:
        yield Line(wall, "GUIDES", "outline", 2)
        yield hatch(wall[:, 0], wall[:, 1], outside, scale)


def piston(frame: Along, pin: float, bore: float, above: float, below: float, fill: Fill) -> Iterator[Line]:
    """Piston with rings: `pin` its place along the axis, crown `above` it, skirt `below`."""
    half = 0.5 * bore * 0.97
    yield Line(frame.block((pin - below, pin + above), half), "LINKS", "outline", 4, True, fill)
    for ring in (pin + above * (1 - share) for share in (0.16, 0.30, 0.44)):
        yield Line(frame.path((ring, -half), (ring, half)), "LINKS", "thin", 4)


def pivot(centre: Array, size: float, scale: float) -> Iterator[Line | Circle]:
    """Fixed pivot: a foot on hatched ground below it."""
    left, right = centre + size * np.array([-0.8, -1.6]), centre + size * np.array([0.8, -1.6])
    yield Line(np.stack([left, centre, right], axis=1), "GUIDES", "outline", 3, True, "paper")
    ground = centre[:, np.newaxis] + size * np.array([[-1.4, 1.4], [-1.6, -1.6]])
    yield Line(ground, "GUIDES", "outline", 3)
    yield hatch(ground[:, 0], ground[:, 1], np.array([0.0, -1.0]), scale)


def arc(centre: Array, radius: float, start: float, end: float) -> Array:
    """Points of an arc between two directions from X, shape (2, n). [rad]"""
    angle = np.linspace(start, end, max(8, int(abs(end - start) / 0.05)))
    return centre[:, np.newaxis] + radius * unit(angle)


def arrowhead(tip: Array, direction: float, size: float) -> Line:
    """Slim filled arrowhead that ends at `tip`; direction from X. [rad]"""
    points = [tip, *(tip - size * unit(direction + side * 0.26) for side in (1, -1))]
    return Line(np.stack(points, axis=1), "DIMENSIONS", "arrow", 5, is_closed=True, fill="ink")


def hull(first: Array, first_radius: float, second: Array, second_radius: float, fill: Fill, order: int) -> Line:
    """Outline that a belt round two circles would have."""
    distance = float(np.hypot(*(second - first)))
    direction = angle_of(second - first)
    lean = float(np.arccos(np.clip((first_radius - second_radius) / distance, -1.0, 1.0)))
    points = (
        arc(first, first_radius, direction + lean, direction + 2 * np.pi - lean),
        arc(second, second_radius, direction - lean, direction + lean),
    )
    return Line(np.concatenate(points, axis=1), "LINKS", "rod", order, is_closed=True, fill=fill)
