"""Facts of a group of designs by the compiled cycle, where there are enough of them; with `run` as its judge."""

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from cranktrain.analysis import run
from cranktrain.columns import some_rows
from cranktrain.errors import InputError
from cranktrain.language import Words, _
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.study.cycle.road import CompiledWay, FactsOfCycles, facts_of_cycles, way_to
from cranktrain.study.sweep.designs import DesignsInColumns

_ENOUGH, _ENOUGH_OF_BEARINGS = 1000, 200
"""Designs of a sweep from when on compiling is worth it: a run of one takes some 5 ms, with main bearings some 20."""
_AT_ONCE, _BEARINGS_AT_ONCE = 16_384, 64
"""Designs of which curves or facts are held in memory together."""
_ALIKE = 1e-6
"""By which part of the largest a fact may differ from that of `run`; most differ by less than 1e-9."""


def way_compiled(machine: Machine, wanted: Sequence[str], n_all: int) -> CompiledWay | Words:
    """How the compiled cycle of a machine gives facts of so many designs; or why `run` gives them."""
    way = _("they are few") if n_all < min(_ENOUGH, _ENOUGH_OF_BEARINGS) else way_to(machine, wanted)
    if not isinstance(way, CompiledWay):
        return way
    return way if n_all >= (_ENOUGH_OF_BEARINGS if way.keeps_points else _ENOUGH) else _("they are few")


def designs_at_once(way: CompiledWay) -> int:
    """How many designs are held in memory together."""
    return _BEARINGS_AT_ONCE if way.keeps_points else _AT_ONCE


def facts_compiled(group: DesignsInColumns, way: CompiledWay) -> FactsOfCycles | None:
    """Find facts of designs that differ in numbers alone.

    Returns
    -------
    FactsOfCycles or None
        None where those of the first design are not what `run` says of it.
    """
    n_designs = len(group.places)
    at_once = designs_at_once(way)
    parts = [
        part
        for first in range(0, n_designs, at_once)
        for part in _facts(group.machine, first, min(first + at_once, n_designs), way)
    ]
    known = [part for part in parts if part.values]
    if not known or not _is_judged_right(group, known[0], parts[0] is known[0]):
        return None
    values = {name: np.concatenate([_of_part(part, known[0], name) for part in parts]) for name in known[0].values}
    return known[0]._replace(is_known=np.concatenate([part.is_known for part in parts]), values=values)


def _facts(together: Machine, first: int, last: int, way: CompiledWay) -> Iterator[FactsOfCycles]:
    """Facts of some of the designs; of one that is refused on the way there are none."""
    try:
        yield facts_of_cycles(some_rows(together, slice(first, last)), last - first, way)
    except InputError:
        if last - first == 1:
            yield FactsOfCycles(np.zeros(1, dtype=np.bool_), {}, {}, {})
            return
        middle = (first + last) // 2
        yield from _facts(together, first, middle, way)
        yield from _facts(together, middle, last, way)


def _of_part(part: FactsOfCycles, like: FactsOfCycles, name: str) -> Array:
    """A fact of some designs, NaN of those that were refused."""
    return part.values[name] if part.values else np.full((len(part.is_known), *like.values[name].shape[1:]), np.nan)


def _is_judged_right(group: DesignsInColumns, found: FactsOfCycles, is_first: bool) -> bool:
    """Whether the facts of the first design are those of `run`; one that is not known is no witness."""
    if not is_first or not found.is_known[0]:
        return True
    judge: Any = run(group.each[0], quantities=tuple(found.values))
    for name, values in found.values.items():
        if found.entries[name].unit == "deg":  # of alike tops either may be told
            continue
        exact = np.asarray(getattr(judge, name))
        largest = np.max(np.abs(np.nan_to_num(exact)), initial=0.0)
        if exact.shape != values[0].shape or not np.array_equal(np.isnan(exact), np.isnan(values[0])):
            return False
        if np.any(np.abs(np.nan_to_num(values[0] - exact)) > _ALIKE * largest):
            return False
    return True
