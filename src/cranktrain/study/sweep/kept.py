"""Where the facts of a sweep are kept while it is computed: in memory, or in a store of which one can go on."""

from collections.abc import Set as AbstractSet
from typing import NamedTuple, Protocol

from cranktrain.language import Words, _
from cranktrain.machine import Machine
from cranktrain.study.facts_of_rows import FactsOfRows, joined_rows
from cranktrain.study.sweep.blocks import Blocks
from cranktrain.study.sweep.crew import without_facts
from cranktrain.study.sweep.varied import SweptDesigns

STORE = ".zarr"
"""How the name of a store ends."""


class Plan(NamedTuple):
    """What a sweep is of: facts `wanted` of `designs` of a `machine`, over the cycle or of their starts."""

    machine: Machine
    designs: SweptDesigns
    wanted: tuple[str, ...]
    over_time: bool


class Store(Protocol):
    """Keeps facts block by block."""

    def opened(self, plan: Plan, /) -> Blocks | None:
        """Give the blocks of a sweep that was begun, to go on with it; None of one that is to begin.

        Raises
        ------
        InputError
            Where there is another sweep, or one with which nobody asked to go on.
        """
        ...

    def begin(self, plan: Plan, blocks: Blocks, /) -> None:
        """Make room for the facts of all blocks."""
        ...

    @property
    def done(self) -> AbstractSet[int]:
        """Numbers of the blocks that are kept."""
        ...

    def add(self, number: int, found: FactsOfRows, /, *, is_lost: bool = False) -> None:
        """Keep the facts of a block, after all before it; of one that `is_lost` why there are none."""
        ...

    def end(self) -> None:
        """Leave all whole, whether all blocks are kept or not."""
        ...

    def found(self) -> FactsOfRows:
        """Give all that is kept; what is not has a sentence."""
        ...


class InMemory:
    """Keeps facts as long as this process has them."""

    def __init__(self) -> None:
        self._parts: list[FactsOfRows] = []
        self._n_designs = 0

    done: AbstractSet[int] = frozenset()

    def opened(self, _plan: Plan) -> None:
        """Nothing was begun before."""

    def begin(self, plan: Plan, _blocks: Blocks) -> None:
        """Make room."""
        self._n_designs = len(plan.designs)

    def add(self, _number: int, found: FactsOfRows, *, is_lost: bool = False) -> None:
        """Keep a block, which stands behind all before it."""
        del is_lost
        self._parts.append(found)

    def end(self) -> None:
        """Leave all as it is."""

    def found(self) -> FactsOfRows:
        """Give all that is kept."""
        n_left = self._n_designs - sum(len(part.refused) for part in self._parts)
        return joined_rows([*self._parts, *([without_facts(n_left, stopped())] if n_left else [])])


def stopped() -> Words:
    """Why a design was not computed that is not kept."""
    return _("not computed, as the sweep was stopped")
