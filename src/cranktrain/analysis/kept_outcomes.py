"""What stages gave before a number of a machine was changed: what does not hang on it is not found again.

Whether it does nobody declares. Stages give the same of the same; so what a stage gave is kept with what it was given,
and given again where it is given that, to the last bit.
"""

from collections.abc import Mapping
from typing import Any, NamedTuple, TypeVar, final

from cranktrain.layout.question import Stage
from cranktrain.machine import Machine
from cranktrain.numerics.sameness import is_same

Part = TypeVar("Part")


class _Given(NamedTuple):
    """What a stage was given, and what it gave of that."""

    stage: Stage
    needs: Mapping[str, object]
    outcome: object


@final
class KeptOutcomes:
    """The last that each stage gave for machines that come from one another by `with_`.

    Of each stage one outcome is held, however many machines there are. Threads may ask together: one that comes between
    another's question and answer costs it the time that it might have saved.
    """

    def __init__(self) -> None:
        self._parts: dict[type, Any] = {}
        self._given: dict[type, _Given] = {}

    def __reduce__(self) -> tuple[type["KeptOutcomes"], tuple[()]]:
        """Leave all behind where machines are sent or copied."""
        return (KeptOutcomes, ())

    def part(self, part: Part) -> Part:
        """Give the part that stages were given before, if this one is the same to the last bit; else this one."""
        before: Part | None = self._parts.get(type(part))
        if before is not None and is_same(before, part):
            return before
        self._parts[type(part)] = part
        return part

    def outcome(self, stage: Stage, needs: Mapping[str, object]) -> object:
        """Give what a stage gives of parts and of what other stages gave, found now unless it was given them before."""
        before = self._given.get(stage.gives)
        if before is None or before.stage is not stage or any(before.needs[name] is not needs[name] for name in needs):
            before = self._given[stage.gives] = _Given(stage, needs, stage.function(**needs))
        return before.outcome


def kept_outcomes(machine: Machine) -> KeptOutcomes | None:
    """Give what stages gave of machines from which one comes by `with_`; None where it comes from none."""
    return machine.alike.setdefault(KeptOutcomes, KeptOutcomes()) if "alike" in vars(machine) else None
