"""Pins and links at the crank angle of a page: folded at first, with the figures of the kernels, in step."""

import re

import numpy as np
import pytest
from tests.browser import faults, pages
from tests.serving import served

import cranktrain as ct
from cranktrain.panels.members import members
from cranktrain.plans.placement import first_throw

FACTORS = {"mm": 1e3, "m/s": 1.0, "m/s²": 1.0, "°": 180.0 / np.pi, "rad/s": 1.0, "rad/s²": 1.0}
ANGLES = (0.0, 37.0, 101.5, 211.3, 359.0)
MACHINES = ("3d12", "r_1340", "deltic", "jaw_crusher", "shaper", "toggle_press", "lms_class5", "traction_engine")


def unfolded(page):
    """Open them; give both tables."""
    page.locator(".members summary").click()
    page.locator(".members td").first.wait_for()
    return tables(page)


def tables(page):
    """Heads and rows of both, row by row."""
    return [
        [row.locator("th, td").all_inner_texts() for row in table.locator("tr").all()]
        for table in page.locator(".members table").all()
    ]


def exact(name, angle):
    """What Python gives there, column by column as the tables have it; in SI."""
    run = ct.run(name)
    found = members(run, first_throw(run.machines[0]), np.array([angle]))
    pins = [[*one.place[:, 0], np.hypot(*one.velocity[:, 0]), np.hypot(*one.acceleration[:, 0])] for one in found.pins]
    links = [[one.direction[0] % (2 * np.pi), one.speed[0], one.acceleration[0]] for one in found.links]
    return pins, links


def number(text):
    return float(text.replace("−", "-"))


@pytest.mark.parametrize("name", MACHINES)
def test_figures_are_those_of_the_kernels_at_whole_degrees_and_between(opened, name):
    for angle in ANGLES:
        page = opened(name, f"#phi={angle}")
        assert tables(page) == []
        for (heads, *rows), expected in zip(unfolded(page), exact(name, angle), strict=True):
            assert len(rows) == len(expected)
            for (_name, *texts), values in zip(rows, expected, strict=True):
                for head, text, value in zip(heads[1:], texts, values, strict=True):
                    decimals = len(text.partition(".")[2])
                    apart = abs(number(text) - FACTORS[head.rpartition(", ")[2]] * value)
                    assert apart <= 0.501 * 10.0**-decimals, (angle, _name, head, text, value)


def test_they_go_along_with_the_crank_and_are_not_there_over_time(opened, axe):
    page = opened("compressor_start")
    at_rest = unfolded(page)
    page.keyboard.press("Shift+ArrowRight")
    assert tables(page) != at_rest
    page.keyboard.press("Home")
    assert tables(page) == at_rest
    page.evaluate(axe)
    assert faults(page) == []
    page.locator(".tabs button", has_text="Start").click()
    assert not page.locator(".members").is_visible()
    page.locator(".tabs button", has_text="Motion").click()
    assert tables(page) == at_rest


def test_of_a_crank_of_no_speed_places_and_directions_alone_are_known(chromium, tmp_path):
    path = tmp_path / "page.html"
    crank = {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "130 mm"}
    ct.run(ct.Machine(mechanism=crank)).view().save(path)
    with pages(chromium, path.as_uri()) as open_page:
        page = open_page("#phi=180")
        (pins, *rows), (links, *directions) = unfolded(page)
        assert (pins, rows[-1]) == (["pin", "X, mm", "Y, mm"], ["B", "0.0", "80.0"])
        assert (links, directions) == (["link", "direction, °"], [["crank O–A", "270.00"], ["rod A–B", "90.00"]])


def test_a_service_is_asked_for_them_when_they_are_opened_and_with_each_number(chromium, tmp_path):
    with served(tmp_path, "textbook_78x78") as address, pages(chromium, address) as open_page:
        page = open_page("#machine=textbook_78x78&phi=0")
        asked = []
        page.on("request", lambda request: asked.append(request.url) if "members" in request.url else None)
        page.locator(".answer tr").first.wait_for()
        page.keyboard.press("ArrowRight")
        assert asked == []
        before = unfolded(page)
        assert len(asked) == 1
        field = page.get_by_label("stroke", exact=True).first
        changed = float(re.match(r"[\d.]+", field.input_value())[0]) + 10.0
        field.fill(f"{changed} mm")
        field.press("Enter")
        for _wait in range(200):
            if tables(page) != before:
                break
            page.wait_for_timeout(25)
        crank = tables(page)[0][2]
        assert np.hypot(number(crank[1]), number(crank[2])) == pytest.approx(changed / 2, abs=0.1)
        assert len(asked) == 2
