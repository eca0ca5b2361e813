"""Parts are added to a chain in a real browser: by clicks on its drawing, and by keys alone."""

import tomllib

import numpy as np
import pytest
from tests.browser import Watched, faults, focused, pages
from tests.serving import served

from cranktrain.io.examples import example_text
from cranktrain.io.starting import starting_file
from cranktrain.mechanisms import KINDS

MACHINES = ("toggle_press", "chain")
LINKS = {"toggle_press": ("upper", "C", "knee"), "chain": ("lever", "C", "B")}
"""A link of each, and the pins between which it lies: a fixed point, and a joint."""
BESIDE = np.array([60.0, -40.0])
"""From a fixed point to where nothing is. [px]"""


@pytest.fixture(scope="module")
def address(tmp_path_factory):
    home = tmp_path_factory.mktemp("served")
    with served(home, "toggle_press") as one:
        yield one


@pytest.fixture
def opened(chromium, address):
    """A page of one of the machines in edit mode; the chain of the gallery is chosen there."""
    with pages(chromium, address, height=1000) as open_page:

        def editing(name):
            page = open_page("#machine=toggle_press&phi=60")
            if name == "chain":
                page.get_by_role("button", name="All machines").click()
                page.locator(".gallery button", has_text=KINDS.named("chain").title).last.click()
                page.locator("h1", has_text="My machine").wait_for()
            page.keyboard.press("e")
            page.locator(".begin").first.wait_for()
            return page

        yield editing


def text_before(name):
    return example_text("toggle_press") if name == "toggle_press" else starting_file(KINDS.named("chain"))


def text_of(page):
    """The machine file that the page gives."""
    with page.expect_download() as found:
        page.get_by_role("button", name="Save the machine file").click()
    return found.value.path().read_text(encoding="utf-8")


def middle(page, pin):
    """Where a pin is drawn. [px]"""
    dot = page.locator(f".stage :is(circle, .standing):has(> title:text-is('{pin}'))").first.bounding_box()
    return np.array([dot["x"] + dot["width"] / 2, dot["y"] + dot["height"] / 2])


def standing(page, pin):
    """Where a fixed pin is drawn: its bracket hangs below it. [px]"""
    dot = page.locator(f".stage .standing:has(> title:text-is('{pin}')) circle").first.bounding_box()
    return np.array([dot["x"] + dot["width"] / 2, dot["y"] + dot["height"] / 2])


def begun(page, part):
    page.locator(".begin", has_text=part).first.click()
    page.locator(".prompt").wait_for()


def clicked(page, at):
    page.mouse.move(*at)
    page.mouse.click(*at)


def ended(page):
    page.locator(".prompt").wait_for(state="detached")
    page.locator(".begin").first.wait_for()


@pytest.mark.parametrize("name", MACHINES)
def test_parts_are_added_where_it_is_clicked(opened, name):
    page = opened(name)
    link, fixed, joint = LINKS[name]
    begun(page, "Followed point")
    clicked(page, (standing(page, fixed) + middle(page, joint)) / 2)
    ended(page)
    ends = standing(page, fixed), middle(page, joint)
    assert np.hypot(*(middle(page, "G") - (ends[0] + ends[1]) / 2)) < 2.0

    begun(page, "Pin")
    at = standing(page, fixed) + BESIDE
    page.mouse.move(*at)
    assert page.locator(".stage .moved").inner_text() == "fixed point"
    assert page.locator(".stage .aimed.link").count() == 0
    page.mouse.move(*((2 * standing(page, fixed) + middle(page, joint)) / 3))
    assert page.locator(".stage .moved").inner_text() == f"pin on {link}"
    assert page.locator(".stage .aimed.link").count() == 1
    page.mouse.click(*((2 * standing(page, fixed) + middle(page, joint)) / 3))
    ended(page)
    ends = standing(page, fixed), middle(page, joint)
    assert np.hypot(*(middle(page, "P") - (2 * ends[0] + ends[1]) / 3)) < 2.0

    begun(page, "Pin")
    clicked(page, standing(page, fixed) + BESIDE)
    ended(page)

    begun(page, "Two links")
    clicked(page, middle(page, joint))
    clicked(page, (middle(page, joint) + standing(page, fixed)) / 2 + np.array([50.0, 0.0]))
    page.mouse.move(*standing(page, "O"))
    assert page.locator(".stage .moved").inner_text() == "on O"
    clicked(page, standing(page, fixed))
    ended(page)

    begun(page, "Link and slider")
    clicked(page, middle(page, joint))
    at = middle(page, joint) + np.array([-15.0, 70.0])
    clicked(page, at)
    clicked(page, at - np.array([0.0, 60.0]))
    ended(page)

    assert page.locator(".stage .cylinder").count() == 2, "beside the output another slider runs in its guide"

    before, after = tomllib.loads(text_before(name))["mechanism"], tomllib.loads(text_of(page))["mechanism"]
    assert after["output"] == before["output"]
    assert after["part"][: len(before["part"])] == before["part"]
    point, pair, slide = after["part"][len(before["part"]) :]
    assert (point["type"], point["link"]) == ("point", link)
    assert after["points"]["G"]["link"] == link
    assert set(after["fixed"]) == {*before["fixed"], "D"}
    assert (pair["rod"]["from"], pair["rocker"]["from"]) == (joint, fixed)
    assert (slide["rod"]["from"], slide["type"]) == (joint, "slide")
    page.locator("h1").click()
    for gone in range(1, 6):
        assert page.get_by_role("button", name="Undo").is_enabled(), gone
        page.keyboard.press("Control+z")
        page.wait_for_timeout(300)
    if name == "toggle_press":
        assert page.get_by_role("button", name="Undo").is_disabled(), "each part is one step"


def reached(page, words):
    """Go on by Tab until a button of these words is reached, and press it."""
    for _step in range(150):
        if page.evaluate("document.activeElement.textContent.trim()") == words:
            break
        page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.matches('button')"), words
    assert page.evaluate("document.activeElement.textContent.trim()") == words
    page.keyboard.press("Enter")


@pytest.mark.parametrize("name", MACHINES)
def test_parts_are_added_by_keys_alone(opened, name):
    page = opened(name)
    link, fixed, joint = LINKS[name]

    reached(page, "Followed point")
    reached(page, f"point on {link}")
    ended(page)
    assert "Followed point" in focused(page)

    reached(page, "Pin")
    reached(page, "fixed point")
    for _step in range(3):
        page.keyboard.press("Shift+ArrowUp")
    page.keyboard.press("Shift+ArrowRight")
    page.keyboard.press("ArrowRight")
    assert page.locator("output.angle").inner_text() == "φ = 60°", "keys move the cross, and not the crank"
    page.keyboard.press("Enter")
    ended(page)

    reached(page, "Two links")
    reached(page, f"on {joint}")
    page.keyboard.press("Shift+ArrowRight")
    page.keyboard.press("Shift+ArrowRight")
    page.keyboard.press("Shift+ArrowUp")
    page.keyboard.press("Enter")
    reached(page, f"on {fixed}")
    ended(page)

    reached(page, "Link and slider")
    reached(page, f"on {joint}")
    for _step in range(4):
        page.keyboard.press("Shift+ArrowDown")
    page.keyboard.press("Enter")
    page.keyboard.press("Shift+ArrowDown")
    page.keyboard.press("Enter")
    ended(page)

    after = tomllib.loads(text_of(page))["mechanism"]
    assert after["points"]["G"]["link"] == link
    assert "D" in after["fixed"]
    pair, slide = after["part"][-2:]
    assert (pair["rod"]["from"], pair["rocker"]["from"], slide["rod"]["from"]) == (joint, fixed, joint)


def test_a_slotted_slider_and_a_link_on_three_legs_are_added_by_mouse(opened):
    """What a click took decides what is asked for: of a rod where it ends, of a slider where its guide runs."""
    page = opened("toggle_press")
    begun(page, "Slotted slider")
    crank = middle(page, "main.pin")
    clicked(page, crank)
    clicked(page, crank + np.array([0.0, 50.0]))
    clicked(page, crank + np.array([90.0, 50.0]))
    ended(page)
    assert page.locator(".stage .block").count() > 0

    begun(page, "Link on three legs")
    crank, pivot = middle(page, "main.pin"), standing(page, "C")
    metre = np.hypot(*(middle(page, "knee") - crank)) / 0.32
    joints = [pivot + metre * np.array([-0.07, 0.29]), pivot + metre * np.array([0.0, 0.25])]
    for start, joint in zip((crank, pivot), joints, strict=True):
        page.mouse.move(*start)
        assert page.locator(".stage .moved").inner_text() in ("rod from main.pin", "rod from C")
        clicked(page, start)
        assert page.locator(".prompt p").inner_text() == "Where on the link does that rod end?"
        clicked(page, joint)
    assert page.locator(".stage .band").count() == 2, "a line for each leg, and none from leg to leg"
    slider = pivot + metre * np.array([0.16, 0.24])
    clicked(page, slider)
    assert page.locator(".prompt p").inner_text() == "In which direction does its guide run?"
    clicked(page, slider + metre * np.array([-0.1, 0.0]))
    ended(page)
    metre = np.hypot(*(middle(page, "knee") - middle(page, "main.pin"))) / 0.32
    assert np.hypot(*(middle(page, "B") - standing(page, "C") - metre * np.array([-0.07, 0.29]))) < 4.0

    yoke, triad = tomllib.loads(text_of(page))["mechanism"]["part"][2:]
    assert (yoke["type"], yoke["pin"], yoke["slot_angle"]) == ("yoke", "main.pin", "90 deg")
    *rods, guided = triad["leg"]
    assert [leg["rod"]["from"] for leg in rods] == ["main.pin", "C"]
    assert guided["slider"] == "slider"
    page.locator("h1").click()
    for _part in range(2):
        page.keyboard.press("Control+z")
        page.wait_for_timeout(500)
    assert page.get_by_role("button", name="Undo").is_disabled(), "each part is one step"


def test_a_rocking_guide_and_a_pin_on_a_slider_are_added_by_keys_alone(opened):
    page = opened("toggle_press")
    reached(page, "Rocking guide")
    for words in ("on main.pin", "on C", "through C"):
        reached(page, words)
    ended(page)
    assert "Rocking guide" in focused(page)

    reached(page, "Pin on a slider")
    reached(page, "slider of ram.pin")
    for _step in range(3):
        page.keyboard.press("Shift+ArrowLeft")
    page.keyboard.press("Enter")
    ended(page)

    swivel, pin = tomllib.loads(text_of(page))["mechanism"]["part"][2:]
    assert (swivel["type"], swivel["pin"]) == ("swivel", "main.pin")
    assert (swivel["guide"]["from"], swivel["guide"]["offset"]) == ("C", "0 mm")
    assert (pin["type"], pin["link"], pin["along"]) == ("point", "ram", "0 mm")


def test_a_slider_in_a_link_s_slot_is_added_by_touch(chromium, address):
    """On a small screen, where the drawing and what is asked for stand one below the other."""
    context = chromium.new_context(viewport={"width": 390, "height": 844}, has_touch=True, reduced_motion="reduce")
    watched = Watched(context, f"{address}#machine=toggle_press&phi=60")
    page = watched.page
    page.keyboard.press("e")
    page.locator(".begin", has_text="Slider in a link's slot").tap()
    page.locator(".prompt").wait_for()
    assert page.locator(".begin:visible").count() == 1, "what else may be added leaves room for the prompt"
    stage, prompt = page.locator(".stage").bounding_box(), page.locator(".prompt").bounding_box()
    assert -1 < stage["y"] < prompt["y"] < prompt["y"] + prompt["height"] <= 844
    middle_of_link = (standing(page, "C") + middle(page, "knee")) / 2
    page.touchscreen.tap(*middle_of_link)
    page.touchscreen.tap(*(middle_of_link - np.array([30.0, 0.0])))
    page.touchscreen.tap(*(middle_of_link - np.array([30.0, 40.0])))
    ended(page)
    assert page.locator(".stage .cylinder").count() == 2
    assert page.evaluate("document.documentElement.scrollWidth") == 390
    assert watched.faults == []
    context.close()


def test_escape_ends_it_and_what_cannot_close_is_said(opened, axe):
    page = opened("toggle_press")
    page.evaluate(axe)
    begun(page, "Two links")
    for back in ("Backspace", "Control+z"):
        clicked(page, middle(page, "main.pin"))
        assert page.locator(".prompt p").inner_text() == "Where do both links meet?"
        page.keyboard.press(back)
        assert page.locator(".prompt p").inner_text() == "On which pin does the first link begin?"
    clicked(page, middle(page, "main.pin"))
    page.keyboard.press("Escape")
    ended(page)
    assert "Two links" in focused(page)
    assert page.locator(".stage .marks > *").count() == 0

    begun(page, "Two links")
    assert faults(page) == []
    page.set_viewport_size({"width": 390, "height": 844})
    assert faults(page) == []
    assert page.evaluate("document.documentElement.scrollWidth") == 390
    page.set_viewport_size({"width": 1440, "height": 1000})
    clicked(page, middle(page, "main.pin"))
    clicked(page, (middle(page, "main.pin") + standing(page, "C")) / 2 + np.array([3.0, 3.0]))
    clicked(page, standing(page, "C"))
    page.locator(".prompt .problems", has_text="close").wait_for()
    assert page.locator(".prompt p").inner_text().startswith("On which pin does the second link end?")
    assert page.get_by_role("button", name="Undo").is_disabled(), "nothing was changed"
    clicked(page, middle(page, "knee"))
    page.wait_for_timeout(1500)
    page.keyboard.press("Escape")
    ended(page)
