"""Which mechanisms of a machine hang on which, and which of them drive its pistons."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from cranktrain.layout.places import PlacedMechanism
from cranktrain.record import record

MASTER = "slider_crank"
"""Kind of what slaves hang on."""


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

    master: NDArray[np.intp]
    piston: NDArray[np.intp]

    @property
    def driven(self) -> NDArray[np.intp]:
        """Which mechanism drives each piston, shape (piston,)."""
        found = np.flatnonzero(self.piston >= 0)
        return found[np.argsort(self.piston[found])]


def carriers_of(places: Sequence[PlacedMechanism]) -> Carriers:
    """Find every slave's master: the slider-crank of the bank that it names, on the same throw."""
    master: list[int] = []
    pistons = 0
    piston: list[int] = []
    for place in places:
        bank = getattr(place.spec, "master", None)
        master.append(
            next(
                (
                    i
                    for i, other in enumerate(places)
                    if other.bank == bank
                    and (other.shaft, other.throw) == (place.shaft, place.throw)
                    and other.kind.name == MASTER
                ),
                -1,
            )
            if bank is not None
            else -1
        )
        is_piston = place.kind.output == "slider"
        piston.append(pistons if is_piston else -1)
        pistons += is_piston
    return Carriers(np.array(master, dtype=np.intp), np.array(piston, dtype=np.intp))
