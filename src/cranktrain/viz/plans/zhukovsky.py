"""Sheet of Zhukovsky's lever: the mechanism, the turned plan of velocities with the forces, and their moments."""

from collections.abc import Callable, Iterator, Mapping, Sequence

import numpy as np

from cranktrain.analysis import SpeedWanted, speed_over_cycle
from cranktrain.errors import InputError, Problem
from cranktrain.language import said as _
from cranktrain.machine import Machine
from cranktrain.panels.figures import column
from cranktrain.panels.formulas import mathematics
from cranktrain.plans.acting import symbols_together
from cranktrain.plans.lettering import pin_letters
from cranktrain.plans.placement import place_called, placed
from cranktrain.plans.polygons import Polygon, velocity_polygons
from cranktrain.plans.positions import rounded_scale, single_plans
from cranktrain.plans.shown_loads import shown_loads
from cranktrain.plans.vectors import POLE, angle_of, pair, spoken_name, turned_left
from cranktrain.plans.zhukovsky import LeverForce, ZhukovskyLever, zhukovsky_lever
from cranktrain.saying.scales import Scale, scale_for
from cranktrain.saying.wording import power_of_ten
from cranktrain.viz.paper.page import LINE, Box, Figure, drawing_settings
from cranktrain.viz.paper.sketch import Circle, Line, Sketch, Wish, bounds_of, placed_labels, together
from cranktrain.viz.paper.style import MUTED
from cranktrain.viz.paper.tables import LEAST_ROW, ROW
from cranktrain.viz.plans.forces import too_many_words
from cranktrain.viz.plans.sheet import (
    cells_of,
    centre,
    centre_at_angle,
    few_angles,
    length_scale,
    plan_page,
    scale_of,
    write_beside,
    write_scales,
)
from cranktrain.viz.plans.sketches import arrow, positions_sketch

_LONGEST = 0.30
"""The longest force, in parts of the room: the rest is the plan's."""

_NAMED = 2.0
"""A force shorter than this stands in the table alone. [mm]"""

_ONE_POINT = 0.7
"""A point nearer to another one has no name of its own. [mm]"""

_TO_A_LINE = 8
"""Symbols side by side below a table."""

_NOTES = 22.0
"""Height of the notes below the mechanism. [mm]"""

_PASSES, _SPARE = 4, 1.05
"""How often a plan of velocities is made smaller, and by how much more than it is too large."""

_HEAD = 6.0
"""Height of a table's head. [mm]"""

_COLUMNS = (0.26, 0.62, 1.0)


@drawing_settings()
def plan_zhukovsky(
    machine: Machine,
    angles: int | Sequence[float] = (30.0,),
    *,
    mechanism: str | None = None,
    size: str = "A4",
    speed: SpeedWanted = "constant",
) -> Figure:
    """Draw Zhukovsky's lever; parameters as `plan_forces` takes them, two angles at most."""
    chosen = [float(angle) for angle in few_angles(angles, _("Zhukovsky's lever"))]
    curve = speed_over_cycle(machine, speed)
    turning = curve or "constant"
    levers = [zhukovsky_lever(machine, angle, mechanism=mechanism, speed=turning) for angle in chosen]
    mechanism = levers[0].mechanism
    place = place_called(machine, mechanism)
    loads = shown_loads(machine, [place], turning)
    beside = None if loads is None else loads.outline
    symbols = None if loads is None else symbols_together(loads.at(np.zeros(1)), [place])
    letters = pin_letters(placed(machine, place, np.zeros(1)))
    page, box = plan_page(machine, angles, size, _("Zhukovsky's lever"), mechanism, curve=curve)
    cells = cells_of(box, len(chosen))
    left, middle = 0.26 * box.width, 0.46 * box.width
    height = cells[0].height
    room = ((1 - 2 * _LONGEST) * middle + 6.0, max((1 - 2 * _LONGEST) * height, 0.4 * height) - 4.0)

    def polygons_in(room: tuple[float, float]) -> Sequence[Polygon]:
        return velocity_polygons(machine, chosen, mechanism=mechanism, room=room, is_lettered=True, speed=turning)

    polygons = polygons_in(room)
    longest = max(_longest(lever, polygon) for lever, polygon in zip(levers, polygons, strict=True))
    unit = scale_for("N", longest)
    # Where nothing acts any scale will do.
    newton = rounded_scale((longest or 1.0) / (_LONGEST * min(middle, height)), one=unit.one)
    polygons = _with_room(levers, polygons, newton, polygons_in, (room, (middle, height - 4.0)))
    room = (left - 14.0, height - 20.0 - _NOTES)
    plans = single_plans(machine, chosen, mechanism=mechanism, room=room, beside=beside)
    for plan, lever, polygon, cell in zip(plans, levers, polygons, cells, strict=True):
        own = cell._replace(bottom=cell.bottom + _NOTES, width=left, height=height - _NOTES)
        centre_at_angle(page, lever.angle, positions_sketch(plan, loads=loads, said=symbols), own)
        page.notes(cell.left, cell.bottom + _NOTES - 4.0, _notes(lever))
        centre(page, lever_sketch(lever, polygon, newton), Box(cell.left + left, cell.bottom, middle, height - 4.0))
        rows = list(_table(lever, letters, unit))
        notes = list(_short_words(lever, newton))
        line = min(ROW, (height - _HEAD - LINE * len(notes)) / len(rows))
        if line < LEAST_ROW:
            raise InputError([Problem("", lever.mechanism, too_many_words(len(chosen), size))])
        start = cell.left + left + middle + 6.0
        write_beside(page, cell, start, rows, notes, shares=_COLUMNS, line=line, gap=0.0)
    velocity = scale_of("v", polygons[0].scale, scale_for(polygons[0].unit, 0.0))
    write_scales(page, box, [length_scale(plans[0].scale), velocity, scale_of("F", newton, unit)], None)
    words = _("Velocities turned by 90° clockwise: a force's anticlockwise moment about p is its power")
    page.text(box.left + left, box.bottom + 4.4, words, color=MUTED)
    return page.figure


def _with_room(
    levers: Sequence[ZhukovskyLever],
    polygons: Sequence[Polygon],
    newton: float,
    polygons_in: Callable[[tuple[float, float]], Sequence[Polygon]],
    rooms: tuple[tuple[float, float], tuple[float, float]],
) -> Sequence[Polygon]:
    """Make plans of velocities smaller until there is room for forces whose points lie far out; rooms are of both."""
    own, whole = rooms
    for _pass in range(_PASSES):
        sketches = [lever_sketch(lever, polygon, newton) for lever, polygon in zip(levers, polygons, strict=True)]
        sizes = [np.subtract(*reversed(bounds_of(sketch.outline()))) for sketch in sketches]
        excess = float(np.max(np.stack(sizes) / np.array(whole)))
        if excess <= 1.0:
            break
        own = own[0] / (_SPARE * excess), own[1] / (_SPARE * excess)
        polygons = polygons_in(own)
    return polygons


def _longest(lever: ZhukovskyLever, polygon: Polygon) -> float:
    """Size of the lever's largest force, with the balancing one. [N]"""
    forces = [*(force for force in lever.forces if force.point), _balancing(lever, polygon)]
    return max(float(np.hypot(*force.value)) for force in forces)


def lever_sketch(lever: ZhukovskyLever, polygon: Polygon, newton: float) -> Sketch:
    """Turned plan of velocities in drawing millimetres with the forces at its points, to newton N in one of them."""
    sketch = Sketch(1.0)
    points = {name: -turned_left(np.array(point)) for name, point in polygon.points.items()}
    for vector in polygon.vectors:
        ends = np.stack([points[vector.start], points[vector.end]], axis=1)
        sketch.add([Line(ends, "PLAN_V", "part" if vector.part == "relative" else "vector", 2)])
    sketch.add(Circle(point, 0.5, "PLAN_V", "outline", 5, "paper") for point in points.values())
    names, places = list(points), np.stack(list(points.values()), axis=1)
    named = {names[of[0]]: places[:, of[0]] for of in together(places, _ONE_POINT)}
    middle = np.mean(places, axis=1)
    wishes = [Wish(point, name, angle_of(point - middle)) for name, point in named.items()]
    long = (force for force in lever.forces if force.point and not _is_short(force, newton))
    for force in (*long, _balancing(lever, polygon)):
        at = -turned_left(np.array(force.velocity)) / polygon.scale
        end = at + np.array(force.value) / newton
        sketch.add(arrow(at, end, "LINKS", "part" if force.symbol.startswith("Φ") else "vector"))
        wishes.append(Wish(end, force.symbol, angle_of(end - at)))
        if force.point.startswith(("s_", "q_")) and not any(
            np.hypot(*(at - point)) < _ONE_POINT for point in named.values()
        ):
            sketch.add([Circle(at, 0.5, "PLAN_V", "outline", 5, "paper")])
            named[force.point] = at
            wishes.append(Wish(at, force.point, angle_of(at - middle)))
    sketch.add([Circle(points[POLE], 0.8, "PLAN_V", "outline", 6, "paper")])
    sketch.add(placed_labels(wishes, list(sketch.outline()), 1.0))
    return sketch


def _is_short(force: LeverForce, newton: float) -> bool:
    """Whether a force is too short to be drawn, to newton N in a millimetre."""
    return float(np.hypot(*force.value)) / newton < _NAMED


def _balancing(lever: ZhukovskyLever, polygon: Polygon) -> LeverForce:
    """The force at the crank pin, across the crank, that the driving torque is."""
    crank = next(vector for vector in polygon.vectors if vector.part == "absolute")
    velocity = np.array(crank.value)
    force = lever.driving_torque * lever.speed / float(velocity @ velocity) * velocity
    return LeverForce("F_b", crank.end, pair(force), crank.value, lever.driving_torque)


def _table(lever: ZhukovskyLever, letters: Mapping[str, str], unit: Scale) -> Iterator[tuple[str, ...]]:
    """Every force: at which point, its size and its moment about the pole, as torque on the crank."""
    largest = max(abs(moment) for moment in (lever.driving_torque, *(force.moment for force in lever.forces)))
    torque = scale_for("N*m", largest)
    yield (_("force"), _("at"), unit.label, torque.label)
    sizes = column([float(np.hypot(*force.value)) for force in lever.forces], unit)
    *moments, driving = column([*(force.moment for force in lever.forces), lever.driving_torque], torque)
    for force, newtons, moment in zip(lever.forces, sizes, moments, strict=True):
        bare = force.point.rstrip("'")
        at = (
            mathematics(force.point.replace(bare, letters.get(bare) or spoken_name(bare)))
            if force.point
            else _("couple")
        )
        yield (mathematics(force.symbol), at, newtons if force.point else "–", moment)
    yield (mathematics("M_b"), "", "", driving)


def _short_words(lever: ZhukovskyLever, newton: float) -> Iterator[str]:
    """Say which forces are too short to be drawn, some to a line."""
    short = [mathematics(force.symbol) for force in lever.forces if _is_short(force, newton)]
    if short:
        yield _("Too short to be drawn:")
    for first in range(0, len(short), _TO_A_LINE):
        yield ", ".join(short[first : first + _TO_A_LINE])


def _notes(lever: ZhukovskyLever) -> Iterator[str]:
    """Say what the lever proves."""
    yield _("Moments about p over the crank's speed.")
    yield _("Last: driving torque by the joints' reactions,")
    yield _("drawn as a force at the crank pin.")
    yield _("Their sum: {residual} of the largest.", residual=power_of_ten(lever.residual))
