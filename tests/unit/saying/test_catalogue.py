"""One description for what a field holds: the quantities that it stands for, and their arrays."""

from dataclasses import astuple, dataclass

import numpy as np
import pytest

from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import Extreme
from cranktrain.saying.catalogue import coefficients, entries, extreme, quantity, values

CURVE = ("piston", "crank_angle")


@dataclass(frozen=True)
class Swings:
    width: float
    lever_angle: Coefficient = coefficients(
        "θ", "rad", CURVE, "Angle", "Velocity", "Acceleration", "docs/a", "1.4 to 1.6"
    )
    largest_load: Extreme = extreme(
        "P_max", "N", ("piston",), "Largest load", "Crank angle of it", "docs/b", "2.1, 2.3"
    )
    stroke: Array = quantity("S", "m", (), "Stroke", "docs/c", "definition")


@dataclass(frozen=True)
class ByMethod:
    displacement_by_method: Coefficient = coefficients(
        "x", "m", CURVE, "Travel", "Velocity", "Acceleration", "docs/a", "1.4"
    )
    slider_position: Coefficient = coefficients("t_s", "m", CURVE, "Place", "Velocity", "Acceleration", "docs/a", "1.4")


def test_a_field_is_one_quantity_or_several_in_its_place():
    assert [astuple(entry)[:7] for entry in entries(Swings)] == [
        ("lever_angle", "θ", "rad", CURVE, "Angle", "docs/a", "1.4 to 1.6"),
        ("lever_velocity_coefficient", "θ′", "rad/rad", CURVE, "Velocity", "docs/a", "1.4 to 1.6"),
        ("lever_acceleration_coefficient", "θ″", "rad/rad^2", CURVE, "Acceleration", "docs/a", "1.4 to 1.6"),
        ("largest_load", "P_max", "N", ("piston",), "Largest load", "docs/b", "2.1, 2.3"),
        ("largest_load_at", "φ(P_max)", "deg", ("piston",), "Crank angle of it", "docs/b", "2.1, 2.3"),
        ("stroke", "S", "m", (), "Stroke", "docs/c", "definition"),
    ]


def test_derivatives_are_named_for_what_moves():
    assert [(entry.name, entry.symbol, entry.unit) for entry in entries(ByMethod)] == [
        ("displacement_by_method", "x", "m"),
        ("velocity_coefficient_by_method", "x′", "m/rad"),
        ("acceleration_coefficient_by_method", "x″", "m/rad^2"),
        ("slider_position", "t_s", "m"),
        ("slider_velocity_coefficient", "t_s′", "m/rad"),
        ("slider_acceleration_coefficient", "t_s″", "m/rad^2"),
    ]


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("lever_angle", 1.0),
        ("lever_velocity_coefficient", 2.0),
        ("lever_acceleration_coefficient", 3.0),
        ("largest_load", 5.0),
        ("largest_load_at", 4.0),
        ("stroke", 6.0),
    ],
)
def test_every_quantity_has_its_array(name, expected):
    one, two, three, four, five, six = (np.full((1, 1, 8), float(i)) for i in range(1, 7))
    outcome = Swings(0.0, Coefficient(one, two, three), Extreme(angle=four, value=five), six)
    (entry,) = (entry for entry in entries(Swings) if entry.name == name)
    np.testing.assert_array_equal(values(outcome, entry), expected)


def test_pages_are_cited_with_the_numbers_of_equations():
    assert {entry.name: entry.citation for entry in entries(Swings) if entry.is_fact} == {
        "largest_load": "docs/b, eqs. (2.1), (2.3)",
        "largest_load_at": "docs/b, eqs. (2.1), (2.3)",
        "stroke": "docs/c",
    }
    assert entries(Swings)[0].citation == "docs/a, eqs. (1.4) to (1.6)"
    assert entries(ByMethod)[0].citation == "docs/a, eq. (1.4)"
