"""The sheet of loads: their curves, work and power, sizes over travel, and the machine under them."""

from collections.abc import Iterator

import numpy as np

from cranktrain.analysis import Result
from cranktrain.language import said as _
from cranktrain.layout.part_tables import part_name
from cranktrain.layout.speed import SpeedCurve
from cranktrain.numerics.ties import first_largest
from cranktrain.one_line import short
from cranktrain.plans.drawn_throws import drawn_throws
from cranktrain.plans.vectors import pair
from cranktrain.saying.names import said_name
from cranktrain.saying.scales import scale_for
from cranktrain.viz.figures import figure, with_unit
from cranktrain.viz.panel import OneDesign
from cranktrain.viz.paper.head import result_page
from cranktrain.viz.paper.page import Box, Figure, Page, drawing_settings
from cranktrain.viz.paper.panels import FORCES, axes_in, draw_curves, draw_panels
from cranktrain.viz.paper.sketch import labelled_bounds
from cranktrain.viz.paper.tables import write_table
from cranktrain.viz.sheets.loads.panels import CurvesOfLoads, load_curves, load_panels, travel_panels
from cranktrain.viz.throw.beside import fitted
from cranktrain.viz.throw.mechanism import mechanism_sketch
from cranktrain.viz.throw.scene import scene_of

_LEFT = 0.5
"""Share of the curves over the crank angle in the width."""

_MOST = 12
"""Loads that the table has room for."""

_NAME, _PART = 20, 10
"""Letters of a load's name, and of what it acts on."""

_COLUMNS = (0.43, 0.60, 0.75, 0.90, 1.0)

_CARD, _CARDS = 38.0, 2
"""Height of a curve over the travel [mm], and how many there are at most."""

_LEAST = 35.0
"""Height from which there is room for the machine. [mm]"""

_NOTES = 13.0
"""Height of the notes. [mm]"""


@drawing_settings()
def sheet_loads(result: Result, *, size: str = "A4", piston: str | None = None, design: int = 0) -> Figure:
    """Draw the sheet of a machine's loads.

    Parameters
    ----------
    result : Result
        Of a machine with [load.NAME].
    size : "A4" or "A3"
        Lying.
    piston : str, optional
        Whose throw is drawn; the first one's unless given.
    design : int
        Which of the result's machines.

    Returns
    -------
    Figure
    """
    shown = OneDesign(result, design)
    curves = load_curves(shown)
    page, box = result_page(result, design, size, _("Loads"))
    left, right = box.columns(_LEFT, 12.0)
    draw_panels(page, list(load_panels(shown, curves)), left, FORCES)
    below = _write_loads(page, shown, curves, right)
    page.notes(right.left, below - 2.0, _notes(curves))
    below = _draw_cards(page, curves, right, below - _NOTES)
    _draw_machine(page, shown, piston, right._replace(height=below - right.bottom))
    return page.figure


def _write_loads(page: Page, shown: OneDesign, curves: CurvesOfLoads, room: Box) -> float:
    """Write what every load is and does; give where the table ends. [mm]"""
    works, most = shown("load_work"), shown("largest_load_power")
    work = scale_for("J", float(np.max(np.abs(works))))
    power = scale_for("W", float(np.max(np.abs(most))))
    heads = (_("load"), _("on"), _("largest"), _("work, {unit}"), _("power, {unit}"), _("at φ, °"))
    head = (*heads[:3], heads[3].format(unit=work.label), heads[4].format(unit=power.label), heads[5])
    rows = [head]
    places = [place.kind.dynamics.moving for place in shown.result.machines[shown.design].places]
    for i, one in enumerate(curves.each[:_MOST]):
        largest = float(np.max(np.abs(one.size)))
        part = _("shaft") if one.load is None else part_name(places[one.load.mechanism][one.load.link])
        rows.append(
            (
                short(f"{i + 1}  {one.name.replace('_', ' ')}", _NAME),
                short(said_name(part), _PART),
                with_unit(largest, scale_for("N*m" if one.is_torque else "N", largest)),
                figure(float(work.of(works[i]))),
                figure(float(power.of(most[i]))),
                f"{float(shown('largest_load_power_at')[i]):.1f}",
            )
        )
    return write_table(page, rows, (room.left, room.bottom + room.height, room.width), _COLUMNS)


def _notes(curves: CurvesOfLoads) -> Iterator[str]:
    """Say how work and power count, and how many loads the table leaves out."""
    yield _("Work over the cycle, less than 0 where the machine works against the load;")
    yield _("largest power of either sign. Forces along their ways, torques in the crank's sense.")
    if len(curves.each) > _MOST:
        yield _("{n} more loads are in the result.", n=len(curves.each) - _MOST)


def _draw_cards(page: Page, curves: CurvesOfLoads, room: Box, top: float) -> float:
    """Draw sizes over the travel; give where they end. [mm]"""
    panels = list(travel_panels(curves))[:_CARDS]
    if not panels or top - _CARD < room.bottom:
        return top
    width = (room.width - 12.0 * len(panels)) / len(panels)
    for number, panel in enumerate(panels):
        left = room.left + 12.0 + number * (width + 12.0)
        axes = axes_in(page, Box(left, top - _CARD, width, _CARD - 8.0))
        draw_curves(axes, panel)
        page.heading(left - 12.0, top - 5.0, panel.title)
    return top - _CARD - 8.0


def _draw_machine(page: Page, shown: OneDesign, piston: str | None, room: Box) -> None:
    """Draw the throw with its loads where their power is largest."""
    if room.height < _LEAST:
        return
    result = shown.result
    machine = result.machines[shown.design]
    throw = drawn_throws(machine, piston)[0]
    scene = scene_of(machine, throw, speed=result.get(SpeedCurve) or "constant")
    at = scene.closing_angle(_largest_at(shown))
    found = fitted(
        lambda scale: [mechanism_sketch(scene, at, scale, has_ring=False)],
        scene.size / room.height,
        (room.width - 2.0, room.height - 9.0),
    )
    low, high = (corner / found.scale for corner in labelled_bounds(found.sketch))
    page.heading(room.left, room.bottom + room.height - 4.0, _("At φ = {angle:.1f}°", angle=at))
    below = room._replace(height=room.height - 7.0)
    page.draw(found.sketch, pair(below.middle - (low + high) / 2))


def _largest_at(shown: OneDesign) -> float:
    """Crank angle at which a load has the largest power of all. [deg]"""
    return float(shown("largest_load_power_at")[first_largest(np.abs(shown("largest_load_power")))])
