"""The base of all specs, and every error of pydantic in our words."""

from typing import Annotated, Literal, TypeAlias

import pytest
from pydantic import AfterValidator, BaseModel, Field, ValidationError, model_validator
from pydantic_core import PydanticCustomError
from tests.sentences import (
    A_LENGTH,
    A_ROD,
    A_SPACING,
    AN_ANGLE,
    NOT_A_KEY,
    NOT_POSITIVE,
    TEXT_IN_QUOTES,
    TRUE_OR_FALSE,
    WHOLE_NUMBER,
)
from tests.told import ToldProblem, problems_told

from cranktrain.errors import InputError, Problem
from cranktrain.quantities import Angle, Given, Length, PositiveLength, PositiveRatio
from cranktrain.spec import Refused, Spec, problems, validated

KINDS = "must be one of: slider, slave"


class Slider(Spec):
    """Check across fields."""

    kind: Literal["slider"]
    crank_radius: PositiveLength
    rod_length: PositiveLength

    @model_validator(mode="after")
    def _closes(self) -> "Slider":
        if self.rod_length.si <= self.crank_radius.si:
            allowed = f"must be more than crank_radius = {self.crank_radius.text}"
            raise Refused(allowed, "make it longer", path="rod_length")
        return self


class Slave(Spec):
    """Several problems at once; a key equal to another table's kind."""

    kind: Literal["slave"]
    slave: Angle
    gaps: tuple[Length, ...] = ()

    @model_validator(mode="after")
    def _gaps_open(self) -> "Slave":
        closed = [index for index, gap in enumerate(self.gaps) if gap.si < 0]
        if closed:
            raise InputError(Problem(f"gaps[{index}]", None, "must be open") for index in closed)
        return self


Mechanism: TypeAlias = Annotated[Slider | Slave, Field(discriminator="kind")]


def _odd(number: int) -> int:
    if number % 2 == 0:
        raise ValueError("must be odd")
    return number


def _small(number: int) -> int:
    if number > 10:
        raise PydanticCustomError("too_big", "must be small")
    return number


class Bank(Spec):
    """A union told by its type."""

    angle: Angle | tuple[Angle, ...] = Given(0.0, "0 deg")
    mechanism: Mechanism


class Machine(Spec):
    """Everything that a spec may hold."""

    name: Annotated[str, Field(min_length=2, max_length=9, pattern="^[a-z0-9 ]*$")] = "one"
    bank: dict[str, Bank] = Field(default_factory=dict)
    mechanism: Mechanism | None = None
    parts: tuple[Mechanism, ...] = ()
    either: Mechanism | tuple[Mechanism, ...] | None = None
    plain: Slider | tuple[Slave, ...] | None = None
    cycle: Literal["two-stroke", "four-stroke"] = "four-stroke"
    spacing: Literal["auto"] | PositiveLength | tuple[PositiveLength, ...] = "auto"
    pair: tuple[Length, Length] | None = None
    count: Annotated[int, Field(gt=0, lt=100, multiple_of=1), AfterValidator(_odd), AfterValidator(_small)] = 1
    efficiency: Annotated[float, Field(ge=0, le=1)] = 1.0
    is_double: bool = False
    compression_ratio: PositiveRatio | None = None
    start: Annotated[str, Field(alias="from")] = ""
    numbers: dict[str, str] = Field(default_factory=dict)
    fuel: dict[Literal["gas", "oil"], str] = Field(default_factory=dict)
    harmonics: Annotated[tuple[int, ...], Field(min_length=1, max_length=2)] = (1,)
    nothing: None = None


SLIDER = {"kind": "slider", "crank_radius": "90 mm", "rod_length": "320 mm"}
SLAVE = {"kind": "slave", "slave": "60 deg"}


def refused(data: object) -> list[ToldProblem]:
    """What is wrong with some data."""
    with pytest.raises(InputError) as error:
        validated(Machine, data)
    return problems_told(error.value.problems)


def test_good_data_are_read_with_lists_as_tuples_and_where_numbers_are_from() -> None:
    rod = {"value": "320 mm", "status": "published", "note": "drawing 7", "source": "[3]"}
    data = {
        "bank": {"L": {"angle": ["30 deg", "-30 deg"], "mechanism": {**SLIDER, "rod_length": rod}}},
        "spacing": ["180 mm", "0.2 m"],
        "compression_ratio": 14.5,
        "efficiency": 1,
        "from": "main.pin",
        "parts": [SLIDER, SLAVE],
    }
    machine = validated(Machine, data)
    mechanism = machine.bank["L"].mechanism
    assert isinstance(mechanism, Slider)
    assert mechanism.rod_length == Given(0.32, "320 mm", "published", "drawing 7", "[3]")
    assert machine.spacing == (Given(0.18, "180 mm"), Given(0.2, "0.2 m"))
    assert machine.compression_ratio == Given(14.5, "14.5")
    assert validated(Machine, machine.model_dump(by_alias=True)) == machine
    assert hash(mechanism) == hash(Slider.model_validate({**SLIDER, "rod_length": rod}))
    assert data["parts"] == [SLIDER, SLAVE]


def test_specs_are_made_in_python_too() -> None:
    slider = Slider(kind="slider", crank_radius=Given(0.09, "90 mm"), rod_length=Given(0.32, "320 mm"))
    assert slider == validated(Slider, SLIDER)
    assert validated(Machine, {"mechanism": slider}).mechanism is slider


@pytest.mark.parametrize(
    ("data", "problem"),
    [
        # keys
        (
            {"mechanisms": {}, "mechanism": SLIDER},
            ("mechanisms", None, NOT_A_KEY, "did you mean mechanism?"),
        ),
        ({"form": "x"}, ("form", "x", NOT_A_KEY, "did you mean from?")),
        (
            {"mechanism": {**SLIDER, "rod_lenght": "3 m"}},
            (
                "mechanism.rod_lenght",
                "3 m",
                f"{NOT_A_KEY}, whose keys are: kind, crank_radius, rod_length",
                "did you mean rod_length?",
            ),
        ),
        ({"parts": [SLIDER, {"kind": "slave"}]}, ("parts[1].slave", None, f"is missing; {AN_ANGLE}", None)),
        ({"pair": ["1 mm"]}, ("pair[1]", None, f"is missing; {A_LENGTH}", None)),
        ({"bank": {"R": {}}}, ("bank.R.mechanism", None, "is missing", None)),
        ({"numbers": {"5": 1}}, ("numbers.5", "1", TEXT_IN_QUOTES, None)),
        ({"fuel": {"Gas": "x"}}, ("fuel.Gas", "Gas", "must be one of: gas, oil", 'write "gas"')),
        # kinds
        ({"mechanism": {"kind": "Slider"}}, ("mechanism.kind", "Slider", KINDS, 'write "slider"')),
        ({"parts": [{"kind": "yoke"}]}, ("parts[0].kind", "yoke", KINDS, None)),
        ({"mechanism": {"kind": 5}}, ("mechanism.kind", "5", KINDS, None)),
        ({"mechanism": {}}, ("mechanism.kind", None, f"is missing; {KINDS}", None)),
        (
            {"mechanism": {"knd": "slider"}},
            ("mechanism.kind", None, f"is missing; {KINDS}", "write kind instead of knd"),
        ),
        ({"mechanism": 5}, ("mechanism", "5", "must be a table", None)),
        ({"mechanism": {**SLAVE, "slave": 60}}, ("mechanism.slave", "60", AN_ANGLE, 'write "60 deg"')),
        ({"either": {**SLAVE, "slave": 60}}, ("either.slave", "60", AN_ANGLE, 'write "60 deg"')),
        ({"either": [{**SLAVE, "slave": 60}]}, ("either[0].slave", "60", AN_ANGLE, 'write "60 deg"')),
        ({"either": {"kind": "salve"}}, ("either.kind", "salve", KINDS, 'write "slave"')),
        # words, numbers, texts
        (
            {"cycle": "four stroke"},
            ("cycle", "four stroke", "must be one of: two-stroke, four-stroke", 'write "four-stroke"'),
        ),
        ({"count": "1"}, ("count", '"1"', WHOLE_NUMBER, None)),
        ({"count": 1.0}, ("count", "1.0", WHOLE_NUMBER, None)),
        ({"count": True}, ("count", "true", WHOLE_NUMBER, None)),
        ({"count": 0}, ("count", "0", NOT_POSITIVE, None)),
        ({"count": 100}, ("count", "100", "must be less than 100", None)),
        ({"count": 2}, ("count", "2", "must be odd", None)),
        ({"count": 11}, ("count", "11", "must be small", None)),
        ({"efficiency": "0.9"}, ("efficiency", '"0.9"', "must be a number", None)),
        ({"efficiency": -1}, ("efficiency", "-1", "must be at least 0.0", None)),
        ({"efficiency": 1.5}, ("efficiency", "1.5", "must be at most 1.0", None)),
        ({"efficiency": float("nan")}, ("efficiency", "nan", "must be a finite number", None)),
        ({"is_double": "yes"}, ("is_double", '"yes"', TRUE_OR_FALSE, None)),
        ({"is_double": 1}, ("is_double", "1", TRUE_OR_FALSE, None)),
        ({"name": 3}, ("name", "3", TEXT_IN_QUOTES, None)),
        ({"name": "x"}, ("name", "x", "must have at least 2 characters", None)),
        ({"name": "x" * 10}, ("name", "x" * 10, "must have at most 9 characters", None)),
        ({"name": "3D12"}, ("name", "3D12", "must match ^[a-z0-9 ]*$", None)),
        ({"nothing": 1}, ("nothing", "1", "must be left out", None)),
        # lists and tables
        ({"parts": SLIDER}, ("parts", None, "must be a list in [ ]", None)),
        ({"numbers": []}, ("numbers", None, "must be a table", None)),
        ({"bank": {"R": 5}}, ("bank.R", "5", "must be a table", None)),
        ({"harmonics": []}, ("harmonics", None, "must have at least 1 items", None)),
        ({"harmonics": [1, 2, 3]}, ("harmonics", None, "must have at most 2 items", None)),
        ([], ("", None, "must be a table", None)),
        # quantities
        ({"compression_ratio": 0}, ("compression_ratio", "0", NOT_POSITIVE, None)),
        (
            {"mechanism": {**SLIDER, "rod_length": {"value": "320 mm", "status": "fited"}}},
            (
                "mechanism.rod_length.status",
                "fited",
                "must be one of: published, derived, assumed, fitted",
                'write "fitted"',
            ),
        ),
        # unions told by their type: only what is wrong with the alternative that fits
        (
            {"bank": {"R": {"angle": "3 mm", "mechanism": SLIDER}}},
            ("bank.R.angle", "3 mm", f"mm measures a length; {AN_ANGLE}", None),
        ),
        (
            {"bank": {"R": {"angle": ["3 deg", "3"], "mechanism": SLIDER}}},
            ("bank.R.angle[1]", "3", AN_ANGLE, 'write "3 deg"'),
        ),
        ({"spacing": "Auto"}, ("spacing", "Auto", f"must be one of: auto, or {A_SPACING}", 'write "auto"')),
        ({"spacing": ["180 mm", "-1 mm"]}, ("spacing[1]", "-1 mm", f"{NOT_POSITIVE} mm", None)),
        ({"plain": {**SLIDER, "rod_length": 1}}, ("plain.rod_length", "1", A_ROD, 'write "1 m" or "1 mm"')),
        ({"plain": [{**SLAVE, "slave": 1}]}, ("plain[0].slave", "1", AN_ANGLE, 'write "1 deg"')),
        ({"plain": [{"kind": "slave"}]}, ("plain[0].slave", None, f"is missing; {AN_ANGLE}", None)),
        (
            {"plain": {"kind": "slider", "crank_radius": "1 m"}},
            ("plain.rod_length", None, f"is missing; {A_ROD}", None),
        ),
        # our own checks across fields
        (
            {"mechanism": {**SLIDER, "rod_length": {"value": "45 mm", "status": "fitted"}}},
            ("mechanism.rod_length", "45 mm", "must be more than crank_radius = 90 mm", "make it longer"),
        ),
        (
            {"parts": [{**SLIDER, "rod_length": "45 mm"}]},
            ("parts[0].rod_length", "45 mm", "must be more than crank_radius = 90 mm", "make it longer"),
        ),
    ],
)
def test_problem(data: object, problem: tuple[str, str | None, str, str | None]) -> None:
    assert refused(data) == [problem]


def test_all_problems_are_told_at_once_in_the_order_of_the_fields() -> None:
    gaps = ["1 mm", "-1 mm", {"value": "-2 mm"}]
    data = {"cycle": "otto", "mechanism": {**SLAVE, "gaps": gaps}, "bank": {"R": {"mechanism": 1}}, "typo": 1}
    assert refused(data) == [
        ("bank.R.mechanism", "1", "must be a table", None),
        ("mechanism.gaps[1]", "-1 mm", "must be open", None),
        ("mechanism.gaps[2]", "-2 mm", "must be open", None),
        ("cycle", "otto", "must be one of: two-stroke, four-stroke", None),
        ("typo", "1", NOT_A_KEY, None),
    ]


def test_check_of_a_spec_made_in_python_has_the_value_too() -> None:
    with pytest.raises(ValidationError) as error:
        Slider(kind="slider", crank_radius=Given(0.09, "90 mm"), rod_length=Given(0.045, "45 mm"))
    (problem,) = problems_told(problems(error.value, Slider))
    assert problem == ("rod_length", "45 mm", "must be more than crank_radius = 90 mm", "make it longer")


def test_spec_cannot_be_changed() -> None:
    slider = validated(Slider, SLIDER)
    with pytest.raises(ValidationError) as error:
        slider.kind = "slider"  # pyright: ignore[reportAttributeAccessIssue]
    (problem,) = problems_told(problems(error.value, Slider))
    assert problem == ("kind", "slider", "must not be changed; make a new one", None)


def test_json_schema_tells_kinds_and_refuses_unknown_keys() -> None:
    schema = Machine.model_json_schema()
    assert schema["additionalProperties"] is False
    assert set(schema["properties"]["parts"]["items"]["discriminator"]["mapping"]) == {"slider", "slave"}


def test_refusal_reads_as_one_line() -> None:
    with pytest.raises(InputError, match=r"^rod_length = 45 mm: must be more than .* = 90 mm; make it longer$"):
        validated(Slider, {**SLIDER, "rod_length": "45 mm"})
    assert issubclass(Spec, BaseModel)
