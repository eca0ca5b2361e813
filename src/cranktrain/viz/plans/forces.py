"""Sheet of the polygons of forces: the mechanism, the polygon of every group, and all forces with their numbers."""

from collections.abc import Sequence

import numpy as np

from cranktrain.analysis import SpeedWanted, speed_over_cycle
from cranktrain.errors import InputError, Problem
from cranktrain.language import said as _
from cranktrain.machine import Machine
from cranktrain.plans.acting import symbols_together
from cranktrain.plans.force_polygons import force_polygons
from cranktrain.plans.lettering import pin_letters
from cranktrain.plans.positions import single_plans
from cranktrain.plans.shown_loads import shown_loads
from cranktrain.plans.together import placed_together, places_called
from cranktrain.saying.scales import scale_for
from cranktrain.viz.paper.page import Figure, drawing_settings
from cranktrain.viz.plans.force_rooms import draw_rows, fitting_polygons
from cranktrain.viz.plans.force_rows import TABLE, tables, write_forces
from cranktrain.viz.plans.sheet import (
    cells_of,
    centre_at_angle,
    few_angles,
    length_scale,
    plan_page,
    scale_of,
    write_scales,
)
from cranktrain.viz.plans.sketches import positions_sketch

_LEFT = 0.24
"""Part of a sheet's width in which the mechanism is drawn."""

_FOOT = 8.0
"""Height of the notes below the polygons. [mm]"""


@drawing_settings()
def plan_forces(
    machine: Machine,
    angles: int | Sequence[float] = (30.0,),
    *,
    mechanism: str | None = None,
    size: str = "A4",
    speed: SpeedWanted = "constant",
) -> Figure:
    """Draw the polygons of forces of a mechanism's groups and crank, to scale, beside the mechanism and a table.

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
    groups = [[polygon for polygon in polygons if polygon.angle == angle] for angle in chosen]
    places = places_called(machine, mechanism)
    loads = shown_loads(machine, places, curve or "constant")
    beside = None if loads is None else loads.outline
    symbols = None if loads is None else symbols_together(loads.at(np.zeros(1)), places)
    letters = pin_letters(placed_together(machine, places, np.zeros(1)))
    unit = scale_for("N", max(force.size for polygon in polygons for force in polygon.forces))
    page, box = plan_page(machine, angles, size, _("Polygons of forces"), mechanism, curve=curve)
    cells = cells_of(box._replace(bottom=box.bottom + _FOOT, height=box.height - _FOOT), len(chosen))
    left, height = _LEFT * box.width, cells[0].height
    middle = box.width - left - TABLE * max(len(tables(group, height, letters, unit)) for group in groups)
    drawn = fitting_polygons(groups, (middle, height))
    if drawn is None:
        raise InputError([Problem("", polygons[0].mechanism, too_many_words(len(chosen), size))])
    plans = single_plans(machine, chosen, mechanism=mechanism, room=(left - 14.0, height - 20.0), beside=beside)
    for plan, pictures, cell in zip(plans, drawn, cells, strict=True):
        sketch = positions_sketch(plan, loads=loads, said=symbols)
        centre_at_angle(page, plan.angles[0], sketch, cell._replace(width=left))
        draw_rows(page, pictures, cell._replace(left=cell.left + left, width=middle))
        group = [picture.polygon for row in pictures for picture in row]
        for number, rows in enumerate(tables(group, height, letters, unit)):
            start = cell.left + left + middle + number * TABLE + 3.0
            write_forces(page, rows, unit, (start, cell.bottom + height, TABLE - 3.0))
    scale = drawn[0][0][0].polygon.scale
    write_scales(page, box, [length_scale(plans[0].scale), scale_of("F", scale, unit)], None)
    notes = (
        _("Groups as they are solved, each closed head to tail from the ring. F₃₄: force of 3 on 4; dashed: inertia."),
        _("Thin: parts of a reaction; Fᵗ lies across the link, by moments about the pin named, Fⁿ along it."),
        _("Dash-dotted: reaction in an inner joint; it closes one link's part, its opposite the other's."),
    )
    page.notes(box.left + left, box.bottom + 12.6, notes)
    return page.figure


def too_many_words(n_angles: int, size: str) -> str:
    """Say what to do about more forces than a sheet has room for."""
    words = {
        (True, True): _("has too many forces for this paper: ask for one crank angle, or for A3"),
        (True, False): _("has too many forces for this paper: ask for one crank angle"),
        (False, True): _("has too many forces for A4: ask for A3, --size A3"),
        (False, False): _("has too many forces for a sheet"),
    }
    return words[n_angles > 1, size == "A4"]
