"""Numbers of lines of equal value: none on another, on another's line, or on what is hatched."""

from itertools import combinations

import numpy as np
import pytest
from tests.machines import slider

import cranktrain as ct
from cranktrain.viz.paper.line_numbers import number_places

MACHINE = ct.Machine(mechanism=slider(crank_radius="40 mm", rod_length="136 mm"), shaft={"main": {"speed": "1500 rpm"}})


@pytest.fixture(scope="module")
def drawn():
    """Acceleration over the rod, which grows beside rods that are shorter than the crank, and over the speed."""
    vary = {"rod_length": "30..150 mm:25", "speed": "500..3000 rpm:11"}
    figure = ct.sweep(MACHINE, vary, "largest_pressure_angle").plot()
    figure.canvas.draw()
    return figure


def test_numbers_stand_clear(drawn):
    axes = drawn.axes[0]
    boxes = [text.get_window_extent() for text in axes.texts]
    assert len(boxes) > 2
    assert not any(one.overlaps(other) for one, other in combinations(boxes, 2))
    closes = axes.transData.transform((45.0, 500.0))[0]  # the first rod of 5 mm steps beyond the crank's 40
    frame = axes.get_window_extent()
    assert all(box.x0 > closes for box in boxes)
    assert all(box.x1 < frame.x1 and frame.y0 < box.y0 and box.y1 < frame.y1 for box in boxes)


def test_lines_that_crowd_have_numbers_where_they_part():
    """Of a fan through one point, each where the next are far; a line without room has none."""
    fan = [[np.array([[0.0, 0.0], [400.0, 400.0 * slope]])] for slope in (0.0, 0.25, 0.5)]
    hatched = np.array([[[0.0, -100.0], [80.0, 400.0]]])
    corners = np.array([[0.0, -100.0], [400.0, 300.0]])
    places = number_places(fan, hatched, corners, np.array([12.0, 6.0]))
    assert len(places) == 3
    for place, slope in zip(places, (0.0, 0.25, 0.5), strict=True):
        assert place[1] == pytest.approx(slope * place[0], abs=1e-9)
        assert place[0] > 92
        assert place[0] * 0.25 / np.hypot(1.0, 0.5) > 6
    near = [[np.array([[0.0, y], [400.0, y]])] for y in (0.0, 4.0, 8.0, 100.0)]
    assert [place[1] for place in number_places(near, hatched, corners, np.array([12.0, 6.0]))] == [100.0]
    assert number_places([], hatched, corners, np.array([12.0, 6.0])) == []


def test_one_value_stands_on_nothing_hatched():
    vary = {"rod_length": "30..150 mm:25", "speed": "500..3000 rpm:11"}
    figure = ct.sweep(MACHINE, vary, "stroke").plot()
    figure.canvas.draw()
    axes = figure.axes[0]
    (said,) = axes.texts
    assert said.get_text() == "80 mm"
    assert said.get_window_extent().x0 > axes.transData.transform((45.0, 500.0))[0]
