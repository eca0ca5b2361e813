"""What is found of mechanisms as they stand is the same of a changed machine as of that by itself."""

import pickle

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.io.examples import example_names
from cranktrain.io.machine_file import inputs_of, read_machine
from cranktrain.numerics.sameness import is_same
from cranktrain.panels.dead_positions import dead_positions
from cranktrain.panels.drawing_of_machine import machine_drawing
from cranktrain.plans.placement import first_throw, placed

SPEED, ROD = "shaft.main.speed", "bank.L.mechanism.rod_length"
ANGLES = np.arange(0.0, 720.0, 30.0)


def by_itself(machine):
    """The same machine, which comes from no other."""
    return pickle.loads(pickle.dumps(machine))


def drawn(machine):
    """What a page draws of it."""
    return machine_drawing(machine, ANGLES), dead_positions(machine, first_throw(machine)[0])


@pytest.mark.parametrize("name", example_names())
def test_a_changed_machine_is_drawn_as_by_itself(name):
    file = read_machine(name)
    inputs = [one for one in inputs_of(file) if one.given.si != 0.0]
    machine = file.machine.with_({})
    if not first_throw(machine):
        return
    for one in inputs[:: 1 + len(inputs) // 3]:
        value, _, unit = one.given.text.partition(" ")
        try:
            changed = machine.with_({one.path: f"{float(value) * 1.001:.9g} {unit}".strip()})
            expected = drawn(by_itself(changed))
        except (ct.InputError, ValueError):  # what has to be whole, or to fit others
            continue
        assert is_same(drawn(changed), expected), one.path
        assert is_same(drawn(changed), expected), one.path


@pytest.mark.parametrize(("path", "value", "is_kept"), [(SPEED, "1600 rpm", True), (ROD, "321 mm", False)])
def test_a_mechanism_that_stands_as_it_stood_is_not_found_again(path, value, is_kept):
    machine = ct.load("3d12").with_({})
    changed = machine.with_({path: value})
    before, after = (placed(one, first_throw(one)[0], np.array([0.0, 1.0])) for one in (machine, changed))
    assert (before is after) == is_kept
    assert (placed(changed, first_throw(changed)[0], np.array([0.0, 1.5])) is after) is False


def test_nobody_writes_to_what_is_kept_nor_is_it_what_they_asked_with():
    machine, angles = ct.load("3d12").with_({}), np.array([0.0, 1.0])
    place = first_throw(machine)[0]
    first = placed(machine, place, angles)
    for pin in first.pins.values():
        for part in (*pin.x, *pin.y):
            assert not part.flags.writeable
    angles[1] = 2.0
    found, expected = (placed(one, place, angles).positions for one in (machine, by_itself(machine)))
    assert is_same(found, expected)


def test_of_a_machine_that_was_never_changed_nothing_is_kept():
    machine = ct.load("burning_cylinder")
    place = first_throw(machine)[0]
    assert placed(machine, place, ANGLES) is not placed(machine, place, ANGLES)
    assert "alike" not in vars(machine)


def test_nothing_that_is_kept_is_sent():
    machine = ct.load("burning_cylinder").with_({SPEED: "1510 rpm"})
    drawn(machine)
    assert len(pickle.dumps(machine.alike)) < 200
