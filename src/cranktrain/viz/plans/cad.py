"""DXF of positions and plans: metal in true millimetres, each kind of thing on a layer of its own."""

import os
from collections.abc import Iterator, Sequence
from io import StringIO
from typing import Any, TypeAlias

import numpy as np

from cranktrain.analysis import SpeedWanted, speed_over_cycle
from cranktrain.errors import refuse
from cranktrain.extras import imported, lacking_for
from cranktrain.io.output import write_whole
from cranktrain.layout.speed import SpeedCurve
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.one_line import visible
from cranktrain.plans.drive_scheme import DriveShaft, drive_chain
from cranktrain.plans.polygons import Polygon, acceleration_polygons, velocity_polygons
from cranktrain.plans.positions import PositionPlan, position_plan, rescaled, track
from cranktrain.plans.shown_loads import shown_loads
from cranktrain.plans.together import places_called
from cranktrain.plans.vectors import pair
from cranktrain.saying.scales import scale_for
from cranktrain.saying.wording import plain
from cranktrain.viz.paper.head import speed_words
from cranktrain.viz.paper.sketch import LAYERS, Circle, Line, Sketch, bounds_of
from cranktrain.viz.plans.drive_beside import crank_pin
from cranktrain.viz.plans.drive_chain import bounds_of_chain, chain_drawing
from cranktrain.viz.plans.drive_symbols import crank_mark
from cranktrain.viz.plans.drive_table import drive_rows, meanings
from cranktrain.viz.plans.sketches import polygon_sketch, positions_sketch

# The DXF library is an extra, and its own types are partial.
Document: TypeAlias = Any
Modelspace: TypeAlias = Any

_ROOM = (180.0, 160.0)
_PLAN_ROOM = (90.0, 90.0)
"""Room for which positions and polygons are scaled. [mm of paper]"""

_TABLE = 105.0
"""Width of a drive's table on a sheet; letters of a drawing program are larger. [mm of paper]"""

_ROWS = 4
"""Polygons one below the other."""

_GAP = 40.0
"""Between polygons. [mm of paper]"""

_TEXT = 3.0
"""Height of text. [mm of paper]"""

_COLOURS = {
    "LINKS": 7,
    "GUIDES": 8,
    "PATHS": 9,
    "PLAN_V": 3,
    "PLAN_A": 30,
    "LOADS": 6,
    "TEXT": 7,
    "DIMENSIONS": 5,
    "DRIVE": 7,
}
_LINE_TYPES = {"dotted": "DOT2", "axis": "DASHDOT2", "part": "DASHED2", "construction": "DASHED2"}


def dxf(
    machine: Machine,
    angles: int | Sequence[float],
    path: "str | os.PathLike[str]",
    *,
    mechanism: str | None = None,
    speed: SpeedWanted = "constant",
    force: bool = False,
) -> None:
    """Write positions and polygons as DXF.

    Parameters
    ----------
    machine : Machine
    angles : int or sequence of float
        How many, evenly over a turn, or which crank angles. [deg]
    path : str or path-like
    mechanism : str, optional
        Its name; the first slave of throw 1, or the first mechanism, unless given.
    speed : SpeedWanted
        As `cranktrain.run` takes it.
    force : bool
        Replace a file that is there.

    Raises
    ------
    InputError
        If ezdxf is not installed, or the file cannot be written.
    """
    refuse(lacking_for(".dxf"))
    write_whole(path, _pieces(machine, angles, mechanism, speed), force=force)


def _pieces(
    machine: Machine, angles: int | Sequence[float], mechanism: str | None, speed: SpeedWanted
) -> Iterator[str]:
    """Draw and give the file's text."""
    ezdxf = imported("ezdxf", ".dxf")
    before = ezdxf.options.write_fixed_meta_data_for_testing
    ezdxf.options.write_fixed_meta_data_for_testing = True  # else the time and a random name make each file another
    try:
        document = ezdxf.new("R2010", setup=True, units=4)
        _draw_all(document, machine, angles, mechanism, speed_over_cycle(machine, speed))
        content = StringIO()
        document.write(content)
    finally:
        ezdxf.options.write_fixed_meta_data_for_testing = before
    yield content.getvalue()


def _draw_all(
    document: Document,
    machine: Machine,
    angles: int | Sequence[float],
    mechanism: str | None,
    curve: SpeedCurve | None,
) -> None:
    """Positions about the shaft centre; to the right of them the velocities' polygons, then the accelerations'."""
    chain = drive_chain(machine)
    for layer in (*LAYERS, "DRIVE") if chain else LAYERS:
        document.layers.add(layer, color=_COLOURS[layer])
    space = document.modelspace()
    loads = shown_loads(machine, places_called(machine, mechanism), curve or "constant")
    beside = None if loads is None else loads.outline
    drawn = position_plan(machine, 180, mechanism=mechanism, room=_ROOM, beside=beside).scale
    plan = rescaled(position_plan(machine, angles, mechanism=mechanism, room=_ROOM), drawn)
    sketch = positions_sketch(plan, track(machine, drawn, mechanism=mechanism), loads=loads)
    scale = sketch.scale
    document.header["$LTSCALE"] = 4.0 * scale
    _draw(space, sketch, np.zeros(2))
    _dimensions(space, plan)
    lowest, corner = bounds_of(sketch.outline())
    if curve is not None:
        _write(space, speed_words(curve), corner + scale * np.array([30.0, 14.0]), _TEXT * scale)
    for number, polygons_of in enumerate((velocity_polygons, acceleration_polygons)):
        polygons = polygons_of(machine, angles, mechanism=mechanism, room=_PLAN_ROOM, speed=curve or "constant")
        for i, polygon in enumerate(polygons):
            column = number * -(-len(polygons) // _ROWS) + i // _ROWS
            step = [30.0 + column * (_PLAN_ROOM[0] + _GAP), -(i % _ROWS) * (_PLAN_ROOM[1] + _GAP)]
            _polygon(space, polygon, corner + scale * np.array(step), scale)
    if chain:
        left = np.array([lowest[0] - scale * (_ROOM[0] + _GAP), corner[1]])
        _drive(space, chain, crank_pin(machine, mechanism) or "", left, scale)


def _drive(space: Modelspace, chain: Sequence[DriveShaft], pin: str, corner: Array, scale: float) -> None:
    """Draw the drive's chain below a corner, as large beside the metal as it is on paper, and write its table below."""
    parts = chain_drawing(chain, _ROOM[0], pin)
    low, high = bounds_of_chain(parts)
    for part in parts:
        _draw(space, part.sketch, corner - scale * np.array([low[0], high[1]]), scale)
    if pin == "O":
        _draw(space, Sketch(scale, circles=crank_mark(np.zeros(2), scale)), np.zeros(2))
    rows = ["   ".join(filter(None, row.cells)) for row in drive_rows(chain, pin, _TABLE)]
    for number, words in enumerate([*rows, *meanings(chain, _TABLE)]):
        down = high[1] - low[1] + 10.0 + 2 * _TEXT * number
        _write(space, words, corner - scale * np.array([0.0, down]), _TEXT * scale)


def _dimensions(space: Modelspace, plan: PositionPlan) -> None:
    """Dimension the links in the first position."""
    scale = 1e3 * plan.scale
    pins = {name: scale * pin[:, 0] for name, pin in plan.drawing.positions.items()}
    manner = {
        "dimtxt": _TEXT * scale,
        "dimasz": _TEXT * scale,
        "dimexo": scale,
        "dimexe": scale,
        "dimlfac": 1.0,  # the library's own style shows metres in centimetres
        "dimdec": 3,
        "dimzin": 8,
    }
    for link in plan.drawing.links:
        for name in link.pins[1:]:
            start, end = pins[link.pins[0]], pins[name]
            if np.hypot(*(end - start)) > _TEXT * scale:
                space.add_aligned_dim(
                    pair(start), pair(end), 8.0 * scale, override=manner, dxfattribs={"layer": "DIMENSIONS"}
                ).render()


def _polygon(space: Modelspace, polygon: Polygon, corner: Array, scale: float) -> None:
    """Draw a polygon as large beside the metal as it is on paper, and say what a millimetre of it is."""
    sketch = polygon_sketch(polygon)
    low, high = bounds_of(sketch.outline())
    _draw(space, sketch, corner - scale * np.array([low[0], high[1]]), scale)
    shown = scale_for(polygon.unit, 0.0)
    words = f"φ = {polygon.angle:g}°: 1 mm = {plain(float(shown.of(polygon.scale / scale)))} {shown.label}"
    _write(space, words, corner + scale * np.array([0.0, 6.0]), _TEXT * scale)


def _draw(space: Modelspace, sketch: Sketch, origin: Array, factor: float = 1.0) -> None:
    """Draw a sketch, `factor` times as large, its origin at a point."""
    for line in sketch.lines:
        manner = _manner(line)
        for part in _parts(origin[:, np.newaxis] + factor * line.points):
            space.add_lwpolyline([pair(point) for point in part.T], close=line.is_closed, dxfattribs=manner)
    for circle in sketch.circles:
        space.add_circle(pair(origin + factor * circle.centre), factor * circle.radius, dxfattribs=_manner(circle))
    for label in sketch.labels:
        height = _TEXT * sketch.scale * factor
        corner = origin + factor * label.position - height * np.array([0.3 * len(label.text), 0.5])
        _write(space, label.text, corner, height)


def _manner(part: Line | Circle) -> dict[str, str]:
    """Layer and line type of a part."""
    return {"layer": part.layer, "linetype": _LINE_TYPES.get(part.habit, "BYLAYER")}


def _parts(points: Array) -> Iterator[Array]:
    """Divide a polyline where NaN stands."""
    gaps = np.flatnonzero(np.isnan(points[0]))
    for part in np.split(points, gaps, axis=1):
        kept = part[:, ~np.isnan(part[0])]
        if kept.shape[1] > 1:
            yield kept


def _write(space: Modelspace, words: str, place: Array, height: float) -> None:
    # In DXF a caret begins a control code, and so do two signs of percent.
    plain = visible(words.replace("^2", "²").replace("^", " ").replace("%%", "% %"))
    space.add_text(plain, height=height, dxfattribs={"layer": "TEXT"}).set_placement(pair(place))
