"""Polar diagrams: marks of the crank angle on the curve, numbers on the rings, the largest load where it is."""

import matplotlib as mpl
import numpy as np
import pytest
from tests.words_on_paper import assert_words_are_readable

import cranktrain as ct
from cranktrain.panels.design import OneDesign
from cranktrain.panels.sheets.crankshaft.panels import bearing_diagrams
from cranktrain.plans.pin_loads import pin_loads
from cranktrain.saying.scales import scale_for
from cranktrain.viz.paper.rings import PolarRings, ring_numbers
from cranktrain.viz.paper.sketch import dots, label_outline
from cranktrain.viz.paper.style import MUTED
from cranktrain.viz.plans.pin_polar import polar_sketch

mpl.use("Agg")
MACHINES = ("3d12", "mill_engine", "vaz_21213")


@pytest.fixture(scope="module")
def results():
    return {name: ct.run(name) for name in MACHINES}


@pytest.mark.parametrize("name", MACHINES)
def test_marks_lie_on_the_first_curve_each_30_degrees(results, name):
    result = results[name]
    for one in bearing_diagrams(OneDesign(result, 0)):
        assert one.marked.tolist() == list(range(0, round(one.cycle), 30))
        places = [int(np.flatnonzero(result.crank_angle == angle)[0]) for angle in one.marked]
        size = np.max(np.abs(one.curves[0].points))
        assert np.max(np.abs(one.marks - one.curves[0].points[:, places])) <= 1e-12 * size
    bearing = 0
    loads = np.stack([result.main_bearing_load_x[0, bearing], result.main_bearing_load_y[0, bearing]])
    first = bearing_diagrams(OneDesign(result, 0))[0]
    assert np.allclose(
        first.marks, loads[:, [int(angle / result.crank_angle[1]) for angle in first.marked]], rtol=1e-12
    )


def test_marks_of_a_coarse_step_that_misses_them_lie_on_its_lines():
    result = ct.run("mill_engine", step_degrees=8.0)
    (one, *_others) = bearing_diagrams(OneDesign(result, 0))
    points = one.curves[0].points
    for angle, mark in zip(one.marked, one.marks.T, strict=True):
        before = int(angle // 8)
        start, step = points[:, before], points[:, before + 1] - points[:, before]
        across = step[0] * (mark - start)[1] - step[1] * (mark - start)[0]
        assert abs(across) <= 1e-12 * np.sum(np.abs(points).max(axis=1)) ** 2


@pytest.mark.parametrize(
    ("step", "largest", "words"), [(10.0, 47.0, ["10", "20", "30", "40"]), (0.5, 1.6, ["0.5", "1", "1.5"])]
)
def test_numbers_stand_on_their_rings_ascend_and_end_with_the_unit(step, largest, words):
    unit = scale_for("N", 1e3 * largest)
    rings = PolarRings(step, unit, scale=1e3 * largest / 60.0)  # 60 mm for the largest
    edges = np.array([-60.0, -60.0]), np.array([60.0, 60.0])
    below = np.stack([np.linspace(-50.0, 50.0, 400), np.full(400, -30.0)])
    numbers = ring_numbers(below, edges, rings)[::-1]
    assert [number.text.removesuffix(" kN") for number in numbers][: len(words)] == words
    assert numbers[-1].text.endswith(" kN")
    loads = [float(number.text.split()[0]) for number in numbers]
    assert loads == sorted(loads)
    assert [number.text for number in numbers if " " in number.text] == [numbers[-1].text]
    for number, load in zip(numbers, loads, strict=True):
        assert np.hypot(*number.position) == pytest.approx(1e3 * load / rings.scale, rel=1e-12)
        low, high = (end(label_outline(number, 1.0), axis=1)[:, np.newaxis] for end in (np.min, np.max))
        assert not np.any(np.all((below > low) & (below < high), axis=0))  # off the curve


@pytest.mark.parametrize("name", MACHINES)
@pytest.mark.parametrize("size", ["A4", "A3"])
def test_sheets_of_polar_diagrams_are_readable(results, name, size):
    for draw in (ct.viz.sheet_crankshaft, ct.viz.sheet_crankpins):
        figure = draw(results[name], size=size)
        assert_words_are_readable(figure)
        words = [text.get_text() for axes in figure.axes for text in axes.texts]
        assert any(word.endswith(("kN", "lbf")) and word.split()[0].isdecimal() for word in words)


def test_the_largest_load_is_ringed_where_the_curve_is_largest_beside_a_jump():
    loads = pin_loads(ct.load("vaz_21213"))
    unit = scale_for("N", loads.largest)
    sketch = polar_sketch(loads, (loads.on_pin, loads.on_pin_without), PolarRings(5.0, unit, 400.0))
    (ring,) = [circle for circle in sketch.circles if circle.radius > 1.0]
    assert 400.0 * np.hypot(*ring.centre) == pytest.approx(loads.largest, rel=1e-3)


def curves_on(axes, result):
    """Curves over the cycle, shape (2, n), not rings. [mm]"""
    n_points = result.crank_angle.size + 1
    lines = [line for line in axes.lines if line.get_color() != MUTED]
    return [line.get_xydata().T for line in lines if len(line.get_xdata()) == n_points]


@pytest.mark.parametrize("name", MACHINES)
def test_no_number_lies_over_a_curve(results, name):
    """Of marks and rings: the box of each on the paper, against the curves as they are drawn there."""
    for draw in (ct.viz.sheet_crankshaft, ct.viz.sheet_crankpins):
        figure = draw(results[name])
        (axes,) = figure.axes
        points = np.concatenate([dots(curve) for curve in curves_on(axes, results[name])], axis=1)
        for text in axes.texts:
            if text.get_bbox_patch() is None:
                continue  # a heading, a note, a number of a table
            (left, low), (right, high) = axes.transData.inverted().transform(text.get_window_extent())
            covered = (points[0] > left) & (points[0] < right) & (points[1] > low) & (points[1] < high)
            assert not np.any(covered), f"{text.get_text()} in {figure}"


def marks_on(result, method):
    """How many degrees apart marks are, by the larger side of their diagram on paper [mm]."""
    (axes,) = ct.viz.sheet_crankshaft(result, method=method).axes
    circles = [np.array(one.center) for one in axes.patches if getattr(one, "radius", 1.0) < 0.6]
    for curve in curves_on(axes, result):
        n = sum(np.min(np.hypot(*(curve - circle[:, np.newaxis]))) < 1e-3 for circle in circles)
        yield float(np.max(np.ptp(curve, axis=1))), round(result.crank_angle[1] * result.crank_angle.size) / n


def test_marks_are_thinned_to_what_a_diagram_has_room_for(results):
    found = [one for name in ("3d12", "vaz_21213") for one in marks_on(results[name], "all")]
    assert {step for _size, step in found} <= {30.0, 60.0, 90.0}
    assert len({step for _size, step in found}) > 1
    by_size = [step for _size, step in sorted(found)]
    assert by_size == sorted(by_size, reverse=True)  # the larger, the closer
