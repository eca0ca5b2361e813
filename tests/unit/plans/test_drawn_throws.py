"""Which throws a sheet shows: one of each sort, or the one that is asked for."""

import pytest

import cranktrain as ct
from cranktrain.io.examples import example_names
from cranktrain.plans.drawn_throws import drawn_throws
from cranktrain.plans.placement import first_throw

CRANK = {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "200 mm"}


def stages(**cylinders):
    throws = {"main": {"throws": ["0 deg", "180 deg", "90 deg"], "speed": "600 rpm"}}
    return ct.Machine(shaft=throws, bank={"A": {"mechanism": CRANK}}, cylinder=cylinders)


def names(machine, mechanism=None):
    return [[place.name for place in throw] for throw in drawn_throws(machine, mechanism)]


def test_cylinders_of_other_bores_are_drawn():
    assert names(stages(**{"1": {"bore": "150 mm"}, "2": {"bore": "90 mm"}, "3": {"bore": "150 mm"}})) == [["1"], ["2"]]
    assert names(stages(bore="150 mm")) == [["1"]]
    assert names(stages(bore="150 mm"), "3") == [["3"]]


def test_cranks_of_other_radii_are_drawn():
    banks = {
        "A": {"throws": [1], "mechanism": CRANK},
        "B": {"throws": [2], "mechanism": CRANK | {"crank_radius": "30 mm"}},
    }
    machine = ct.Machine(shaft={"main": {"throws": ["0 deg", "180 deg"]}}, bank=banks)
    assert len(drawn_throws(machine)) == 2


@pytest.mark.parametrize("name", example_names())
def test_like_throws_of_the_examples_are_drawn_once(name):
    machine = ct.load(name)
    assert drawn_throws(machine) == (first_throw(machine),)
