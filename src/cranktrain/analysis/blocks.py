"""Many designs in blocks, so that memory does not grow with them: sizes, and results put together again."""

from collections.abc import Collection, Sequence
from dataclasses import fields, is_dataclass
from typing import Any, TypeVar, cast

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import Message, Words
from cranktrain.saying.catalogue import entries
from cranktrain.saying.checks import Flag

MOST_AT_ONCE = 64
"""Designs of a block; cost per design falls no further with more."""

Outcome = TypeVar("Outcome")


def block_sizes(n_designs: int) -> list[int]:
    """Sizes of blocks, all but alike; of several, two differ.

    What follows their sizes in a result has the design axis: no count of cylinders, orders or events does.
    """
    n_blocks = -(-n_designs // MOST_AT_ONCE)
    sizes = [len(part) for part in np.array_split(np.arange(n_designs), n_blocks)]
    if n_blocks > 1 and len(set(sizes)) == 1:
        sizes[0], sizes[-1] = sizes[0] + 1, sizes[-1] - 1
    return sizes


def is_kept(kind: type, names: Collection[str] | None) -> bool:
    """Whether a stage's result is kept of every block: with quantities, or with some of those that are asked for."""
    held = {entry.name for entry in entries(kind)}
    return bool(held) if names is None else not held.isdisjoint(names)


def joined(outcomes: Sequence[Outcome], sizes: Sequence[int]) -> Outcome:
    """Put what one stage gave of each block together.

    Parameters
    ----------
    outcomes : sequence of result objects
        One of each block, in their order.
    sizes : sequence of int
        Designs of each block.

    Returns
    -------
    result object
        Arrays and tuples that follow the blocks' sizes are joined, warnings are told once; what does not hang on the
        design is that of the first block.
    """
    return cast("Outcome", _joined(outcomes, sizes))


def _joined(each: Sequence[Any], sizes: Sequence[int]) -> Any:
    first = each[0]
    if all(one is first for one in each):
        return first
    if isinstance(first, np.ndarray):
        arrays = cast("Sequence[NDArray[Any]]", each)
        return np.concatenate(arrays) if _follows([len(np.atleast_1d(part)) for part in arrays], sizes) else arrays[0]
    if is_dataclass(first) and not isinstance(first, type):
        parts = {one.name: _joined([getattr(part, one.name) for part in each], sizes) for one in fields(first)}
        return type(first)(**parts)
    if isinstance(first, tuple):
        return _joined_tuples(cast("Sequence[tuple[Any, ...]]", each), sizes)
    return first


def _joined_tuples(each: Sequence[tuple[Any, ...]], sizes: Sequence[int]) -> Any:
    """Tuples of sentences, of one item for each design, or of parts that are the same in all blocks."""
    first = each[0]
    if hasattr(first, "_fields"):
        return type(first)(*(_joined(parts, sizes) for parts in zip(*each, strict=True)))
    if _follows([len(part) for part in each], sizes):
        return tuple(item for part in each for item in part)
    if all(isinstance(item, str | Message) for part in each for item in part):
        return _joined_words(each, sizes)
    return tuple(_joined(parts, sizes) for parts in zip(*each, strict=True))


def _joined_words(each: Sequence[tuple[Words, ...]], sizes: Sequence[int]) -> tuple[Words, ...]:
    """Sentences, each once; a flag of designs with these at their places among all."""
    said: dict[Words, Words] = {}
    start = 0
    for words, size in zip(each, sizes, strict=True):
        for one in words:
            before = said.setdefault(one, one)
            if isinstance(one, Flag):
                own = {start + design: message for design, message in one.own.items()}
                if isinstance(before, Flag) and before is not one:
                    own = {**before.own, **own}
                said[one] = Flag(one.text, one.pieces, own)
        start += size
    return tuple(said.values())


def _follows(lengths: Sequence[int], sizes: Sequence[int]) -> bool:
    """Whether lengths are those of the blocks."""
    return len(sizes) > 1 and list(lengths) == list(sizes)
