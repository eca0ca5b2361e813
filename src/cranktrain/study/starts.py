"""Starts of many designs of one machine: their facts beside one another, and each design's curves where asked for."""

from collections.abc import Callable, Iterator, Mapping, Sequence

from cranktrain.analysis.parts import differences
from cranktrain.columns import in_columns
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.grouping import grouped
from cranktrain.language import Words, _
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.one_line import short
from cranktrain.record import record
from cranktrain.saying.catalogue import Entry
from cranktrain.saying.run import Run
from cranktrain.saying.sections import Column, Grid, PagePart, section
from cranktrain.study.facts_of_rows import FactsOfRows, Gathered
from cranktrain.study.facts_of_starts import FACTS_SHOWN, facts_of_starts
from cranktrain.study.start import Start, start
from cranktrain.study.sweep.machines import wrong_machines
from cranktrain.transient.runs import Progress

_MOST_LINES, _MOST_SENTENCES = 24, 6
"""Of designs, and of what is to be minded, on the screen."""


@record
class Starts(Run):
    """Starts of designs of one machine.

    Every fact of `catalogue` is an attribute, an array along the designs and its own dimensions; NaN where a design
    has none. `starts[2]` is the start of one design with its curves, which are computed then.

    Attributes
    ----------
    machines : tuple of Machine
    found : FactsOfRows
    """

    machines: tuple[Machine, ...]
    found: FactsOfRows

    def __getattr__(self, name: str) -> Array:
        """Give a fact of all designs, in the unit of its entry."""
        if name.startswith("_") or name not in self.found.values:
            raise AttributeError(name)
        return self.found.values[name]

    def __getitem__(self, design: int) -> Start:
        """Give the start of one design, as `start` runs it alone."""
        return start(self.machines[design])

    def __len__(self) -> int:
        """How many designs there are."""
        return len(self.machines)

    def __iter__(self) -> Iterator[Start]:
        """Give the start of each design, computed one by one."""
        return (start(machine) for machine in self.machines)

    def __repr__(self) -> str:
        """Say in one line what it is."""
        about = _("<Starts of {n} designs of {name}, {refused} not computed>")
        return str(about.format(n=len(self), name=short(self.machines[0].name), refused=len(self.refused)))

    @property
    def subject(self) -> Words:
        """Whose they are."""
        return self.machines[0].name

    @property
    def catalogue(self) -> Mapping[str, Entry]:
        """Facts, and what is known of events, by name."""
        return self.found.entries

    @property
    def labels(self) -> Mapping[str, tuple[str, ...]]:
        """Designs by their numbers, events by their names."""
        return {"design": tuple(str(place + 1) for place in range(len(self))), **self.found.labels}

    @property
    def n_designs(self) -> int:
        """How many designs its arrays have along a leading dimension."""
        return len(self.machines)

    @property
    def reasons(self) -> tuple[Words, ...]:
        """Why the start of each design ended; empty of one that was not computed."""
        return tuple(self.found.ended)

    @property
    def refused(self) -> Mapping[int, Problem]:
        """What is wrong with designs that were not computed, by their places."""
        return {place: problem for place, problem in enumerate(self.found.refused) if problem is not None}

    def about(self) -> Iterator[tuple[str, Words]]:
        """What heads a file of it: the machine, what of the designs cannot be, and why starts ended."""
        yield "machine", self.machines[0].name
        yield from (("minded", words) for words in self._sentences())

    def attributes(self) -> Mapping[str, object]:
        """What a dataset says of it as a whole: the machine, what of the designs cannot be, why starts ended."""
        return {"name": self.machines[0].name, "minded": list(map(str, self._sentences()))}

    def sections(self) -> Iterator[PagePart]:
        """The main facts of the first designs; what cannot be, and why starts ended."""
        lines = range(min(len(self), _MOST_LINES))
        columns = [
            Column(entry.symbol, self.found.values[name][: len(lines)].tolist(), entry.shown, "amounts", name)
            for name in FACTS_SHOWN
            for entry in (self.catalogue[name],)
        ]
        heads = [str(line + 1) for line in lines]
        yield from section(_("Facts"), [Grid(columns, heads, title=_("design"), names_quantities=True)])
        said, more = list(self._sentences()), len(self) - len(lines)
        yield from section(_("To be minded"), [*said, *([_("and {n} more designs", n=more)] if more else [])])

    def _sentences(self) -> Iterator[Words]:
        """What is wrong with designs, the first of them; how many starts ended for which reason."""
        for place, problem in list(self.refused.items())[:_MOST_SENTENCES]:
            yield _("design {n}: {why}", n=place + 1, why=str(problem))
        if (more := len(self.refused) - _MOST_SENTENCES) > 0:
            yield _("and {n} more that cannot start", n=more)
        for words, places in grouped((words, place) for place, words in enumerate(self.reasons) if words).items():
            yield _("{n} of {all} starts: {why}", n=len(places), all=len(self), why=words)


def starts(
    machines: Sequence[Machine],
    placed: Sequence[Callable[[Problem], Problem]] = (),
    *,
    progress: Progress | None = None,
) -> Starts:
    """Run designs of one machine with their motors over time, as [drive.start] of each says.

    Parameters
    ----------
    machines : sequence of Machine
        With [drive]; they differ in numbers alone.
    placed : sequence of callable, optional
        Of each design: puts what is wrong with it to where that stands.
    progress : callable, optional
        Refused, as it is told of one machine alone.

    Returns
    -------
    Starts
        With the facts of each, to the last bit what `start` gives of it alone. What is wrong with a design stands at
        its place, and the others are computed.

    Raises
    ------
    InputError
        Where designs differ in more than numbers, or none of them can start.
    """
    refuse([] if progress is None else [Problem("progress", None, _("is told of one machine alone"))])
    refuse([] if machines else [Problem("machine", None, _("must be at least one design"))])
    refuse(dict.fromkeys(differences(machines)))
    columns = in_columns(machines)
    wrong = wrong_machines(machines, columns)
    fit = [place for place in range(len(machines)) if place not in wrong]
    each = [machines[place] for place in fit]
    together = Gathered(len(machines))
    if each:
        together.add_rows(facts_of_starts(each, columns=in_columns(each) if wrong else columns), fit)
    for place, problem in wrong.items():
        together.refused[place] = problem
    if placed:
        together.refused = [problem and put(problem) for put, problem in zip(placed, together.refused, strict=True)]
    if None not in together.refused:
        raise InputError(dict.fromkeys(problem for problem in together.refused if problem is not None))
    return Starts(tuple(machines), together.found())
