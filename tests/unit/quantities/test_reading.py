"""From text to SI: values from the definitions of the units, refusals with what to write."""

from decimal import Decimal
from fractions import Fraction

import mpmath
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.sentences import A_LENGTH, A_RATIO, AN_INERTIA
from tests.told import problems_told

from cranktrain.quantities import Dimension, QuantityError, expected, read, shown, unit_names

D = Dimension
LBF = Fraction("0.45359237") * Fraction("9.80665")  # pound and standard gravity, both by definition
INCH = Fraction("0.0254")

# What one unit is in SI, from the definitions, with every way to write it
MULTIPLICATIVE = {
    D.LENGTH: {
        Fraction(1, 1000): ("mm", "мм"),
        Fraction(1, 100): ("cm", "см"),
        Fraction(1): ("m", "м"),
        INCH: ("in", "дюйм"),
        Fraction("0.3048"): ("ft", "фут"),
    },
    D.AREA: {
        Fraction(1, 10**6): ("mm²", "mm^2", "mm2", "mm**2", "мм²"),
        Fraction(1, 10**4): ("cm²", "см2"),
        Fraction(1): ("m²", "м²"),
        INCH**2: ("in²", "дюйм²"),
    },
    D.VOLUME: {
        Fraction(1, 1000): ("L", "l", "л"),
        Fraction(1, 10**6): ("cm³", "cm3", "cm^3", "см³"),
        INCH**3: ("in³", "in^3", "дюйм³"),
        Fraction(1): ("m³", "m3", "м³"),
    },
    D.VELOCITY: {
        Fraction(1): ("m/s", "m / s", "м/с"),
        Fraction(1, 1000): ("mm/s", "мм/с"),
        Fraction("0.3048"): ("ft/s", "фут/с"),
    },
    D.FORCE: {
        Fraction(1): ("N", "Н"),
        Fraction(1000): ("kN", "кН"),
        Fraction("9.80665"): ("kgf", "кгс"),
        Fraction("9806.65"): ("tf", "тс"),
        LBF: ("lbf", "фунт-сила"),
    },
    D.TORQUE: {
        Fraction(1): ("N·m", "N*m", "N.m", "N m", "Nm", "N⋅m", "Н·м", "Н*м", "Нм"),
        Fraction(1000): ("kN·m", "kN*m", "kNm", "кН·м", "кНм"),
        Fraction("9.80665"): ("kgf·m", "kgf*m", "кгс·м", "кгс*м", "кгсм"),
        LBF * 12 * INCH: ("lbf·ft", "lbf*ft", "lbf ft", "ft·lbf", "фунт-сила·фут"),
        LBF * INCH: ("lbf·in", "in·lbf", "фунт-сила·дюйм"),
    },
    D.PRESSURE: {
        Fraction(1): ("Pa", "Па"),
        Fraction(1000): ("kPa", "кПа"),
        Fraction(10**6): ("MPa", "МПа", "N/mm²", "N/mm2", "N/mm^2", "Н/мм²"),
        Fraction(10**5): ("bar", "бар"),
        Fraction("98066.5"): ("at", "ат", "kgf/cm²", "kgf/cm2", "кгс/см²"),
        Fraction(101325): ("atm", "атм"),
        LBF / INCH**2: ("psi", "фунт-сила/дюйм²"),
    },
    D.MASS: {
        Fraction(1, 1000): ("g", "г"),
        Fraction(1): ("kg", "кг"),
        Fraction(1000): ("t", "т"),
        Fraction("0.45359237"): ("lb", "фунт"),
    },
    D.INERTIA: {
        Fraction(1): ("kg·m²", "kg*m^2", "kg·m2", "kg m²", "kgm²", "кг·м²", "кг*м2"),
        Fraction("0.45359237") * (12 * INCH) ** 2: ("lb·ft²", "lb*ft^2", "фунт·фут²"),
    },
    D.FLYWHEEL_MOMENT: {
        Fraction(1): ("kgf·m²", "kg·m²", "kgf*m^2", "кгс·м²", "кг·м²"),
        1 / Fraction("9.80665"): ("N·m²", "N*m2", "Н·м²"),
        Fraction("0.45359237") * (12 * INCH) ** 2: ("lb·ft²", "lb*ft^2", "фунт·фут²"),
    },
    D.POWER: {
        Fraction(1): ("W", "Вт"),
        Fraction(1000): ("kW", "кВт"),
        550 * 12 * INCH * LBF: ("hp",),
        75 * Fraction("9.80665"): ("PS", "л.с.", "л. с.", "лс"),
    },
    D.STIFFNESS: {Fraction(1000): ("N/mm", "Н/мм"), Fraction(1): ("N/m", "Н/м")},
    D.BENDING_STIFFNESS: {
        Fraction(10**6): ("MN·m²", "MN*m^2", "МН·м²"),
        Fraction(1000): ("kN·m²", "kN*m2", "кН·м²"),
        Fraction(1): ("Pa·m⁴", "Pa*m4", "Па·м⁴"),
        LBF * INCH**2: ("lbf·in²", "lbf*in^2", "фунт-сила·дюйм²"),
    },
    D.TORSIONAL_STIFFNESS: {
        Fraction(10**6): ("MN·m/rad", "MN*m/rad", "MNm/rad", "МН·м/рад"),
        Fraction(1000): ("kN·m/rad", "kN*m/rad", "kNm/rad", "кН·м/рад"),
        Fraction(1): ("N·m/rad", "N*m/rad", "Nm/rad", "Н·м/рад"),
        Fraction("9.80665"): ("kgf·m/rad", "кгс·м/рад"),
        LBF * INCH: ("lbf·in/rad", "in·lbf/rad", "фунт-сила·дюйм/рад"),
    },
    D.FLOW: {
        Fraction(1): ("m³/s", "m3/s", "м³/с"),
        Fraction(1, 60): ("m³/min", "м³/мин"),
        Fraction(1, 3600): ("m³/h", "m^3/h", "м³/ч"),
        Fraction(1, 1000): ("L/s", "l/s", "л/с"),
        Fraction(1, 60000): ("L/min", "l/min", "л/мин"),
        (12 * INCH) ** 3 / 60: ("cfm", "ft³/min", "ft3/min"),
        231 * INCH**3 / 60: ("gpm", "gal/min"),
    },
    D.MASS_FLOW: {
        Fraction(1): ("kg/s", "кг/с"),
        Fraction(1, 60): ("kg/min", "кг/мин"),
        Fraction(1, 3600): ("kg/h", "кг/ч"),
        Fraction(1000, 3600): ("t/h", "т/ч"),
        Fraction("0.45359237") / 60: ("lb/min", "фунт/мин"),
        Fraction("0.45359237") / 3600: ("lb/h", "фунт/ч"),
    },
    D.MOLAR_MASS: {Fraction(1): ("kg/mol", "кг/моль"), Fraction(1, 1000): ("g/mol", "kg/kmol", "г/моль")},
    D.TEMPERATURE: {Fraction(1): ("K", "К")},
    D.TIME: {
        Fraction(1): ("s", "с"),
        Fraction(1, 1000): ("ms", "мс"),
        Fraction(60): ("min", "мин"),
        Fraction(3600): ("h", "ч"),
    },
    D.FREQUENCY: {
        Fraction(1): ("Hz", "Гц"),
        Fraction(1000): ("kHz", "кГц"),
        Fraction(1, 60): ("1/min", "1/мин"),
        Fraction(1, 3600): ("1/h", "1/ч"),
    },
    D.CURRENT: {Fraction(1): ("A", "А"), Fraction(1000): ("kA", "кА")},
    D.VOLTAGE: {Fraction(1): ("V", "В"), Fraction(1000): ("kV", "кВ")},
    D.RESISTANCE: {Fraction(1): ("Ω", "ohm", "Ом"), Fraction(1, 1000): ("mΩ", "mohm", "мОм")},
}
SPELLED = [
    (dimension, factor, unit)
    for dimension, factors in MULTIPLICATIVE.items()
    for factor, units in factors.items()
    for unit in units
]
TURNS = {  # radians by turn, and so on: multiples of π
    D.ANGLE: {Fraction(1, 180): ("deg", "°", "град"), Fraction(2): ("rev", "об")},
    D.SPEED: {Fraction(2, 60): ("rpm", "rev/min", "об/мин")},
}
ROUND = [
    (dimension, factor, unit)
    for dimension, factors in TURNS.items()
    for factor, units in factors.items()
    for unit in units
]


@pytest.mark.parametrize(("dimension", "factor", "unit"), SPELLED)
def test_every_spelling_of_a_unit_means_its_definition(dimension: Dimension, factor: Fraction, unit: str) -> None:
    assert read(f"2.7 {unit}", dimension) == float(Fraction("2.7") * factor)


@pytest.mark.parametrize(("dimension", "factor", "unit"), ROUND)
def test_angles_are_rounded_once(dimension: Dimension, factor: Fraction, unit: str) -> None:
    with mpmath.workdps(40):
        radians = mpmath.mpf("66.63") * factor.numerator / factor.denominator * mpmath.pi
        assert read(f"66.63 {unit}", dimension) == float(radians)


@pytest.mark.parametrize(
    ("text", "dimension", "si"),
    [
        ("180 mm", D.LENGTH, 0.18),
        ("85 mm", D.LENGTH, 0.085),
        ("63.5 mm", D.LENGTH, 0.0635),
        ("2.5 in", D.LENGTH, 0.0635),
        ("-1/16 in", D.LENGTH, -0.0015875),
        ("120 1/2 in", D.LENGTH, 3.0607),
        ("7 1/16 in", D.LENGTH, 0.1793875),
        ("3 рад", D.ANGLE, 3.0),
        ("3 рад/с", D.SPEED, 3.0),
        ("0 ati", D.PRESSURE, 101325.0),
        ("10 ати", D.PRESSURE, 1081990.0),
        ("1 barg", D.PRESSURE, 201325.0),
        ("20 °C", D.TEMPERATURE, 293.15),
        ("20.1 degC", D.TEMPERATURE, 293.25),
        ("-273.15 °С", D.TEMPERATURE, 0.0),  # with the Cyrillic letter of a Russian keyboard
        ("300 K", D.TEMPERATURE, 300.0),
        ("9.80665 N·m²", D.FLYWHEEL_MOMENT, 1.0),
        (14.5, D.RATIO, 14.5),
        (14, D.RATIO, 14.0),
        ("63/25", D.RATIO, 2.52),
        ("\u00a0180\u202fmm ", D.LENGTH, 0.18),
    ],
)
def test_values(text: object, dimension: Dimension, si: float) -> None:
    assert read(text, dimension) == si


def test_gauge_pounds_count_from_the_atmosphere() -> None:
    assert read("100 psig", D.PRESSURE) == float(100 * LBF / INCH**2 + 101325)


def test_horsepower_has_the_printed_value() -> None:
    assert read("1 hp", D.POWER) == pytest.approx(745.699872, abs=5e-7)
    assert read("1 PS", D.POWER) == 735.49875


SPEED = "must be a speed of rotation in rpm, rad/s, such as 1500 rpm"
TORQUE = "must be a torque in N·m, kN·m, kgf·m, lbf·ft, lbf·in, such as 120 N·m"
RANGE = "must be within what a computer number holds, in SI units 5e-324 to 1.8e308"


@pytest.mark.parametrize(
    ("given", "dimension", "told", "allowed", "repair"),
    [
        ("1,5 m", D.LENGTH, "1,5 m", A_LENGTH, 'write "1.5 m"'),
        ("1,500 mm", D.LENGTH, "1,500 mm", A_LENGTH, 'write "1.500 mm" or "1500 mm"'),
        ("1_000 mm", D.LENGTH, "1_000 mm", A_LENGTH, 'write "1000 mm"'),
        ("1 000 mm", D.LENGTH, "1 000 mm", A_LENGTH, 'write "1000 mm"'),
        ("7-1/16 in", D.LENGTH, "7-1/16 in", A_LENGTH, 'write "7 1/16 in"'),
        ("−5 mm", D.LENGTH, "−5 mm", A_LENGTH, 'write "-5 mm"'),
        ("1,5 MM", D.LENGTH, "1,5 MM", A_LENGTH, 'write "1.5 mm"'),
        ("nan m", D.LENGTH, "nan m", f"must be finite; {A_LENGTH}", None),
        ("-inf m", D.LENGTH, "-inf m", f"must be finite; {A_LENGTH}", None),
        (float("nan"), D.LENGTH, "nan", f"must be finite; {A_LENGTH}", None),
        (float("inf"), D.RATIO, "inf", f"must be finite; {A_RATIO}", None),
        ("1e400 m", D.LENGTH, "1e400 m", RANGE, None),
        ("1e306 kN", D.FORCE, "1e306 kN", RANGE, None),
        ("1e-323 mm", D.LENGTH, "1e-323 mm", RANGE, None),
        (90, D.LENGTH, "90", A_LENGTH, 'write "90 mm"'),
        (90.5, D.LENGTH, "90.5", A_LENGTH, 'write "90.5 mm"'),
        ("90", D.LENGTH, "90", A_LENGTH, 'write "90 mm"'),
        ("1/3", D.LENGTH, "1/3", A_LENGTH, 'write "1/3 m" or "1/3 mm"'),
        (
            "1500 1/min",
            D.SPEED,
            "1500 1/min",
            SPEED,
            'write "1500 rpm", or the speed in rad/s: 1/min does not say whether turns or radians',
        ),
        (
            "25 s^-1",
            D.SPEED,
            "25 s^-1",
            SPEED,
            'write "25 rad/s", or the speed in rpm: s^-1 does not say whether turns or radians',
        ),
        ("5 parsec", D.LENGTH, "5 parsec", A_LENGTH, None),
        ("90 kg", D.LENGTH, "90 kg", f"kg measures a mass; {A_LENGTH}", None),
        ("5 mm", D.RATIO, "5 mm", f"mm measures a length; {A_RATIO}", None),
        (
            "5 kgf·m²",
            D.INERTIA,
            "5 kgf·m²",
            f"kgf·m² measures a flywheel moment GD²; {AN_INERTIA}",
            None,
        ),
        ("5 MM", D.LENGTH, "5 MM", A_LENGTH, 'write "5 mm"'),
        ("5 kg·cm²", D.INERTIA, "5 kg·cm²", AN_INERTIA, None),
        ("5 dyn·cm", D.TORQUE, "5 dyn·cm", TORQUE, None),
        ("5 hPa", D.PRESSURE, "5 hPa", str(expected(D.PRESSURE)), None),
        ("5 Mm", D.LENGTH, "5 Mm", A_LENGTH, 'write "5 mm"'),
        ("5 kgm", D.TORQUE, "5 kgm", TORQUE, 'write "5 kgf·m"'),
        ("5 кгм", D.TORQUE, "5 кгм", TORQUE, 'write "5 кгс·м"'),
        ("5 lb-ft", D.TORQUE, "5 lb-ft", TORQUE, 'write "5 lbf·ft"'),
        ("1 1/2 Rpm", D.SPEED, "1 1/2 Rpm", SPEED, 'write "1 1/2 rpm"'),
        ("", D.LENGTH, '""', A_LENGTH, None),
        ("  ", D.LENGTH, '""', A_LENGTH, None),
        ("mm", D.LENGTH, "mm", A_LENGTH, None),
        ("1/0 in", D.LENGTH, "1/0 in", "must be a fraction whose denominator is not 0", None),
        (True, D.RATIO, "true", A_RATIO, None),
        (False, D.LENGTH, "false", A_LENGTH, None),
        (None, D.LENGTH, None, A_LENGTH, None),
        (["90 mm"], D.LENGTH, None, A_LENGTH, None),
        ("5 m·m", D.LENGTH, "5 m·m", A_LENGTH, 'write "5 mm"'),
        ("14,5", D.RATIO, "14,5", A_RATIO, 'write "14.5"'),
    ],
)
def test_refusals_say_what_to_write(
    given: object, dimension: Dimension, told: str | None, allowed: str, repair: str | None
) -> None:
    with pytest.raises(QuantityError) as refused:
        read(given, dimension)
    (problem,) = problems_told(refused.value.problems)
    assert problem == ("", told, allowed, repair)


@pytest.mark.parametrize("dimension", [dimension for dimension in D if dimension.units])
def test_example_and_every_name_are_readable(dimension: Dimension) -> None:
    assert read(dimension.example, dimension) > 0.0
    for unit in unit_names(dimension):
        read(f"1 {unit}", dimension)


DECIMALS = st.decimals(min_value=Decimal("-1e9"), max_value=Decimal("1e9"), places=6).filter(bool)


@given(DECIMALS, st.sampled_from(SPELLED))
def test_reading_rounds_once(number: Decimal, spelled: tuple[Dimension, Fraction, str]) -> None:
    dimension, factor, unit = spelled
    assert read(f"{number} {unit}", dimension) == float(Fraction(number) * factor)


@given(DECIMALS, st.sampled_from([(d, unit) for d in D for unit in unit_names(d)]))
def test_reading_what_is_shown_gives_the_value_back(number: Decimal, unit_of: tuple[Dimension, str]) -> None:
    dimension, unit = unit_of
    si = read(f"{number} {unit}", dimension)
    zero, one = (read(f"{number} {unit}", dimension) for number in (0, 1))
    # one rounding in reading, at most three in showing; an offset takes digits from the value
    lost = 4e-16 * (zero / (one - zero))
    assert shown(si, unit) == pytest.approx(float(number), rel=1e-15, abs=lost)


NEARLY = st.from_regex(r"[-+0-9 ./,e_]{1,8}[a-zA-Zа-я ./*^·²-]{0,6}", fullmatch=True)


@given(st.text(max_size=12) | NEARLY)
def test_any_text_is_read_or_refused(text: str) -> None:
    for dimension in D:
        try:
            read(text, dimension)
        except QuantityError as refused:
            assert str(refused.problems[0].allowed)
