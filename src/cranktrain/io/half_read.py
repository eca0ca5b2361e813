"""What else is wrong with a file of which some tables cannot be read: of the others, what rests on them alone."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any

from cranktrain.declared_types import bare, table_of
from cranktrain.errors import InputError, Problem
from cranktrain.layout.closing import closing_problems
from cranktrain.layout.design import Design, Table
from cranktrain.layout.shaft_problems import layout_problems
from cranktrain.machine import ARRANGING, Machine
from cranktrain.paths import quantity_path

_OF_WEIGHED = frozenset({"masses", "friction", "guide", "gravity"})
_OF_MOTION = frozenset({"speed", "speed_curve", "acceleration"})
"""Keys of a shaft by which nothing is arranged."""


class TableUnreadError(LookupError):
    """Raised by a rule that asks for a table which cannot be read: it is not judged."""


class _Read(dict[str, Any]):
    """Tables that were read; one that cannot be is no table that is not there."""

    unread: frozenset[str]

    def get(self, key: str, default: Any = None) -> Any:
        """Give a table."""
        if key in self.unread:
            raise TableUnreadError(key)
        return super().get(key, default)


class HalfDesign(Design):
    """A design of which some tables cannot be read."""

    tables: _Read

    def table(self, kind: type[Table]) -> Table | None:
        """Give the table of that class."""
        if any(_class_of(key) is kind for key in self.tables.unread):
            raise TableUnreadError(kind)
        return super().table(kind)

    def __getattribute__(self, name: str) -> Any:
        """Give a part, unless it is made of tables that cannot be read."""
        made_of = {"weighed": _OF_WEIGHED, "loads": frozenset({"load"})}.get(name)
        if made_of is not None and made_of & self.tables.unread:
            raise TableUnreadError(name)
        return super().__getattribute__(name)


def _class_of(key: str) -> object:
    """Class of a table of the machine file."""
    return table_of(bare(Machine.model_fields[key].annotation).annotation)


def problems_of_the_rest(
    data: Mapping[str, Any], found: Iterable[Problem], *, partial: bool = False
) -> tuple[Problem, ...]:
    """Find what is wrong with tables that can be read, where others cannot.

    Parameters
    ----------
    data : mapping
        The file's tables.
    found : iterable of Problem
        What is wrong with those that cannot be read.
    partial : bool
        Accept links that cannot close over the whole turn.

    Returns
    -------
    tuple of Problem
        None of a rule that asks for a table which cannot be read.
    """
    known = tuple(found)
    readable, unread = _without(data, known)
    if unread & {*ARRANGING, "crank_zero"}:
        return ()
    try:
        machine = Machine(**readable)
    except InputError as error:
        new = tuple(_new(error.problems, known))
        return (*new, *problems_of_the_rest(data, (*known, *new), partial=partial)) if new else ()
    design = machine.design
    read = _Read(design.tables)
    read.unread = unread
    half = HalfDesign(design.places, design.shafts, design.orientation, design.zero, design.weighed, design.loads, read)
    rules: list[Callable[[Design], Iterable[Problem]]] = [lambda _half: machine.arranged[1]]
    if not machine.arranged[1]:
        rules += [layout_problems, *(question.problems for question in machine.questions)]
        rules += [] if partial else [closing_problems]
    return tuple(_new((problem for rule in rules for problem in _judged(rule, half)), known))


def _without(data: Mapping[str, Any], found: Iterable[Problem]) -> tuple[dict[str, Any], frozenset[str]]:
    """Leave out tables with something wrong in them, but of a shaft what it does not stand by; give their keys, too."""
    readable, unread = dict(data), set[str]()
    for problem in found:
        first, *rest = (*map(str, quantity_path(problem.path or "?")),)
        if first == "shaft" and len(rest) == 2 and rest[1] in _OF_MOTION and isinstance(readable.get(first), Mapping):
            shaft = {key: value for key, value in readable[first][rest[0]].items() if key != rest[1]}
            readable[first] = {**readable[first], rest[0]: shaft}
        else:
            readable.pop(first, None)
            if first in Machine.model_fields:
                unread.add(first)
    return readable, frozenset(unread)


def _judged(rule: Callable[[Design], Iterable[Problem]], half: HalfDesign) -> Iterator[Problem]:
    """What a rule finds until it asks for what cannot be read."""
    try:
        yield from rule(half)
    except TableUnreadError:
        return


def _new(found: Iterable[Problem], known: tuple[Problem, ...]) -> Iterator[Problem]:
    """What is not told already, nor of a value that is left out because of what is."""
    paths = {problem.path for problem in known}
    yield from (problem for problem in found if problem.path not in paths)
