"""Stages in the order in which they can run: all that a machine allows, and in words what it lacks for the others."""

import re
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, is_dataclass
from functools import cache, partial
from graphlib import TopologicalSorter
from typing import TypeAlias, cast

import numpy as np

from cranktrain import texts
from cranktrain.all_questions import QUESTIONS
from cranktrain.analysis.unasked import UnaskedStage, unasked
from cranktrain.brief import brief_fields
from cranktrain.errors import Problem, refuse
from cranktrain.grouping import grouped
from cranktrain.how_far import say_how_far
from cranktrain.language import _
from cranktrain.layout.question import NOT_FOR_IT, Stage
from cranktrain.machine import Machine
from cranktrain.mechanisms import KINDS
from cranktrain.motion import Array


@dataclass(frozen=True)
class Missing:
    """Results that a machine file does not allow yet: their names, and what the file would have to say."""

    results: tuple[str, ...]
    needs: tuple[str, ...]

    def __repr__(self) -> str:
        """Show both in a line."""
        return brief_fields("Missing", vars(self).items())


@cache
def ordered(stages: tuple[Stage, ...]) -> tuple[Stage, ...]:
    """Put stages in an order in which every need comes before its use: once, however often they run."""
    by_outcome = {one.gives: one for one in stages}
    graph = {one.gives: [need for need in one.needs.values() if need in by_outcome] for one in by_outcome.values()}
    return tuple(by_outcome[outcome] for outcome in TopologicalSorter(graph).static_order())


def leading_to(stages: Sequence[Stage], outcomes: Iterable[type]) -> tuple[Stage, ...]:
    """Those stages that outcomes need, and their own, in the order of `stages`."""
    by_outcome = {one.gives: one for one in stages}
    wanted: set[type] = set()
    open_ends = list(outcomes)
    while open_ends:
        outcome = open_ends.pop()
        if outcome in by_outcome and outcome not in wanted:
            wanted.add(outcome)
            open_ends += by_outcome[outcome].wanted
    return tuple(one for one in stages if one.gives in wanted)


@cache
def homes(stages: tuple[Stage, ...]) -> dict[str, Stage]:
    """Which stage gives each quantity."""
    return {name: stage for stage in stages for name in stage.results}


def stages_giving(stages: Sequence[Stage], names: Iterable[str], path: str) -> list[Stage]:
    """Find the stage that gives each quantity; refuse names of none, as what is wrong at a path."""
    home, asked = homes(tuple(stages)), list(names)
    refuse(_unknown(name, home, path) for name in asked if name not in home)
    return [home[name] for name in asked]


def _unknown(name: str, known: Iterable[str], path: str) -> Problem:
    """Refuse what is no quantity."""
    from cranktrain.quantities import nearest  # only after a mistake

    allowed = _("is not a quantity of the catalogue; `cranktrain list results` names them")
    close = nearest(name, known)
    return Problem(path, name, allowed, _("did you mean {name}?").format(name=close) if close else None)


@cache
def stages_of(questions: tuple[str, ...], kinds: tuple[str, ...]) -> tuple[Stage, ...]:
    """Give the stages of questions and kinds of mechanisms by their names, in the order of their results for people."""
    return (
        *(stage for name in questions for stage in QUESTIONS.named(name).stages),
        *(Stage(function) for name in kinds for function in KINDS.named(name).stages),
        *texts.STAGES,
    )


def stages_for(machine: Machine) -> tuple[Stage, ...]:
    """Give the stages of what a machine's file asks."""
    return stages_of(machine.asks, machine.kinds)


def every_stage() -> tuple[Stage, ...]:
    """Give all stages that there are."""
    return stages_of(QUESTIONS.names, KINDS.names)


Step: TypeAlias = Stage | UnaskedStage
"""A stage, or what is known of one that nobody asks."""


@cache
def steps_of(questions: tuple[str, ...], kinds: tuple[str, ...]) -> tuple[Step, ...]:
    """Give the stages of questions and kinds, and in their place what is known of those of all other questions."""
    each = ((QUESTIONS.named(name) if name in questions else unasked(name)).stages for name in QUESTIONS.names)
    return (*(step for steps in each for step in steps), *stages_of((), kinds))


def lacking(steps: Sequence[Step], parts: Mapping[type, object]) -> dict[str, tuple[str, ...]]:
    """Which outcomes cannot be made of some parts, and what is missing for them.

    Parameters
    ----------
    steps : sequence of Stage or UnaskedStage
        In any order.
    parts : mapping of type to object
        What the machine declares.

    Returns
    -------
    dict of str to tuple of str
        By the names of outcomes, in words for what a machine file could say; none of an outcome that is not for this
        machine.
    """
    known = {part.__name__ for part in parts}
    roots: dict[str, frozenset[str]] = {}
    for one in _by_needs(tuple(steps)):
        needed, applies = one.lacks.keys() - known, one.applies_to(parts)
        if needed or applies is not True:
            asked = applies if isinstance(applies, tuple) else (applies or NOT_FOR_IT,)
            said = frozenset[str]() if applies is True else frozenset(cast(tuple[str, ...], asked))
            roots[one.outcome] = said.union(*(roots.get(need, frozenset([one.lacks[need]])) for need in needed))
        else:
            known.add(one.outcome)
    told = {
        words: () if NOT_FOR_IT in words else tuple(sorted(_(word) for word in words)) for words in set(roots.values())
    }
    return {outcome: told[words] for outcome, words in roots.items()}


@cache
def _by_needs(steps: tuple[Step, ...]) -> tuple[Step, ...]:
    """Put steps in an order in which what each cannot do without comes before it."""
    by_outcome = {one.outcome: one for one in steps}
    graph = {one.outcome: [need for need in one.lacks if need in by_outcome] for one in steps}
    return tuple(by_outcome[outcome] for outcome in TopologicalSorter(graph).static_order())


def run_stages(stages: Sequence[Stage], parts: Mapping[type, object], absent: Collection[str]) -> dict[type, object]:
    """Run every stage whose needs are met.

    Parameters
    ----------
    stages : sequence of Stage
        In any order; results come in this one.
    parts : mapping of type to object
        What the machine declares.
    absent : collection of str
        Names of outcomes that cannot be had of these, as `lacking` finds it.

    Returns
    -------
    mapping of type to object
    """
    known = dict(parts)
    seen: set[int] = set()
    for part in parts.values():
        _freeze(part, seen)
    in_order = [one for one in ordered(tuple(stages)) if one.outcome not in absent]
    for place, one in enumerate(in_order, start=1):
        say_how_far(partial(_how_far, place, len(in_order), one.gives))
        # NaN stands for links that cannot close, and is no news.
        with np.errstate(all="ignore"):
            outcome = one.function(**{name: known.get(need) for name, need in one.needs.items()})
        _freeze(outcome, seen)
        known[one.gives] = outcome
    return {one.gives: known[one.gives] for one in stages if one.gives in known}


def spoken(outcome: type) -> str:
    """Name of a result in words: `DeadCentres` are dead centres."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", outcome.__name__).lower()


def _how_far(place: int, n_stages: int, outcome: type) -> str:
    """Which result is worked on."""
    return _("{place} of {n}, {name}").format(place=place, n=n_stages, name=spoken(outcome))


def missing_results(steps: Sequence[Step], absent: Mapping[str, tuple[str, ...]]) -> tuple[Missing, ...]:
    """Results that stages do not give, in their order, those that lack the same together.

    Parameters
    ----------
    steps : sequence of Stage or UnaskedStage
    absent : mapping of str to tuple of str
        As `lacking` gives it; a stage for another kind of machine lacks nothing, and is not spoken of.
    """
    needs = ((absent.get(one.outcome), name) for one in steps for name in one.results)
    return tuple(Missing(tuple(results), lacks) for lacks, results in grouped(needs).items() if lacks)


def _freeze(outcome: object, seen: set[int]) -> None:
    """Make all arrays of an outcome read-only: stages and users share them. `seen` holds what has been gone through."""
    open_ends: list[object] = [outcome]
    while open_ends:
        value = open_ends.pop()
        holds = _what_it_holds(type(value))
        if holds is np.ndarray:
            cast(Array, value).setflags(write=False)
        elif holds is not None and id(value) not in seen:
            seen.add(id(value))
            open_ends += cast(tuple[object, ...], value) if holds is tuple else vars(value).values()


@cache
def _what_it_holds(kind: type) -> type | None:
    """As what a value of some type may hold arrays: as an array, a tuple, an object with fields; None of any other."""
    if issubclass(kind, np.ndarray | tuple):
        return np.ndarray if issubclass(kind, np.ndarray) else tuple
    return object if is_dataclass(cast(object, kind)) else None
