"""Numbers and names in sentences."""

import numpy as np
import pytest

from cranktrain.saying.wording import around_turn, number, precise, ranged, shared

NAMES = ("1L", "2L", "3L", "1R", "2R", "3R")


@pytest.mark.parametrize(
    ("value", "unit", "text"),
    [
        (0.18, "mm", "180.00 mm"),
        (-0.0000001, "mm", "0.00 mm"),
        (np.pi / 3, "deg", "60.00 deg"),
        (0.0388807, "L", "38.881 L"),
        (157.07963267948966, "rpm", "1500.0 rpm"),
        (0.6228112, "%", "62.28 %"),
        (14.0383, "%", "1404 %"),
        (1.234567, "%", "123.5 %"),
        (14.5, "1", "14.500"),
        (2845.2, "m/s^2", "2845 m/s^2"),
        (float("nan"), "mm", "–"),
        (float("nan"), "1", "–"),
    ],
)
def test_number(value, unit, text):
    assert str(number(value, unit)) == text


def test_limits_keep_their_digits():
    assert precise(0.04154874, "mm") == "41.54874 mm"
    assert precise(0.05, "mm") == "50 mm"


@pytest.mark.parametrize(
    ("values", "text"),
    [
        ([0.18] * 6, "180.00 mm"),
        ([0.18] * 3 + [0.1867] * 3, "180.00 mm (1L–3L), 186.70 mm (1R–3R)"),
        ([0.1, 0.2, 0.1, 0.1, 0.2, 0.3], "100.00 mm (1L, 3L, 1R), 200.00 mm (2L, 2R), 300.00 mm (3R)"),
        ([0.1, 0.1 + 1e-9, np.nan, np.nan, 0.1, 0.1], "100.00 mm (1L, 2L, 2R, 3R), – (3L, 1R)"),
        ([np.nan] * 6, "–"),
    ],
)
def test_equal_values_are_said_once(values, text):
    assert str(shared(NAMES, np.array(values), "mm")) == text


@pytest.mark.parametrize(
    ("members", "text"),
    [
        ([0], "1L"),
        ([0, 1], "1L, 2L"),
        ([0, 1, 2], "1L–3L"),
        ([0, 2, 3, 4], "1L, 3L, 1R, 2R"),
        ([0, 1, 2, 3, 4, 5], "1L–3R"),
        ([], ""),
    ],
)
def test_runs_of_names(members, text):
    assert ranged(NAMES, members) == text


def test_no_angle_is_said_to_be_a_whole_turn():
    angles = np.radians([359.999, 359.99, -0.001, 0, 180])
    assert [str(number(float(angle), "deg")) for angle in around_turn(angles)] == [
        "0.00 deg",
        "359.99 deg",
        "0.00 deg",
        "0.00 deg",
        "180.00 deg",
    ]


@pytest.mark.parametrize(
    ("value", "unit", "written"),
    [
        (9.0, "m/s", "9.00 m/s"),
        (0.10234, "m/s", "0.102 m/s"),
        (2845.2, "m/s^2", "2845 m/s^2"),
        (42.38, "m/s^2", "42.4 m/s^2"),
        (-0.9876, "m/s^2", "-0.988 m/s^2"),
        (0.0, "m/s^2", "0 m/s^2"),
    ],
)
def test_slow_machines_have_three_figures(value, unit, written):
    assert str(number(value, unit)) == written
