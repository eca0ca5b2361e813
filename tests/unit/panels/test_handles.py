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


def pin_of(machine, handle, declared):
    if handle.at is None:
        return ct.drawing(machine, ANGLES).mechanism(handle.mechanism).pins[handle.pin]
    return np.repeat(handle_of(machine, declared, handle.pin).at[:, np.newaxis], ANGLES.size, axis=1)


def handle_of(machine, declared, pin):
    return next(one for one in handles_of(machine, declared) if one.pin == pin)


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
        before = pin_of(file.machine, handle, tuple(inputs))
        assert 1 <= len(handle.numbers) <= 2
        for number in handle.numbers:
            assert {inputs[path].text for path in number.paths} == {inputs[number.paths[0]].text}
            assert number.step > 0.0
            moved = pin_of(with_change(file.machine, number, PART * number.step), handle, tuple(inputs)) - before
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
    assert {one.slides or one.pin for one in place.kind.handles} <= set(drawn.pins)


GUIDES = {
    "shaper": ("ram.guide", "mechanism.part[2].guide.direction", np.array([0.0, 0.0]), 0.23),
    "toggle_press": ("ram.guide", "mechanism.part[1].guide.direction", np.array([0.4, 0.25]), 0.0),
}
"""End of a guide, its direction in the file, and the point beside which it goes, with how far to its left. [m]"""


@pytest.mark.parametrize("name", GUIDES)
@pytest.mark.parametrize("turned", [0.0, -1.5, -4.0])
def test_a_guide_is_held_at_the_end_of_its_line(name, turned):
    """It is on the line of what slides in it, beyond all its places, as far beside its point as the file says."""
    pin, path, through, offset = GUIDES[name]
    file = read_machine(name)
    direction = {one.path: float(one.given.text.split()[0]) for one in inputs_of(file) if one.path == path}[
        path
    ] + turned
    machine = file.machine.with_({path: f"{direction!r} deg"})
    end = handle_of(machine, (path,), pin)
    (number,) = end.numbers
    assert (number.paths, number.unit) == ((path,), "deg")
    along = np.array([np.cos(np.deg2rad(direction)), np.sin(np.deg2rad(direction))])
    left = np.array([-along[1], along[0]])
    assert left @ (end.at - through) == pytest.approx(offset, abs=1e-12)
    slider = ct.drawing(machine, np.arange(360.0)).mechanism(end.mechanism).pins[end.slides]
    np.testing.assert_allclose(left @ slider, left @ end.at, atol=1e-12)
    places = along @ slider
    assert not np.min(places) <= along @ end.at <= np.max(places)


@pytest.mark.parametrize(("kind", "end", "pivot"), [("slotted_lever", "B", "C"), ("oscillating_cylinder", "D", "C")])
def test_a_rocking_guide_beside_its_pivot_is_held_at_its_end(kind, end, pivot):
    """Its line goes past the pivot at the offset, through the crank pin, and its end moves as the offset says."""
    example = tomllib.loads(KINDS.named(kind).example)
    example["mechanism"]["offset"] = "12 mm"
    machine = ct.Machine(**example)
    (held,) = (one for one in handles_of(machine, ("mechanism.offset",)) if one.pin == end)
    assert held.numbers[0].paths == ("mechanism.offset",)
    drawn = ct.drawing(machine, np.arange(0.0, 360.0, 17.0)).mechanisms[0]
    (block,) = drawn.blocks
    foot, far = (drawn.pins[name] for name in block.link)
    assert block.link[1] == end
    arm = drawn.pins[pivot] - foot
    np.testing.assert_allclose(np.hypot(*arm), 0.012, rtol=1e-12)
    np.testing.assert_allclose(np.sum(arm * (far - foot), axis=0), 0.0, atol=1e-15)
    slid = drawn.pins[block.pin] - foot
    np.testing.assert_allclose(slid[0] * (far - foot)[1] - slid[1] * (far - foot)[0], 0.0, atol=1e-12)


def test_a_yoke_of_a_chain_has_its_slot_drawn_from_end_to_end():
    """Through the block's pin and the slider's, across the guide by the slot's angle."""
    machine = ct.Machine(
        angle="-90 deg",
        rotation="anticlockwise",
        mechanism={
            "kind": "chain",
            "output": "ram",
            "crank": {"main": {"radius": "50 mm"}},
            "part": [
                {
                    "type": "yoke",
                    "pin": "main.pin",
                    "slider": "ram",
                    "guide": {"through": "O", "direction": "0 deg", "offset": "10 mm"},
                    "slot_angle": "80 deg",
                }
            ],
        },
    )
    drawn = ct.drawing(machine, np.arange(0.0, 360.0, 5.0)).mechanisms[0]
    link = next(one for one in drawn.links if not one.is_crank)
    begin, middle, end = (drawn.pins[name] for name in link.pins)
    assert {link.pins[0], link.pins[2]} <= set(drawn.ends)
    np.testing.assert_allclose(np.arctan2(*(end - begin)[::-1]), np.deg2rad(80.0), rtol=1e-12)
    length = np.hypot(*(end - begin))
    for pin in (middle, drawn.pins["main.pin"]):
        part = np.sum((pin - begin) * (end - begin), axis=0) / length**2
        np.testing.assert_allclose(begin + part * (end - begin), pin, atol=1e-12)
        assert np.all((part > 0.0) & (part < 1.0))
