"""Curves of the gas at a piston: its pressure over the crank angle, and over the volume."""

import numpy as np

from cranktrain.analysis import Result
from cranktrain.language import _
from cranktrain.scales import scale_for
from cranktrain.viz.panel import Curve, OneDesign, Panel, closed


def pressure_panel(shown: OneDesign, piston: str) -> Panel:
    """Absolute pressure in the chambers of a piston over the cycle."""
    curves = tuple(
        Curve(closed(shown("gas_pressure")[chamber]), "chamber" if later else "main", "p", symbol)
        for later, (chamber, symbol) in enumerate(_symbols(shown.result, piston).items())
    )
    return Panel(_("Gas pressure at piston {piston}, absolute").format(piston=piston), "Pa", shown.cycle, curves)


def indicator_panel(shown: OneDesign, piston: str) -> Panel:
    """Pressure over the volume of each of a piston's chambers, both as they are shown."""
    chambers = chambers_of(shown.result, piston)
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


def _symbols(result: Result, piston: str) -> dict[int, str]:
    """Chambers of a piston, and what each one's pressure is called: where there are two, by its side."""
    chambers = chambers_of(result, piston)
    if len(chambers) == 1:
        return dict.fromkeys(chambers, "p")
    sides = (result.labels["chamber"][chamber].rpartition(".")[2] for chamber in chambers)
    return {chamber: rf"p_\mathrm{{{side}}}" for chamber, side in zip(chambers, sides, strict=True)}


def chambers_of(result: Result, piston: str) -> list[int]:
    """Places of a piston's chambers: of its own name, of both its sides, or of the cylinder that it shares."""
    return [
        i
        for i, name in enumerate(result.labels["chamber"])
        if name == piston or name.startswith(f"{piston}.") or piston.startswith(f"{name}.")
    ] or [0]
