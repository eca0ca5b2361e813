"""Lines of an answer by the titles of the questions, each computed when somebody asks for it."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import lru_cache
from typing import Any, Protocol

from cranktrain.analysis.outcomes import Outcomes
from cranktrain.analysis.stages import KEPT
from cranktrain.grouping import grouped
from cranktrain.language import Words
from cranktrain.layout.question import needs_of
from cranktrain.machine import Machine
from cranktrain.mechanisms import KINDS
from cranktrain.saying.rows import AnswerLine, Telling

_MOST = 2
"""Rows that are said in one sentence."""


class Answering(Protocol):
    """What an answer is told of: a result."""

    @property
    def machines(self) -> Sequence[Machine]:
        """Whose it is, a machine for each design."""
        ...

    @property
    def computed(self) -> Outcomes:
        """What was found, or will be when somebody asks for it."""
        ...

    @property
    def labels(self) -> Mapping[str, Sequence[str]]:
        """Names of the members along each dimension."""
        ...

    @property
    def titles(self) -> Mapping[str, Sequence[Words]]:
        """What people call them."""
        ...

    @property
    def cycle(self) -> float:
        """Crank angle at which all begins again. [deg]"""
        ...

    def get(self, kind: Any) -> Any:
        """Give what a stage gave by its type; None where there is none."""
        ...


_RowsOf = Callable[..., Iterable[AnswerLine]]


def answer_titles(result: Answering) -> tuple[str, ...]:
    """Titles under which there may be lines: of questions that have what they tell of. Nothing is computed."""
    return tuple(title for title, functions in _functions(result).items() if functions)


def answer_kinds(result: Answering) -> set[type]:
    """Types of all that the lines of the answer ask for."""
    functions = (rows_of for each in _functions(result).values() for rows_of in each)
    return {kind for function in functions for kind in needs_of(function).types.values()}


def answer_groups(result: Answering, design: int = 0) -> Iterator[tuple[str, list[AnswerLine]]]:
    """Lines of the answer for one design under their titles, if there are any."""
    for title, functions in _functions(result).items():
        rows = _rows(result, functions, design)
        if rows:
            yield title, rows


def rows_under(result: Answering, title: str, design: int = 0) -> list[AnswerLine]:
    """Lines under one title, for one design: of all questions that share it, as far as there is anything to say."""
    return _rows(result, _functions(result).get(title, ()), design)


def rows_that_say_most(result: Answering, title: str, rows: Sequence[AnswerLine]) -> list[AnswerLine]:
    """Give those of the rows under a title that tell of the headlines of its questions; the first where none does."""
    questions = (question for question in result.machines[0].questions if question.title == title)
    names = (name for question in questions for name in question.headline)
    places = (next((place for place, row in enumerate(rows) if name in row.quantities), None) for name in names)
    chosen = [place for place in dict.fromkeys(places) if place is not None]
    return [rows[place] for place in chosen[:_MOST]] or list(rows[:1])


def _functions(result: Answering) -> dict[str, list[_RowsOf]]:
    """What says the lines of an answer by the titles under which it says them, where it has what it asks for.

    What kinds of mechanisms have of their own stands with the first question.
    """
    machine = result.machines[0]
    own = tuple(rows for kind in machine.kinds for rows in KINDS.named(kind).rows)
    first = machine.questions[0]
    return grouped(
        (question.title, rows_of)
        for question in machine.questions
        for rows_of in (*question.rows, *(own if question is first else ()))
        if all(_is_there(result, kind) for kind in needs_of(rows_of).required)
    )


def _is_there(result: Answering, kind: type) -> bool:
    """Whether a result has what a stage gives by its type, or can compute it."""
    return kind in _with_bases(tuple(result.computed.kinds))


@lru_cache(maxsize=KEPT)
def _with_bases(kinds: tuple[type, ...]) -> frozenset[type]:
    """Give classes with all of which they are."""
    return frozenset(base for kind in kinds for base in kind.__mro__)


def _rows(result: Answering, functions: Iterable[_RowsOf], design: int) -> list[AnswerLine]:
    """Rows of some functions that say anything."""
    telling = Telling(result.labels, result.titles, design, result.cycle)
    found = (
        rows_of(telling, **{name: result.get(kind) for name, kind in needs_of(rows_of).types.items()})
        for rows_of in functions
    )
    return [row for rows in found for row in rows if row.says]
