"""Two machines side by side: their answers, and by how much they differ."""

from collections.abc import Iterator, Mapping
from contextlib import AbstractContextManager
from dataclasses import replace
from functools import cached_property
from html import escape
from typing import Any, NamedTuple

import numpy as np

from cranktrain.analysis.fact_values import FactValues, OneMachine, fact_values, headline_names
from cranktrain.analysis.figures import compared_texts
from cranktrain.analysis.result import Result
from cranktrain.errors import Problem, refuse
from cranktrain.faces import face
from cranktrain.grouping import grouped
from cranktrain.language import N_, Listed, Words, _
from cranktrain.motion import Array
from cranktrain.one_line import one_line, short
from cranktrain.quantities import FileUnits, shown_as_in
from cranktrain.record import record
from cranktrain.saying.catalogue import Entry
from cranktrain.saying.run import BehindQuantity, Run
from cranktrain.saying.sections import Compared, ComparedFact, PagePart

_LONGEST_HEAD = 10
"""Characters of a column's head; the machines' whole names stand above."""


class ComparedRow(NamedTuple):
    """A fact of two machines.

    question, quantity: whose it is and its name in the catalogue; of: which of its members; unit: the catalogue's, in
    which first, second and difference are; NaN where a machine has none. percent: of the first.
    """

    question: str
    quantity: str
    of: str
    unit: str
    first: float
    second: float
    difference: float
    percent: float


def compared(
    results: tuple[Result, Result], names: tuple[str, str], asked: tuple[str, ...] | None = None
) -> "Comparison":
    """Compare two results.

    Parameters
    ----------
    results : tuple of two Result
        Each of one machine.
    names : tuple of two str
        Of the machines.
    asked : tuple of str, optional
        Names of quantities; the headlines of all questions unless given.

    Returns
    -------
    Comparison

    Raises
    ------
    InputError
        With every quantity that neither has, and what it needs.
    """
    refuse(_absence(name, results) for name in asked or () if not any(name in result.catalogue for result in results))
    return Comparison(results, names, asked)


@record
class Comparison(Run):
    """Two machines side by side.

    Attributes
    ----------
    results : tuple of two Result
        Each of one machine.
    names : tuple of two str
        As they were named.
    asked : tuple of str, or None
        Quantities; the headlines of all questions unless given.
    """

    results: tuple[Result, Result]
    names: tuple[str, str]
    asked: tuple[str, ...] | None = None

    @cached_property
    def _rows(self) -> tuple[FactValues, ...]:
        names = headline_names(self.results) if self.asked is None else self.asked
        return tuple(fact_values([OneMachine(result) for result in self.results], names))

    @property
    def rows(self) -> tuple[ComparedRow, ...]:
        """Every fact that at least one of them has, in the order of the questions."""
        return tuple(_compared(row) for row in self._rows)

    @property
    def subject(self) -> Words:
        """What stands beside each other."""
        return " — ".join(self.names)

    @property
    def catalogue(self) -> Mapping[str, Entry]:
        """The facts that are compared, along `machine` and their own dimensions."""
        return self._catalogue

    @cached_property
    def _catalogue(self) -> dict[str, Entry]:
        found: dict[str, Entry] = {}
        for row in self._rows:
            if row.entry.is_fact:
                found[row.entry.name] = replace(row.entry, dimensions=("machine", *row.entry.dimensions))
        return found

    @property
    def labels(self) -> Mapping[str, tuple[str, ...]]:
        """The machines, and the members that any of them has along each other dimension."""
        names = {dimension for entry in self.catalogue.values() for dimension in entry.dimensions[1:]}
        every = {
            name: tuple(dict.fromkeys(label for one in self.results for label in one.labels.get(name, ())))
            for name in sorted(names)
        }
        return {"machine": self.names, **every}

    def __getattr__(self, name: str) -> Array:
        """Give a fact of both, in the unit of its entry; NaN where a machine has none, or no such member."""
        if name.startswith("_") or name not in self.catalogue:
            raise AttributeError(name)
        dimensions = self.catalogue[name].dimensions[1:]
        found = np.full((len(self.results), *(len(self.labels[one]) for one in dimensions)), np.nan)
        for place, result in enumerate(self.results):
            if name in result.catalogue:
                own = result.labels_of(result.catalogue[name])
                where = [[self.labels[one].index(label) for label in labels] for one, labels in own.items()]
                found[np.ix_([place], *where)] = getattr(result, name)
        return found

    def about(self) -> Iterator[tuple[str, Words]]:
        """What heads a file of it: both machines."""
        for result, name in zip(self.results, self.names, strict=True):
            yield "machine", Listed((name, result.machines[0].name), ": ")

    def before(self) -> Mapping[str, object]:
        """What a .json has before its numbers: both machines."""
        return {"machines": {name: one.machines[0].name for name, one in zip(self.names, self.results, strict=True)}}

    def in_its_units(self) -> AbstractContextManager[None]:
        """Show numbers in the units of the first machine, as far as nobody chose others."""
        units: FileUnits = face("units_of")(self.results[0].machines[0])
        return shown_as_in(units)

    def plot(self, *quantities: str, **_members: object) -> Any:
        """Lay the curves of both over each other.

        Parameters
        ----------
        *quantities : str
            Names of curves; the main ones of the machines unless given.

        Returns
        -------
        matplotlib.figure.Figure

        Raises
        ------
        InputError
            Where neither machine has such a curve.
        """
        with self.in_its_units():
            return face("plot_comparison")(self, *quantities)

    def sections(self) -> Iterator[PagePart]:
        """Facts of both side by side, question by question."""
        groups = grouped((row.question, row) for row in self._rows)
        if not groups:
            yield _("Neither machine has a result that could be compared.")
            return
        yield Compared(self._heads(), [(_title(question), list(map(_fact, rows))) for question, rows in groups.items()])

    def behind(self, name: str) -> BehindQuantity | None:
        """What leads to a fact in the first machine; None where it has none."""
        return self.results[0].behind(name) if name in self.results[0].catalogue else None

    def _heads(self) -> tuple[Words, Words]:
        """Names short enough for a column: of a machine with other values, these are named above."""
        first, second = (one_line(name) for name in self.names)
        if second.startswith(f"{first} ") and first:
            return _brief_name(first), _("changed")
        one, other = _brief_name(first), _brief_name(second)
        return (one, other) if one and other and one != other else (_("first"), _("second"))

    def __repr__(self) -> str:
        """Say in one line what it is."""
        first, second = (short(name) for name in self.names)
        n_rows = len(self._rows)
        rows = _("1 row") if n_rows == 1 else _("{n} rows", n=n_rows)
        return str(_("<Comparison of {first} and {second}: {rows}>", first=first, second=second, rows=rows))

    def __str__(self) -> str:
        """Write it as a table."""
        return self.page().lstrip("\n")

    def _repr_html_(self) -> str:
        """Write it as a table of a notebook."""
        titles = map(str, ("", *self._heads(), "", _("difference"), "%"))
        heads = "".join(f"<th>{escape(text)}</th>" for text in titles)
        parts = [f"<p>{escape(' — '.join(self.names))}</p><table><thead><tr>{heads}</tr></thead><tbody>"]
        for question, rows in grouped((row.question, row) for row in self._rows).items():
            title = escape(str(_title(question)))
            parts.append(f'<tr><th colspan="6" style="text-align:left">{title}</th></tr>')
            for row in rows:
                with self.in_its_units():
                    texts = "".join(f"<td>{escape(text)}</td>" for text in compared_texts(_fact(row)))
                parts.append(f'<tr><td style="text-align:left">{escape(row.name)}</td>{texts}</tr>')
        return "".join([*parts, "</tbody></table>"])


def _title(question: str) -> Words:
    """Title of a question's facts, or of those of none."""
    return _(question.capitalize() if question else N_("More"))


def _brief_name(name: str) -> str:
    """Name a machine in the head of a column: of a file without its folder."""
    return short(name.removesuffix(".toml").rpartition("/")[2], _LONGEST_HEAD)


def _absence(name: str, results: tuple[Result, Result]) -> Problem:
    """Say what a quantity needs that neither machine gives."""
    needs = next((needs for result in results if (needs := result.needs_of(name))), ())
    allowed = _("is a result of neither machine")
    if needs:
        allowed = _("is a result of neither machine; it needs {needs}", needs=", ".join(map(str, needs)))
    return Problem("quantities", name, allowed)


def _compared(row: FactValues) -> ComparedRow:
    first, second = row.values
    return ComparedRow(
        row.question, row.entry.name, row.of, row.entry.unit, first, second, second - first, _percent(row)
    )


def _percent(row: FactValues) -> float:
    """By how much the second is more, in percent of the first; none of places, nor of 0."""
    first, second = row.values
    is_place = row.entry.is_place
    if first == second and np.isfinite(first) and not is_place:
        return 0.0
    if is_place or first == 0.0 or not np.isfinite(second - first):
        return np.nan
    return 100.0 * (second - first) / abs(first)


def _fact(row: FactValues) -> ComparedFact:
    """A fact as it is shown."""
    first, second = row.values
    return ComparedFact(row.called, row.entry.shown, first, second, _percent(row))
