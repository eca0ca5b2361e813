"""The sheet of a pumping unit: curves over the crank angle, its card with permissible loads, and a table of facts."""

from collections.abc import Iterator

import numpy as np

from cranktrain.analysis import Result
from cranktrain.language import said as _
from cranktrain.saying.scales import scale_for
from cranktrain.viz.figures import with_unit
from cranktrain.viz.panel import OneDesign
from cranktrain.viz.paper.head import result_page
from cranktrain.viz.paper.page import Box, Figure, Page, drawing_settings
from cranktrain.viz.paper.panels import FORCES, axes_in, draw_panels
from cranktrain.viz.paper.style import COLOURS, INK
from cranktrain.viz.paper.tables import write_table
from cranktrain.viz.sheets.pumping.panels import card_curves, largest_torque, pumping_panels, rated_torque

_LEFT = 0.52
"""Share of the curves over the crank angle in the width."""
_CARD = 0.44
"""Share of the card in the height."""
_COLUMNS = (1.0,)
_UP, _DOWN = (COLOURS["T"], (7.0, 2.0)), (COLOURS["s"], (2.0, 2.0))
"""Colour and dashes of permissible loads."""


@drawing_settings()
def sheet_pumping(result: Result, *, size: str = "A4", design: int = 0) -> Figure:
    """Draw the sheet of a pumping unit.

    Parameters
    ----------
    result : Result
        Of a machine with [pumping].
    size : "A4" or "A3"
        Lying.
    design : int
        Which of the result's machines.

    Returns
    -------
    Figure
    """
    shown = OneDesign(result, design)
    page, box = result_page(result, design, size, _("Pumping unit"))
    left, right = box.columns(_LEFT, 14.0)
    draw_panels(page, list(pumping_panels(shown)), left, FORCES)
    below = _draw_card(page, shown, right)
    table = write_table(page, list(_facts(shown)), (right.left, below, right.width), _COLUMNS)
    page.notes(right.left, table - 2.0, _notes(shown))
    return page.figure


def _draw_card(page: Page, shown: OneDesign, room: Box) -> float:
    """Draw the card with the permissible loads; give where the room below begins. [mm]"""
    curves = card_curves(shown)
    scale = scale_for("N", curves.high)
    height = _CARD * room.height
    top = room.bottom + room.height
    axes = axes_in(page, Box(room.left + 13.0, top - height, room.width - 13.0, height - 8.0), 0.0)
    axes.plot(curves.position, scale.of(curves.load), color=INK, linewidth=1.6)
    for (position, load), (colour, pattern) in zip((curves.up, curves.down), (_UP, _DOWN), strict=True):
        axes.plot(position, scale.of(load), color=colour, linewidth=1.1, linestyle=(0, pattern))
    axes.set(xlim=(-0.02, 1.02), ylim=(scale.of(curves.low), scale.of(curves.high)))
    page.heading(room.left, top - 5.0, _("Load at the polished rod over its position, {unit}", unit=scale.label))
    x, y = room.left, top - height - 10.0
    page.sample(x, x + 8.0, y + 0.9, color=INK, linewidth=1.6)
    _begin, x = page.ends(page.text(x + 9.5, y, _("card")))
    is_rated = np.isfinite(rated_torque(shown))
    for words, (colour, pattern) in zip(_allowed(), (_UP, _DOWN), strict=True) if is_rated else ():
        x += 5.0
        page.sample(x, x + 8.0, y + 0.9, color=colour, linewidth=1.1, linestyle=(0, pattern))
        _begin, x = page.ends(page.text(x + 9.5, y, words))
    return y - 5.0


def _allowed() -> tuple[str, str]:
    """Names of the permissible loads, of the upstroke and of the downstroke."""
    return _("most going up"), _("least going down")


def _facts(shown: OneDesign) -> Iterator[tuple[str, str]]:
    """Rows of the table."""

    def of(words: str, name: str, unit: str) -> tuple[str, str]:
        value = float(shown(name))
        return words, with_unit(value, scale_for(unit, abs(value))) if np.isfinite(value) else "–"

    rated = rated_torque(shown)
    yield _("Gearbox and counterbalance"), ""
    yield of(_("stroke of the polished rod"), "rod_stroke", "m")
    yield of(_("peak of the upstroke"), "upstroke_peak", "N*m")
    yield of(_("peak of the downstroke"), "downstroke_peak", "N*m")
    yield of(_("least torque"), "least_gearbox_torque", "N*m")
    yield of(_("mean torque"), "mean_gearbox_torque", "N*m")
    yield _("cyclic load factor"), f"{float(shown('cyclic_load_factor')):.3f}"
    if np.isfinite(rated):
        yield _("rated torque"), with_unit(rated, scale_for("N*m", rated))
        yield _("largest torque, of the rating"), f"{100 * largest_torque(shown) / rated:.1f} %"
    yield of(_("moment of the counterbalance"), "counterbalance_moment", "N*m")
    yield of(_("for equal peaks"), "equal_peaks_moment", "N*m")
    yield of(_("peaks with that"), "equal_peaks_torque", "N*m")
    yield of(_("for the least root mean square"), "least_rms_moment", "N*m")
    yield of(_("power at the polished rod"), "polished_rod_power", "W")


def _notes(shown: OneDesign) -> Iterator[str]:
    """Say what the curves leave out."""
    yield _("Quasi-static, of loads alone. Permissible loads are infinite at the ends of the stroke.")
    if not np.isfinite(rated_torque(shown)):
        yield _("No permissible loads: [pumping] has no rated_torque.")
