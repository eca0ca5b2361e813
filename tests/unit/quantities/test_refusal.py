"""The right word that was meant, and how a wrong one is refused."""

import pytest
from tests.sentences import NOT_A_KEY
from tests.told import problems_told

from cranktrain.quantities import nearest, one_of, unknown_key, unlisted, written


@pytest.mark.parametrize(
    ("word", "meant"),
    [("slider-crank", "slider_crank"), ("YOKE", "yoke"), ("yok", "yoke"), ("trammel", None), ("", None)],
)
def test_nearest(word: str, meant: str | None) -> None:
    assert nearest(word, ("slider_crank", "crank_rocker", "yoke")) == meant


def test_letter_case_decides_before_likeness() -> None:
    assert nearest("KN", ("N", "kN", "kgf")) == "kN"


@pytest.mark.parametrize(
    ("value", "text"),
    [("90 mm", "90 mm"), ("", '""'), (" ", '" "'), (True, "true"), (14, "14"), (0.5, "0.5"), ([1], None), ({}, None)],
)
def test_written(value: object, text: str | None) -> None:
    assert written(value) == text


def test_refusals() -> None:
    assert str(one_of(["auto", 2])) == "must be one of: auto, 2"
    many = [f"key_{number}" for number in range(17)]
    problems = (
        unlisted("cycle", "Otto", ["otto", "diesel"]),
        unlisted("strokes", 3, [2, 4]),
        unknown_key("bank.boer", "boer", "90 mm", ["bore", "stroke"]),
        unknown_key("x", "x", {}, many),
    )
    assert problems_told(problems) == [
        ("cycle", "Otto", "must be one of: otto, diesel", 'write "otto"'),
        ("strokes", "3", "must be one of: 2, 4", None),
        ("bank.boer", "90 mm", f"{NOT_A_KEY}, whose keys are: bore, stroke", "did you mean bore?"),
        ("x", None, NOT_A_KEY, None),
    ]
    assert all(problem.position is None for problem in problems)
