"""Designs of a sweep one by one: a .csv with a path of the machine file at the head of each column."""

import csv
import re
import tomllib
from collections.abc import Sequence
from dataclasses import replace
from io import StringIO
from pathlib import Path
from typing import NamedTuple, TypeAlias

from cranktrain.errors import InputError, Position, Problem, refuse
from cranktrain.io.curve_files import curve_text
from cranktrain.language import N_
from cranktrain.language import said as _
from cranktrain.study.sweep.varied import names_of, whole_word

_COMMA = re.compile(r"([+−-]?\d+),(\d+(?:[eE][+-]?\d+)?)(?![\d,.])(.*)", re.DOTALL)
"""A number whose decimals a comma divides, and what stands behind it."""
_IN_BRACKETS, _IN_ROUND_BRACKETS = re.compile(r"(.*?)\s*\[([^\[\]]*)\]"), re.compile(r"(.*?)\s*\(([^()]*)\)")
"""A head and its unit."""


_WRITTEN, _VARIED = "# cranktrain: ", re.compile(r"# varied: (.*): [^:]*")
"""Remarks above a list that a sweep has written, on what and how many values."""
_PLAIN_UNIT = "1"

Line: TypeAlias = tuple[Position, list[str]]
"""Cells of a line, and where it stands."""


class Head(NamedTuple):
    """What stands at the head of a column: a path, and the unit of plain numbers below it."""

    path: str
    unit: str


class Cases(NamedTuple):
    """Designs of a file: values of each by path, and where which paths head the columns."""

    designs: tuple[dict[str, object], ...]
    heads: tuple[Head, ...]
    position: Position

    def placed(self, problem: Problem) -> Problem:
        """Put what is wrong with the path of a column to its head, and all else to the file."""
        if problem.position is not None:
            return problem
        is_of_head = problem.given is None and problem.path in [one.path for one in self.heads]
        return replace(problem, position=self.position if is_of_head else Position(self.position.file))


def cases_of(name: str) -> Cases:
    """Read designs of a .csv.

    Parameters
    ----------
    name : str
        Of the file: a path at the head of each column, with the unit of plain numbers behind it in brackets. Columns
        are divided by semicolons or tabs, and then a comma may divide decimals as in curve files; or by commas. What
        is empty stays as the machine file has it; a table or a list is written as TOML has it in one line. Of a file
        that a sweep has written what was varied is taken, and facts are left.

    Returns
    -------
    Cases

    Raises
    ------
    InputError
        With the line and the column of what cannot be read.
    """
    text = curve_text(Path(name), name, N_("a list of designs")).removeprefix("\ufeff")
    separator = _separator(text)
    lines = [
        (Position(name, number), [cell.strip() for cell in line])
        for number, line in enumerate(csv.reader(StringIO(text), delimiter=separator), start=1)
        if any(cell.strip() for cell in line) and not line[0].lstrip().startswith("#")
    ]
    if len(lines) < 2:
        allowed = _("has no design: needs paths at the heads of columns, and a line below for each design")
        repair = _("write like rod_length [mm],speed [rpm], and below 130,1500")
        raise InputError([Problem("", None, allowed, repair, Position(name))])
    if (paths := _paths_written(text)) is not None:
        lines = _as_typed(lines, paths)
    (at_head, head), *designs = lines
    heads = _heads(head, at_head)
    return Cases(tuple(_design(line, heads, separator, position) for position, line in designs), heads, at_head)


def _paths_written(text: str) -> list[str] | None:
    """Paths of what is varied in a file that a sweep has written; None of any other file."""
    remarks = [line for line in text.splitlines() if line.startswith("#")]
    found = [match[1] for match in map(_VARIED.fullmatch, remarks) if match is not None]
    return found if found and remarks[0].startswith(_WRITTEN) else None


def _as_typed(lines: Sequence[Line], paths: Sequence[str]) -> list[Line]:
    """Columns of what is varied alone, with their paths at the head: as they are typed into a list of designs."""
    (at_head, head), *designs = lines
    first = 1 if head[0] == "case" else 0
    own = head[first : first + len(paths)]
    named = zip(own, names_of(paths), paths, strict=False)
    if len(own) < len(paths) or not all(_headed(cell).path in (name, whole_word(path)) for cell, name, path in named):
        allowed = _("has the facts of several designs side by side, as it was written of values that were combined")
        raise InputError([Problem("", None, allowed, _("vary them again, with --vary"), Position(at_head.file))])
    units = [cell.removeprefix(_headed(cell).path) for cell in own]
    typed = [f"{path}{unit}" for path, unit in zip(paths, units, strict=True)]
    return [(at_head, typed), *((position, line[first : first + len(paths)]) for position, line in designs)]


def _heads(line: Sequence[str], position: Position) -> tuple[Head, ...]:
    """Heads of columns; those behind the last that is not empty are none."""
    n_heads = max(place for place, cell in enumerate(line, start=1) if cell)
    heads = tuple(map(_headed, line[:n_heads]))
    paths = [one.path for one in heads]
    problems = [Problem(path, None, _("heads two columns"), position=position) for path in _twice(paths)]
    if "" in paths:
        allowed = _("column {n} has no head", n=paths.index("") + 1)
        problems.append(Problem("", None, allowed, _("write the path of what stands below it"), position))
    for path in paths:
        if (round_bracket := _IN_ROUND_BRACKETS.fullmatch(path)) is not None:
            repair = _('write "{text}"', text="{} [{}]".format(*round_bracket.groups()))
            problems.append(Problem(path, None, _("has its unit in round brackets"), repair, position))
    refuse(problems)
    return heads


def _twice(paths: Sequence[str]) -> list[str]:
    """Paths that stand twice."""
    return [path for path in dict.fromkeys(paths) if path and paths.count(path) > 1]


def _design(line: Sequence[str], heads: Sequence[Head], separator: str, position: Position) -> dict[str, object]:
    """Values of a design by path; what is empty is left out."""
    if len(line) < len(heads) or any(line[len(heads) :]):
        allowed = _("has {n} values, and {heads} columns have a head", n=len(line), heads=len(heads))
        repair = _("where a comma divides decimals, divide the columns by semicolons") if separator == "," else None
        if len(line) < len(heads):
            repair = _("a cell may be empty, between its separators: then the machine file's value stays")
        raise InputError([Problem("", separator.join(line), allowed, repair, position)])
    columns = zip(heads, line, strict=False)
    return {head.path: _value(cell, head, separator, position) for head, cell in columns if cell}


def _value(cell: str, head: Head, separator: str, position: Position) -> object:
    """What a cell holds: a text, or a table or list as TOML has it."""
    if cell[0] in "{[":
        try:
            return tomllib.loads(f"value = {cell}")["value"]
        except (tomllib.TOMLDecodeError, RecursionError):
            allowed = _("must be a table or a list as TOML has it, in one line")
            raise InputError([Problem(head.path, cell, allowed, position=position)]) from None
    plain = _plain(cell, head.path, separator, position)
    return plain.removesuffix(".0") if head.unit == _PLAIN_UNIT else f"{plain} {head.unit}".strip()


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


def _headed(cell: str) -> Head:
    """Path and unit of a column; a number in brackets is the item of a list, but for the unit [1] behind a blank."""
    found = _IN_BRACKETS.fullmatch(cell)
    is_item = found is not None and found[2].isdecimal() and not cell.endswith(f" [{_PLAIN_UNIT}]")
    return Head(cell, "") if found is None or is_item else Head(found[1], found[2].strip())
