"""Which mechanisms of a machine hang on which, and which of them drive its pistons."""

from collections.abc import Sequence
from functools import cached_property
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from cranktrain.layout.places import PlacedMechanism
from cranktrain.record import record


@record
class Carriers:
    """Which mechanisms hang on which, and which pistons they are.

    Attributes
    ----------
    master : array of int, shape (mechanism,)
        On whose rod a slave hangs; −1 for a mechanism on the crank itself.
    piston : array of int, shape (mechanism,)
        Which piston it drives; −1 for none.
    """

    reads: ClassVar[tuple[str, ...]] = ("[bank.NAME]",)

    master: NDArray[np.intp]
    piston: NDArray[np.intp]

    @cached_property
    def driven(self) -> NDArray[np.intp]:
        """Which mechanism drives each piston, shape (piston,)."""
        found = np.flatnonzero(self.piston >= 0)
        return found[np.argsort(self.piston[found])]


def carriers_of(places: Sequence[PlacedMechanism]) -> Carriers:
    """Find every slave's master: the slider-crank of the bank that it names, on the same throw."""
    masters: dict[tuple[str, int, str | None], int] = {
        (place.shaft, place.throw, place.bank): i
        for i, place in reversed(list(enumerate(places)))
        if place.kind.is_direct
    }
    named = [getattr(place.spec, "master", None) if place.kind.is_slave else None for place in places]
    master = [masters.get((place.shaft, place.throw, name), -1) for place, name in zip(places, named, strict=True)]
    is_piston = np.array([place.kind.output.is_slider for place in places])
    return Carriers(np.array(master, dtype=np.intp), np.where(is_piston, np.cumsum(is_piston) - 1, -1))
