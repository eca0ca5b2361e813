"""A result as a workbook for spreadsheets: a sheet of curves, one of facts, and what the numbers count from."""

import io
import math
from collections.abc import Collection, Iterator, Sequence

from cranktrain.analysis.curve_columns import CurveColumn
from cranktrain.extras import imported
from cranktrain.io.tables import HEADS, about, fact_rows, headed
from cranktrain.language import said as _
from cranktrain.motion import Array
from cranktrain.saying.run import Run

_LONGEST_CELL = 32_767
"""Characters that a cell of a spreadsheet holds."""


def workbook_bytes(
    run: Run, columns: Sequence[CurveColumn], facts: Collection[str], angles: Array | None = None
) -> Iterator[bytes]:
    """Write curves, facts and conventions as sheets of an .xlsx.

    Parameters
    ----------
    run : Run
        Of one design.
    columns : sequence of CurveColumn
        To write.
    facts : collection of str
        Facts to write; no sheet of them where there are none.
    angles : Array, shape (n,)
        The crank angles of the columns; those of the result unless given. [deg]

    Yields
    ------
    bytes
        Of the whole file; numbers of 16 digits, NaN an empty cell.

    Raises
    ------
    InputError
        If openpyxl is not installed.
    """
    book = imported("openpyxl", ".xlsx").Workbook(write_only=True)
    shown = headed(run, columns, angles)
    curves = book.create_sheet(_("curves") if run.design_rows is None else _("designs"))
    curves.freeze_panes = "B2"
    curves.append(list(map(_text, shown)))
    for numbers in zip(*(column.tolist() for column in shown.values()), strict=True):
        curves.append(list(map(_cell, numbers)))
    rows = list(fact_rows(run, facts)) if run.design_rows is None else []
    if rows:
        sheet = book.create_sheet(_("facts"))
        sheet.freeze_panes = "A2"
        sheet.append(HEADS)
        for name, of, value, unit, meaning in rows:
            sheet.append((name, _text(of), _cell(value), unit, meaning))
    head = book.create_sheet(_("about"))
    for word, sentence in about(run, columns, angles):
        head.append((word, _text(sentence)))
    content = io.BytesIO()
    book.save(content)
    yield content.getvalue()


def _cell(number: float | str) -> float | str | None:
    """Leave a cell empty where there is no number."""
    if isinstance(number, str):
        return _text(number)
    return number if math.isfinite(number) else None


def _text(sentence: str) -> str:
    """Write what no spreadsheet takes for a formula, and no cell is too small for."""
    plain = "".join(character for character in " ".join(sentence.split()) if character.isprintable())[:_LONGEST_CELL]
    return f"'{plain}" if plain.startswith("=") else plain
