"""Sheets of bearings, pins, wear and torque along the shaft: what they draw, and of which machines they are not."""

import numpy as np
import pytest

import cranktrain as ct
from cranktrain import viz
from cranktrain.panels.design import OneDesign
from cranktrain.panels.sheets import PICTURES
from cranktrain.panels.sheets.crankshaft.panels import (
    alike_pins,
    bearing_diagrams,
    crank_pin_diagrams,
    method_place,
    torque_panels,
)
from cranktrain.panels.sheets.wear.panels import journal_wear, pin_wear
from cranktrain.viz.paper.page import Box
from cranktrain.viz.paper.polar import cells, method_pen

SHEETS = (viz.sheet_crankshaft, viz.sheet_crankpins, viz.sheet_wear, viz.sheet_shaft_torque)


@pytest.fixture(scope="module")
def four():
    return ct.run("vaz_21213")


def words(figure):
    return [text.get_text() for axes in figure.axes for text in axes.texts]


def test_the_sheet_of_wear_is_named_among_those_of_the_crankshaft():
    named = [one.name for one in PICTURES]
    first = named.index("crankshaft")
    assert named[first : first + 4] == ["crankshaft", "crankpins", "wear", "shaft_torque"]


def test_every_method_has_a_line_of_its_own():
    """However many there are: pens do not run out."""
    lines = [(pen.width, pen.dashes) for pen in map(method_pen, range(20))]
    assert len(set(lines)) == len(lines)


def test_bearings_have_a_diagram_each_with_all_methods(four):
    diagrams = bearing_diagrams(OneDesign(four, 0))
    assert [str(one.title) for one in diagrams] == [f"Bearing {n}" for n in range(1, 6)]
    for bearing, one in enumerate(diagrams):
        first, *others = four.labels["bearing_method"]
        assert method_place(first) == 0
        assert [curve.place for curve in one.curves] == [0, *map(method_place, others)]
        np.testing.assert_array_equal(one.curves[0].points[:, 0], one.curves[0].points[:, -1])
        # What is ringed lies on the curve, as far as its points are apart.
        largest = four.largest_bearing_load[0, bearing]
        assert np.hypot(*one.largest) == pytest.approx(largest, rel=0.02)


def test_alike_pins_are_drawn_once(four):
    (pin,) = alike_pins(OneDesign(four, 0))
    assert (pin.first, pin.names) == (0, "1–4")
    on_pin, on_rod = crank_pin_diagrams(OneDesign(four, 0), pin)
    np.testing.assert_allclose(np.hypot(*on_pin.curves[0].points), np.hypot(*on_rod.curves[0].points), rtol=1e-9)
    assert on_pin.largest[1] < 0 < on_rod.largest[1]  # the gas pushes the pin toward the shaft, the rod is pushed back


def test_many_alike_pins_are_called_by_the_first():
    shown = OneDesign(ct.run("deltic"), 0)
    assert [pin.names for pin in alike_pins(shown)] == ["1A.exhaust +17", "1A.scavenge +17"]


def test_rays_count_in_the_sense_of_rotation(four):
    """On paper ray 0 is up, and 90° to the right where the shaft turns clockwise."""
    (clockwise, _rod) = pin_wear(OneDesign(four, 0))
    at = clockwise.direction
    np.testing.assert_allclose([np.cos(at[0]), np.sin(at[0]), np.cos(at[9])], [0.0, 1.0, 1.0], atol=1e-12)
    other = ct.run(ct.load("vaz_21213").with_({"rotation": "anticlockwise"}))
    bearings = [pair[1] for pair in journal_wear(OneDesign(other, 0))]
    assert all(np.cos(one.direction[9]) == pytest.approx(-1.0) for one in bearings)


def test_panels_of_torque(four):
    journals, pins = torque_panels(OneDesign(four, 0))
    assert [len(panel.curves) for panel in (journals, pins)] == [5, 4]
    thick = [curve.name for panel in (journals, pins) for curve in panel.curves if curve.role == "whole"]
    assert list(map(str, thick)) == ["journal 4", "pin 4"]


@pytest.mark.parametrize("n", [1, 2, 5, 7, 21])
def test_cells_do_not_overlap(n):
    rooms = cells(Box(10.0, 10.0, 277.0, 140.0), n, 0.7)
    assert len({(room.left, room.bottom) for room in rooms}) == n
    assert all(room.left + room.width <= 287.0 + 1e-9 and room.bottom + room.height <= 150.0 + 1e-9 for room in rooms)
    assert all(room.left >= 10.0 and room.bottom >= 10.0 - 1e-9 for room in rooms)


@pytest.mark.parametrize("sheet", SHEETS, ids=lambda sheet: sheet.__name__)
@pytest.mark.parametrize("size", ["A4", "A3"])
def test_words_stay_on_the_paper(four, sheet, size):
    figure = sheet(four, size=size)
    width, height = figure.get_size_inches() * figure.dpi
    for axes in figure.axes[:1]:
        for text in axes.texts:
            box = text.get_window_extent()
            assert box.x0 >= -1 and box.x1 <= width + 1 and box.y0 >= -1 and box.y1 <= height + 1, text.get_text()


def test_sheets_without_a_crankshaft_table():
    """Pins have loads of their own, journals and bearings need the table."""
    radial = ct.run("r_1340")
    assert any(word.startswith("Pin 1M") for word in words(viz.sheet_wear(radial)))
    assert not any("Journal" in word for word in words(viz.sheet_wear(radial)))
    with pytest.raises(ct.InputError, match=r"needs .*\[crankshaft\]"):
        viz.sheet_crankshaft(radial)
    with pytest.raises(ct.InputError, match="needs"):
        viz.sheet_crankpins(ct.run("shaper"))


def test_units_that_were_chosen():
    inches = ct.run(
        ct.load("vaz_21213").with_({"units.force": "lbf", "units.torque": "lbf·ft", "units.pressure": "psi"})
    )
    assert "Largest load, lbf" in words(viz.sheet_crankshaft(inches))
    assert "specific, psi" in words(viz.sheet_crankpins(inches))
    assert "range, lbf·ft" in words(viz.sheet_shaft_torque(inches))
