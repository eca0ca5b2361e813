"""Pistons in their order of firing, and directions of throws by where their crank pins are drawn."""

from functools import cache

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.io.examples import example_names
from cranktrain.panels.drawing_of_machine import machine_drawing
from cranktrain.web.throws import page_pistons, page_throws


@cache
def result(name):
    return ct.run(name)


def test_pistons_of_a_four_stroke_v12_in_the_order_of_its_maker():
    """1L 6R 5L 2R 3L 4R 6L 1R 2L 5R 4L 3R, each 60 degrees after the one before."""
    found = page_pistons(result("3d12"))
    assert [one.name for one in found] == ["1L", "6R", "5L", "2R", "3L", "4R", "6L", "1R", "2L", "5R", "4L", "3R"]
    assert [one.firing for one in found] == [f"{angle}°" for angle in range(0, 720, 60)]
    assert [one.throw for one in found] == [int(one.name[0]) for one in found]


def test_both_pistons_of_a_cylinder_fire_at_once():
    found = page_pistons(result("deltic"))
    assert [one.name for one in found[:2]] == ["1A.exhaust", "1A.scavenge"]
    assert [one.firing for one in found[:4]] == ["0°", "0°", "20°", "20°"]
    assert {one.shaft for one in found} == {"main", "right", "bottom"}


def test_makers_numbers_are_those_of_the_firing_order():
    """1-3-5-7-9-2-4-6-8 (FAA-H-8083-32), where the file calls cylinder 1 the master's, and the others 1S to 8S."""
    found = page_pistons(result("r_1340"))
    assert [one.number for one in found] == list("135792468")
    assert {one.name: one.number for one in found} == {"1M": "1"} | {f"{k}S": str(k + 1) for k in range(1, 9)}
    assert {one.number for one in page_pistons(result("3d12"))} == {""}


def test_where_nothing_fires_they_stand_as_in_the_file():
    found = page_pistons(result("two_throw_compressor"))
    assert [(one.name, one.firing) for one in found] == [("1", ""), ("2", "")]


def test_one_alone_is_no_choice_and_one_throw_no_star():
    assert page_pistons(result("burning_cylinder")) == ()
    assert page_throws(result("burning_cylinder").machines[0]) == ()
    assert page_throws(result("r_1340").machines[0]) == ()


@pytest.mark.parametrize("name", example_names())
def test_throws_point_where_their_crank_pins_are_drawn(name):
    machine = result(name).machines[0]
    throws = {(one.shaft, one.number): one.direction for one in page_throws(machine)}
    drawn = machine_drawing(machine, [0.0])
    centres = {shaft.name: shaft.centre for shaft in drawn.shafts}
    pistons = {one.name for one in machine.design.pistons}
    seen = {}
    for one in drawn.mechanisms:
        if one.name in pistons:
            pin = one.pins[one.links[0].pins[1]][:, 0] - centres[one.shaft]
            seen.setdefault((one.shaft, one.throw), np.arctan2(pin[1], pin[0]))
    for throw, direction in throws.items():
        apart = direction - seen[throw]
        assert abs((apart + np.pi) % (2 * np.pi) - np.pi) < 1e-9, throw
    shafts = {shaft for shaft, _number in seen}
    assert throws.keys() == {
        one for one in seen for shaft in shafts if one[0] == shaft and sum(other[0] == shaft for other in seen) > 1
    }
