"""The sheet of loads: their curves, work and power, sizes over travel, and the machine under them."""

from collections.abc import Iterator

import numpy as np

from cranktrain.analysis import Result
from cranktrain.language import Message, Words, _
from cranktrain.layout.part_tables import part_name
from cranktrain.layout.speed import SpeedCurve
from cranktrain.numerics.ties import first_largest
from cranktrain.one_line import short
from cranktrain.panels.design import OneDesign
from cranktrain.panels.parts import (
    CurveCard,
    Notes,
    Part,
    Sheet,
    SheetColumn,
    Stack,
    Table,
    TableColumn,
    ThrowAtAngle,
    sheet_of,
)
from cranktrain.panels.shapes import peak
from cranktrain.panels.sheets.loads.panels import CurveOfLoad, CurvesOfLoads, load_curves, load_panels, travel_panels
from cranktrain.panels.throw_scene import scene_of
from cranktrain.plans.drawn_throws import drawn_throws
from cranktrain.saying.amounts import Amount, UnitLabel
from cranktrain.saying.names import spelled

_MOST = 12
"""Loads that the table has room for."""

_NAME = 20
"""Letters of a load's name."""

_COLUMNS = (0.43, 0.60, 0.75, 0.90, 1.0)

_CARDS = 2
"""Curves over the travel, at most."""


def sheet_loads(result: Result, *, piston: str | None = None, design: int = 0) -> Sheet:
    """Collect what a machine works against.

    Parameters
    ----------
    result : Result
        Of a machine with [load.NAME].
    piston : str, optional
        Whose throw is drawn; the first one's unless given.
    design : int
        Which of the result's machines.

    Returns
    -------
    Sheet
    """
    shown = OneDesign(result, design)
    curves = load_curves(shown)
    cards = tuple(travel_panels(curves))[:_CARDS]
    right: tuple[Part, ...] = (
        _table(shown, curves.each[:_MOST]),
        Notes(tuple(_notes(curves))),
        *((CurveCard(cards, height=0.28, is_optional=True),) if cards else ()),
        _machine(shown, piston),
    )
    left = Stack(tuple(load_panels(shown, curves)))
    return sheet_of(result, design, _("Loads"), SheetColumn(0.5, (left,)), SheetColumn(0.5, right))


def _table(shown: OneDesign, each: tuple[CurveOfLoad, ...]) -> Table:
    """What every load is and does."""
    works, powers = shown("load_work"), shown("largest_load_power")
    n = len(each)
    return Table(
        (
            TableColumn(
                _("load"), [short(f"{i + 1}  {one.name.replace('_', ' ')}", _NAME) for i, one in enumerate(each)]
            ),
            TableColumn(_("on"), [_part(shown, one) for one in each]),
            TableColumn(_("largest"), [Amount(peak(one.size), "N*m" if one.is_torque else "N") for one in each]),
            TableColumn(_("work, {unit}", unit=UnitLabel("J", peak(works))), works[:n], "J", peak(works)),
            TableColumn(_("power, {unit}", unit=UnitLabel("W", peak(powers))), powers[:n], "W", peak(powers)),
            TableColumn(_("at φ, °"), shown("largest_load_power_at")[:n], decimals=1),
        ),
        _COLUMNS,
    )


def _part(shown: OneDesign, one: CurveOfLoad) -> Words:
    """What a load acts on."""
    if one.load is None:
        return _("shaft")
    place = shown.result.machines[shown.design].places[one.load.mechanism]
    return _(spelled(part_name(place.kind.dynamics.moving[one.load.link])))


def _notes(curves: CurvesOfLoads) -> Iterator[Message]:
    """Say how work and power count, and how many loads the table leaves out."""
    yield _(
        "Work is over the cycle, less than 0 where the machine works against the load; the largest power is of either"
        " sign. Forces are along their ways, torques in the crank's sense."
    )
    if len(curves.each) > _MOST:
        yield _("{n} more loads are in the result.", n=len(curves.each) - _MOST)


def _machine(shown: OneDesign, piston: str | None) -> ThrowAtAngle:
    """The throw with its loads where a load has the largest power of all."""
    result = shown.result
    machine = result.machines[shown.design]
    scene = scene_of(machine, drawn_throws(machine, piston)[0], speed=result.get(SpeedCurve) or "constant")
    largest = first_largest(np.abs(shown("largest_load_power")))
    at = scene.closing_angle(float(shown("largest_load_power_at")[largest]))
    return ThrowAtAngle(scene, at, _("At φ = {angle:.1f}°", angle=at))
