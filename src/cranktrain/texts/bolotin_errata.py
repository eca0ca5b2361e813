"""What is wrong in Bolotin's text: half the lead, the larger stroke, constants that divide by zero."""

from math import pi, radians

import numpy as np

from cranktrain.language import N_
from cranktrain.mechanisms.articulated_rod import ArticulatedRod, articulated_rod
from cranktrain.mechanisms.slider_crank import SliderCrank
from cranktrain.motion import Array
from cranktrain.numerics import bracketed_roots, extremes
from cranktrain.texts.opposed_errors import OpposedPair, exact_pair
from cranktrain.texts.wrong_step import WrongStep

_R, _L, _KNUCKLE, _ROD, _BANK = 0.09, 0.32, 0.085, 0.235, radians(60.0)
"""Rods often quoted for 3Д12. [m, rad]"""
_QUOTED_ANGLE, _SMALL_ANGLE = radians(67.0), radians(55.0)
_PRINTED_STROKE = 186.7
"""[mm]"""
_LEAD = radians(12.0)


def bolotin_errata() -> tuple[WrongStep, ...]:
    """Name what is wrong in the source, in its order.

    Returns
    -------
    tuple of WrongStep
    """
    inner, outer = unequal_dead_centres()
    ratio = _KNUCKLE / _L
    second = _R / _ROD * (1 - 2 * ratio) + _R / _L * ratio * (1 + _KNUCKLE / _ROD)
    return (
        WrongStep(
            N_("inner volumetric dead centre"),
            "Δ/2",
            _LEAD / 2,
            inner,
            "rad",
            N_(
                "for λ = 0.20 of the exhaust and 0.30 of the scavenge rod, Δ = 12°; unlike rods are the usual case on "
                "the same page. Half the lead is exact where cranks and rods are equal"
            ),
        ),
        WrongStep(
            N_("outer volumetric dead centre"),
            "180° + Δ/2",
            pi + _LEAD / 2,
            outer,
            "rad",
            N_("as of the inner one, but to the other side"),
        ),
        WrongStep(
            N_("constant F of (I.13) where the cylinders stand in one direction"),
            "F = 2(r/L)(R/l) sin γ[…]/sin Θ",
            None,
            second,
            "1",
            N_(
                "for γ = 0 it divides 0 by 0, as sin Θ is 0 there, too; amplitude and phase come from both components. "
                "The number is that of R 90, L 320, r 85 and l 235 mm"
            ),
        ),
        WrongStep(
            N_("the slave's stroke, “larger than in the master's cylinder”"),
            "ход поршня в цилиндре с прицепным шатуном получается больше, чем в главном цилиндре",
            None,
            1e3 * _stroke(_SMALL_ANGLE),
            "mm",
            N_(
                "no law: with R 90, L 320, r 85, l 235 mm, γ 60° both strokes are 180 mm at ζ = 59.8°, and at 55° the "
                "slave's is this one, smaller"
            ),
        ),
        WrongStep(
            N_("stroke of the slaves of 3Д12"),
            "Sₗ = 186,7 мм",
            1e3 * _stroke(_QUOTED_ANGLE),
            _PRINTED_STROKE,
            "mm",
            N_(
                "the print is right, and the rods often quoted for it, r 85, l 235 mm, ζ 67°, are not: these give "
                "187.07 mm. The displacement of 38.88 L supports 186.7, and so does ζ = 66.63°, a fit: one stroke does "
                "not fix three sizes"
            ),
        ),
    )


def unequal_dead_centres() -> tuple[float, float]:
    """Exact volumetric dead centres of rods with λ = 0.20 (exhaust) and 0.30 (scavenge) and a lead of 12°. [rad]"""
    one, zero = np.array(1.0), np.array(0.0)
    pair = OpposedPair(SliderCrank(one, one / 0.2, zero), SliderCrank(one, one / 0.3, zero), _LEAD)

    def parting(angle: Array) -> Array:
        return exact_pair(angle, pair).combined.first

    low = np.array([0.0, pi])
    inner, outer = bracketed_roots(parting, low, low + _LEAD)
    return float(inner), float(outer)


def _stroke(articulation_angle: float) -> float:
    """Stroke of the slave with the rods often quoted, at some angle of articulation. [m]"""
    master = SliderCrank(np.array(_R), np.array(_L), np.array(0.0))
    rod = ArticulatedRod(master, *map(np.array, (_KNUCKLE, articulation_angle, _BANK, _ROD, 0.0)))
    low, high = extremes(lambda angle: articulated_rod(angle, rod).slider.value)
    return float(high.value[0] - low.value[0])
