"""The result: every quantity by name, its facts, checks, what is missing, and sentences that answer."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, TypeAlias, TypeVar

import numpy as np

from cranktrain.analysis.answer import answer_groups, answer_kinds
from cranktrain.analysis.dimensions import Titled
from cranktrain.analysis.outcomes import Outcomes
from cranktrain.analysis.stages import Missing, every_stage
from cranktrain.analysis.unused import Unused, sentences, unused
from cranktrain.brief import brief
from cranktrain.faces import face
from cranktrain.language import Listed, Message, Words, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.quantities import shown, shown_as_in
from cranktrain.record import record
from cranktrain.saying.catalogue import Entry, entries, values
from cranktrain.saying.checks import Check, Checked, Flagged
from cranktrain.saying.rows import AnswerLine
from cranktrain.saying.run import Axis, BehindQuantity, Run
from cranktrain.saying.wording import in_print

if TYPE_CHECKING:
    from cranktrain.saying.sections import PagePart

Outcome = TypeVar("Outcome")

# fmt: off
Sheet: TypeAlias = Literal[
    "machine", "forces", "crankshaft", "crankpins", "wear", "rod_load", "shaft_torque", "loads", "drive", "pumping",
    "torsion",
]
# fmt: on
"""Sheets of paper by their names."""

_MILLION = 1e6
"""From here on six figures would take a power of ten."""


class Fact(NamedTuple):
    """A quantity that stands for the whole cycle: its catalogue entry, and its array in the entry's unit."""

    entry: Entry
    value: Array

    def __repr__(self) -> str:
        """Show name, symbol and unit, and one value, or how many there are."""
        value = brief(self.value)
        if np.ndim(self.value) == 0:
            value = f"{self.value:.6g}" if abs(self.value) < _MILLION else f"{self.value:.0f}"
        return f"<{self.entry.name} {self.entry.symbol} = {value} {self.entry.unit}>"


@record
class Result(Run):
    """What a machine does, as far as its file says.

    Every quantity of `catalogue` is an attribute: a read-only array in the unit of its entry, the same numbers as in a
    file or dataset, with the entry's dimensions (and `design` before them where several machines were run). What a
    stage gave as a whole is had by its type, `result[FlywheelSize]`.

    Attributes
    ----------
    machines : tuple of Machine
    has_designs : bool
        Whether arrays have the leading dimension `design`.
    grid : CrankAngle
    computed : Outcomes
        What each stage gives, found when it is first asked for.
    missing : tuple of Missing
    lacking : mapping of str to tuple of Words
        Names of results that cannot be had of this file, and what is missing for them.
    asked : tuple of str, or None
        The quantities that were asked for, which the dataset has; None for all.
    """

    machines: tuple[Machine, ...]
    has_designs: bool
    grid: CrankAngle
    computed: Outcomes
    missing: tuple[Missing, ...]
    lacking: Mapping[str, tuple[Words, ...]]
    asked: tuple[str, ...] | None = None

    @cached_property
    def unused(self) -> tuple[Unused, ...]:
        """Tables that the file has and no result could rest on, with what is missing for them."""
        return unused(self.machines[0], self.lacking)

    @property
    def outcomes(self) -> tuple[Any, ...]:
        """What the stages give, in SI and radians, always with the design axis; before them a speed that varies."""
        return self._outcomes_of(object)

    def _outcomes_of(self, *kinds: type) -> tuple[Any, ...]:
        """What those stages give whose results are of some kinds."""
        wanted = [kind for kind in self.computed.kinds if issubclass(kind, kinds)]
        self.computed.find(wanted)
        return tuple(self.computed[kind] for kind in wanted)

    def find_all(self) -> None:
        """Find now what would be found when it is first asked for: everything."""
        self.computed.find(self.computed.kinds)

    def find_answer(self) -> None:
        """Find now what the answer rests on: its rows, and whatever may check or warn."""
        asked, there = answer_kinds(self), self.computed.kinds
        self.computed.find(kind for kind in there if kind in asked or issubclass(kind, Checked | Flagged))

    @property
    def labels(self) -> Mapping[str, tuple[str, ...]]:
        """Names along the dimensions of its quantities."""
        return self.computed.labels

    @property
    def titles(self) -> Mapping[str, tuple[Words, ...]]:
        """What people call the members along the dimensions: their labels, or in words what these are keys of."""
        return Titled(self.labels)

    @cached_property
    def _homes(self) -> dict[str, tuple[Entry, type]]:
        """Entry of every quantity, and the stage's result that holds it."""
        return {entry.name: (entry, kind) for kind in self.computed.kinds for entry in entries(kind)}

    @property
    def catalogue(self) -> Mapping[str, Entry]:
        """What there is, by name."""
        return self._catalogue

    @cached_property
    def _catalogue(self) -> dict[str, Entry]:
        return {name: entry for name, (entry, _home) in self._homes.items()}

    @cached_property
    def crank_angle(self) -> Array:
        """Crank angles of the grid, shape (crank_angle,). [deg]"""
        n_angles = self.grid.shown.size
        # Degrees are counted, as their steps are rounder than those of radians.
        return _read_only(np.arange(n_angles) * self.cycle / n_angles)

    def __getattr__(self, name: str) -> Array:
        """Give a quantity by name, in the unit of its entry."""
        if name.startswith("_"):
            raise AttributeError(name)
        if name not in self._homes:
            raise AttributeError(str(self._unknown(name)))
        entry, home = self._homes[name]
        inside: Array = values(self.computed[home], entry)
        given = _read_only(shown(inside, "deg")) if entry.unit == "deg" else inside
        return given if self.has_designs else given[0]

    def get(self, kind: type[Outcome]) -> Outcome | None:
        """Give what a stage gave by its type, in SI and radians, with the design axis; None where there is none."""
        own = next((one for one in self.computed.kinds if issubclass(one, kind)), None)
        return None if own is None else self.computed[own]

    def __getitem__(self, kind: type[Outcome]) -> Outcome:
        """Give what a stage gave, as `get` does; a `KeyError` says why there is none."""
        found = self.get(kind)
        if found is None:
            needs = self.needs_of(*(entry.name for entry in entries(kind)))
            raise KeyError(str(self._absence(kind.__name__, needs, (one.__name__ for one in self.computed.kinds))))
        return found

    @property
    def worth_asking(self) -> tuple[Missing, ...]:
        """Of what is missing, that which makes sense for this machine: a press is not asked when it fires."""
        design, questions = self.machines[0].design, self.machines[0].questions
        return tuple(
            one
            for one in self.missing
            if all(question.is_for([need.text for need in one.needs], design) for question in questions)
        )

    def needs_of(self, *quantities: str) -> tuple[Message, ...]:
        """What the machine file would have to say for quantities that are missing; nothing of others."""
        return next((one.needs for one in self.missing if not set(quantities).isdisjoint(one.results)), ())

    def _absence(self, wanted: str, needs: Sequence[Words], there: Iterable[str]) -> Words:
        """Say why there is no such quantity, or stage's result."""
        if needs:
            return _("this result has no {wanted}, which needs {needs}", wanted=wanted, needs=Listed(needs))
        return _("this result has no {wanted}; it has {there}", wanted=wanted, there=", ".join(there))

    def _unknown(self, wanted: str) -> Words:
        """Say why there is no such attribute, and which was probably meant."""
        from cranktrain.quantities import nearest  # only after a mistake

        if needs := self.needs_of(wanted):
            return self._absence(wanted, needs, ())
        if any(wanted in stage.results for stage in every_stage()):
            return _(
                "this result has no {wanted}, which other machines have, or other `quantities` would give",
                wanted=wanted,
            )
        others = (name for name in object.__dir__(self) if not name.startswith("_"))
        if meant := nearest(wanted, (*self._homes, *others)):
            return _("this result has no {wanted}; did you mean {meant}?", wanted=wanted, meant=meant)
        return _("this result has no {wanted}; its `catalogue` names all", wanted=wanted)

    def __dir__(self) -> list[str]:
        """List the quantities too, for completion in a notebook."""
        return [*super().__dir__(), *self._homes]

    @property
    def facts(self) -> dict[str, Fact]:
        """Quantities that stand for the whole cycle."""
        return {name: Fact(entry, getattr(self, name)) for name, entry in self.catalogue.items() if entry.is_fact}

    @property
    def headline(self) -> dict[str, Fact]:
        """Those facts that say most, question by question."""
        facts = self.facts
        return {name: facts[name] for one in self.machines[0].questions for name in one.headline if name in facts}

    @property
    def checks(self) -> tuple[Check, ...]:
        """Identities that can fail, with their residuals."""
        return tuple(check for outcome in self._outcomes_of(Checked) for check in outcome.checks)

    @property
    def flags(self) -> tuple[str, ...]:
        """Warnings: a textbook form outside its source's range, and the like; as they are said here and now."""
        with self.in_its_units():
            return tuple(in_print(str(flag)) for flag in self.flag_words)

    @property
    def unlikely(self) -> tuple[str, ...]:
        """Those of the flags that ask whether a number of the file is right."""
        with self.in_its_units():
            return tuple(in_print(str(flag)) for outcome in self._outcomes_of(Flagged) for flag in outcome.unlikely)

    @property
    def flag_words(self) -> tuple[Words, ...]:
        """The flags as data, for whoever says them later, or to others."""
        found = ((*outcome.flags, *outcome.unlikely) for outcome in self._outcomes_of(Flagged))
        return (*self.computed.coarse, *(flag for flags in found for flag in flags))

    def rows(self, design: int = 0) -> Iterator[tuple[Words, list[AnswerLine]]]:
        """Give the lines of the answer for one design, question by question: titles and rows, if there are any.

        Questions with one title stand together; what kinds of mechanisms have of their own, with the first question.
        """
        for title, rows in answer_groups(self, design):
            yield _(title), rows

    def answer_rows(self) -> Iterator[tuple[Words, list[AnswerLine]]]:
        """Lines of the answer, of several designs those of the first."""
        return self.rows()

    def sections(self) -> Iterator["PagePart"]:
        """All that there is of one machine, as `--full` shows it: answer, numbers, checks, flags, what is missing."""
        sections: Iterator[PagePart] = face("result_sections")(self)
        return sections

    def summary(self, design: int | None = None) -> str:
        """Say what is not used of the file, and what was found, in a line each.

        Parameters
        ----------
        design : int, optional
            Which of several, from 0; between which values they all are unless given.

        Returns
        -------
        str
        """
        is_of_all = self.has_designs and design is None
        with self.in_its_units():
            found = face("summary_of_designs")(self) if is_of_all else face("result_lines")(self, design or 0)
            return "\n".join([*map(str, sentences(self.unused)), *found])

    @property
    def subject(self) -> Words:
        """Whose result it is."""
        return self.machines[0].name

    @property
    def axis(self) -> Axis:
        """Crank angles, which its curves are over."""
        return Axis("crank_angle", "deg", "φ", self.crank_angle)

    @property
    def cycle(self) -> float:
        """At which crank angle all begins again. [deg]"""
        return float(round(shown(self.grid.cycle, "deg")))

    @property
    def n_designs(self) -> int | None:
        """How many designs its arrays have along a leading dimension; None of one machine alone."""
        return len(self.machines) if self.has_designs else None

    @property
    def wanted(self) -> Iterable[str]:
        """Names of what was asked for, or of all."""
        return self.catalogue if self.asked is None else self.asked

    def about(self) -> Iterable[tuple[str, Words]]:
        """What heads a file of it: the machine, and what its numbers count from."""
        return (("machine", self.machines[0].name), *face("conventions")(self).items())

    def attributes(self) -> Mapping[str, object]:
        """What a dataset says of it as a whole: the machine, and what of its file is not used."""
        return {"name": self.machines[0].name, "unused": [*map(str, sentences(self.unused))]}

    def before(self) -> Mapping[str, object]:
        """What a .json has before its numbers: what they count from."""
        return {"conventions": face("conventions")(self)}

    def after(self) -> Mapping[str, object]:
        """What a .json has behind its numbers: checks, what is not used, flags, what is missing."""
        checks: Mapping[str, object] = face("checks_record")(self)
        return checks

    def behind(self, name: str) -> BehindQuantity:
        """What leads to a quantity in the machine, of several in the first."""
        from cranktrain.analysis.behind import behind  # only where somebody asks why

        more = _("More: cranktrain list results --behind {name}", name=name)
        return behind(name, self.machines[0]).in_short._replace(more=more)

    def in_its_units(self) -> AbstractContextManager[None]:
        """Show numbers in the units of the first machine, as far as nobody chose others."""
        return shown_as_in(face("units_of")(self.machines[0]))

    def sheet(self, name: Sheet = "machine", *, size: Literal["A4", "A3"] = "A4", design: int = 0) -> Any:
        """Draw a sheet of paper.

        Parameters
        ----------
        name : Sheet
            `machine` (motion and what the machine does, on one page), `forces`, `crankshaft`, `crankpins`, `wear`,
            `rod_load`, `shaft_torque`, `loads`, `drive`, `pumping` or `torsion`.
        size : "A4" or "A3"
        design : int
            Which of the result's machines.

        Returns
        -------
        matplotlib.figure.Figure

        Raises
        ------
        InputError
            Where there is no such sheet, or the result lacks what it needs.
        """
        return face("sheet_called")(self, name, size=size, design=design)

    def view(self) -> Any:
        """Give a page in which the machine moves beside its curves: a notebook shows it, `.save("page.html")` keeps it.

        Raises
        ------
        InputError
            Of several designs, or of a result that was asked for some quantities alone.
        """
        return face("view_of")(self)

    def __repr__(self) -> str:
        """Say in one line whose result it is."""
        line: str = face("result_line")(self)
        return line

    def _repr_html_(self) -> str:
        """Give the answer for a notebook."""
        with self.in_its_units():
            words: str = face("result_html")(self)
            return words


def _read_only(values: Array) -> Array:
    """Make an array read-only."""
    values.flags.writeable = False
    return values
