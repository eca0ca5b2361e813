"""Any table of numbers as text: its separator, its decimal sign, its header, each number with its place."""

import re
from collections.abc import Iterator, Sequence
from itertools import pairwise

from cranktrain.errors import InputError, Position, Problem
from cranktrain.language import _
from cranktrain.record import record

_NUMBER = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")
_STARTS_AS_NUMBER = re.compile(r"\s*[\"']?[+\-−]?[.,]?[0-9]")
_COMMENT = re.compile(r"\s*(?:#|%|//)\s*")
_LARGEST = 1e30
_MOST_PROBLEMS = 10
"""Problems told of one file; a file of another kind has one in every line."""


@record
class Table:
    """A table of numbers.

    Attributes
    ----------
    labels : tuple of str
        Header of each column, its lines joined by blanks; empty without a header.
    lines : tuple of int
        Line of the file of each row, from 1.
    rows : tuple of tuple of float
    columns : tuple of tuple of int
        Where each number begins in its line, from 1.
    """

    labels: tuple[str, ...]
    lines: tuple[int, ...]
    rows: tuple[tuple[float, ...], ...]
    columns: tuple[tuple[int, ...], ...]


@record
class _Field:
    """A field of a line: its text without blanks and quotes, and its column from 1."""

    text: str
    column: int


def read_table(text: str, name: str) -> Table:
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
    Table
        Every row as long as the first.

    Raises
    ------
    InputError
        With what is wrong, at line and column.

    Examples
    --------
    >>> read_table("angle;p\n0;1,5\n1;2", "a.csv").rows
    ((0.0, 1.5), (1.0, 2.0))
    """
    lines = list(enumerate(re.split(r"\r\n|\r|\n", text.removeprefix("\ufeff")), start=1))
    start = _first_row(lines)
    if start is None:
        raise InputError([Problem("file", name, _("has no numbers in it"))])
    head = [line for number, line in lines if number < start and line.strip()]
    body = [(number, line) for number, line in lines if number >= start and line.strip() and not _COMMENT.match(line)]
    separator = _separator([line for _number, line in body])
    fields = [(number, _fields(line, separator)) for number, line in body]
    labels = _labels(head, separator, len(fields[0][1]))
    problems = [*_comma_problems(fields, labels, separator, name)]
    if not problems:
        problems = [*_problems(fields, separator, name)]
    if problems:
        raise InputError(_first_of(problems, name))
    return Table(
        labels=labels,
        lines=tuple(number for number, _row in fields),
        rows=tuple(tuple(float(_plain(field.text, separator)) for field in row) for _number, row in fields),
        columns=tuple(tuple(field.column for field in row) for _number, row in fields),
    )


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


def _fields(line: str, separator: str) -> tuple[_Field, ...]:
    """Divide a line; a separator at its end divides nothing."""
    if separator == " ":
        return tuple(_Field(found[0], found.start() + 1) for found in re.finditer(r"\S+", line))
    found: list[_Field] = []
    place = 0
    for part in line.rstrip().removesuffix(separator).split(separator):
        blanks = len(part) - len(part.lstrip())
        found.append(_Field(part.strip().strip("\"'"), place + blanks + 1))
        place += len(part) + 1
    return tuple(found)


def _labels(head: Sequence[str], separator: str, n_columns: int) -> tuple[str, ...]:
    """Join the header's lines column by column; lines with another number of columns are titles."""
    split = [[field.text for field in _fields(_COMMENT.sub("", line, count=1), separator)] for line in head]
    of_columns = [cells for cells in split if len(cells) == n_columns]
    return tuple(" ".join(cells).strip() for cells in zip(*of_columns, strict=True))


def _plain(text: str, separator: str) -> str:
    """Write a number with a decimal point and a plain minus."""
    ours = text.replace("−", "-")
    return ours if separator == "," else ours.replace(",", ".")


def _comma_problems(
    fields: Sequence[tuple[int, tuple[_Field, ...]]], labels: Sequence[str], separator: str, name: str
) -> Iterator[Problem]:
    """Refuse a file whose commas may divide columns as well as numbers."""
    number, first = fields[0]
    has_point = any("." in field.text for _number, row in fields for field in row)
    if separator == "," and len(first) > 2 and not has_point and not labels:
        allowed = _("commas may stand here for decimal points or between columns, which cannot be told apart")
        repair = _("divide the columns by semicolons or tabs, or write decimal points")
        yield Problem("", ",".join(field.text for field in first), allowed, repair, Position(name, number))


def _problems(fields: Sequence[tuple[int, tuple[_Field, ...]]], separator: str, name: str) -> Iterator[Problem]:
    """Find lines of another length and what is no number."""
    expected = len(fields[0][1])
    for number, row in fields:
        if len(row) != expected:
            allowed = _("must have {expected} values, as the first line of numbers has").format(expected=expected)
            yield Problem("", _("{n} values").format(n=len(row)), allowed, None, Position(name, number))
        else:
            for field in row:
                text = _plain(field.text, separator)
                is_number = _NUMBER.fullmatch(text) is not None
                if not is_number or abs(float(text)) > _LARGEST:
                    allowed = _("is beyond the size of any machine") if is_number else _("must be a number")
                    yield Problem("", field.text or '""', allowed, None, Position(name, number, field.column))


def _first_of(problems: Sequence[Problem], name: str) -> Sequence[Problem]:
    """Keep the first problems, and count the others."""
    if len(problems) <= _MOST_PROBLEMS:
        return problems
    rest = _("{n} more lines or values like these").format(n=len(problems) - _MOST_PROBLEMS)
    return (*problems[:_MOST_PROBLEMS], Problem("file", name, rest))
