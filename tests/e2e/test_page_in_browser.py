"""A page that stands alone, in a real browser, as a person uses it."""

import re

import numpy as np
import pytest
from tests.browser import Watched

import cranktrain as ct
from cranktrain.io.examples import EXAMPLES_FOLDER
from cranktrain.web.standalone import standalone_page

EXAMPLES = sorted(path.stem for path in EXAMPLES_FOLDER.glob("*.toml"))
SETTLED = "() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done())))"
LEAST_TEXT = 10.9
"""[px]"""


def angle(page):
    return float(re.search(r"= (\d+(\.\d+)?)°", page.locator("output.angle").inner_text())[1])


def readings(page, panel):
    items = page.locator(".panel", has_text=panel).first.locator(".legend li")
    return {one.split("\n")[0].strip(): one.split("\n")[-1].strip() for one in items.all_inner_texts()}


def test_keys_turn_the_crank(opened):
    page = opened("3d12")
    assert angle(page) == 0.0
    presses = {"ArrowRight": 1, "Shift+ArrowRight": 11, "Home": 0, "Shift+ArrowLeft": 710, "ArrowLeft": 709}
    for key, expected in presses.items():
        page.keyboard.press(key)
        assert angle(page) == expected, key


def test_space_turns_and_stops_at_a_whole_degree(opened):
    page = opened("burning_cylinder")
    page.keyboard.press(" ")
    for _wait in range(100):
        page.wait_for_timeout(20)
        if angle(page) > 3.0:
            break
    page.keyboard.press(" ")
    stopped = angle(page)
    assert stopped == round(stopped) > 3
    page.wait_for_timeout(100)
    assert angle(page) == stopped


def test_tabs_by_keys_and_the_link_gives_the_same_screen(opened, written):
    page = opened("3d12", "#phi=70")
    page.locator(".tabs button").first.focus()
    for _step in range(3):
        page.keyboard.press("ArrowRight")
    assert page.locator(".tabs button[aria-selected=true]").inner_text() == "Largest forces"
    assert page.evaluate("document.activeElement.textContent") == "Largest forces"
    assert angle(page) == 70.0
    again = opened("3d12", "#" + page.url.partition("#")[2])
    assert again.locator(".tabs button[aria-selected=true]").inner_text() == "Largest forces"
    assert angle(again) == 70.0


def test_values_at_the_cursor_are_the_result_s(opened):
    page, found = opened("3d12", "#phi=137"), ct.run("3d12")
    for panel, quantity, factor in (
        ("Piston travel", "piston_displacement", 1e3),
        ("Piston velocity", "piston_velocity", 1.0),
        ("Piston acceleration", "piston_acceleration", 1.0),
    ):
        shown = readings(page, panel)
        for piston in ("1L", "1R"):
            value = factor * getattr(found, quantity)[found.labels["piston"].index(piston), 137]
            assert float(shown[piston].replace("−", "-")) == float(f"{value:.4g}"), (panel, piston)


def test_motion_over_one_turn_is_read_in_both_turns_of_a_cycle(opened):
    page = opened("3d12", "#phi=100")
    first = readings(page, "Piston velocity")
    again = readings(opened("3d12", "#phi=460"), "Piston velocity")
    assert first == again
    assert first["1L"] != "–"


def test_the_cursor_stands_at_the_crank_angle(opened):
    page = opened("3d12", "#phi=90")
    for tab in (0, 3):
        page.locator(".tabs button").nth(tab).click()
        page.evaluate(SETTLED)
        for plot in page.locator(".stack .u-over").all():
            over, cursor = plot.bounding_box(), plot.locator(".cursor").bounding_box()
            part = (cursor["x"] - over["x"]) / over["width"]
            assert part == pytest.approx(90.0 / (360.0 if tab == 0 else 720.0), abs=0.003)


def test_pointing_at_a_curve_sets_the_angle(opened):
    page = opened("burning_cylinder")
    box = page.locator(".plot .u-over").first.bounding_box()
    page.mouse.click(box["x"] + box["width"] / 4, box["y"] + box["height"] / 2)
    assert angle(page) == pytest.approx(90.0, abs=360.0 / box["width"])  # motion repeats itself each turn


def test_dragging_turns_the_crank(opened):
    page = opened("burning_cylinder")
    box = page.locator("svg.mechanism .ring").first.bounding_box()
    middle = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    around = [
        (middle[0] + 60 * np.cos(part), middle[1] + 60 * np.sin(part)) for part in np.radians(np.arange(-90, 1, 10))
    ]
    page.mouse.move(*around[0])
    page.mouse.down()
    for point in around[1:]:
        page.mouse.move(*point)
    page.mouse.up()
    assert angle(page) == pytest.approx(90.0, abs=3.0)


NAMES = "() => [...document.querySelectorAll('.mechanism circle.pin')].map((pin) => pin.textContent)"
STAND = """(angle) => {
    const slider = document.querySelector('.turning-controls input');
    slider.value = angle;
    slider.dispatchEvent(new Event('input'));
}"""
MIDDLES = """(names) => names.map((name) => {
    const all = [...document.querySelectorAll('.mechanism circle.pin')];
    const pin = all.find((one) => one.textContent === name).getBoundingClientRect();
    return [pin.x + pin.width / 2, pin.y + pin.height / 2];
})"""


PIXELS_OF_A_METRE = """() => {
    const [bar, words] = ["path", "text"].map((one) => document.querySelector(`.mechanism ${one}.scale`));
    const [, number, unit] = /^([\\d.]+) (m|mm)$/.exec(words.textContent);
    return (bar.getBBox().width * bar.getScreenCTM().a) / (number * (unit === "mm" ? 1e-3 : 1));
}"""
"""By the scale bar under the drawing."""


@pytest.mark.parametrize("name", ["3d12", "jaw_crusher", "r_1340"])
def test_drawn_to_scale(opened, name):
    """Distances between drawn pins are those of the machine within half a pixel, at every 10°."""
    page = opened(name)
    at = np.arange(0.0, 360.0, 10.0)
    first = ct.drawing(ct.load(name), at).mechanisms[0]
    pins = [pin for pin in dict.fromkeys(page.evaluate(NAMES)) if pin in first.pins][:2]
    drawn = []
    for degree in at:
        page.evaluate(STAND, degree)
        drawn.append(np.hypot(*np.subtract(*page.evaluate(MIDDLES, pins))))
    true = np.hypot(*(first.pins[pins[0]] - first.pins[pins[1]]))
    np.testing.assert_allclose(drawn, page.evaluate(PIXELS_OF_A_METRE) * true, atol=0.5)


def arrow(page, name, kind):
    """Length of a vector's arrow, in the units of the picture, and its direction, anticlockwise. [deg]"""
    shown = page.locator(f".mechanism .vector:has(title:text-is('{name}')).ink-{kind} path:not([hidden])")
    start, end = (complex(*map(float, part.split())) for part in re.split("[ML]", shown.get_attribute("d"))[1:3])
    return abs(end - start), -np.angle(end - start, deg=True)


def on_the_drawing(page):
    return page.locator(".choice[aria-pressed=true]").all_inner_texts()


def test_velocities_are_to_their_scale(opened):
    """That of the crank pin is Rω, and across the crank: 90 mm at 1500 rpm, the left bank 30° before the upright."""
    page = opened("3d12", "#phi=20")
    assert on_the_drawing(page) == ["Velocities"]
    scale = page.locator(".mechanism text.beside")
    assert scale.text_content() == "10 m/s"
    ends = re.match(r"M(\S+) \S+H([\d.-]+)", page.locator(".mechanism path.vector").get_attribute("d"))
    long = (float(ends[2]) - float(ends[1])) / 10.0
    length, direction = arrow(page, "1L A", "v")
    assert length / long == pytest.approx(0.09 * 1500 * np.pi / 30, rel=2e-3)
    assert direction == pytest.approx(30.0 - 20.0, abs=0.2)


def test_each_tab_turns_on_its_own_vectors_and_a_click_others(opened):
    page = opened("3d12", "#phi=20")
    page.locator(".tabs button", has_text="Largest forces").click()
    forces = ["Gas force", "Side force", "Crank pin", "Joints"]
    assert on_the_drawing(page) == forces
    assert page.locator(".mechanism text.beside").all_text_contents() == ["50 kN"]
    page.locator(".choice", has_text="Velocities").click()
    assert on_the_drawing(page) == ["Velocities", *forces]
    assert page.locator(".mechanism text.beside").all_text_contents() == ["10 m/s", "50 kN"]
    page.locator(".choice", has_text="Gas force").click()
    page.locator(".tabs button", has_text="Motion").click()
    assert on_the_drawing(page) == ["Velocities"]
    page.locator(".choice", has_text="Velocities").click()
    assert page.locator(".mechanism .vector").count() == 0


def test_ghosts_stand_at_the_dead_centres(opened):
    """Crank and rod of each in line with the cylinder; the key shows and hides them."""
    page = opened("burning_cylinder", "#phi=70")
    ghosts = page.locator(".mechanism .ghost > path")
    assert ghosts.count() == 0
    page.keyboard.press("g")
    ends = [
        [complex(*map(float, part.split())) for part in re.split("[ML]", one.get_attribute("d"))[1:]]
        for one in ghosts.all()
    ]
    assert len(ends) == 4
    directions = sorted({round(float(np.angle(end - start, deg=True))) % 360 for start, end in ends})
    assert directions == [90, 270]
    page.locator("button", has_text="Dead centres").click()
    assert ghosts.count() == 0


@pytest.mark.parametrize("name", EXAMPLES)
def test_every_tab_of_every_example(opened, name):
    """Something is drawn or said on each; no text is too small, nothing reaches beyond the window."""
    page = opened(name, width=1024, height=768)
    for tab in page.locator(".tabs button").all():
        tab.click()
        page.evaluate(SETTLED)
        drawn = page.locator(".sheets canvas, .sheets svg, .sheets table, .sheets p, .answers tr").count()
        assert drawn, tab.inner_text()
        assert page.evaluate("document.documentElement.scrollWidth") <= 1024, tab.inner_text()
        smallest = page.evaluate(
            """() => Math.min(...[...document.querySelectorAll('svg text')].filter((one) => one.getClientRects().length)
            .map((one) => parseFloat(getComputedStyle(one).fontSize) * one.ownerSVGElement.getScreenCTM().a))"""
        )
        assert smallest > LEAST_TEXT, tab.inner_text()


def test_the_middle_of_a_polar_diagram_is_enlarged(opened):
    page = opened("3d12", "#phi=30")
    page.locator(".tabs button", has_text="Main bearings").click()
    panel = page.locator("figure.panel", has=page.locator("svg.polar")).first
    largest = panel.locator("text.ring").all_text_contents()[-1]
    point = panel.locator("circle.now")
    before = point.get_attribute("transform")
    for factor in (2, 4, 8, 1):
        panel.locator("button.zoom").click()
        assert panel.locator("button.zoom").inner_text() == f"×{factor}"
        outer = float(panel.locator("text.ring").all_text_contents()[-1].replace("−", "-"))
        assert 0.4 * float(largest) / factor <= outer <= 2.0 * float(largest) / factor
    assert point.get_attribute("transform") == before


def test_on_a_phone_nothing_reaches_beyond_the_window(opened):
    page = opened("3d12", width=390, height=844, has_touch=True, is_mobile=True)
    for tab in page.locator(".tabs button").all():
        tab.click()
        page.evaluate(SETTLED)
        assert page.evaluate("document.documentElement.scrollWidth") <= 390, tab.inner_text()


def test_who_wants_little_motion_gets_none(opened):
    page = opened("burning_cylinder", "", reduced_motion="reduce")
    page.wait_for_timeout(150)
    assert angle(page) == 0.0


def test_the_slider_is_taken_where_it_is_put_while_the_crank_turns(opened):
    page = opened("burning_cylinder", "")
    page.wait_for_function("Number(document.querySelector('input[type=range]').value) > 3")
    page.locator("input[type=range]").fill("200")
    assert page.locator("output.angle").inner_text() == "φ = 200°"


def test_in_the_frame_of_a_notebook_it_is_the_same_page(chromium, tmp_path):
    path = tmp_path / "notebook.html"
    path.write_text(f"<!doctype html>{ct.run('burning_cylinder').view()._repr_html_()}", encoding="utf-8")
    context = chromium.new_context(viewport={"width": 1000, "height": 900}, reduced_motion="reduce")
    watched = Watched(context, path.as_uri(), waits_for="iframe")
    frame = watched.page.frame_locator("iframe")
    frame.locator(".tabs button", has_text="Torque").click()
    frame.locator("input[type=range]").fill("0")  # the frame may be made before it knows that motion is unwanted
    frame.locator("button", has_text="+1°").click()
    assert frame.locator("output.angle").inner_text() == "φ = 1°"
    assert watched.faults == []
    context.close()


def test_script_in_a_name_stays_text(opened, tmp_path, chromium):
    text = "</script><img src=x onerror=\"document.title='bad'\"><b>name</b>"
    machine = ct.load("textbook_78x78").with_({"name": text})
    path = tmp_path / "named.html"
    path.write_text(standalone_page(ct.run(machine)), encoding="utf-8")
    context = chromium.new_context()
    watched = Watched(context, path.as_uri() + "#phi=0")
    assert watched.page.title() == text
    assert watched.page.locator("h1").inner_text() == text
    assert watched.faults == []
    context.close()
