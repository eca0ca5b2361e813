"""Quantities as fields: text, number, table or `Given`; ranges; what editors are told."""

import math
import re
from typing import Annotated, Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import TypeAdapter
from tests.sentences import A_LENGTH, NOT_A_KEY, NOT_POSITIVE, TEXT_IN_QUOTES
from tests.told import ToldProblem, problems_told

from cranktrain import quantities as q
from cranktrain.errors import InputError
from cranktrain.quantities import Dimension, Given, Quantity, QuantityError

LENGTH = Quantity(Dimension.LENGTH, above=0.0)
TABLE = {"value": "66.63 deg", "status": "fitted", "note": "to the published stroke", "source": "[3]"}


def refusals(quantity: Quantity, data: object) -> list[ToldProblem]:
    """What is wrong with some data."""
    with pytest.raises(InputError) as refused:
        quantity.given(data)
    return problems_told(refused.value.problems)


def test_text_number_table_and_given_are_read() -> None:
    assert LENGTH.given(" 90  mm") == Given(0.09, "90 mm")
    assert LENGTH.given({"value": "90 mm"}) == Given(0.09, "90 mm")
    assert Quantity(Dimension.RATIO).given(14.5) == Given(14.5, "14.5")
    fitted = Quantity(Dimension.ANGLE).given(TABLE)
    assert fitted == Given(fitted.si, "66.63 deg", "fitted", "to the published stroke", "[3]")
    assert fitted.si == pytest.approx(math.radians(66.63), rel=1e-15)
    assert Quantity(Dimension.ANGLE).given(fitted) is fitted


def test_given_of_another_dimension_or_value_is_refused() -> None:
    (other,) = refusals(Quantity(Dimension.MASS), Given(0.09, "90 mm"))
    assert other[2] == "mm measures a length; must be a mass in kg, g, t, lb, such as 4.5 kg"
    (changed,) = refusals(LENGTH, Given(0.08, "90 mm"))
    assert changed == ("", "90 mm", "must be the value of its text, but 0.08 in SI units is not", None)


def test_everything_wrong_in_a_table_is_told_at_once() -> None:
    wrong = {"value": "90", "statuss": "x", "status": "Fitted", "note": 3, "source": ["[3]"]}
    assert refusals(LENGTH, wrong) == [
        ("value", "90", A_LENGTH, 'write "90 mm"'),
        (
            "statuss",
            "x",
            f"{NOT_A_KEY}, whose keys are: value, status, note, source",
            "did you mean status?",
        ),
        ("status", "Fitted", "must be one of: published, derived, assumed, fitted", 'write "fitted"'),
        ("note", "3", TEXT_IN_QUOTES, None),
        ("source", None, TEXT_IN_QUOTES, None),
    ]
    missing = ("value", None, f"is missing; {A_LENGTH}", None)
    assert refusals(LENGTH, {"status": "fitted"}) == [missing]


@pytest.mark.parametrize(
    ("quantity", "text", "allowed"),
    [
        (LENGTH, "0 mm", f"{NOT_POSITIVE} mm"),
        (LENGTH, "-1/2 in", f"{NOT_POSITIVE} in"),
        (Quantity(Dimension.LENGTH, at_least=0.05), "45 mm", "must be at least 50 mm"),
        (Quantity(Dimension.ANGLE, below=math.pi), "1 rev", "must be less than 0.5 rev"),
        (Quantity(Dimension.ANGLE, at_most=math.pi / 2), "91 град", "must be at most 90 deg"),
        (Quantity(Dimension.RATIO, above=1.0), 1, "must be more than 1"),
        (Quantity(Dimension.TEMPERATURE, above=0.0), "-300 °C", "must be more than -273.15 °C"),
    ],
)
def test_range_is_told_in_the_unit_given(quantity: Quantity, text: object, allowed: str) -> None:
    with pytest.raises(QuantityError) as refused:
        quantity.given(text)
    (problem,) = problems_told(refused.value.problems)
    assert (problem.given, problem.allowed) == (str(text), allowed)


@pytest.mark.parametrize("text", ["50 mm", "60 mm"])
def test_limits_that_are_included(text: str) -> None:
    Quantity(Dimension.LENGTH, at_least=0.05, at_most=0.06).given(text)


@pytest.mark.parametrize(
    ("name", "accepted", "refused"),
    [
        ("Length", "-5 mm", "5 kg"),
        ("PositiveLength", "5 mm", "0 mm"),
        ("NonNegativeLength", "0 mm", "-5 mm"),
        ("Angle", "-5 deg", "5 rpm"),
        ("TurnedAngle", "500 deg", "5 rpm"),
        ("Speed", "-5 rpm", "5 deg"),
        ("PositiveSpeed", "5 rpm", "0 rpm"),
        ("Velocity", "5 m/s", "5 m"),
        ("Force", "-5 kN", "5 kg"),
        ("Pressure", "-1 ati", "-1 bar"),
        ("PositiveMass", "5 kg", "0 kg"),
        ("PositiveInertia", "5 kg·m²", "0 kg·m²"),
        ("NonNegativeInertia", "0 kg·m²", "-5 kg·m²"),
        ("FlywheelMoment", "5 N·m²", "5 N·m"),
        ("PositiveBendingStiffness", "5 kN·m²", "0 kN·m²"),
        ("PositiveTorsionalStiffness", "5 kN·m/rad", "0 kN·m/rad"),
        ("Ratio", -5, "5 mm"),
        ("PositiveRatio", "5/2", 0),
    ],
)
def test_every_annotation(name: str, accepted: object, refused: object) -> None:
    adapter: TypeAdapter[Given] = TypeAdapter(getattr(q, name))
    for data in (accepted, {"value": accepted, "status": "assumed"}):
        quantity = adapter.validate_python(data)
        assert isinstance(quantity, Given)
        assert adapter.dump_python(quantity) == data
        assert adapter.validate_python(adapter.dump_python(quantity)) == quantity
    with pytest.raises(ValueError, match="value_error"):
        adapter.validate_python(refused)


def test_editors_learn_units_range_and_statuses() -> None:
    schema: dict[str, Any] = TypeAdapter(q.PositiveLength).json_schema()
    text, table = schema["else"], schema["then"]
    assert schema["if"] == {"type": "object"}
    assert schema["description"] == f"{A_LENGTH}; {NOT_POSITIVE} (SI)"
    assert text["examples"] == ["90 mm"]
    assert table["properties"]["status"]["enum"] == ["published", "derived", "assumed", "fitted"]
    assert table["required"] == ["value"]
    assert table["additionalProperties"] is False
    assert table["properties"]["value"] == text
    for wrong in ("90", "1,5 m", "mm", "nan m", "1_000 mm", ""):
        assert not re.search(text["pattern"], wrong)
    ratio: dict[str, Any] = TypeAdapter(q.Ratio).json_schema()
    assert ratio["else"]["type"] == ["number", "string"]
    assert TypeAdapter(q.Ratio).json_schema(mode="serialization") == ratio


@given(st.from_regex(r"[-+]?[0-9./ e]{1,8}(mm|in|kg)?", fullmatch=True))
def test_editor_accepts_what_is_read(text: str) -> None:
    quantity = Quantity(Dimension.LENGTH)
    schema = TypeAdapter(Annotated[Given, quantity]).json_schema()
    try:
        quantity.given(text)
    except QuantityError:
        return
    assert re.search(schema["else"]["pattern"], text)


@pytest.mark.parametrize(
    ("text", "same"),
    [
        ("720000000030 deg", "30 deg"),
        ("-720000000030 deg", "-30 deg"),
        ("1e5 deg", "280 deg"),
        ("7.2e14 deg", "0 deg"),
        ("1000000000000.25 rev", "0.25 rev"),
        ("99999 deg", "99999 deg"),
        ("1000 1/3 rev", "120 deg"),
        ("-200 deg", "-200 deg"),
    ],
)
def test_whole_turns_of_a_direction_are_left_out_exactly(text: str, same: str) -> None:
    """By hand: 720000000030 = 2000000000 · 360 + 30; as a double in radians it is 7e-5 deg off."""
    adapter: TypeAdapter[Given] = TypeAdapter(q.Angle)
    found = adapter.validate_python(text)
    assert found.si == adapter.validate_python(same).si == q.read(same, Dimension.ANGLE)
    assert found.text == text
    assert adapter.validate_python(found) == found


def test_whole_turns_of_radians_too() -> None:
    """1e6 − 159154 · 2π by mpmath, 50 digits."""
    assert TypeAdapter[Given](q.Angle).validate_python("1e6 rad").si == 5.925621140093852
    assert TypeAdapter[Given](q.TurnedAngle).validate_python("1e6 rad").si == 1e6
