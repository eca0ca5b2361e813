"""Panels of curves over the crank angle as a figure of the plotting library, which a notebook shows."""

from collections.abc import Mapping
from io import BytesIO
from typing import Any

import numpy as np

from cranktrain.language import said as _
from cranktrain.one_line import visible
from cranktrain.panels.plotted import Plot
from cranktrain.panels.shapes import Curve, Map, Panel, as_shown, is_level
from cranktrain.viz.paper.contours import draw_map
from cranktrain.viz.paper.curves import PENS, comes_near_zero, line_of
from cranktrain.viz.paper.page import Axes, Figure, drawing_settings
from cranktrain.viz.paper.style import GRID, HATCH, HEADING, MUTED, TEXT

_KEY: Mapping[str, Any] = {"fontsize": TEXT, "frameon": False, "handlelength": 4.0}

_WIDTH, _HEIGHT, _OF_MAP, _HEAD = 8.0, 2.1, 4.2, 0.7
"""Of a figure, of a panel, of a map, and of what stands above and below [in]."""

_FEW = 12
"""Points of a curve that are marked: between them nothing was computed."""
_POINT = 4.0
"""Size of a point that is marked [pt]."""

_TURN = 360.0
_DOTS_PER_INCH = 110


def in_notebook(figure: Figure) -> Figure:
    """Let a notebook show a figure, which the plotting library's own windows know nothing of."""

    def picture() -> bytes:
        content = BytesIO()
        with drawing_settings():
            figure.savefig(content, format="png", dpi=_DOTS_PER_INCH)
        return content.getvalue()

    figure._repr_png_ = picture
    return figure


def drawn_plot(plot: Plot) -> Figure:
    """Draw panels one above the other over one crank angle.

    Parameters
    ----------
    plot : Plot

    Returns
    -------
    Figure
        Which a notebook shows.
    """
    with drawing_settings():
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure as NewFigure

        heights = [_OF_MAP if isinstance(panel, Map) else _HEIGHT for panel in plot.panels]
        size = (_WIDTH, _HEAD + sum(heights))
        figure: Figure = NewFigure(figsize=size, facecolor="white", layout="constrained")
        FigureCanvasAgg(figure)
        if title := str(plot.title):
            figure.suptitle(visible(title), fontsize=HEADING + 1.5, fontweight="bold", parse_math=False)
        rooms = figure.subplots(len(plot.panels), sharex=True, squeeze=False, height_ratios=heights)[:, 0]
        panels = [panel if isinstance(panel, Map) else as_shown(panel) for panel in plot.panels]
        for axes, panel in zip(rooms, panels, strict=True):
            if isinstance(panel, Map):
                draw_map(axes, panel)
                continue
            _draw_panel(axes, panel)
            if not plot.keys and any(curve.name for curve in panel.curves):
                _plain(axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), **_KEY))
        if plot.keys:
            handles = [_drawn_line(curve, np.zeros(1)) for curve in plot.keys]
            _plain(figure.legend(handles=handles, loc="outside upper center", ncols=len(plot.keys), **_KEY))
        units = [panel.across_unit for panel in panels[-1:] if isinstance(panel, Panel) and panel.across_unit]
        over = _("Crank angle φ, °") if plot.over is None else ", ".join([str(plot.over), *units])
        rooms[-1].set_xlabel("\n".join(filter(None, (over, visible(str(plot.note))))), parse_math=False)
    return in_notebook(figure)


def _plain(legend: Any) -> None:
    """Write what stands in a key as it is: a dollar sign in a name begins no formula."""
    for text in legend.get_texts():
        text.set_parse_math(False)


def _draw_panel(axes: Axes, panel: Panel) -> None:
    """Draw the curves of one quantity, and a line at zero where they come there."""
    start, end = panel.reach or (float(panel.across[0]), float(panel.across[-1]))
    axes.grid(color=GRID, linewidth=0.5)
    if comes_near_zero(panel, 0.0):
        axes.axhline(0.0, color=MUTED, linewidth=0.5, zorder=1)
    for curve in panel.curves:
        axes.add_line(_drawn_line(curve, panel.across_of(curve)))
    axes.autoscale_view()
    values = np.concatenate([curve.values for curve in panel.curves])
    if is_level(values):
        middle = float(np.nanmean(values))
        axes.set_ylim(middle - 0.1 * abs(middle) - (middle == 0.0), middle + 0.1 * abs(middle) + (middle == 0.0))
    for first, last in panel.hatched:
        axes.axvspan(first, last, facecolor="none", edgecolor=MUTED, linewidth=0.0, hatch=HATCH, zorder=1)
    axes.set_xlim(start, end)
    if panel.across_unit == "°":
        axes.set_xticks(np.arange(0.0, end + 1.0, 30.0 if end <= _TURN else 60.0))
    title = visible(f"{panel.title}, {panel.unit}".removesuffix(", "))
    axes.set_title(title, loc="left", fontsize=HEADING, parse_math=False)
    axes.spines[["top", "right"]].set_visible(False)


def _drawn_line(curve: Curve, across: Any) -> Any:
    """What draws a curve, or stands for it in a key."""
    from matplotlib.lines import Line2D

    label = visible(str(curve.name))
    line = line_of(curve)
    if curve.is_cloud:
        line |= {"linestyle": "none", "marker": "o", "markersize": _POINT, "markeredgewidth": 0.0, "alpha": 0.6}
    elif np.count_nonzero(np.isfinite(curve.values)) <= _FEW:
        line |= {"marker": "o", "markersize": _POINT, "clip_on": False}
    return Line2D(across, curve.values, label=label, zorder=PENS[curve.role].layer, **line)
