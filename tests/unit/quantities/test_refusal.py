"""The right word that was meant, and how a wrong one is refused."""

import pytest
from tests.sentences import NOT_A_KEY

from cranktrain.errors import Problem
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
    assert one_of(["auto", 2]) == "must be one of: auto, 2"
    assert unlisted("cycle", "Otto", ["otto", "diesel"]) == Problem(
        "cycle", "Otto", "must be one of: otto, diesel", 'write "otto"'
    )
    assert unlisted("strokes", 3, [2, 4]) == Problem("strokes", "3", "must be one of: 2, 4")
    told = unknown_key("bank.boer", "boer", "90 mm", ["bore", "stroke"])
    assert told == Problem("bank.boer", "90 mm", f"{NOT_A_KEY}, whose keys are: bore, stroke", "did you mean bore?")
    many = [f"key_{number}" for number in range(17)]
    assert unknown_key("x", "x", {}, many) == Problem("x", None, NOT_A_KEY)
