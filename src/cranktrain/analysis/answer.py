"""Lines of an answer by the titles of the questions, each computed when somebody asks for it."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, Protocol

from cranktrain.analysis.outcomes import Outcomes
from cranktrain.grouping import grouped
from cranktrain.language import Words
from cranktrain.layout.question import needs_of
from cranktrain.machine import Machine
from cranktrain.mechanisms import KINDS
from cranktrain.saying.rows import AnswerLine, Telling


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
    return tuple(title for title, functions in _functions(result).items() if any(map(_has_needs(result), functions)))


def answer_kinds(result: Answering) -> set[type]:
    """Types of all that the lines of the answer ask for."""
    functions = (rows_of for each in _functions(result).values() for rows_of in each)
    return {kind for function in functions for kind in needs_of(function).types.values()}


def rows_under(result: Answering, title: str, design: int = 0) -> list[AnswerLine]:
    """Lines under a title, for one design: of all questions that share it, as far as there is anything to say.

    What kinds of mechanisms have of their own stands with the first question.
    """
    functions = filter(_has_needs(result), _functions(result).get(title, ()))
    return [row for rows_of in functions for row in _rows(result, rows_of, design) if row.says]


def _functions(result: Answering) -> dict[str, list[_RowsOf]]:
    """What says the lines of an answer, by the titles under which it says them."""
    machine = result.machines[0]
    own = tuple(rows for kind in machine.kinds for rows in KINDS.named(kind).rows)
    first = machine.questions[0]
    return grouped(
        (question.title, rows_of)
        for question in machine.questions
        for rows_of in (*question.rows, *(own if question is first else ()))
    )


def _has_needs(result: Answering) -> Callable[[_RowsOf], bool]:
    """Say whether what a function asks for is in a result, or can be computed."""

    def holds(function: _RowsOf) -> bool:
        needs = needs_of(function)
        return all(kind in result.computed.kinds for name, kind in needs.types.items() if name not in needs.optional)

    return holds


def _rows(result: Answering, function: _RowsOf, design: int) -> Iterable[AnswerLine]:
    """Rows of one function."""
    found: dict[str, object] = {name: result.get(kind) for name, kind in needs_of(function).types.items()}
    return function(Telling(result.labels, result.titles, design, result.cycle), **found)
