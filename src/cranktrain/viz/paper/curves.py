"""Panels of curves on paper: stacked over one crank angle or time, or each over its own on a card."""

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from cranktrain.language import said as _
from cranktrain.motion import Array
from cranktrain.panels.formulas import formula
from cranktrain.panels.parts import CurveCard, Stack
from cranktrain.panels.shapes import Curve, Panel, Role, as_shown
from cranktrain.viz.paper.marks import draw_marks, number_levels, words_below
from cranktrain.viz.paper.page import Axes, Box, Page
from cranktrain.viz.paper.style import COLOURS, GRID, HEADING, INK, MUTED, SYMBOL, TEXT

_MIDDLE = (4.0, 96.0)
"""Which of the values set the scale where the links cannot close all round. [%]"""

_RINGS = np.arange(15.0, 360.0, 30.0)
"""Where a second curve has its rings. [deg]"""

_TURN = 360.0
"""A longer cycle has ticks twice as far apart. [deg]"""

_FOOT = 9.0
"""Below panels for the crank angle. [mm]"""

_STRIP = 4.0
"""Height of the numbers over the marks. [mm]"""

_AXIS, _TITLE, _NUMBERS, _TICKS, _OVER, _LEGEND = 13.0, 9.0, 3.0, 7.0, 13.0, 8.0
"""About the curves of a card: left of them for figures, over them for the title and for numbers of rays, under them for
figures, for these with words, and for a legend. [mm]"""


class Look(NamedTuple):
    """How a sheet's panels look.

    head, gap, tallest: room above the first panel for its words, between panels, and of the largest ones; lift: of
    words above their panel; reach, sample: from symbol to symbol of a legend, and where the line before each begins and
    ends [mm]. beside: room over and under the curves, in parts of their height. zero: width of the line at zero [pt];
    it is drawn where curves cross it, or come nearer to it than this part of their largest. is_unit_bold: as the title.
    """

    head: float
    gap: float
    tallest: float
    lift: float
    reach: float
    sample: tuple[float, float]
    beside: float
    zero: float
    near: float
    is_unit_bold: bool


_SPACE = 1.5
"""Between a legend's line and its symbol, at least. [mm]"""

MOTION = Look(7.0, 7.0, np.inf, 1.9, 15.0, (10.5, 3.5), 0.09, 0.5, near=0.0, is_unit_bold=False)
FORCES = Look(5.2, 9.0, 60.0, 2.2, 18.0, (14.0, 6.5), 0.08, 0.6, near=0.5, is_unit_bold=True)


_NARROW = MOTION._replace(reach=11.5, sample=(8.5, 3.0))
"""Look of curves in two columns."""


class LinePen(NamedTuple):
    """Width of a curve [pt], its dashes in widths, and its layer."""

    width: float
    dashes: tuple[float, ...] = ()
    layer: float = 2.0


PENS: Mapping[Role, LinePen] = {
    "first": LinePen(1.9, layer=4),
    "second": LinePen(0.9, layer=3),
    "other": LinePen(0.6, layer=3),
    "textbook": LinePen(0.6, (4.0, 8.0), layer=5),
    "error": LinePen(1.1),
    "main": LinePen(1.6),
    "side": LinePen(1.1, (8.0, 2.0)),
    "radial": LinePen(0.9, (6.0, 2.0)),
    "resultant": LinePen(0.8, (2.0, 2.0)),
    "formula": LinePen(0.5, (3.0, 2.0)),
    "chamber": LinePen(0.9, (5.0, 2.0)),
    "whole": LinePen(1.9),
    "mean": LinePen(0.9, (6.0, 3.0)),
    "each": LinePen(0.45),
    "carried": LinePen(1.1, (6.0, 2.5)),
    "card": LinePen(1.4),
    "later_card": LinePen(0.9),
    "ray": LinePen(0.7),
    "half_ray": LinePen(0.35),
    "saved": LinePen(0.8, (1.0, 2.0)),
}

_ERROR_DASHES = {"s": (1.5, 1.5), "v": (5.0, 2.0), "j": (9.0, 2.0, 2.0, 2.0)}
"""Dashes of an error by the letter of its quantity, for prints in grey."""


def line_of(curve: Curve) -> dict[str, Any]:
    """How a curve's line is drawn: a textbook's in ink, others in the colour of their quantity."""
    pen = PENS[curve.role]
    dashes = _ERROR_DASHES[curve.letter] if curve.role == "error" else pen.dashes
    colour = INK if curve.role == "textbook" else COLOURS[curve.letter]
    return {"color": colour, "linewidth": pen.width, "linestyle": (0, dashes) if dashes else "-"}


def draw_stack(page: Page, stack: Stack, box: Box, *, is_narrow: bool = False) -> None:
    """Stack panels over the same in a room; numbers of levels stand over the first."""
    look = _NARROW if is_narrow else MOTION if stack.of_motion else FORCES
    strip = _STRIP if any(level.number for panel in stack.panels for level in panel.levels) else 0.0
    n = len(stack.panels)
    each = (box.height - _FOOT - look.head - strip - look.gap * (n - 1)) / n
    if not stack.is_tall:
        each = min(each, look.tallest)
    low = box.bottom + box.height - look.head - strip + look.gap
    for place, panel in enumerate(map(as_shown, stack.panels), start=1):
        low -= each + look.gap
        axes = axes_in(page, Box(box.left, low, box.width, each), look.beside)
        _draw_panel(page, axes, panel, look)
        axes.tick_params(labelbottom=place == n)
        over = strip if place == 1 else 0.0
        _write_head(page, panel, (box.left, box.left + box.width, low + each + look.lift + over), look)
        if over:
            ends = (box.left, box.left + box.width, low + each + 1.2)
            number_levels(page, panel.levels, ends, float(panel.across[-1]))
    page.text(box.left + box.width / 2, low - _FOOT, str(stack.over or _("Crank angle φ, °")), ha="center")


def draw_card(page: Page, card: CurveCard, box: Box) -> None:
    """Draw panels side by side in a room, each over its own."""
    width = box.width / len(card.panels)
    for place, panel in enumerate(map(as_shown, card.panels)):
        _draw_on_card(page, panel, box._replace(left=box.left + place * width, width=width - 2.0))


def _draw_on_card(page: Page, panel: Panel, room: Box) -> None:
    """Draw a panel under its title, over what its curves are over and the names of these."""
    named = [curve for curve in panel.curves if curve.name and curve.role != "ray"]
    said = [str(mark.words) for mark in panel.marks if mark.sort == "ring" and mark.words]
    legend = _LEGEND if named or said else 0.0
    foot = legend + (_OVER if panel.over else _TICKS)
    page.heading(room.left, room.bottom + room.height - 5.0, str(panel.title))
    head = _TITLE + (_NUMBERS if any(curve.role == "ray" for curve in panel.curves) else 0.0)
    box = Box(room.left + _AXIS, room.bottom + foot, room.width - _AXIS - 2.0, room.height - foot - head)
    axes = axes_in(page, box, FORCES.beside if panel.limits is None else 0.0)
    if panel.limits is None and comes_near_zero(panel, FORCES.near):
        axes.axhline(0.0, color=MUTED, linewidth=FORCES.zero, zorder=1)
    draw_curves(axes, panel)
    if panel.reach is not None:
        axes.set_xlim(*panel.reach)
    if panel.limits is not None:
        axes.set_ylim(*panel.limits)
    draw_marks(page, axes, panel)
    axes.text(
        0.98,
        0.9,
        "\n".join(map(str, panel.corner)),
        ha="right",
        va="top",
        transform=axes.transAxes,
        fontsize=TEXT,
    )
    if panel.over:
        page.text(box.left + box.width / 2, box.bottom - 8.5, str(panel.over), ha="center")
    x, y = room.left, room.bottom + 3.0
    for curve in named:
        page.sample(x, x + 8.0, y + 0.9, **line_of(curve))
        _begin, x = page.ends(page.text(x + 9.5, y, str(curve.name)))
        x += 5.0
    for words in said:
        page.text(x, y, words)


def draw_curves(axes: Axes, panel: Panel) -> None:
    """Draw the curves of a panel; a second one has hollow rings."""
    for curve in panel.curves:
        across = panel.across_of(curve)
        axes.plot(across, curve.values, **line_of(curve), zorder=PENS[curve.role].layer)
        if curve.role == "second":
            rings = np.interp(_RINGS, across, curve.values)
            axes.plot(_RINGS, rings, "o", ms=3.2, mfc="white", mec=COLOURS[curve.letter], mew=0.8, zorder=3.5)


def axes_in(page: Page, room: Box, beside: float = FORCES.beside) -> Axes:
    """Give axes in a room, with our grid, few round ticks and our frame; `beside` is of the height of their curves."""
    from matplotlib.ticker import MaxNLocator

    left, bottom, width, height = room
    axes = page.figure.add_axes((left / page.width, bottom / page.height, width / page.width, height / page.height))
    axes.grid(color=GRID, linewidth=0.5)
    axes.set_axisbelow(True)
    axes.margins(y=beside)
    axes.tick_params(labelsize=TEXT, pad=2.0)
    axes.yaxis.set_major_locator(MaxNLocator(nbins=4, steps=[1, 2, 5, 10], min_n_ticks=3))
    axes.spines[["top", "right"]].set_visible(False)
    return axes


def _draw_panel(page: Page, axes: Axes, panel: Panel, look: Look) -> None:
    """Draw curves over the crank angle or the time, with a line at zero where they come near it."""
    values, end = panel.values, float(panel.across[-1])
    if comes_near_zero(panel, look.near):
        axes.axhline(0.0, color=MUTED, linewidth=look.zero, zorder=1)
    draw_curves(axes, panel)
    axes.set_xlim(0.0, end)
    if panel.across_unit == "°":
        axes.set_xticks(np.arange(0.0, end + 1.0, 30.0 if end <= _TURN else 60.0))
    if np.any(np.isnan(values)):
        _leave_open(axes, panel.across, values)
    if panel.limits is not None:
        axes.set_ylim(*panel.limits)
    words_below(page, axes, panel)
    draw_marks(page, axes, panel)


def comes_near_zero(panel: Panel, near: float) -> bool:
    """Whether a curve crosses zero, or comes nearer to it than a part of its largest value."""
    ends = [(float(np.nanmin(curve.values)), float(np.nanmax(curve.values))) for curve in panel.curves]
    return any(least <= near * most and most >= near * least for least, most in ends)


def _leave_open(axes: Axes, angle: Array, values: Array) -> None:
    """Shade where the links cannot close, and take the scale from what is not the steep edge beside that."""
    open_there = np.any(np.isnan(values), axis=0)
    axes.fill_between(angle, 0.0, 1.0, where=open_there, transform=axes.get_xaxis_transform(), color=GRID, linewidth=0)
    low, high = np.nanpercentile(values, _MIDDLE)
    axes.set_ylim(low - 0.3 * (high - low), high + 0.3 * (high - low))


def _write_head(page: Page, panel: Panel, place: tuple[float, float, float], look: Look) -> None:
    """Name a panel over its left end, with symbol and unit; over its right end the curves that have symbols."""
    left, right, y = place
    if look.is_unit_bold:
        page.heading(left, y, f"{panel.title}, {panel.unit}".removesuffix(", "))
    else:
        _start, end = page.ends(page.heading(left, y, str(panel.title)))
        if panel.symbol:
            words, colour = formula(panel.symbol.replace("'", "′")), COLOURS[panel.curves[0].letter]
            _start, end = page.ends(page.text(end + 1.5, y, words, color=colour, fontsize=SYMBOL))
        page.text(end, y, f", {panel.unit}", fontsize=HEADING)
    x = right
    for curve in reversed([curve for curve in panel.curves if curve.symbol]):
        words = page.text(x, y, formula(curve.symbol), ha="right", color=COLOURS[curve.letter], fontsize=SYMBOL)
        begin, end = look.sample
        # A symbol with a word as its index is longer than the room that letters have.
        longer = max(0.0, x - end + _SPACE - page.ends(words)[0])
        page.sample(x - longer - begin, x - longer - end, y + 0.9, **line_of(curve))
        x -= look.reach + longer
