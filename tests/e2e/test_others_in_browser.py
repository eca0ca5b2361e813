"""The other pistons' curves, thin: shown when somebody asks for them, and told apart where somebody points."""

import pytest
from tests.browser import faults, pages, tab_to
from tests.serving import served

import cranktrain as ct

SWITCH = ".tools button:not([hidden])"


def pressed(page):
    return page.locator(SWITCH).get_attribute("aria-pressed")


def point_at(page, which, angle, value):
    """Point at a place of a panel, found by its scale as the picture has it."""
    over = page.locator(".panel .u-over").nth(which)
    over.scroll_into_view_if_needed()
    box = over.bounding_box()
    page.mouse.move(box["x"] + box["width"] * angle, box["y"] + box["height"] * (1.0 - value))


def said(page):
    return page.locator(".whose:not([hidden])").all_inner_texts()


def test_a_page_that_stands_alone_says_whose_line_it_is(opened, axe):
    page = opened("3d12", "#phi=0&tab=Motion")
    assert pressed(page) == "false"
    point_at(page, 0, 120 / 360, 0.02)
    assert said(page) == []
    page.locator(SWITCH).click()
    assert pressed(page) == "true"
    assert page.locator(".others-hint").is_visible()
    run = ct.run("3d12")
    at_top = {
        name for name, travel in zip(run.labels["piston"], run.piston_displacement, strict=True) if travel[120] < 1e-9
    }
    point_at(page, 0, 120 / 360, 0.02)
    (who,) = said(page)
    assert at_top == set(who.split(", ")) == {"2L", "5L"}
    page.mouse.move(5, 5)
    assert said(page) == []
    page.evaluate(axe)
    assert faults(page) == []
    page.locator(SWITCH).click()
    point_at(page, 0, 120 / 360, 0.02)
    assert said(page) == []


def test_keys_reach_it(opened):
    page = opened("3d12", "#phi=0&tab=Motion")
    page.locator(".tabs button").first.focus()
    tab_to(page, SWITCH)
    page.keyboard.press("Enter")
    assert pressed(page) == "true"


def test_keys_tell_whose_each_line_is(opened):
    """One after the other, as the names that a pointer finds; arrows go on and back, Escape ends it."""
    page = opened("3d12", "#phi=0&tab=Motion")
    page.locator(SWITCH).click()
    tab_to(page, ".whose-next")
    told = []
    for key in ("Enter", "ArrowDown", "ArrowDown", "Space"):
        page.keyboard.press(key)
        (who,) = said(page)
        told.append(who)
    assert len(set(told)) == 4
    page.keyboard.press("ArrowUp")
    assert said(page) == [told[2]]
    page.keyboard.press("Escape")
    assert said(page) == []
    every = {name for who in told for name in who.split(", ")}
    assert every <= set(ct.run("3d12").labels["piston"]) - {"1L"}


def test_a_finger_s_tap_tells_whose_line_it_is_until_the_next(chromium, tmp_path):
    page_file = tmp_path / "3d12.html"
    ct.run("3d12").view().save(page_file)
    context = chromium.new_context(viewport={"width": 390, "height": 844}, has_touch=True, reduced_motion="reduce")
    page = context.new_page()
    page.goto(page_file.as_uri() + "#phi=0&tab=Motion")
    page.locator(SWITCH).tap()
    over = page.locator(".panel .u-over").first
    over.scroll_into_view_if_needed()
    page.wait_for_timeout(200)
    box = over.bounding_box()
    page.touchscreen.tap(box["x"] + box["width"] / 3, box["y"] + 0.98 * box["height"])
    assert said(page) == ["2L, 5L"]
    page.touchscreen.tap(box["x"] + box["width"] / 3, box["y"] + 0.3 * box["height"])
    assert said(page) != ["2L, 5L"]
    context.close()


@pytest.mark.parametrize(("name", "tab"), [("r_1340", "Motion"), ("3d12", "Torque"), ("shears", "Motion")])
def test_a_tab_that_shows_all_or_none_of_one_piston_has_no_switch(opened, name, tab):
    page = opened(name, f"#phi=0&tab={tab}")
    assert page.locator(SWITCH).count() == 0


def test_a_service_is_asked_for_them_when_they_are_wanted_and_after_each_edit(chromium, tmp_path):
    with served(tmp_path, "two_throw_compressor") as address, pages(chromium, address) as open_page:
        page = open_page("#machine=two_throw_compressor&phi=0&tab=Motion")
        asked = []
        page.on("request", lambda request: asked.append(request.url) if "others" in request.url else None)
        page.locator(".answer tr").first.wait_for()
        assert asked == []
        with page.expect_response("**/api/others"):
            page.locator(SWITCH).click()
        page.locator(".legend li:has-text('Other pistons')").first.wait_for()
        before = page.locator(".panel canvas").first.evaluate("one => one.toDataURL()")
        field = page.get_by_label("speed", exact=True).first
        with page.expect_response("**/api/others"):
            field.fill("777 rpm")
            field.press("Enter")
        page.wait_for_timeout(100)
        assert pressed(page) == "true"
        assert len(asked) == 2
        assert page.locator(".legend li:has-text('Other pistons')").count() >= 3
        assert page.locator(".panel canvas").nth(0).evaluate("one => one.toDataURL()") == before
        with page.expect_response("**/api/others"):
            page.locator(".pistons label").nth(1).click()
        page.locator(".legend li:has-text('Other pistons')").first.wait_for()
