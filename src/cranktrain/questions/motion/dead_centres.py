"""Dead centres: where each piston truly turns back, and its stroke; roots of s′, not points of a grid."""

from typing import NamedTuple

import numpy as np

from cranktrain.language import N_
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.mechanisms import Distinct, Mechanisms, Pistons, distinct
from cranktrain.mechanisms.kind import AnyMotion
from cranktrain.mechanisms.output import OutputPart
from cranktrain.motion import Array, Coefficient, Link
from cranktrain.numerics import Extreme, Extremes, around_zero, extremes, slower_over_faster, turn_grid
from cranktrain.questions.motion.grid_motion import GridMotion
from cranktrain.questions.motion.outputs import InCylinders, outputs_of
from cranktrain.record import record
from cranktrain.references import THEORY_OF_SLIDER_CRANKS as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import Flagged, Limit, flagged

_PISTON = ("piston",)
ANGLE_ROUNDING = 1e-12
"""Sums of a few angles differ by less. [rad]"""


class SliderAndRod(NamedTuple):
    """Slider position along its own axis, and rod angle, shape (design, piston, n); NaN for a rod that there is not."""

    slider: Coefficient
    rod: Coefficient


def slider_and_rod(pistons: Mechanisms, angle: Array) -> SliderAndRod:
    """Every piston's slider and rod.

    Parameters
    ----------
    pistons : Mechanisms
        All of which drive sliders.
    angle : Array, shape (n,), (design, 1, n) or (design, piston, n)
        φ. [rad]

    Returns
    -------
    SliderAndRod, shape (design, piston, n). [m, m/rad, m/rad²; rad, rad/rad, rad/rad²]
    """
    return pistons.evaluated(_picked, angle)


def _picked(motion: AnyMotion) -> SliderAndRod:
    """Slider and rod of mechanisms of one kind."""
    return SliderAndRod(motion.slider, rod_angle(motion, motion.slider))


def rod_angle(motion: AnyMotion, output: Coefficient) -> Coefficient:
    """Angle of the rod that the output hangs on; NaN, as many as the output has, where there is none."""
    rod: Link | None = getattr(motion, "rod", None)
    return Coefficient(*(np.full_like(part, np.nan) for part in output)) if rod is None else rod.angle


def slider_motion(pistons: Mechanisms, angle: Array) -> Coefficient:
    """Distance of every piston pin from its shaft along its own axis; parameters as of `slider_and_rod`. [m, …]"""
    return pistons.evaluated(lambda motion: motion.slider, angle)


@record
class PistonTurn:
    """One turn of the pistons that are distinct, whatever the machine's own grid: where extremes are looked for first.

    Attributes
    ----------
    distinct : Distinct
    samples : SliderAndRod, shape (1, distinct, 720)
        On `turn_grid()`, at each piston's own crank angle.
    peaks : Extremes, shapes (3, 1, distinct, 1)
        Of the slider's position and of its two derivatives.
    """

    distinct: Distinct
    samples: SliderAndRod
    peaks: Extremes


def piston_turn(pistons: Pistons) -> PistonTurn:
    """Find the distinct pistons and sample their turn."""
    different = distinct(pistons)
    samples = slider_and_rod(different.mechanisms, turn_grid())

    def slider(angle: Array) -> list[Array]:
        """Position, its derivatives, and NaN for the third one, each at angles of its own, (1, distinct, k)."""
        apart = np.moveaxis(angle, 0, -2)
        motion = slider_motion(different.mechanisms, apart.reshape(*apart.shape[:2], -1))
        return [part.reshape(apart.shape) for part in (*motion, np.full_like(motion.value, np.nan))]

    def coordinate(angle: Array) -> Array:
        return np.stack([part[..., order, :] for order, part in enumerate(slider(angle)[:3])])

    def slope(angle: Array) -> Array:
        return np.stack([part[..., order, :] for order, part in enumerate(slider(angle)[1:])])

    return PistonTurn(different, samples, extremes(coordinate, slope, samples=np.stack(samples.slider)))


@record
class PistonGrid:
    """Slider and rod of every piston on the grid of crank angles, shape (design, piston, n)."""

    value: SliderAndRod


def piston_grid(pistons: Pistons, motion: GridMotion) -> PistonGrid:
    """Pick what moves pistons from the motion of all mechanisms."""
    return PistonGrid(motion.of(pistons, _picked))


# The position has 16 digits, and its part that moves so many fewer. Rods that stand for none are given 10⁴ cranks.
_DISTANCE = Limit(
    1e5,
    "",
    N_(
        "A slider's stroke is {value} of its distance from the shaft: its curves lose as many digits as that has zeros."
    ),
)


@record
class DeadCentres(Flagged):
    """Where each piston truly turns back, and how far it travels; outputs: what each is."""

    outputs: tuple[OutputPart, ...]
    stroke: Array = quantity(
        "S",
        "m",
        _PISTON,
        N_("Stroke, between the true dead centres"),
        _THEORY,
        "2.7",
        line="{top_position} − {bottom_position}",
    )
    top_dead_centre: Array = quantity(
        "φ_T", "deg", _PISTON, N_("Crank angle of the true top dead centre"), _THEORY, "2.6", is_place=True
    )
    bottom_dead_centre: Array = quantity(
        "φ_B", "deg", _PISTON, N_("Crank angle of the true bottom dead centre"), _THEORY, "2.6", is_place=True
    )
    top_shift: Array = quantity(
        "ε_T", "deg", _PISTON, N_("Top dead centre after the crank points along the cylinder"), _THEORY, "2.6"
    )
    bottom_shift: Array = quantity(
        "ε_B", "deg", _PISTON, N_("Bottom dead centre after the crank points away from the cylinder"), _THEORY, "2.6"
    )
    top_position: Array = quantity(
        "H", "m", _PISTON, N_("Distance from shaft centre to piston pin at top dead centre"), _THEORY, "2.7"
    )
    bottom_position: Array = quantity(
        "h", "m", _PISTON, N_("Distance from shaft centre to piston pin at bottom dead centre"), _THEORY, "2.7"
    )
    stroke_time_ratio: Array = quantity(
        "k", "1", _PISTON, N_("Crank travel of the slower stroke over that of the faster one"), _THEORY, "2.8"
    )


def dead_centres(
    pistons: Pistons, turn: PistonTurn, crank_angle: CrankAngle, cylinders: InCylinders | None
) -> DeadCentres:
    """True dead centres of every piston, roots of s′; docs/theory/slider-crank, eqs. (2.6) to (2.8)."""
    different = turn.distinct
    bottom, top = (Extreme(different.spread(one.angle[0]), different.spread(one.value[0])) for one in turn.peaks)
    return dead_centres_at(top, bottom, pistons, crank_angle, cylinders)


def dead_centres_at(
    top: Extreme, bottom: Extreme, pistons: Pistons, crank_angle: CrankAngle, cylinders: InCylinders | None
) -> DeadCentres:
    """Tell dead centres by where pistons are farthest from the shaft and nearest to it.

    Parameters
    ----------
    top, bottom : Extreme, shapes (design, piston, 1)
        Angle of each piston's own crank from its axis, and distance of its pin from the shaft. [rad, m]
    pistons : Pistons
    crank_angle : CrankAngle
    cylinders : InCylinders or None
    """
    stroke, position = (top.value - bottom.value)[..., 0], top.value[..., 0]
    return DeadCentres(
        outputs=outputs_of(pistons, cylinders),
        stroke=stroke,
        top_dead_centre=crank_angle.counted(top.angle + pistons.nominal_top)[..., 0],
        bottom_dead_centre=crank_angle.counted(bottom.angle + pistons.nominal_top)[..., 0],
        top_shift=around_zero(top.angle)[..., 0],
        bottom_shift=around_zero(bottom.angle - np.pi)[..., 0],
        top_position=position,
        bottom_position=bottom.value[..., 0],
        stroke_time_ratio=slower_over_faster(bottom.angle - top.angle)[..., 0],
        unlikely=tuple(flagged(_DISTANCE, np.abs(position) / stroke, stroke / np.abs(position))),
    )
