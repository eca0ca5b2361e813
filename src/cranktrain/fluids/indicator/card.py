"""A card: what a file holds, and how it is to be put into a chamber, in SI."""

from typing import Any, Literal, NamedTuple

from cranktrain.fluids.indicator.diagram import Interpolation
from cranktrain.fluids.indicator.placing import Sense
from cranktrain.fluids.indicator.reading import Trace


class Peg(NamedTuple):
    """How the level of the pressures is found: one pressure [Pa] at an angle, or an exponent [1] between two. [rad]"""

    pressure: float | None
    angle: float
    exponent: float | None
    start: float
    end: float


class Card(NamedTuple):
    """An indicator card.

    Attributes
    ----------
    trace : Trace
        What the file holds.
    firing_angle : float, optional
        The file's angle of the firing dead centre. [rad]
    sense : "forward", "backward" or "found"
        Whether its angles count with the rotation.
    peg : Peg, optional
    smoothing : float, optional
        σ. [rad]
    interpolation : "limited" or "spline"
    unrolling : "exact" or "brix"
    """

    trace: Trace
    firing_angle: float | None
    sense: Sense
    peg: Peg | None
    smoothing: float | None
    interpolation: Interpolation
    unrolling: Literal["exact", "brix"]


class CardNumbers(NamedTuple):
    """What a machine file's table holds: the card of each design, shape (design,) or (design, 1, 1)."""

    card: Any
