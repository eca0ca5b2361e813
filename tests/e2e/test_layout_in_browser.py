"""How a page is laid out, measured in a browser: letters are large enough and stand clear, controls are in reach."""

import re

import numpy as np
import pytest
from tests.browser import Watched
from tests.serving import served

WIDTHS = (390, 1024, 1440, 1920)
SETTLED = "() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done())))"
FAULTS = """() => {
    const found = [];
    const cut = (box, by) => {
        const [left, top] = [Math.max(box.left, by.left), Math.max(box.top, by.top)];
        const [right, bottom] = [Math.min(box.right, by.right), Math.min(box.bottom, by.bottom)];
        return { left, top, right, bottom };
    };
    const isThere = (box) => box.right - box.left > 2 && box.bottom - box.top > 3;
    const layerOf = (element) => element.closest(".turning-controls, dialog, .side, .vector") ?? document.body;
    const isRead = (parent) => !parent.closest("script, style, option, title") && parent.checkVisibility()
        && !parent.matches("details:not([open])");
    const texts = [];
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
        const [text, parent] = [node.textContent, node.parentElement];
        if (!text.trim() || !isRead(parent)) continue;
        const svg = parent.closest("svg");
        const size = parseFloat(getComputedStyle(parent).fontSize) * (svg ? svg.getScreenCTM().a : 1);
        if (size < (parent.closest("sub, sup, tspan") ? 10 : 11) - 0.05) found.push(`small: ${text} ${size}`);
        const range = document.createRange();
        range.selectNodeContents(node);
        for (let box of range.getClientRects()) {
            const room = svg ? { visible: Infinity, clip: 12 }[getComputedStyle(svg).overflow] ?? 1.5 : Infinity;
            const own = svg?.getBoundingClientRect();
            if (svg && (box.left < own.left - room || box.right > own.right + room)) found.push(`cut off: ${text}`);
            for (let over = svg?.parentElement ?? parent; over !== document.body; over = over.parentElement)
                if (getComputedStyle(over).overflowX !== "visible") box = cut(box, over.getBoundingClientRect());
            if (isThere(box)) texts.push({ text, box, layer: layerOf(parent) });
        }
    }
    texts.forEach((one, place) => {
        const others = texts.slice(place + 1).filter(({ layer }) => layer === one.layer);
        for (const { text, box } of others)
            if (isThere(cut(one.box, box))) found.push(`over each other: ${one.text} / ${text}`);
    });
    for (const one of document.querySelectorAll("body *")) {
        if (!one.checkVisibility() || one.closest("svg")) continue;
        const { overflowX } = getComputedStyle(one);
        const isField = one.matches("input[type=text]");
        if ((isField || overflowX === "hidden" || overflowX === "clip") && one.scrollWidth > one.clientWidth + 1)
            found.push(`cut off: ${one.value ?? one.textContent.slice(0, 60)}`);
    }
    if (document.documentElement.scrollWidth > innerWidth) found.push(`wide: ${document.documentElement.scrollWidth}`);
    return found;
}"""


def laid_out(page):
    """Faults of the layout, on each tab that has any."""
    found = {}
    for tab in page.locator(".tabs button").all():
        tab.click()
        page.evaluate(SETTLED)
        if faults := page.evaluate(FAULTS):
            found[tab.inner_text()] = sorted(set(faults))
    return found


@pytest.mark.parametrize("width", WIDTHS)
@pytest.mark.parametrize("name", ["3d12", "jaw_crusher", "pumping_unit_c57"])
def test_letters_are_large_enough_and_stand_clear(opened, name, width):
    assert laid_out(opened(name, "#phi=70", width=width, height=900)) == {}


def test_at_twice_the_size_nothing_is_lost(opened):
    """A window of 1440 by 900 at 200 %."""
    page = opened("3d12", "#phi=70", width=720, height=450, device_scale_factor=2)
    assert laid_out(page) == {}
    page.locator(".turning-controls .play").click(trial=True)


@pytest.mark.parametrize("width", [390, 1024, 1440])
def test_so_do_numbers_beside_it(chromium, tmp_path, width):
    with served(tmp_path) as address:
        context = chromium.new_context(viewport={"width": width, "height": 900}, reduced_motion="reduce")
        page = Watched(context, f"{address}#machine=jaw_crusher&phi=70", waits_for=".field input").page
        page.locator(".checks").wait_for()
        page.evaluate(SETTLED)
        assert page.evaluate(FAULTS) == []
        context.close()


def test_on_a_phone_what_turns_the_crank_stays_in_reach(opened):
    page = opened("3d12", "#phi=70", width=390, height=844, has_touch=True, is_mobile=True)
    for part in (0.0, 0.5, 1.0):
        page.evaluate(f"scrollTo(0, {part} * document.documentElement.scrollHeight)")
        for one in page.locator(".turning-controls > :visible").all():
            box = one.bounding_box()
            assert min(box["x"], box["y"]) >= 0, part
            assert (box["x"] + box["width"], box["y"] + box["height"]) <= (390, 844), part
    small = page.evaluate(
        """() => [...document.querySelectorAll("button, select, summary, input")].filter((one) => one.checkVisibility())
        .map((one) => [one.outerHTML.slice(0, 80), one.getBoundingClientRect()])
        .filter(([, box]) => box.height < 36 && box.width > 0).map(([html]) => html)"""
    )
    assert small == []


def test_on_a_desk_all_of_a_tab_is_seen_at_once(opened):
    page = opened("3d12", "#phi=70", width=1440, height=900)
    for part in ("h1", "svg.mechanism", ".answer tr:last-child", ".panel:last-child .plot"):
        box = page.locator(part).last.bounding_box()
        assert box["y"] + box["height"] <= 900, part


COVERED = """() => {
    const own = document.querySelector("svg.mechanism").getBoundingClientRect();
    const texts = [...document.querySelectorAll("svg.mechanism text")]
        .filter((one) => one.textContent && one.checkVisibility() && !one.closest("[hidden]"))
        .map((one) => [one.textContent, one.getBoundingClientRect()]);
    const overlap = (one, other) => Math.min(one.right, other.right) - Math.max(one.left, other.left) > 1
        && Math.min(one.bottom, other.bottom) - Math.max(one.top, other.top) > 3;
    const off = texts.filter(([, box]) => box.left < own.left - 1 || box.right > own.right + 1).map(([text]) => text);
    return [...off, ...texts.flatMap(([text, box], place) => texts.slice(place + 1)
        .filter(([, other]) => overlap(box, other)).map(([other]) => `${text} / ${other}`))];
}"""


@pytest.mark.parametrize(
    ("name", "angle"), [("eccentric_press", 350), ("10d100", 100), ("toggle_press", 0), ("deltic", 40), ("3d12", 40)]
)
def test_what_goes_along_with_the_drawing_stands_clear_of_all_words_on_it(opened, name, angle):
    page = opened(name, f"#phi={angle}&tab=Motion")
    page.evaluate(SETTLED)
    assert page.evaluate(COVERED) == []


def test_a_horsehead_is_as_far_from_its_pivot_as_the_file_says(opened):
    """64 in: its line to the scale of the bar beside, at any crank angle."""
    page = opened("pumping_unit_c57", "#phi=40")
    for _step in range(3):
        page.keyboard.press("Shift+ArrowRight")
        bar, beam = (
            page.evaluate(f"document.querySelector('svg.mechanism {path}').getAttribute('d')")
            for path in ("path.scale", "path.held")
        )
        start, end = re.search(r"M([-\d.]+) [-\d.]+H([-\d.]+)", bar).groups()
        x0, y0, x1, y1 = map(float, re.match(r"M([-\d.]+) ([-\d.]+)L([-\d.]+) ([-\d.]+)M", beam).groups())
        words = page.locator("svg.mechanism text.scale").first.text_content()
        assert words == "500 mm"
        length = 500.0 * np.hypot(x1 - x0, y1 - y0) / (float(end) - float(start))
        assert length == pytest.approx(64 * 25.4, rel=1e-3)
