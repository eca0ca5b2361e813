"""What valve gears have in common: how steam is admitted, the notch of the reverser, where an eccentric is set."""

from math import pi
from typing import Annotated, Literal, TypeAlias

from cranktrain.motion import Array
from cranktrain.quantities import Dimension, Given, Quantity

Admission: TypeAlias = Literal["outside", "inside"]
"""Whether steam comes in past the valve's outer edges or its inner ones."""

Notch: TypeAlias = Annotated[Given, Quantity(Dimension.RATIO, at_least=-1.0, at_most=1.0)]
"""Position of the reverser: +1 full gear ahead, 0 mid gear, −1 full gear astern."""


def set_ahead(angle_of_advance: Array, admission: Admission) -> Array:
    """How far ahead of the crank an eccentric for running ahead stands; docs/theory/eccentric, eq. (20.2). [rad]"""
    return angle_of_advance + (pi / 2 if admission == "outside" else -pi / 2)
