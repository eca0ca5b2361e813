"""What else is wrong with a file of which a part cannot be read: what rests on the rest alone."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from typing import Any

import numpy as np

from cranktrain.all_questions import QUESTIONS
from cranktrain.declared_types import bare, table_of
from cranktrain.errors import UNREAD, InputError, Problem, UnreadError, judged
from cranktrain.io.half_spec import HalfReader, without
from cranktrain.layout.as_in_file import as_in_file
from cranktrain.layout.closing import closing_problems
from cranktrain.layout.design import Design, Table
from cranktrain.layout.shaft_problems import layout_problems
from cranktrain.machine import Machine
from cranktrain.paths import parts_of


class HalfDesign(Design):
    """A design of which a part cannot be read: who asks for that, or for what is made of it, cannot judge."""

    def __init__(self, machine: Machine) -> None:
        fields = type(machine).model_fields
        tables = {key: table for key in fields if (table := vars(machine)[key]) is not None}
        vars(self).update(machine=machine, tables=tables)
        with suppress(UnreadError):  # of those that cannot be arranged nobody knows where they are
            places, problems = machine.arranged
            vars(self).update({} if problems else {"places": places})

    def __getattr__(self, name: str) -> Any:
        """Give a part, which is made when a rule asks for it."""
        return UNREAD if name == "places" else getattr(vars(self)["machine"], name)

    def table(self, kind: type[Table]) -> Table | None:
        """Give the table of that class."""
        if any(table is UNREAD and _class_of(key) is kind for key, table in self.tables.items()):
            raise UnreadError
        return super().table(kind)


def _class_of(key: str) -> object:
    """Class of a table of the machine file."""
    return table_of(bare(Machine.model_fields[key].annotation).annotation)


def problems_of_the_rest(
    data: Mapping[str, Any], found: Iterable[Problem], *, partial: bool = False
) -> tuple[Problem, ...]:
    """Find what else is wrong with a file.

    Parameters
    ----------
    data : mapping
        The file's tables.
    found : iterable of Problem
        What is wrong with it, as far as it could be told so far.
    partial : bool
        Accept links that cannot close over the whole turn.

    Returns
    -------
    tuple of Problem
        None that rests on what cannot be read.
    """
    known, reader = tuple(found), HalfReader()
    machine = reader.read(Machine, data)
    told = (*known, *(as_in_file(problem, data) for problem in reader.problems))
    for problem in told:
        machine = without(machine, parts_of(problem.path))
    design = HalfDesign(machine)
    asked = {key for key, table in vars(machine).items() if table is UNREAD or table}
    rules: list[Callable[[Design], Iterable[Problem]]] = [
        lambda _design: machine.arranged[1],
        layout_problems,
        *(QUESTIONS.named(name).problems for name in QUESTIONS.by(asked)),
    ]
    rules += [] if partial else [closing_problems]
    with np.errstate(all="ignore"):  # links that cannot close have no motion
        more = [problem for rule in rules for problem in judged(_of_rule(rule, design))]
    return tuple(_new((*told[len(known) :], *more), known))


def _of_rule(rule: Callable[[Design], Iterable[Problem]], design: Design) -> Iterator[Problem]:
    """Ask a rule when its answer is wanted."""
    try:
        yield from rule(design)
    except InputError as error:
        yield from error.problems


def _new(found: Iterable[Problem], known: tuple[Problem, ...]) -> Iterator[Problem]:
    """What is not told already, nor of a value that is left out because of what is."""
    paths = {problem.path for problem in known}
    yield from (problem for problem in found if problem.path not in paths)
