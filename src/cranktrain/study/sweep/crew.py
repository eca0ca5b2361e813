"""Who computes blocks of designs: this process, others beside it, or a cluster; their facts come in order."""

from collections.abc import Callable, Iterable, Iterator
from contextlib import AbstractContextManager
from typing import Protocol, TypeAlias

from cranktrain.errors import Problem
from cranktrain.how_far import listened_to
from cranktrain.language import Words, _
from cranktrain.study.facts_of_rows import FactsOfRows

Span: TypeAlias = tuple[int, int]
"""Designs of a sweep, from one and up to another."""
Compute: TypeAlias = Callable[[Span], FactsOfRows]

TRIES = 3
"""So often a block is computed whose process is killed meanwhile: each time anew, by another one."""
_AHEAD = 4
"""So many blocks for each that may work at once wait at most for those before them."""


class Crew(AbstractContextManager["Crew"], Protocol):
    """Whoever computes blocks, within `with`."""

    @property
    def n_at_once(self) -> int:
        """How many blocks may be handed over before one is finished."""
        ...

    def take(self, number: int, span: Span) -> None:
        """Take a block over."""
        ...

    def finished(self) -> Iterable[tuple[int, FactsOfRows | None]]:
        """Wait for blocks to be finished; None where each process that computed one was killed."""
        ...


class Alone(AbstractContextManager["Alone"]):
    """The process that asks."""

    n_at_once = 1

    def __init__(self, compute: Compute) -> None:
        self._compute = compute
        self._taken: list[tuple[int, Span]] = []

    def __exit__(self, *_raised: object) -> None:
        self._taken.clear()

    def take(self, number: int, span: Span) -> None:
        """Take a block over."""
        self._taken.append((number, span))

    def finished(self) -> Iterator[tuple[int, FactsOfRows]]:
        """Compute what was taken over."""
        while self._taken:
            number, span = self._taken.pop(0)
            with listened_to(_nobody):  # how far a block is says nothing beside how far all are
                found = self._compute(span)
            yield number, found


def _nobody(_words: object) -> None:
    """Listen to nothing."""


def in_order(
    blocks: Iterator[tuple[int, Span]], crew: Crew, say: Callable[[], None] = lambda: None
) -> Iterator[tuple[int, FactsOfRows | None]]:
    """Give the facts of blocks in the order of these; `say` is called before anybody is waited for.

    Parameters
    ----------
    blocks : iterator of (int, span)
        Taken as far as somebody computes them.
    crew : Crew
    say : callable

    Yields
    ------
    tuple
        Number of a block, and its facts: None where each process that computed it was killed.
    """
    order: list[int] = []
    ready: dict[int, FactsOfRows | None] = {}
    while True:
        while len(order) - len(ready) < crew.n_at_once and len(order) < _AHEAD * crew.n_at_once:
            block = next(blocks, None)
            if block is None:
                break
            order.append(block[0])
            crew.take(*block)
        if not order:
            return
        say()
        ready.update(crew.finished())
        while order and order[0] in ready:
            number = order.pop(0)
            yield number, ready.pop(number)


def killed(n_rows: int) -> FactsOfRows:
    """Designs of a block of which each process was killed that computed it."""
    return without_facts(n_rows, _("not computed: each process that began with it was killed; is memory short?"))


def without_facts(n_rows: int, why: Words) -> FactsOfRows:
    """Designs that were not computed."""
    nothing: tuple[Words, ...] = ("",) * n_rows
    return FactsOfRows({}, {}, {}, (Problem("", None, why),) * n_rows, nothing, nothing, ((),) * n_rows)
