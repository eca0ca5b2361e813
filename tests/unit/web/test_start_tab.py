"""The tab of a start: the terminal's words and figures, curves and crank angles of the run, none where none can be."""

from functools import cache

import numpy as np
import pytest
from tests.answers import GOOD, answered

import cranktrain as ct
from cranktrain.io.examples import EXAMPLES_FOLDER
from cranktrain.language import Listed
from cranktrain.web import start_tab
from cranktrain.web.page import machine_page, tab_content, tab_names
from cranktrain.web.parts import EventStrip, PageCurves, PageEvents

EXAMPLES = sorted(path.stem for path in EXAMPLES_FOLDER.glob("*.toml"))
WITH_DRIVE = [name for name in EXAMPLES if ct.load(name).drive is not None]


@cache
def content(name):
    result = ct.run(name)
    with result.in_its_units():
        return tab_content(result, "Start")


def parts(name, kind):
    found = [part for sheet in content(name).sheets for column in sheet.columns for part in column]
    return [part for part in found if isinstance(part, kind)]


def plain(text):
    return " ".join(text.split())


@pytest.mark.parametrize("name", WITH_DRIVE)
def test_rows_and_events_are_those_of_the_terminal(name, monkeypatch):
    monkeypatch.setenv("COLUMNS", "1000")
    answer = answered(["start", name, "--full"])
    assert answer.status == GOOD, answer.errors
    _head, rows, events = answer.output.split("\n\n", 2)
    shown = [" ".join((row.name, *row.cells, row.label, row.words)) for row in content(name).answer.rows]
    assert plain(" ".join(shown)) == plain(rows).removeprefix("Start ")
    (listed,) = parts(name, PageEvents)
    told = [f"{one.time} {one.name}, at {one.angle}, {one.speed}" for one in listed.events]
    assert plain(" ".join(told)) == plain(events).removeprefix("Events ")


@pytest.mark.parametrize("name", EXAMPLES)
def test_what_has_no_drive_has_no_such_tab(name):
    assert ("Start" in tab_names(ct.run(name))) == (name in WITH_DRIVE)


def test_a_drive_that_moves_nothing_has_no_such_tab():
    machine = {"kind": "slider_crank", "stroke": "78 mm", "rod_length": "125 mm"}
    result = ct.run({"mechanism": machine, "drive": {"start": {"speed": "0 rpm"}}})
    assert "Start" not in tab_names(result)


@pytest.mark.parametrize("name", ["shears", "tilting_table", "compressor_start"])
def test_the_crank_turns_as_in_the_run(name):
    course, found = content(name).course, ct.start(ct.load(name))
    assert course.unit == "s"
    assert course.time[-1] == found.run.whole_time[-1]
    at_events = np.interp([event.time for event in found.events], course.time, course.crank_angle)
    np.testing.assert_allclose(at_events, np.degrees([event.angle for event in found.events]), atol=0.1)


def test_where_no_time_passes_there_are_rows_alone():
    assert content("servo_press").course is None
    assert parts("servo_press", PageCurves) == []
    assert parts("servo_press", EventStrip) == []


def test_the_reason_of_the_end_is_said():
    assert str(content("shears").sheets[0].title).endswith(str(ct.start(ct.load("shears")).run.reason))


def test_it_is_computed_when_it_is_asked_for_alone(monkeypatch):
    asked = []
    monkeypatch.setattr(start_tab, "whole_start", lambda machine: asked.append(machine) or ct.start(machine))
    result = ct.run("shears")
    for name in tab_names(result):
        asked.clear()
        machine_page(result, name)
        assert len(asked) == (name == "Start"), name


def test_a_long_run_keeps_its_largest_values(monkeypatch):
    monkeypatch.setattr(start_tab, "_MOST", 100)
    result = ct.run("compressor_start")
    with result.in_its_units():
        few = tab_content(result, "Start")
    stacks = [part for sheet in few.sheets for part in sheet.columns[0] if isinstance(part, PageCurves)]
    (whole,) = (part for part in parts("compressor_start", PageCurves) if part.is_stack)
    for own, panel in zip(stacks[0].panels, whole.panels, strict=True):
        for thin, curve in zip(own.curves, panel.curves, strict=True):
            assert thin.values.size <= 102
            assert (np.min(thin.values), np.max(thin.values)) == (np.min(curve.values), np.max(curve.values))
    assert few.course.time.size <= 100


def test_heat_is_that_of_the_facts():
    stack = next(part for part in parts("shears", PageCurves) if part.is_stack)
    heat = next(panel for panel in stack.panels if panel.symbol == "Q_m")
    assert heat.curves[0].values[-1] == pytest.approx(float(ct.start(ct.load("shears")).final_motor_heat))
    assert str(Listed((heat.title, heat.unit))) == "Heat in the motor's rotor, J"
