"""The tab where numbers are varied: curves over one, maps over two, as `cranktrain sweep` has them; clicks load."""

import pytest
from tests.browser import pages
from tests.serving import served

import cranktrain as ct

SPEED = "shaft.main.speed"


@pytest.fixture(scope="module")
def address(tmp_path_factory):
    with served(tmp_path_factory.mktemp("served"), "burning_cylinder") as one:
        yield one


@pytest.fixture
def page(chromium, address):
    with pages(chromium, address, ".facts label", height=1100) as open_page:
        yield open_page("#phi=0&tab=Design")


def vary(page, place, path, start, end, count):
    axis = page.locator(".design .axis").nth(place)
    axis.locator("select").select_option(path)
    for field, value in zip(axis.locator("input").all(), (start, end, count), strict=True):
        field.fill(value)


def want(page, *names):
    chosen = page.locator(".facts input:checked")
    while chosen.count():
        chosen.first.uncheck()
    for name in names:
        page.locator(f".facts input[value={name}]").check()


def compute(page):
    page.locator(".design button[type=submit]").click()
    page.locator(".swept figure").first.wait_for(timeout=60_000)


def paths(page):
    return page.locator(".design .axis select").first.evaluate("one => [...one.options].map(option => option.value)")


def test_a_range_about_the_present_number_is_proposed(page):
    (speed,) = [path for path in paths(page) if path == SPEED]
    page.locator(".design .axis select").first.select_option(speed)
    start, end = (one.input_value() for one in page.locator(".design .axis").first.locator(".end").all()[:2])
    now = page.locator(f'.numbers label[title="{speed}"] + input').input_value()
    number, unit = now.split(" ", 1)
    assert (start.split(" ", 1)[1], end.split(" ", 1)[1]) == (unit, unit)
    assert float(start.split(" ")[0]) == pytest.approx(0.8 * float(number), rel=1e-3)
    assert float(end.split(" ")[0]) == pytest.approx(1.2 * float(number), rel=1e-3)


def test_who_only_asks_to_compute_sees_what_a_dimension_of_the_mechanism_changes(page):
    assert ".mechanism." in f".{page.locator('.design .axis select').first.input_value()}"
    compute(page)
    assert page.locator(".swept figure").count() == 3


def test_facts_over_one_number_are_those_of_runs_and_a_click_loads_a_design(page):
    vary(page, 0, SPEED, "2000 rpm", "4000 rpm", "5")
    want(page, "mean_piston_speed")
    compute(page)
    page.locator(".swept .numbers-of, .swept button").first.click()
    shown = page.locator(".swept table td, .swept table th").all_inner_texts()
    for speed in (2000, 2500, 3000, 3500, 4000):
        expected = ct.run("burning_cylinder", set={SPEED: f"{speed} rpm"}).mean_piston_speed
        assert any(text.startswith(f"{float(expected.max()):.4g}"[:4]) for text in shown), (speed, shown)
    plot = page.locator(".swept .u-over").first
    box = plot.bounding_box()
    plot.click(position={"x": 0.76 * box["width"], "y": 20})
    page.locator(".head p", has_text="3500 rpm").wait_for()
    assert page.locator(f'.numbers label[title="{SPEED}"] + input').input_value() == "3500 rpm"
    page.locator("button", has_text="Undo").click()
    page.locator(".head p", has_text="3500 rpm").wait_for(state="detached")


def test_what_is_wrong_with_a_range_stands_by_it_and_goes_with_the_next_one(page):
    want(page, "mean_piston_speed")
    refused = page.locator(".design .problems")
    for start, end, said in (
        ("abc", "4000 rpm", "must be FROM..TO:N"),
        ("2000 rpm", "300 rad/s", "must have one unit for both ends"),
    ):
        vary(page, 0, SPEED, start, end, "5")
        page.locator(".design button[type=submit]").click()
        refused.filter(has_text=said).wait_for()
    assert page.locator(".numbers [aria-invalid]").count() == 0
    vary(page, 0, SPEED, "9000 rpm", "200 rpm", "5")
    compute(page)
    assert refused.inner_text() == ""
    assert page.locator(".swept figure").first.inner_text().count("–") == 0


def test_two_numbers_are_a_map_and_a_click_loads_both(page):
    others = [path for path in paths(page) if path.endswith("rod_length")]
    vary(page, 0, SPEED, "2000 rpm", "4000 rpm", "9")
    vary(page, 1, others[0], "140 mm", "220 mm", "9")
    want(page, "largest_piston_speed", "largest_piston_acceleration")
    compute(page)
    maps = page.locator(".swept svg.map")
    assert maps.count() == 2
    frame = maps.first.locator(".frame")
    box = frame.bounding_box()
    page.mouse.move(box["x"] + 0.5 * box["width"], box["y"] + 0.5 * box["height"])
    reading = page.locator(".swept figcaption .reading").first.inner_text()
    expected = ct.run("burning_cylinder", set={SPEED: "3000 rpm", others[0]: "180 mm"}).largest_piston_speed
    assert reading.startswith("3000 · 180: ")
    assert float(reading.split(": ")[1].split(" ")[0]) == pytest.approx(float(expected.max()), rel=5e-4)
    page.mouse.click(box["x"] + 0.5 * box["width"], box["y"] + 0.5 * box["height"])
    page.locator(".head p", has_text="3000 rpm").wait_for()
    assert page.locator(f'.numbers label[title="{others[0]}"] + input').input_value() == "180 mm"


def test_designs_that_cannot_be_are_hatched_and_said(page):
    others = [path for path in paths(page) if path.endswith("rod_length")]
    vary(page, 0, SPEED, "2000 rpm", "4000 rpm", "8")
    vary(page, 1, others[0], "10 mm", "200 mm", "8")
    want(page, "largest_piston_speed")
    compute(page)
    assert page.locator(".swept svg.map .missing").count() > 0
    assert "cannot be" in page.locator(".swept").inner_text()


def test_what_is_wrong_with_a_range_is_said(page):
    vary(page, 0, SPEED, "2000 rpm", "4000 mm", "5")
    page.locator(".design button[type=submit]").click()
    page.locator(".problems p, .said:not(:empty)").first.wait_for()


def test_at_most_four_facts_are_wanted(page):
    want(page)
    for box in page.locator(".facts input").all()[:4]:
        box.check()
    assert page.locator(".facts input").nth(5).is_disabled()
    page.locator(".facts input").first.uncheck()
    assert page.locator(".facts input").nth(5).is_enabled()


def test_a_sweep_is_stopped_before_it_has_its_number(page):
    vary(page, 0, SPEED, "2000 rpm", "4000 rpm", "100")
    ended = []
    page.on("request", lambda one: ended.append(one.url) if one.method == "DELETE" else None)
    page.evaluate(
        """() => {
          document.querySelector(".design button[type=submit]").click();
          return new Promise((later) => setTimeout(() => {
            document.querySelector(".design form button[type=button]").click();
            later();
          }, 0));
        }"""
    )
    for _wait in range(100):
        if ended:
            break
        page.wait_for_timeout(50)
    assert len(ended) == 1
    assert page.locator(".design button[type=submit]").is_enabled()
    assert page.locator(".swept figure").count() == 0


def test_a_long_sweep_is_stopped(page):
    vary(page, 0, SPEED, "2000 rpm", "4000 rpm", "100")
    vary(page, 1, "gas.start_pressure", "80 kPa", "120 kPa", "90")
    want(page, "largest_torque")
    page.locator(".design button[type=submit]").click()
    stop = page.locator(".design button[type=button]", has_text="Stop")
    stop.wait_for()
    stop.click()
    stop.wait_for(state="hidden")
    assert page.locator(".design button[type=submit]").is_enabled()
