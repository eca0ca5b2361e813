"""Tables on a sheet of paper."""

from collections.abc import Sequence

from cranktrain.language import _
from cranktrain.numerics.ties import falling
from cranktrain.panels.formulas import is_formula
from cranktrain.panels.parts import Table, column_texts
from cranktrain.viz.paper.page import LINE, Box, Page
from cranktrain.viz.paper.polar import line_of_method
from cranktrain.viz.paper.style import SYMBOL, TEXT

ROW, LEAST_ROW = 5.2, 4.5
"""Height of a row of a table, and how low it may be made where there is no room. [mm]"""

_FIGURE, _GAP = 1.8, 1.0
"""Width of a figure, and between columns at least. [mm]"""


_ABOVE, _RULE, _TITLE = 4.0, 1.2, 6.0
"""Over the first row, below the head, and of a title. [mm]"""
_ROUNDING = 1e-6
"""Of heights. [mm]"""
_SAMPLE, _NAME = 10.0, 12.0
"""Length of a line before a row, and where its name begins. [mm]"""


def table_height(page: Page, table: Table, width: float, line: float = ROW, n_rows: int | None = None) -> float:
    """How high a table of a width is with rows of a height, of which there are so many. [mm]"""
    n = table.n_rows if n_rows is None else n_rows
    has_groups = any(one.group for one in table.columns)
    n_lines = len(_notes(page, table, width)) + (n < table.n_rows)
    return _ABOVE + _RULE + line * (n + 1 + has_groups) + _TITLE * bool(table.title) + LINE * n_lines


def draw_table(page: Page, table: Table, box: Box) -> None:
    """Draw a table in a room, its rows as high as there is room, those of low rank left out where there is none."""
    line = ROW if table_height(page, table, box.width) <= box.height + _ROUNDING else LEAST_ROW
    n = table.n_rows
    while n > 1 and table_height(page, table, box.width, line, n) > box.height + _ROUNDING:
        n -= 1
    kept = list(range(n)) if table.ranks is None else sorted(falling(table.ranks)[:n])
    texts = [column_texts(one) for one in table.columns]
    top = box.bottom + box.height
    if table.title:
        page.heading(box.left, top - 3.0, str(table.title))
        top -= _TITLE
    groups = [one.group for one in table.columns]
    rows = [[str(one.head) for one in table.columns], *([cells[row] for cells in texts] for row in kept)]
    if any(groups):
        top -= line
        _write_groups(page, table, groups, (box.left, top - _ABOVE + line, box.width))
    aside = _NAME if table.samples else 0.0
    for place, method in enumerate(table.samples):
        y = top - _ABOVE - _RULE - line * (place + 1) + 0.9
        page.sample(box.left, box.left + _SAMPLE, y, **line_of_method(method))
    ends = tuple((box.width * end - aside) / (box.width - aside) for end in table.ends)
    below = write_table(page, rows, (box.left + aside, top, box.width - aside), ends, line)
    said = table.left_out or _("and {n} more")
    left_out = [str(said.format(n=table.n_rows - n))] if n < table.n_rows else []
    page.notes(box.left, below, [*left_out, *_notes(page, table, box.width)])


def _notes(page: Page, table: Table, width: float) -> list[str]:
    """Fold its notes into lines."""
    return [line for note in table.notes for line in page.wrapped(note, width)]


def _write_groups(page: Page, table: Table, groups: Sequence[str], place: tuple[float, float, float]) -> None:
    """Write what stands over several columns over the first of each."""
    left, y, width = place
    for number, group in enumerate(groups):
        if group and group not in groups[:number]:
            start = table.ends[number - 2] if number > 1 else table.ends[0] / 2
            page.text(left + width * start + 4.0, y, group, fontweight="bold")


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
    for place, width in enumerate(widths[1:-1]):
        before = kept[place] = max(kept[place], before + width + _GAP)
    for place in reversed(range(1, len(ends))):
        kept[place - 1] = min(kept[place - 1], kept[place] - widths[place + 1] - _GAP)
    return kept


def _width(words: Sequence[str]) -> float:
    """Room for the longest of some words, of which formulas are short. [mm]"""
    return _FIGURE * max((len(one) for one in words if not is_formula(one)), default=0)


def write_row(page: Page, row: Sequence[str], places: Sequence[tuple[float, str]], y: float, *, is_bold: bool) -> None:
    """Write a row of a table: each column at its place, on one side of it."""
    for words, (x, side) in zip(row, places, strict=False):
        size = SYMBOL if is_formula(words) else TEXT
        page.text(x, y, words, ha=side, fontsize=size, fontweight="bold" if is_bold else "normal")
