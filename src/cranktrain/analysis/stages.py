"""Stages in the order in which they can run: all that a machine allows, and in words what it lacks for the others."""

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, lru_cache
from graphlib import TopologicalSorter
from typing import TypeAlias, cast

from cranktrain import texts
from cranktrain.all_questions import QUESTIONS
from cranktrain.analysis.unasked import UnaskedStage, unasked
from cranktrain.brief import brief_fields
from cranktrain.errors import Problem, refuse
from cranktrain.grouping import grouped
from cranktrain.language import Message, _
from cranktrain.layout.question import NOT_FOR_IT, Applies, Stage
from cranktrain.machine import Machine
from cranktrain.mechanisms import KINDS
from cranktrain.saying.names import said_name

KEPT = 64
"""Of how many sorts of machines, or ways of asking, it is kept what of all stages they take or lack."""


@dataclass(frozen=True)
class Missing:
    """Results that a machine file does not allow yet: their names, and what the file would have to say."""

    results: tuple[str, ...]
    needs: tuple[Message, ...]

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
    return Problem(path, name, allowed, _("did you mean {name}?", name=close) if close else None)


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


def stages_over_time(machine: Machine, parts: Mapping[type, object]) -> tuple[Stage, ...]:
    """Give the stages of what a machine's file asks, and those over time that are for it, whose names go first."""
    own = (stage for question in machine.questions for stage in question.over_time())
    return (*stages_for(machine), *(stage for stage in own if stage.applies_to(parts) is True))


def every_stage() -> tuple[Stage, ...]:
    """Give all stages that there are."""
    return stages_of(QUESTIONS.names, KINDS.names)


Step: TypeAlias = Stage | UnaskedStage
"""A stage, or what is known of one that nobody asks."""


@cache
def steps_of(questions: tuple[str, ...], kinds: tuple[str, ...]) -> tuple[Step, ...]:
    """Give the stages of questions and kinds, and in their place what is known of those of all other questions."""
    asked = {name for name in QUESTIONS.names if name in questions or not unasked(name).is_general}
    each = ((QUESTIONS.named(name) if name in asked else unasked(name)).stages for name in QUESTIONS.names)
    return (*(step for steps in each for step in steps), *stages_of((), kinds))


def lacking(steps: Sequence[Step], parts: Mapping[type, object]) -> dict[str, tuple[Message, ...]]:
    """Which outcomes cannot be made of some parts, and what is missing for them.

    Parameters
    ----------
    steps : sequence of Stage or UnaskedStage
        In any order.
    parts : mapping of type to object
        What the machine declares.

    Returns
    -------
    dict of str to tuple of Message
        By the names of outcomes, in words for what a machine file could say; none of an outcome that is not for this
        machine.
    """
    every = tuple(steps)
    answers = tuple(one.applies_to(parts) for one in _choosy(every).values())
    roots = _roots(every, frozenset(part.__name__ for part in parts), answers)
    told = {words: () if NOT_FOR_IT in words else tuple(map(_, sorted(words))) for words in set(roots.values())}
    return {outcome: told[words] for outcome, words in roots.items()}


@lru_cache(maxsize=KEPT)
def _roots(
    steps: tuple[Step, ...], declared: frozenset[str], answers: tuple[Applies, ...]
) -> Mapping[str, frozenset[str]]:
    """What a file would have to say for outcomes that cannot be made of parts, by their names.

    `answers` are what the parts say of the choosy steps.
    """
    known, roots = set(declared), dict[str, frozenset[str]]()
    answered = dict(zip(_choosy(steps), answers, strict=True))
    for one in _by_needs(steps):
        needed = one.lacks.keys() - known
        applies = answered[one.applies] if isinstance(one, Stage) and one.applies else one.applies_to({})
        if needed or applies is not True:
            asked = applies if isinstance(applies, tuple) else (applies or NOT_FOR_IT,)
            said = frozenset[str]() if applies is True else frozenset(cast(tuple[str, ...], asked))
            roots[one.outcome] = said.union(*(roots.get(need, frozenset([one.lacks[need]])) for need in needed))
        else:
            known.add(one.outcome)
    return roots


@cache
def _choosy(steps: tuple[Step, ...]) -> Mapping[Callable[..., Applies], Stage]:
    """Steps whose machines they choose by their parts, one for each way of choosing."""
    return {one.applies: one for one in steps if isinstance(one, Stage) and one.applies}


@cache
def _by_needs(steps: tuple[Step, ...]) -> tuple[Step, ...]:
    """Put steps in an order in which what each cannot do without comes before it."""
    by_outcome = {one.outcome: one for one in steps}
    graph = {one.outcome: [need for need in one.lacks if need in by_outcome] for one in steps}
    return tuple(by_outcome[outcome] for outcome in TopologicalSorter(graph).static_order())


def spoken(outcome: type) -> str:
    """Name of a result in words: `DeadCentres` are dead centres."""
    return said_name(key_of(outcome))


def key_of(outcome: type) -> str:
    """Name of a result's class as other names of the program are written: of `DeadCentres`, `dead_centres`."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", outcome.__name__).lower()


def missing_results(steps: Sequence[Step], absent: Mapping[str, tuple[Message, ...]]) -> tuple[Missing, ...]:
    """Results that stages do not give, in their order, those that lack the same together.

    Parameters
    ----------
    steps : sequence of Stage or UnaskedStage
    absent : mapping of str to tuple of str
        As `lacking` gives it; a stage for another kind of machine lacks nothing, and is not spoken of.
    """
    needs = ((lacks, name) for one in steps if (lacks := absent.get(one.outcome)) for name in one.results)
    return tuple(Missing(tuple(results), lacks) for lacks, results in grouped(needs).items())
