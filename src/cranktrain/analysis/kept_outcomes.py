"""What stages gave before a number of a machine was changed: what does not hang on it is not found again.

Whether it does nobody declares. Stages give the same of the same; so what a stage gave is kept with what it was given,
and given again where it is given that, to the last bit.
"""

from collections.abc import Callable, Iterable, Mapping
from typing import Any, NamedTuple, TypeVar, final

from cranktrain.layout.question import Stage
from cranktrain.numerics.sameness import is_same

Part = TypeVar("Part")


_GONE: Any = object()
"""Stands for an outcome that was let go."""


class _Kept(NamedTuple):
    """A part or an outcome.

    Attributes
    ----------
    held : object
    mark : object
        That nothing else has: others say by it that they were given this.
    stage : Stage or None
        That gave an outcome.
    given : mapping of str to object
        The marks of what it was given.
    telling : tuple of str
        The needs whose change last made it another.
    """

    held: Any
    mark: object
    stage: Stage | None = None
    given: Mapping[str, object] = {}
    telling: tuple[str, ...] = ()

    def changed(self, given: Mapping[str, object]) -> tuple[str, ...]:
        """Give the needs that a stage is given now, by these marks, and was not given then."""
        return tuple(name for name, mark in given.items() if mark is not self.given[name])


@final
class KeptOutcomes:
    """The last that each stage gave for machines that come from one another by `with_`.

    Of each stage one outcome is held, however many machines there are. Threads may ask together: one that comes between
    another's question and answer costs it the time that it might have saved.
    """

    def __init__(self) -> None:
        self._kept: dict[type, _Kept] = {}

    def __reduce__(self) -> tuple[type["KeptOutcomes"], tuple[()]]:
        """Leave all behind where machines are sent or copied."""
        return (KeptOutcomes, ())

    def part(self, part: Part) -> Part:
        """Give the part that stages were given before, if this one is the same to the last bit; else this one."""
        before = self._kept.get(type(part))
        if before is not None and is_same(before.held, part):
            return before.held
        self._kept[type(part)] = _Kept(part, object())
        return part

    def outcome(self, stage: Stage, needs: Mapping[str, object]) -> object:
        """Give what a stage gives of parts and of what other stages gave, found now unless it was given them before."""
        given = {name: self._mark(stage.needs[name], found) for name, found in needs.items()}
        before = self._kept.get(stage.gives)
        if before is None or before.stage is not stage:
            return self._keep(stage, stage.function(**needs), given)
        changed = before.changed(given)
        if before.held is _GONE:
            return self._keep(stage, stage.function(**needs), given, changed)
        if not changed:
            return before.held
        outcome = stage.function(**needs)
        if is_same(before.held, outcome):  # and so is all that hangs on it
            self._kept[stage.gives] = before._replace(given=given)
            return before.held
        return self._keep(stage, outcome, given, changed)

    def forget(self, stages: Iterable[Stage], known: Callable[[type], object]) -> None:
        """Let go what these stages, in the order in which they run, will give anew as the last time.

        Who moves a slider changes the same again and again. What nobody compares with goes all at once, before anything
        else comes: that then finds its place in the processor's cache.
        """
        marks: dict[type, object] = {}
        for stage in stages:
            before = self._kept.get(stage.gives)
            if before is None or before.stage is not stage or not before.telling:
                continue
            for need in stage.needs.values():
                if need not in marks:
                    marks[need] = self._mark_now(need, known(need))
            if before.changed({name: marks[need] for name, need in stage.needs.items()}) == before.telling:
                marks[stage.gives] = mark = object()
                self._kept[stage.gives] = before._replace(held=_GONE, mark=mark)

    def _mark_now(self, kind: type, known: object | None) -> object:
        """The mark of a part that is known, or else of what is kept."""
        if known is not None:
            return self._mark(kind, known)
        kept = self._kept.get(kind)
        return None if kept is None else kept.mark

    def _mark(self, kind: type, found: object) -> object:
        """The mark of what a stage is given; of what is not kept, or no more, the thing itself."""
        kept = self._kept.get(kind)
        return kept.mark if kept is not None and kept.held is found else found

    def _keep(
        self, stage: Stage, outcome: object, given: Mapping[str, object], telling: tuple[str, ...] = ()
    ) -> object:
        """Keep what a stage gave."""
        self._kept[stage.gives] = _Kept(outcome, object(), stage, given, telling)
        return outcome
