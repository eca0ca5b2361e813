"""Crank-rocker from swing, time ratio and rocker length, with the best transmission angle; docs/theory/synthesis."""

from collections.abc import Iterator
from math import degrees, pi, sin
from typing import Annotated, Literal

import numpy as np

from cranktrain.errors import InputError, Problem, refuse
from cranktrain.language import N_, Words, _
from cranktrain.mechanisms.crank_rocker import CrankRocker
from cranktrain.mechanisms.crank_rocker.facts import CLASSES
from cranktrain.motion import single
from cranktrain.saying.wording import as_limit, number
from cranktrain.synthesis.four_bars import (
    FourBarRequirements,
    best_parameter,
    excess_angle,
    four_bar,
    judged,
    largest_time_ratio,
    rod_with_equal_swings,
    time_ratio_of,
    with_equal_swings,
)
from cranktrain.synthesis.proposal import (
    Alternative,
    Angle,
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

Swing = Literal["forward", "backward"]
"""Of the rocker: in the sense of the crank's rotation, or against it."""

_SIDES = {"forward": -1, "backward": 1}
"""On which side of the chord the shaft must lie for the slow swing to be in that sense; eq. (8.11)."""

_SHOWN = 7
_EQUAL = 1e-9
"""Below this excess angle the slow and the quick swing are the same: the rod becomes free. [rad]"""


def crank_rocker_from_swing(
    swing: Annotated[Angle, N_("Of the rocker.")],
    time_ratio: TimeRatio,
    rocker_length: Length,
    *,
    transmission_angle: Annotated[Angle | None, N_("Least that is permitted.")] = None,
    rod_length: Annotated[Length | None, N_("With a time ratio of 1 only.")] = None,
    slow_swing: Annotated[Swing, N_("In the sense of the crank's rotation, or against it; forward.")] = "forward",
    speed: Speed | None = None,
) -> Proposal:
    """Propose the crank-rocker whose smallest transmission angle is the largest.

    Parameters
    ----------
    swing : float
        Of the rocker, between 0 and π. [rad]
    time_ratio : float
        Time of the slow swing over that of the quick one, at constant speed; at least 1.
    rocker_length : float
        [m]
    transmission_angle : float, optional
        Least that is permitted. With a time ratio of 1, where the rod is free, it is met exactly. [rad]
    rod_length : float, optional
        For a time ratio of 1 only. [m]
    slow_swing : "forward" or "backward"
        In which sense the rocker swings slowly; forward is the better drive.
    speed : float, optional
        [rad/s]

    Returns
    -------
    Proposal
        With the numbers `crank_radius`, `rod_length`, `rocker_length`, `ground_length`, `transmission_angle`, `swing`,
        `time_ratio`, `parameter`; alternatives over the range of the free parameter on both sides.

    Raises
    ------
    InputError
        If no crank-rocker can do it, with what is possible.

    Examples
    --------
    >>> from math import degrees, radians
    >>> proposal = crank_rocker_from_swing(radians(50), 1.2, 1.0)
    >>> round(proposal.value("crank_radius"), 6), round(degrees(proposal.value("transmission_angle")), 5)
    (0.401961, 43.25994)
    """
    refuse(_impossible(swing, time_ratio, rocker_length, transmission_angle, rod_length, speed))
    _refuse_unreachable(swing, time_ratio, slow_swing)
    requirement = FourBarRequirements(swing, excess_angle(time_ratio), rocker_length)
    if requirement.excess < _EQUAL:
        return _of_equal_swings(requirement, transmission_angle, rod_length, speed)
    if rod_length is not None:
        allowed = _("must be left out: with a time ratio other than 1 the best rod follows from swing and ratio")
        raise InputError([Problem("rod_length", as_limit(rod_length), allowed)])
    side = _SIDES[slow_swing]
    parameter = best_parameter(requirement, side)
    bars = four_bar(requirement, single(parameter), side)
    reached = float(judged(requirement, bars).transmission_angle)
    if transmission_angle is not None and reached < transmission_angle:
        allowed = _("must be at most {angle} with this swing and time ratio", angle=number(reached, "deg"))
        raise InputError([Problem("transmission_angle", number(transmission_angle, "deg"), allowed)])
    return _proposal(
        requirement,
        bars,
        speed,
        parameter=parameter,
        alternatives=_alternatives(requirement, side),
        remarks=(
            _(
                "One parameter is free; ξ = {angle} gives the largest smallest transmission angle, {best}.",
                angle=number(parameter, "deg"),
                best=number(reached, "deg"),
            ),
        ),
    )


def _impossible(
    swing: float,
    time_ratio: float,
    rocker_length: float,
    transmission_angle: float | None,
    rod_length: float | None,
    speed: float | None,
) -> Iterator[Problem]:
    """Find requirements that contradict themselves or geometry."""
    if not 0 < swing < pi:
        yield Problem("swing", number(swing, "deg"), _("must lie between 0 and 180 deg"))
    if not time_ratio >= 1:
        allowed = _("must be at least 1: the slow swing's time over the quick one's")
        yield Problem("time_ratio", plain(time_ratio), allowed)
    yield from not_positive({"rocker_length": rocker_length, "rod_length": rod_length})
    if transmission_angle is not None and not 0 < transmission_angle < pi / 2:
        allowed = _("must lie between 0 and 90 deg")
        yield Problem("transmission_angle", number(transmission_angle, "deg"), allowed)
    yield from not_positive({"speed": speed}, plain)


def _refuse_unreachable(swing: float, time_ratio: float, slow_swing: Swing) -> None:
    """Refuse a time ratio that no crank-rocker of this swing has."""
    most = largest_time_ratio(swing, _SIDES[slow_swing])
    if time_ratio < most:
        return
    allowed = _("must be less than {most:.3f} for a swing of {swing}", most=most, swing=number(swing, "deg"))
    repair = None
    if time_ratio < (forward := largest_time_ratio(swing, -1)):
        repair = _("with the slow swing in the sense of rotation it can be up to {most:.3f}", most=forward)
    raise InputError([Problem("time_ratio", plain(time_ratio), allowed, repair)])


def _of_equal_swings(
    requirement: FourBarRequirements, transmission_angle: float | None, rod_length: float | None, speed: float | None
) -> Proposal:
    """Propose for a time ratio of 1: the crank follows from the swing, the rod is free."""
    rocker = requirement.rocker_length
    radius = rocker * sin(requirement.swing / 2)
    limit = (pi - requirement.swing) / 2
    if (rod_length is None) == (transmission_angle is None):
        allowed = _("is missing, and transmission_angle with it; with a time ratio of 1 the rod is free: give one")
        if rod_length is not None:
            allowed = _("must not stand beside transmission_angle; give one of them")
        raise InputError([Problem("rod_length", None if rod_length is None else as_limit(rod_length), allowed)])
    if rod_length is not None and rod_length <= radius:
        allowed = _("must be more than the crank radius, {least}", least=as_limit(radius))
        raise InputError([Problem("rod_length", as_limit(rod_length), allowed)])
    if transmission_angle is not None and transmission_angle >= limit:
        allowed = _("must be less than {limit} for this swing, which only an endless rod would reach")
        raise InputError(
            [
                Problem(
                    "transmission_angle",
                    number(transmission_angle, "deg"),
                    allowed.format(limit=number(limit, "deg")),
                )
            ]
        )
    rod = rod_length if transmission_angle is None else rod_with_equal_swings(requirement, transmission_angle)
    assert rod is not None  # one of the two is given
    bars = with_equal_swings(requirement, rod)
    return _proposal(
        requirement,
        bars,
        speed,
        parameter=None,
        alternatives=_with_other_rods(requirement, rod),
        remarks=(
            _("With equal swings the crank follows from the swing and the rod is free."),
            _("A longer rod transmits better, but never quite at {limit}.", limit=number(limit, "deg")),
        ),
    )


def _with_other_rods(requirement: FourBarRequirements, rod: float) -> tuple[Alternative, ...]:
    """Four-bars of time ratio 1 with rods shorter and longer."""
    return tuple(
        _alternative(_("rod × {factor:g}", factor=factor), requirement, with_equal_swings(requirement, factor * rod))
        for factor in (0.5, 0.75, 1.5, 2.0, 4.0)
        if factor * rod > requirement.rocker_length * sin(requirement.swing / 2)
    )


def _alternatives(requirement: FourBarRequirements, side: int) -> tuple[Alternative, ...]:
    """Four-bars over the range of the parameter on the chosen side, and the best of the other side."""
    values = np.linspace(requirement.excess / 2, pi / 2, _SHOWN + 2)[1:-1].tolist()
    chosen = [
        _alternative(
            _("ξ = {angle:.2f} deg", angle=degrees(value)),
            requirement,
            four_bar(requirement, single(value), side),
        )
        for value in values
    ]
    other = best_parameter(requirement, -side)
    if not np.isnan(other):
        label = (
            _("best with the slow swing against the sense of rotation")
            if side < 0
            else _("best with the slow swing in the sense of rotation")
        )
        chosen.append(_alternative(label, requirement, four_bar(requirement, single(other), -side)))
    return tuple(chosen)


def _alternative(label: Words, requirement: FourBarRequirements, bars: CrankRocker) -> Alternative:
    """Numbers of one four-bar, and in its label what keeps it from being used."""
    verdict = judged(requirement, bars)
    kind = int(verdict.grashof_class)
    if kind != 0:
        label = _("{label}: no crank-rocker; {kind}", label=label, kind=_(CLASSES[kind]))
    elif not verdict.is_one_branch:
        label = _("{label}: its dead positions lie on different branches", label=label)
    return Alternative(label, _numbers(bars, float(verdict.transmission_angle)))


def _numbers(bars: CrankRocker, transmission_angle: float) -> tuple[Number, ...]:
    """Lengths and transmission angle."""
    radius, rod, rocker, ground = (float(length) for length in bars[:4])
    return (
        Number("crank_radius", "R", radius, "mm", _("Crank radius")),
        Number("rod_length", "l", rod, "mm", _("Rod length")),
        Number("rocker_length", "r", rocker, "mm", _("Rocker length")),
        Number("ground_length", "g", ground, "mm", _("Shaft centre to the rocker's pivot")),
        Number("transmission_angle", "μ", transmission_angle, "deg", _("Smallest transmission angle, μ or 180° − μ")),
    )


def _proposal(
    requirement: FourBarRequirements,
    bars: CrankRocker,
    speed: float | None,
    *,
    parameter: float | None,
    alternatives: tuple[Alternative, ...],
    remarks: tuple[Words, ...],
) -> Proposal:
    """Put a four-bar together with its machine file."""
    ratio = time_ratio_of(requirement.excess)
    how = _("equal swings") if parameter is None else _("swing, time ratio, largest transmission angle")
    reached = float(judged(requirement, bars).transmission_angle)
    if reached < 2 * pi / 9:
        remarks += (_("The transmission angle falls below the usual 40 deg: expect large bearing forces there."),)
    free = () if parameter is None else (Number("parameter", "ξ", parameter, "deg", _("Free parameter")),)
    return Proposal(
        title=_(
            "Crank-rocker with a swing of {swing}, time ratio {ratio:.4g}",
            swing=number(requirement.swing, "deg"),
            ratio=ratio,
        ),
        numbers=(
            *_numbers(bars, reached),
            Number("swing", "γ", requirement.swing, "deg", _("Swing of the rocker")),
            Number("time_ratio", "k", ratio, "1", _("Time of the slow swing over that of the quick one")),
            *free,
        ),
        alternatives=alternatives,
        remarks=remarks,
        tables=(
            *shaft_table(speed),
            ProposedTable(
                "mechanism",
                {
                    "kind": '"crank_rocker"',
                    "crank_radius": found(float(bars.crank_radius), "mm", how),
                    "rod_length": found(float(bars.rod_length), "mm", how),
                    "rocker_length": wanted(requirement.rocker_length, "mm"),
                    "ground_length": found(float(bars.ground_length), "mm", how),
                    "side": '"left"',
                },
            ),
        ),
    )
