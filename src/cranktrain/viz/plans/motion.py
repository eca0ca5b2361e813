"""Sheets of plans: positions, polygons of velocities and accelerations, Klein's construction, each with its numbers."""

from collections.abc import Callable, Iterator, Sequence

import numpy as np

from cranktrain.analysis import SpeedWanted, speed_over_cycle
from cranktrain.language import _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.layout.speed import rates
from cranktrain.layout.speed_curve import SpeedCurve
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.plans.klein import Klein, klein
from cranktrain.plans.lettering import lettered
from cranktrain.plans.placement import output_motion
from cranktrain.plans.polygons import Polygon, acceleration_polygons, velocity_polygons
from cranktrain.plans.positions import (
    PositionPlan,
    closed_angles,
    plan_angles,
    position_plan,
    rescaled,
    rounded_scale,
    track,
)
from cranktrain.plans.together import places_called
from cranktrain.plans.turning import turning
from cranktrain.plans.vectors import Vector
from cranktrain.quantities import shown
from cranktrain.viz.figures import figure
from cranktrain.viz.paper.page import INDICES, Box, Figure, Page, drawing_settings, mathematics, muted
from cranktrain.viz.paper.tables import LEAST_ROW, ROW, write_table
from cranktrain.viz.plans.sheet import (
    VECTOR_COLUMNS,
    WITH_TABLE,
    cells_of,
    centre,
    few_angles,
    plan_page,
    scale_of,
    unit_words,
    write_scales,
)
from cranktrain.viz.plans.sketches import klein_sketch, polygon_sketch, positions_sketch


@drawing_settings()
def plan_positions(
    machine: Machine,
    angles: int | Sequence[float] = 12,
    *,
    mechanism: str | None = None,
    size: str = "A4",
    speed: SpeedWanted = "constant",
) -> Figure:
    """Draw a mechanism in several positions, to scale, beside a table of its output.

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

    Returns
    -------
    Figure
    """
    curve = speed_over_cycle(machine, speed)
    is_single = len(plan_angles(angles)) == 1  # pins of several positions have numbers instead of letters
    title = _("Plan of positions")
    page, box = plan_page(machine, angles, size, title, mechanism, has_key=is_single, curve=curve)
    places = places_called(machine, mechanism)
    wide = (0.62 if len(places) == 1 else 0.42) * box.width
    left = Box(box.left, box.bottom + 8.0, wide, box.height - 8.0)
    room = (left.width - 22.0, left.height - 22.0)
    scale = position_plan(machine, 180, mechanism=mechanism, room=room).scale
    plan = rescaled(position_plan(machine, angles, mechanism=mechanism, room=room, is_lettered=True), scale)
    centre(page, positions_sketch(plan, lettered(track(machine, scale, mechanism=mechanism))), left)
    write_scales(page, box, [scale_of("l", scale, "m")], 1e3 * scale)
    rows = list(_positions_table(machine, plan, curve))
    start = box.left + wide + 8.0
    end = write_table(page, rows, (start, box.bottom + box.height, box.left + box.width - start))
    if places[0].kind.output == "slider":
        counted = (
            _("from the shaft along the line of stroke, positive away from it")
            if plan.drawing.guides
            else _("in the cylinder, positive toward its head")
        )
        page.text(start, end - 2.0, counted, **muted())
    return page.figure


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
    cells = list(cells_of(box, n))
    has_table = n <= WITH_TABLE
    cell = cells[0]
    width = 0.38 * cell.width if has_table else cell.width
    room = (width - 22.0, cell.height - (18.0 if has_table else 16.0))
    polygons = polygons_of(machine, angles, mechanism=mechanism, room=room, is_lettered=True, speed=curve or "constant")
    symbol = "v" if polygons[0].quantity == "velocity" else "a"
    scales = [scale_of(symbol, polygons[0].scale, unit_words(polygons[0].unit))]
    if has_table:
        scales.append(_beside(page, machine, polygons, cells, mechanism))
    else:
        for polygon, place in zip(polygons, cells, strict=True):
            page.heading(place.left, place.bottom + place.height - 4.0, f"φ = {polygon.angle:g}°")
            centre(page, polygon_sketch(polygon, with_symbols=False), place._replace(height=place.height - 6.0))
    write_scales(page, box, scales, None)
    return page.figure


def _beside(
    page: Page, machine: Machine, polygons: Sequence[Polygon], cells: Sequence[Box], mechanism: str | None
) -> str:
    """Draw mechanism, polygon and table side by side for each angle; say the mechanism's scale."""
    first = 0.30 * cells[0].width
    room = (first - 14.0, cells[0].height - 20.0)
    plans = [
        position_plan(machine, [polygon.angle], mechanism=mechanism, room=room, is_lettered=True)
        for polygon in polygons
    ]
    scale = max(plan.scale for plan in plans)
    for plan, polygon, cell in zip(plans, polygons, cells, strict=True):
        page.heading(cell.left, cell.bottom + cell.height - 4.0, f"φ = {polygon.angle:g}°")
        left = Box(cell.left, cell.bottom, first, cell.height - 5.0)
        centre(page, positions_sketch(rescaled(plan, scale)), left)
        middle = Box(cell.left + first, cell.bottom, 0.38 * cell.width, cell.height - 2.0)
        centre(page, polygon_sketch(polygon), middle)
        start = middle.left + middle.width + 4.0
        rows, line = _fitting_rows(polygon, cell.height)
        end = (start, cell.bottom + cell.height, cell.left + cell.width - start)
        foot = write_table(page, rows, end, VECTOR_COLUMNS, line)
        left_out = len(polygon.vectors) + 1 - len(rows)
        if left_out:
            page.text(start, foot, _("without {n} vectors between pins").format(n=left_out), **muted())
    return scale_of("l", scale, "m")


@drawing_settings()
def plan_klein(
    machine: Machine, angles: int | Sequence[float] = (60.0,), *, mechanism: str | None = None, size: str = "A4"
) -> Figure:
    """Draw Klein's construction of a slider-crank; parameters as `plan_positions` takes them, two angles at most."""
    chosen = few_angles(angles, _("Klein's construction"))
    constructions = [klein(machine, float(angle), mechanism=mechanism) for angle in chosen]
    page, box = plan_page(machine, angles, size, _("Klein's construction"), constructions[0].mechanism)
    cells = list(cells_of(box, len(constructions)))
    wide = 0.62 * cells[0].width
    room = (wide - 16.0, cells[0].height - 14.0)
    rough = [klein_sketch(construction, 1.0).bounds() for construction in constructions]
    spans = [max((b[1] - b[0]) / room[0], (b[3] - b[2]) / room[1]) for b in rough]
    scale = 1e3 * rounded_scale(1e-3 * max(spans))
    for construction, cell in zip(constructions, cells, strict=True):
        page.heading(cell.left, cell.bottom + cell.height - 4.0, f"φ = {construction.angle:g}°")
        centre(page, klein_sketch(construction, scale), cell._replace(width=wide))
        rows = list(_klein_table(machine, construction))
        start = cell.left + wide + 6.0
        end = write_table(page, rows, (start, cell.bottom + cell.height, cell.left + cell.width - start))
        page.notes(start, end - 2.0, _klein_notes(construction))
    speed = machine.main_shaft.speed
    omega = 1.0 if speed is None else speed.si
    units = ("m/rad", "m/rad²") if speed is None else ("m/s", "m/s²")
    metre = 1e-3 * scale
    scales = [
        scale_of("l", metre, "m"),
        scale_of("v", omega * metre, units[0]),
        scale_of("a", omega**2 * metre, units[1]),
    ]
    write_scales(page, box, scales, scale)
    return page.figure


def _positions_table(machine: Machine, plan: PositionPlan, curve: SpeedCurve | None) -> Iterator[tuple[str, ...]]:
    """Number, crank angle and motion of the output in each position; of opposed pistons both."""
    places = places_called(machine, plan.mechanism)
    columns = [
        (_indexed(name, i) if len(places) > 1 else name, values)
        for i, place in enumerate(places)
        for name, values in _output_columns(machine, place, plan, curve)
    ]
    yield (_("no."), "φ, °", *(name for name, _values in columns))
    for i, angle in enumerate(plan.angles):
        yield (f"{i}", f"{angle:g}", *(figure(float(values[i])) for _name, values in columns))


def _indexed(head: str, i: int) -> str:
    """Head of a column of one of several mechanisms: x₂, mm."""
    symbol, comma, unit = head.partition(",")
    return f"{symbol}{str(i + 1).translate(INDICES)}{comma}{unit}"


def _output_columns(
    machine: Machine, place: PlacedMechanism, plan: PositionPlan, curve: SpeedCurve | None
) -> Iterator[tuple[str, Array]]:
    """Heads and values of the motion of a place's output."""
    has_speed = machine.main_shaft.speed is not None or curve is not None
    angle = np.deg2rad(plan.angles)
    drive = turning(machine, curve, angle + machine.zero)
    moving = output_motion(machine, place, angle)
    motion = (moving.value, *rates(moving, drive))
    if place.kind.output == "slider":
        names = ("x, mm", "v, m/s", "a, m/s²") if has_speed else ("x, mm", "x′, mm/rad", "x″, mm/rad²")
        factors = (1e3, 1.0, 1.0) if has_speed else (1e3, 1e3, 1e3)
    else:
        names = ("θ, °", "ω₃, rad/s", "ε₃, rad/s²") if has_speed else ("θ, °", "θ′", "θ″")
        factors = (shown(1.0, "deg"), 1.0, 1.0)
    yield from ((name, factor * part) for name, factor, part in zip(names, factors, motion, strict=True))


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


def _vectors_table(polygon: Polygon, vectors: Sequence[Vector]) -> Iterator[tuple[str, ...]]:
    """Vectors: where each is, its length on paper and its size."""
    yield (_("vector"), _("from, to"), "mm", unit_words(polygon.unit))
    for vector in vectors:
        ends = f"{mathematics(vector.start)} {mathematics(vector.end)}"
        yield (mathematics(vector.symbol), ends, f"{polygon.length(vector):.2f}", figure(vector.size))


def _klein_table(machine: Machine, construction: Klein) -> Iterator[tuple[str, ...]]:
    """What Klein's construction gives: lengths, and the velocities and accelerations that they are."""
    speed = machine.main_shaft.speed
    omega = 1.0 if speed is None else speed.si
    units = ("m/rad", "m/rad²") if speed is None else ("m/s", "m/s²")
    origin = np.zeros(2)
    yield (_("line"), _("length, mm"), _("is"), _("size"), _("unit"))
    lines = (
        ("OA", origin, construction.A, "v_A", 1),
        ("AC", construction.A, construction.C, "v_BA", 1),
        ("OC", origin, construction.C, "v_B", 1),
        ("OA", origin, construction.A, "a_A", 2),
        ("AD", construction.A, construction.D, "a_BA^n", 2),
        ("DN", construction.D, construction.N, "a_BA^t", 2),
        ("ON", origin, construction.N, "a_B", 2),
    )
    for name, start, end, symbol, power in lines:
        length = float(np.hypot(*(end - start)))
        yield (name, f"{1e3 * length:.3f}", mathematics(symbol), figure(omega**power * length), units[power - 1])


def _klein_notes(construction: Klein) -> Iterator[str]:
    """What else there is to say of Klein's construction."""
    yield _("Turned by 90° in the sense of running, OAC is the plan of velocities;")
    yield _("turned by 180°, OADN that of accelerations.")
    x, y = 1e3 * construction.centre
    if np.isfinite(x):
        yield _("Instant centre of the rod: X = {x}, Y = {y} mm").format(x=figure(x), y=figure(y))
