"""What the text on the synthesis of a slider-crank states of its requirements, or of others, beside what is so."""

from collections.abc import Iterator
from math import pi, sin

import numpy as np

from cranktrain.errors import InputError, Problem, refuse
from cranktrain.language import _
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
}


def synthesis(
    *, stroke: str | None = None, mean_speed: str | None = None, pressure_angle: str | None = None
) -> Statements:
    """Give what [slider-crank-synthesis] makes of its requirements, or of others, each number beside the right one.

    Parameters
    ----------
    stroke, mean_speed, pressure_angle : str, optional
        Between the dead centres; of the slider over the turn; largest permissible, less than 90°: as "160 mm",
        "6.3 m/s", "30 deg". Those of the text unless given.

    Returns
    -------
    Statements
        Requirements, lengths, period, speed; velocities at 0, 30, … 330°, positive toward the shaft, as printed and by
        its formula beside the exact ones; curves over the turn. With the text's requirements all is by its own numbers,
        r, l = 0.27 m, ω, and with its slips; with others the velocities are of the right rod.

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
    given = {"stroke": stroke, "mean_speed": mean_speed, "pressure_angle": pressure_angle}
    problems: list[Problem] = []
    read = dict(REQUIREMENTS._asdict())
    for name, text in given.items():
        if text is not None:
            try:
                read[name] = _WANTED[name].given(text).si
            except InputError as error:
                problems += [Problem(name, one.given, one.allowed, one.repair) for one in error.problems]
    refuse(problems)
    return synthesis_statements(SliderCrankRequirements(**read))


def synthesis_statements(wanted: SliderCrankRequirements) -> Statements:
    """Give all numbers and curves of the text for requirements."""
    is_own = bool(np.allclose(wanted, REQUIREMENTS, rtol=_ROUNDING, atol=0.0))
    over = np.arange(361.0)
    return Statements(
        _("Slider-crank from stroke and pressure angle [{source}]").format(source=SOURCE),
        (*_requirements(wanted), *_sizes(wanted, is_own=is_own), *_velocities(wanted, is_own=is_own)),
        over,
        tuple(_curves(wanted, np.deg2rad(over), is_own=is_own)),
        {_("Its velocities"): (_words(wanted, is_own=is_own),)},
    )


def _statement(
    equation: str, symbol: str, name: str, value: float, unit: str, exact: float | None = None, at: str = ""
) -> Statement:
    """A number that is right, or printed where another one is."""
    verdict: Verdict = "right" if exact is None else "printed"
    return Statement(SOURCE, equation, symbol, name, "", at, value, unit, verdict, value if exact is None else exact)


def _requirements(wanted: SliderCrankRequirements) -> Iterator[Statement]:
    yield _statement("", "S", _("stroke"), wanted.stroke, "m", at="given")
    yield _statement("", "v", _("mean slider speed"), wanted.mean_speed, "m/s", at="given")
    yield _statement("", "[α]", _("permissible pressure angle"), wanted.pressure_angle, "rad", at="given")


def _sizes(wanted: SliderCrankRequirements, *, is_own: bool) -> Iterator[Statement]:
    """Lengths with the pressure angles that they have, period and speed."""
    limit, radius = wanted.pressure_angle, wanted.stroke / 2
    yield _statement("r = S/2", "r", _("crank radius"), radius, "m")
    rods = [(_("rod by the rule"), rod_by_tangent(radius, limit))]
    if is_own:
        rods.append((_("rod that it goes on with"), ROD_LENGTH))
    for name, rod in rods:
        yield _statement("l = r/tg [α]", "l", name, rod, "m", radius / sin(limit))
        angle = _("its largest pressure angle")
        yield _statement("l = r/tg [α]", "α", angle, largest_pressure_angle(radius, rod), "rad", limit, "largest")
    period = 2 * wanted.stroke / wanted.mean_speed
    yield _statement("Tц = 2S/v", "Tц", _("period of a turn"), period, "s")
    if is_own:
        yield _statement("Tц = 2S/v", "Tц", _("the same, rounded"), _PERIOD, "s", period)
    yield _statement("ω = 2π/Tц", "ω", _("angular speed of the crank"), 2 * pi / period, "rad/s")
    if is_own:
        yield _statement("ω = 2π/Tц", "ω", _("the same, from the rounded period"), SPEED, "rad/s", 2 * pi / period)


def _by_formula(angle: Array, wanted: SliderCrankRequirements, *, is_own: bool) -> Array:
    """Velocity by the formula, with sin φ where φ is printed. [m/s]"""
    if is_own:
        return two_harmonics(angle, single(PIN_SPEED), single(2 * HALF_RATIO)).first
    pin_speed = pi * wanted.mean_speed / 2  # rω = (S/2)·2π·v/(2S)
    return two_harmonics(angle, single(pin_speed), single(sin(wanted.pressure_angle))).first


def _exact(angle: Array, wanted: SliderCrankRequirements, *, is_own: bool) -> Array:
    """Velocity of the rod that the text goes on with, or of the right one. [m/s]"""
    if is_own:
        return exact_velocity(angle, CRANK_RADIUS, ROD_LENGTH, SPEED)
    radius = wanted.stroke / 2
    return exact_velocity(angle, radius, radius / sin(wanted.pressure_angle), pi * wanted.mean_speed / wanted.stroke)


def _velocities(wanted: SliderCrankRequirements, *, is_own: bool) -> Iterator[Statement]:
    """The text's table: as printed, and by its formula, beside the exact velocity."""
    degrees = np.arange(0.0, 360.0, _STEP)
    angle = np.deg2rad(degrees)
    exact = _exact(angle, wanted, is_own=is_own).tolist()
    columns: list[tuple[Verdict, str, list[float], str]] = [
        ("approximate", _("by its formula"), _by_formula(angle, wanted, is_own=is_own).tolist(), VELOCITY)
    ]
    if is_own:
        columns.insert(0, ("printed", _("as printed"), list(PRINTED_VELOCITY), "table"))
    for verdict, name, values, equation in columns:
        for at, value, true in zip(degrees.tolist(), values, exact, strict=True):
            yield Statement(SOURCE, equation, "v", name, "", "at", value, "m/s", verdict, true, at)


def _curves(wanted: SliderCrankRequirements, angle: Array, *, is_own: bool) -> Iterator[StatementCurve]:
    """Velocity over the turn by its formula, beside the exact one."""
    values, exact = (curve(angle, wanted, is_own=is_own) for curve in (_by_formula, _exact))
    yield StatementCurve(SOURCE, VELOCITY, "v", _("velocity of the slider"), "", "m/s", "approximate", values, exact)


def _words(wanted: SliderCrankRequirements, *, is_own: bool) -> str:
    """Say with which numbers the velocities are."""
    if is_own:
        return _(
            "Its formula and the exact law have its own numbers, rω = {speed} m/s and l = {rod} m. "
            "Positive is toward the shaft."
        ).format(speed=PIN_SPEED, rod=ROD_LENGTH)
    return _("Its formula and the exact law have the right rod, l = r/sin [α]. Positive is toward the shaft.")
