"""A sweep: facts of a machine over values of its file."""

import itertools
import re
from collections.abc import Iterator, Mapping
from contextlib import AbstractContextManager
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from cranktrain.analysis.dimensions import Titled
from cranktrain.errors import InputError, Problem
from cranktrain.faces import face
from cranktrain.grouping import grouped, places_of_equal
from cranktrain.language import Listed, Words, _
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.numerics.ties import first_largest
from cranktrain.one_line import short
from cranktrain.quantities import FileUnits, nearest, shown_as_in
from cranktrain.record import record
from cranktrain.saying.catalogue import Entry
from cranktrain.saying.names import said_name
from cranktrain.saying.run import Axis, BehindQuantity, Marks, RowHeads, Run
from cranktrain.saying.sections import PagePart, section
from cranktrain.study.facts_of_rows import FactsOfRows
from cranktrain.study.sweep.kept import stopped
from cranktrain.study.sweep.shown import FactsAlong, shown_facts
from cranktrain.study.sweep.varied import SweptDesigns, Varied

_FIGURES = 9
"""Of its size, in which columns of members that share one are alike."""
_MOST_SENTENCES = 6
_NUMBER = re.compile(r"[+−-]?[\d.,]+(e[+−-]?\d+)?")
"""In a sentence, which else is the same of all designs."""


@record
class Sweep(Run):
    """Facts of a machine over values of its file.

    Every fact of `catalogue` is an attribute: an array along what is varied, and along its own dimensions. What is
    varied first among numbers is the `axis`, and stands last; NaN where a design cannot be.

    Attributes
    ----------
    machine : Machine
        Of which the designs are variants.
    designs : SweptDesigns
    found : FactsOfRows
    """

    machine: Machine
    designs: SweptDesigns
    found: FactsOfRows

    @cached_property
    def along(self) -> tuple[Varied, ...]:
        """Along what facts stand: what is varied, or the cases of a list."""
        return self.designs.dimensions

    @property
    def shape(self) -> tuple[int, ...]:
        """How many values there are along each."""
        return self.designs.shape

    @cached_property
    def over(self) -> int | None:
        """Which of them is the axis."""
        return next((place for place, one in enumerate(self.along) if one.numbers is not None), None)

    def dimensions_of(self, entry: Entry | None = None) -> tuple[str, ...]:
        """Along what a fact's array stands: what is varied, its own dimensions, the axis; of None what is no fact."""
        beside = tuple(one.name for place, one in enumerate(self.along) if place != self.over)
        over = () if self.over is None else (self.along[self.over].name,)
        return (*beside, *(() if entry is None else entry.dimensions), *over)

    @property
    def subject(self) -> Words:
        """Whose they are, and over what."""
        over = Listed(tuple(said_name(one.spoken) for one in self.designs.varied), " × ")
        return _("{name}, over {varied}", name=short(self.machine.name) or _("Machine without a name"), varied=over)

    @property
    def axis(self) -> Axis | None:
        """The first of the numbers that are varied."""
        return next(iter(self.number_axes), None)

    @property
    def number_axes(self) -> Iterator[Axis]:
        """All numbers that are varied."""
        for one in self.along:
            if one.numbers is not None:
                yield Axis(one.name, one.unit, "", one.numbers)

    @property
    def catalogue(self) -> Mapping[str, Entry]:
        """The facts, along what is varied and their own dimensions."""
        return self._catalogue

    @cached_property
    def _catalogue(self) -> dict[str, Entry]:
        return {
            name: replace(entry, dimensions=self.dimensions_of(entry), of="", line="")
            for name, entry in self.found.entries.items()
        }

    @property
    def labels(self) -> Mapping[str, tuple[str, ...]]:
        """Values as typed along what is varied, and members along all other dimensions."""
        beside = {one.name: one.texts for place, one in enumerate(self.along) if place != self.over}
        return {**beside, **self.found.labels}

    @property
    def titles(self) -> Mapping[str, tuple[Words, ...]]:
        """What people call the members."""
        return Titled(self.labels)

    def __getattr__(self, name: str) -> Array:
        """Give a fact of all designs, in the unit of its entry."""
        if name.startswith("_") or name not in self.found.values:
            meant = nearest(name, list(self.found.values))
            raise AttributeError(f"a sweep has no {name}" + (f"; did you mean {meant}?" if meant else ""), name=name)
        values = self.found.values[name]
        apart = values.reshape(*self.shape, *values.shape[1:])
        return apart if self.over is None else np.moveaxis(apart, self.over, -1)

    @property
    def refused(self) -> Mapping[int, Problem]:
        """What is wrong with designs that were not computed, by their places among all."""
        return {place: problem for place, problem in enumerate(self.found.refused) if problem is not None}

    @property
    def failing(self) -> Mapping[Words, list[int]]:
        """Checks that do not hold, each with the places of designs of which they do not."""
        return grouped((words, place) for place, words in enumerate(self.found.failing) if words)

    @property
    def flags(self) -> Mapping[Words, list[int]]:
        """What is to be minded of numbers, each as it is said of the first, with the places of all designs it is of."""
        said = ((words, place) for place, flags in enumerate(self.found.flags) for words in flags)
        alike = grouped((_NUMBER.sub("", str(words)), (words, place)) for words, place in said)
        return {each[0][0]: [place for _words, place in each] for each in alike.values()}

    @property
    def marks(self) -> Mapping[str, Marks]:
        """The flags of each design, a line for each, where any has one."""
        if not any(self.found.flags):
            return {}
        texts = ["\n".join(map(str, flags)) for flags in self.found.flags]
        apart = np.array(texts, dtype=object).reshape(self.shape)
        along = apart if self.over is None else np.moveaxis(apart, self.over, -1)
        return {"flags": Marks(self.dimensions_of(), along, _("What is to be minded"))}

    @property
    def case_coordinates(self) -> Iterator[Axis]:
        """Values of listed designs, in the unit that was typed, or as words."""
        for one in self.designs.varied if self.designs.is_listed else ():
            plain = np.array(one.texts, dtype=object) if one.numbers is None else one.numbers
            yield Axis(one.name, one.unit if one.numbers is not None else "", "", plain)

    @property
    def design_rows(self) -> RowHeads | None:
        """A row for each design, where none of what is varied is an axis: its values, and what is wrong with it."""
        if self.over is not None:
            return None
        n_designs = len(self.designs)
        columns: dict[str, NDArray[Any]] = {}
        if self.designs.is_listed:
            columns["case"] = np.arange(1, n_designs + 1)
            places = [np.arange(n_designs)] * len(self.designs.varied)
        else:
            places = [index for _one, index in self.designs.block(0, n_designs)]
        for one, index in zip(self.designs.varied, places, strict=True):
            head = one.name if one.numbers is None else f"{one.name} [{one.unit or '1'}]"
            columns[head] = np.array(one.texts if one.numbers is None else one.numbers, dtype=object)[index]
        if self.refused:
            said = ["" if problem is None else str(replace(problem, repair=None)) for problem in self.found.refused]
            columns["refused"] = np.array(said, dtype=object)
        return RowHeads(self.dimensions_of(), columns)

    def best(self, *, least: str = "", most: str = "") -> Machine:
        """Give the design with the least or the largest value of a fact.

        Parameters
        ----------
        least, most : str
            Name of a fact with one value for each design, or of several: of these the worst member counts.

        Returns
        -------
        Machine
            Of alike ones the first.

        Raises
        ------
        InputError
            Where there is no such fact, or no design that has it.
        """
        return self.machine.with_(self.values_at(self.place_of_best(least=least, most=most)))

    @property
    def n_stopped(self) -> int:
        """How many designs were not computed, as the sweep was stopped; these are the last."""
        last = Problem("", None, stopped())
        return sum(1 for _problem in itertools.takewhile(lambda one: one == last, reversed(self.found.refused)))

    def values_at(self, place: int) -> Mapping[str, object]:
        """Values of a design by path, by its place among all."""
        if not 0 <= place < len(self.designs):
            raise InputError([Problem("place", str(place), _("must be from 0 to {last}", last=len(self.designs) - 1))])
        return self.designs.row(place)

    def place_of_best(self, *, least: str = "", most: str = "") -> int:
        """Place among the designs of that which `best` gives."""
        if bool(least) == bool(most):
            repair = _('write like best(least="{name}")', name=next(iter(self.catalogue), ""))
            raise InputError([Problem("best", None, _("needs one fact: least or most"), repair)])
        name, option = least or most, "least" if least else "most"
        if name not in self.catalogue:
            meant = nearest(name, list(self.catalogue))
            allowed = _("must be one of: {names}", names=", ".join(self.catalogue))
            repair = _("did you mean {name}?", name=meant) if meant else None
            raise InputError([Problem(option, name, allowed, repair)])
        worst = self.worst_of(name, is_least_wanted=bool(least))
        if np.all(np.isnan(worst)):
            raise InputError([Problem(option, name, _("has no value in any of these designs"))])
        return first_largest(-worst if least else worst)

    def worst_of(self, name: str, *, is_least_wanted: bool) -> Array:
        """Of each design the member of a fact that is farthest from what is wanted, shape (design,)."""
        values = self.found.values[name].reshape(len(self.designs), -1)
        return (np.fmax if is_least_wanted else np.fmin).reduce(values, axis=1)

    def about(self) -> Iterator[tuple[str, Words]]:
        """What heads a file of it: the machine, what is varied, and what of it cannot be."""
        yield "machine", self.machine.name
        for one in self.designs.varied:
            yield "varied", _("{path}: {n} values", path=one.path, n=len(one.values))
        yield from (("minded", words) for words in self._refusals())

    def attributes(self) -> Mapping[str, object]:
        """What a dataset says of it as a whole: the machine, and what of it cannot be."""
        return {"name": str(self.subject), "minded": list(map(str, self._refusals()))}

    def before(self) -> Mapping[str, object]:
        """What a .json has before its numbers: the machine, what is varied, and what of it cannot be."""
        varied = [{"path": one.path, "values": list(one.values)} for one in self.designs.varied]
        return {"machine": self.machine.name, "varied": varied, "minded": list(map(str, self._refusals()))}

    def _refusals(self) -> Iterator[Words]:
        """How many designs cannot be, and why; how starts ended; how many do not hold a check."""
        n_designs = len(self.designs)
        for problems in grouped((problem.path, problem) for problem in self.refused.values()).values():
            first = str(replace(problems[0], repair=None))  # of a single run
            if len(problems) == 1:
                yield _("1 of {all} designs cannot be: {why}", all=n_designs, why=first)
            elif not problems[0].path:
                yield _("{n} of {all} designs: {why}", n=len(problems), all=n_designs, why=first)
            else:
                said = _("{n} of {all} designs cannot be, one of them as {why}")
                yield said.format(n=len(problems), all=n_designs, why=first)
        ended = grouped((words, place) for place, words in enumerate(self.found.ended) if words)
        for words, places in ended.items():
            yield _("{n} of {all} starts: {why}", n=len(places), all=n_designs, why=words)
        for words, places in self.failing.items():
            yield _("{n} of {all} designs do not hold a check: {which}", n=len(places), all=n_designs, which=words)
        for words, places in self.flags.items():
            counted = _("1 design") if len(places) == 1 else _("{n} designs", n=len(places))
            yield _("flags: {words} ({counted})", words=words, counted=counted)

    def in_its_units(self) -> AbstractContextManager[None]:
        """Show numbers in the units of the machine, as far as nobody chose others."""
        units: FileUnits = face("units_of")(self.machine)
        return shown_as_in(units)

    def behind(self, _name: str) -> BehindQuantity | None:
        """What leads to a fact is that which leads to it in the machine."""
        return None

    def sections(self) -> Iterator[PagePart]:
        """The facts in columns, as many as a screen has room for; and what cannot be."""
        shown = FactsAlong(self.designs, self.found, self.catalogue, self.along, self.over, self.apart)
        yield from section(_("Facts"), shown_facts(shown))
        refusals = list(self._refusals())
        more = len(refusals) - _MOST_SENTENCES
        said: list[Words] = [*refusals[:_MOST_SENTENCES], *([_("and {n} more reasons", n=more)] if more > 0 else [])]
        yield from section(_("To be minded"), said)

    def apart(self, name: str) -> list[tuple[str, Array]]:
        """Values of a fact by its members, arrays of `shape`; members that are alike in all designs stand once.

        Each with what people call it: nothing where all are alike.
        """
        entry, titles = self.found.entries[name], Titled(self.found.labels)
        named = [tuple(map(str, titles[dimension])) for dimension in entry.dimensions]
        members = [
            " ".join(words) for words in itertools.product(*(each if len(each) > 1 else ("",) for each in named))
        ]
        members = [words.strip() for words in members]
        values = self.found.values[name].reshape(-1, len(members)).T
        size = np.fmax.reduce(np.abs(values), axis=None, initial=0.0) or 1.0
        alike = places_of_equal(np.round(own / size, _FIGURES).tobytes() for own in values)
        return [
            (
                "" if len(alike) == 1 else f"{members[first]}, …" if more else members[first],
                values[first].reshape(self.shape),
            )
            for first, *more in alike.values()
        ]

    def plot(self, *quantities: str, **_members: object) -> Any:
        """Draw facts: over one number as curves, over two as maps, with the designs that cannot be hatched.

        Designs of a list are points: over the number that differs, or where several do over the first fact.

        Parameters
        ----------
        *quantities : str
            Names of facts; all unless given.

        Returns
        -------
        matplotlib.figure.Figure

        Raises
        ------
        InputError
            Where there is no such fact, or nothing that is a number is varied.
        """
        with self.in_its_units():
            return face("plot_sweep")(self, *quantities)

    def __repr__(self) -> str:
        """Say in one line what it is."""
        n_refused = len(self.refused)
        n_designs = len(self.designs)
        about = _("<Sweep of {subject}: {n} designs, {refused} not computed>")
        return str(about.format(subject=self.subject, n=n_designs, refused=n_refused))

    def __str__(self) -> str:
        """Write it as tables."""
        return self.page().lstrip("\n")
