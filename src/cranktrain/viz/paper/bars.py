"""Bars on paper, and shapes along a shaft."""

import numpy as np

from cranktrain.motion import Array
from cranktrain.panels.parts import ShaftShapes
from cranktrain.panels.shapes import Bars, ShaftShape
from cranktrain.saying.scales import scale_for
from cranktrain.viz.paper.curves import axes_in
from cranktrain.viz.paper.page import LINE, Axes, Box, Page
from cranktrain.viz.paper.style import COLOURS, INK, MUTED

_AXIS, _HEADING, _TICKS = 9.0, 6.0, 7.0
"""Left of bars for figures, over them for the heading, and under them for names or figures. [mm]"""
_MARGIN = 0.06
"""Over and under bars that have two ends, in parts of their reach."""

_BRANCH = (4.0, 2.0)
"""Dashes of a shaft that passes other discs on the drawing."""
_SCALE, _WORDS = 8.0, 6.5
"""Room for the figures of the scale, and for the words over each shape. [mm]"""


def bars_height(bars: Bars, height: float) -> float:
    """Room for bars of a height; a heading says why there are none. [mm]"""
    return height if np.any(bars.high != bars.low) else _HEADING + 1.0


def draw_bars(page: Page, bars: Bars, box: Box) -> None:
    """Draw bars under their heading over their notes."""
    page.heading(box.left, box.bottom + box.height - 3.0, str(bars.title))
    if not np.any(bars.high != bars.low):
        return
    groups = [name.rpartition(".")[0] for name in bars.names]
    foot = _TICKS + LINE * (len(bars.notes) + any(groups)) + (1.0 if bars.notes else 0.0)
    room = Box(box.left + _AXIS, box.bottom + foot, box.width - _AXIS, box.height - _HEADING - foot)
    axes = axes_in(page, room)
    scale = scale_for(bars.unit, float(np.max(np.abs([bars.low, bars.high]))))
    low, span = scale.of(bars.low), scale.of(bars.high - bars.low)
    colours = np.where(bars.is_filled, COLOURS["T"], "white").tolist()
    width = (0.62 if bars.names else 0.7) * float(bars.across[1] - bars.across[0])
    drawn = axes.bar(bars.across, span, bottom=low, width=width, color=colours, edgecolor=COLOURS["T"], linewidth=0.7)
    axes.grid(visible=False, axis="x")
    if bars.names:
        _name_bars(page, axes, bars, groups, (low, low + span))
    else:
        last = float(bars.across[-1])
        axes.set(xlim=(0.0, last + 0.5), xticks=np.arange(1.0, last + 0.5), ylim=(0.0, None))
    if bars.framed >= 0:
        drawn[bars.framed].set(edgecolor=INK, linewidth=1.8)
    page.notes(box.left, box.bottom + LINE * (len(bars.notes) - 1) + 1.0, map(str, bars.notes))


def _name_bars(page: Page, axes: Axes, bars: Bars, groups: list[str], ends: tuple[Array, Array]) -> None:
    """Name bars that are places, by their groups where they have such, with a line at zero and room about them."""
    axes.axhline(0.0, color=INK, linewidth=0.6)
    axes.set_xlim(bars.across[0] - 0.7, bars.across[-1] + 0.7)
    low, high = float(np.min(ends[0])), float(np.max(ends[1]))
    axes.set_ylim(low - _MARGIN * (high - low), high + _MARGIN * (high - low))
    own = [place for place, name in enumerate(bars.names) if name]
    axes.set_xticks(bars.across[own], [bars.names[place].rpartition(".")[2] for place in own])
    bottom = axes.get_position().y0 * page.height - _TICKS - 1.5
    for group in dict.fromkeys(filter(None, groups)):
        middle = np.mean([bars.across[place] for place, one in enumerate(groups) if one == group])
        x = page.place_of(axes, np.array([[middle], [0.0]]))[0, 0]
        page.text(float(x), bottom, group, ha="center")


def draw_modes(page: Page, modes: ShaftShapes, box: Box) -> None:
    """Draw shapes, the first at the top, and name their places below them."""
    step = (box.width - _SCALE) / len(modes.names)
    starts = [box.left + _SCALE + (place + 0.5) * step for place in range(len(modes.names))]
    names = [page.text(x, box.bottom, name, ha="center") for x, name in zip(starts, modes.names, strict=True)]
    longest = max(float(np.ptp(page.ends(name))) for name in names) + 1.5
    is_turned = longest > step
    foot = 5.0 + longest if is_turned else 8.0
    for name in names:
        name.set(y=box.bottom + foot - 4.0, va="top", rotation=90 if is_turned else 0)
    height = (box.height - _HEADING - foot) / len(modes.shapes)
    top = box.bottom + box.height
    page.heading(box.left, top - 3.0, str(modes.title))
    for place, shape in enumerate(modes.shapes, start=1):
        bottom = top - _HEADING - place * height
        room = Box(box.left + _SCALE, bottom + 1.5, box.width - _SCALE, height - _WORDS)
        _draw_shape(axes_in(page, room), shape)
        page.text(box.left + _SCALE, bottom + height - 3.8, str(shape.title))


def _draw_shape(axes: Axes, shape: ShaftShape) -> None:
    """Draw amplitudes over the places, joined as these are by shafts, and the nodes."""
    places = np.arange(shape.amplitude.size)
    axes.set(xlim=(-0.5, places.size - 0.5))
    axes.set_xticks(places, [""] * places.size)
    axes.axhline(0.0, color=INK, linewidth=0.6)
    for place, other in enumerate(shape.following.tolist()):
        dashes = () if other == place + 1 else _BRANCH
        axes.plot([place, other], shape.amplitude[[place, other]], color=COLOURS["s"], linewidth=1.4, dashes=dashes)
    axes.vlines(places, 0.0, shape.amplitude, color=MUTED, linewidth=0.6)
    axes.plot(places, shape.amplitude, "o", ms=3.2, color=COLOURS["s"], zorder=5)
    if shape.nodes.size:
        axes.plot(shape.nodes, np.zeros_like(shape.nodes), "o", ms=4.0, mfc="white", mec=INK, mew=0.8, zorder=6)
