"""What stages give, each found when it is first asked for: once, of the parts that are kept, in whatever order."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from copy import copy
from dataclasses import is_dataclass
from functools import cache, partial
from threading import RLock
from typing import TYPE_CHECKING, Any, NamedTuple, Self, cast, final

import numpy as np

from cranktrain.analysis.grids import are_wide, coarse_curves, has_curves, with_curves
from cranktrain.analysis.shapes import refuse_misshapen
from cranktrain.analysis.stages import ordered, spoken
from cranktrain.how_far import say_how_far
from cranktrain.language import Said, Words, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.question import Parts, Stage
from cranktrain.mechanisms.kind import Kind
from cranktrain.motion import Array
from cranktrain.saying.catalogue import entries

if TYPE_CHECKING:
    from cranktrain.analysis.kept_outcomes import KeptOutcomes

Labels = Mapping[str, tuple[str, ...]]


class StageRun:
    """Stages of some parts, each run when what it gives is asked for; nobody asks for what others lack."""

    def __init__(self, stages: Sequence[Stage], parts: Parts, kept: "KeptOutcomes | None" = None) -> None:
        self._order = ordered(tuple(stages))
        self._known: dict[type, Any] = dict(parts)
        self._kept, self._own_parts, self._is_under_way = kept, set(parts), False
        self.labels: dict[str, tuple[str, ...]] = {}
        """Names along the dimensions of all that is known."""
        for part in parts.values():
            self.labels |= getattr(part, "labels", {})

    @property
    def n_angles(self) -> int:
        """Crank angles of its grid."""
        grid: CrankAngle = self._known[CrankAngle]
        return grid.shown.size

    def find(self, kinds: Iterable[type], accept: Callable[[Any, Labels], None] | None = None) -> None:
        """Run the stages that lead to some outcomes and were not run yet.

        Parameters
        ----------
        kinds : iterable of type
        accept : callable, optional
            Given what a stage gives, with names along its dimensions; raises where nobody is to have that.
        """
        way = self._way(kinds)
        if self._kept is not None and not self._is_under_way:
            self._kept.forget(self._order, self._need)
        self._is_under_way = True
        # NaN stands for links that cannot close, and is no news.
        with np.errstate(all="ignore"):
            for place, one in enumerate(way, start=1):
                say_how_far(partial(_how_far, place, len(way), one.gives))
                outcome = self._given_by(one)
                own: Labels | None = getattr(outcome, "labels", None)
                labels = {**self.labels, **own} if own else self.labels
                if accept is not None:
                    accept(outcome, labels)
                self._known[one.gives], self.labels = outcome, labels

    def know(self, outcome: object) -> None:
        """Take an outcome that was found otherwise, on which stages may go on."""
        self._known[type(outcome)] = outcome
        self.labels = {**self.labels, **getattr(outcome, "labels", {})}

    def __getitem__(self, kind: type) -> Any:
        """Give an outcome that was found."""
        return self._known[kind]

    def as_now(self) -> Self:
        """Give a run that knows what this one knows now, whatever this one finds later."""
        other = copy(self)
        vars(other).update(_known=dict(self._known), _own_parts=set(self._own_parts))
        return other

    def _way(self, kinds: Iterable[type]) -> list[Stage]:
        """Stages that are still to be run, in the order in which they can be."""
        wanted, way = set(kinds), list[Stage]()
        for one in reversed(self._order):  # in which each stands behind what it needs
            if one.gives in wanted and one.gives not in self._known:
                way.append(one)
                wanted.update(one.needs.values())
        return way[::-1]

    def _given_by(self, stage: Stage) -> object:
        """Run a stage."""
        needs = {name: self._need(need) for name, need in stage.needs.items()}
        try:
            return stage.function(**needs) if self._kept is None else self._kept.outcome(stage, needs)
        except AttributeError as error:  # which would say of a result that it has no such quantity
            raise RuntimeError(f"{stage.outcome} could not be computed: {error}") from error

    def _need(self, kind: type) -> object | None:
        """Give a part or an outcome that there is: the part that is kept, where it is the same."""
        found = self._known.get(kind)
        if self._kept is not None and kind in self._own_parts:
            found = self._known[kind] = self._kept.part(found)
            self._own_parts.discard(kind)
        return found


def run_stages(
    stages: Sequence[Stage], parts: Parts, absent: Iterable[str], kept: "KeptOutcomes | None" = None
) -> dict[type, object]:
    """Run every stage whose needs are met.

    Parameters
    ----------
    stages : sequence of Stage
        In any order; results come in this one.
    parts : mapping of type to object
        What the machine declares.
    absent : iterable of str
        Names of outcomes that cannot be had of these, as `lacking` finds it.
    kept : KeptOutcomes, optional
        What they gave of others, given again where it is the same.

    Returns
    -------
    mapping of type to object
    """
    left_out = frozenset(absent)
    there = [one for one in stages if one.outcome not in left_out]
    run = StageRun(there, parts, kept)
    run.find(one.gives for one in there)
    return {one.gives: run[one.gives] for one in there}


class Finding(NamedTuple):
    """How outcomes are found that nobody has asked for yet.

    Attributes
    ----------
    kinds : sequence of type
        Of the outcomes, in the order in which people read them.
    facts, curves : StageRun
        Which may be one.
    every : int
        Of so many points of curves one is taken.
    shown : Array, shape (n,)
        Crank angles at which curves are shown. [rad]
    """

    kinds: Sequence[type]
    facts: StageRun
    curves: StageRun
    every: int
    shown: Array


@final
class Outcomes:
    """What the stages of a run give, by its type, in SI and radians, with the design axis.

    Whatever is asked of it first, the same comes out. Threads may ask it together.

    Parameters
    ----------
    given : mapping of type to object
        Outcomes that are there.
    labels : mapping of str to tuple of str
        Names along the dimensions of these, and of all parts.
    finding : Finding, optional
        How others are found.
    coarse : tuple of Words
        What is to be said of wide steps, where there are no others.
    """

    def __init__(
        self,
        given: Mapping[type, object],
        labels: Labels,
        finding: Finding | None = None,
        coarse: tuple[Words, ...] = (),
    ) -> None:
        self.kinds = (*given, *(finding.kinds if finding is not None else ()))
        self.known, self._first, self._designs = dict(labels), tuple(labels), labels["design"]
        self._shown: dict[type, Any] = dict(given)
        self._finding, self._coarse = finding, coarse
        self._frozen: set[type] = set()
        self._lock = RLock()

    def __getitem__(self, kind: type) -> Any:
        """Give an outcome, found now if nobody asked for it before."""
        if kind not in self._frozen:
            self.find((kind,))
            read_only(self._shown[kind])
            self._frozen.add(kind)
        return self._shown[kind]

    def find(self, kinds: Iterable[type]) -> None:
        """Find outcomes, and all that they need."""
        with self._lock:
            wanted = [kind for kind in kinds if kind not in self._shown]
            if not wanted or self._finding is None:
                return
            _kinds, facts, curves, every, _shown = self._finding
            self._find(facts, wanted)
            drawn = [kind for kind in wanted if has_curves(kind)]
            if curves is not facts:
                self._find(curves, drawn)
            for kind in wanted:
                is_drawn = kind in drawn and (curves is not facts or every > 1)
                self._shown[kind] = with_curves(facts[kind], curves[kind], every) if is_drawn else facts[kind]

    def _find(self, run: StageRun, kinds: Sequence[type]) -> None:
        """Find what a run gives, and hold its arrays against their dimensions."""
        n_angles = run.n_angles

        def accept(outcome: object, labels: Labels) -> None:
            refuse_misshapen((outcome,), {"design": self._designs, **labels}, n_angles)

        try:
            run.find(kinds, accept)
        finally:
            self.known.update(run.labels)

    @property
    def labels(self) -> "FoundLabels":
        """Names along dimensions. They hold the outcomes and not the other way, so that all goes with who holds it."""
        return FoundLabels(self, self._first)

    @property
    def coarse(self) -> tuple[Words, ...]:
        """What is to be said of curves for which the steps asked for are too wide; all are found for that."""
        if self._finding is None or not are_wide(self._finding.shown):
            return self._coarse
        self.find(self.kinds)
        facts = {kind: self._finding.facts[kind] for kind in self._finding.kinds}
        curves = {kind: self._shown[kind] for kind in self._finding.kinds}
        return coarse_curves(facts, curves, self._finding.shown)

    def __getstate__(self) -> dict[str, Any]:
        """Give all but the lock, which is for the threads of one process, as it is now."""
        with self._lock:
            state = {**vars(self), "_shown": dict(self._shown), "known": dict(self.known)}
            if self._finding is not None:
                facts, curves = (self._finding.facts.as_now(), self._finding.curves.as_now())
                is_one = self._finding.curves is self._finding.facts
                state["_finding"] = self._finding._replace(facts=facts, curves=facts if is_one else curves)
        # Arrays that were sent can be written to again.
        return {**{name: held for name, held in state.items() if name != "_lock"}, "_frozen": set()}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Take all, and a lock of one's own."""
        vars(self).update(state, _lock=RLock())


class FoundLabels(Mapping[str, tuple[str, ...]]):
    """Names along dimensions; of what was not computed yet, they are found with it."""

    def __init__(self, outcomes: Outcomes, first: Sequence[str]) -> None:
        self._outcomes, self._first = outcomes, first

    def __getitem__(self, dimension: str) -> tuple[str, ...]:
        known = self._outcomes.known
        for kind in self._outcomes.kinds:
            if dimension in known:
                break
            if any(dimension in entry.dimensions for entry in entries(kind)):
                self._outcomes.find((kind,))
        return known[dimension]

    def __iter__(self) -> Iterator[str]:
        self._outcomes.find(self._outcomes.kinds)
        held = (getattr(self._outcomes[kind], "labels", {}) for kind in self._outcomes.kinds)
        return iter(
            dict.fromkeys([*self._first, *(name for labels in held for name in labels), *sorted(self._outcomes.known)])
        )

    def __repr__(self) -> str:
        return repr(dict(self))

    def __len__(self) -> int:
        return sum(1 for _dimension in self)


def _how_far(place: int, n_stages: int, outcome: type) -> Words:
    """Which result is worked on."""
    return _("{place} of {n}, {name}", place=place, n=n_stages, name=spoken(outcome))


def read_only(outcome: object) -> None:
    """Make all arrays of an outcome read-only, before anybody has it: what other stages are still to ask is the same.

    Stages change nothing that others gave, which is tested.
    """
    open_ends: list[Iterable[object]] = [(outcome,)]
    seen = set[int]()
    while open_ends:
        for value in open_ends.pop():
            if isinstance(value, np.ndarray):
                value.setflags(write=False)
            elif _may_hold_arrays(type(value)) and id(value) not in seen:
                seen.add(id(value))
                open_ends.append(_held_in(value))


def _held_in(value: object) -> Iterable[object]:
    """What a tuple, a list or a mapping holds, or the fields of an object."""
    if isinstance(value, tuple | list):
        return cast("Iterable[object]", value)
    return (cast("Mapping[object, object]", value) if isinstance(value, Mapping) else vars(value)).values()


@cache
def _may_hold_arrays(kind: type) -> bool:
    """Whether a value of some type, no array itself, may hold arrays: a collection or an object with fields.

    No kind does, and no words.
    """
    is_record = is_dataclass(cast(object, kind)) and not issubclass(kind, Kind | Said)
    return is_record or issubclass(kind, tuple | list | Mapping)
