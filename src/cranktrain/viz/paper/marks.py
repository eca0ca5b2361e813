"""What marks a panel on paper: rings and dots on its curves, lines across it, and what is said of these."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics.ties import first_largest
from cranktrain.panels.formulas import formula
from cranktrain.panels.shapes import Mark, Panel, PanelLine
from cranktrain.viz.paper.page import Axes, Page, set_words
from cranktrain.viz.paper.sketch import Wish, placed_labels, together
from cranktrain.viz.paper.style import COLOURS, INK, MUTED, SYMBOL, TEXT

_LEVELS: dict[str, dict[str, Any]] = {
    "limit": {"color": INK, "linewidth": 0.6, "linestyle": (0, (3.0, 2.0))},
    "natural": {"color": COLOURS["s"], "linewidth": 1.2},
    "declared": {"color": COLOURS["T"], "linewidth": 0.9, "linestyle": (0, (6.0, 3.0))},
    "event": {"color": INK, "linewidth": 0.7, "linestyle": (0, (5.0, 2.0)), "zorder": 1.2},
    "often": {"color": MUTED, "linewidth": 0.5, "linestyle": (0, (1.0, 2.5)), "zorder": 1.2},
}
_CHANGE: dict[str, Any] = {"color": MUTED, "linewidth": 0.7, "linestyle": (0, (3.0, 2.0)), "zorder": 1.5}
_RING: dict[str, Any] = {"ms": 4.5, "mfc": "white", "mec": INK, "mew": 0.9, "zorder": 6, "clip_on": False}
_LARGEST_DOT, _LEAST_DOT, _ANGLE_DOT = 10.0, 1.6, 2.6
"""Diameters of dots. [pt]"""

_ROW, _APART, _MOST_ROWS = 4.2, 1.5, 3
"""Height of a row of words under a curve, room between two of them [mm], and how many rows there are at most."""
_WIDE = 2.2
"""Of a number over its line; nearer ones stand together. [mm]"""
_LEVELS_APART = 4.5
"""Between symbols of levels, and numbers of rays. [mm]"""
_ONE_POINT, _NAMED = 1.5, 2
"""Dots nearer to each other are one, with one label [mm]; of more angles at one not each is named."""


def draw_marks(page: Page, axes: Axes, panel: Panel) -> None:
    """Draw the marks and levels of a panel, which is as it is shown, on axes whose limits are known."""
    for level in panel.levels:
        line = axes.axvline if level.is_upright else axes.axhline
        line(level.at, **_LEVELS[level.role])
    for mark in panel.marks:
        if mark.sort == "change":
            axes.axvline(mark.across, **_CHANGE)
        style = _dot(mark) if mark.sort in ("dot", "angle") else _RING
        axes.plot([mark.across], [mark.value], "o", **style)
        if mark.sort == "dot" and mark.words:
            at = page.place_of(axes, np.array([[mark.across], [mark.value]]))[:, 0]
            _write_over(page, axes, at + np.array([3.0, 0.0]), str(mark.words), ha="left")
    _name_angles(page, axes, panel)
    _name_levels(page, axes, panel)
    _number_rays(page, axes, panel)
    if panel.dimension:
        _dimension(page, axes, panel)


def _dot(mark: Mark) -> dict[str, Any]:
    """How a dot is drawn: its area is its size."""
    if mark.sort == "angle":
        return {"ms": _ANGLE_DOT, "color": COLOURS["v"], "zorder": 6}
    return {"ms": max(_LEAST_DOT, _LARGEST_DOT * mark.size**0.5), "color": INK, "mew": 0, "zorder": 6}


def _write_over(page: Page, axes: Axes, at: Array, words: str, *, ha: str) -> None:
    """Write words at a place on the sheet over what axes hold. [mm]"""
    manner = {"ha": ha, "va": "center_baseline", "transform": page.paper.transData, "zorder": 20}
    axes.text(float(at[0]), float(at[1]), **set_words(words), **manner)


def _name_angles(page: Page, axes: Axes, panel: Panel) -> None:
    """Name the crank angles that are marked along the first curve, clear of all curves and of each other."""
    marks = [mark for mark in panel.marks if mark.sort == "angle"]
    if not marks:
        return
    curve, *others = (page.place_of(axes, np.stack([panel.across_of(one), one.values])) for one in panel.curves)
    points = page.place_of(axes, np.array([[mark.across, mark.value] for mark in marks]).T)
    angles, middle = np.array([mark.angle for mark in marks]), np.mean(curve[:, :-1], axis=1)
    away = np.arctan2(*(points - middle[:, np.newaxis])[::-1])
    wishes = [
        Wish(points[:, of[0]], _joined(angles[of]), float(away[of[0]]), "name") for of in together(points, _ONE_POINT)
    ]
    for label in placed_labels(wishes, [curve, *others], 1.0):
        _write_over(page, axes, label.position, label.text, ha="center")


def _joined(angles: Array) -> str:
    """Name all crank angles of one point; many at even distances by the first one and the distance, 60° + 180°k."""
    steps = np.diff(angles)
    if len(angles) > _NAMED and np.ptp(steps) < 1e-6:
        return f"{angles[0]:g}° + {steps[0]:g}°k"
    return ", ".join(f"{angle:g}°" for angle in angles)


def _name_levels(page: Page, axes: Axes, panel: Panel) -> None:
    """Write the symbols of levels over them where most room is, as far as they have room one above the other."""
    below = -np.inf
    for level in panel.levels:
        if not level.symbol:
            continue
        left, height = page.place_of(axes, np.array([[axes.get_xlim()[0]], [level.at]]))[:, 0].tolist()
        if height - below < _LEVELS_APART:
            continue
        below = height
        free = _free_place(page, axes, panel, (left, height))
        _begin = axes.annotate(
            set_words(formula(level.symbol))["s"],
            xy=(free, level.at),
            xytext=(0.0, 2.0),
            textcoords="offset points",
            ha="center",
            va="bottom",
            fontsize=SYMBOL,
            color=COLOURS["s"],
            zorder=5,
        )


def _free_place(page: Page, axes: Axes, panel: Panel, at: tuple[float, float]) -> float:
    """Middle of the widest room over a level, between straight curves from the origin and upright levels."""
    _left, low = at
    (start, end), (bottom, top) = axes.get_xlim(), axes.get_ylim()
    height = axes.get_position().height * page.height
    level = bottom + (top - bottom) * (low - axes.get_position().y0 * page.height) / height
    above = level + (top - bottom) * _LEVELS_APART / height
    ends = [(float(panel.across_of(one)[-1]), float(one.values[-1])) for one in panel.curves]
    slopes = np.array([up / along for along, up in ends])
    uprights = np.array([one.at for one in panel.levels if one.is_upright])
    starts = np.sort(np.concatenate([[start], above / slopes, uprights]))
    stops = np.sort(np.minimum(np.concatenate([level / slopes, uprights, [end]]), end))
    widest = first_largest(stops - starts)
    return float(starts[widest] + stops[widest]) / 2


def _number_rays(page: Page, axes: Axes, panel: Panel) -> None:
    """Write the names of rays at their ends, as far as they have room side by side. [mm]"""
    before = np.inf, np.inf
    for ray in (curve for curve in panel.curves if curve.role == "ray"):
        end = np.array([[float(panel.across_of(ray)[-1])], [float(ray.values[-1])]])
        x, y = page.place_of(axes, end)[:, 0].tolist()
        if np.hypot(x - before[0], y - before[1]) < _LEVELS_APART:
            continue
        before = x, y
        is_at_top = end[1, 0] >= axes.get_ylim()[1] * (1 - 1e-9)
        manner = {"ha": "center", "va": "bottom"} if is_at_top else {"ha": "left", "va": "center_baseline"}
        page.text(x if is_at_top else x + 1.0, y + 0.6 * is_at_top, str(ray.name), color=MUTED, **manner)


def _dimension(page: Page, axes: Axes, panel: Panel) -> None:
    """Draw the range between two levels as a dimension beside the right end, clear of the curve. [mm]"""
    limits = [level.at for level in panel.levels if level.role == "limit"]
    ends = np.stack([np.full(2, float(panel.across[-1])), [min(limits), max(limits)]])
    (right, _same), (low, high) = page.place_of(axes, ends).tolist()
    x = right + 4.0
    for y in (low, high):
        page.paper.plot((right, x + 1.5), (y, y), color=INK, lw=0.6)
    page.paper.annotate("", (x, high), (x, low), arrowprops={"arrowstyle": "<->", "lw": 0.7, "color": INK})
    page.text(x + 2.0, (low + high) / 2, formula(panel.dimension), va="center", fontsize=SYMBOL)


def number_levels(page: Page, levels: Sequence[PanelLine], place: tuple[float, float, float], until: float) -> None:
    """Write the numbers of upright levels over a panel, from its left to its right end [mm], which is at `until`.

    Those that would stand over each other stand side by side behind the first.
    """
    left, right, y = place
    rows: list[tuple[float, list[int]]] = []
    for level in sorted((one for one in levels if one.number), key=lambda one: (one.at, one.number)):
        x = left + (right - left) * level.at / until
        if rows and x - rows[-1][0] < _WIDE * (2 * len(rows[-1][1]) - 1) + 1.0:
            rows[-1][1].append(level.number)
        else:
            rows.append((x, [level.number]))
    for x, numbers in rows:
        page.text(x, y, ",".join(map(str, numbers)), ha="center" if len(numbers) == 1 else "left")


class _Placed(NamedTuple):
    """Words in a row, and from where to where they stand along the axis."""

    words: str
    row: int
    start: float
    end: float


def words_below(page: Page, axes: Axes, panel: Panel) -> None:
    """Write what marks say, and then what else is to stand below the curves, in rows as many as they need.

    The axes reach farther down for these; what finds no room is left out.
    """
    wanted = [(mark.across, str(mark.words)) for mark in panel.marks if mark.sort == "change"]
    wanted += [(at, str(words)) for at, words in panel.below]
    if not wanted:
        return
    placed = _in_rows(page, axes, wanted)
    height = axes.get_position().height * page.height
    foot = _ROW * (1 + max((one.row for one in placed), default=0)) + 1.0
    low, high = axes.get_ylim()
    axes.set_ylim(low - (high - low) * foot / (height - foot), high)
    axes.set_yticks([tick for tick in axes.get_yticks() if low <= tick <= high])
    for one in placed:
        axes.text(
            (one.start + one.end) / 2,
            (0.5 + one.row) * _ROW / height,
            one.words,
            transform=axes.get_xaxis_transform(),
            ha="center",
            va="center",
            fontsize=TEXT,
            zorder=7,
            bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.4},
        )


def _in_rows(page: Page, axes: Axes, wanted: Sequence[tuple[float, str]]) -> list[_Placed]:
    """Give each of some words the lowest row in which it has room."""
    end = float(axes.get_xlim()[1])
    per_mm = end / (axes.get_position().width * page.width)
    placed: list[_Placed] = []
    for at, words in wanted:
        half = per_mm * (_width(page, words) / 2 + _APART / 2)
        middle = float(np.clip(at, half, end - half))
        for row in range(_MOST_ROWS):
            own = _Placed(words, row, middle - half, middle + half)
            if all(other.row != row or own.start >= other.end or own.end <= other.start for other in placed):
                placed.append(own)
                break
    return placed


def _width(page: Page, words: str) -> float:
    """How wide words are. [mm]"""
    text = page.text(0.0, 0.0, words)
    begin, end = page.ends(text)
    text.remove()
    return end - begin
