"""Modes along the shaft on paper, one above the other."""

from collections.abc import Sequence

import numpy as np

from cranktrain.language import _
from cranktrain.one_line import short
from cranktrain.scales import scale_for
from cranktrain.viz.figures import with_unit
from cranktrain.viz.paper.page import Axes, Box, Page
from cranktrain.viz.paper.panels import axes_in
from cranktrain.viz.paper.style import COLOURS, INK, MUTED
from cranktrain.viz.sheets.torsion.panels import ModeShape

_MODES = 4
"""Modes that have a drawing."""
_BRANCH = (4.0, 2.0)
"""Dashes of a shaft that passes other discs on the drawing."""
_LONGEST = 16
"""Letters of a disc's name that are written."""
_SCALE, _HEAD, _WORDS = 8.0, 6.0, 6.5
"""Room for the figures of the scale, for the heading, and for the words over each mode. [mm]"""


def draw_modes(page: Page, shapes: Sequence[ModeShape], discs: Sequence[str], box: Box) -> None:
    """Draw the lowest modes, the lowest at the top, and name the discs below them.

    Parameters
    ----------
    page : Page
    shapes : sequence of ModeShape
    discs : sequence of str
        Their names, by the rows of Holzer's table.
    box : Box
    """
    step = (box.width - _SCALE) / len(discs)
    starts = [box.left + _SCALE + (place + 0.5) * step for place in range(len(discs))]
    names = [
        page.text(x, box.bottom, short(name, _LONGEST), ha="center") for x, name in zip(starts, discs, strict=True)
    ]
    longest = max(float(np.ptp(page.ends(name))) for name in names) + 1.5
    is_turned = longest > step
    foot = 5.0 + longest if is_turned else 8.0
    for name in names:
        name.set(y=box.bottom + foot - 4.0, va="top", rotation=90 if is_turned else 0)
    few = shapes[:_MODES]
    height = (box.height - _HEAD - foot) / len(few)
    top = box.bottom + box.height
    page.heading(box.left, top - 3.0, _("Modes, and their nodes"))
    for place, shape in enumerate(few, start=1):
        bottom = top - _HEAD - place * height
        room = Box(box.left + _SCALE, bottom + 1.5, box.width - _SCALE, height - _WORDS)
        _draw_mode(axes_in(page, room), shape)
        words = _("mode {n}, {frequency}; amplitude 1 at {disc}").format(
            n=shape.mode,
            frequency=with_unit(shape.frequency, scale_for("Hz", shape.frequency)),
            disc=_called(short(shape.unit, _LONGEST)),
        )
        page.text(box.left + _SCALE, bottom + height - 3.8, words)


def _draw_mode(axes: Axes, shape: ModeShape) -> None:
    """Draw amplitudes over the discs, joined as these are by shafts, and the nodes."""
    places = np.arange(shape.amplitude.size)
    axes.set(xlim=(-0.5, places.size - 0.5))
    axes.set_xticks(places, [""] * places.size)
    axes.axhline(0.0, color=INK, linewidth=0.6)
    for disc, other in enumerate(shape.following.tolist()):
        dashes = () if other == disc + 1 else _BRANCH
        axes.plot([disc, other], shape.amplitude[[disc, other]], color=COLOURS["s"], linewidth=1.4, dashes=dashes)
    axes.vlines(places, 0.0, shape.amplitude, color=MUTED, linewidth=0.6)
    axes.plot(places, shape.amplitude, "o", ms=3.2, color=COLOURS["s"], zorder=5)
    axes.plot(shape.nodes, np.zeros_like(shape.nodes), "o", ms=4.0, mfc="white", mec=INK, mew=0.8, zorder=6)


def _called(disc: str) -> str:
    """Name a disc in a sentence."""
    return _("throw {n}").format(n=disc) if disc.isdigit() else disc
