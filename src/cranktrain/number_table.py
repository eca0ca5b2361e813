"""Any table of numbers as text: its separator, its decimal sign, its header, each number with its place."""

import csv
import re
from collections.abc import Iterator, Sequence
from itertools import accumulate, pairwise

import numpy as np
from numpy.typing import NDArray

from cranktrain.errors import InputError, Position, Problem, first_of
from cranktrain.language import _
from cranktrain.motion import Array
from cranktrain.record import record

_NUMBER = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")
_STARTS_AS_NUMBER = re.compile(r"\s*[\"']?[+\-−]?[.,]?[0-9]")
_COMMENT = re.compile(r"\s*(?:#|%|//)\s*")
_LARGEST = 1e30
_MOST_LINES = 40_000
"""A cycle of 720° in steps of 0.02° has 36 000."""


@record
class NumberTable:
    """A table of numbers.

    Attributes
    ----------
    name : str
        Of the file, for messages.
    labels : tuple of str
        Header of each column, its lines joined by blanks; empty without a header.
    rows : Array, shape (row, column)
    lines : array of int, shape (row,)
        Line of the file of each row, from 1.
    texts : tuple of str
        Those lines.
    separator : str
        What divides their columns.
    """

    name: str
    labels: tuple[str, ...]
    rows: Array
    lines: NDArray[np.intp]
    texts: tuple[str, ...]
    separator: str

    def position(self, row: int, column: int) -> Position:
        """Where a number stands in the file."""
        return Position(self.name, int(self.lines[row]), _starts(self.texts[row], self.separator)[column])


def held_text(file: str, text: str | None) -> str:
    """What a file that a table names holds; refuse one that nobody has read."""
    if text is None:
        allowed = _("has not been read: load the machine from its file, or give what the file holds in `text`")
        raise InputError([Problem("file", file, allowed)])
    return text


def read_table(text: str, name: str) -> NumberTable:
    r"""Read a table of numbers.

    Parameters
    ----------
    text : str
        Columns divided by tabs, semicolons, blanks or commas; decimal points, or commas where commas do not divide;
        lines of header, and comments after #, % or //, or none.
    name : str
        Of the file, for messages.

    Returns
    -------
    NumberTable
        Every row as long as the first.

    Raises
    ------
    InputError
        With what is wrong, at line and column; or if it has more lines than any curve needs.

    Examples
    --------
    >>> read_table("angle;p\n0;1,5\n1;2", "a.csv").rows.tolist()
    [[0.0, 1.5], [1.0, 2.0]]
    """
    _refuse_many(text, name)
    lines = list(enumerate(re.split(r"\r\n|\r|\n", text.removeprefix("\ufeff")), start=1))
    start = _first_row(lines)
    if start is None:
        raise InputError([Problem("file", name, _("has no numbers in it"))])
    head = [line for number, line in lines if number < start and line.strip()]
    body = [(number, line) for number, line in lines if number >= start and line.strip() and not _COMMENT.match(line)]
    texts = tuple(line for _number, line in body)
    numbers = np.array([number for number, _line in body], dtype=np.intp)
    separator = _separator(texts)
    n_columns = len(_cells(texts[0], separator))
    labels = _labels(head, separator, n_columns)
    _refuse_two_commas(texts, labels, separator, Position(name, int(numbers[0])))
    rows = _numbers(texts, separator, n_columns)
    if rows is None:
        raise InputError(_few_of(_problems(body, separator, name), name))
    return NumberTable(name, labels, rows, numbers, texts, separator)


def _refuse_many(text: str, name: str) -> None:
    """Refuse a file of more lines than a curve needs."""
    n_lines = max(text.count("\n"), text.count("\r"))
    if n_lines > _MOST_LINES:
        allowed = _("has {n} lines; {most} at most are read, and a cycle of 720° in steps of 0.02° has 36 000")
        repair = _("keep one row of {n}, or the mean of so many", n=-(-n_lines // _MOST_LINES))
        raise InputError([Problem("file", name, allowed.format(n=n_lines, most=_MOST_LINES), repair)])


def _first_row(lines: Sequence[tuple[int, str]]) -> int | None:
    """Line of the first row: it and what follows begin with a number; a title may begin with one, too."""
    written = [(number, bool(_STARTS_AS_NUMBER.match(line))) for number, line in lines if line.strip()]
    written.append((0, True))
    return next((number for (number, is_row), (_next, next_is) in pairwise(written) if is_row and next_is), None)


def _separator(lines: Sequence[str]) -> str:
    """Tell what divides the columns: a tab, a semicolon, blanks (given as one) or a comma."""
    if any("\t" in line.strip() for line in lines):
        return "\t"
    if any(";" in line for line in lines):
        return ";"
    return " " if re.search(r"[0-9.]\s+[+\-−]?[.,]?[0-9]", lines[0]) else ","


def _parts(line: str, separator: str) -> list[str]:
    """Divide a line; a separator at its end divides nothing."""
    return line.rstrip().removesuffix(separator).split(separator)


def _cells(line: str, separator: str) -> list[str]:
    """Texts of a line's fields."""
    if separator == " ":
        return line.split()
    return [part.strip().strip("\"'") for part in _parts(line, separator)]


def _starts(line: str, separator: str) -> list[int]:
    """Where each of a line's fields begins, counted from 1."""
    if separator == " ":
        return [found.start() + 1 for found in re.finditer(r"\S+", line)]
    parts = _parts(line, separator)
    starts = accumulate((len(part) + 1 for part in parts[:-1]), initial=1)
    return [start + len(part) - len(part.lstrip()) for start, part in zip(starts, parts, strict=True)]


def _numbers(texts: Sequence[str], separator: str, n_columns: int) -> Array | None:
    """Numbers of all lines, shape (row, column); None if some are none, or not as many as in the first line."""
    rows = np.empty((len(texts), n_columns))
    for row, text in enumerate(texts):
        cells = _cells(_plain(text, separator), separator)
        if len(cells) != n_columns or not all(map(_NUMBER.fullmatch, cells)):
            return None
        rows[row] = [float(cell) for cell in cells]
    return rows if np.max(np.abs(rows)) <= _LARGEST else None


def _labels(head: Sequence[str], separator: str, n_columns: int) -> tuple[str, ...]:
    """Join the header's lines column by column; lines with another number of columns are titles."""
    split = [_head_cells(_COMMENT.sub("", line, count=1), separator, n_columns) for line in head]
    of_columns = [cells for cells in split if len(cells) == n_columns]
    return tuple(" ".join(cells).strip() for cells in zip(*of_columns, strict=True))


def _head_cells(line: str, separator: str, n_columns: int) -> list[str]:
    """Divide a line of the header: words of one head have single blanks between them, commas of a head are quoted."""
    cells = _cells(line, separator)
    if len(cells) == n_columns or separator not in " ,":
        return cells
    others = re.split(r"\s{2,}", line.strip()) if separator == " " else next(csv.reader([line], skipinitialspace=True))
    return others if len(others) == n_columns else cells


def _plain(text: str, separator: str) -> str:
    """Write a number with a decimal point and a plain minus."""
    ours = text.replace("−", "-")
    return ours if separator == "," else ours.replace(",", ".")


def _refuse_two_commas(texts: Sequence[str], labels: Sequence[str], separator: str, first: Position) -> None:
    """Refuse a file whose commas may divide columns as well as numbers."""
    cells = _cells(texts[0], separator)
    if separator == "," and len(cells) > 2 and not labels and not any("." in text for text in texts):
        allowed = _("commas may stand here for decimal points or between columns, which cannot be told apart")
        repair = _("divide the columns by semicolons or tabs, or write decimal points")
        raise InputError([Problem("", ",".join(cells), allowed, repair, first)])


def _problems(body: Sequence[tuple[int, str]], separator: str, name: str) -> Iterator[Problem]:
    """Find lines of another length and what is no number."""
    expected = len(_cells(body[0][1], separator))
    for number, line in body:
        row = _cells(line, separator)
        if len(row) != expected:
            allowed = _("must have {expected} values, as the first line of numbers has", expected=expected)
            yield Problem("", _("{n} values", n=len(row)), allowed, None, Position(name, number))
        else:
            for cell, column in zip(row, _starts(line, separator), strict=True):
                text = _plain(cell, separator)
                is_number = _NUMBER.fullmatch(text) is not None
                if not is_number or abs(float(text)) > _LARGEST:
                    allowed = _("is beyond the size of any machine") if is_number else _("must be a number")
                    yield Problem("", cell or '""', allowed, None, Position(name, number, column))


def _few_of(problems: Iterator[Problem], name: str) -> Iterator[Problem]:
    """Keep the first problems, and count the others."""
    return first_of(problems, lambda n: Problem("file", name, _("{n} more lines or values like these", n=n)))
