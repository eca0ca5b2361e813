"""Wear of pins, journals and bearings on their rays, out of a result."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import Listed, Words, _
from cranktrain.motion import Array
from cranktrain.numerics.harmonics import TURN
from cranktrain.panels.design import OneDesign
from cranktrain.panels.shapes import Rays
from cranktrain.panels.sheets.crankshaft.panels import alike_pins
from cranktrain.questions.crankshaft.loads.loaded_shafts import LoadedShafts


def pin_wear(shown: OneDesign) -> Iterator[Rays]:
    """Wear of crank pins, and of the rods' bearings on them; up is away from the shaft, and toward the piston."""
    for pin in alike_pins(shown):
        hole = float(shown("crankpin_oil_hole")[pin.first])
        yield wear_rays(_("Pin {names}", names=pin.names), shown("crankpin_wear")[pin.first], hole)
        yield wear_rays(_("Rod {names}", names=pin.names), shown("rod_bearing_wear")[pin.first])


def journal_wear(shown: OneDesign, place: int = 0, method: Words = "") -> Iterator[tuple[Rays, Rays]]:
    """Wear of every journal, up is toward throw 1, and of its bearing as it is seen, by the method at a place.

    method: what stands below the title, if anything.
    """
    turns = [
        -one.layout.turn for one in shown.result[LoadedShafts].each for _bearing in one.layout.declared.bearing_names
    ]
    for bearing, (name, turn) in enumerate(zip(shown.result.labels["bearing"], turns, strict=True)):
        journal, shell = (
            wear_rays(
                Listed((title.format(name=name), method), "\n") if method else title.format(name=name),
                shown(f"{part}_wear")[place, bearing],
                float(shown(f"{part}_oil_hole")[place, bearing]),
                sense,
            )
            for part, title, sense in (("journal", _("Journal {name}"), 1.0), ("bearing", _("Bearing {name}"), turn))
        )
        yield journal, shell


def wear_rays(title: Words, wear: Array, hole: float = np.nan, turn: float = 1.0) -> Rays:
    """Mean load on each ray, shape (ray,) [N], from straight up; and where an oil hole goes. [rad]

    turn is 1 where rays count clockwise on paper, −1 where they count anticlockwise.
    """
    rays = np.arange(wear.size, dtype=np.float64)
    direction = TURN / 4 - turn * (TURN / wear.size) * rays
    return Rays(title, direction, wear, hole=TURN / 4 - turn * hole, hole_angle=hole)
