"""What stands behind a quantity: what the machine file declares, and the stages that lead from there to it."""

import inspect
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import lru_cache
from pathlib import Path
from typing import Any, NamedTuple

from cranktrain.analysis.grids import FACTS_STEP
from cranktrain.analysis.parts import parts_of
from cranktrain.analysis.pipeline import PartBehind, Pipeline, Place, StageBehind
from cranktrain.analysis.stages import KEPT, every_stage, lacking, leading_to, ordered, stages_for, stages_giving
from cranktrain.errors import InputError, Problem
from cranktrain.grouping import grouped
from cranktrain.language import Listed, Words, _
from cranktrain.layout.question import Parts, Stage, tables_of
from cranktrain.machine import Machine
from cranktrain.paths import is_table, path_text
from cranktrain.saying.catalogue import cited, entries

_CITED = re.compile(r"(docs/theory/[\w-]+)(?:, eqs?\. (\([\d.]+\)(?:(?:,| to| and|, and) \([\d.]+\))*))?")
_MOST_TABLES = 4096
"""Of parts of machines whose files have the same tables, of which it is kept what these are."""
_ANY = "NAME"
"""In the name of a table, for those of all names."""


def behind(quantity: str, machine: Machine | None = None) -> Pipeline:
    """Find what leads to a quantity.

    Parameters
    ----------
    quantity : str
        Its name in the catalogue.
    machine : Machine, optional
        What leads to it in this machine; what may do so in any unless given.

    Returns
    -------
    Pipeline

    Raises
    ------
    InputError
        Where there is no such quantity, or the machine's file does not allow it.

    Examples
    --------
    >>> found = behind("stroke")
    >>> [(stage.name, stage.word) for stage in found.stages]
    [('piston_turn', 'hand-over'), ('dead_centres', 'result')]
    >>> found.stages[-1].place.file
    'questions/motion/dead_centres.py'
    """
    if machine is None:
        return pipeline(quantity, every_stage())
    return pipeline(quantity, every_stage(), parts_of((machine,), step=FACTS_STEP), machine.declared)


def pipeline(
    quantity: str, stages: Sequence[Stage], parts: Parts | None = None, declared_tables: Mapping[str, Any] | None = None
) -> Pipeline:
    """Find what leads to a quantity among some stages: in any machine, or in that of some parts and tables."""
    (giving,) = stages_giving(stages, [quantity], "behind")
    entry = next(entry for entry in entries(giving.gives) if entry.name == quantity)
    absent = {} if parts is None else lacking(stages, parts)
    if giving.outcome in absent:
        raise InputError([Problem("behind", quantity, _lacks(absent[giving.outcome]))])
    way = ordered(leading_to([one for one in stages if one.outcome not in absent], [giving.gives]))
    given, by_any = {one.gives for one in way}, {one.gives for one in stages}
    is_known = {one: one in given or (one not in by_any and (parts is None or one in parts)) for one in _needs(way)}
    there = None if declared_tables is None else _there(declared_tables)
    declared = {
        part: _tables(tables_of(part), there) for part, known in is_known.items() if known and part not in given
    }
    return Pipeline(
        entry,
        tuple(
            PartBehind(part.__name__, _(first_sentence(part)), _place(part), names) for part, names in declared.items()
        ),
        tuple(_behind(one, [need for need in one.needs.values() if is_known[need]], declared) for one in way),
    )


def tables_behind(machine: Machine, there: Iterable[type], quantities: Iterable[str]) -> frozenset[str]:
    """Name the tables of a machine's file that are read on the way to quantities, as `behind` does, and nothing else.

    Parameters
    ----------
    machine : Machine
    there : iterable of type
        All outcomes that there are of it.
    quantities : iterable of str
        Names in the catalogue.
    """
    parts = _parts_behind(stages_for(machine), frozenset(there), tuple(quantities))
    declared = _there(machine.declared)
    found = (_tables(tables_of(part), declared) for part in parts)
    return frozenset(table.strip("[]") for tables in found for table in tables)


@lru_cache(maxsize=KEPT)
def _parts_behind(stages: tuple[Stage, ...], there: frozenset[type], quantities: tuple[str, ...]) -> tuple[type, ...]:
    """Find the parts that stand on the way to quantities, where there are some outcomes."""
    own = [one for one in stages if one.gives in there]
    way = leading_to(own, [one.gives for one in stages_giving(own, quantities, "behind")])
    return tuple(dict.fromkeys(need for need in _needs(way) if need not in there))


def _needs(way: Sequence[Stage]) -> Iterator[type]:
    """All that stages need, as they come to it."""
    for one in way:
        yield from one.needs.values()


def _lacks(needs: Sequence[Words]) -> Words:
    """Say why a machine has no such quantity."""
    if needs:
        return _("is no result of this machine; it needs {needs}", needs=Listed(needs))
    return _("is a result of other machines")


def _behind(stage: Stage, takes: Sequence[type], declared: Mapping[type, Sequence[str]]) -> StageBehind:
    """Describe a stage that goes on from some parts and outcomes."""
    function = stage.function
    found: list[tuple[str, str]] = _CITED.findall(" ".join((inspect.getdoc(function) or "").split()))
    found = found or [(entry.source, entry.numbers) for entry in entries(stage.gives)]
    return StageBehind(
        function.__name__,
        _(first_sentence(function)),
        _place(function),
        stage.gives.__name__,
        stage.word,
        tuple(one.__name__ for one in takes),
        tuple(dict.fromkeys(table for one in takes for table in declared.get(one, ()))),
        tuple(cited(page, ", ".join(dict.fromkeys(filter(None, each)))) for page, each in grouped(found).items()),
    )


def first_sentence(thing: Callable[..., Any]) -> str:
    """Give the first sentence of a docstring, which stands in its first line, without what it cites at its end."""
    said, cites, _cited = (inspect.getdoc(thing) or "").partition("\n")[0].partition("; docs/theory/")
    return f"{said}." if cites else said


def _place(thing: Callable[..., Any]) -> Place:
    """Find where a function or class of this package stands."""
    file = Path(inspect.getfile(thing)).relative_to(Path(__file__).parents[1])
    lines, first = inspect.getsourcelines(thing)
    above = next(number for number, line in enumerate(lines) if line.startswith(("def ", "class ")))
    return Place(file.as_posix(), first + above)


class _There(NamedTuple):
    """What a machine's file has: its keys, and the paths of all tables."""

    keys: tuple[str, ...]
    tables: tuple[tuple[str, ...], ...]


def _there(declared: Mapping[str, Any]) -> _There:
    """Look what a machine's file has."""
    return _There(tuple(declared), tuple(_paths(declared)))


@lru_cache(maxsize=_MOST_TABLES)
def _tables(patterns: tuple[str, ...], there: _There | None) -> tuple[str, ...]:
    """Name tables as they are in general, or those that a file has: `[bank.L.mechanism]` for `[mechanism]`."""
    if there is None:
        return patterns
    found = [f"[{path_text(path)}]" for pattern in patterns for path in there.tables if _is_of(pattern, path)]
    return tuple(dict.fromkeys((*(name for name in patterns if name in there.keys), *found)))


def _paths(declared: Mapping[str, Any], above: tuple[str, ...] = ()) -> Iterator[tuple[str, ...]]:
    """Paths of all tables in a file's tables."""
    for key, value in declared.items():
        if is_table(value):
            yield (*above, key)
            yield from _paths(value, (*above, key))


def _is_of(pattern: str, path: Sequence[str]) -> bool:
    """Whether a table is one of those that a pattern stands for, at any place: `[masses]` of a bank, too."""
    keys = pattern.strip("[]").split(".")
    last = path[-len(keys) :]
    return len(last) == len(keys) and all(key in (_ANY, own) for key, own in zip(keys, last, strict=True))
