"""Synthesis of a slider-crank from stroke and pressure angle as [slider-crank-synthesis] has it, each wrong step named.

The source's one example: stroke 0.16 m, mean slider speed 6.3 m/s, permissible pressure angle 30°. What is right, and
why: docs/theory/synthesis.
"""

from math import asin, cos, nan, pi, sin, sqrt, tan
from typing import NamedTuple

import numpy as np

from cranktrain.language import N_
from cranktrain.motion import Array, single
from cranktrain.texts.steam_engine import two_harmonics
from cranktrain.texts.wrong_step import WrongStep


class SliderCrankRequirements(NamedTuple):
    """What the source starts from: stroke [m], mean slider speed [m/s], permissible pressure angle [rad]."""

    stroke: float
    mean_speed: float
    pressure_angle: float


class VelocityTable(NamedTuple):
    """The source's table of slider velocities [m/s] at crank angles [rad], and the same columns with its own numbers.

    approximate: by its formula, v = rω(sin φ + (r/2l) sin 2φ), with its rounded rω and r/2l; exact: by its r, l, ω.
    """

    angle: Array
    printed: Array
    approximate: Array
    exact: Array


REQUIREMENTS = SliderCrankRequirements(stroke=0.16, mean_speed=6.3, pressure_angle=pi / 6)
CRANK_RADIUS = 0.08
ROD_LENGTH = 0.27
"""After r/tan 30°, with 0.3 for the tangent. [m]"""
SPEED = 125.6
"""2·3.14/0.05, from the period rounded to 0.05 s. [rad/s]"""
PIN_SPEED = 10.048
"""rω [m/s]"""
HALF_RATIO = 0.15
"""r/2l [1]"""
PRINTED_VELOCITY = (0.0, 6.3, 9.99, 10.048, 7.4, 3.7, 0.0, -3.7, -7.4, -10.048, -9.99, -6.3)
"""At 0, 30, … 330°. [m/s]"""


def rod_by_tangent(crank_radius: float, pressure_angle: float) -> float:
    """Rod by the source's rule l = r/tan[α], which takes the pressure angle where crank and rod stand square.

    Parameters
    ----------
    crank_radius : float
        r [m]
    pressure_angle : float
        [α], permissible. [rad]

    Returns
    -------
    float
        l [m]; the largest pressure angle of this rod, at 90°, is asin(tan[α]) > [α].

    Examples
    --------
    >>> round(rod_by_tangent(0.08, REQUIREMENTS.pressure_angle), 4)
    0.1386
    """
    return crank_radius / tan(pressure_angle)


def largest_pressure_angle(crank_radius: float, rod_length: float) -> float:
    """Largest pressure angle of a central slider-crank, asin(r/l) at φ = 90°; NaN where the crank cannot turn. [rad]

    Parameters
    ----------
    crank_radius, rod_length : float
        [m]

    Returns
    -------
    float
    """
    return asin(crank_radius / rod_length) if crank_radius < rod_length else nan


def velocity_table() -> VelocityTable:
    """Give the source's table of velocities beside the same columns without its slips.

    Returns
    -------
    VelocityTable, shape (12,)
    """
    angle = np.arange(12, dtype=np.float64) * (pi / 6)
    return VelocityTable(
        angle=angle,
        printed=np.array(PRINTED_VELOCITY),
        approximate=two_harmonics(angle, single(PIN_SPEED), single(2 * HALF_RATIO)).first,
        exact=exact_velocity(angle, CRANK_RADIUS, ROD_LENGTH, SPEED),
    )


def exact_velocity(angle: Array, crank_radius: float, rod_length: float, speed: float) -> Array:
    """Velocity of a central slider toward the shaft, ωr sin φ (1 + r cos φ/√(l² − r² sin²φ)).

    Parameters
    ----------
    angle : Array
        φ [rad]
    crank_radius, rod_length : float
        r, l [m]
    speed : float
        ω [rad/s]

    Returns
    -------
    Array, of the shape of `angle`
        [m/s]

    Examples
    --------
    >>> round(float(exact_velocity(np.array(pi / 3), 0.08, 0.27, 125.6)), 3)
    10.036
    """
    sine = crank_radius * np.sin(angle)
    along = np.sqrt(rod_length**2 - sine**2)
    return speed * sine * (1 + crank_radius * np.cos(angle) / along)


def wrong_steps() -> tuple[WrongStep, ...]:
    """Name every wrong step of the source, in its order.

    Returns
    -------
    tuple of WrongStep
        A right number follows from the requirements alone, or, where the step only uses an earlier one, from the
        source's own earlier numbers.
    """
    limit = REQUIREMENTS.pressure_angle
    radius = REQUIREMENTS.stroke / 2
    table = velocity_table()
    period = 2 * REQUIREMENTS.stroke / REQUIREMENTS.mean_speed
    at_60 = pi / 3
    return (
        WrongStep(
            N_("rod from the permissible pressure angle"),
            "l = r/tg [α]",
            rod_by_tangent(radius, limit),
            radius / sin(limit),
            "m",
            N_("the pressure angle is largest at 90°, sin α = r/l, not where crank and rod stand square, at 60°"),
        ),
        WrongStep(
            N_("largest pressure angle of the rod r/tan[α]"),
            "[α] = 30°",
            largest_pressure_angle(radius, rod_by_tangent(radius, limit)),
            limit,
            "rad",
            N_("the rod is too short by r/sin[α] − r/tan[α]: its pressure angle is over the limit"),
        ),
        WrongStep(
            N_("tangent of 30°"),
            "0,08/tg 30° = 0,08/0,3",
            0.3,
            tan(limit),
            "1",
            N_("tan 30° is 0.577; the rod becomes 0.27 m, with a largest pressure angle of 17.2°"),
        ),
        WrongStep(
            N_("largest pressure angle of the rod that it goes on with"),
            "l ≈ 0,27 м",
            largest_pressure_angle(CRANK_RADIUS, ROD_LENGTH),
            limit,
            "rad",
            N_(
                "the tangent makes the rod 0.866 times as long as the limit needs and 0.3 for tan 30° makes that 1.925 "
                "times as long: together 1.667 times, 1.69 as rounded"
            ),
        ),
        WrongStep(
            N_("pressure angle in the plans at φ = [α] and 180° + [α]"),
            "φ₁, равном [α] и 180° + [α]",
            asin(CRANK_RADIUS * sin(limit) / ROD_LENGTH),
            largest_pressure_angle(CRANK_RADIUS, ROD_LENGTH),
            "rad",
            N_(
                "the text says that the limit is reached at 60°, and draws 30° and 210° beside the dead centres and "
                "the middle; the largest angle of its rod stands at 90° and 270°"
            ),
        ),
        WrongStep(
            N_("period of a turn"),
            "Tц = 2S/v ≈ 0,05 с",
            0.05,
            period,
            "s",
            N_("rounded by 1.6 %, which goes into the speed and every velocity"),
        ),
        WrongStep(
            N_("angular speed of the crank"),
            "ω ≈ 125,6 1/с",
            SPEED,
            2 * pi / period,
            "rad/s",
            N_("from the rounded period"),
        ),
        WrongStep(
            N_("position of the slider, at 60°"),
            "x = r cos φ + [l² − (r sin φ)²]",
            CRANK_RADIUS * cos(at_60) + ROD_LENGTH**2 - (CRANK_RADIUS * sin(at_60)) ** 2,
            CRANK_RADIUS * cos(at_60) + sqrt(ROD_LENGTH**2 - (CRANK_RADIUS * sin(at_60)) ** 2),
            "m",
            N_("the root over the bracket is lost: a length and an area are added"),
        ),
        WrongStep(
            N_("velocity of the slider, at 60°"),
            "v = rω[φ + (r/2l) sin 2φ]",
            PIN_SPEED * (at_60 + HALF_RATIO * sin(2 * at_60)),
            float(table.approximate[2]),
            "m/s",
            N_("φ is printed for sin φ; the table is computed with sin φ"),
        ),
        WrongStep(
            N_("half the ratio of crank and rod, r/2l"),
            "r/2l ≈ 0,15",
            HALF_RATIO,
            CRANK_RADIUS / (2 * ROD_LENGTH),
            "1",
            N_("0.08/0.54 is 0.148; with it the second harmonic is 1.2 % smaller"),
        ),
        WrongStep(
            N_("sign of the velocity, at 90°"),
            "v = 10,048 м/с",
            PRINTED_VELOCITY[3],
            -float(table.exact[3]),
            "m/s",
            N_("x is the distance from the shaft and falls there: the printed v is −dx/dt"),
        ),
        WrongStep(
            N_("velocity at 60°"),
            "v = 9,99 м/с",
            PRINTED_VELOCITY[2],
            float(table.approximate[2]),
            "m/s",
            N_("arithmetic: with its own rω and r/2l it is 10.01 m/s; exact, with its rod, 10.04 m/s"),
        ),
        WrongStep(N_("sin 2φ at 150°"), "0,9", 0.9, sin(2 * 5 * pi / 6), "1", N_("sin 300° is negative")),
        WrongStep(
            N_("the bracket sin φ + (r/2l) sin 2φ at 150°"),
            "−0,4",
            -0.4,
            float(table.approximate[5]) / PIN_SPEED,
            "1",
            N_("it is positive; the velocity 3.7 m/s beside it has the right sign"),
        ),
        WrongStep(N_("sin 2φ at 210°"), "−0,9", -0.9, sin(2 * 7 * pi / 6), "1", N_("sin 420° is positive")),
        WrongStep(
            N_("velocity at 300°"),
            "v = −9,99 м/с",
            PRINTED_VELOCITY[10],
            float(table.approximate[10]),
            "m/s",
            N_("the slip of 60° again: both are 10.01 m/s with its own numbers"),
        ),
    )
