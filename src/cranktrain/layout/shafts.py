"""Shafts and their throws: which mechanism works on which, the journals between them, and where they stand."""

from collections.abc import Mapping, Sequence
from itertools import accumulate
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_
from cranktrain.layout.places import PlacedMechanism
from cranktrain.layout.specs import MAIN, ShaftSpec
from cranktrain.layout.standing import shaft_centres
from cranktrain.motion import ZERO, Array
from cranktrain.numerics.designs import by_design
from cranktrain.numerics.gathering import gathered
from cranktrain.numerics.harmonics import ComplexArray
from cranktrain.record import record


@record
class Shafts:
    """The crankshafts of a machine and what works on them.

    Attributes
    ----------
    names : tuple of str
    n_throws : tuple of int
        Throws of each shaft.
    shaft, throw : array of int, shape (mechanism,)
        On which shaft each mechanism works, and on which throw of it, from 0.
    """

    reads: ClassVar[tuple[str, ...]] = ("[shaft.NAME]",)

    names: tuple[str, ...]
    n_throws: tuple[int, ...]
    shaft: NDArray[np.intp]
    throw: NDArray[np.intp]

    @property
    def main(self) -> int:
        """The shaft whose angle is the crank angle."""
        return self.names.index(MAIN)

    @property
    def journals(self) -> tuple[str, ...]:
        """Names of all main journals: `1` stands before throw 1; with several shafts, `upper.1`."""
        return tuple(
            f"{name}.{number}" if len(self.names) > 1 else str(number)
            for name, n_throws in zip(self.names, self.n_throws, strict=True)
            for number in range(1, n_throws + 2)
        )


def shafts_of(shafts: Mapping[str, ShaftSpec], places: Sequence[PlacedMechanism]) -> Shafts:
    """Say where every mechanism works."""
    names = tuple(shafts)
    return Shafts(
        names=names,
        n_throws=tuple(len(shaft.throws) for shaft in shafts.values()),
        shaft=np.array([names.index(place.shaft) for place in places], dtype=np.intp),
        throw=np.array([place.throw for place in places], dtype=np.intp),
    )


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


@record
class AxialPlaces:
    """Distance of every mechanism from throw 1 along Z, shape (design, mechanism). [m]

    throw is that of the middle of its throw, from which the bank's stagger sets it aside. [m]
    mid_plane, shape (design,), lies halfway between the first and the last throw of `main`: z̄, about which couples
    count. [m]
    """

    needs: ClassVar[str] = N_("[shaft.main] spacing")
    reads: ClassVar[tuple[str, ...]] = ("[bank.NAME]", "[shaft.NAME]")

    value: Array
    throw: Array
    mid_plane: Array


def axial_places_of(
    shafts: Mapping[str, ShaftSpec], places: Sequence[PlacedMechanism], n_designs: int
) -> AxialPlaces | None:
    """Add up the gaps between throws, and the banks' stagger; None where several throws have no spacing."""
    positions = {name: along for name, shaft in shafts.items() if (along := throw_positions(shaft)) is not None}
    if len(positions) < len(shafts):
        return None
    return AxialPlaces(
        by_design([positions[place.shaft][place.throw] + place.stagger for place in places], n_designs),
        by_design([positions[place.shaft][place.throw] for place in places], n_designs),
        by_design([positions[MAIN][-1] / 2], n_designs)[:, 0],
    )


def throw_positions(shaft: ShaftSpec) -> list[Array] | None:
    """Distance of every throw from throw 1; None where it is not given. [m]"""
    n_gaps = len(shaft.throws) - 1
    if n_gaps == 0:
        return [ZERO]
    if shaft.spacing is None:
        return None
    gaps = [gap.array for gap in shaft.spacing]
    return list(accumulate(gaps * n_gaps if len(gaps) == 1 else gaps, initial=ZERO))
