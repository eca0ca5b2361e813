"""What the program says late, as text: warnings, needs, problems, rows of the answer."""

from collections.abc import Iterable
from itertools import dropwhile, takewhile
from typing import NamedTuple

import cranktrain as ct
from cranktrain.errors import Problem
from cranktrain.language import Words
from cranktrain.saying.rows import AnswerLine


def texts_of(words: Iterable[Words]) -> tuple[str, ...]:
    """Say each of them."""
    return tuple(map(str, words))


class ToldProblem(NamedTuple):
    """A problem as text, but for where it stands."""

    path: str
    given: str | None
    allowed: str
    repair: str | None


def problems_told(problems: Iterable[Problem]) -> list[ToldProblem]:
    """Say each of them."""
    return [ToldProblem(one.path, _or_none(one.given), str(one.allowed), _or_none(one.repair)) for one in problems]


def _or_none(words: Words | None) -> str | None:
    return None if words is None else str(words)


def row_of(result: ct.Result, title: str, name: str) -> AnswerLine:
    """The one row of the answer with a name under a title."""
    (found,) = (row for one, rows in result.rows() if str(one) == title for row in rows if str(row.name) == name)
    return found


def lines_of(result: ct.Result, title: str) -> list[str]:
    """What the summary says under a title, a line each; nothing without that title."""
    _title, *below = dropwhile(lambda line: line != title, [*result.summary().splitlines(), title])
    return [line.removeprefix("  ") for line in takewhile(lambda line: line.startswith("  "), below)]


def line_of(result: ct.Result, title: str, name: str) -> str:
    """What the one line with a name under a title says behind it."""
    (found,) = (line.removeprefix(f"{name}: ") for line in lines_of(result, title) if line.startswith(f"{name}: "))
    return found
