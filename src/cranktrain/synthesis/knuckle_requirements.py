"""What a slave on an articulated rod is to have, as equations of its dead centres.

Every requirement but an unshifted dead centre is linear in the distances H, h of the two dead centres from the shaft.
"""

from collections.abc import Iterator
from typing import Literal, NamedTuple

from cranktrain.mechanisms.slider_crank import SliderCrank
from cranktrain.motion import Array
from cranktrain.synthesis.knuckle_numbers import master_stroke, master_top


class KnuckleRequirements(NamedTuple):
    """What a slave is to have; None and False: no matter.

    stroke [m]; unshifted: the dead centre that must stay where the crank points along the cylinder; same_height: piston
    pin as high at the top as the master's; same_ratio: the master's compression ratio, which the slave must have too.
    """

    stroke: float | None = None
    unshifted: Literal["top", "bottom"] | None = None
    same_height: bool = False
    same_ratio: float | None = None

    @property
    def decided(self) -> int:
        """How many dimensions they decide."""
        return sum([self.stroke is not None, self.unshifted is not None, self.same_height, self.same_ratio is not None])


class Goal(NamedTuple):
    """A requirement as an equation of the distances H and h: `of_top`·H + `of_bottom`·h = `target`. [m]"""

    of_top: float
    of_bottom: float
    target: float

    def of(self, top: Array, bottom: Array) -> Array:
        """What a goal makes of two dead centres, or of their slopes."""
        return self.of_top * top + self.of_bottom * bottom


def goals_of(requirements: KnuckleRequirements, master: SliderCrank) -> Iterator[Goal]:
    """The requirements as equations, the stroke first: it varies most with what is chosen first.

    Parameters
    ----------
    requirements : KnuckleRequirements
    master : SliderCrank
        Of single numbers.

    Yields
    ------
    Goal
        Stroke H − h = S; height H = H_m; compression ratio with the master's deck and chamber,
        H − h = (ε − 1)(c_m + H_m − H), where its ε sets the clearance c_m = S_m/(ε − 1).
    """
    if requirements.stroke is not None:
        yield Goal(1.0, -1.0, requirements.stroke)
    if requirements.same_height:
        yield Goal(1.0, 0.0, master_top(master))
    if requirements.same_ratio is not None:
        over_clearance = requirements.same_ratio - 1
        clearance = master_stroke(master) / over_clearance
        yield Goal(requirements.same_ratio, -1.0, over_clearance * (clearance + master_top(master)))
