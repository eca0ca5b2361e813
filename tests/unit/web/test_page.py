"""What a page has of a machine: the terminal's rows, a picture or a reason on every tab, curves of the result."""

import gzip
import json
import re
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from tests.sentences import MISSING_FOR_DIAGRAM
from tests.unit.web.test_packed import array

import cranktrain as ct
from cranktrain.io.examples import EXAMPLES_FOLDER
from cranktrain.panels.parts import Notes
from cranktrain.saying.row_words import row_words
from cranktrain.web.other_pistons import other_pistons
from cranktrain.web.packed import packed
from cranktrain.web.page import ASKED_TABS, machine_page
from cranktrain.web.parts import PageCurves, PagePolars
from cranktrain.web.standalone import standalone_page

EXAMPLES = sorted(path.stem for path in EXAMPLES_FOLDER.glob("*.toml"))


@cache
def result(name):
    return ct.run(name)


@cache
def page(name):
    return machine_page(result(name))


def parts(tab):
    return [part for sheet in tab.content.sheets for column in sheet.columns for part in column]


@pytest.mark.parametrize("name", EXAMPLES)
def test_every_row_of_the_terminal_is_on_the_page(name):
    rows = [row for _title, rows in result(name).answer_rows() for row in rows]
    others = {tab.name for tab in ASKED_TABS}
    shown = [row for tab in page(name).tabs if tab.name not in others for row in tab.content.answer.rows]
    assert [row.name for row in shown] == [str(row.name) for row in rows]
    for row, own in zip(shown, rows, strict=True):
        if len(row.cells) == 1:
            assert row_words(own).startswith(f"{row.name}: {row.cells[0]}")


def figures(words):
    """Numbers that stand in words, but for how many members there are beside a named one."""
    return set(re.findall(r"[−+]?\d+(?:\.\d+)?", re.sub(r" \+\d+\)", ")", str(words))))


@pytest.mark.parametrize("name", EXAMPLES)
def test_each_tab_with_rows_begins_with_a_sentence_whose_figures_are_theirs(name):
    for tab in page(name).tabs:
        rows = tab.content.answer.rows
        sentence = str(tab.content.sentence)
        assert bool(sentence) == bool(rows), tab.name
        told = "; ".join(" ".join((str(row.name), *row.cells, row.words)) for row in rows)
        assert figures(sentence) <= figures(told) | figures(" ".join(result(name).labels.get("piston", ()))), tab.name
        assert len(sentence) < 230, tab.name


@pytest.mark.parametrize(
    ("name", "tab", "sentence"),
    [
        ("3d12", "Motion", "Motion: stroke 180.0 mm (L), 186.7 mm (R); mean piston speed 9.000 m/s (L), 9.335 m/s (R)"),
        ("3d12", "Largest forces", "Largest forces: on a crank pin 62.38 kN at 438.3°, rod of 1L"),
        ("3d12", "Torque", "Torque: on the shaft mean 1776 N·m, 666.6 at 113.3° to 3528 N·m at 78.3°"),
        ("3d12", "Wear of crank pins", ""),
        ("shears", "Start", "Start: it ends after 7.014 s: it has run up: two cycles more at its steady speed"),
        ("shears", "Textbook", "Textbook: Δx 0.0063 %, Δv 0.016 %, Δj 0.046 % at most by (333), (336), (337),"
                               " 1: two harmonics; inside its range"),
    ],
)  # fmt: skip
def test_the_sentence_is_of_the_rows_that_say_most(name, tab, sentence):
    (own,) = [one.content.sentence for one in page(name).tabs if one.name == tab]
    assert str(own).replace("\N{NO-BREAK SPACE}", " ") == sentence


@pytest.mark.parametrize("name", EXAMPLES)
def test_every_tab_has_something_and_sheets_have_a_picture_or_a_reason(name):
    for tab in page(name).tabs:
        assert tab.content.answer.rows or parts(tab), tab.title
        for sheet in tab.content.sheets:
            assert any(column for column in sheet.columns), tab.title


@pytest.mark.parametrize("name", EXAMPLES)
def test_no_curve_is_rounding_drawn_large(name):
    """Forces of a machine that balances itself cancel: 0 is drawn, and not what is left of them by chance."""
    for tab in page(name).tabs:
        stacks = [part for part in parts(tab) if isinstance(part, PageCurves)]
        curves = [(panel.title, curve.values) for stack in stacks for panel in stack.panels for curve in panel.curves]
        for title, values in curves:
            assert not 0.0 < np.nanmax(np.abs(values), initial=0.0) < 1e-9, (tab.name, str(title))


@pytest.mark.parametrize("name", EXAMPLES)
def test_a_browser_can_take_it(name):
    found = packed(page(name))
    json.dumps(found.data, allow_nan=False)
    assert found.numbers.dtype == np.float32


@pytest.mark.parametrize("name", EXAMPLES)
def test_one_cycle_takes_a_tenth_of_a_megabyte_on_its_way_whatever_is_open(name):
    whole = page(name)
    for tab in whole.tabs:
        if tab.content.has_others:
            assert len(gzip.compress(packed(other_pistons(result(name), tab.name)).content, 1)) < 100_000, tab.name
        tabs = tuple(one if one is tab else replace(one, content=None) for one in whole.tabs)
        for sent in (tab.content, replace(whole, tabs=tabs, trust=None, members=None)):
            assert len(gzip.compress(packed(sent).content, 1)) < 100_000, tab.name
    assert len(gzip.compress(packed(whole.members).content, 1)) < 100_000


@pytest.mark.parametrize("name", ["3d12", "vaz_21213", "deltic", "r_1340"])
def test_the_largest_pages_are_below_half_a_megabyte(name):
    assert len(standalone_page(result(name)).encode()) < 500_000


def test_curves_are_those_of_the_result():
    found = result("3d12")
    (stack,) = [part for part in parts(page("3d12").tabs[0]) if isinstance(part, PageCurves)]
    travel = next(panel for panel in stack.panels if str(panel.title) == "Piston travel")
    assert travel.unit == "mm"
    place = found.labels["piston"].index("1L")
    np.testing.assert_array_equal(travel.curves[0].values[:360], 1e3 * found.piston_displacement[place][:360])


def test_polar_diagrams_of_bearings_are_in_their_unit():
    found = result("3d12")
    bearings = next(tab for tab in page("3d12").tabs if tab.name == "Main bearings")
    polars = next(part for part in parts(bearings) if isinstance(part, PagePolars))
    largest = max(float(np.hypot(*one.largest)) for one in polars.diagrams)
    assert polars.unit == "kN"
    assert largest == pytest.approx(1e-3 * float(found.largest_bearing_load.max()), rel=0.2)
    for place, one in enumerate(polars.diagrams):
        assert np.hypot(*one.largest) >= np.max(np.hypot(*one.curves[0].points)) * (1 - 1e-12)
        np.testing.assert_allclose(one.curves[0].points[0, :-1], 1e-3 * found.main_bearing_load_x[0, place], rtol=1e-14)
        assert {curve.points.shape[1] < 360 for curve in one.curves[1:]} == {True}


def test_a_sheet_that_lacks_something_says_what():
    evenness = next(tab for tab in page("textbook_78x78").tabs if str(tab.title) == "Evenness")
    (first, *_others) = parts(evenness)
    assert isinstance(first, Notes)
    assert "[evenness]" in str(first.sentences[0])


def test_the_drawing_goes_over_the_cycle_and_closes():
    drawing = page("3d12").drawing
    assert drawing.crank_angle[0] == 0.0
    assert drawing.crank_angle[-1] == page("3d12").cycle == 720.0
    for mechanism in drawing.mechanisms:
        for pin in mechanism.pins.values():
            np.testing.assert_allclose(pin[:, 0], pin[:, -1], atol=1e-15)
            np.testing.assert_allclose(pin[:, 0], pin[:, 180], atol=1e-15)


def test_words_and_units_are_those_that_are_chosen():
    from cranktrain.quantities import shown_by, units_by_dimension

    with shown_by(units_by_dimension(["in"])):
        found = packed(machine_page(result("textbook_78x78")))
    first = next(
        part
        for sheet in found.data["tabs"][0]["content"]["sheets"]
        for column in sheet["columns"]
        for part in column
        if part["is"] == "PageCurves"
    )
    travel = first["panels"][0]
    assert travel["unit"] == "in"
    assert np.max(array(found, travel["curves"][0]["values"])) == pytest.approx(78.0 / 25.4, rel=1e-4)


def test_a_page_of_another_piston_has_its_throw_and_its_curves():
    found = result("3d12")
    other = machine_page(found, "Largest forces", piston="4R")
    assert [mechanism.name for mechanism in other.drawing.mechanisms] == ["4L", "4R"]
    (own,) = [tab for tab in other.tabs if tab.content]
    curves = next(part for part in parts(own) if isinstance(part, PageCurves))
    assert "4R" in str(curves.panels[0].title)
    assert machine_page(found, "Motion", piston="no such").drawing.mechanisms[0].name == "1L"
    assert {one.name for one in other.pistons} == set(found.labels["piston"])
    assert page("burning_cylinder").pistons == ()


@pytest.mark.parametrize("name", ["pumping_unit_c57", "eccentric_press", "deltic"])
def test_what_the_file_lacks_for_two_sheets_is_said_once(name):
    (tab,) = [one for one in page(name).tabs if one.name == "Evenness"]
    lacking = [part.sentences for part in parts(tab) if isinstance(part, Notes)]
    assert [list(map(str, one)) for one in lacking] == [[f"evenness: {MISSING_FOR_DIAGRAM}[evenness] coefficient"]]
