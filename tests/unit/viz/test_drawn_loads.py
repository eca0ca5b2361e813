"""Loads on the drawing of a throw: heads where they can be seen, torques on shafts as arcs in their sense."""

import matplotlib as mpl
import numpy as np
import pytest
from tests.machines import slider

import cranktrain as ct
from cranktrain.panels.throw_scene import scene_of
from cranktrain.plans.vectors import angle_of
from cranktrain.viz.throw.annotations import throw_loads

mpl.use("Agg")
TURNING = {"main": {"speed": "300 rpm"}}
FAN = {"on": "main", "torque": "5 N*m"}
MOTOR = {"on": "main", "torque": "9 N*m", "sense": "active"}
ANGLES = (0.0, 50.0, 137.0, 260.0)


def machine(loads, **more):
    return ct.Machine(mechanism=slider(), shaft=TURNING, load=loads, **more)


def marks_of(machine, angle=50.0):
    return {mark.load.name: mark for mark in throw_loads(scene_of(machine), angle)}


def swept(mark):
    """By how much an arc turns about its load's pin, anticlockwise. [rad]"""
    line, tip = mark.lines
    points = np.concatenate([line.points, tip.points[:, :1]], axis=1) - mark.load.place
    return float(np.sum(np.angle(np.exp(1j * np.diff(np.unwrap([angle_of(point) for point in points.T]))))))


@pytest.mark.parametrize("rotation", ["clockwise", "anticlockwise"])
@pytest.mark.parametrize("angle", ANGLES)
def test_torque_on_a_shaft_is_an_arc_about_it_in_the_sense_in_which_it_acts(rotation, angle):
    running = -1.0 if rotation == "clockwise" else 1.0
    marks = marks_of(machine({"fan": FAN, "motor": MOTOR}, rotation=rotation), angle)
    for name, sense in (("fan", -running), ("motor", running)):  # a fan resists, a motor drives
        line, tip = marks[name].lines
        radii = np.hypot(*line.points)
        assert np.ptp(radii) < 1e-9  # about the shaft's centre, which is the origin
        assert np.hypot(*tip.points[:, 0]) == pytest.approx(radii[0], rel=1e-12)
        assert np.sign(swept(marks[name])) == sense
        assert marks[name].load.size[0] == pytest.approx(sense * {"fan": 5.0, "motor": 9.0}[name])
    assert np.hypot(*marks["fan"].lines[0].points[:, 0]) < np.hypot(*marks["motor"].lines[0].points[:, 0])
    assert abs(swept(marks["fan"])) < abs(swept(marks["motor"]))


def test_an_arc_about_a_shaft_keeps_off_its_crank():
    scene = scene_of(machine({"fan": FAN}))
    (mark,) = throw_loads(scene, 50.0)
    crank = angle_of(scene.pins(scene.leading, 50.0)["A"])
    away = [abs(np.angle(np.exp(1j * (angle_of(point) - crank)))) for point in mark.lines[0].points.T]
    assert min(away) > np.pi / 4 - 1e-9


def test_a_torque_that_balances_the_machine_resists_and_has_no_number():
    piston = {"on": "piston", "force": "100 N", "sense": "active"}
    marks = marks_of(machine({"gas": piston, "propeller": {"on": "main", "scale": "balanced", "exponent": 2}}))
    assert swept(marks["propeller"]) > 0  # against a shaft that turns clockwise
    assert np.isnan(marks["propeller"].load.size[0])
    drawing = ct.drawing(machine({"gas": piston, "propeller": {"on": "main", "scale": "balanced"}}), [0.0, 50.0])
    (load,) = [one for one in drawing.loads if one.name == "propeller"]
    assert (load.mechanism, load.link, load.is_torque) == ("", "main", True)
    assert load.place == pytest.approx(np.zeros((2, 2)))


@pytest.mark.parametrize("size", ["800 N", "-800 N"])
@pytest.mark.parametrize("angle", ANGLES)
@pytest.mark.parametrize("below", [False, True])
def test_a_force_on_a_slider_stands_at_its_face_with_its_head_outside(size, angle, below):
    force = {"on": "piston", "force": size, "sense": "active"}
    scene = scene_of(machine({"push": force}, angle="180 deg" if below else "0 deg"))
    (mark,) = throw_loads(scene, angle)
    (member,) = scene.members
    face = member.stroke_line.at(scene.reach(member, angle) + scene.above(member))
    line, tip = mark.lines
    ends = np.stack([line.points[:, 0], tip.points[:, 0]])
    assert min(np.hypot(*(end - face)) for end in ends) < 1e-9  # one end at the face
    along = (np.concatenate([line.points, tip.points], axis=1).T - face) @ member.stroke_line.along
    assert along.min() > -1e-9  # and all of it outside the body
    direction = tip.points[:, 0] - line.points[:, 0]
    pushed = np.sign(float(direction @ member.stroke_line.along))
    assert pushed == (1.0 if size[0] != "-" else -1.0)


def test_a_load_that_is_nothing_at_the_angle_has_no_head():
    (mark,) = throw_loads(scene_of(ct.load("shears")), 50.0)
    assert [line.habit for line in mark.lines] == ["part"]
    assert mark.load.size[0] == 0.0


def test_loads_on_shafts_are_drawn_on_the_sheet_and_in_a_film():
    loaded = machine({"fan": FAN, "push": {"on": "piston", "force": "100 N"}})
    figure = ct.viz.sheet(ct.run(loaded))
    words = {text.get_text() for axes in figure.axes for text in axes.texts} | {
        text.get_text() for text in figure.texts
    }
    assert "fan 5.000 N·m" in words
