"""What the text on the synthesis of a slider-crank states of its requirements, or of others, beside what is so."""

from collections.abc import Iterator
from math import pi, sin, sqrt
from typing import NamedTuple

import numpy as np

from cranktrain.errors import InputError, Problem, refuse
from cranktrain.language import Words, _
from cranktrain.motion import Array, single
from cranktrain.quantities import Dimension, Quantity
from cranktrain.textbook.statements import Statement, StatementCurve, Statements, Verdict
from cranktrain.texts.slider_crank_synthesis import (
    CRANK_RADIUS,
    HALF_RATIO,
    PIN_SPEED,
    PRINTED_VELOCITY,
    REQUIREMENTS,
    ROD_LENGTH,
    SPEED,
    SliderCrankRequirements,
    exact_velocity,
    largest_pressure_angle,
    rod_by_tangent,
)
from cranktrain.texts.steam_engine import two_harmonics

SOURCE = "slider-crank-synthesis"
VELOCITY = "v = rω[φ + (r/2l) sin 2φ]"
PLACE = "x = r cos φ + [l² − (r sin φ)²]"
_STEP = 30.0
"""Of the text's table. [deg]"""
_PERIOD = 0.05
"""As the text rounds it. [s]"""
_ROUNDING = 1e-12
"""Requirements are the text's own however they are typed: "30 deg" or "0.523598775598299 rad"."""
_WANTED = {
    "stroke": Quantity(Dimension.LENGTH, above=0.0),
    "mean_speed": Quantity(Dimension.VELOCITY, above=0.0),
    "pressure_angle": Quantity(Dimension.ANGLE, above=0.0, below=pi / 2),
    "rod_length": Quantity(Dimension.LENGTH, above=0.0),
}


def synthesis(
    *,
    stroke: str | None = None,
    mean_speed: str | None = None,
    pressure_angle: str | None = None,
    rod_length: str | None = None,
) -> Statements:
    """Give what [slider-crank-synthesis] makes of its requirements, or of others, each number beside the right one.

    Parameters
    ----------
    stroke, mean_speed, pressure_angle : str, optional
        Between the dead centres; of the slider over the turn; largest permissible, less than 90°: as "160 mm",
        "6.3 m/s", "30 deg". Those of the text unless given.
    rod_length : str, optional
        Of the rod with which it goes on; the text's own with its requirements, else the right one, unless given.

    Returns
    -------
    Statements
        Requirements, lengths, period, speed; at 0, 30, … 330° places from the shaft as printed, in numbers of m, and
        velocities, positive toward the shaft, as printed and by its formula, beside the exact ones; curves over the
        turn. With the text's requirements all is by its own numbers, r, l = 0.27 m, ω, and with its slips.

    Raises
    ------
    InputError
        With everything that is wrong.

    Examples
    --------
    >>> rod = [one for one in synthesis().numbered("l = r/tg [α]") if one.symbol == "l"]
    >>> [(one.name, round(one.value, 4), round(one.exact, 4)) for one in rod]
    [('rod by the rule', 0.1386, 0.16), ('rod that it goes on with', 0.27, 0.16)]
    >>> longer = synthesis(stroke="200 mm").numbered("r = S/2")[0]
    >>> longer.value, longer.unit, longer.verdict
    (0.1, 'm', 'right')
    """
    given = {
        "stroke": stroke,
        "mean_speed": mean_speed,
        "pressure_angle": pressure_angle,
        "rod_length": rod_length,
    }
    problems: list[Problem] = []
    read: dict[str, float] = dict(REQUIREMENTS._asdict())
    for name, text in given.items():
        if text is not None:
            try:
                read[name] = _WANTED[name].given(text).si
            except InputError as error:
                problems += [Problem(name, one.given, one.allowed, one.repair) for one in error.problems]
    rod = read.pop("rod_length", None)
    if rod is not None and not problems and rod <= read["stroke"] / 2:
        allowed = _("must be more than half the stroke, or the crank cannot turn")
        problems.append(Problem("rod_length", rod_length, allowed))
    refuse(problems)
    return synthesis_statements(SliderCrankRequirements(**read), rod)


class _SliderCrank(NamedTuple):
    """With what the text goes on: r, l [m], ω [rad/s], and as it has them rω [m/s] and r/l."""

    radius: float
    rod: float
    speed: float
    pin_speed: float
    ratio: float


_OWN = _SliderCrank(CRANK_RADIUS, ROD_LENGTH, SPEED, PIN_SPEED, 2 * HALF_RATIO)


def _mechanism(wanted: SliderCrankRequirements, rod: float | None) -> _SliderCrank:
    """The slider-crank of requirements, with the right rod unless one is given."""
    radius = wanted.stroke / 2
    length = radius / sin(wanted.pressure_angle) if rod is None else rod
    speed = pi * wanted.mean_speed / wanted.stroke
    return _SliderCrank(radius, length, speed, radius * speed, radius / length)


def synthesis_statements(wanted: SliderCrankRequirements, rod: float | None = None) -> Statements:
    """Give all numbers and curves of the text for requirements, and a rod with which it goes on."""
    is_own = rod is None and bool(np.allclose(wanted, REQUIREMENTS, rtol=_ROUNDING, atol=0.0))
    own = _OWN if is_own else _mechanism(wanted, rod)
    over = np.arange(361.0)
    return Statements(
        _("Slider-crank from stroke and pressure angle [{source}]", source=SOURCE),
        (
            *_requirements(wanted),
            *_sizes(wanted, rod, is_own=is_own),
            *_places(own),
            *_velocities(own, is_own=is_own),
        ),
        over,
        tuple(_curves(own, np.deg2rad(over))),
        {_("Its velocities"): (_words(is_own=is_own, has_rod=rod is not None),)},
    )


def _statement(
    equation: str, symbol: str, words: Words, value: float, unit: str, exact: float | None = None, at: str = ""
) -> Statement:
    """A number that is right, or printed where another one is."""
    verdict: Verdict = "right" if exact is None else "printed"
    return Statement(SOURCE, equation, symbol, words, "", at, value, unit, verdict, value if exact is None else exact)


def _requirements(wanted: SliderCrankRequirements) -> Iterator[Statement]:
    yield _statement("", "S", _("stroke"), wanted.stroke, "m", at="given")
    yield _statement("", "v", _("mean slider speed"), wanted.mean_speed, "m/s", at="given")
    yield _statement("", "[α]", _("permissible pressure angle"), wanted.pressure_angle, "rad", at="given")


def _sizes(wanted: SliderCrankRequirements, given: float | None, *, is_own: bool) -> Iterator[Statement]:
    """Lengths with the pressure angles that they have, of a rod that is given too; period and speed."""
    limit, radius = wanted.pressure_angle, wanted.stroke / 2
    yield _statement("r = S/2", "r", _("crank radius"), radius, "m")
    rule, name = "l = r/tg [α]", _("its largest pressure angle")
    rods = [(_("rod by the rule"), rod_by_tangent(radius, limit))]
    if is_own:
        rods.append((_("rod that it goes on with"), ROD_LENGTH))
    for rod_name, rod in rods:
        yield _statement(rule, "l", rod_name, rod, "m", radius / sin(limit))
        yield _statement(rule, "α", name, largest_pressure_angle(radius, rod), "rad", limit, "largest")
    if given is not None:
        yield _statement(rule, "l", _("rod that is given"), given, "m")
        yield _statement(rule, "α", name, largest_pressure_angle(radius, given), "rad", at="largest")
    period = 2 * wanted.stroke / wanted.mean_speed
    yield _statement("Tц = 2S/v", "Tц", _("period of a turn"), period, "s")
    if is_own:
        yield _statement("Tц = 2S/v", "Tц", _("the same, rounded"), _PERIOD, "s", period)
    yield _statement("ω = 2π/Tц", "ω", _("angular speed of the crank"), 2 * pi / period, "rad/s")
    if is_own:
        yield _statement("ω = 2π/Tц", "ω", _("the same, from the rounded period"), SPEED, "rad/s", 2 * pi / period)


def _by_formula(angle: Array, own: _SliderCrank) -> Array:
    """Velocity by the formula, with sin φ where φ is printed. [m/s]"""
    return two_harmonics(angle, single(own.pin_speed), single(own.ratio)).first


def _exact(angle: Array, own: _SliderCrank) -> Array:
    """Velocity of the slider-crank with which the text goes on. [m/s]"""
    return exact_velocity(angle, own.radius, own.rod, own.speed)


def _places(own: _SliderCrank) -> Iterator[Statement]:
    """Places of the slider as printed, where a length and an area in numbers of m are added, and with the root."""
    for at in np.arange(0.0, 360.0, _STEP).tolist():
        along = own.radius * float(np.cos(np.deg2rad(at)))
        square = own.rod**2 - (own.radius * float(np.sin(np.deg2rad(at)))) ** 2
        name = _("position of the slider, without the root")
        yield Statement(SOURCE, PLACE, "x", name, "", "at", along + square, "m", "printed", along + sqrt(square), at)


def _velocities(own: _SliderCrank, *, is_own: bool) -> Iterator[Statement]:
    """The text's table: as printed, and by its formula, beside the exact velocity."""
    degrees = np.arange(0.0, 360.0, _STEP)
    angle = np.deg2rad(degrees)
    exact = _exact(angle, own).tolist()
    columns: list[tuple[Verdict, Words, list[float], str]] = [
        ("approximate", _("by its formula"), _by_formula(angle, own).tolist(), VELOCITY)
    ]
    if is_own:
        columns.insert(0, ("printed", _("as printed"), list(PRINTED_VELOCITY), "table"))
    for verdict, name, values, equation in columns:
        for at, value, true in zip(degrees.tolist(), values, exact, strict=True):
            yield Statement(SOURCE, equation, "v", name, "", "at", value, "m/s", verdict, true, at)


def _curves(own: _SliderCrank, angle: Array) -> Iterator[StatementCurve]:
    """Velocity over the turn by its formula, beside the exact one."""
    values, exact = (curve(angle, own) for curve in (_by_formula, _exact))
    yield StatementCurve(SOURCE, VELOCITY, "v", _("velocity of the slider"), "", "m/s", "approximate", values, exact)


def _words(*, is_own: bool, has_rod: bool) -> Words:
    """Say with which numbers the velocities are."""
    if is_own:
        return _(
            "Its formula and the exact law have its own numbers, rω = {speed} m/s and l = {rod} m. "
            "Positive is toward the shaft.",
            speed=PIN_SPEED,
            rod=ROD_LENGTH,
        )
    if has_rod:
        return _("Its formula and the exact law have the rod that is given. Positive is toward the shaft.")
    return _("Its formula and the exact law have the right rod, l = r/sin [α]. Positive is toward the shaft.")
