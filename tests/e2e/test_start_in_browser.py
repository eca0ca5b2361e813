"""The tab of a start in a real browser: time passes, the crank turns in it, and other tabs stay as they are."""

import re

import pytest
from tests.browser import Watched, browser
from tests.e2e.test_service_in_browser import served

import cranktrain as ct
from cranktrain.io.examples import example_names
from cranktrain.study.start import start as run_over_time
from cranktrain.web.standalone import standalone_page

SETTLED = "() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done())))"
WITH_DRIVE = [name for name in example_names() if ct.load(name).drive is not None]


@pytest.fixture(scope="module")
def chromium():
    with browser() as one:
        yield one


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    folder, found = tmp_path_factory.mktemp("starts"), {}

    def address(name):
        if name not in found:
            found[name] = folder / f"{name}.html"
            found[name].write_text(standalone_page(ct.run(name)), encoding="utf-8")
        return found[name].as_uri()

    return address


@pytest.fixture
def opened(chromium, written):
    contexts, found = [], []

    def open_page(name, place="#tab=Start&phi=0", width=1440, height=900, **more):
        contexts.append(chromium.new_context(viewport={"width": width, "height": height}, **more))
        found.append(Watched(contexts[-1], written(name) + place))
        return found[-1].page

    yield open_page
    for context in contexts:
        context.close()
    assert [fault for one in found for fault in one.faults] == []


def read(page):
    """Time and crank angle at which it stands."""
    text = page.locator("output.angle").inner_text()
    time, angle = re.fullmatch(r"t = ([\d.]+) s\s+φ = ([−\d.]+)°", text).groups()
    return float(time), float(angle.replace("−", "-"))


def speed(page):
    return float(page.locator(".panel", has_text="Speed of the motor").first.locator("output").inner_text())


def expected(name, time):
    found = run_over_time(ct.load(name), at=[time])
    return float(found.crank_angle_turned[0]) * 57.29577951308232, float(found.motor_speed[0]) * 9.549296585513721


@pytest.mark.parametrize("name", ["shears", "tilting_table"])
def test_the_link_s_moment_is_that_of_the_run(opened, name):
    page = opened(name, "#tab=Start&phi=0&t=1.5")
    angle, rpm = expected(name, 1.5)
    assert read(page) == (1.5, pytest.approx(angle, abs=0.06))
    assert speed(page) == pytest.approx(rpm, rel=1e-3)


def test_dragging_along_the_curves_goes_to_the_moment(opened):
    page = opened("shears")
    page.evaluate(SETTLED)
    assert read(page) == (0.0, 0.0)
    box = page.locator(".stack .u-over").first.bounding_box()
    y = box["y"] + box["height"] / 2
    page.mouse.move(box["x"] + 5, y)
    page.mouse.down()
    page.mouse.move(box["x"] + box["width"] / 2, y)
    page.mouse.up()
    time, angle = read(page)
    assert time == pytest.approx(7.014 / 2, abs=0.02)
    assert angle == pytest.approx(expected("shears", time)[0], abs=1.0)
    assert speed(page) == pytest.approx(expected("shears", time)[1], rel=0.01)


def test_playing_ends_at_the_end_and_keys_step(opened):
    page = opened("shears", "#tab=Start&phi=0&t=6.5")
    page.keyboard.press(" ")
    page.wait_for_function("() => document.querySelector('output.angle').textContent.startsWith('t = 7.01')")
    page.locator(".play[title='Let the start run']").wait_for()
    page.keyboard.press("Home")
    assert read(page) == (0.0, 0.0)
    page.keyboard.press("ArrowRight")
    page.keyboard.press("Shift+ArrowRight")
    assert read(page)[0] == 1.1
    page.keyboard.press("ArrowLeft")
    assert read(page)[0] == 1.0


def test_it_runs_at_real_speed_or_slower(opened):
    page = opened("shears")
    assert page.locator("select.pace option").first.inner_text() == "real speed"
    assert page.locator("select.pace").input_value() == "real speed"
    page.locator("select.pace").select_option("10 times slower")
    passed = page.evaluate(
        """async () => {
            const at = () => parseFloat(/t = ([0-9.]+)/.exec(document.querySelector('output.angle').textContent)[1]);
            document.querySelector('.play').click();
            await new Promise((done) => setTimeout(done, 300));
            const [first, begin] = [at(), performance.now()];
            await new Promise((done) => setTimeout(done, 1500));
            return (at() - first) / ((performance.now() - begin) / 1000);
        }"""
    )
    assert passed == pytest.approx(0.1, rel=0.2)


def test_an_event_leads_to_its_moment(opened):
    page = opened("shears")
    page.locator(".events button", has_text="4.019472 s").click()
    assert read(page) == (4.02, pytest.approx(209.4 + 360, abs=0.1))
    assert page.locator(".events tr:not(.to-come)").count() == 4
    page.locator(".strip .rare").click()
    assert read(page)[0] == 4.02


def test_the_drawing_is_dragged_along_the_run(opened):
    page = opened("shears", "#tab=Start&phi=0&t=1")
    before = read(page)
    box = page.locator("svg.mechanism .ring").first.bounding_box()
    middle = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(middle[0], middle[1] - 50)
    page.mouse.down()
    page.mouse.move(middle[0] + 35, middle[1] - 35, steps=4)
    page.mouse.up()
    time, angle = read(page)
    assert abs(angle - before[1]) == pytest.approx(45.0, abs=4.0)
    assert time != before[0]


def test_other_tabs_go_on_at_the_crank_s_angle(opened):
    page = opened("shears", "#tab=Start&phi=0&t=4")
    _time, angle = read(page)
    page.locator(".tabs button").first.click()
    shown = float(re.fullmatch(r"φ = ([\d.]+)°", page.locator("output.angle").inner_text())[1])
    assert shown == pytest.approx(angle % 360, abs=0.06)
    assert not page.locator("select.pace").is_visible()


@pytest.mark.parametrize("name", WITH_DRIVE)
def test_on_a_phone_nothing_reaches_beyond_the_window(opened, name):
    page = opened(name, width=390, height=844, has_touch=True, is_mobile=True)
    page.evaluate(SETTLED)
    assert page.evaluate("document.documentElement.scrollWidth") <= 390
    bar = page.locator(".turning-controls").bounding_box()
    for one in page.locator(".turning-controls > *:visible").all():
        box = one.bounding_box()
        assert bar["x"] <= box["x"]
        assert box["x"] + box["width"] <= 390


def test_the_service_computes_it_when_it_is_opened(chromium, tmp_path):
    with served(tmp_path, "shears") as address:
        context = chromium.new_context(reduced_motion="reduce")
        watched = Watched(context, address + "#phi=0")
        page, asked = watched.page, []
        page.on("request", lambda one: asked.append(one.post_data_json) if one.url.endswith("api/tab") else None)
        page.locator(".tabs button", has_text="Torque").click()
        page.locator(".sheets:visible:not(.computing)").wait_for()
        assert [one["tab"] for one in asked] == ["Torque"]
        page.locator(".tabs button", has_text="Start").click()
        page.locator(".answer", has_text="it ends after").wait_for()
        assert [one["tab"] for one in asked] == ["Torque", "Start"]
        field = page.get_by_label("mass", exact=True).first
        field.fill("800 kg")
        field.press("Enter")
        duration = float(ct.start(ct.load("shears").with_({"masses.piston.mass": "800 kg"})).start_duration)
        page.locator(".answer", has_text=f"{duration:.4g} s").wait_for()
        assert watched.faults == []
        context.close()
