"""Slider-crank from stroke, speed and permissible pressure angles, exact with an offset; docs/theory/synthesis."""

from collections.abc import Iterator
from math import isnan, pi, sin, tan
from typing import Annotated, Literal

from cranktrain.errors import InputError, Problem, refuse
from cranktrain.language import N_, Words, _
from cranktrain.saying.wording import as_limit, number
from cranktrain.synthesis.four_bars import time_ratio_of
from cranktrain.synthesis.guide_friction import friction_numbers, friction_remark, locking_problems
from cranktrain.synthesis.proposal import (
    Alternative,
    Angle,
    Friction,
    Length,
    Number,
    Proposal,
    ProposedTable,
    Speed,
    Velocity,
    found,
    not_positive,
    plain,
    shaft_table,
    wanted,
)
from cranktrain.synthesis.slider_crank_lengths import (
    Lengths,
    Limits,
    best_offset,
    crank_radius_for,
    excess_angle_of,
    largest_offset,
    least_rod,
    pressure_angles_of,
    shortest_rod,
    shortest_rod_and_offset,
    stroke_of,
)
from cranktrain.texts.slider_crank_synthesis import largest_pressure_angle, rod_by_tangent

Stroke = Literal["toward", "away"]
"""Toward the shaft, or away from it."""

_ROUNDING = 1e-12


def slider_crank_from_stroke(
    stroke: Annotated[Length, N_("Between the dead centres.")],
    pressure_angle: Annotated[Angle | None, N_("Largest permissible, on the working stroke.")] = None,
    *,
    return_pressure_angle: Annotated[Angle | None, N_("On the other stroke; the same unless given.")] = None,
    working_stroke: Annotated[Stroke, N_("From the shaft's point of view; toward unless given.")] = "toward",
    rod_length: Annotated[Length | None, N_("The shortest that keeps the limits unless given.")] = None,
    offset: Annotated[Length | None, N_("Of the line of stroke toward +y; 0 unless given.")] = 0.0,
    mean_speed: Annotated[Velocity | None, N_("Of the slider over the turn, instead of --speed.")] = None,
    speed: Speed | None = None,
    friction: Friction | None = None,
) -> Proposal:
    """Propose a slider-crank.

    Parameters
    ----------
    stroke : float
        True stroke between the dead centres. [m]
    pressure_angle : float, optional
        Largest permissible on the working stroke, dead centres included; needed unless the rod is given. [rad]
    return_pressure_angle : float, optional
        The same on the other stroke; as on the working stroke unless given. [rad]
    working_stroke : "toward" or "away"
        From the shaft's point of view.
    rod_length : float, optional
        The shortest that keeps the limits unless given. [m]
    offset : float or None
        Toward +y; None: whatever is best. With a rod, that makes the working stroke's pressure angle least; without,
        that allows the shortest rod. [m]
    mean_speed, speed : float, optional
        Mean slider speed over the turn [m/s], or crank speed [rad/s]; at most one.
    friction : float, optional
        Coefficient of friction of the slider on its guide. [1]

    Returns
    -------
    Proposal
        With the numbers `crank_radius`, `rod_length`, `offset`, `stroke`, `working_pressure_angle`,
        `return_pressure_angle`, `time_ratio`, `side_force_share`, with a speed `speed` and `mean_speed`, and with
        friction `locking_angle`, `side_force_with_friction` and `friction_share`.

    Raises
    ------
    InputError
        If no slider-crank can do it, with what is possible.

    Examples
    --------
    >>> from math import radians
    >>> proposal = slider_crank_from_stroke(0.16, radians(30), mean_speed=6.3)
    >>> round(proposal.value("rod_length"), 6), round(proposal.value("speed"), 2)
    (0.16, 123.7)
    """
    refuse(_impossible(stroke, pressure_angle, return_pressure_angle, rod_length, mean_speed, speed))
    if rod_length is not None and rod_length <= (least := least_rod(stroke, offset or 0.0)):
        allowed = _("must be more than {least} for this stroke, or the crank cannot turn", least=as_limit(least))
        raise InputError([Problem("rod_length", as_limit(rod_length), allowed)])
    working = pi / 2 if pressure_angle is None else pressure_angle
    back = working if return_pressure_angle is None else return_pressure_angle
    lengths = _chosen(stroke, rod_length, offset, working_stroke, (sin(working), sin(back)))
    if rod_length is not None:
        _refuse_over_limits(lengths, working_stroke, working, return_pressure_angle)
    if friction is not None:
        refuse(locking_problems(max(pressure_angles_of(lengths)), friction))
    omega = mean_speed * pi / stroke if mean_speed is not None else speed
    return Proposal(
        title=_("Slider-crank of {stroke} stroke", stroke=number(stroke, "mm")),
        numbers=(
            *slider_crank_numbers(lengths, working_stroke, omega),
            *friction_numbers(_by_stroke(lengths, working_stroke)[0], friction),
        ),
        alternatives=_alternatives(stroke, lengths, working_stroke, (working, back)) if pressure_angle else (),
        remarks=(*_remarks(lengths, working_stroke), friction_remark(_by_stroke(lengths, working_stroke)[0], friction)),
        tables=(
            *shaft_table(omega, None if mean_speed is None else _("π v/S")),
            _mechanism(lengths, rod_length, offset, None if pressure_angle is None else (working, back)),
        ),
    )


def _impossible(
    stroke: float,
    pressure_angle: float | None,
    return_pressure_angle: float | None,
    rod_length: float | None,
    mean_speed: float | None,
    speed: float | None,
) -> Iterator[Problem]:
    """Find requirements that contradict themselves or geometry."""
    yield from not_positive({"stroke": stroke, "rod_length": rod_length})
    yield from not_positive({"mean_speed": mean_speed, "speed": speed}, plain)
    for name, value in {"pressure_angle": pressure_angle, "return_pressure_angle": return_pressure_angle}.items():
        if value is not None and not 0 < value < pi / 2:
            yield Problem(name, number(value, "deg"), _("must lie between 0 and 90 deg"))
    if pressure_angle is None and rod_length is None:
        allowed = _("is missing; without a rod_length it decides how long the rod must be")
        yield Problem("pressure_angle", None, allowed)
    if mean_speed is not None and speed is not None:
        yield Problem("speed", plain(speed), _("must not stand beside mean_speed; give one of them"))


def _chosen(
    stroke: float,
    rod_length: float | None,
    offset: float | None,
    working_stroke: Stroke,
    sines: tuple[float, float],
) -> Lengths:
    """Choose what is free: the shortest rod, or the best offset."""
    if offset is not None:
        is_working_slow = (offset >= 0) == (working_stroke == "toward")
        limits = Limits(*sines) if is_working_slow else Limits(*sines[::-1])
        if rod_length is None:
            return shortest_rod(stroke, offset, limits)
        return Lengths(crank_radius_for(stroke, rod_length, offset), rod_length, offset)
    # The stroke with the narrower limit is made the slow one, which has the smaller pressure angle.
    is_working_slow = sines[0] <= sines[1]
    limits = Limits(min(sines), max(sines))
    if rod_length is None:
        best = shortest_rod_and_offset(stroke, limits)
    else:
        best = best_offset(stroke, rod_length)
        if best.crank_radius + best.offset > limits.quick * rod_length > stroke / 2:
            best = largest_offset(stroke, rod_length, limits.quick)
    sign = 1.0 if is_working_slow == (working_stroke == "toward") else -1.0
    return best._replace(offset=sign * best.offset)


def _by_stroke(lengths: Lengths, working_stroke: Stroke) -> tuple[float, float]:
    """Largest pressure angle on the working stroke and on the return."""
    slow, quick = pressure_angles_of(lengths)
    return (slow, quick) if (lengths.offset >= 0) == (working_stroke == "toward") else (quick, slow)


def _refuse_over_limits(lengths: Lengths, working_stroke: Stroke, working: float, back: float | None) -> None:
    """Refuse a given rod with which a limit is not kept; without one for the return, the first is for both."""
    angles = _by_stroke(lengths, working_stroke)
    limits = {"pressure_angle": (working, max(angles))}
    if back is not None:
        limits = {"pressure_angle": (working, angles[0]), "return_pressure_angle": (back, angles[1])}
    refuse(
        Problem(
            name,
            number(limit, "deg"),
            _(
                "must be at least {angle} with a rod of {rod} and an offset of {offset}",
                angle=number(angle, "deg"),
                rod=number(lengths.rod_length, "mm"),
                offset=number(lengths.offset, "mm"),
            ),
            _("give a longer rod, or leave rod_length out"),
        )
        for name, (limit, angle) in limits.items()
        if angle > limit * (1 + _ROUNDING)
    )


def slider_crank_numbers(lengths: Lengths, working_stroke: Stroke, speed: float | None) -> tuple[Number, ...]:
    """Give the numbers of a slider-crank, with the speed [rad/s] where there is one."""
    working, back = _by_stroke(lengths, working_stroke)
    stroke = stroke_of(lengths)
    moving = ()
    if speed is not None:
        moving = (
            Number("speed", "n", speed, "rpm", _("Crank speed")),
            Number("mean_speed", "c_m", stroke * speed / pi, "m/s", _("Mean slider speed over the turn")),
        )
    return (
        Number("crank_radius", "R", lengths.crank_radius, "mm", _("Crank radius")),
        Number("rod_length", "L", lengths.rod_length, "mm", _("Rod length")),
        Number("offset", "e", lengths.offset, "mm", _("Offset of the line of stroke toward +y")),
        Number("stroke", "S", stroke, "mm", _("Stroke")),
        Number("working_pressure_angle", "β_w", working, "deg", _("Largest pressure angle on the working stroke")),
        Number("return_pressure_angle", "β_r", back, "deg", _("Largest pressure angle on the return stroke")),
        Number(
            "side_force_share", "N/P", tan(working), "1", _("Largest side force on the working stroke, of the load")
        ),
        Number(
            "time_ratio",
            "k",
            time_ratio_of(excess_angle_of(lengths)),
            "1",
            _("Time of the slow stroke over that of the quick one"),
        ),
        *moving,
    )


def _alternatives(
    stroke: float, lengths: Lengths, working_stroke: Stroke, limits: tuple[float, float]
) -> tuple[Alternative, ...]:
    """What else keeps the limits: without an offset, with the best one; and what the source's rule would give."""
    central = shortest_rod(stroke, 0.0, Limits(sin(limits[0]), sin(limits[1])))
    best = _chosen(stroke, None, None, working_stroke, (sin(limits[0]), sin(limits[1])))
    considered = (
        (_("shortest rod without an offset"), central, (lengths,)),
        (_("shortest rod of all, with an offset"), best, (lengths, central)),
    )
    kept = (
        Alternative(label, slider_crank_numbers(other, working_stroke, None))
        for label, other, seen in considered
        if not any(_are_same(other, one) for one in seen)
    )
    return (*kept, _source_rule(central.crank_radius, min(limits)))


def _are_same(one: Lengths, other: Lengths) -> bool:
    """Whether two slider-cranks differ by rounding alone."""
    return max(abs(a - b) for a, b in zip(one, other, strict=True)) <= _ROUNDING * one.rod_length


def _source_rule(crank_radius: float, limit: float) -> Alternative:
    """The rod that the source's rule gives, and the pressure angle that it truly has; NaN where it cannot turn."""
    rod = rod_by_tangent(crank_radius, limit)
    angle = largest_pressure_angle(crank_radius, rod)
    label = (
        _("the source's rule l = r/tan[α]: too short, the crank cannot turn")
        if isnan(angle)
        else _("the source's rule l = r/tan[α]: too short, the angle is over the limit")
    )
    return Alternative(
        label,
        (
            Number("crank_radius", "R", crank_radius, "mm", _("Crank radius")),
            Number("rod_length", "L", rod, "mm", _("Rod length")),
            Number("working_pressure_angle", "β_w", angle, "deg", _("Largest pressure angle on the working stroke")),
        ),
    )


def _remarks(lengths: Lengths, working_stroke: Stroke) -> tuple[Words, ...]:
    """Say in words what the offset does."""
    if lengths.offset == 0.0:
        return (
            _("The pressure angle is largest where the crank stands square to the line of stroke, not to the rod."),
        )
    working, back = _by_stroke(lengths, working_stroke)
    slow = _("toward the shaft") if lengths.offset > 0 else _("away from the shaft")
    return (
        _(
            "The stroke with the smaller pressure angle is always the slow one: here {slow}, {share} of the turn.",
            slow=slow,
            share=number(pi + excess_angle_of(lengths), "deg"),
        ),
        _(
            "Pressure angle up to {working} on the working stroke, {back} on the return, dead centres included.",
            working=number(working, "deg"),
            back=number(back, "deg"),
        ),
    )


def _mechanism(
    lengths: Lengths, rod_length: float | None, offset: float | None, limits: tuple[float, float] | None
) -> ProposedTable:
    """The mechanism's table, with the limit that holds all round the turn: of two the wider, if an offset uses both."""
    how_offset = _("shortest rod within the limits") if rod_length is None else _("least pressure angle")
    how_crank = _("from the stroke, rod and offset") if lengths.offset else _("S/2")
    keys = {
        "kind": '"slider_crank"',
        "crank_radius": found(lengths.crank_radius, "mm", how_crank),
        "rod_length": found(lengths.rod_length, "mm", _("shortest within the permissible pressure angle"))
        if rod_length is None
        else wanted(rod_length, "mm"),
    }
    if lengths.offset:
        keys["offset"] = found(lengths.offset, "mm", how_offset) if offset is None else wanted(lengths.offset, "mm")
    if limits is not None:
        keys["permissible_pressure_angle"] = wanted(max(limits) if lengths.offset else min(limits), "deg")
    return ProposedTable("mechanism", keys)
