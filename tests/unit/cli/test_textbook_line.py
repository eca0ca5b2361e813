"""One line on the textbook's forms, for the screen of `run`."""

import pytest
from tests.machines import ROCKER, V12, slider, throws

import cranktrain as ct
from cranktrain.cli.textbook.line import textbook_line


def test_a_plain_crank():
    """λ = 0.3: the largest of 0.18, 0.44 and 1.11 %, the digest's table."""
    machine = ct.Machine(mechanism={"kind": "slider_crank", "crank_radius": "50 mm", "crank_to_rod_ratio": 0.3})
    said = textbook_line(ct.run(machine), "mine.toml")
    assert said == "Textbook forms are off by up to 1.11 %: cranktrain textbook mine.toml"


def test_banks_are_named():
    said = textbook_line(ct.run(ct.Machine(**V12)), "3d12")
    # docs/theory/textbook-forms: 0.92 % of a plain crank with λ = 0.281, 2.61 % of the V-2's reconstructed
    assert said == "Textbook forms are off by up to 0.92 % (L), 2.61 % (R): cranktrain textbook 3d12"


def test_many_give_a_range():
    bank = {
        name: {"angle": f"{angle} deg", "mechanism": slider(rod_length=f"{rod} mm")}
        for name, angle, rod in (("A", 0, 500), ("B", 60, 250), ("C", 120, 200))
    }
    said = textbook_line(ct.run(ct.Machine(shaft=throws(0), bank=bank)), "w3.toml")
    # (337) of λ = 0.1 and 0.25: 4.6e-4 and 6.6e-3
    assert said == "Textbook forms are off by up to 0.046 to 0.66 %: cranktrain textbook w3.toml"


def test_some_pistons_of_a_bank_are_named_one_by_one():
    bank = {
        "A": {"throws": [1, 2], "angle": "0 deg", "mechanism": slider(rod_length="200 mm")},
        "B": {"throws": [3], "angle": "60 deg", "mechanism": slider(rod_length="500 mm")},
    }
    said = textbook_line(ct.run(ct.Machine(shaft=throws(0, 120, 240), bank=bank)), "x")
    assert said == "Textbook forms are off by up to 0.66 % (A), 0.046 % (B): cranktrain textbook x"


def test_a_valve_is_named():
    """(337) of λ = 0.25 is off by 0.66 %, of λ = 0.05 by 0.0060 %."""
    eccentric = {"kind": "eccentric", "eccentricity": "60 mm", "rod_length": "1200 mm", "angle_of_advance": "30 deg"}
    bank = {"A": {"mechanism": slider(rod_length="200 mm")}, "valve": {"mechanism": eccentric}}
    said = textbook_line(ct.run(ct.Machine(bank=bank)), "x")
    assert said == "Textbook forms are off by up to 0.66 % (A), 0.0060 % (valve): cranktrain textbook x"


@pytest.mark.parametrize("mechanism", [ROCKER, {"kind": "scotch_yoke", "crank_radius": "50 mm"}])
def test_none_where_no_form_is_for_the_machine(mechanism):
    assert textbook_line(ct.run(ct.Machine(mechanism=mechanism)), "x") is None


def test_none_where_it_was_not_asked_for():
    assert textbook_line(ct.run(ct.Machine(mechanism=slider()), quantities="stroke"), "x") is None
