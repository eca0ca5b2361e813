"""Rays on paper: stars of phases side by side, and circles off which loads take, with their oil holes."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.motion import Array
from cranktrain.panels.parts import Stars, WearCircles
from cranktrain.panels.shapes import Rays
from cranktrain.saying.scales import scale_for
from cranktrain.saying.wording import plain
from cranktrain.viz.paper.page import LINE, Box, Page, rounded_down
from cranktrain.viz.paper.polar import cells
from cranktrain.viz.paper.shapes import unit as direction_of
from cranktrain.viz.paper.sketch import together
from cranktrain.viz.paper.style import FILLS, INK, MUTED

STARS_HEIGHT = 42.0
"""Of stars with their heading. [mm]"""
_BESIDE = 3
"""Stars that have room side by side."""
_RADIUS, _NAME = 8.0, 12.0
"""Of a star, and of the names round it. [mm]"""
_SHORT = 3
"""Longer names in one direction give way to how many they are."""
_ALIKE = 1e-6
"""Directions nearer to each other are one. [rad]"""
_CROWD = 12
"""With more directions only the first is named."""

_DEEPEST = 0.62
"""How far into a circle the largest load reaches, in parts of its radius."""
_HEAD, _LARGEST = 9.0, 30.0
"""Over a circle for its words, and its radius, at most. [mm]"""
_TITLE = 3.4
"""From line to line of a title over a circle. [mm]"""
_ROUND = np.linspace(0.0, 2 * np.pi, 181)
_ROW = 8
"""Circles that may stand in rows of any length."""
_LOWEST, _WIDEST = 28.0, 56.0
"""Height of a row, at least, and room of a circle, at most. [mm]"""


def draw_stars(page: Page, stars: Stars, box: Box) -> None:
    """Draw stars side by side under their heading."""
    page.heading(box.left, box.bottom + box.height - 3.0, str(stars.title))
    middle = box.bottom + box.height - 10.0 - _NAME
    for number, star in enumerate(stars.rays):
        centre = (box.left + (number + 0.5) * box.width / _BESIDE, middle)
        _draw_star(page, star, centre)
        page.text(centre[0], middle - _NAME - 5.5, str(star.title), ha="center")


def _draw_star(page: Page, star: Rays, centre: tuple[float, float]) -> None:
    """Draw one star: a line for each direction, and the names of the rays in it."""
    edge = np.array(centre)[:, np.newaxis] + _RADIUS * direction_of(np.linspace(0.0, 2 * np.pi, 91))
    page.paper.plot(*edge, color=MUTED, lw=0.4)
    rays = star.size * direction_of(star.direction)
    groups = together(rays, _ALIKE)
    for place, of in enumerate(groups):
        x, y = rays[:, of[0]].tolist()
        page.paper.plot((centre[0], centre[0] + _RADIUS * x), (centre[1], centre[1] + _RADIUS * y), color=INK, lw=0.9)
        page.paper.plot([centre[0] + _RADIUS * x], [centre[1] + _RADIUS * y], "o", ms=2.6, color=INK)
        said = ",".join(star.names[i] for i in of)
        words = said if len(said) <= _SHORT else f"×{len(of)}"
        if not place or len(groups) <= _CROWD:
            page.text(centre[0] + _NAME * x, centre[1] + _NAME * y, words, ha="center", va="center_baseline")


def draw_wear(page: Page, circles: WearCircles, box: Box) -> None:
    """Draw circles in rows, the load that takes off them inward to one scale, and say that."""
    above = box._replace(bottom=box.bottom + 2 * LINE, height=box.height - 2 * LINE)
    fitting = circles.rows[: int(above.height / _LOWEST)]
    drawn = [one for row in fitting for one in row]
    rooms = cells(above, len(drawn)) if len(drawn) <= _ROW else list(_rooms(above, [*map(len, fitting)]))
    radius = min(_LARGEST, rooms[0].width / 2 - 3.0, (rooms[0].height - _HEAD) / 2 - 1.0)
    most = max(float(np.max(one.size)) for one in drawn)
    unit = scale_for("N", most)
    force = most / (_DEEPEST * radius)
    bar = rounded_down(float(unit.of(most)))
    for one, room in zip(drawn, rooms, strict=True):
        _draw_circle(page, one, room, radius, force)
    end, y = box.left + bar * unit.one / force, box.bottom + LINE
    page.sample(box.left, end, y + 0.9, color=INK, lw=2.0, solid_capstyle="butt")
    page.text(end + 2.0, y, str(circles.words.format(force=plain(bar), unit=unit.label)))
    n_left_out = sum(map(len, circles.rows)) - len(drawn)
    if n_left_out:
        page.notes(box.left, box.bottom, [str(circles.left_out.format(n=n_left_out))])


def _rooms(box: Box, lengths: Sequence[int]) -> Iterator[Box]:
    """Rooms in rows of some lengths, all as wide as those of the longest."""
    width, height = min(box.width / max(lengths), _WIDEST), box.height / len(lengths)
    for row, length in enumerate(lengths):
        for place in range(length):
            yield Box(box.left + place * width, box.bottom + box.height - (row + 1) * height, width, height)


def _draw_circle(page: Page, one: Rays, room: Box, radius: float, force: float) -> None:
    """Draw the circle, what the loads take off it, and the oil hole."""
    pole = np.array([room.left + room.width / 2, room.bottom + (room.height - _HEAD) / 2])
    around = np.append(one.direction, one.direction[0])
    inner = radius - np.append(one.size, one.size[0]) / force
    edge = pole[:, np.newaxis] + radius * direction_of(_ROUND)
    worn = pole[:, np.newaxis] + inner * direction_of(around)
    outside = pole[:, np.newaxis] + radius * direction_of(around)
    ring = np.concatenate([outside, worn[:, ::-1]], axis=1)
    page.paper.fill(*ring, facecolor=FILLS["light"], edgecolor="none", zorder=2)
    page.paper.plot(*edge, color=INK, linewidth=0.9, zorder=4)
    page.paper.plot(*worn, color=INK, linewidth=0.8, zorder=4)
    for axis in (0, 1):
        ends = np.tile(pole[:, np.newaxis], 2)
        ends[axis] += np.array([-1.0, 1.0]) * (radius + 1.5)
        page.paper.plot(*ends, color=MUTED, linewidth=0.4, zorder=1)
    for number, line in enumerate(reversed(str(one.title).split("\n"))):
        over = float(pole[1]) + radius + 2.5 + number * _TITLE
        page.text(float(pole[0]), over, line, ha="center", fontweight="bold")
    if np.isfinite(one.hole):
        _draw_hole(page, one, pole, radius)


def _draw_hole(page: Page, one: Rays, pole: Array, radius: float) -> None:
    """Draw the oil hole from the middle through the surface, and write its place."""
    towards = direction_of(np.array([one.hole]))[:, 0]
    across = 0.9 * np.array([-towards[1], towards[0]])
    for side in (-1.0, 1.0):
        ends = np.stack([pole + side * across, pole + side * across + radius * towards], axis=1)
        page.paper.plot(*ends, color=INK, linewidth=0.7, zorder=5)
    page.paper.plot(*np.stack([pole, pole + (radius + 1.5) * towards], axis=1), color=INK, linewidth=0.4, zorder=5)
    at = pole + np.array([0.0, -0.45 * radius if towards[1] > 0 else 0.3 * radius])
    page.text(
        float(at[0]),
        float(at[1]),
        f"{np.rad2deg(one.hole_angle):.0f}°",
        ha="center",
        va="center",
        zorder=6,
        bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.6},
    )
