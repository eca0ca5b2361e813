"""Values of facts of one machine or of several side by side: a row for what stands alike in all of them."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from cranktrain.all_questions import QUESTIONS
from cranktrain.analysis.figures import shown_in, text_in
from cranktrain.analysis.members import Labelled, rows_of
from cranktrain.analysis.result import Result
from cranktrain.grouping import grouped
from cranktrain.language import Said, Words
from cranktrain.layout.question import Question
from cranktrain.record import record
from cranktrain.saying.catalogue import Entry
from cranktrain.saying.names import said_name


@dataclass(frozen=True, slots=True, repr=False)
class FactName(Said):
    """A fact in words, with whose it is."""

    entry: Entry
    of: str

    def said(self, say: Callable[[object], object]) -> str:
        """Say it."""
        return ", ".join((self.entry.words, *map(said_name, self.of.split(", ")))) if self.of else self.entry.words


@record
class FactValues:
    """A fact of one machine or several.

    Attributes
    ----------
    question : str
        Whose fact it is.
    entry : Entry
    of : str
        Whose of the machine's parts, or which of them: `L`, `mode 1`, `largest`; empty where there is one alone.
    values : tuple of float
        Of each machine, in the entry's unit; NaN where it has none.
    """

    question: str
    entry: Entry
    of: str
    values: tuple[float, ...]

    @property
    def called(self) -> Words:
        """The fact in words, with whose it is."""
        return FactName(self.entry, self.of)

    @property
    def name(self) -> str:
        """The same here and now."""
        return str(self.called)

    @property
    def texts(self) -> tuple[tuple[str, ...], str]:
        """The values as they are shown, and their unit."""
        shown = shown_in(self.entry.shown, np.array(self.values))
        return tuple(text_in(shown, value) for value in self.values), shown.label


class OneMachine(NamedTuple):
    """A result and which of its designs."""

    result: Result
    design: int = 0

    def fact(self, name: str) -> Labelled | None:
        """Give a fact with the labels of its dimensions, or None where it has none; of a curve its values."""
        entry = self.result.catalogue.get(name)
        if entry is None:
            return None
        values = np.asarray(getattr(self.result, name), dtype=np.float64)
        return Labelled(values[self.design] if self.result.has_designs else values, self.result.titles_of(entry))


def headline_names(results: Sequence[Result]) -> tuple[str, ...]:
    """Name the facts that say most, question by question, which at least one of some results has."""
    named = (name for question in _asked(results) for name in question.headline)
    return tuple(name for name in named if any(name in result.catalogue for result in results))


def _asked(results: Sequence[Result]) -> list[Question]:
    """Questions that at least one of some machines is asked, in their order."""
    names = {name for result in results for name in result.machines[0].asks}
    return [QUESTIONS.named(name) for name in QUESTIONS.names if name in names]


def _question_of(name: str, questions: Sequence[Question]) -> str:
    """Question whose stage gives a quantity; empty for what a kind of mechanism or a textbook gives."""
    return next((one.name for one in questions if any(name in stage.results for stage in one.stages)), "")


def fact_values(machines: Sequence[OneMachine], names: Sequence[str]) -> Iterator[FactValues]:
    """Give the rows of some quantities.

    Parameters
    ----------
    machines : sequence of OneMachine
    names : sequence of str
        Of facts, or of curves: of these the smallest and the largest value.

    Yields
    ------
    FactValues
        In the order of the questions. Where machines have the same members, those that are equal in all of them share a
        row; where they have others, or many that differ, the smallest and the largest stand beside each other.
    """
    questions = _asked([one.result for one in machines])
    place = {question.name: i for i, question in enumerate(questions)}
    by_question = grouped((_question_of(name, questions), name) for name in names)
    for question in sorted(by_question, key=lambda one: place.get(one, len(place))):
        for name in by_question[question]:
            found = [one.fact(name) for one in machines]
            entry = next((one.result.catalogue[name] for one in machines if name in one.result.catalogue), None)
            if entry is not None:
                rows = (FactValues(question, entry, of, values) for of, values in rows_of(entry, found))
                yield from (row for row in rows if np.any(np.isfinite(row.values)))
