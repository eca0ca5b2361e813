"""The strict rule for the number before a unit."""

from fractions import Fraction

import pytest

from cranktrain.quantities.number import measured, rounded


@pytest.mark.parametrize(
    ("text", "number", "unit"),
    [
        ("90 mm", Fraction(90), "mm"),
        ("90mm", Fraction(90), "mm"),
        ("+1.5 m", Fraction(3, 2), "m"),
        ("-.25 in", Fraction(-1, 4), "in"),
        ("5. mm", Fraction(5), "mm"),
        ("2.5e-3 m", Fraction(1, 400), "m"),
        ("2E3 N", Fraction(2000), "N"),
        ("120 1/2 in", Fraction(241, 2), "in"),
        ("7 1/16 in", Fraction(113, 16), "in"),
        ("-7 1/16 in", Fraction(-113, 16), "in"),
        ("-1/16 in", Fraction(-1, 16), "in"),
        ("1/2 in", Fraction(1, 2), "in"),
        ("-0 mm", Fraction(0), "mm"),
        ("0e999999999999999999999 mm", Fraction(0), "mm"),
        ("1500 1/min", Fraction(1500), "1/min"),
        ("14.5", Fraction(29, 2), ""),
        ("1" * 5000 + "e-5000 mm", Fraction(int("1" * 400), 10**400), "mm"),
    ],
)
def test_number_and_unit_are_taken_apart(text: str, number: Fraction, unit: str) -> None:
    found = measured(text)
    assert found is not None
    assert found.unit == unit
    assert float(found.number) == float(number)
    if len(text) < 100:
        assert found.number == number


@pytest.mark.parametrize(
    "text",
    ["", "mm", "nan m", "inf m", "1,5 m", "1_000 mm", "1.2.3 mm", "3/4.5 in", "--5 mm", "- 5 mm", "7-1/16 in", "٣ mm"],
)
def test_nothing_else_is_a_number(text: str) -> None:
    assert measured(text) is None


@pytest.mark.parametrize("text", ["1e400 m", "-1e400 m", "1e-400 m", "1e999999999999999999999 m", "0.1e-99999999 m"])
def test_number_beyond_doubles_is_refused_at_once(text: str) -> None:
    with pytest.raises(OverflowError):
        measured(text)


def test_zero_denominator_is_refused() -> None:
    with pytest.raises(ZeroDivisionError):
        measured("1/0 in")


def test_rounding_is_to_the_nearest_double_or_refused() -> None:
    assert rounded(Fraction(1, 3)) == 1 / 3
    assert rounded(Fraction(0)) == 0.0
    for beyond in (Fraction(10) ** 309, Fraction(10) ** -330):
        with pytest.raises(OverflowError):
            rounded(beyond)
