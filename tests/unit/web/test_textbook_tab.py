"""The tab of the textbooks: the terminal's words and figures, errors over the turn, constructions on the machine."""

from functools import cache

import numpy as np
import pytest
from tests.answers import GOOD, answered

import cranktrain as ct
from cranktrain.io.examples import EXAMPLES_FOLDER
from cranktrain.panels.construction_drawing import ConstructionDrawing, construction_drawing
from cranktrain.panels.parts import Notes
from cranktrain.panels.textbook_errors import textbook_error_panels
from cranktrain.web.page import tab_content, tab_names
from cranktrain.web.parts import PageCurves, PageSection, PageTable

EXAMPLES = sorted(path.stem for path in EXAMPLES_FOLDER.glob("*.toml"))
UNSPOKEN_OF = {"shaper", "toggle_press"}
SPOKEN_OF = [name for name in EXAMPLES if name not in UNSPOKEN_OF]


@cache
def result(name):
    return ct.run(name)


@cache
def content(name):
    """In the usual units, as the terminal's command; a page has those of the file."""
    return tab_content(result(name), "Textbook")


def parts(name, kind):
    found = [part for sheet in content(name).sheets for column in sheet.columns for part in column]
    return [part for part in found if isinstance(part, kind)]


def plain(text):
    return "".join(str(text).split())


@cache
def screen(*typed):
    answer = answered(["textbook", *typed])
    assert answer.status == GOOD, answer.errors
    return answer.output


@pytest.mark.parametrize("name", EXAMPLES)
def test_a_machine_of_which_no_text_speaks_has_no_such_tab(name):
    assert ("Textbook" in tab_names(result(name))) == (name in SPOKEN_OF)


@pytest.mark.parametrize("name", SPOKEN_OF)
def test_rows_are_those_of_the_terminal(name):
    rows = content(name).answer.rows
    told = plain(screen(name))
    for row in rows:
        assert plain(" ".join((row.name, *row.cells, row.words))) in told
    assert bool(rows) == ("Largesterrorsovertheturn" in told)


@pytest.mark.parametrize("name", SPOKEN_OF)
def test_every_number_and_sentence_of_the_sections_is_the_terminal_s(name):
    """The terminal folds lines, and tables that are wider than a screen."""
    told = plain(screen(name, "--full") + screen("errata", "--full"))
    for section in parts(name, PageSection):
        assert plain(section.heading) in told
        for part in section.parts:
            said = part.sentences if isinstance(part, Notes) else [cell for row in part.rows for cell in row]
            for one in said:
                words = str(one).split()
                assert all(plain(word) in told for word in words), one
                assert isinstance(part, PageTable) or plain(one) in told


@pytest.mark.parametrize("name", ["3d12", "r_1340", "textbook_78x78", "great_northern"])
def test_errors_over_the_turn_have_the_largest_of_the_result(name):
    """Beside the largest that the result looks for between the angles."""
    found = result(name)
    methods, pistons = found.labels["motion_method"], found.labels["piston"]
    largest = {"s": found.displacement_error, "v": found.velocity_error, "j": found.acceleration_error}
    names = {
        "two harmonics": "two_harmonics",
        "Brix's construction": "brix",
        "two harmonics of an articulated rod, derived anew": "derived",
        "two harmonics of an articulated rod, reconstructed": "reconstructed",
    }
    seen = set()
    for panels in textbook_error_panels(found):
        for panel in panels:
            for curve in panel.curves:
                form = names.get(str(curve.name), "infinite_rod")
                piston = next(one for one in pistons if f", {one}" in str(panel.title))
                expected = largest[curve.letter][methods.index(form), pistons.index(piston)]
                assert np.max(np.abs(curve.values)) == pytest.approx(expected, rel=2e-3), (panel.title, curve.name)
                seen.add(form)
    assert {"two_harmonics", "infinite_rod", "brix"} <= seen


def test_forms_of_slaves_stand_beside_each_other():
    names = {
        str(curve.name) for panels in textbook_error_panels(result("3d12")) for one in panels for curve in one.curves
    }
    assert {f"two harmonics of an articulated rod, {how}" for how in ("derived anew", "reconstructed")} <= names


@pytest.mark.parametrize("name", ["textbook_78x78", "3d12", "shaking_conveyor"])
def test_the_construction_is_on_the_drawn_machine(name):
    machine = ct.load(name)
    found = construction_drawing(machine)
    drawing = ct.drawing(machine, np.arange(0.0, 361.0, 2.0)).mechanisms[0]
    np.testing.assert_allclose(found.points["A"], drawing.pins["A"], atol=1e-12)
    np.testing.assert_allclose(found.points["B"], drawing.pins["B"], atol=1e-12)
    rod = np.hypot(*(found.points["A"] - found.points["B"]))
    np.testing.assert_allclose(np.hypot(*(found.points["C"] - found.points["B"])), rod, rtol=1e-12)
    np.testing.assert_allclose(np.hypot(*found.points["A′"]), found.radius, rtol=1e-12)


def test_readings_are_the_formulas_of_the_text():
    """R(1 − cos φ) + L(1 − √(1 − λ² sin² φ)), (334), and R(1 − cos φ_O) with φ_O = φ + asin(½λ sin φ)."""
    found = construction_drawing(ct.load("3d12"))
    radius, rod, angle = 90.0, 320.0, np.radians(np.arange(0.0, 361.0, 2.0))
    exact = radius * (1 - np.cos(angle)) + rod - np.sqrt(rod**2 - (radius * np.sin(angle)) ** 2)
    by_ray = angle + np.arcsin(radius / rod / 2 * np.sin(angle))
    expected = {"C": exact, "D": radius * (1 - np.cos(angle)), "D′": radius * (1 - np.cos(by_ray))}
    assert found.unit == "mm"
    for one in found.readings:
        np.testing.assert_allclose(one.displacement, expected[one.point], atol=1e-9)


def test_what_is_no_crank_has_no_construction():
    assert construction_drawing(ct.load("jaw_crusher")) is None
    assert parts("jaw_crusher", ConstructionDrawing) == []
    (curves,) = parts("jaw_crusher", PageCurves)
    assert [str(one.name) for one in curves.panels[0].curves] == ["exact", "(10)", "refuted"]


def test_constants_stand_side_by_side():
    section = next(one for one in parts("3d12", PageSection) if str(one.heading).startswith("Constants of (I.13)"))
    (table,) = section.parts
    assert table.heads == ("", "E", "Φ, °", "F", "Θ, °", "K, mm", "H, mm")
    assert [row[0] for row in table.rows][:2] == ["reconstructed", "derived anew"]
