"""The sheet of a drive and the picture of a start: words that can be read, curves that are those of the results."""

import numpy as np
import pytest
from tests.unit.viz.test_pictures import assert_words_are_readable, words_of

import cranktrain as ct
from cranktrain.viz import sheet_drive
from cranktrain.viz.panel import OneDesign
from cranktrain.viz.sheets.drive.panels import drive_panels
from cranktrain.viz.sheets.drive.start import start_picture

DRIVEN = ("tilting_table", "jaw_crusher", "shears", "shaking_conveyor", "compressor_start", "high_slip_press")
RPM = np.pi / 30


def texts(drawn):
    assert_words_are_readable(drawn)
    return [text for text, _box in words_of(drawn)]


def drawn_curves(figure):
    """Values of every curve of more than two points, by the heads of their axes from above."""
    axes = [one for one in figure.axes if one.get_xlabel() == "" and len(one.lines) > 0]
    return [np.asarray(line.get_ydata(), float) for one in axes for line in one.lines if len(line.get_ydata()) > 2]


@pytest.mark.parametrize("name", DRIVEN)
@pytest.mark.parametrize("size", ["A4", "A3"])
def test_sheet_is_readable(name, size):
    words = texts(sheet_drive(ct.run(ct.load(name)), size=size))
    assert any(text.startswith("Static torque at the motor's shaft") for text in words)
    assert any(text.startswith("Torque of the motor in steady running") for text in words)
    assert "coefficient of fluctuation" in words


def test_curves_are_the_results():
    result = ct.run(ct.load("jaw_crusher"))
    static, moment, torque, speed = drive_panels(OneDesign(result, 0))
    np.testing.assert_array_equal(static.values[0, :-1], result.static_motor_torque[0])
    np.testing.assert_array_equal(moment.values[0, :-1], result.driven_flywheel_moment[0])
    assert np.all(moment.values[1] == result.gear_flywheel_moment[0])
    np.testing.assert_array_equal(torque.values[0, :-1], result.motor_torque)
    np.testing.assert_array_equal(speed.values[0, :-1], result.motor_speed)


def test_without_a_motor_there_is_what_the_load_asks():
    machine = ct.load("tilting_table").with_({"drive": {"stage": [{"ratio": 40}]}})
    words = texts(sheet_drive(ct.run(machine)))
    assert any(text.startswith("Static torque at the motor's shaft") for text in words)
    assert not any(text.startswith("Torque of the motor") for text in words)


@pytest.mark.parametrize("name", ["tilting_table", "high_slip_press"])
def test_picture_of_a_start(name):
    start = ct.start(name)
    drawn = start_picture(start)
    words = texts(drawn)
    assert ("Speed of the crank, rpm" in words) == (name == "high_slip_press")
    assert {"ends after", "turns of the crank", "energy left over, of what was put in"} <= set(words)
    curves = drawn_curves(drawn)
    for expected in (start.motor_speed / RPM, start.motor_torque):
        assert any(len(one) == len(expected) and np.allclose(one, expected, rtol=1e-12) for one in curves)


def test_a_start_without_a_motor_is_drawn():
    machine = ct.load("tilting_table").with_({"drive": {"stage": [{"ratio": 40}], "start": {"duration": "2 s"}}})
    words = texts(start_picture(ct.start(machine)))
    assert not any(text.startswith("Torque of the motor over its speed") for text in words)
