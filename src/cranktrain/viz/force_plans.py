"""Sheet of the polygons of forces: the mechanism, the polygon of every group, and all forces with their numbers."""

from collections.abc import Sequence

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.machine import Machine
from cranktrain.study.force_polygons import force_polygons
from cranktrain.study.lettering import pin_letters
from cranktrain.study.placement import placed_together, places_called
from cranktrain.study.plans import position_plan
from cranktrain.study.plans import rescaled as rescaled_plan
from cranktrain.viz.force_rooms import draw_rows, fitting_pictures
from cranktrain.viz.force_rows import TABLE, tables, write_forces
from cranktrain.viz.page import Figure, Page, drawing_settings, muted
from cranktrain.viz.plan_sheet import Box, cells_of, centre, few_angles, plan_page, scale_of, write_scales
from cranktrain.viz.plan_sketches import positions_sketch

_FOOT = 12.0
"""Height of the notes below the polygons. [mm]"""


def plan_forces(
    machine: Machine, angles: int | Sequence[float] = (30.0,), *, mechanism: str | None = None, size: str = "A4"
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

    Returns
    -------
    Figure
    """
    chosen = [float(angle) for angle in few_angles(angles, _("polygons of forces"))]
    polygons = force_polygons(machine, chosen, mechanism=mechanism)
    letters = pin_letters(placed_together(machine, places_called(machine, mechanism), np.zeros(1)))
    with drawing_settings():
        page, box = plan_page(machine, angles, size, _("Polygons of forces"), mechanism)
        cells = list(cells_of(box._replace(bottom=box.bottom + _FOOT - 4.0, height=box.height - _FOOT + 4.0), len(chosen)))
        groups = [[polygon for polygon in polygons if polygon.angle == angle] for angle in chosen]
        left = 0.24 * box.width
        n_tables = max(len(tables(group, cells[0].height, letters)) for group in groups)
        middle = box.width - left - TABLE * n_tables
        drawn = fitting_pictures(groups, (middle, cells[0].height))
        if drawn is None:
            raise InputError([Problem("", polygons[0].mechanism, too_many_words())])
        plans = [
            position_plan(
                machine, [angle], mechanism=mechanism, room=(left - 14.0, cells[0].height - 20.0), is_lettered=True
            )
            for angle in chosen
        ]
        metal = max(plan.scale for plan in plans)
        for plan, pictures, cell in zip(plans, drawn, cells, strict=True):
            page.heading(cell.left, cell.bottom + cell.height - 4.0, f"φ = {plan.angles[0]:g}°")
            sketch = positions_sketch(rescaled_plan(plan, metal))
            centre(page, sketch, Box(cell.left, cell.bottom, left, cell.height - 5.0))
            draw_rows(page, pictures, cell._replace(left=cell.left + left, width=middle))
            group = [picture.polygon for row in pictures for picture in row]
            for number, rows in enumerate(tables(group, cell.height, letters)):
                start = cell.left + left + middle + number * TABLE
                write_forces(page, rows, (start + 3.0, cell.bottom + cell.height, TABLE - 3.0))
        write_scales(page, box, [scale_of("l", metal, "m"), scale_of("F", drawn[0][0][0].polygon.scale, "N")], None)
        for i, note in enumerate(_notes()):
            page.text(box.left + left, box.bottom + 12.6 - 4.2 * i, note, **muted())
        return page.figure


def _notes() -> tuple[str, ...]:
    """Say how the polygons are to be read."""
    return (
        _("Groups as they are solved, each closed head to tail from the ring. F₃₄ is the force of 3 on 4; dashed: inertia."),
        _("Thin: parts of a reaction; Fᵗ lies across the link and follows from moments about the pin named, Fⁿ along it."),
        _("Dash-dotted: reaction in an inner joint; it closes one link's part of the polygon, its opposite the other's."),
    )


def too_many_words() -> str:
    """Say what to do about more forces than a sheet has room for."""
    return _("has too many forces for this paper: ask for one crank angle, or for A3")
