"""Dimensions of all results: those that questions share, and those that each brings."""

from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from itertools import chain, product

from cranktrain import texts
from cranktrain.all_questions import QUESTIONS
from cranktrain.language import Words
from cranktrain.layout import parts
from cranktrain.layout.question import ResultDimension

Place = tuple[int | slice, ...]
"""Which members along each of some dimensions: one, or all."""

_SHARED = {dimension.name: dimension for dimension in (*parts.DIMENSIONS, *texts.DIMENSIONS)}


@cache
def dimension_named(name: str) -> ResultDimension:
    """Give a dimension: one that questions share, or that one of them brings; else a plain one."""
    if name in _SHARED:
        return _SHARED[name]
    # No other question is loaded where one that is has it.
    brought = (one for question in chain(QUESTIONS.loaded, QUESTIONS) for one in question.dimensions)
    return next((one for one in brought if one.name == name), ResultDimension(name, ""))


class Titled(Mapping[str, tuple[Words, ...]]):
    """What people call the members along dimensions, found where somebody asks."""

    def __init__(self, labels: Mapping[str, tuple[str, ...]]) -> None:
        self._labels = labels

    def __getitem__(self, dimension: str) -> tuple[Words, ...]:
        return dimension_named(dimension).called(self._labels[dimension])

    def __iter__(self) -> Iterator[str]:
        return iter(self._labels)

    def __len__(self) -> int:
        return len(self._labels)


def rivals(labels: Mapping[str, Sequence[str]]) -> Iterator[tuple[Place, str]]:
    """Part values by what are rivals among their members, as methods are, the one that is meant first.

    Parameters
    ----------
    labels : mapping of str to sequence of str
        Names along each dimension, in their order.

    Yields
    ------
    place : tuple of int or slice
        One rival, with all members along the other dimensions.
    words : str
        Its name; empty where there are none beside it.
    """
    each = [_places(dimension_named(dimension).own, len(names)) for dimension, names in labels.items()]
    for place in product(*each):
        chosen = zip(place, labels.values(), strict=True)
        yield place, ", ".join(names[at] for at, names in chosen if not isinstance(at, slice) and len(names) > 1)


def _places(own: int | None, n_members: int) -> Sequence[int | slice]:
    """All members at once, or rivals one by one."""
    if own is None or not n_members:
        return (slice(None),)
    first = own % n_members
    return (first, *(i for i in range(n_members) if i != first))
