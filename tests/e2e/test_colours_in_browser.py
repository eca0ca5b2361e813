"""A page in light and dark, as the system has it or as somebody chose, and on paper."""

import pytest

LIGHT, DARK = "rgb(252, 252, 250)", "rgb(20, 23, 26)"
GROUND = "() => getComputedStyle(document.body).backgroundColor"
TRAVEL = {LIGHT: [0, 90, 230], DARK: [123, 160, 232]}
"""Of curves of travel. [r, g, b]"""
HAS_COLOUR = """([r, g, b]) => {
    const canvas = document.querySelector(".plot canvas");
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    for (let place = 0; place < data.length; place += 4)
        if (data[place] === r && data[place + 1] === g && data[place + 2] === b && data[place + 3] === 255) return true;
    return false;
}"""


def are_curves_for(page, ground):
    """Whether curves have the colours of a ground."""
    other = DARK if ground == LIGHT else LIGHT
    return page.evaluate(HAS_COLOUR, TRAVEL[ground]) and not page.evaluate(HAS_COLOUR, TRAVEL[other])


def is_in(page, ground):
    """Whether a page has a ground, and its curves the colours that go with it."""
    return page.evaluate(GROUND) == ground and are_curves_for(page, ground)


@pytest.mark.parametrize(
    ("system", "ground", "choice", "chosen"), [("light", LIGHT, "dark", DARK), ("dark", DARK, "light", LIGHT)]
)
def test_the_page_is_as_the_system_until_somebody_chooses(opened, system, ground, choice, chosen):
    page = opened("burning_cylinder", color_scheme=system)
    assert is_in(page, ground)
    page.locator("select.colours").select_option(choice)
    assert is_in(page, chosen)
    page.reload()
    page.wait_for_selector(".plot canvas")
    assert page.locator("select.colours").input_value() == choice
    assert is_in(page, chosen)
    page.locator("select.colours").select_option("system")
    assert is_in(page, ground)
    page.emulate_media(color_scheme=choice)
    page.wait_for_selector(f":root[data-colours={choice}]")


def test_on_paper_it_is_light_whole_and_without_controls(opened):
    page = opened("3d12", color_scheme="dark")
    is_shown = "(query) => [...document.querySelectorAll(query)].map((one) => one.checkVisibility())"
    controls = "button[aria-selected=false], .turning-controls :is(button, input), .keys, select"
    page.emulate_media(media="print")
    page.wait_for_selector(".on-paper")
    assert are_curves_for(page, LIGHT)
    assert not any(page.evaluate(is_shown, controls))
    for part in ("h1", "[aria-selected=true]", ".answer tr", "svg.mechanism", ".plot canvas", ".angle", ".checks li"):
        shown = page.evaluate(is_shown, part)
        assert shown and all(shown), part
    widths = page.evaluate("[...document.querySelectorAll('main *')].map((one) => one.getBoundingClientRect().right)")
    assert max(widths) - page.locator("main").bounding_box()["x"] <= page.locator("main").bounding_box()["width"] + 1
    page.emulate_media(media="screen")
    page.wait_for_selector(":root:not(.on-paper)")
    assert is_in(page, DARK)
    assert not page.locator(".checks").evaluate("one => one.open")


def test_a_sheet_of_paper_takes_all_of_it(opened):
    page = opened("burning_cylinder")
    printed = page.pdf(prefer_css_page_size=True)
    assert printed.startswith(b"%PDF")
    assert 1 <= printed.count(b"/Type /Page\n") <= 3
    assert page.locator(":root").evaluate("one => one.className") == ""
