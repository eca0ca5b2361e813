"""Handles on the drawing: a pin that is moved gives numbers with which it is where it was moved to."""

import tomllib

import numpy as np
import pytest
from tests.machines import RADIUS, slider

import cranktrain as ct
from cranktrain.io.examples import example_names
from cranktrain.io.machine_file import inputs_of, read_machine
from cranktrain.mechanisms import KINDS
from cranktrain.panels.handles import HANDLE_STEP, drawn_handles
from cranktrain.plans.placement import first_throw

ANGLES = np.arange(0.0, 360.0, 40 * HANDLE_STEP / 3)
PART = 0.02
"""Of a step, by which a number is changed: so little that its slope says where the pin goes."""


def handles_of(machine, declared):
    return drawn_handles(machine, first_throw(machine), declared)


def pin_of(machine, handle):
    return ct.drawing(machine, ANGLES).mechanism(handle.mechanism).pins[handle.pin]


def with_change(machine, number, by):
    return machine.with_({path: f"{number.number + by!r} {number.unit}".strip() for path in number.paths})


@pytest.mark.parametrize("name", example_names())
def test_pins_go_where_their_numbers_say(name):
    """By each number alone, at angles all round, and as much as the slope says."""
    file = read_machine(name)
    inputs = {one.path: one.given for one in inputs_of(file)}
    handles = handles_of(file.machine, tuple(inputs))
    assert handles
    at = np.rint(ANGLES / HANDLE_STEP).astype(int)
    for handle in handles:
        before = pin_of(file.machine, handle)
        assert 1 <= len(handle.numbers) <= 2
        for number in handle.numbers:
            assert {inputs[path].text for path in number.paths} == {inputs[number.paths[0]].text}
            assert number.step > 0.0
            moved = pin_of(with_change(file.machine, number, PART * number.step), handle) - before
            expected = PART * number.step * number.slope[:, at]
            known = np.isfinite(expected[0])
            assert np.any(known)
            np.testing.assert_allclose(
                moved[:, known],
                expected[:, known],
                atol=0.02 * np.max(np.abs(expected[:, known])),
                err_msg=f"{handle.pin} {number.paths}",
            )


def test_a_step_is_round_and_fine():
    """Of three figures at most where the number has them, and no more than a few thousandths of what is drawn."""
    (crank, piston) = handles_of(ct.Machine(mechanism=slider()), ("mechanism.crank_radius", "mechanism.rod_length"))
    assert (crank.pin, piston.pin) == ("A", "B")
    assert (crank.numbers[0].number, crank.numbers[0].unit, crank.numbers[0].step) == (50.0, "mm", 0.5)
    assert piston.numbers[0].step == 0.5


def test_the_crank_pin_goes_outward_with_its_radius():
    machine = ct.Machine(mechanism=slider())
    crank = handles_of(machine, ("mechanism.crank_radius",))[0]
    phi = np.deg2rad(np.arange(0.0, 360.0 + HANDLE_STEP / 2, HANDLE_STEP))
    np.testing.assert_allclose(crank.numbers[0].slope, 1e-3 * np.stack([np.sin(phi), np.cos(phi)]), atol=1e-12)


def test_a_ratio_of_the_rod_moves_the_piston_as_it_is_typed():
    """λ = R/L, so that the rod gets shorter as λ grows; at φ = 90° by the rod's lean more."""
    machine = ct.Machine(mechanism={"kind": "slider_crank", "crank_radius": "50 mm", "crank_to_rod_ratio": 0.25})
    (number,) = handles_of(machine, ("mechanism.crank_to_rod_ratio",))[0].numbers
    assert (number.unit, number.number) == ("", 0.25)
    assert number.slope[1, 0] == pytest.approx(-RADIUS / 0.25**2, rel=1e-6)
    quarter = round(90 / HANDLE_STEP)
    assert number.slope[1, quarter] == pytest.approx(-RADIUS / 0.25**2 / np.sqrt(1 - 0.25**2), rel=1e-6)


def test_numbers_that_the_file_does_not_have_are_changed_by_no_handle():
    machine = ct.Machine(mechanism=slider())
    assert handles_of(machine, ()) == ()
    paths = [path for one in handles_of(machine, ("mechanism.rod_length", "mechanism.offset")) for path in one.numbers]
    assert [path.paths for path in paths] == [("mechanism.rod_length",)]


def test_rods_side_by_side_have_their_crank_in_common():
    file = read_machine("kamaz_740")
    crank = handles_of(file.machine, [one.path for one in inputs_of(file)])[0]
    assert crank.numbers[0].paths == ("bank.R.mechanism.stroke", "bank.L.mechanism.stroke")


@pytest.mark.parametrize("name", KINDS.names)
def test_handles_of_a_kind_are_pins_of_its_drawing(name):
    kind = KINDS.named(name)
    assert kind.handles
    machine = ct.Machine(**tomllib.loads(kind.example))
    drawn = next(one for one in ct.drawing(machine, [0.0]).mechanisms if one.kind == name)
    place = next(place for place in machine.places if place.name == drawn.name)
    assert {one.pin for one in place.kind.handles} <= set(drawn.pins)
