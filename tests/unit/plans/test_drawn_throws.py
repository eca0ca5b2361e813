"""Which throws a sheet shows: one of each sort, or the one that is asked for."""

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.io.examples import example_names
from cranktrain.plans.drawn_throws import drawn_throws
from cranktrain.plans.placement import first_throw
from cranktrain.viz.throw.beside import Bounds, arrangements

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


def test_every_sort_is_drawn_however_many():
    bores = {str(number): {"bore": f"{300 - 40 * number} mm"} for number in range(1, 7)}
    throws = {"main": {"throws": [f"{60 * number} deg" for number in range(6)]}}
    machine = ct.Machine(shaft=throws, bank={"A": {"mechanism": CRANK}}, cylinder=bores)
    assert names(machine) == [[str(number)] for number in range(1, 7)]
    assert names(machine, "5") == [["5"]]


def test_throws_stand_in_rows_and_columns_that_do_not_touch():
    """Squares of 2, 4, 2 and 2: in a row 10 + 3 gaps of 1, two by two (2 + 4 + 1) by (4 + 2 + 1)."""
    bounds = [Bounds(np.array([-half, -half]), np.array([half, half])) for half in (1.0, 2.0, 1.0, 1.0)]
    found = {len({float(place[1]) for place in places}): (places, whole) for places, whole in arrangements(bounds, 1.0)}
    assert sorted(found) == [1, 2, 4]
    sizes = {rows: tuple(whole.high - whole.low) for rows, (_places, whole) in found.items()}
    assert sizes == {1: (13.0, 4.0), 2: (7.0, 7.0), 4: (4.0, 13.0)}
    np.testing.assert_array_equal(found[2][0], [[0, 0], [4, 0], [0, -4], [4, -4]])
