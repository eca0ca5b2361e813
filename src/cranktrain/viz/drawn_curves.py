"""Panels of curves over the crank angle as a figure of the plotting library, which a notebook shows."""

from collections.abc import Mapping, Sequence
from io import BytesIO
from typing import Any, NamedTuple

import numpy as np

from cranktrain.language import said as _
from cranktrain.motion import Array
from cranktrain.one_line import visible
from cranktrain.record import record
from cranktrain.viz.paper.page import Axes, Figure, drawing_settings
from cranktrain.viz.paper.style import GRID, HEADING, MUTED, TEXT

LOOKS = ((1.8, ()), (1.2, (6.0, 2.0)), (1.2, (1.5, 1.5)), (1.1, (8.0, 2.0, 1.5, 2.0)), (0.6, ()), (0.6, (4.0, 4.0)))
"""Width and dashes of the first, second, … curve of a panel [pt]: told apart in grey, too."""

_KEY: Mapping[str, Any] = {"fontsize": TEXT, "frameon": False, "handlelength": 4.0}

_WIDTH, _HEIGHT, _HEAD = 8.0, 2.1, 0.7
"""Of a figure, of a panel, and of what stands above and below [in]."""

_TURN = 360.0
_DOTS_PER_INCH = 110


class CurveLine(NamedTuple):
    """A curve: its angles [deg] and values, what it is called, its look and its colour."""

    across: Array
    values: Array
    name: str
    look: tuple[float, tuple[float, ...]]
    colour: str


@record
class CurvePanel:
    """Curves of one quantity, with title and unit."""

    title: str
    unit: str
    lines: tuple[CurveLine, ...]


def in_notebook(figure: Figure) -> Figure:
    """Let a notebook show a figure, which the plotting library's own windows know nothing of."""

    def picture() -> bytes:
        content = BytesIO()
        with drawing_settings():
            figure.savefig(content, format="png", dpi=_DOTS_PER_INCH)
        return content.getvalue()

    figure._repr_png_ = picture
    return figure


def drawn_panels(panels: Sequence[CurvePanel], title: str = "", keys: Sequence[CurveLine] = ()) -> Figure:
    """Draw panels one above the other over one crank angle.

    Parameters
    ----------
    panels : sequence of CurvePanel
    title : str
    keys : sequence of CurveLine
        What a key above all panels explains; each panel has its own beside it unless given.

    Returns
    -------
    Figure
        Which a notebook shows.
    """
    with drawing_settings():
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure as NewFigure

        size = (_WIDTH, _HEAD + _HEIGHT * len(panels))
        figure: Figure = NewFigure(figsize=size, facecolor="white", layout="constrained")
        FigureCanvasAgg(figure)
        if title:
            figure.suptitle(visible(title), fontsize=HEADING + 1.5, fontweight="bold", parse_math=False)
        rooms = figure.subplots(len(panels), sharex=True, squeeze=False)[:, 0]
        for axes, panel in zip(rooms, panels, strict=True):
            _draw_panel(axes, panel)
            if not keys and any(line.name for line in panel.lines):
                _plain(axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), **_KEY))
        if keys:
            handles = list(map(_drawn_line, keys))
            _plain(figure.legend(handles=handles, loc="outside upper center", ncols=len(keys), **_KEY))
        rooms[-1].set_xlabel(_("Crank angle φ, °"))
    return in_notebook(figure)


def _plain(legend: Any) -> None:
    """Write what stands in a key as it is: a dollar sign in a name begins no formula."""
    for text in legend.get_texts():
        text.set_parse_math(False)


def _draw_panel(axes: Axes, panel: CurvePanel) -> None:
    """Draw the curves of one quantity, and a line at zero where they come there."""
    end = max(float(line.across[-1]) for line in panel.lines)
    every = np.concatenate([line.values for line in panel.lines])
    axes.grid(color=GRID, linewidth=0.5)
    if np.nanmin(every, initial=0.0) < 0.0 < np.nanmax(every, initial=0.0):
        axes.axhline(0.0, color=MUTED, linewidth=0.5, zorder=1)
    for place, line in enumerate(panel.lines):
        axes.add_line(_drawn_line(line, layer=2 + place))
    axes.autoscale_view()
    axes.set(xlim=(0.0, end), xticks=np.arange(0.0, end + 1.0, 30.0 if end <= _TURN else 60.0))
    title = visible(f"{panel.title}, {panel.unit}" if panel.unit else panel.title)
    axes.set_title(title, loc="left", fontsize=HEADING, parse_math=False)
    axes.spines[["top", "right"]].set_visible(False)


def _drawn_line(line: CurveLine, layer: float = 2.0) -> Any:
    """What draws a curve, or stands for it in a key."""
    from matplotlib.lines import Line2D

    width, dashes = line.look
    style: Any = (0, dashes) if dashes else "-"
    return Line2D(
        line.across,
        line.values,
        color=line.colour,
        linewidth=width,
        linestyle=style,
        label=visible(line.name),
        zorder=layer,
    )
