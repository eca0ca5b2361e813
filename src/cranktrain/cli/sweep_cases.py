"""Designs of a sweep one by one: a .csv with a path of the machine file at the head of each column."""

import csv
import re
from collections.abc import Iterator
from io import StringIO
from pathlib import Path

from cranktrain.errors import InputError, Position, Problem, refuse
from cranktrain.io.curve_files import curve_text
from cranktrain.language import N_
from cranktrain.language import said as _

_COMMA = re.compile(r"([+−-]?\d+),(\d+(?:[eE][+-]?\d+)?)(?![\d,.])(.*)", re.DOTALL)
"""A number whose decimals a comma divides, and what stands behind it."""


def cases_of(name: str) -> Iterator[dict[str, object]]:
    """Read designs of a .csv.

    Parameters
    ----------
    name : str
        Of the file: a path at the head of each column, with the unit of plain numbers behind it in brackets. Columns
        are divided by semicolons or tabs, and then a comma may divide decimals as in curve files; or by commas.

    Yields
    ------
    dict of str
        Values of a design by path; what is empty is left out.

    Raises
    ------
    InputError
        With the line and the column of what cannot be read.
    """
    text = curve_text(Path(name), name, N_("a list of designs")).removeprefix("\ufeff")
    separator = _separator(text)
    paths: list[tuple[str, str]] | None = None
    for number, line in enumerate(csv.reader(StringIO(text), delimiter=separator), start=1):
        if not any(cell.strip() for cell in line) or line[0].lstrip().startswith("#"):
            continue
        if paths is None:
            paths = [_headed(cell) for cell in line]
            twice = [path for path, _unit in paths if [other for other, _other_unit in paths].count(path) > 1]
            refuse(Problem(path, None, _("heads two columns"), position=Position(name, number)) for path in twice[:1])
            continue
        if len(line) > len(paths):
            allowed = _("has {n} values, and {heads} columns have a head", n=len(line), heads=len(paths))
            repair = _("where a comma divides decimals, divide the columns by semicolons") if separator == "," else None
            raise InputError([Problem("", separator.join(line), allowed, repair, Position(name, number))])
        yield {
            path: f"{_plain(cell.strip(), path, separator, Position(name, number))} {unit}".strip()
            for (path, unit), cell in zip(paths, line, strict=False)
            if cell.strip()
        }


def _separator(text: str) -> str:
    """What divides the columns, by the first line that is no remark."""
    head = next((line for line in text.splitlines() if line.strip() and not line.lstrip().startswith("#")), "")
    if "\t" in head.strip():
        return "\t"
    return ";" if head.count(";") > head.count(",") else ","


def _plain(cell: str, path: str, separator: str, position: Position) -> str:
    """A cell with a decimal point, where a comma divided the decimals of its number."""
    found = _COMMA.fullmatch(cell)
    if found is None:
        return cell
    written = f"{found[1]}.{found[2]}{found[3]}"
    if separator == ",":
        allowed = _("has a comma in a number, and commas divide the columns here")
        raise InputError([Problem(path, cell, allowed, _('write "{text}"', text=written), position)])
    return written


def _headed(cell: str) -> tuple[str, str]:
    """Path and unit of a column."""
    path, bracket, unit = cell.strip().rpartition(" [")
    return (path.strip(), unit.removesuffix("]").strip()) if bracket and unit.endswith("]") else (cell.strip(), "")
