"""Largest errors of (I.11) and (I.12) of [bolotin], of each piston and of both together."""

from typing import NamedTuple

import numpy as np

from cranktrain.mechanisms.slider_crank import SliderCrank
from cranktrain.motion import Array, Coefficient
from cranktrain.texts.largest_errors import LargestErrors, from_top, largest_errors
from cranktrain.texts.opposed import OpposedMotion, OpposedSize, opposed_pistons


class OpposedPair(NamedTuple):
    """Two slider-cranks that share a cylinder, and by how much the exhaust crank leads [rad]; numbers."""

    exhaust: SliderCrank
    scavenge: SliderCrank
    lead: float

    @property
    def size(self) -> OpposedSize:
        """What (I.11) and (I.12) need."""
        exhaust, scavenge = self.exhaust, self.scavenge
        return OpposedSize(
            exhaust.crank_radius,
            exhaust.crank_radius / exhaust.rod_length,
            scavenge.crank_radius,
            scavenge.crank_radius / scavenge.rod_length,
            np.array(self.lead),
        )

    @property
    def is_alike(self) -> bool:
        """Whether cranks and rods are equal, so that the source's dead centres are exact."""
        return self.exhaust[:2] == self.scavenge[:2] and self.exhaust.offset == self.scavenge.offset == 0.0


class OpposedErrors(NamedTuple):
    """Largest errors of the exhaust piston, of the scavenge piston, and of both together."""

    exhaust: LargestErrors
    scavenge: LargestErrors
    combined: LargestErrors


def exact_pair(angle: Array, pair: OpposedPair) -> OpposedMotion:
    """Exact motion of opposed pistons, each from its own inner dead centre.

    Parameters
    ----------
    angle : Array
        Angle α of the exhaust crank from where it points along its cylinder. [rad]
    pair : OpposedPair

    Returns
    -------
    OpposedMotion, of the shape of `angle`
    """
    exhaust, scavenge = from_top(pair.exhaust)(angle), from_top(pair.scavenge)(angle - pair.lead)
    combined = Coefficient(*(one + other for one, other in zip(exhaust, scavenge, strict=True)))
    return OpposedMotion(exhaust, scavenge, combined)


def opposed_errors(pair: OpposedPair) -> OpposedErrors:
    """Largest errors of (I.11), (I.12) and of their sum, by the exhaust crank's angle.

    Parameters
    ----------
    pair : OpposedPair

    Returns
    -------
    OpposedErrors
        Displacement in parts of each exact stroke, of both together of the combined stroke.
    """
    return OpposedErrors(
        *(
            largest_errors(
                lambda angle, part=part: opposed_pistons(angle, pair.size)[part],
                lambda angle, part=part: exact_pair(angle, pair)[part],
            )
            for part in range(3)
        )
    )
