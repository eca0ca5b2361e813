"""The slider-crank synthesis text: its example, its errors, its table, each as printed, and what is right.

Expected numbers are from a reading of the source by hand: docs/theory/synthesis has the table of its wrong steps.
"""

from decimal import Decimal

import numpy as np
import pytest

from cranktrain.synthesis.slider_crank import slider_crank_from_stroke
from cranktrain.texts import slider_crank_synthesis as source

STEPS = {(step.printed, step.step): step for step in source.wrong_steps()}


def half_a_unit(printed):
    return float(Decimal((0, (5,), Decimal(printed).as_tuple().exponent - 1)))


def step_printed(printed):
    (step,) = (step for (text, _), step in STEPS.items() if text == printed)
    return step


@pytest.mark.parametrize(
    ("printed", "got", "right"),
    [
        ("l = r/tg [α]", "0.1386", "0.16"),
        ("0,08/tg 30° = 0,08/0,3", "0.3", "0.577"),
        ("Tц = 2S/v ≈ 0,05 с", "0.05", "0.0508"),
        ("ω ≈ 125,6 1/с", "125.6", "123.70"),
        ("v = 9,99 м/с", "9.99", "10.01"),
        ("−0,4", "-0.4", "0.37"),
        ("0,9", "0.9", "-0.87"),
        ("−0,9", "-0.9", "0.87"),
        # 0.08·½ + 0.0729 − 0.0048 = 0.1081 and 0.04 + √0.0681 = 0.30096
        ("x = r cos φ + [l² − (r sin φ)²]", "0.1081", "0.3010"),
        # 10.048·(π/3 + 0.15·√3/2) = 11.8275
        ("v = rω[φ + (r/2l) sin 2φ]", "11.828", "10.007"),
        ("v = 10,048 м/с", "10.048", "-10.048"),
        # 0.08/0.54 = 0.148148
        ("r/2l ≈ 0,15", "0.15", "0.1481"),
        ("v = −9,99 м/с", "-9.99", "-10.01"),
    ],
)
def test_wrong_step(printed, got, right):
    step = step_printed(printed)
    assert abs(step.got - float(got)) <= half_a_unit(got)
    assert abs(step.right - float(right)) <= half_a_unit(right)
    assert step.why


@pytest.mark.parametrize(("printed", "degrees"), [("[α] = 30°", "35.3"), ("l ≈ 0,27 м", "17.2")])
def test_true_pressure_angles_of_its_rods(printed, degrees):
    step = step_printed(printed)
    assert abs(np.degrees(step.got) - float(degrees)) <= half_a_unit(degrees)
    assert np.degrees(step.right) == pytest.approx(30, rel=1e-15)


def test_plans_for_the_limit_do_not_show_it():
    """At φ = [α] = 30° sin α = 0.08·½/0.27; its largest angle, at 90°, has sin α = 0.08/0.27."""
    step = step_printed("φ₁, равном [α] и 180° + [α]")
    assert np.sin([step.got, step.right]) == pytest.approx([0.04 / 0.27, 0.08 / 0.27], rel=1e-14)


def test_every_wrong_step_is_wrong_and_named_once():
    assert len(STEPS) == len(source.wrong_steps()) == 16
    for step in STEPS.values():
        assert abs(step.got - step.right) > 1e-3 * abs(step.right)


def test_speed_is_one_and_a_half_percent_high():
    step = step_printed("ω ≈ 125,6 1/с")
    assert round((step.got / step.right - 1) * 100, 1) == 1.5


def test_rod_by_its_rule_cannot_turn_from_45_degrees_on():
    rod = source.rod_by_tangent(0.08, np.radians(50))
    assert rod < 0.08
    assert np.isnan(source.largest_pressure_angle(0.08, rod))


def test_printed_table():
    table = source.velocity_table()
    np.testing.assert_allclose(np.degrees(table.angle), np.arange(0, 360, 30), rtol=1e-15, atol=1e-13)
    printed = [0, 6.3, 9.99, 10.048, 7.4, 3.7, 0, -3.7, -7.4, -10.048, -9.99, -6.3]
    assert table.printed.tolist() == printed


@pytest.mark.parametrize(
    ("column", "expected"),
    [
        ("approximate", ("0", "6.33", "10.01", "10.05", "7.40", "3.72", "0")),
        ("exact", ("0.000", "6.328", "10.036", "10.048", "7.368", "3.720", "0.000")),
    ],
)
def test_its_table_with_its_own_numbers(column, expected):
    found = getattr(source.velocity_table(), column)
    for value, number in zip(found[:7], expected, strict=True):
        assert abs(value - float(number)) <= half_a_unit(number)
    np.testing.assert_allclose(found[:6:-1], -found[1:6], rtol=0, atol=1e-13)


def test_right_answer_to_the_same_requirements():
    requirements = source.REQUIREMENTS
    proposal = slider_crank_from_stroke(
        requirements.stroke, requirements.pressure_angle, mean_speed=requirements.mean_speed
    )
    assert proposal.value("crank_radius") == 0.08
    assert proposal.value("rod_length") == pytest.approx(0.16, rel=1e-15)
    # ω = π v/S = π·6.3/0.16
    assert proposal.value("speed") == pytest.approx(123.70021073509814, rel=1e-15)
    (by_source,) = (one for one in proposal.alternatives if "tan[α]" in str(one.label))
    numbers = {one.name: one.value for one in by_source.numbers}
    assert round(numbers["rod_length"], 4) == 0.1386
    assert round(np.degrees(numbers["working_pressure_angle"]), 1) == 35.3
