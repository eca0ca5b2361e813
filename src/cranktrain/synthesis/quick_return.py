"""Quick returns: time ratio from geometry and geometry from time ratio, in closed form; docs/theory/synthesis."""

from collections.abc import Iterator
from math import asin, cos, pi, sin, tan
from typing import Annotated

import numpy as np

from cranktrain.errors import InputError, Problem, refuse
from cranktrain.language import N_, _
from cranktrain.motion import Array
from cranktrain.numerics import bracketed_roots
from cranktrain.saying.wording import as_limit, number
from cranktrain.synthesis.four_bars import excess_angle, time_ratio_of
from cranktrain.synthesis.proposal import (
    Alternative,
    Length,
    Number,
    Proposal,
    ProposedTable,
    Speed,
    TimeRatio,
    found,
    not_positive,
    plain,
    shaft_table,
    wanted,
)
from cranktrain.synthesis.slider_crank import Stroke, slider_crank_numbers
from cranktrain.synthesis.slider_crank_lengths import Lengths


def slotted_time_ratio(share: float) -> float:
    """Time ratio of a slotted lever or of a Whitworth quick return, sin(ϑ/2) = share.

    Parameters
    ----------
    share : float
        Below 1. Of a lever that swings, crank radius over the distance of shaft and pivot, R/d; of Whitworth's link,
        which turns fully, (d/R) sin χ with d the distance of the two shafts and χ the angle from their line to the line
        of stroke, which passes through the slotted link's shaft.

    Returns
    -------
    float

    Examples
    --------
    >>> round(slotted_time_ratio(0.5), 12)
    2.0
    """
    return time_ratio_of(2 * asin(share))


def slotted_share(ratio: float) -> float:
    """R/d of the slotted lever of a time ratio k > 1, swinging by ϑ; d/R of a Whitworth drive with a square line."""
    return sin(excess_angle(ratio) / 2)


def offset_slider_crank(stroke: float, excess: float, parameter: float) -> Lengths:
    """Offset slider-crank of a stroke and an excess angle ϑ, one for each value of the free parameter.

    Parameters
    ----------
    stroke : float
        [m]
    excess : float
        ϑ, between 0 and π/2. [rad]
    parameter : float
        ξ, between ϑ/2 and (π − ϑ)/2. [rad]

    Returns
    -------
    Lengths

    Notes
    -----
    docs/theory/synthesis, eq. (8.20).
    """
    radius = stroke / 2 * cos(parameter) / cos(excess / 2)
    rod = stroke / 2 * sin(parameter) / sin(excess / 2)
    return Lengths(radius, rod, (rod - radius) * (rod + radius) * sin(excess) / stroke)


def least_pressure_parameter(excess: float) -> float:
    """Parameter ξ of the offset slider-crank whose largest pressure angle is least. [rad]

    Parameters
    ----------
    excess : float
        ϑ, between 0 and π/2. [rad]

    Returns
    -------
    float
        Root of the derivative of (R + e)/L, docs/theory/synthesis, eq. (8.22).
    """
    tangent, cosine = tan(excess / 2), cos(excess / 2)

    def slope(parameter: Array) -> Array:
        sine, ratio = np.sin(parameter), tangent / np.tan(parameter)
        ratio_first = -tangent / sine**2
        return ratio_first + cosine * ((1 - ratio**2) * np.cos(parameter) - 2 * ratio * ratio_first * sine)

    ends = np.array([excess / 2]), np.array([(pi - excess) / 2])
    return float(bracketed_roots(slope, *ends)[0])


def quick_return(
    stroke: Annotated[Length, N_("Between the dead centres.")],
    time_ratio: TimeRatio,
    *,
    rod_length: Annotated[Length | None, N_("That of the least pressure angle unless given.")] = None,
    slow_stroke: Annotated[Stroke, N_("From the shaft's point of view; toward unless given.")] = "toward",
    speed: Speed | None = None,
) -> Proposal:
    """Propose an offset slider-crank with a quick return; beside it a slotted lever and a Whitworth drive.

    Parameters
    ----------
    stroke : float
        [m]
    time_ratio : float
        Time of the slow stroke over that of the quick one, at constant speed; between 1 and 3.
    rod_length : float, optional
        That with which the largest pressure angle is least unless given. [m]
    slow_stroke : "toward" or "away"
        From the shaft's point of view.
    speed : float, optional
        [rad/s]

    Returns
    -------
    Proposal
        With the numbers of `slider_crank_from_stroke`; the working stroke is the slow one.

    Raises
    ------
    InputError
        If no offset slider-crank can do it, with what is possible.

    Examples
    --------
    >>> proposal = quick_return(0.3, 1.2)
    >>> round(proposal.value("time_ratio"), 12)
    1.2
    """
    refuse(_impossible(stroke, time_ratio, speed))
    excess = excess_angle(time_ratio)
    parameter = least_pressure_parameter(excess) if rod_length is None else _parameter_of(stroke, excess, rod_length)
    lengths = offset_slider_crank(stroke, excess, parameter)
    if slow_stroke == "away":
        lengths = lengths._replace(offset=-lengths.offset)
    how = _("stroke and time ratio")
    best = _("stroke, time ratio, least pressure angle")
    return Proposal(
        title=_(
            "Offset slider-crank of {stroke} stroke with a quick return, time ratio {ratio:.4g}",
            stroke=number(stroke, "mm"),
            ratio=time_ratio,
        ),
        numbers=slider_crank_numbers(lengths, slow_stroke, speed),
        alternatives=_alternatives(stroke, time_ratio),
        remarks=(
            _("The pressure angle grows fast with the time ratio; a slotted lever or a Whitworth drive does not mind."),
            _("A time ratio of 3 is the end: the slider would turn back where the rod stands across the guide."),
        ),
        tables=(
            *shaft_table(speed),
            ProposedTable(
                "mechanism",
                {
                    "kind": '"slider_crank"',
                    "crank_radius": found(lengths.crank_radius, "mm", how if rod_length else best),
                    "rod_length": wanted(rod_length, "mm") if rod_length else found(lengths.rod_length, "mm", best),
                    "offset": found(lengths.offset, "mm", how if rod_length else best),
                },
            ),
        ),
    )


def _impossible(stroke: float, ratio: float, speed: float | None) -> Iterator[Problem]:
    """Find requirements that contradict geometry."""
    yield from not_positive({"stroke": stroke})
    yield from not_positive({"speed": speed}, plain)
    if not 1 < ratio < 3:
        repair = None
        if ratio >= 3:
            repair = _(
                "a slotted lever can, with a crank of {share:.4f} of the distance between shaft and pivot",
                share=slotted_share(ratio),
            )
        allowed = _("must lie between 1 and 3 for an offset slider-crank")
        yield Problem("time_ratio", plain(ratio), allowed, repair)


def _parameter_of(stroke: float, excess: float, rod_length: float) -> float:
    """Parameter that gives a rod; refuse one for which there is none."""
    least, most = stroke / 2, stroke / 2 / tan(excess / 2)
    if not least < rod_length < most:
        allowed = _("must lie between {least} and {most} for this stroke and time ratio")
        allowed = allowed.format(least=as_limit(least), most=as_limit(most))
        raise InputError([Problem("rod_length", as_limit(rod_length), allowed)])
    return asin(2 * rod_length * sin(excess / 2) / stroke)


def _alternatives(stroke: float, ratio: float) -> tuple[Alternative, ...]:
    """Slotted lever and Whitworth drive of the same stroke and time ratio."""
    share = slotted_share(ratio)
    return (
        Alternative(
            _("slotted lever, its end moving the slider"),
            (
                Number("crank_to_distance", "R/d", share, "1", _("Crank radius over distance")),
                Number("swing", "γ", excess_angle(ratio), "deg", _("Swing of the lever")),
                Number("lever_length", "l", stroke / 2 / share, "mm", _("Lever from pivot to its end")),
            ),
        ),
        Alternative(
            _("Whitworth drive, line of stroke square to the line of the shafts"),
            (
                Number("distance_to_crank", "d/R", share, "1", _("Distance of shafts over crank radius")),
                Number("output_radius", "r", stroke / 2, "mm", _("Radius at which the slotted link drives the slider")),
            ),
        ),
    )
