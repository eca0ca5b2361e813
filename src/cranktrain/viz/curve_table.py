"""A table of curves on a sheet of paper: a line for each crank angle, a column for each curve."""

from collections.abc import Iterator, Sequence

from cranktrain.analysis.curve_columns import CurveColumn
from cranktrain.analysis.figures import shown_in, text_in
from cranktrain.errors import InputError, Problem
from cranktrain.language import said as _
from cranktrain.motion import Array
from cranktrain.panels.formulas import mathematics
from cranktrain.panels.parts import Sheet
from cranktrain.viz.paper.head import headed_page
from cranktrain.viz.paper.page import LINE, Figure, drawing_settings
from cranktrain.viz.paper.tables import LEAST_ROW, write_table

_HEADS = 2
"""Rows of a head: symbols, and units."""
_HEAD = 8.0
"""Height of the rule below it, and above the first row. [mm]"""
_GAP = 10.0
"""Between two tables side by side. [mm]"""
_ANGLE = 0.05
"""Width of the column of angles, in parts of a table's."""
_MOST_BESIDE = 10
"""Columns of a table of which there is room for two."""
_LETTERS, _SYMBOL = 150, 6
"""In a line of names below; and about how many of them a symbol takes."""


@drawing_settings()
def curve_table(sheet: Sheet, columns: Sequence[CurveColumn], angles: Array, *, size: str = "A4") -> Figure:
    """Draw a table of curves.

    Parameters
    ----------
    sheet : Sheet
        On which it stands alone.
    columns : sequence of CurveColumn
        With values at the angles.
    angles : Array, shape (n,)
        [deg]
    size : "A4" or "A3"
        Lying.

    Returns
    -------
    Figure

    Raises
    ------
    InputError
        If there are more lines than a sheet holds.
    """
    page, box = headed_page(sheet, size)
    notes = list(_names(columns))
    top = box.bottom + box.height
    n_lines = int((box.height - LINE * (len(notes) + 1) - _HEAD - LEAST_ROW) / LEAST_ROW)
    n_beside = 2 if len(columns) + 1 <= _MOST_BESIDE and angles.size > n_lines else 1
    if angles.size > n_lines * n_beside:
        allowed = _("of {n} lines does not fit on a sheet, which holds {most}", n=angles.size, most=n_lines * n_beside)
        raise InputError([Problem("--table", None, allowed, _("ask for fewer with --every or --at, or write a .csv"))])
    rows = list(_rows(columns, angles))
    in_each = -(-angles.size // n_beside)
    width = (box.width - _GAP * (n_beside - 1)) / n_beside
    ends = tuple(_ANGLE + (1 - _ANGLE) * (i + 1) / len(columns) for i in range(len(columns)))
    for place in range(n_beside):
        own = rows[_HEADS + place * in_each : _HEADS + (place + 1) * in_each]
        left = box.left + place * (width + _GAP)
        write_table(page, [*rows[:_HEADS], *own], (left, top, width), ends, LEAST_ROW, n_heads=_HEADS)
    page.notes(box.left, box.bottom + LINE * (len(notes) - 1), notes)
    return page.figure


def _rows(columns: Sequence[CurveColumn], angles: Array) -> Iterator[tuple[str, ...]]:
    """Rows of the table: symbols, units, and a line for each angle."""
    scales = [shown_in(column.entry.shown, column.values) for column in columns]
    yield mathematics("φ"), *(mathematics(column.entry.symbol or column.entry.name) for column in columns)
    yield "°", *(scale.label for scale in scales)
    for line, angle in enumerate(angles.tolist()):
        numbers = (text_in(scale, column.values[line]) for scale, column in zip(scales, columns, strict=True))
        yield f"{angle:g}", *numbers


def _names(columns: Sequence[CurveColumn]) -> Iterator[str]:
    """What the symbols stand for, in lines."""
    line, length = "", 0
    for column in columns:
        words = column.entry.words
        if line and length + len(words) > _LETTERS:
            yield f"{line},"
            line, length = "", 0
        said = f"{mathematics(column.entry.symbol)} {words}" if column.entry.symbol else words
        line, length = f"{line}, {said}" if line else said, length + len(words) + _SYMBOL
    yield line
