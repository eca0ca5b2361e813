"""Throws that carry mechanisms: where they stand, and whose they are; and the centres of their shafts."""

from collections.abc import Mapping, Sequence
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_
from cranktrain.layout.places import PlacedMechanism
from cranktrain.layout.specs import MAIN, ShaftSpec
from cranktrain.layout.standing import shaft_centres
from cranktrain.numerics.designs import by_design
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

    reads: ClassVar[tuple[str, ...]] = ("[shaft.NAME]",)

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
    shafts: Mapping[str, ShaftSpec], places: Sequence[PlacedMechanism], n_designs: int
) -> ShaftCentres | None:
    """Find the centres; None where a shaft that carries a mechanism has no place."""
    centres = shaft_centres(shafts)
    if any(place.shaft not in centres for place in places):
        return None
    across, up = (by_design([centres[place.shaft][axis] for place in places], n_designs) for axis in (0, 1))
    return ShaftCentres(across + 1j * up)
