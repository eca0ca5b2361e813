"""What sliders are: pistons with a cylinder about them, valves, or neither, as a ram."""

from typing import Final

import numpy as np
from numpy.typing import NDArray

from cranktrain.layout.mechanisms import Pistons
from cranktrain.record import record

PISTON: Final = 0
SLIDER: Final = 1
VALVE: Final = 2


@record
class InCylinders:
    """Says that the machine's sliders that can have a cylinder have one; without it there are none."""


def sorts_of(pistons: Pistons, cylinders: InCylinders | None) -> NDArray[np.intp]:
    """What each slider is, shape (piston,)."""
    return np.where(pistons.is_valve, VALVE, SLIDER if cylinders is None else PISTON)
