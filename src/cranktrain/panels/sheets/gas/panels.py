"""Curves of the gas at a piston: its pressure over the crank angle, and over the volume."""

from collections.abc import Iterator, Mapping

import numpy as np

from cranktrain.language import Message, _
from cranktrain.panels.design import OneDesign, closed
from cranktrain.panels.shapes import Curve, Panel
from cranktrain.questions.cylinders.parts import chambers_at
from cranktrain.saying.amounts import UnitLabel


def pressure_panel(shown: OneDesign, piston: str) -> Panel:
    """Absolute pressure in the chambers of a piston over the cycle."""
    curves = tuple(
        Curve(closed(shown("gas_pressure")[chamber]), "chamber" if later else "main", "p", symbol)
        for later, (chamber, symbol) in enumerate(_symbols(shown, piston).items())
    )
    return Panel(_("Gas pressure at piston {piston}, absolute", piston=piston), "Pa", shown.cycle, curves)


def indicator_panel(shown: OneDesign, piston: str) -> Panel:
    """Pressure over the volume of each of a piston's chambers, with its mean."""
    chambers = chambers_of(shown, piston)
    volumes = [closed(shown("chamber_volume")[chamber]) for chamber in chambers]
    curves = tuple(
        Curve(closed(shown("gas_pressure")[chamber]), "later_card" if later else "card", "p", across=volume)
        for later, (chamber, volume) in enumerate(zip(chambers, volumes, strict=True))
    )
    title = _(
        "Indicator diagram, pressure in {pressure} over volume in {volume}",
        pressure=UnitLabel("Pa", 0.0),
        volume=UnitLabel("m^3", float(np.max(volumes))),
    )
    corner = tuple(_means(shown, chambers)) if shown.has("indicated_mean_pressure") else ()
    return Panel(title, "Pa", volumes[0], curves, across_unit="m^3", corner=corner)


def _means(shown: OneDesign, chambers: Mapping[int, str]) -> Iterator[Message]:
    """Mean pressure of each of a piston's chambers; where there are two, whose, and that the second's card is thin."""
    for later, (chamber, side) in enumerate(chambers.items()):
        said = _("{side} (thin): mean {mean}") if later else _("{side}: mean {mean}")
        words = said if len(chambers) > 1 else _("mean {mean}")
        yield words.format(side=side, mean=shown.amount("indicated_mean_pressure", chamber))


def _symbols(shown: OneDesign, piston: str) -> dict[int, str]:
    """Chambers of a piston, and what each one's pressure is called: where there are two, by its side."""
    chambers = chambers_of(shown, piston)
    if len(chambers) == 1:
        return dict.fromkeys(chambers, "p")
    return {chamber: rf"p_\mathrm{{{side}}}" for chamber, side in chambers.items()}


def chambers_of(shown: OneDesign, piston: str) -> dict[int, str]:
    """Places of a piston's chambers, with their sides; of a piston without any the first of the machine's."""
    return chambers_at(shown.result.machines[shown.design].design, piston) or {0: ""}
