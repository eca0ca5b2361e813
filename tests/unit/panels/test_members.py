"""Pins and links of a drawing: a slider-crank by closed forms, all examples by differences."""

from functools import cache

import numpy as np
import pytest
from tests.machines import RADIUS, ROD, slider

import cranktrain as ct
from cranktrain.io.examples import example_names
from cranktrain.layout.frames import in_machine_axes
from cranktrain.panels.members import members
from cranktrain.plans.placement import first_throw, frame

OMEGA = 2 * np.pi * 10
"""Of 600 rpm. [rad/s]"""
TURN = np.arange(0.0, 360.0, 5.0)
STEP = 1e-3
"""Of central differences. [deg]"""


@cache
def result(name):
    return ct.run(name)


def found(run, angles):
    return members(run, first_throw(run.machines[0]), angles)


def test_pins_and_links_of_a_slider_crank():
    """It turns clockwise from the line of stroke, which is Y."""
    run = ct.run(ct.Machine(mechanism=slider(), shaft={"main": {"speed": "600 rpm"}}))
    own, phi = found(run, TURN), np.deg2rad(TURN)
    ratio = RADIUS / ROD
    slope = np.arcsin(ratio * np.sin(phi))
    slope1 = ratio * np.cos(phi) / np.cos(slope)
    slope2 = (slope1**2 * np.sin(slope) - ratio * np.sin(phi)) / np.cos(slope)
    pins = {one.names[0]: one for one in own.pins}
    assert [(one.mechanism, *one.names, one.is_fixed) for one in own.pins] == [
        ("1", "O", True), ("1", "A", False), ("1", "B", False),
    ]  # fmt: skip
    np.testing.assert_allclose(pins["O"].place, 0.0, atol=1e-15)
    np.testing.assert_allclose(pins["A"].place, RADIUS * np.stack([np.sin(phi), np.cos(phi)]), atol=1e-15)
    np.testing.assert_allclose(pins["A"].acceleration, -(OMEGA**2) * pins["A"].place, atol=1e-9)
    along = RADIUS * np.cos(phi) + ROD * np.cos(slope)
    np.testing.assert_allclose(pins["B"].place, [0 * phi, along], atol=1e-14)
    speed = -RADIUS * np.sin(phi) - ROD * np.sin(slope) * slope1
    np.testing.assert_allclose(pins["B"].velocity, [0 * phi, OMEGA * speed], atol=1e-11)
    change = -RADIUS * np.cos(phi) - ROD * (np.cos(slope) * slope1**2 + np.sin(slope) * slope2)
    np.testing.assert_allclose(pins["B"].acceleration, [0 * phi, OMEGA**2 * change], atol=1e-9)
    crank, rod = own.links
    assert (crank.name, crank.pins, rod.name, rod.pins) == ("crank", ("O", "A"), "rod", ("A", "B"))
    np.testing.assert_allclose(crank.direction, np.pi / 2 - phi, atol=1e-12)
    np.testing.assert_allclose(crank.speed, -OMEGA, rtol=1e-12)
    np.testing.assert_allclose(crank.acceleration, 0.0, atol=1e-9)
    np.testing.assert_allclose(rod.direction, np.pi / 2 + slope, atol=1e-12)
    np.testing.assert_allclose(rod.speed, OMEGA * slope1, atol=1e-11)
    np.testing.assert_allclose(rod.acceleration, OMEGA**2 * slope2, atol=1e-9)


def test_of_what_mechanisms_share_each_stands_once():
    own = found(result("3d12"), TURN)
    assert [(one.mechanism, *one.names) for one in own.pins] == [
        ("1L", "O"), ("1L", "A"), ("1L", "B"), ("1R", "C"), ("1R", "D"),
    ]  # fmt: skip
    assert [(one.mechanism, one.name) for one in own.links] == [("1L", "crank"), ("1L", "rod"), ("1R", "rod")]


def test_what_only_shows_how_far_a_link_reaches_is_no_pin():
    own = found(result("shaper"), TURN)
    assert "lever.end" not in {name for one in own.pins for name in one.names}
    assert [one.pins for one in own.links if one.name == "lever"] == [("C", "lever.end")]


def test_a_point_of_a_rod_is_where_the_result_has_it():
    run = result("jaw_crusher")
    (own,) = [one for one in found(run, np.arange(360.0)).pins if "jaw_end" in one.names]
    assert own.names == ("B", "jaw_end")  # the file has it there
    number, machine = run.labels["point"].index("1.jaw_end"), run.machines[0]
    there = in_machine_axes(run.point_x[number], run.point_y[number], frame(machine, machine.places[0]))
    np.testing.assert_allclose(own.place, there, atol=1e-12)


@pytest.mark.parametrize("name", example_names())
def test_speeds_and_accelerations_are_changes_in_time(name):
    """By central differences, at the speed there."""
    run, angles = result(name), np.arange(3.0, 360.0, 40.0)
    here, before, after = (found(run, angles + by) for by in (0.0, -STEP, STEP))
    omega = np.abs(here.links[0].speed)  # the crank's

    def change(one, last, name):
        return (getattr(last, name) - getattr(one, name)) / np.deg2rad(2 * STEP) * omega

    for kind, rates in (("pins", {"velocity": "place", "acceleration": "velocity"}),
                        ("links", {"speed": "direction", "acceleration": "speed"})):  # fmt: skip
        every = [getattr(each, kind) for each in (here, before, after)]
        for rate, of in rates.items():
            largest = max(np.nanmax(np.abs(getattr(own, rate))) for own in every[0])
            for own, one, last in zip(*every, strict=True):
                np.testing.assert_allclose(getattr(own, rate), change(one, last, of), atol=1e-5 * largest)
