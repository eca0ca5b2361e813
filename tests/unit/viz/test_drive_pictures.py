"""The sheet of a drive and the picture of a start: words that can be read, curves that are those of the results."""

from functools import cache

import numpy as np
import pytest
from tests.example_runs import ran
from tests.words_on_paper import assert_words_are_readable, words_of

import cranktrain as ct
from cranktrain.panels.design import OneDesign
from cranktrain.panels.sheets.drive.panels import drive_panels, steady_panels
from cranktrain.viz import sheet_drive, start_picture

DRIVEN = ("tilting_table", "jaw_crusher", "shears", "shaking_conveyor", "compressor_start", "high_slip_press")
RPM = np.pi / 30


@cache
def started(name):
    """A start of an example, computed once for all that is asked of it."""
    return ct.start(name)


@cache
def drive_of(name):
    """The sheet of an example's drive, drawn once for all that is asked of it."""
    return sheet_drive(ran(name))


@cache
def start_of(name):
    """The picture of its start."""
    return start_picture(started(name))


def texts(drawn):
    assert_words_are_readable(drawn)
    return [text for text, _box in words_of(drawn)]


STATIC = ("Static torque at the motor's shaft", "Static and constant-speed torque")
"""Titles of the panel, where inertia makes no difference and where it does."""


def drawn_curves(figure):
    """Values of every curve of more than two points, by the heads of their axes from above."""
    axes = [one for one in figure.axes if one.get_xlabel() == "" and len(one.lines) > 0]
    return [np.asarray(line.get_ydata(), float) for one in axes for line in one.lines if len(line.get_ydata()) > 2]


@pytest.mark.parametrize("name", DRIVEN)
@pytest.mark.parametrize("size", ["A4", "A3"])
def test_sheet_is_readable(name, size):
    words = texts(drive_of(name) if size == "A4" else sheet_drive(ran(name), size=size))
    assert any(text.startswith(STATIC) for text in words)
    assert any(text.startswith("Torque of the motor in steady running") for text in words)
    assert "coefficient of fluctuation" in words


def test_half_periods_are_marked():
    """The crank-rocker's dead positions, by closed form: 31.7525° and 214.6222°, 182.8696° and 177.1304° apart."""
    words = texts(drive_of("tilting_table"))
    assert {"31.75°", "214.62°", "Δφ = 182.87°", "Δφ = 177.13°"} <= set(words)
    never = texts(drive_of("jaw_crusher"))
    assert not any(text.startswith("Δφ") for text in never)


@pytest.mark.parametrize("n", [8, 36])
def test_many_half_periods_do_not_overlap(n):
    """A torque on the shaft that changes its sign n times a turn: of many changes those that have room are said."""
    angles = [360 * i / n for i in range(n + 1)]
    sizes = [100.0 * (-1) ** i for i in range(n + 1)]
    wave = {
        "on": "crank",
        "sense": "active",
        "torque": [f"{size} N*m" for size in sizes],
        "crank_angles": [f"{angle} deg" for angle in angles],
    }
    machine = ct.load("tilting_table").with_({"load": {"wave": wave}})
    words = texts(sheet_drive(ct.run(machine)))
    said = [text for text in words if text.endswith("°") and "." in text and not text.startswith("Δφ")]
    expected = [f"{360 * (i + 0.5) / n:.2f}°" for i in range(n)]
    assert set(said) == set(expected) if n == 8 else set(said) < set(expected)


def test_curves_are_the_results():
    result = ran("jaw_crusher")
    shown = OneDesign(result, 0)
    static, inertia, torque, speed = *drive_panels(shown), *steady_panels(shown)
    np.testing.assert_array_equal(static.values[0, :-1], result.static_motor_torque[0])
    np.testing.assert_array_equal(inertia.values[0, :-1], result.driven_inertia[0])
    assert np.all(inertia.values[1] == result.gear_flywheel_moment[0] / 4)
    np.testing.assert_array_equal(torque.values[0, :-1], result.motor_torque)
    np.testing.assert_array_equal(speed.values[0, :-1], result.motor_speed)


@pytest.mark.parametrize("name", DRIVEN)
def test_titles_end_before_their_keys(name):
    """The sample of a curve's line stands to the right of the panel's title."""
    figure = drive_of(name)
    boxes = [(text, box) for text, box in words_of(figure) if "shaft, " in text or "running, " in text]
    assert boxes
    (paper, *_panels) = figure.axes
    for line in paper.lines:
        start, low = paper.transData.transform(line.get_xydata()).min(axis=0)
        for text, box in boxes:
            assert not (start < box.x1 and box.y0 < low < box.y1), text


def test_without_a_motor_there_is_what_the_load_asks():
    machine = ct.load("tilting_table").with_({"drive": {"stage": [{"ratio": 40}]}})
    words = texts(sheet_drive(ct.run(machine)))
    assert any(text.startswith(STATIC) for text in words)
    assert not any(text.startswith("Torque of the motor") for text in words)


@pytest.mark.parametrize("name", DRIVEN)
def test_picture_of_a_start(name):
    start, drawn = started(name), start_of(name)
    words = texts(drawn)
    assert ("Speed of the crank, rpm" in words) == (name == "high_slip_press")
    assert {"ends after", "turns of the crank", "energy left over, of what was put in"} <= set(words)
    curves = drawn_curves(drawn)
    for expected in (start.run.whole.motor_speed / RPM, start.run.whole.motor_torque):
        assert any(len(one) == len(expected) and np.allclose(one, expected, rtol=1e-12) for one in curves)


def test_events_of_a_start_have_numbers_where_they_are_rare():
    press = texts(start_of("high_slip_press"))
    assert {"1  crank sets off", "2  clutch locks", "5  crank stands", "3", "4", "5"} <= set(press)
    assert "1,2" in press  # 0.03 s and 0.06 s of 2 s are too near to each other for a place each
    start = started("compressor_start")
    words = texts(start_of("compressor_start"))
    n_dead = sum(str(event.name) == "dead position" for event in start.events)
    assert f"dead position, dotted: {n_dead}" in words
    assert "1  98 % of its steady speed" in words


def test_a_start_that_takes_no_time_has_facts_alone():
    words = texts(start_of("servo_press"))
    assert "Start: it stands still and nothing pulls" in " ".join(words)
    assert "Time, s" not in words
    assert "1  is held" in words


def test_speeds_are_in_the_unit_that_is_chosen():
    with ct.units("rad/s"):
        words = texts(start_picture(started("high_slip_press"))) + texts(sheet_drive(ran("jaw_crusher")))
    assert {"Speed of the motor, rad/s", "Speed of the crank, rad/s"} <= set(words)
    assert any(text.endswith("N·m over rad/s") for text in words)
    assert not any(text.endswith("rpm") and text.startswith(("Speed", "Torque")) for text in words)


def test_a_start_without_a_motor_is_drawn():
    machine = ct.load("tilting_table").with_({"drive": {"stage": [{"ratio": 40}], "start": {"duration": "2 s"}}})
    words = texts(start_picture(ct.start(machine)))
    assert not any(text.startswith("Torque of the motor over its speed") for text in words)


@pytest.mark.parametrize(
    ("resistance", "speed", "said"), [(3, 1320.0, "○ rated torque, with its resistance"), (1, 1440.0, "○ rated")]
)
def test_rated_point_lies_on_the_curve(resistance, speed, said):
    """The plate's 36.47 N·m at 1440 rpm; three times the resistance slips by three times as much, 180 rpm, for them."""
    machine = ct.load("shears", set={"drive.motor.resistance_ratio": str(resistance)})
    for drawn in (sheet_drive(ct.run(machine)), start_picture(ct.start(machine))):
        assert said in texts(drawn)
        lines = [line for axes in drawn.axes for line in axes.lines]
        (curve,) = (line for line in lines if len(line.get_xdata()) == 801)
        (point,) = (line for line in curve.axes.lines if line.get_marker() == "o")
        x, y = (float(np.ravel(values)[0]) for values in point.get_data())
        assert (x, y) == (pytest.approx(speed), pytest.approx(5500 / (1440 * RPM)))
        assert np.interp(x, *curve.get_data()) == pytest.approx(y, rel=1e-4)


def test_numbers_of_a_start_do_not_depend_on_the_interval():
    """Of one that rolls back, with its torque and its end between whole seconds."""
    machine = ct.load("tilting_table").with_({"drive.motor.breakdown_torque": "30 N*m"})
    seldom = ct.start(machine.with_({"drive.start.interval": "1 s"}))
    often, few = texts(start_picture(ct.start(machine))), texts(start_picture(seldom))
    numbers = few[few.index("The start") : few.index("energy left over, of what was put in")]
    assert numbers == often[often.index("The start") : often.index("energy left over, of what was put in")]


def test_heat_that_nothing_is_known_of_is_not_0():
    assert "heat in the motor" not in texts(start_of("servo_press"))
    assert "heat in the motor" in texts(start_of("tilting_table"))


def test_a_sheet_without_a_speed_begins_with_a_capital():
    from cranktrain.viz.paper.head import running_words

    assert running_words(ct.load("servo_press")) == "Clockwise"
    assert running_words(ct.load("shears")) == "n = 40 rpm, clockwise"


@pytest.mark.parametrize("name", ["servo_press", "servo_press_rocking"])
def test_sheet_of_a_wanted_motion_has_the_way_that_its_motor_goes(name):
    """Power is torque times speed: the largest on the way is the result's, and none of steady running stands beside."""
    motor = {"kind": "servo", "power": "40 kW", "speed": "2000 rpm", "peak_torque": "600 N*m", "peak_power": "90 kW"}
    result = ct.run(ct.load(name).with_({"drive.motor": motor}))
    drawn = sheet_drive(result)
    words = texts(drawn)
    assert {"wanted motion", "energy taken back in a period"} <= set(words)
    assert not any("steady running" in text for text in words)
    loop = drawn.axes[1]
    curves = [line for line in loop.lines if len(line.get_xdata()) > 2]
    limits, (way,) = ([one for one in curves if (one.get_linestyle() == "-") is solid] for solid in (False, True))
    speed, torque = (np.asarray(part) for part in way.get_data())
    peak = float(result.servo_peak_power if name == "servo_press" else result.rocking_peak_power)
    assert np.max(np.abs(speed * RPM * torque)) == pytest.approx(peak, rel=5e-4)
    for line, sign in zip(limits, (1, -1), strict=True):
        turned, allowed = (np.asarray(part) for part in line.get_data())
        np.testing.assert_allclose(allowed, sign * np.minimum(600, 90e3 / np.maximum(np.abs(turned) * RPM, 1e-9)))


def test_sheet_of_a_wanted_motion_needs_no_motor():
    words = texts(drive_of("servo_press"))
    assert "wanted motion" in words
    assert not any(text.startswith("○") for text in words)
