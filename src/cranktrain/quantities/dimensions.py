"""What can be measured in a machine file, and in which units: the closed list, English names first."""

import re
import unicodedata
from collections.abc import Mapping
from enum import Enum
from functools import cache
from typing import NamedTuple

from cranktrain.language import N_, _


class Unit(NamedTuple):
    """A unit of the list: its name, its other spellings, and what it means in the words of `units.txt`."""

    name: str
    also: tuple[str, ...]
    meaning: str


def _unit(name: str, *also: str, meaning: str | None = None) -> Unit:
    """List a unit; where the name says what it means, pint reads the name."""
    return Unit(name, also, meaning or name)


class Dimension(Enum):
    """A kind of quantity: what it is called, an example, and its units, the usual one first."""

    RATIO = (N_("a number without a unit"), "0.25", ())
    LENGTH = (
        N_("a length"),
        "90 mm",
        (_unit("mm", "мм"), _unit("cm", "см"), _unit("m", "м"), _unit("in", "дюйм"), _unit("ft", "фут")),
    )
    AREA = (
        N_("an area"),
        "180 cm²",
        (_unit("cm²", "см²"), _unit("mm²", "мм²"), _unit("m²", "м²"), _unit("in²", "дюйм²")),
    )
    VOLUME = (
        N_("a volume"),
        "3.2 L",
        (_unit("L", "l", "л"), _unit("cm³", "см³"), _unit("in³", "дюйм³"), _unit("m³", "м³")),
    )
    ANGLE = (N_("an angle"), "30 deg", (_unit("deg", "°", "град"), _unit("rad", "рад"), _unit("rev", "об")))
    SPEED = (
        N_("a speed of rotation"),
        "1500 rpm",
        (_unit("rpm", "rev/min", "r/min", "об/мин"), _unit("rad/s", "рад/с")),
    )
    VELOCITY = (N_("a velocity"), "9 m/s", (_unit("m/s", "м/с"), _unit("mm/s", "мм/с"), _unit("ft/s", "фут/с")))
    FORCE = (
        N_("a force"),
        "500 N",
        (_unit("N", "Н"), _unit("kN", "кН"), _unit("kgf", "кгс"), _unit("tf", "тс"), _unit("lbf", "фунт-сила")),
    )
    TORQUE = (
        N_("a torque"),
        "120 N·m",
        (
            _unit("N·m", "Н·м"),
            _unit("kgf·m", "кгс·м"),
            _unit("lbf·ft", "ft·lbf", "фунт-сила·фут"),
            _unit("lbf·in", "in·lbf", "фунт-сила·дюйм"),
        ),
    )
    PRESSURE = (
        N_("a pressure"),
        "800 kPa",
        (
            _unit("kPa", "кПа"),
            _unit("Pa", "Па"),
            _unit("MPa", "МПа"),
            _unit("bar", "бар"),
            _unit("barg", "бари"),
            _unit("at", "ат", "kgf/cm²", "кгс/см²"),
            _unit("ati", "ати"),
            _unit("atm", "атм"),
            _unit("psi", "psia", "фунт-сила/дюйм²"),
            _unit("psig"),
        ),
    )
    MASS = (N_("a mass"), "4.5 kg", (_unit("kg", "кг"), _unit("g", "г"), _unit("t", "т"), _unit("lb", "фунт")))
    INERTIA = (N_("a moment of inertia"), "0.5 kg·m²", (_unit("kg·m²", "кг·м²"),))
    FLYWHEEL_MOMENT = (
        N_("a flywheel moment GD²"),
        "2 kgf·m²",
        (  # a weight G and a mass G in these two units are the same number
            _unit("kgf·m²", "кгс·м²", meaning="kgf·m²/g_n"),
            _unit("kg·m²", "кг·м²"),
            _unit("N·m²", "Н·м²", meaning="N·m²/g_n"),
        ),
    )
    POWER = (N_("a power"), "220 kW", (_unit("kW", "кВт"), _unit("W", "Вт"), _unit("hp"), _unit("PS", "л.с.")))
    STIFFNESS = (N_("a stiffness"), "250 N/mm", (_unit("N/mm", "Н/мм"), _unit("N/m", "Н/м")))
    DENSITY = (N_("a density"), "7200 kg/m³", (_unit("kg/m³", "кг/м³"), _unit("g/cm³", "г/см³")))
    TEMPERATURE = (N_("a temperature"), "20 °C", (_unit("°C", "degC", "°С"), _unit("K", "К")))

    def __init__(self, noun: str, example: str, units: tuple[Unit, ...]) -> None:
        self.noun = noun
        self.example = example
        self.units = units


def unit_names(dimension: Dimension) -> tuple[str, ...]:
    """Names of the units of a dimension, the usual one first; none for a plain number."""
    return tuple(unit.name for unit in dimension.units)


def expected(dimension: Dimension) -> str:
    """Say what is allowed: "must be a length in mm, cm, m, in, ft, such as 90 mm"."""
    if not dimension.units:
        return _("must be {noun}, such as {example}").format(noun=_(dimension.noun), example=dimension.example)
    return _("must be {noun} in {units}, such as {example}").format(
        noun=_(dimension.noun), units=", ".join(unit_names(dimension)), example=dimension.example
    )


def plain(unit: str) -> str:
    """Spell a unit one way: m² and m^2 as m2; N·m, N*m, N.m and N m as N·m."""
    text = unicodedata.normalize("NFKC", unit).replace("**", "").replace("^", "")
    text = re.sub(r"\s*/\s*", "/", text.strip())
    return re.sub(r"[\s.*·⋅∙×]+", "·", text).strip("·")


@cache
def spellings(dimension: Dimension) -> Mapping[str, tuple[Unit, str]]:
    """Every plain spelling of every unit of a dimension, also without dots (Nm), with the unit and the listed form."""
    listed = [(unit, form) for unit in dimension.units for form in (unit.name, *unit.also)]
    return {key: (unit, form) for unit, form in listed for key in (plain(form), plain(form).replace("·", ""))}
