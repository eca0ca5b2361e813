"""Rams that work downward: bed, ends of the stroke, upper and lower as the machine stands."""

import matplotlib as mpl
import numpy as np
import pytest
from tests.machines import slider

import cranktrain as ct
from cranktrain.panels.sheets.motion.dead_centres import ruler_of
from cranktrain.panels.sheets.motion.sheet import drawn_scenes
from cranktrain.viz.throw.mechanism import mechanism_sketch

mpl.use("Agg")
ANGLES = np.arange(0.0, 360.0, 5.0)
PRESSES = ("high_slip_press", "shears", "eccentric_press", "servo_press", "servo_press_rocking", "toggle_press")


@pytest.mark.parametrize("name", PRESSES)
def test_ram_stands_over_its_bed_below_the_shaft(name):
    drawing = ct.drawing(ct.load(name), ANGLES)
    (one,) = drawing.mechanisms
    out, ram = one.output, one.output.ram
    assert out.along == pytest.approx([0.0, -1.0], abs=1e-12)
    face = out.foot[:, np.newaxis] + out.along[:, np.newaxis] * (
        out.along @ (one.pins[out.pin] - out.foot[:, np.newaxis]) + ram.face
    )
    bed = float((out.foot + ram.bed * out.along)[1])
    assert np.all(face[1] > bed)
    upper, lower = (float((out.foot + end * out.along)[1]) for end in ram.ends)
    assert upper > lower
    assert upper - lower == pytest.approx(out.travel[1] - out.travel[0], rel=1e-12)
    assert lower - 1e-9 <= face[1].min()
    assert face[1].max() <= upper + 1e-9
    assert np.all(one.pins[one.links[0].pins[0]][1] > face[1])


@pytest.mark.parametrize("name", PRESSES)
def test_upper_and_lower_are_where_the_pin_is_highest_and_lowest(name):
    result = ct.run(ct.load(name))
    marks = ruler_of(result).marks
    drawing = ct.drawing(ct.load(name), [mark.angle for mark in marks])
    (one,) = drawing.mechanisms
    heights = dict(zip([str(mark.word) for mark in marks], one.pins[one.output.pin][1].tolist(), strict=True))
    around = ct.drawing(ct.load(name), np.arange(0.0, 360.0, 1.0)).mechanisms[0].pins[one.output.pin][1]
    assert heights["upper"] >= around.max() - 1e-9
    assert heights["lower"] <= around.min() + 1e-9


@pytest.mark.parametrize(("angle", "words"), [("0 deg", ("upper", "lower")), ("180 deg", ("lower", "upper"))])
def test_words_go_by_how_the_machine_stands(angle, words):
    machine = ct.Machine(mechanism=slider(), angle=angle)
    assert tuple(str(mark.word) for mark in ruler_of(ct.run(machine)).marks) == words
    (one,) = ct.drawing(machine, 0.0).mechanisms
    assert (one.output.ram is not None) == (angle == "180 deg")


def test_a_lying_slider_and_an_engine_upside_down_have_their_dead_centres():
    lying = ct.Machine(mechanism=slider(), angle="90 deg")
    assert [str(mark.word) for mark in ruler_of(ct.run(lying)).marks] == ["TDC", "BDC"]
    inverted = ct.Machine(mechanism=slider(), angle="180 deg", cylinder={"bore": "80 mm"})
    assert [str(mark.word) for mark in ruler_of(ct.run(inverted)).marks] == ["TDC", "BDC"]
    assert ct.drawing(inverted, 0.0).mechanisms[0].output.ram is None


def test_the_stroke_is_dimensioned_beside_the_ram():
    result = ct.run("high_slip_press")
    (scene,) = drawn_scenes(result)
    sketch = mechanism_sketch(scene, 50.0, 7.5, [(0.0, 180.0)])
    labels = {label.text: label.position for label in sketch.labels}
    assert labels["upper 180.00°"][1] > labels["130.0 mm"][1] > labels["lower 0.00°"][1]
    (member,) = scene.members
    heights = [label[1] for label in (labels["upper 180.00°"], labels["lower 0.00°"])]
    assert heights == pytest.approx([-end for end in member.ram.ends], abs=1e-9)
    assert np.subtract(*heights) == pytest.approx(130.0, abs=1e-9)  # of the file
