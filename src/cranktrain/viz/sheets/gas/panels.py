"""Curves of the gas at a piston: its pressure over the crank angle, and over the volume."""

import numpy as np

from cranktrain.language import said as _
from cranktrain.questions.cylinders.parts import chambers_at
from cranktrain.saying.scales import scale_for
from cranktrain.viz.panel import Curve, OneDesign, Panel, closed


def pressure_panel(shown: OneDesign, piston: str) -> Panel:
    """Absolute pressure in the chambers of a piston over the cycle."""
    curves = tuple(
        Curve(closed(shown("gas_pressure")[chamber]), "chamber" if later else "main", "p", symbol)
        for later, (chamber, symbol) in enumerate(_symbols(shown, piston).items())
    )
    return Panel(_("Gas pressure at piston {piston}, absolute", piston=piston), "Pa", shown.cycle, curves)


def indicator_panel(shown: OneDesign, piston: str) -> Panel:
    """Pressure over the volume of each of a piston's chambers, both as they are shown."""
    chambers = chambers_of(shown, piston)
    pressure = scale_for("Pa", 0.0)
    curves = tuple(
        Curve(pressure.of(closed(shown("gas_pressure")[chamber])), "later_card" if later else "card", "p")
        for later, chamber in enumerate(chambers)
    )
    volumes = np.stack([closed(shown("chamber_volume")[chamber]) for chamber in chambers])
    volume = scale_for("m^3", float(np.max(volumes)))
    title = _("Indicator diagram, pressure in {pressure} over volume in {volume}")
    said = title.format(pressure=pressure.label, volume=volume.label)
    return Panel(said, pressure.label, volume.of(volumes), curves)


def _symbols(shown: OneDesign, piston: str) -> dict[int, str]:
    """Chambers of a piston, and what each one's pressure is called: where there are two, by its side."""
    chambers = chambers_of(shown, piston)
    if len(chambers) == 1:
        return dict.fromkeys(chambers, "p")
    return {chamber: rf"p_\mathrm{{{side}}}" for chamber, side in chambers.items()}


def chambers_of(shown: OneDesign, piston: str) -> dict[int, str]:
    """Places of a piston's chambers, with their sides; of a piston without any the first of the machine's."""
    return chambers_at(shown.result.machines[shown.design].design, piston) or {0: ""}
