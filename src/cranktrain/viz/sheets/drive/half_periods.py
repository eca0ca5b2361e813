"""Half-periods of the static torque on paper: where it changes its sign, and how long it keeps it."""

from typing import NamedTuple

import numpy as np

from cranktrain.viz.figures import degrees
from cranktrain.viz.panel import OneDesign
from cranktrain.viz.paper.page import Axes, Page
from cranktrain.viz.paper.style import INK, MUTED, TEXT

_ROW, _APART = 4.2, 1.5
"""Height of a row of words under a curve, and room between two of them. [mm]"""
_MOST_ROWS = 3


class _Placed(NamedTuple):
    """Words in a row, and from where to where they stand along the axis. [deg]"""

    words: str
    row: int
    start: float
    end: float


def draw_half_periods(page: Page, axes: Axes, shown: OneDesign) -> None:
    """Mark where the static torque at the motor changes its sign, with the angle, and the angles between.

    The words stand in rows under the curve, as many as they need; lengths that find no room are left out, as the angles
    beside them say as much.
    """
    start, length = shown("half_period_start"), shown("half_period_length")
    start, length = start[np.isfinite(start)], length[np.isfinite(length)]
    if len(start) < 2:
        return
    changes = [(float(angle), f"{degrees(abs(float(angle)))}°") for angle in start]
    end = float(axes.get_xlim()[1])
    between = [
        (_middle(float(a), float(b), end), f"Δφ = {degrees(float(b))}°") for a, b in zip(start, length, strict=True)
    ]
    placed = _in_rows(page, axes, [*changes, *between])
    height = axes.get_position().height * page.height
    foot = _ROW * (1 + max((one.row for one in placed), default=0)) + 1.0
    low, high = axes.get_ylim()
    axes.set_ylim(low - (high - low) * foot / (height - foot), high)
    axes.set_yticks([tick for tick in axes.get_yticks() if low <= tick <= high])
    for angle, _words in changes:
        axes.axvline(angle, color=MUTED, linewidth=0.7, linestyle=(0, (3.0, 2.0)), zorder=1.5)
        axes.plot([angle], [0.0], "o", ms=4.5, mfc="white", mec=INK, mew=1.0, zorder=6, clip_on=False)
    for one in placed:
        _write(axes, (one.start + one.end) / 2, (0.5 + one.row) * _ROW / height, one.words)


def _middle(start: float, length: float, end: float) -> float:
    """Middle of the larger part of a half-period on the sheet, where it may be cut in two. [deg]"""
    first, rest = min(length, end - start), max(0.0, start + length - end)
    return start + first / 2 if first >= rest else rest / 2


def _write(axes: Axes, x: float, y: float, words: str) -> None:
    """Write words on white, their middle at an angle and a share of the height."""
    axes.text(
        x,
        y,
        words,
        transform=axes.get_xaxis_transform(),
        ha="center",
        va="center",
        fontsize=TEXT,
        zorder=7,
        bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.4},
    )


def _in_rows(page: Page, axes: Axes, wanted: list[tuple[float, str]]) -> list[_Placed]:
    """Give each of some words the lowest row in which it has room."""
    end = float(axes.get_xlim()[1])
    degree = end / (axes.get_position().width * page.width)
    placed: list[_Placed] = []
    for angle, words in wanted:
        half = degree * (_width(page, words) / 2 + _APART / 2)
        middle = float(np.clip(angle, half, end - half))
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
