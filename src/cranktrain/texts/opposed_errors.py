"""Largest errors of (I.11) and (I.12) of [bolotin], of each piston and of both together."""

from typing import NamedTuple

import numpy as np

from cranktrain.layout.specs import ENDS
from cranktrain.mechanisms.slider_crank import SliderCrank
from cranktrain.motion import Array, Coefficient
from cranktrain.texts.largest_errors import LargestErrors, from_bottom, from_top, largest_errors
from cranktrain.texts.opposed import OpposedMotion, OpposedSize, opposed_pistons


class OpposedPair(NamedTuple):
    """Two slider-cranks that share a cylinder; numbers.

    Attributes
    ----------
    exhaust, scavenge : SliderCrank
    lead : float
        By how much the exhaust crank is ahead of the scavenge crank, each from its own inner dead centre. [rad]
    far : "exhaust", "scavenge" or ""
        Which piston bounds the cylinder from its far side, on side rods of a shaft that both share; on two none.
    """

    exhaust: SliderCrank
    scavenge: SliderCrank
    lead: float
    far: str = ""

    @property
    def size(self) -> OpposedSize:
        """What (I.11) and (I.12) need."""
        exhaust, scavenge = self._ratios
        return OpposedSize(
            self.exhaust.crank_radius,
            -exhaust if self.far == "exhaust" else exhaust,
            self.scavenge.crank_radius,
            -scavenge if self.far == "scavenge" else scavenge,
            np.array(self.lead),
        )

    @property
    def size_as_printed(self) -> OpposedSize:
        """The same with the plus signs that the source prints, of pistons that each face their own shaft."""
        exhaust, scavenge = self._ratios
        return self.size._replace(exhaust_ratio=exhaust, scavenge_ratio=scavenge)

    @property
    def _ratios(self) -> tuple[Array, Array]:
        """λ of each."""
        return (
            self.exhaust.crank_radius / self.exhaust.rod_length,
            self.scavenge.crank_radius / self.scavenge.rod_length,
        )

    @property
    def is_central(self) -> bool:
        """Whether both lines of stroke go through the shafts' centres, as the formulas have it."""
        return bool(self.exhaust.offset == self.scavenge.offset == 0.0)

    @property
    def is_alike(self) -> bool:
        """Whether both mechanisms are equal and stand alike, so that the source's dead centres are exact."""
        return self.exhaust[:2] == self.scavenge[:2] and self.is_central and not self.far


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
        Angle α of the exhaust crank from where it lies along its cylinder, its piston innermost. [rad]
    pair : OpposedPair

    Returns
    -------
    OpposedMotion, of the shape of `angle`
    """
    exhaust, scavenge = (
        (from_bottom if pair.far == end else from_top)(getattr(pair, end))(own)
        for end, own in zip(ENDS, (angle, angle - pair.lead), strict=True)
    )
    combined = Coefficient(*(one + other for one, other in zip(exhaust, scavenge, strict=True)))
    return OpposedMotion(exhaust, scavenge, combined)


def opposed_errors(pair: OpposedPair, *, as_printed: bool = False) -> OpposedErrors:
    """Largest errors of (I.11), (I.12) and of their sum, by the exhaust crank's angle.

    Parameters
    ----------
    pair : OpposedPair
    as_printed : bool
        With the plus signs of the source for a far piston, too.

    Returns
    -------
    OpposedErrors
        Displacement in parts of each exact stroke, of both together of the combined stroke.
    """
    size = pair.size_as_printed if as_printed else pair.size
    return OpposedErrors(
        *(
            largest_errors(
                lambda angle, part=part: opposed_pistons(angle, size)[part],
                lambda angle, part=part: exact_pair(angle, pair)[part],
            )
            for part in range(3)
        )
    )
