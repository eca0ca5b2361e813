"""A map: lines of equal value over two numbers, and hatched where there is none."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from cranktrain.numerics.ties import first_largest
from cranktrain.one_line import visible
from cranktrain.panels.shapes import Map, is_level, peak, scale_of
from cranktrain.viz.paper.line_numbers import number_places
from cranktrain.viz.paper.page import Axes
from cranktrain.viz.paper.style import GRID, HATCH, HEADING, INK, MUTED, TEXT

_LINES = 9
"""About as many lines of equal value."""
_TAIL = 10.0
"""Percent of all values on either side, which have lines as far beyond the others as these lie apart."""
_WIDE, _HIGH = 0.35, 0.6
"""Half the width of a digit, and half the height of a number with the room above it, in letters' heights."""
_TONES = ("#f4f5f5", "#9aa0a6")
"""Of what is least and of what is most: light enough for lines and their numbers, in grey as in colour."""


def draw_map(axes: Axes, shown: Map) -> None:
    """Draw lines of equal value with their numbers over tones of grey; where there is no value it is hatched."""
    from matplotlib.colors import LinearSegmentedColormap

    scale = scale_of(shown.unit, peak(shown.values))
    values = np.ma.masked_invalid(np.asarray(scale.of(shown.values)))
    axes.grid(color=GRID, linewidth=0.5)
    axes.set_axisbelow(True)
    axes.set_xlim(float(np.min(shown.across)), float(np.max(shown.across)))
    axes.set_ylim(float(np.min(shown.up)), float(np.max(shown.up)))
    if is_level(shown.values):
        said = visible(f"{float(values.mean()):.4g} {scale.label}".strip())
        clear = {"facecolor": "white", "edgecolor": "none", "pad": 2.0}
        axes.text(*_middle(shown), said, ha="center", fontsize=HEADING, parse_math=False, bbox=clear, zorder=4)
    elif np.ma.count(values):
        levels = _levels(values)
        tones = LinearSegmentedColormap.from_list("tones", _TONES)
        axes.contourf(shown.across, shown.up, values, levels, cmap=tones, extend="both", corner_mask=False, zorder=1)
        lines = axes.contour(shown.across, shown.up, values, levels, colors=INK, linewidths=0.8, zorder=2)
        axes.clabel(lines, fontsize=TEXT, inline=True, inline_spacing=3, manual=_numbers(axes, shown, lines))
    _hatch_missing(axes, shown)
    for mark in shown.marks:
        axes.plot(mark.across, mark.value, "o", ms=5, mfc="white", mec=INK, zorder=4)
    axes.set_ylabel(visible(f"{shown.upward}, {shown.up_unit}".removesuffix(", ")), parse_math=False)
    title = visible(f"{shown.title}, {scale.label}".removesuffix(", "))
    axes.set_title(title, loc="left", fontsize=HEADING, parse_math=False)


def _levels(values: np.ma.MaskedArray) -> NDArray[np.float64]:
    """Values that have a line: of what grows beyond all others, as near locking, not all that it reaches."""
    from matplotlib.ticker import MaxNLocator

    known = values.compressed()
    least, low, high, most = (float(np.percentile(known, share)) for share in (0.0, _TAIL, 100.0 - _TAIL, 100.0))
    middle = high - low
    least, most = max(least, low - middle), min(most, high + middle)
    return np.asarray(MaxNLocator(_LINES).tick_values(least, most))


def _middle(shown: Map) -> tuple[float, float]:
    """The design with a value that is nearest to the middle of all that have one."""
    known = np.argwhere(np.isfinite(shown.values))
    row, column = known[first_largest(-np.hypot(*((known - known.mean(axis=0)) / shown.values.shape).T))].tolist()
    return float(shown.across[column]), float(shown.up[row])


def _numbers(axes: Axes, shown: Map, lines: Any) -> list[tuple[float, float]]:
    """Where lines have their numbers."""
    to_pixels = axes.transData
    pieces = [[to_pixels.transform(piece) for piece in of_level if len(piece) > 1] for of_level in lines.allsegs]
    cells = np.array([[[x, y], [x + width, y + height]] for x, y, width, height in _missing_cells(shown)])
    hatched = to_pixels.transform(cells.reshape(-1, 2)).reshape(-1, 2, 2)
    corners = to_pixels.transform([[shown.across[0], shown.up[0]], [shown.across[-1], shown.up[-1]]])
    longest = max(len(f"{level:.6g}") for level in lines.levels)
    letter = TEXT * axes.figure.dpi / 72
    size = np.array([_WIDE * longest * letter, _HIGH * letter])
    places = number_places(pieces, hatched, np.sort(corners, axis=0), size)
    return [tuple(place) for place in to_pixels.inverted().transform(np.reshape(places, (-1, 2))).tolist()]


def _missing_cells(shown: Map) -> list[tuple[float, float, float, float]]:
    """Cells of which a corner is a design that has no value: where they begin, their width and height."""
    missing = np.isnan(shown.values)
    missing = missing[1:, 1:] | missing[1:, :-1] | missing[:-1, 1:] | missing[:-1, :-1]
    widths, heights = np.diff(shown.across), np.diff(shown.up)
    return [
        (float(shown.across[column]), float(shown.up[row]), float(widths[column]), float(heights[row]))
        for row, column in np.argwhere(missing).tolist()
    ]


def _hatch_missing(axes: Axes, shown: Map) -> None:
    """Hatch the cells of which a corner is a design that has no value."""
    from matplotlib.collections import PatchCollection
    from matplotlib.patches import Rectangle

    cells = [Rectangle((x, y), width, height) for x, y, width, height in _missing_cells(shown)]
    axes.add_collection(PatchCollection(cells, facecolor="none", edgecolor=MUTED, linewidth=0.0, hatch=HATCH, zorder=3))
