"""Tables on a sheet of paper."""

from collections.abc import Sequence

from cranktrain.viz.paper.page import Page, is_formula
from cranktrain.viz.paper.style import SYMBOL, TEXT

ROW, LEAST_ROW = 5.2, 4.5
"""Height of a row of a table, and how low it may be made where there is no room. [mm]"""


def write_table(
    page: Page,
    rows: Sequence[Sequence[str]],
    place: tuple[float, float, float],
    shares: tuple[float, ...] = (),
    line: float = ROW,
    n_heads: int = 1,
) -> float:
    """Write a table: a head of so many rows, rows, all but the first column to the right; give where it ends. [mm]

    `shares` are where the other columns end, in parts of the width; evenly, unless given. `line` is a row's height.
    """
    left, top, width = place
    last = len(rows[0]) - 1
    ends = shares or tuple(0.1 + 0.9 * column / last for column in range(1, last + 1))
    places = [(left, "left"), *((left + width * share, "right") for share in ends)]
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


def write_row(page: Page, row: Sequence[str], places: Sequence[tuple[float, str]], y: float, *, is_bold: bool) -> None:
    """Write a row of a table: each column at its place, on one side of it."""
    for words, (x, side) in zip(row, places, strict=False):
        size = SYMBOL if is_formula(words) else TEXT
        page.text(x, y, words, ha=side, fontsize=size, fontweight="bold" if is_bold else "normal")
