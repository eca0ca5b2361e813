"""The closed list against pint, and output in its units."""

import math
from fractions import Fraction
from typing import Any

import numpy as np
import pint
import pytest

from cranktrain.quantities import Dimension, QuantityError, shown
from cranktrain.quantities.dimensions import Unit, spellings

L, M, T = "[length]", "[mass]", "[time]"
DIMENSIONALITY = {
    Dimension.RATIO: {},
    Dimension.LENGTH: {L: 1},
    Dimension.AREA: {L: 2},
    Dimension.VOLUME: {L: 3},
    Dimension.ANGLE: {},
    Dimension.SPEED: {T: -1},
    Dimension.VELOCITY: {L: 1, T: -1},
    Dimension.ACCELERATION: {L: 1, T: -2},
    Dimension.ANGULAR_ACCELERATION: {T: -2},
    Dimension.FORCE: {M: 1, L: 1, T: -2},
    Dimension.TORQUE: {M: 1, L: 2, T: -2},
    Dimension.PRESSURE: {M: 1, L: -1, T: -2},
    Dimension.MASS: {M: 1},
    Dimension.INERTIA: {M: 1, L: 2},
    Dimension.FLYWHEEL_MOMENT: {M: 1, L: 2},
    Dimension.POWER: {M: 1, L: 2, T: -3},
    Dimension.STIFFNESS: {M: 1, T: -2},
    Dimension.TORSIONAL_STIFFNESS: {M: 1, L: 2, T: -2},
    Dimension.BENDING_STIFFNESS: {M: 1, L: 3, T: -2},
    Dimension.DENSITY: {M: 1, L: -3},
    Dimension.ENERGY: {M: 1, L: 2, T: -2},
    Dimension.HEAT_TRANSFER: {M: 1, T: -3, "[temperature]": -1},
    Dimension.FLOW: {L: 3, T: -1},
    Dimension.MASS_FLOW: {M: 1, T: -1},
    Dimension.MOLAR_MASS: {M: 1, "[substance]": -1},
    Dimension.TEMPERATURE: {"[temperature]": 1},
    Dimension.TIME: {T: 1},
    Dimension.FREQUENCY: {T: -1},
    Dimension.CURRENT: {"[current]": 1},
    Dimension.VOLTAGE: {M: 1, L: 2, T: -3, "[current]": -1},
    Dimension.RESISTANCE: {M: 1, L: 2, T: -3, "[current]": -2},
}
OF_PINT = {
    "rev": "turn",
    "kgf": "kilogram_force",
    "tf": "metric_ton * g_0",
    "lbf": "pound_force",
    "kgf·m": "kilogram_force * m",
    "lbf·ft": "pound_force * ft",
    "ft·lbf": "ft * pound_force",
    "W/m²/K": "W / m ** 2 / K",
    "kW/m²/K": "kW / m ** 2 / K",
    "lbf·in": "pound_force * in",
    "kgf·m/rad": "kilogram_force * m / rad",
    "lbf·in/rad": "pound_force * in / rad",
    "barg": "bar",
    "at": "technical_atmosphere",
    "ati": "technical_atmosphere",
    "psig": "psi",
    "t": "metric_ton",
    "lb": "pound",
    "kgf·m²": "kilogram_force * m ** 2 / g_0",
    "N·m²": "N * m ** 2 / g_0",
    "PS": "metric_horsepower",
    "hp": "UK_horsepower",
    "°C": "delta_degree_Celsius",
    "cfm": "foot ** 3 / min",
    "gpm": "gallon / min",
}
"""What pint calls a unit, where it is not called so."""
UNITS = [(dimension, unit) for dimension in Dimension for unit in dimension.units]


@pytest.fixture(scope="module")
def pint_registry():
    return pint.UnitRegistry(non_int_type=Fraction, cache_folder=None)


@pytest.mark.parametrize(("dimension", "unit"), UNITS)
def test_unit_means_what_pint_says(pint_registry: Any, dimension: Dimension, unit: Unit) -> None:
    meant = pint_registry.Quantity(Fraction(1), OF_PINT.get(unit.name, unit.name.replace("·", "*")))
    assert dict(meant.dimensionality) == DIMENSIONALITY[dimension]
    assert meant.to_base_units().magnitude == unit.scale


def test_units_that_do_not_count_from_zero() -> None:
    apart = {unit.name: unit.offset for _dimension, unit in UNITS if unit.offset != 0}
    gauge = dict.fromkeys(("barg", "ati", "psig"), Fraction(101325))
    assert apart == gauge | {"°C": Fraction("273.15")}


def test_a_spelling_means_one_thing() -> None:
    for dimension in Dimension:
        forms = [form for unit in dimension.units for form in (unit.name, *unit.also)]
        assert len(forms) == len(set(forms))
        for key, (unit, _form) in spellings(dimension).items():
            for other in Dimension:
                if key in spellings(other):
                    assert unit[2:] == spellings(other)[key][0][2:]


@pytest.mark.parametrize(
    ("si", "unit", "number"),
    [
        (0.18, "mm", 180.0),
        (0.07, "mm", 70.0),
        (0.0635, "in", 2.5),
        (math.pi / 2, "deg", 90.0),
        (50 * math.pi, "rpm", 1500.0),
        (0.0388, "L", 38.8),
        (8e5, "bar", 8.0),
        (101325.0, "ati", 0.0),
        (1081990.0, "ати", 10.0),
        (293.15, "°C", 20.0),
        (1.0, "N·m²", 9.80665),
        (735.49875, "л.с.", 1.0),
        (98.0665, "kgf*m", 10.0),
    ],
)
def test_shown(si: float, unit: str, number: float) -> None:
    assert shown(si, unit) == pytest.approx(number, rel=2e-15, abs=1e-15)
    np.testing.assert_array_equal(shown(np.array([[si, 2 * si]]), unit), [[shown(si, unit), shown(2 * si, unit)]])


def test_decimal_units_are_shown_with_one_rounding() -> None:
    metres = np.arange(1.0, 10000.0) / 1000
    np.testing.assert_array_equal(shown(metres, "mm"), [float(Fraction(length) * 1000) for length in metres.tolist()])
    np.testing.assert_array_equal(shown(metres, "kPa"), [float(Fraction(size) / 1000) for size in metres.tolist()])


def test_unit_outside_the_list_is_refused_with_the_list() -> None:
    with pytest.raises(QuantityError, match=r"furlong: must be one of the units %, mm, cm, m, in, ft, .*°C, K, .*mΩ$"):
        shown(1.0, "furlong")
