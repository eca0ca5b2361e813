"""A slave on an articulated rod: its numbers beside its master's, and what its dead centres are to be, as equations.

Every requirement but an unshifted dead centre is linear in the distances H, h of the two dead centres from the shaft.
"""

from collections.abc import Iterator
from math import pi
from typing import Literal, NamedTuple

from cranktrain.language import Words, _
from cranktrain.mechanisms.articulated_rod import ArticulatedRod
from cranktrain.mechanisms.slider_crank import SliderCrank
from cranktrain.motion import Array
from cranktrain.synthesis.knuckle_equations import slave_dead_centres, stroke_product
from cranktrain.synthesis.proposal import Number, ProposedTable, wanted, wanted_ratio
from cranktrain.synthesis.slider_crank_lengths import Lengths, stroke_of


def slave_numbers(rod: ArticulatedRod, master_ratio: float | None) -> tuple[Number, ...]:
    """Numbers of one slave; its compression ratio with the master's deck and chamber, where the master's is given.

    Parameters
    ----------
    rod : ArticulatedRod
        Of single numbers.
    master_ratio : float or None

    Returns
    -------
    tuple of Number
    """
    at = slave_dead_centres(rod)
    stroke, top = float(at.top - at.bottom), float(at.top)
    higher = top - _master_top(rod.master)
    ratio = ()
    if master_ratio is not None:
        clearance = _master_stroke(rod.master) / (master_ratio - 1) - higher
        ratio = (Number("compression_ratio", "ε", 1 + stroke / clearance, "1", _("Compression ratio")),)
    return (
        Number("knuckle_radius", "r", float(rod.knuckle_radius), "mm", _("Knuckle radius")),
        Number("articulation_angle", "ζ", float(rod.articulation_angle), "deg", _("Articulation angle")),
        Number("rod_length", "l", float(rod.rod_length), "mm", _("Articulated rod")),
        Number("stroke", "S", stroke, "mm", _("Stroke of the slave")),
        Number("top_shift", "ε_T", float(at.top_angle - rod.bank_angle), "deg", _("Shift of the top dead centre")),
        Number(
            "bottom_shift",
            "ε_B",
            float(at.bottom_angle - rod.bank_angle) - pi,
            "deg",
            _("Shift of the bottom dead centre"),
        ),
        Number("top_distance", "H", top, "mm", _("Piston pin from the shaft at the top")),
        Number("height_over_master", "H − H_m", higher, "mm", _("Piston pin above the master's at the top")),
        Number("stroke_product", "r(1 + r/l) sin ψ", float(stroke_product(rod)), "mm", _("What the stroke fixes")),
        *ratio,
    )


def cylinder_table(ratio: float | None, bore: float | None) -> tuple[ProposedTable, ...]:
    """Write the cylinders' table: the bore and the master's compression ratio, where there is either."""
    keys: dict[str, Words] = {} if bore is None else {"bore": wanted(bore, "mm")}
    if ratio is not None:
        keys["compression_ratio"] = wanted_ratio(ratio)
    return (ProposedTable("cylinder", keys),) if keys else ()


def _master_top(master: SliderCrank) -> float:
    """Distance of the master's piston pin from the shaft at its top. [m]"""
    reach = float(master.crank_radius + master.rod_length)
    return float((reach**2 - master.offset**2) ** 0.5)


def _master_stroke(master: SliderCrank) -> float:
    """Stroke of the master. [m]"""
    return stroke_of(Lengths(float(master.crank_radius), float(master.rod_length), float(master.offset)))


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
        yield Goal(1.0, 0.0, _master_top(master))
    if requirements.same_ratio is not None:
        over_clearance = requirements.same_ratio - 1
        clearance = _master_stroke(master) / over_clearance
        yield Goal(requirements.same_ratio, -1.0, over_clearance * (clearance + _master_top(master)))
