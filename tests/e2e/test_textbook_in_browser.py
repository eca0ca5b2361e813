"""The tab of the textbooks in a real browser: the construction turns with the crank, and all has room on a phone."""

import numpy as np
import pytest
from tests.browser import Watched, browser

import cranktrain as ct
from cranktrain.web.standalone import standalone_page

SETTLED = "() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done())))"
DOTS = """() => Object.fromEntries([...document.querySelectorAll('.construction text:not([hidden])')].map((text) => {
    const dot = text.previousElementSibling;
    return [text.textContent, [Number(dot.getAttribute('cx')), Number(dot.getAttribute('cy'))]];
}))"""

TURN = """(angle) => {
    const slider = document.querySelector('.turning-controls input');
    slider.value = angle;
    slider.dispatchEvent(new Event('input'));
}"""
LETTERS = """() => [...document.querySelectorAll('.construction text:not([hidden])')].map((text) => {
    const dot = text.previousElementSibling;
    return [text.getAttribute('x'), text.getAttribute('y'), dot.getAttribute('cx'), dot.getAttribute('cy')].map(Number);
})"""


@pytest.fixture(scope="module")
def chromium():
    with browser() as one:
        yield one


@pytest.fixture
def opened(chromium, tmp_path):
    contexts, found = [], []

    def open_page(name, width=1440, height=900, **more):
        path = tmp_path / f"{name}.html"
        path.write_text(standalone_page(ct.run(name)), encoding="utf-8")
        contexts.append(chromium.new_context(viewport={"width": width, "height": height}, **more))
        found.append(Watched(contexts[-1], f"{path.as_uri()}#tab=Textbook&phi=0"))
        return found[-1].page

    yield open_page
    for context in contexts:
        context.close()
    assert [fault for one in found for fault in one.faults] == []


def readings(page):
    items = page.locator(".construction-figure .legend output").all_inner_texts()
    return [float(one.removeprefix("S = ").removesuffix(" mm")) for one in items]


def test_the_construction_turns_with_the_crank(opened):
    """R = 90 mm, L = 320 mm; readings to four figures."""
    page = opened("3d12")
    assert readings(page) == [0.0, 0.0, 0.0]
    for angle in (70, 200):
        page.evaluate(TURN, angle)
        turned = np.radians(angle)
        exact = 90 * (1 - np.cos(turned)) + 320 - np.sqrt(320**2 - (90 * np.sin(turned)) ** 2)
        by_ray = 90 * (1 - np.cos(turned + np.arcsin(90 / 640 * np.sin(turned))))
        assert readings(page) == pytest.approx([exact, 90 * (1 - np.cos(turned)), by_ray], rel=6e-4)
        dots = page.evaluate(DOTS)
        pin = np.array(dots["A"])
        assert np.hypot(*pin) == pytest.approx(150.0, abs=0.05)
        # The line of stroke leans 30° to the left of upward; clockwise the crank goes to the right of it.
        assert np.degrees(np.arctan2(pin[0], -pin[1])) % 360 == pytest.approx((angle - 30) % 360, abs=0.1)


@pytest.mark.parametrize("name", ["3d12", "10d100", "jaw_crusher"])
def test_on_a_phone_nothing_reaches_beyond_the_window(opened, name):
    page = opened(name, width=390, height=844, has_touch=True, is_mobile=True)
    page.evaluate(SETTLED)
    assert page.evaluate("document.documentElement.scrollWidth") <= 390
    assert page.locator(".section").count() > 2


def test_letters_stand_by_their_points_and_clear_of_each_other(opened):
    """Even where a crank near a dead centre brings several points of the construction together."""
    page = opened("3d12")
    for angle in range(0, 360, 15):
        page.evaluate(TURN, angle)
        letters, points = np.split(np.array(page.evaluate(LETTERS)), 2, axis=1)
        assert np.hypot(*(letters - points).T).max() < 25, angle
        apart = np.hypot(*(letters[:, np.newaxis] - letters).T) + 100 * np.eye(len(letters))
        assert apart.min() > 12, angle


def test_long_words_stand_below_their_numbers_where_there_is_little_room(opened):
    page = opened("3d12", width=360)
    rows = page.locator(".answer.wordy tbody tr").all()
    assert len(rows) == 5
    for row in rows:
        number, words = row.locator(".number").first.bounding_box(), row.locator(".words").bounding_box()
        assert words["y"] >= number["y"] + number["height"] - 1
        assert words["height"] <= 3 * 20, "of three lines at most"
