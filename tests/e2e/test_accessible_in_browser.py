"""A page for those who do not see it well or have no mouse: axe-core finds no fault, and keys reach all of it."""

import pytest
from tests.browser import faults, tab_to

SETTLED = "() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done())))"


@pytest.mark.parametrize("width", [1440, 390])
@pytest.mark.parametrize("name", ["3d12", "jaw_crusher", "burning_cylinder", "compressor_start"])
def test_no_fault_on_any_tab(opened, axe, name, width):
    page = opened(name, width=width, height=900)
    page.evaluate(axe)
    for tab in page.locator(".tabs button").all():
        tab.click()
        for button in page.locator(".numbers-of").all():
            button.click()
        page.evaluate(SETTLED)
        assert faults(page) == [], tab.inner_text()
        page.emulate_media(color_scheme="dark")
        page.wait_for_selector(":root[data-colours=dark]")
        assert faults(page, "color-contrast") == [], tab.inner_text()
        page.emulate_media(color_scheme="light")
        page.wait_for_selector(":root[data-colours=light]")


def test_each_chart_has_a_name_and_its_numbers(opened):
    page = opened("3d12")
    for tab in page.locator(".tabs button").all():
        tab.click()
        page.evaluate(SETTLED)
        names = page.evaluate(
            """() => [...document.querySelectorAll(".plot, .sheets svg:not(.sample, svg svg)")]
            .map((one) => one.role === "img" && (one.ariaLabel ?? one.querySelector("title")?.textContent))"""
        )
        assert names and all(names), tab.inner_text()
        panels = page.locator(".sheets figure.panel:not(.construction-figure)").count()
        assert page.locator(".sheets figure.panel .numbers-of").count() == panels


def test_numbers_of_a_curve_are_those_under_its_cursor(opened):
    page = opened("3d12", "#phi=60")
    panel = page.locator(".panel").first
    reading = panel.locator(".legend output").all_inner_texts()
    panel.locator(".numbers-of").click()
    rows = [row.locator("th, td").all_inner_texts() for row in panel.locator("tbody tr").all()]
    assert [row[0] for row in rows] == [f"{angle}" for angle in range(0, 361, 30)]
    assert {angle: values for angle, *values in rows}["60"] == reading
    assert panel.locator("thead th").all_inner_texts() == ["Crank angle φ, °", "1L mm", "1R mm"]
    panel.locator(".numbers-of").click()
    assert panel.locator("tbody tr").count() == 0


def test_keys_reach_every_function_of_a_page(opened):
    page = opened("3d12")
    tab_to(page, "select.colours")
    page.keyboard.press("End")
    assert page.locator(":root").get_attribute("data-colours") == "dark"
    tab_to(page, "[role=tab]")
    page.keyboard.press("ArrowRight")
    assert page.locator("[role=tab][aria-selected=true]").inner_text() == "Cylinders"
    page.keyboard.press("ArrowLeft")
    tab_to(page, ".turning-controls button[aria-label='1° on']")
    page.keyboard.press("Enter")
    page.keyboard.press("ArrowRight")
    assert page.locator("output.angle").inner_text() == "φ = 2°"
    tab_to(page, ".play", key="Shift+Tab")
    page.keyboard.press("Space")
    assert page.locator(".play").get_attribute("aria-label") == "Stop the crank"
    page.keyboard.press("Space")
    tab_to(page, ".checks summary")
    page.keyboard.press("Enter")
    assert page.locator(".checks").evaluate("one => one.open")
    tab_to(page, ".numbers-of")
    page.keyboard.press("Space")
    assert page.locator(".figures tbody tr").count() == 13
