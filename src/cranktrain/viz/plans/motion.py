"""Sheets of plans: polygons of velocities and accelerations, Klein's construction, each with its numbers."""

from collections.abc import Callable, Iterator, Sequence

import numpy as np

from cranktrain.analysis import SpeedWanted, speed_over_cycle
from cranktrain.language import said as _
from cranktrain.layout.speed import SpeedCurve
from cranktrain.machine import Machine
from cranktrain.panels.figures import column, figure, rounded
from cranktrain.panels.formulas import mathematics
from cranktrain.plans.klein import Klein, klein
from cranktrain.plans.polygons import Polygon, acceleration_polygons, velocity_polygons
from cranktrain.plans.position_table import PositionColumn, output_columns
from cranktrain.plans.positions import (
    closed_angles,
    fitting,
    position_plan,
    rescaled,
    single_plans,
)
from cranktrain.plans.shown_loads import shown_loads
from cranktrain.plans.together import places_called
from cranktrain.plans.vectors import PolygonVector
from cranktrain.saying.scales import Scale, scale_for
from cranktrain.viz.paper.page import LINE, Box, Figure, Page, drawing_settings
from cranktrain.viz.paper.tables import LEAST_ROW, ROW
from cranktrain.viz.plans.position_rows import N_HEADS, position_rows
from cranktrain.viz.plans.positions import draw_positions, output_notes
from cranktrain.viz.plans.sheet import (
    VECTOR_COLUMNS,
    WITH_TABLE,
    cells_of,
    centre,
    centre_at_angle,
    few_angles,
    length_scale,
    plan_page,
    row_height,
    scale_of,
    write_beside,
    write_scales,
)
from cranktrain.viz.plans.sketches import klein_sketch, polygon_sketch, positions_sketch

_STRIP = 104.0
"""Width of the mechanism and its table beside many polygons. [mm]"""

_NAMED = 12
"""Of more polygons the corners between parts of a vector have no names."""

_COLUMNS = 5
"""Beside number and angle in a table of that width."""


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
    room = (width - (22.0 if has_table else 16.0), cell.height - (18.0 if has_table else 16.0))
    polygons = polygons_of(machine, angles, mechanism=mechanism, room=room, is_lettered=True, speed=curve or "constant")
    scales = [scale_of(polygons[0].quantity[0], polygons[0].scale, scale_for(polygons[0].unit, 0.0))]
    if has_table:
        scales.append(_beside(page, machine, polygons, cells, mechanism, curve))
    else:
        for number, (polygon, place) in enumerate(zip(polygons, cells, strict=True)):
            sketch = polygon_sketch(polygon, with_symbols=False, with_corners=n <= _NAMED)
            centre_at_angle(page, polygon.angle, sketch, place, 6.0, f"{number}:  ")
        scales.append(_strip(page, machine, polygons, box, mechanism, curve))
    write_scales(page, box, scales, None)
    return page.figure


def _beside(
    page: Page,
    machine: Machine,
    polygons: Sequence[Polygon],
    cells: Sequence[Box],
    mechanism: str | None,
    curve: SpeedCurve | None,
) -> str:
    """Draw mechanism, polygon and table side by side for each angle; say the mechanism's scale."""
    first = 0.30 * cells[0].width
    room = (first - 14.0, cells[0].height - 20.0)
    loads = shown_loads(machine, places_called(machine, mechanism), curve or "constant")
    beside = None if loads is None else loads.outline
    angles = [polygon.angle for polygon in polygons]
    plans = single_plans(machine, angles, mechanism=mechanism, room=room, beside=beside)
    for plan, polygon, cell in zip(plans, polygons, cells, strict=True):
        centre_at_angle(page, polygon.angle, positions_sketch(plan, loads=loads), cell._replace(width=first))
        middle = Box(cell.left + first, cell.bottom, 0.38 * cell.width, cell.height - 2.0)
        centre(page, polygon_sketch(polygon), middle)
        rows, line = _fitting_rows(polygon, cell.height)
        left_out = len(polygon.vectors) + 1 - len(rows)
        notes = [_("without {n} vectors between pins", n=left_out)] if left_out else []
        start = middle.left + middle.width + 4.0
        write_beside(page, cell, start, rows, notes, shares=VECTOR_COLUMNS, line=line, gap=0.0)
    return length_scale(plans[0].scale)


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
    first, *others = places
    n_more = 0 if others else _COLUMNS - len(output_columns(machine, first, angles))
    more = list(_link_columns(polygons))[:n_more]
    rows = list(position_rows(machine, places, angles, curve, more))
    line = row_height([len(rows)], 0.66 * box.height)
    high = line * len(rows) + 8.0 + LINE * 3
    upper = Box(box.left, box.bottom + high, _STRIP, box.height - high)
    room = (upper.width - 18.0, upper.height - 18.0)
    loads = shown_loads(machine, places, curve or "constant")
    beside = None if loads is None else loads.outline
    whole = position_plan(machine, 180, mechanism=mechanism, room=room, beside=beside).scale
    plan = rescaled(position_plan(machine, angles.tolist(), mechanism=mechanism, room=room, is_lettered=True), whole)
    draw_positions(page, machine, plan, mechanism, upper, loads)
    notes = output_notes(machine, plan, places)
    lower = Box(box.left, box.bottom, _STRIP, high)
    write_beside(page, lower, box.left, rows, notes, line=line, n_heads=N_HEADS)
    return length_scale(whole)


def _link_columns(polygons: Sequence[Polygon]) -> Iterator[PositionColumn]:
    """Sizes of the vectors between pins that every polygon has; of accelerations their parts."""
    parts = ("relative",) if polygons[0].quantity == "velocity" else ("normal", "tangential", "coriolis")
    for number, vector in enumerate(polygons[0].vectors):
        if vector.part in parts and all(_symbol_at(polygon, number) == vector.symbol for polygon in polygons):
            sizes = np.array([polygon.vectors[number].size for polygon in polygons])
            yield PositionColumn(mathematics(vector.symbol), polygons[0].unit, sizes)


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
    scales = [length_scale(metre), *(scale_of(letter, rate * metre, unit) for letter, (rate, unit) in rates)]
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
    shown = scale_for(polygon.unit, 0.0)
    yield (_("vector"), _("from, to"), "mm", shown.label)
    for vector, size in zip(vectors, column([vector.size for vector in vectors], shown), strict=True):
        ends = f"{mathematics(vector.start)} {mathematics(vector.end)}"
        yield (mathematics(vector.symbol), ends, rounded(polygon.length(vector)), size)


def _klein_rates(machine: Machine) -> tuple[tuple[float, Scale], tuple[float, Scale]]:
    """What a metre of Klein's construction is of velocity, and of acceleration, each with its unit."""
    speed = machine.main_shaft.speed
    rates = (1.0, 1.0) if speed is None else (speed.si, speed.si**2)
    units = ("m/rad", "m/rad^2") if speed is None else ("m/s", "m/s^2")
    velocity, acceleration = ((rate, scale_for(unit, 0.0)) for rate, unit in zip(rates, units, strict=True))
    return velocity, acceleration


def _klein_table(machine: Machine, construction: Klein) -> Iterator[tuple[str, ...]]:
    """What Klein's construction gives: lengths, and the velocities and accelerations that they are."""
    velocity, acceleration = _klein_rates(machine)
    drawn = scale_for("m", 0.0)
    yield (_("line"), _("length, {unit}", unit=drawn.label), _("is"), _("size"), _("unit"))
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
        yield (ends, figure(float(drawn.of(length))), mathematics(symbol), figure(unit.of(rate * length)), unit.label)


def _klein_notes(construction: Klein) -> Iterator[str]:
    """What else there is to say of Klein's construction."""
    yield _("Turned by 90° in the sense of running, OAC is the plan of velocities;")
    yield _("turned by 180°, OADN that of accelerations.")
    shown = scale_for("m", 0.0)
    x, y = map(figure, shown.of(construction.centre).tolist())
    if np.all(np.isfinite(construction.centre)):
        yield _("Instant centre of the rod: X = {x}, Y = {y} {unit}", x=x, y=y, unit=shown.label)
