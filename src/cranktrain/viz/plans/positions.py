"""The plan of positions: a mechanism in several positions beside tables of what it does."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.analysis import SpeedWanted, speed_over_cycle
from cranktrain.language import said as _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.layout.speed import SpeedCurve
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.plans.lettering import lettered, pin_letters
from cranktrain.plans.positions import PositionPlan, chosen_scale, position_plan, rescaled, rounded_scale, track
from cranktrain.plans.shown_loads import ShownLoads, shown_loads
from cranktrain.plans.together import placed_together, places_called
from cranktrain.plans.vectors import spoken_name
from cranktrain.viz.paper.detail import RADIUS, draw_detail, has_room, is_too_small
from cranktrain.viz.paper.page import Box, Figure, Page, drawing_settings
from cranktrain.viz.paper.sketch import Sketch, bounds_of
from cranktrain.viz.plans.position_rows import N_HEADS, every, load_rows, point_tables, position_rows
from cranktrain.viz.plans.sheet import (
    LOWEST,
    length_scale,
    origin_in,
    plan_page,
    row_height,
    write_beside,
    write_scales,
)
from cranktrain.viz.plans.sketches import positions_sketch

_ONE, _BOTH = 0.62, 0.48
"""Width of the drawing in parts of the room's: of one mechanism, and of opposed pistons, whose table is wider."""

_LOADS = 4
"""Loads in one table."""

_PASSES = 4
"""How often a scale is made smaller for loads."""

_BESIDE_ROWS = 15.0
"""Height of a table beside its rows: heading, rule and note. [mm]"""

ROOM_FOR_WORDS = 66.0
"""Height of a room from which positions have numbers and a small crank a detail. [mm]"""


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
    is_one = len(places_called(machine, mechanism)) == 1
    wide = (_ONE if is_one else _BOTH) * box.width
    left = Box(box.left, box.bottom + 8.0, wide, box.height - 8.0)
    room = (left.width - 22.0, left.height - 22.0)
    loads = shown_loads(machine, places_called(machine, mechanism), curve or "constant")
    beside = None if loads is None else loads.outline
    metre = chosen_scale(position_plan(machine, 180, mechanism=mechanism, room=room, beside=beside).scale, scale)
    plan = rescaled(position_plan(machine, angles, mechanism=mechanism, room=room, is_lettered=True), metre)
    if loads is not None and scale is None:
        plan = _with_room(plan, loads, left)
        metre = plan.scale
    draw_positions(page, machine, plan, mechanism, left, loads)
    write_scales(page, box, [length_scale(metre)], 1e3 * metre)
    beside = box._replace(left=box.left + wide + 6.0, width=box.width - wide - 6.0)
    _write_tables(page, machine, plan, curve, mechanism, beside, loads)
    return page.figure


def _with_room(plan: PositionPlan, loads: ShownLoads, room: Box) -> PositionPlan:
    """Give a plan to the next smaller scales, a few at most, until there is room for its loads too."""
    for _pass in range(_PASSES):
        sketch = positions_sketch(plan, loads=loads)
        low, high = bounds_of(sketch.outline())
        if np.all((high - low) / sketch.scale <= (room.width, room.height)):
            break
        plan = rescaled(plan, rounded_scale(1.01 * plan.scale))
    return plan


class _Table(NamedTuple):
    """A table below that of the output: its head, its rows, what is said below it."""

    head: str
    rows: list[tuple[str, ...]]
    notes: tuple[str, ...]


def _further_tables(
    machine: Machine, place: PlacedMechanism, angles: Array, curve: SpeedCurve | None, loads: ShownLoads | None
) -> Iterator[_Table]:
    """Table of the loads, and of each followed point."""
    acting = () if loads is None else loads.at(angles)
    for start in range(0, len(acting), _LOADS):
        notes = _("forces along their ways, torques in the crank's sense;"), _("less than 0 against that")
        yield _Table(_("Loads"), load_rows(angles, acting[start : start + _LOADS]), notes)
    letters = pin_letters(placed_together(machine, (place,), np.zeros(1)))
    for name, table in point_tables(machine, place, angles, curve):
        words = f"{letters[name]}, {spoken_name(name).replace('_', ' ')}" if name in letters else spoken_name(name)
        notes = (_("x, y in the mechanism's own axes; sizes of velocity and acceleration"),)
        yield _Table(_("Point {name}", name=words), table, notes)


def _write_tables(
    page: Page,
    machine: Machine,
    plan: PositionPlan,
    curve: SpeedCurve | None,
    mechanism: str | None,
    room: Box,
    loads: ShownLoads | None,
) -> None:
    """Write what the output does in every position, loads and followed points; of these fewer rows where room ends."""
    first, *others = places_called(machine, mechanism)
    rows = list(position_rows(machine, (first, *others), plan.angles, curve))
    tables = [] if others else list(_further_tables(machine, first, plan.angles, curve, loads))
    while len(tables) > 1 and _least_height(rows, tables, len(rows)) > room.height:
        tables = tables[1:]  # loads are on their arrows, and on a sheet of their own
    step = next((step for step in range(1, len(rows)) if _least_height(rows, tables, step) <= room.height), len(rows))
    tables = [table._replace(rows=every(table.rows, step)) for table in tables]
    line = row_height([len(rows), *(len(table.rows) + 1 for table in tables)], room.height - 8.0)
    notes = output_notes(machine, plan, (first, *others))
    below = write_beside(page, room, room.left, rows, notes, line=line, n_heads=N_HEADS)
    for table in tables:
        page.heading(room.left, below - 3.0, table.head)
        rest = room._replace(height=below - 5.0 - room.bottom)
        below = write_beside(page, rest, room.left, table.rows, table.notes, line=line, n_heads=N_HEADS)


def _least_height(rows: Sequence[tuple[str, ...]], tables: Sequence[_Table], step: int) -> float:
    """How high the tables are at least with every so manyth row of the further ones. [mm]"""
    n_rows = len(rows) + sum(len(every(table.rows, step)) for table in tables)
    return LOWEST * n_rows + _BESIDE_ROWS * (len(tables) + 1)


def output_notes(machine: Machine, plan: PositionPlan, places: Sequence[PlacedMechanism]) -> list[str]:
    """Say from where the output counts."""
    if not places[0].kind.output.is_slider:
        return []
    if not plan.drawing.guides:
        return [_("x in the cylinder, positive toward its head; s from the top")]
    has_speed = machine.main_shaft.speed is not None
    rates = _("s, v, a") if has_speed else _("s and its derivatives")
    if len(places) > 1:
        return [_("{rates} from each piston's own top toward its shaft", rates=rates)]
    return [_("x from the shaft along the line of stroke;"), _("{rates} from the top toward it", rates=rates)]


def draw_positions(
    page: Page, machine: Machine, plan: PositionPlan, mechanism: str | None, room: Box, loads: ShownLoads | None
) -> None:
    """Draw the positions with paths and loads; where the crank is too small to be seen, the shaft once more, larger."""
    metal = 1e3 * plan.scale
    crank = plan.drawing.links[0].pins
    pins = plan.drawing.positions
    radius = metal * float(np.hypot(*(pins[crank[1]] - pins[crank[0]])[:, 0]))

    def drawn(scale: float, hidden: Sequence[str] = (), acting: ShownLoads | None = None) -> Sketch:
        paths = lettered(track(machine, 1e-3 * scale, mechanism=mechanism))
        return positions_sketch(rescaled(plan, 1e-3 * scale), paths, hidden=hidden, is_lettered=True, loads=acting)

    is_small = is_too_small(radius, metal) and len(plan.angles) > 1
    whole = drawn(metal, crank if is_small else (), loads)
    aside = room._replace(left=room.left + 2 * RADIUS + 4.0, width=room.width - 2 * RADIUS - 4.0)
    origins = [origin_in(whole, one) for one in (room, aside)]
    origin = next((one for one in origins if is_small and has_room(whole, one, room)), origins[0])
    n_cranks = len([link for link in plan.drawing.links if link.name == plan.drawing.links[0].name])
    has_detail = is_small and n_cranks == 1 and has_room(whole, origin, room)
    if room.height <= ROOM_FOR_WORDS or (is_small and not has_detail):
        whole = drawn(metal, tuple(pins), loads)
        has_detail = False
    page.draw(whole, origin)
    if has_detail:
        others = [pin for pin in pins if pin not in crank]
        draw_detail(page, lambda scale: drawn(scale, others), 1.2 * radius, whole, origin, room)
