"""Tables on a sheet of paper."""

from collections.abc import Sequence

from cranktrain.viz.paper.page import Page, is_formula
from cranktrain.viz.paper.style import SYMBOL

ROW, LEAST_ROW = 5.2, 4.5
"""Height of a row of a table, and how low it may be made where there is no room. [mm]"""


def write_table(
    page: Page,
    rows: Sequence[Sequence[str]],
    place: tuple[float, float, float],
    shares: tuple[float, ...] = (),
    line: float = ROW,
) -> float:
    """Write a table: a head, rows, all but the first column to the right; give where it ends. [mm]

    `shares` are where the other columns end, in parts of the width; evenly, unless given. `line` is a row's height.
    """
    left, top, width = place
    columns = len(rows[0])
    y = top - 4.0
    for number, row in enumerate(rows):
        for column, words in enumerate(row):
            share = shares[column - 1] if shares else 0.1 + 0.9 * column / (columns - 1)
            is_symbol = is_formula(words)
            page.text(
                left if column == 0 else left + width * share,
                y,
                words,
                ha="left" if column == 0 else "right",
                fontsize=SYMBOL if is_symbol else 8.0,
                fontweight="bold" if number == 0 else "normal",
            )
        if number == 0:
            page.rule(y - 1.6, left, left + width)
            y -= 1.2
        y -= line
    return y
