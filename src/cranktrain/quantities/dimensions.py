"""What can be measured in a machine file, and in which units: the closed list, English names first.

Numbers are read as fractions, so that a value is rounded once. Gauge pressures count from 101.325 kPa.
"""

import re
import unicodedata
from collections.abc import Iterable, Mapping
from enum import Enum
from fractions import Fraction
from functools import cache
from typing import NamedTuple

from cranktrain.language import N_, Words, _


class Unit(NamedTuple):
    """A unit of the list: its name, its other spellings, and SI value = scale · number + offset, exactly."""

    name: str
    also: tuple[str, ...]
    scale: Fraction
    offset: Fraction


def _unit(name: str, *also: str, si: int | str | Fraction = 1, offset: int | str = 0) -> Unit:
    """List a unit with the SI value of one of it; what counts from elsewhere than zero has an offset."""
    return Unit(name, also, Fraction(si), Fraction(offset))


# Exact by definition: yard and pound of 1959, standard gravity of 1901. π has 50 digits, so that an angle is rounded
# once, too.
_INCH, _FOOT, _POUND, _GRAVITY = Fraction("0.0254"), Fraction("0.3048"), Fraction("0.45359237"), Fraction("9.80665")
_POUND_FORCE = _POUND * _GRAVITY
_PSI = _POUND_FORCE / _INCH**2
_TECHNICAL_ATMOSPHERE = _GRAVITY * 10**4
TURN = 2 * Fraction("3.1415926535897932384626433832795028841971693993751")
_GALLON = 231 * _INCH**3
"""The gallon of the United States."""
_AMBIENT = 101325
_FREEZING = "273.15"


class Dimension(Enum):
    """A kind of quantity: what it is called, an example, and its units, the usual one first."""

    RATIO = (N_("a number without a unit"), "0.25", (_unit("%", si="0.01"),))
    LENGTH = (
        N_("a length"),
        "90 mm",
        (
            _unit("mm", "мм", si="0.001"),
            _unit("cm", "см", si="0.01"),
            _unit("m", "м"),
            _unit("in", "дюйм", si=_INCH),
            _unit("ft", "фут", si=_FOOT),
        ),
    )
    AREA = (
        N_("an area"),
        "180 cm²",
        (
            _unit("cm²", "см²", si="1e-4"),
            _unit("mm²", "мм²", si="1e-6"),
            _unit("m²", "м²"),
            _unit("in²", "дюйм²", si=_INCH**2),
        ),
    )
    VOLUME = (
        N_("a volume"),
        "3.2 L",
        (
            _unit("L", "l", "л", si="0.001"),
            _unit("cm³", "см³", si="1e-6"),
            _unit("in³", "дюйм³", si=_INCH**3),
            _unit("m³", "м³"),
        ),
    )
    ANGLE = (
        N_("an angle"),
        "30 deg",
        (_unit("deg", "°", "град", si=TURN / 360), _unit("rad", "рад"), _unit("rev", "об", si=TURN)),
    )
    SPEED = (
        N_("a speed of rotation"),
        "1500 rpm",
        (_unit("rpm", "rev/min", "r/min", "об/мин", si=TURN / 60), _unit("rad/s", "рад/с")),
    )
    VELOCITY = (
        N_("a velocity"),
        "9 m/s",
        (_unit("m/s", "м/с"), _unit("mm/s", "мм/с", si="0.001"), _unit("ft/s", "фут/с", si=_FOOT)),
    )
    ACCELERATION = (
        N_("an acceleration"),
        "9.81 m/s²",
        (_unit("m/s²", "м/с²"), _unit("cm/s²", "см/с²", si="0.01"), _unit("ft/s²", "фут/с²", si=_FOOT)),
    )
    ANGULAR_ACCELERATION = (
        N_("an angular acceleration"),
        "50 rad/s²",
        (
            _unit("rad/s²", "рад/с²"),
            _unit("deg/s²", "град/с²", si=TURN / 360),
            _unit("rpm/s", "об/мин/с", si=TURN / 60),
        ),
    )
    FORCE = (
        N_("a force"),
        "500 N",
        (
            _unit("N", "Н"),
            _unit("kN", "кН", si=1000),
            _unit("kgf", "кгс", si=_GRAVITY),
            _unit("tf", "тс", si=1000 * _GRAVITY),
            _unit("lbf", "фунт-сила", si=_POUND_FORCE),
        ),
    )
    TORQUE = (
        N_("a torque"),
        "120 N·m",
        (
            _unit("N·m", "Н·м"),
            _unit("kN·m", "кН·м", si=1000),
            _unit("kgf·m", "кгс·м", si=_GRAVITY),
            _unit("lbf·ft", "ft·lbf", "фунт-сила·фут", si=_POUND_FORCE * _FOOT),
            _unit("lbf·in", "in·lbf", "фунт-сила·дюйм", si=_POUND_FORCE * _INCH),
        ),
    )
    PRESSURE = (
        N_("a pressure"),
        "800 kPa",
        (
            _unit("kPa", "кПа", si=1000),
            _unit("Pa", "Па"),
            _unit("MPa", "МПа", "N/mm²", "Н/мм²", si=10**6),
            _unit("GPa", "ГПа", si=10**9),
            _unit("bar", "бар", si=10**5),
            _unit("barg", "бари", si=10**5, offset=_AMBIENT),
            _unit("at", "ат", "kgf/cm²", "кгс/см²", si=_TECHNICAL_ATMOSPHERE),
            _unit("ati", "ати", si=_TECHNICAL_ATMOSPHERE, offset=_AMBIENT),
            _unit("atm", "атм", si=_AMBIENT),
            _unit("psi", "psia", "фунт-сила/дюйм²", si=_PSI),
            _unit("psig", si=_PSI, offset=_AMBIENT),
        ),
    )
    MASS = (
        N_("a mass"),
        "4.5 kg",
        (
            _unit("kg", "кг"),
            _unit("g", "г", si="0.001"),
            _unit("t", "т", si=1000),
            _unit("lb", "фунт", si=_POUND),
        ),
    )
    INERTIA = (
        N_("a moment of inertia"),
        "0.5 kg·m²",
        (_unit("kg·m²", "кг·м²"), _unit("lb·ft²", "фунт·фут²", si=_POUND * _FOOT**2)),
    )
    FLYWHEEL_MOMENT = (
        N_("a flywheel moment GD²"),
        "2 kgf·m²",
        (  # a weight G and a mass G in these two units are the same number
            _unit("kgf·m²", "кгс·м²"),
            _unit("kg·m²", "кг·м²"),
            _unit("N·m²", "Н·м²", si=1 / _GRAVITY),
            _unit("lb·ft²", "фунт·фут²", si=_POUND * _FOOT**2),
        ),
    )
    POWER = (
        N_("a power"),
        "220 kW",
        (
            _unit("kW", "кВт", si=1000),
            _unit("W", "Вт"),
            _unit("hp", si=550 * _FOOT * _POUND_FORCE),
            _unit("PS", "л.с.", si=75 * _GRAVITY),
        ),
    )
    STIFFNESS = (
        N_("a stiffness"),
        "250 N/mm",
        (_unit("N/mm", "Н/мм", si=1000), _unit("kN/mm", "кН/мм", si=10**6), _unit("N/m", "Н/м")),
    )
    TORSIONAL_STIFFNESS = (
        N_("a torsional stiffness"),
        "1.25 MN·m/rad",
        (
            _unit("MN·m/rad", "МН·м/рад", si=10**6),
            _unit("kN·m/rad", "кН·м/рад", si=1000),
            _unit("N·m/rad", "Н·м/рад"),
            _unit("N·m/deg", "Н·м/град", si=360 / TURN),
            _unit("kgf·m/rad", "кгс·м/рад", si=_GRAVITY),
            _unit("lbf·in/rad", "in·lbf/rad", "фунт-сила·дюйм/рад", si=_POUND_FORCE * _INCH),
        ),
    )
    BENDING_STIFFNESS = (
        N_("a bending stiffness EI"),
        "2.5 MN·m²",
        (
            _unit("MN·m²", "МН·м²", si=10**6),
            _unit("kN·m²", "кН·м²", si=1000),
            _unit("Pa·m⁴", "Па·м⁴"),  # N·m² is a flywheel moment's
            _unit("lbf·in²", "фунт-сила·дюйм²", si=_POUND_FORCE * _INCH**2),
        ),
    )
    ENERGY = (
        N_("an energy"),
        "1200 J",
        (
            _unit("J", "Дж"),
            _unit("kJ", "кДж", si=1000),
            _unit("MJ", "МДж", si=10**6),
            _unit("kgf·m", "кгс·м", si=_GRAVITY),
            _unit("ft·lbf", si=_FOOT * _POUND_FORCE),
        ),
    )
    HEAT_TRANSFER = (
        N_("a heat transfer coefficient"),
        "600 W/m²/K",
        (_unit("W/m²/K", "W/(m²·K)", "Вт/м²/К"), _unit("kW/m²/K", "kW/(m²·K)", "кВт/м²/К", si=1000)),
    )
    DENSITY = (N_("a density"), "7200 kg/m³", (_unit("kg/m³", "кг/м³"), _unit("g/cm³", "г/см³", si=1000)))
    FLOW = (
        N_("a flow of volume"),
        "300 m³/h",
        (
            _unit("m³/h", "м³/ч", si=Fraction(1, 3600)),
            _unit("m³/min", "м³/мин", si=Fraction(1, 60)),
            _unit("m³/s", "м³/с"),
            _unit("L/min", "l/min", "л/мин", si=Fraction(1, 60000)),
            _unit("L/s", "l/s", "л/с", si="0.001"),
            _unit("cfm", "ft³/min", si=_FOOT**3 / 60),
            _unit("gpm", "gal/min", si=_GALLON / 60),
        ),
    )
    MASS_FLOW = (
        N_("a flow of mass"),
        "360 kg/h",
        (
            _unit("kg/h", "кг/ч", si=Fraction(1, 3600)),
            _unit("kg/min", "кг/мин", si=Fraction(1, 60)),
            _unit("kg/s", "кг/с"),
            _unit("t/h", "т/ч", si=Fraction(1000, 3600)),
            _unit("lb/h", "фунт/ч", si=_POUND / 3600),
            _unit("lb/min", "фунт/мин", si=_POUND / 60),
        ),
    )
    MOLAR_MASS = (
        N_("a molar mass"),
        "28.96 g/mol",
        (_unit("g/mol", "kg/kmol", "г/моль", "кг/кмоль", si="0.001"), _unit("kg/mol", "кг/моль")),
    )
    TEMPERATURE = (N_("a temperature"), "20 °C", (_unit("°C", "degC", "°С", offset=_FREEZING), _unit("K", "К")))
    TIME = (
        N_("a time"),
        "2 s",
        (_unit("s", "с"), _unit("ms", "мс", si="0.001"), _unit("min", "мин", si=60), _unit("h", "ч", si=3600)),
    )
    FREQUENCY = (
        N_("a frequency"),
        "50 Hz",
        (
            _unit("Hz", "Гц"),
            _unit("kHz", "кГц", si=1000),
            _unit("1/min", "1/мин", si=Fraction(1, 60)),
            _unit("1/h", "1/ч", si=Fraction(1, 3600)),
        ),
    )
    CURRENT = (N_("an electric current"), "15 A", (_unit("A", "А"), _unit("kA", "кА", si=1000)))
    VOLTAGE = (N_("a voltage"), "400 V", (_unit("V", "В"), _unit("kV", "кВ", si=1000)))
    RESISTANCE = (
        N_("an electric resistance"),
        "0.5 Ω",
        (_unit("Ω", "\u2126", "ohm", "Ом"), _unit("mΩ", "mohm", "мОм", si="0.001")),
    )

    def __init__(self, noun: str, example: str, units: tuple[Unit, ...]) -> None:
        self.noun = noun
        self.example = example
        self.units = units

    @property
    def needs_unit(self) -> bool:
        """Whether a number alone says nothing."""
        return self is not Dimension.RATIO


def unit_names(dimension: Dimension) -> tuple[str, ...]:
    """Names of the units of a dimension, the usual one first."""
    return tuple(unit.name for unit in dimension.units)


def expected(dimension: Dimension, example: str | None = None, others: Iterable[str] = ()) -> Words:
    """Say what is allowed: "must be a length in mm, cm, m, in, ft, such as 90 mm"; with the dimension's own example.

    others: units of another dimension that are taken too.
    """
    words = _("must be {noun} in {units}, such as {example}")
    if not dimension.needs_unit:
        words = _("must be {noun} or in {units}, such as {example}")
    return words.format(
        noun=_(dimension.noun), units=", ".join([*unit_names(dimension), *others]), example=example or dimension.example
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


def is_unit(text: str, dimension: Dimension) -> bool:
    """Whether a text names a unit of a dimension, in any of its spellings.

    Examples
    --------
    >>> is_unit("N m", Dimension.TORQUE), is_unit("bar", Dimension.TORQUE)
    (True, False)
    """
    return plain(text) in spellings(dimension)
