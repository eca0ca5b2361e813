"""Sheets of plans: positions, polygons of velocities and accelerations, Klein's construction, each with its numbers."""

import itertools
from collections.abc import Callable, Iterator, Sequence

import numpy as np

from cranktrain.analysis import SpeedWanted, speed_over_cycle
from cranktrain.language import _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.layout.speed_curve import SpeedCurve
from cranktrain.machine import Machine
from cranktrain.plans.klein import Klein, klein
from cranktrain.plans.lettering import lettered
from cranktrain.plans.polygons import Polygon, acceleration_polygons, velocity_polygons
from cranktrain.plans.position_table import Column, output_columns
from cranktrain.plans.positions import (
    PositionPlan,
    chosen_scale,
    closed_angles,
    fitting,
    position_plan,
    rescaled,
    single_plans,
    track,
)
from cranktrain.plans.together import places_called
from cranktrain.plans.vectors import PolygonVector, spoken_name
from cranktrain.viz.figures import figure
from cranktrain.viz.paper.detail import draw_detail, is_too_small
from cranktrain.viz.paper.page import LINE, Box, Figure, Page, drawing_settings, mathematics
from cranktrain.viz.paper.sketch import Sketch
from cranktrain.viz.paper.tables import LEAST_ROW, ROW
from cranktrain.viz.plans.position_rows import N_HEADS, every, point_tables, position_rows
from cranktrain.viz.plans.sheet import (
    VECTOR_COLUMNS,
    WITH_TABLE,
    cells_of,
    centre,
    centre_at_angle,
    few_angles,
    plan_page,
    row_height,
    scale_of,
    unit_words,
    write_beside,
    write_scales,
)
from cranktrain.viz.plans.sketches import klein_sketch, polygon_sketch, positions_sketch

_STRIP = 104.0
"""Width of the mechanism and its table beside many polygons. [mm]"""

_ROOM_FOR_WORDS = 66.0
"""Height of a room from which positions have numbers and a small crank a detail. [mm]"""

_NAMED = 12
"""Of more polygons the corners between parts of a vector have no names."""

_COLUMNS = 5
"""Beside number and angle in a table of that width."""


@drawing_settings()
def plan_positions(
    machine: Machine,
    angles: int | Sequence[float] = 12,
    *,
    mechanism: str | None = None,
    size: str = "A4",
    speed: SpeedWanted = "constant",
    scale: float | None = None,
) -> Figure:
    """Draw a mechanism in several positions, to scale, beside a table of its output, and of points that are followed.

    Parameters
    ----------
    machine : Machine
    angles : int or sequence of float
        How many, evenly over a turn, or which crank angles; 24 at most. [deg]
    mechanism : str, optional
        Its name; the first slave of throw 1, or the first mechanism, unless given.
    size : "A4" or "A3"
    speed : SpeedWanted
        As `cranktrain.run` takes it.
    scale : float, optional
        Millimetres of metal in one of paper, 4 for 1:4; the largest round one that fits, unless given.

    Returns
    -------
    Figure
    """
    curve = speed_over_cycle(machine, speed)
    page, box = plan_page(machine, angles, size, _("Plan of positions"), mechanism, curve=curve)
    places = places_called(machine, mechanism)
    wide = 0.62 * box.width
    left = Box(box.left, box.bottom + 8.0, wide, box.height - 8.0)
    room = (left.width - 22.0, left.height - 22.0)
    metre = chosen_scale(position_plan(machine, 180, mechanism=mechanism, room=room).scale, scale)
    plan = rescaled(position_plan(machine, angles, mechanism=mechanism, room=room, is_lettered=True), metre)
    _draw_positions(page, machine, plan, mechanism, left)
    write_scales(page, box, [scale_of("l", metre, "m")], 1e3 * metre)
    start = box.left + wide + 6.0
    rows = list(position_rows(machine, places, plan.angles, curve))
    tables = [] if len(places) > 1 else list(point_tables(machine, places[0], plan.angles, curve))
    room_for_points = box.height - 20.0 - ROW * len(rows)
    step = next(step for step in itertools.count(1) if _height_of(tables, step) <= room_for_points or step == len(rows))
    tables = [(name, every(table, step)) for name, table in tables]
    manner = {"line": row_height([len(rows), *(len(table) + 1 for _name, table in tables)], box.height - 8.0)}
    below = write_beside(page, box, start, rows, _output_notes(machine, plan, places), n_heads=N_HEADS, **manner)
    for name, table in tables:
        page.heading(start, below - 3.0, _("Point {name}").format(name=spoken_name(name)))
        notes = [_("x, y in the mechanism's own axes; sizes of velocity and acceleration")]
        rest = box._replace(height=below - 5.0 - box.bottom)
        below = write_beside(page, rest, start, table, notes, n_heads=N_HEADS, **manner)
    return page.figure


def _height_of(tables: Sequence[tuple[str, list[tuple[str, ...]]]], step: int) -> float:
    """How high tables of points are with every so manyth of their rows. [mm]"""
    return sum(16.0 + ROW * len(every(table, step)) for _name, table in tables)


def _output_notes(machine: Machine, plan: PositionPlan, places: Sequence[PlacedMechanism]) -> list[str]:
    """Say from where the output counts."""
    if places[0].kind.output != "slider":
        return []
    if not plan.drawing.guides:
        return [_("x in the cylinder, positive toward its head; s from the top")]
    has_speed = machine.main_shaft.speed is not None
    rates = _("s, v, a") if has_speed else _("s and its derivatives")
    if len(places) > 1:
        return [_("{rates} from each piston's own top toward its shaft").format(rates=rates)]
    return [_("x from the shaft along the line of stroke;"), _("{rates} from the top toward it").format(rates=rates)]


def _draw_positions(page: Page, machine: Machine, plan: PositionPlan, mechanism: str | None, room: Box) -> None:
    """Draw the positions with their paths; where the crank is too small to be seen, the shaft once more, larger."""
    metal = 1e3 * plan.scale
    crank = plan.drawing.links[0].pins
    pins = plan.drawing.positions
    radius = metal * float(np.hypot(*(pins[crank[1]] - pins[crank[0]])[:, 0]))
    is_large = room.height > _ROOM_FOR_WORDS
    is_small = is_too_small(radius, metal) and len(plan.angles) > 1 and is_large

    def drawn(scale: float, hidden: Sequence[str] = ()) -> Sketch:
        paths = lettered(track(machine, 1e-3 * scale, mechanism=mechanism))
        return positions_sketch(rescaled(plan, 1e-3 * scale), paths, hidden=hidden, is_lettered=True)

    whole = drawn(metal, crank if is_small else () if is_large else tuple(pins))
    origin = centre(page, whole, room)
    if is_small:
        others = [pin for pin in pins if pin not in crank]
        draw_detail(page, lambda scale: drawn(scale, others), 1.2 * radius, whole, origin, room)


def plan_velocities(
    machine: Machine,
    angles: int | Sequence[float] = (30.0, 60.0),
    *,
    mechanism: str | None = None,
    size: str = "A4",
    speed: SpeedWanted = "constant",
) -> Figure:
    """Draw polygons of velocities; parameters as `plan_positions` takes them."""
    return _polygon_sheet(machine, angles, mechanism, size, speed, velocity_polygons, _("Plan of velocities"))


def plan_accelerations(
    machine: Machine,
    angles: int | Sequence[float] = (30.0, 60.0),
    *,
    mechanism: str | None = None,
    size: str = "A4",
    speed: SpeedWanted = "constant",
) -> Figure:
    """Draw polygons of accelerations; parameters as `plan_positions` takes them."""
    return _polygon_sheet(machine, angles, mechanism, size, speed, acceleration_polygons, _("Plan of accelerations"))


@drawing_settings()
def _polygon_sheet(
    machine: Machine,
    angles: int | Sequence[float],
    mechanism: str | None,
    size: str,
    speed: SpeedWanted,
    polygons_of: Callable[..., tuple[Polygon, ...]],
    title: str,
) -> Figure:
    """Polygons, few of them beside the mechanism and a table of vectors."""
    curve = speed_over_cycle(machine, speed)
    page, box = plan_page(machine, angles, size, title, mechanism, curve=curve)
    n = len(closed_angles(machine, places_called(machine, mechanism), angles))
    has_table = n <= WITH_TABLE
    right = box if has_table else box._replace(left=box.left + _STRIP + 4.0, width=box.width - _STRIP - 4.0)
    cells = cells_of(right, n)
    cell = cells[0]
    width = 0.38 * cell.width if has_table else cell.width
    room = (width - 22.0, cell.height - (18.0 if has_table else 16.0))
    polygons = polygons_of(machine, angles, mechanism=mechanism, room=room, is_lettered=True, speed=curve or "constant")
    scales = [scale_of(polygons[0].quantity[0], polygons[0].scale, unit_words(polygons[0].unit))]
    if has_table:
        scales.append(_beside(page, machine, polygons, cells, mechanism))
    else:
        for number, (polygon, place) in enumerate(zip(polygons, cells, strict=True)):
            sketch = polygon_sketch(polygon, with_symbols=False, with_corners=n <= _NAMED)
            centre_at_angle(page, polygon.angle, sketch, place, 6.0, f"{number}:  ")
        scales.append(_strip(page, machine, polygons, box, mechanism, curve))
    write_scales(page, box, scales, None)
    return page.figure


def _beside(
    page: Page, machine: Machine, polygons: Sequence[Polygon], cells: Sequence[Box], mechanism: str | None
) -> str:
    """Draw mechanism, polygon and table side by side for each angle; say the mechanism's scale."""
    first = 0.30 * cells[0].width
    room = (first - 14.0, cells[0].height - 20.0)
    plans = single_plans(machine, [polygon.angle for polygon in polygons], mechanism=mechanism, room=room)
    for plan, polygon, cell in zip(plans, polygons, cells, strict=True):
        centre_at_angle(page, polygon.angle, positions_sketch(plan), cell._replace(width=first))
        middle = Box(cell.left + first, cell.bottom, 0.38 * cell.width, cell.height - 2.0)
        centre(page, polygon_sketch(polygon), middle)
        rows, line = _fitting_rows(polygon, cell.height)
        left_out = len(polygon.vectors) + 1 - len(rows)
        notes = [_("without {n} vectors between pins").format(n=left_out)] if left_out else []
        start = middle.left + middle.width + 4.0
        write_beside(page, cell, start, rows, notes, shares=VECTOR_COLUMNS, line=line, gap=0.0)
    return scale_of("l", plans[0].scale, "m")


def _strip(
    page: Page,
    machine: Machine,
    polygons: Sequence[Polygon],
    box: Box,
    mechanism: str | None,
    curve: SpeedCurve | None,
) -> str:
    """Draw the mechanism in all positions above a table of its motion, left of many polygons; say its scale."""
    angles = np.array([polygon.angle for polygon in polygons])
    places = places_called(machine, mechanism)
    more = (
        []
        if len(places) > 1
        else list(_link_columns(polygons))[: _COLUMNS - len(output_columns(machine, places[0], angles))]
    )
    rows = list(position_rows(machine, places, angles, curve, more))
    line = row_height([len(rows)], 0.66 * box.height)
    high = line * len(rows) + 8.0 + LINE * 3
    upper = Box(box.left, box.bottom + high, _STRIP, box.height - high)
    room = (upper.width - 18.0, upper.height - 18.0)
    whole = position_plan(machine, 180, mechanism=mechanism, room=room).scale
    plan = rescaled(position_plan(machine, angles.tolist(), mechanism=mechanism, room=room, is_lettered=True), whole)
    _draw_positions(page, machine, plan, mechanism, upper)
    notes = _output_notes(machine, plan, places)
    lower = Box(box.left, box.bottom, _STRIP, high)
    write_beside(page, lower, box.left, rows, notes, line=line, n_heads=N_HEADS)
    return scale_of("l", whole, "m")


def _link_columns(polygons: Sequence[Polygon]) -> Iterator[Column]:
    """Sizes of the vectors between pins that every polygon has; of accelerations their parts."""
    parts = ("relative",) if polygons[0].quantity == "velocity" else ("normal", "tangential", "coriolis")
    for number, vector in enumerate(polygons[0].vectors):
        if vector.part in parts and all(_symbol_at(polygon, number) == vector.symbol for polygon in polygons):
            sizes = np.array([polygon.vectors[number].size for polygon in polygons])
            yield Column(mathematics(vector.symbol), polygons[0].unit, sizes)


def _symbol_at(polygon: Polygon, number: int) -> str:
    """Symbol of a polygon's vector by its number."""
    return polygon.vectors[number].symbol if number < len(polygon.vectors) else ""


@drawing_settings()
def plan_klein(
    machine: Machine, angles: int | Sequence[float] = (60.0,), *, mechanism: str | None = None, size: str = "A4"
) -> Figure:
    """Draw Klein's construction of a slider-crank; parameters as `plan_positions` takes them, two angles at most."""
    chosen = few_angles(angles, _("Klein's construction"))
    constructions = [klein(machine, float(angle), mechanism=mechanism) for angle in chosen]
    page, box = plan_page(machine, angles, size, _("Klein's construction"), constructions[0].mechanism)
    cells = cells_of(box, len(constructions))
    wide = 0.62 * cells[0].width
    room = (wide - 16.0, cells[0].height - 14.0)
    rough = [np.concatenate(list(klein_sketch(one, 1.0).outline()), axis=1) for one in constructions]
    scale = 1e3 * fitting([1e-3 * outline for outline in rough], room)
    for construction, cell in zip(constructions, cells, strict=True):
        centre_at_angle(page, construction.angle, klein_sketch(construction, scale), cell._replace(width=wide), 0.0)
        rows = _klein_table(machine, construction)
        write_beside(page, cell, cell.left + wide + 6.0, rows, _klein_notes(construction))
    metre = 1e-3 * scale
    rates = zip("va", _klein_rates(machine), strict=True)
    scales = [scale_of("l", metre, "m"), *(scale_of(letter, rate * metre, unit) for letter, (rate, unit) in rates)]
    write_scales(page, box, scales, scale)
    return page.figure


def _fitting_rows(polygon: Polygon, height: float) -> tuple[list[tuple[str, ...]], float]:
    """Rows of a table of vectors, and how high each is; without room those between pins are left out, wholes first."""
    is_split = any(vector.part == "normal" for vector in polygon.vectors)
    parts = [vector for vector in polygon.vectors if vector.part != "relative" or not is_split]
    whole = [vector for vector in polygon.vectors if vector.part == "absolute"]
    for vectors in (polygon.vectors, parts, whole):
        line = min(ROW, (height - 12.0) / (len(vectors) + 1))
        if line >= LEAST_ROW:
            break
    return list(_vectors_table(polygon, vectors)), max(line, LEAST_ROW)


def _vectors_table(polygon: Polygon, vectors: Sequence[PolygonVector]) -> Iterator[tuple[str, ...]]:
    """Vectors: where each is, its length on paper and its size."""
    yield (_("vector"), _("from, to"), "mm", unit_words(polygon.unit))
    for vector in vectors:
        ends = f"{mathematics(vector.start)} {mathematics(vector.end)}"
        yield (mathematics(vector.symbol), ends, f"{polygon.length(vector):.2f}", figure(vector.size))


def _klein_rates(machine: Machine) -> tuple[tuple[float, str], tuple[float, str]]:
    """What a metre of Klein's construction is of velocity, and of acceleration, each with its unit."""
    speed = machine.main_shaft.speed
    return ((1.0, "m/rad"), (1.0, "m/rad²")) if speed is None else ((speed.si, "m/s"), (speed.si**2, "m/s²"))


def _klein_table(machine: Machine, construction: Klein) -> Iterator[tuple[str, ...]]:
    """What Klein's construction gives: lengths, and the velocities and accelerations that they are."""
    velocity, acceleration = _klein_rates(machine)
    yield (_("line"), _("length, mm"), _("is"), _("size"), _("unit"))
    lines = (
        ("OA", "v_A", velocity),
        ("AC", "v_BA", velocity),
        ("OC", "v_B", velocity),
        ("OA", "a_A", acceleration),
        ("AD", "a_BA^n", acceleration),
        ("DN", "a_BA^t", acceleration),
        ("ON", "a_B", acceleration),
    )
    for ends, symbol, (rate, unit) in lines:
        start, end = (construction.points[letter] for letter in ends)
        length = float(np.hypot(*(end - start)))
        yield (ends, f"{1e3 * length:.3f}", mathematics(symbol), figure(rate * length), unit)


def _klein_notes(construction: Klein) -> Iterator[str]:
    """What else there is to say of Klein's construction."""
    yield _("Turned by 90° in the sense of running, OAC is the plan of velocities;")
    yield _("turned by 180°, OADN that of accelerations.")
    x, y = 1e3 * construction.centre
    if np.isfinite(x):
        yield _("Instant centre of the rod: X = {x}, Y = {y} mm").format(x=figure(x), y=figure(y))
