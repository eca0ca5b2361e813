"""Random designs of the examples that the compiled cycle knows, and how near to `run` their facts have to be."""

import random
from collections.abc import Iterator, Mapping

import numpy as np

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.machine import machine_problems
from cranktrain.quantities.number import rounded
from cranktrain.study.cycle.road import CompiledWay, way_to
from cranktrain.study.sweep.typed import quantity_typed

EXAMPLES = (
    *("vaz_21213", "3d12", "kamaz_740", "ls3", "r_1340", "deltic", "10d100"),
    *("gas_compressor", "two_throw_compressor", "compressor_start", "inline_six"),
)
_EVEN = ("excess", "flywheel", "fluctuation", "crank_speed", "mean_speed_over_angle", "mean_speed_of_extremes")
"""Of what is made of integrals of the torque."""
_EXTREMES = ("largest_torque", "smallest_torque")
"""Of one curve, in parts of whose largest size both are exact: one of them may be next to nothing."""


def most_apart(fact: str) -> float:
    """By how much a fact may differ from that of `run`, in parts of the largest of its design."""
    return 1e-6 if any(word in fact for word in _EVEN) else 1e-9


def numbers_of(data, above=()) -> Iterator[tuple[tuple, object]]:
    """Paths of all numbers of some tables, with what is typed."""
    if isinstance(data, Mapping) and "value" not in data:
        for key, inner in data.items():
            yield from numbers_of(inner, (*above, key))
    else:
        typed = data["value"] if isinstance(data, Mapping) else data
        if isinstance(typed, float) or (isinstance(typed, str) and quantity_typed(typed) is not None):
            yield above, typed


def changed(typed, factor):
    """A number as typed, times a factor."""
    if isinstance(typed, float):
        return typed * factor
    found = quantity_typed(typed)
    return f"{rounded(found.number) * factor!r} {found.unit}"


def designs(name: str, n_designs: int, spread: float = 0.04) -> list[ct.Machine]:
    """The example, and variants of it in up to six numbers by up to 4 %."""
    machine, chance = ct.load(name), random.Random(name)
    numbers = [one for one in numbers_of(machine.declared) if one[0][-1] not in ("start_pressure", "direction")]
    found = [machine]
    while len(found) < n_designs:
        some = chance.sample(numbers, min(6, len(numbers)))
        row = {".".join(map(str, path)): changed(typed, chance.uniform(1 - spread, 1 + spread)) for path, typed in some}
        try:
            design = machine.with_(row)
            ct.run(design)
        except InputError:
            continue
        if not machine_problems(design):
            found.append(design)
    return found


def facts_of_both(machine: ct.Machine) -> list[str]:
    """Facts of a machine that `run` and the compiled cycle give."""
    alone = ct.run(machine)
    return [
        fact
        for fact, entry in alone.catalogue.items()
        if not alone.is_curve(entry) and isinstance(way_to(machine, [fact]), CompiledWay)
    ]


def facts_by_run(machines: list[ct.Machine], facts: list[str]) -> dict[str, np.ndarray]:
    """Facts of several designs by `run`, and none of the curves."""
    result = ct.run(machines, quantities=facts)
    return {fact: np.array(getattr(result, fact)) for fact in facts}


def parts_apart(fact: str, values: np.ndarray, by_run: Mapping[str, np.ndarray]) -> np.ndarray:
    """By how much a fact of designs is apart, in parts of each design's largest; NaN where only one is a number."""
    exact = by_run[fact]
    of_members = tuple(range(1, exact.ndim))
    like_it = [by_run[one] for one in _EXTREMES if one in by_run] if fact in _EXTREMES else [exact]
    scale = np.max([np.nanmax(np.abs(one), axis=of_members, initial=0.0) for one in like_it], axis=0)
    off = np.nanmax(
        np.where(np.isnan(values) & np.isnan(exact), 0.0, np.abs(values - exact)), axis=of_members, initial=0.0
    )
    return np.where(off == 0.0, 0.0, off / np.where(scale == 0.0, 1.0, scale))
