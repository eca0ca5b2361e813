"""Coupler points on the sheet, in plans, in the moving picture and in a DXF; unlike and wide machines."""

import io

import numpy as np
import pytest
from PIL import Image
from tests.words_on_paper import assert_words_are_readable, words_of

import cranktrain as ct
from cranktrain.layout.frames import in_machine_axes
from cranktrain.panels.throw_scene import scene_of
from cranktrain.plans.placement import frame
from cranktrain.viz import (
    plan_accelerations,
    plan_arc,
    plan_brix,
    plan_brix_backward,
    plan_centres,
    plan_positions,
    plan_projection,
    plan_scheme,
    plan_velocities,
    sheet,
)
from cranktrain.viz.plans.cad import dxf
from cranktrain.viz.throw.gif import animation
from cranktrain.viz.throw.mechanism import mechanism_sketch

FOUR_BAR = {
    "kind": "crank_rocker",
    "crank_radius": "50 mm",
    "rod_length": "120 mm",
    "rocker_length": "100 mm",
    "ground_length": "140 mm",
    "points": {
        "P": {"link": "rod", "along": "60 mm", "across": "80 mm"},
        "low": {"link": "rod", "along": "200 mm", "across": "-20 mm"},
    },
}
CRANK = {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "200 mm"}


def four_bar(**more):
    return ct.Machine(**({"mechanism": FOUR_BAR, "shaft": {"main": {"speed": "60 rpm"}}} | more))


def two_stage(**bank):
    return ct.Machine(
        name="two stages",
        shaft={"main": {"throws": ["0 deg", "180 deg"], "speed": "600 rpm"}},
        bank={"A": {"mechanism": CRANK} | bank},
        cylinder={"1": {"bore": "150 mm"}, "2": {"bore": "90 mm"}},
    )


@pytest.mark.parametrize("rotation", ["clockwise", "anticlockwise"])
def test_curve_of_a_point_is_the_result_s(rotation):
    machine = four_bar(rotation=rotation)
    result = ct.run(machine)
    sketch = mechanism_sketch(scene_of(machine), 50.0, 2.0)
    curves = [line.points for line in sketch.lines if line.habit == "curve"]
    (place,) = machine.places
    for name, curve in zip(("1.P", "1.low"), curves, strict=True):
        number = result.labels["point"].index(name)
        expected = in_machine_axes(1e3 * result.point_x[number], 1e3 * result.point_y[number], frame(machine, place))
        np.testing.assert_allclose(curve[:, :-1], expected, rtol=0, atol=1e-9)
    assert [label.text for label in sketch.labels if label.text in ("P", "low")] == ["P", "low"]


def test_marks_of_a_curve_stand_at_every_thirtieth_degree():
    machine = four_bar()
    result = ct.run(machine)
    sketch = mechanism_sketch(scene_of(machine), 50.0, 2.0)
    marks = np.stack([circle.centre for circle in sketch.circles if circle.layer == "PATHS"], axis=1)
    number = result.labels["point"].index("1.P")
    path = 1e3 * np.stack([result.point_x[number], result.point_y[number]])[:, ::30]
    (place,) = machine.places
    np.testing.assert_allclose(marks[:, :12], in_machine_axes(*path, frame(machine, place)), rtol=0, atol=1e-9)
    assert [circle.fill for circle in sketch.circles if circle.layer == "PATHS"].count("ink") == 2


@pytest.mark.parametrize("angles", [[30.0, 60.0], 12, 24])
@pytest.mark.parametrize("plan", [plan_positions, plan_velocities, plan_accelerations])
def test_plans_with_points_are_readable(plan, angles):
    assert_words_are_readable(plan(four_bar(), angles))


def test_other_pictures_with_points_are_readable():
    assert_words_are_readable(plan_centres(four_bar(), [50.0]))
    assert_words_are_readable(sheet(ct.run(four_bar())))


def test_table_of_a_point_is_written():
    result = ct.run(four_bar())
    words = [text for text, _box in words_of(plan_positions(four_bar(), 12))]
    number = result.labels["point"].index("1.P")
    assert {"Point P", "Point low"} <= set(words)
    x = 1e3 * result.point_x[number, ::30]
    decimals = 3 - int(np.floor(np.log10(np.max(np.abs(x)))))  # four figures of the largest
    assert f"{x[2]:.{decimals}f}" in words


def test_points_are_in_the_dxf_and_move_in_the_gif(tmp_path):
    ezdxf = pytest.importorskip("ezdxf")
    machine = four_bar()
    result = ct.run(machine)
    dxf(machine, [0.0], tmp_path / "a.dxf")
    space = ezdxf.readfile(tmp_path / "a.dxf").modelspace()
    (place,) = machine.places
    number = result.labels["point"].index("1.P")
    expected = in_machine_axes(1e3 * result.point_x[number], 1e3 * result.point_y[number], frame(machine, place))
    paths = [np.array(one.get_points("xy")).T for one in space.query('LWPOLYLINE[layer=="PATHS"]')]
    assert any(np.allclose(path[:, :360], expected, rtol=0, atol=1e-6) for path in paths if path.shape[1] > 360)
    with Image.open(io.BytesIO(animation(result, n_frames=4))) as picture:
        assert picture.n_frames == 4


def test_unlike_throws_stand_beside_each_other():
    result = ct.run(two_stage())
    figure = sheet(result)
    assert_words_are_readable(figure)
    words = [text for text, _box in words_of(figure)]
    assert any("Throws 1, 2 of 2" in said for said in words)
    one = sheet(result, piston="2")
    assert_words_are_readable(one)
    assert any("Throw 2 of 2" in text for text, _box in words_of(one))


def test_a_wide_machine_takes_the_page_s_width():
    """Two of four panels stand at the left, two at the right; an upright one has all below each other."""
    for angle, columns in (("90 deg", 2), ("0 deg", 1)):
        crank = CRANK | {"rod_length": "300 mm"}
        bank = {"A": {"angle": angle, "mechanism": crank}}
        machine = ct.Machine(shaft={"main": {"speed": "600 rpm"}}, bank=bank, cylinder={"bore": "60 mm"})
        figure = sheet(ct.run(machine))
        assert_words_are_readable(figure)
        lefts = {round(axes.get_position().x0, 3) for axes in figure.axes[1:]}
        assert len(lefts) == columns


def test_the_scale_that_is_asked_for_is_taken():
    result = ct.run(two_stage())
    figure = sheet(result, scale=6.0)
    assert any("scale 1:6" in text for text, _box in words_of(figure))
    with pytest.raises(ct.InputError, match="too large for the paper"):
        sheet(result, scale=1.0)
    words = [text for text, _box in words_of(plan_positions(four_bar(), 4, scale=4.0))]
    assert any("scale 1:4" in text for text in words)


@pytest.mark.parametrize("rotation", ["clockwise", "anticlockwise"])
@pytest.mark.parametrize("offset", ["0 mm", "12 mm", "-12 mm"])
@pytest.mark.parametrize("plan", [plan_arc, plan_projection, plan_brix, plan_brix_backward])
def test_constructions_both_ways_round_are_readable(plan, offset, rotation):
    machine = ct.Machine(rotation=rotation, mechanism=CRANK | {"offset": offset})
    figure = plan(machine)
    assert_words_are_readable(figure)
    words = {text for text, _box in words_of(figure)}
    assert {"$A_{M}$", "$B_{M}$", "$O$"} <= words
    assert ({"$A′$", "$B′$", "$P$"} if "brix" in plan.__name__ else {"$A$", "$B$"}) <= words


@pytest.mark.parametrize("name", ["3d12", "jumo_205", "pumping_unit_c57", "vaz_21213", "r_1340", "10d100", "deltic"])
@pytest.mark.parametrize("angle", [50.0, 200.0])
def test_schemes_are_readable(name, angle):
    assert_words_are_readable(plan_scheme(ct.load(name), [angle]))


def test_a_small_crank_has_a_detail_in_plans():
    small = ct.Machine(mechanism=CRANK | {"crank_radius": "3 mm"})
    for plan in (plan_positions, plan_velocities):
        figure = plan(small, 12)
        assert_words_are_readable(figure)
        assert any(text.startswith("A (") for text, _box in words_of(figure))
