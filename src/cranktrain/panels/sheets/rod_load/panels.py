"""Curves of rod loads with limits and reversals, and pressures of all chambers over their volumes."""

from collections.abc import Sequence

import numpy as np

from cranktrain.language import _
from cranktrain.panels.design import OneDesign, closed
from cranktrain.panels.shapes import Curve, Mark, Panel, PanelLine, Role, peak
from cranktrain.questions.rod_load.declared import LIMITS
from cranktrain.questions.rod_load.loads import CRANK_PIN, CROSSHEAD_PIN, GAS, PISTON_ROD
from cranktrain.saying.amounts import UnitLabel

_LINES: tuple[tuple[int, Role, str, str], ...] = (
    (GAS, "side", "p", "F_g"),
    (PISTON_ROD, "each", "s", "F_r"),
    (CRANK_PIN, "resultant", "j", "S"),
    (CROSSHEAD_PIN, "whole", "F", "F"),
)
"""Places, and the line of each; what counts by the frame's limits is drawn last, over all others."""

_CARDS: tuple[Role, ...] = ("card", "later_card", "side", "resultant", "chamber", "mean")
_FAR, _MARGIN = 2.0, 0.06
"""Limits so many times as far as the largest load would leave its curves no room; what is left beyond all, in parts."""


def rod_load_panel(shown: OneDesign, piston: str) -> Panel:
    """Rod loads of a piston over the cycle, the frame's limits, and where the load at the crosshead pin reverses."""
    place = shown.member("piston", piston)
    loads = shown("rod_load")[:, place]
    curves = tuple(
        Curve(closed(loads[where]), role, letter, symbol)
        for where, role, letter, symbol in _LINES
        if np.any(np.isfinite(loads[where]))
    )
    limits = shown("rod_load_limit")[LIMITS.index("compression") :, place] if shown.has("rod_load_limit") else ()
    levels = tuple(
        PanelLine(sign * float(limit), "limit")
        for sign, limit in zip((1, -1), limits, strict=False)
        if np.isfinite(limit)
    )
    marks = tuple(
        Mark(float(angle), 0.0, "change", f"{float(angle):.1f}°")
        for angle in (shown(name)[CROSSHEAD_PIN, place] for name in ("tension_begins", "tension_ends"))
        if np.isfinite(angle)
    )
    title = _("Rod load of {piston}", piston=piston)
    return Panel(title, "N", shown.cycle, curves, marks=marks, levels=levels, limits=_reach(curves, levels))


def _reach(curves: Sequence[Curve], levels: Sequence[PanelLine]) -> tuple[float, float] | None:
    """From where to where loads are drawn, with the frame's limits that are not far beyond; None without any."""
    values = np.concatenate([curve.values for curve in curves])
    near = [line.at for line in levels if abs(line.at) <= _FAR * peak(values)]
    if not near:
        return None
    low, high = min(float(np.nanmin(values)), *near), max(float(np.nanmax(values)), *near)
    return low - _MARGIN * (high - low), high + _MARGIN * (high - low)


def stages_panel(shown: OneDesign) -> Panel:
    """Pressure over the volume in all chambers, each by its name."""
    pressures, volumes = shown("gas_pressure"), [closed(volume) for volume in shown("chamber_volume")]
    curves = tuple(
        Curve(closed(pressures[chamber]), _CARDS[chamber % len(_CARDS)], "p", name=name, across=volumes[chamber])
        for chamber, name in enumerate(shown.result.labels["chamber"])
    )
    title = _(
        "Indicator diagrams, pressure in {pressure} over volume in {volume}",
        pressure=UnitLabel("Pa", 0.0),
        volume=UnitLabel("m^3", float(np.max(volumes))),
    )
    return Panel(title, "Pa", volumes[0], curves, across_unit="m^3")
