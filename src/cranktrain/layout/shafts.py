"""Shafts: which mechanism works on which throw of which shaft, and the journals between the throws."""

from collections.abc import Mapping, Sequence
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from cranktrain.layout.places import PlacedMechanism
from cranktrain.layout.specs import MAIN, ShaftSpec
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
