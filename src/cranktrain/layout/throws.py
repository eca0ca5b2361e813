"""Throws that carry mechanisms: where they stand, and whose they are; and the centres of their shafts."""

from collections.abc import Mapping, Sequence
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_
from cranktrain.layout.places import PlacedMechanism
from cranktrain.layout.specs import MAIN, ShaftSpec
from cranktrain.layout.standing import shaft_centres
from cranktrain.numerics.gathering import gathered
from cranktrain.numerics.harmonics import ComplexArray
from cranktrain.record import record


@record
class Throws:
    """Throws that carry mechanisms.

    Attributes
    ----------
    names : tuple of str
        `1`, `2`, … of `main`, `upper.1` of another shaft.
    shafts : tuple of str
        Whose each is.
    carrying : array of int, shape (mechanism,)
        Which of them each mechanism works on.
    first : array of int, shape (throw,)
        The first mechanism on each.
    """

    names: tuple[str, ...]
    shafts: tuple[str, ...]
    carrying: NDArray[np.intp]
    first: NDArray[np.intp]

    def gathered(self, values: ComplexArray) -> ComplexArray:
        """Sum what the mechanisms on each throw have, shape (design, mechanism, n) → (design, throw, n)."""
        return gathered(values, self.carrying, len(self.names))


def throws_of(places: Sequence[PlacedMechanism]) -> Throws:
    """List the throws in the order of the mechanisms."""
    carriers = [(place.shaft, place.throw) for place in places]
    throws = list(dict.fromkeys(carriers))
    return Throws(
        names=tuple(f"{throw + 1}" if shaft == MAIN else f"{shaft}.{throw + 1}" for shaft, throw in throws),
        shafts=tuple(shaft for shaft, _throw in throws),
        carrying=np.array([throws.index(carrier) for carrier in carriers], dtype=np.intp),
        first=np.array([carriers.index(throw) for throw in throws], dtype=np.intp),
    )


@record
class ShaftCentres:
    """Centre of every mechanism's shaft from that of `main`, X + iY, shape (design, mechanism). [m]"""

    needs: ClassVar[str] = N_("[shaft.NAME] place")

    value: ComplexArray


def shaft_centres_of(
    shafts: Sequence[Mapping[str, ShaftSpec]], designs: Sequence[Sequence[PlacedMechanism]]
) -> ShaftCentres | None:
    """Find the centres; None where a shaft that carries a mechanism has no place."""
    centres = [shaft_centres(design) for design in shafts]
    if any(place.shaft not in centres[0] for place in designs[0]):
        return None
    return ShaftCentres(
        np.array(
            [[complex(*known[place.shaft]) for place in design] for known, design in zip(centres, designs, strict=True)]
        )
    )
