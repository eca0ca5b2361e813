"""The scheme of a throw on paper: letters inside the sheet and clear of each other."""

import pytest

from cranktrain.plans.throw_scheme import throw_scheme
from cranktrain.texts.throw_table import read_throw
from cranktrain.viz.plans.throw_scheme import throw_figure, throw_sketch

SIZES = {"l1": "14 mm", "hL": "22 mm", "l2": "15 mm", "l5": "15 mm", "hP": "24 mm", "l6": "14 mm"}
THROWS = {
    "one": SIZES | {"C3": "2 kN", "C4": "4 kN", "C1": "5 kN", "K1": "20 kN", "T1": "-3 kN"},
    "two": SIZES | {"rods": "two", "l3": "0 mm", "l4": "0 mm", "K1": "20 kN", "K2": "9 kN", "T1": "1 N", "T2": "1 kN"},
    "both ends": SIZES | {"lP1": "31 mm", "lP2": "36 mm", "C10": "1 kN", "C11": "2 kN", "C12": "1 kN", "C13": "-2 kN"},
    "no forces": SIZES,
}


@pytest.mark.parametrize("name", THROWS)
def test_letters_are_apart_and_on_the_sheet(name):
    throw = read_throw(THROWS[name])
    places = [label.position for label in throw_sketch(throw_scheme(throw), 1.0).labels]
    for i, one in enumerate(places):
        for other in places[:i]:
            assert abs(one[0] - other[0]) > 3.0 or abs(one[1] - other[1]) > 3.0
    figure = throw_figure(throw, name)
    figure.canvas.draw()
    width, height = figure.bbox.width, figure.bbox.height
    for text in figure.axes[0].texts:
        box = text.get_window_extent()
        assert box.x0 >= 0 and box.x1 <= width and box.y0 >= 0 and box.y1 <= height
