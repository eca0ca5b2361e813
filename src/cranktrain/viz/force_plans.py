"""Sheet of the polygons of forces: the mechanism, the polygon of every link, and all forces with their numbers."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.analysis import SpeedWanted, speed_over_cycle
from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.machine import Machine
from cranktrain.study.force_polygons import ForcePolygon, force_polygons, rescaled
from cranktrain.study.plans import fitting, position_plan
from cranktrain.study.plans import rescaled as rescaled_plan
from cranktrain.study.vectors import spoken_name
from cranktrain.viz import shapes
from cranktrain.viz.labels import Wish, placed_labels
from cranktrain.viz.page import Figure, Page, drawing_settings, mathematics, muted
from cranktrain.viz.plan_sheet import Box, cells_of, centre, few_angles, figure, plan_page, scale_of, write_scales
from cranktrain.viz.plan_sketches import positions_sketch
from cranktrain.viz.sketch import Circle, Line, Sketch
from cranktrain.viz.style import SYMBOL

_TABLE, _LINE, _HEAD = 62.0, 4.3, 6.0
"""Width of a table of forces, height of its rows and of its head. [mm]"""

_EDGE = (15.0, 17.0)
"""What the words beside a polygon, and its heading, need. [mm]"""

_HEADED = 2.5
"""A force shorter than this has no arrowhead. [mm]"""

_SYMBOL = 4.0
"""A force shorter than this has no symbol beside it; the table has it. [mm]"""


_ASIDE, _BACK = 0.9, -0.9995
"""How far a force stands beside the one on which it goes back [mm], and the cosine of what is back."""

_LEAST = 1e-9
"""Of a length by which is divided. [mm]"""

_LETTERS = 13
"""Of a joint's name there is room for so many."""


def plan_forces(
    machine: Machine,
    angles: int | Sequence[float] = (30.0,),
    *,
    mechanism: str | None = None,
    size: str = "A4",
    speed: SpeedWanted = "constant",
) -> Figure:
    """Draw the polygons of forces of a mechanism's links, to scale, beside the mechanism and a table.

    Parameters
    ----------
    machine : Machine
        With masses or gas, and a speed.
    angles : int or sequence of float
        How many, evenly over a turn, or which crank angles; two at most. [deg]
    mechanism : str, optional
        Its name; the first slave of throw 1, or the first mechanism, unless given.
    size : "A4" or "A3"
    speed : SpeedWanted
        As `cranktrain.run` takes it.

    Returns
    -------
    Figure
    """
    chosen = [float(angle) for angle in few_angles(angles, _("polygons of forces"))]
    curve = speed_over_cycle(machine, speed)
    polygons = force_polygons(machine, chosen, mechanism=mechanism, speed=curve or "constant")
    with drawing_settings():
        page, box = plan_page(machine, angles, size, _("Polygons of forces"), polygons[0].mechanism, curve=curve)
        cells = list(cells_of(box, len(chosen)))
        groups = [[polygon for polygon in polygons if polygon.angle == angle] for angle in chosen]
        tables = [_tables(group, cell.height) for group, cell in zip(groups, cells, strict=True)]
        left = 0.24 * box.width
        middle = box.width - left - _TABLE * max(map(len, tables))
        columns, scale = _columns(groups, (middle, cells[0].height))
        plans = [
            position_plan(machine, [angle], mechanism=mechanism, room=(left - 14.0, cells[0].height - 20.0))
            for angle in chosen
        ]
        metal = max(plan.scale for plan in plans)
        for plan, group, rows, cell in zip(plans, groups, tables, cells, strict=True):
            page.heading(cell.left, cell.bottom + cell.height - 4.0, f"φ = {plan.angles[0]:g}°")
            sketch = positions_sketch(rescaled_plan(plan, metal))
            centre(page, sketch, Box(cell.left, cell.bottom, left, cell.height - 5.0))
            _draw(
                page,
                [rescaled(one, scale) for one in group],
                cell._replace(left=cell.left + left, width=middle),
                columns,
            )
            for number, part in enumerate(rows):
                start = cell.left + left + middle + number * _TABLE
                _write(page, part, scale, (start + 3.0, cell.bottom + cell.height, _TABLE - 3.0))
        write_scales(page, box, [scale_of("l", metal, "m"), scale_of("F", scale, "N")], None)
        page.text(
            box.left + left,
            box.bottom + 4.2,
            _("Forces on each link, head to tail from the ring; F₃₄ is the force of 3 on 4; dashed: inertia"),
            **muted(),
        )
        return page.figure


def _columns(groups: Sequence[Sequence[ForcePolygon]], room: tuple[float, float]) -> tuple[int, float]:
    """Choose the number of columns in which the polygons can be largest, and their scale."""
    outlines = [polygon.corners * polygon.scale for group in groups for polygon in group]
    most = max(map(len, groups))
    found: list[tuple[float, int]] = []
    for columns in range(1, most + 1):
        width, height = room[0] / columns - _EDGE[0], room[1] / -(-most // columns) - _EDGE[1]
        if min(width, height) > 0.0:
            found.append((fitting(outlines, (width, height)), columns))
    if not found:
        raise InputError([Problem("", groups[0][0].mechanism, too_many_words())])
    scale, columns = min(found)
    return columns, scale


def too_many_words() -> str:
    """Say what to do about more forces than a sheet has room for."""
    return _("has too many forces for this paper: ask for one crank angle, or for A3")


def _draw(page: Page, polygons: Sequence[ForcePolygon], box: Box, columns: int) -> None:
    """Draw the polygons of one angle in a grid, each headed by its link."""
    rows = -(-len(polygons) // columns)
    width, height = box.width / columns, (box.height - 4.0) / rows
    for i, polygon in enumerate(polygons):
        left, bottom = box.left + i % columns * width, box.bottom + 4.0 + (rows - 1 - i // columns) * height
        page.heading(left + 4.0, bottom + height - 4.0, _heading(polygon))
        centre(page, force_polygon_sketch(polygon), Box(left, bottom, width, height - 5.0))


def _heading(polygon: ForcePolygon) -> str:
    """Number and name of a link."""
    return f"{polygon.number} {polygon.link.replace('_', ' ')}"


def force_polygon_sketch(polygon: ForcePolygon) -> Sketch:
    """Polygon in drawing millimetres: forces head to tail from a ring, those of inertia dashed."""
    sketch = Sketch(1.0)
    middle = np.mean(polygon.corners, axis=1)
    wishes: list[Wish] = []
    before = np.zeros(2)
    for force, start, end in zip(polygon.forces, polygon.corners.T[:-1], polygon.corners.T[1:], strict=True):
        side = (end - start) / max(polygon.length(force), _LEAST)
        # Where a force goes back on the one before, it is drawn beside it.
        aside = _ASIDE * np.array([side[1], -side[0]]) * float(side @ before < _BACK)
        habit = "part" if force.cause == "inertia" else "vector"
        sketch.add([Line(np.stack([start + aside, end + aside], axis=1), "LINKS", habit, 3)])
        along = float(np.arctan2(side[1], side[0]))
        if polygon.length(force) > _HEADED:
            sketch.add([shapes.arrowhead(end + aside, along, 2.0)])
        if polygon.length(force) > _SYMBOL:
            half = 0.5 * (start + end) + aside
            wishes.append(Wish(half, force.symbol, _outward(half - middle, along)))
        before = side
    sketch.add([Circle(polygon.corners[:, 0], 0.7, "LINKS", "outline", 6, "paper")])
    if wishes:
        sketch.add(placed_labels(wishes, list(sketch.outline()), 1.0))
    return sketch


def _outward(away: np.ndarray, along: float) -> float:
    """Direction across a side, away from the middle; to its left where the middle is on it."""
    across = np.array([-np.sin(along), np.cos(along)])
    side = -1.0 if float(across @ away) < -1e-6 else 1.0
    return float(np.arctan2(side * across[1], side * across[0]))


def _tables(polygons: Sequence[ForcePolygon], height: float) -> list[list[ForcePolygon]]:
    """Divide links among tables that are as high as the room."""
    room = int((height - _HEAD) / _LINE) - 1
    tables: list[list[ForcePolygon]] = [[]]
    for polygon in polygons:
        used = sum(1 + len(one.forces) for one in tables[-1])
        if tables[-1] and used + 1 + len(polygon.forces) > room:
            tables.append([])
        tables[-1].append(polygon)
    return tables


def _write(page: Page, polygons: Sequence[ForcePolygon], scale: float, place: tuple[float, float, float]) -> None:
    """Write a table of the forces on several links: symbol, joint, length on paper, size."""
    left, top, width = place
    ends = (left, left + 0.2 * width, left + 0.76 * width, left + width)
    y = top - 4.0
    for words, x, where in zip(
        (_("force"), _("joint"), "mm", "N"), ends, ("left", "left", "right", "right"), strict=True
    ):
        page.text(x, y, words, ha=where, fontweight="bold")
    page.rule(y - 1.4, left, left + width)
    y -= _HEAD
    for polygon in polygons:
        page.text(left, y, _heading(polygon), fontweight="bold")
        for row in _rows(rescaled(polygon, scale)):
            y -= _LINE
            for words, x, where in zip(row, ends, ("left", "left", "right", "right"), strict=True):
                page.text(x, y, words, ha=where, fontsize=SYMBOL if words.startswith("$") else 8.0)
        y -= _LINE


def _rows(polygon: ForcePolygon) -> Iterator[tuple[str, str, str, str]]:
    """Every force of a link."""
    causes = {"load": _("load"), "weight": _("weight"), "inertia": _("inertia"), "reaction": ""}
    for force in polygon.forces:
        said = causes[force.cause] or _joint_words(force.joint)
        yield mathematics(force.symbol), said, f"{polygon.length(force):.2f}", figure(force.size)


def _joint_words(joint: str) -> str:
    """Name of a joint in words; a chain's is the point's, as the symbol says which links meet there."""
    words = spoken_name(joint.partition("/")[0]).replace("_", " ")
    return words if len(words) <= _LETTERS else f"{words[: _LETTERS - 1]}…"
