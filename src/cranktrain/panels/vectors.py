"""Vectors on a machine's drawing as data: of which quantity, at which pin, how large over the cycle."""

from collections.abc import Iterable, Iterator
from dataclasses import replace

import numpy as np

from cranktrain.language import Words
from cranktrain.motion import Array
from cranktrain.record import record
from cranktrain.saying.scales import scale_for

_NOTHING = 1e-9
"""Of the largest: less is rounding."""


@record
class PinVector:
    """A vector that starts at a pin.

    Attributes
    ----------
    mechanism, pin : str
    letter : str
        Of the quantity whose colour it has.
    symbol : str
        As mathematics sets it.
    value : Array, shape (2, n)
        X and Y at crank angles that stand evenly from 0 to the end of the cycle, both included; in SI until it is as it
        is shown; NaN where the links cannot close.
    """

    mechanism: str
    pin: str
    letter: str
    symbol: str
    value: Array

    @property
    def largest(self) -> float:
        """Its largest size; 0 where it has none."""
        return float(np.nanmax(np.hypot(*self.value), initial=0.0))


@record
class VectorsToScale:
    """Vectors of one sort.

    Attributes
    ----------
    title : Words
    unit : str
        Of the catalogue; once they are as they are shown, what is written.
    largest : float
        Of all that are drawn to the same scale.
    vectors : tuple of PinVector
    """

    title: Words
    unit: str
    largest: float
    vectors: tuple[PinVector, ...]


def to_one_scale(unit: str, sorts: Iterable[tuple[Words, Iterable[PinVector]]]) -> Iterator[VectorsToScale]:
    """Give sorts of vectors to the scale of the largest of all; what is nothing beside that is left out."""
    found = [(title, tuple(vectors)) for title, vectors in sorts]
    largest = max((one.largest for _title, vectors in found for one in vectors), default=0.0)
    for title, vectors in found:
        kept = tuple(one for one in vectors if one.largest > _NOTHING * largest)
        if kept:
            yield VectorsToScale(title, unit, largest, kept)


def vectors_as_shown(found: VectorsToScale) -> VectorsToScale:
    """Give vectors in the unit in which they are shown, and its label."""
    scale = scale_for(found.unit, found.largest)
    vectors = tuple(replace(one, value=scale.of(one.value)) for one in found.vectors)
    return replace(found, unit=scale.label, largest=float(scale.of(found.largest)), vectors=vectors)
