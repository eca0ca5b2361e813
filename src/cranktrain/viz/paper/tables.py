"""Tables on a sheet of paper."""

from collections.abc import Sequence

from cranktrain.viz.paper.page import Page, is_formula
from cranktrain.viz.paper.style import SYMBOL, TEXT

ROW, LEAST_ROW = 5.2, 4.5
"""Height of a row of a table, and how low it may be made where there is no room. [mm]"""

_FIGURE, _GAP = 1.8, 1.0
"""Width of a figure, and between columns at least. [mm]"""


def write_table(
    page: Page,
    rows: Sequence[Sequence[str]],
    place: tuple[float, float, float],
    shares: tuple[float, ...] = (),
    line: float = ROW,
    n_heads: int = 1,
) -> float:
    """Write a table: a head of so many rows, rows, all but the first column to the right; give where it ends. [mm]

    `shares` are where the other columns end, in parts of the width; evenly, unless given, and farther aside where a
    column beside it needs the room. `line` is a row's height.
    """
    left, top, width = place
    last = len(rows[0]) - 1
    ends = shares or tuple(0.1 + 0.9 * column / last for column in range(1, last + 1))
    places = [(left, "left"), *((left + end, "right") for end in _kept_apart(rows, [width * share for share in ends]))]
    y = top - 4.0
    for number, row in enumerate(rows):
        write_row(page, row, places, y, is_bold=number == 0)
        if number < n_heads - 1:
            y += line - LEAST_ROW
        elif number == n_heads - 1:
            page.rule(y - 1.6, left, left + width)
            y -= 1.2
        y -= line
    return y


def _kept_apart(rows: Sequence[Sequence[str]], ends: Sequence[float]) -> list[float]:
    """Move the ends of columns as far as the widest words of any need: to the right of those before, but the last. [mm]

    Of the first column, which is to the left, a number counts alone: other words may be longer than they look.
    """
    widths = [_width([row[column] for row in rows if len(row) > column]) for column in range(len(ends) + 1)]
    kept = list(ends)
    before = widths[0] if all(row[0].isdigit() for row in rows[-1:]) else 0.0
    for column, width in enumerate(widths[1:-1]):
        before = kept[column] = max(kept[column], before + width + _GAP)
    for column in reversed(range(1, len(ends))):
        kept[column - 1] = min(kept[column - 1], kept[column] - widths[column + 1] - _GAP)
    return kept


def _width(words: Sequence[str]) -> float:
    """Room for the longest of some words, of which formulas are short. [mm]"""
    return _FIGURE * max((len(one) for one in words if not is_formula(one)), default=0)


def write_row(page: Page, row: Sequence[str], places: Sequence[tuple[float, str]], y: float, *, is_bold: bool) -> None:
    """Write a row of a table: each column at its place, on one side of it."""
    for words, (x, side) in zip(row, places, strict=False):
        size = SYMBOL if is_formula(words) else TEXT
        page.text(x, y, words, ha=side, fontsize=size, fontweight="bold" if is_bold else "normal")
