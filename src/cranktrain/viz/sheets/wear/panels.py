"""Wear of pins, journals and bearings on their rays, out of a result."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from cranktrain.language import said as _
from cranktrain.motion import Array
from cranktrain.numerics.harmonics import TURN
from cranktrain.questions.crankshaft.loads.loaded_shafts import LoadedShafts
from cranktrain.viz.panel import OneDesign
from cranktrain.viz.sheets.crankshaft.panels import alike_pins


class WearDiagram(NamedTuple):
    """Mean load on each ray, shape (ray,) [N], from straight up in the sense `turn`; place of an oil hole. [rad]

    turn is 1 where rays count clockwise on paper, −1 where they count anticlockwise.
    """

    title: str
    wear: Array
    hole: float
    turn: float


def pin_wear(shown: OneDesign) -> Iterator[WearDiagram]:
    """Wear of crank pins, and of the rods' bearings on them; up is away from the shaft, and toward the piston."""
    for pin in alike_pins(shown):
        hole = float(shown("crankpin_oil_hole")[pin.first])
        yield WearDiagram(_("Pin {names}", names=pin.names), shown("crankpin_wear")[pin.first], hole, 1.0)
        title = _("Rod {names}", names=pin.names)
        yield WearDiagram(title, shown("rod_bearing_wear")[pin.first], np.nan, 1.0)


def journal_wear(shown: OneDesign) -> Iterator[tuple[WearDiagram, WearDiagram]]:
    """Wear of every journal, up is toward throw 1, and of its bearing as it is seen, by the first method."""
    turns = [
        -one.layout.turn for one in shown.result[LoadedShafts].each for _bearing in one.layout.declared.bearing_names
    ]
    for bearing, (name, turn) in enumerate(zip(shown.result.labels["bearing"], turns, strict=True)):
        journal, shell = (
            WearDiagram(
                title.format(name=name),
                shown(f"{part}_wear")[0, bearing],
                float(shown(f"{part}_oil_hole")[0, bearing]),
                sense,
            )
            for part, title, sense in (("journal", _("Journal {name}"), 1.0), ("bearing", _("Bearing {name}"), turn))
        )
        yield journal, shell


def turned_by(wear: WearDiagram) -> Array:
    """Directions of its rays on paper, anticlockwise from the right. [rad]"""
    rays = np.arange(wear.wear.size, dtype=np.float64)
    return np.asarray(TURN / 4 - wear.turn * (TURN / wear.wear.size) * rays)
