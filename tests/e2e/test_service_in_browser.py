"""The page of the service in a real browser: numbers are changed, what is wrong stands beside them, nothing is lost."""

import itertools
import re
import tomllib

import pytest
from tests.browser import Watched, faults, pages, tab_to
from tests.sentences import NOT_POSITIVE
from tests.serving import address_of, served, started

import cranktrain as ct


@pytest.fixture(scope="module")
def address(tmp_path_factory):
    with served(tmp_path_factory.mktemp("served"), "burning_cylinder") as one:
        yield one


@pytest.fixture
def opened(chromium, address):
    with pages(chromium, address) as open_page:
        yield open_page


def row(page, name):
    return page.locator(".answer tr", has_text=name).first.locator(".number").all_inner_texts()


def settled(page, name, value):
    """Wait until a row says a value."""
    for _wait in range(200):
        if row(page, name)[:1] == [value]:
            return
        page.wait_for_timeout(25)
    assert row(page, name)[:1] == [value]


def typed(page, label, value):
    field = page.get_by_label(label, exact=True).first
    field.fill(value)
    field.press("Enter")
    return field


def test_a_number_changes_what_is_shown_and_undo_brings_it_back(opened):
    page = opened("#machine=3d12&phi=0")
    settled(page, "mean piston speed", "9.000")
    typed(page, "speed", "1800 rpm")
    expected = ct.run("3d12", set={"shaft.main.speed": "1800 rpm"}).mean_piston_speed[0]
    settled(page, "mean piston speed", f"{expected:.2f}")
    page.locator("h1").click()
    page.keyboard.press("Control+z")
    settled(page, "mean piston speed", "9.000")
    page.keyboard.press("Control+Shift+z")
    settled(page, "mean piston speed", f"{expected:.2f}")


@pytest.mark.parametrize("tab", ["Motion", "Largest forces", "Main bearings"])
def test_what_takes_the_place_of_other_values_reads_as_on_a_new_page(opened, tab):
    """Rows, bars and sheets stay where they stand and change: nothing of what was there before is left in them."""

    def read(page):
        page.evaluate("document.fonts.ready")
        page.wait_for_timeout(300)
        return page.evaluate("['.answers', '.sheets', '.stage'].map((one) => document.querySelector(one).innerHTML)")

    page = opened(f"#machine=3d12&phi=40&tab={tab}")
    page.locator(".answer tr").first.wait_for()
    for speed in (1600, 900):
        before = page.locator("p.head, .head p").first.inner_text()
        typed(page, "speed", f"{speed} rpm")
        page.wait_for_function("(old) => document.querySelector('.head p').textContent !== old", arg=before)
    page.wait_for_url(re.compile("=900"))
    again = opened(page.url[page.url.index("#") :])
    again.locator(".answer tr").first.wait_for()
    assert read(page) == read(again)


def test_the_sentence_under_the_tabs_goes_along_and_is_said(opened):
    page = opened("#machine=3d12&phi=0")
    sentence = page.locator("p.sentence")
    sentence.get_by_text("Motion: stroke 180.0 mm (L), 186.7 mm (R)").wait_for()
    assert sentence.get_attribute("aria-live") == "polite"
    assert page.evaluate("getComputedStyle(document.querySelector('.sentence')).fontSize") == "17px"
    typed(page, "speed", "1800 rpm")
    sentence.get_by_text("mean piston speed 10.80 m/s (L), 11.20 m/s (R)").wait_for()
    page.locator(".tabs button", has_text="Main bearings").click()
    sentence.get_by_text("Main bearings: on elastic bearings").wait_for()
    page.locator(".tabs button", has_text="Wear of crank pins").click()
    page.locator(".tabs button", has_text="Design").click()
    assert not sentence.is_visible()


def test_a_link_gives_the_same_machine_with_the_same_numbers(opened):
    page = opened("#machine=textbook_78x78&phi=30")
    typed(page, "stroke", "80 mm")
    settled(page, "stroke", "80.00")
    page.wait_for_url(re.compile("=80"))
    again = opened(page.url[page.url.index("#") :])
    settled(again, "stroke", "80.00")
    assert again.locator("output.angle").inner_text() == "φ = 30°"


def test_a_wrong_number_is_said_beside_it_and_the_page_stays(opened):
    page = opened("#machine=3d12&phi=0")
    settled(page, "stroke", "180.0")
    field = typed(page, "bore", "-3 mm")
    said = page.locator(f"#{field.get_attribute('aria-describedby').split()[0]}")
    said.get_by_text(f"{NOT_POSITIVE} mm").wait_for()
    assert field.get_attribute("aria-invalid") == "true"
    assert row(page, "stroke")[0] == "180.0"
    typed(page, "bore", "151 mm")
    for _wait in range(100):
        if field.get_attribute("aria-invalid") is None:
            break
        page.wait_for_timeout(25)
    assert said.inner_text() == ""


def test_a_number_says_where_it_is_from_and_leads_to_the_numbers_behind_it(opened):
    page = opened("#machine=3d12&phi=0")
    page.locator(".answer .way", has_text="mean piston speed").click()
    dialog = page.locator("dialog.whence")
    dialog.locator("h2", has_text="mean piston speed").wait_for()
    assert "eq." in dialog.inner_text()
    dialog.locator(".way", has_text="speed").first.click()
    assert not dialog.is_visible()
    assert page.evaluate("document.activeElement.value") == "1500 rpm"
    page.locator(".answer .way", has_text="mean piston speed").focus()
    page.keyboard.press("Enter")
    dialog.locator("h2").wait_for()
    page.keyboard.press("Escape")
    assert not dialog.is_visible()


def test_home_and_end_choose_the_first_and_the_last_piston_of_a_list_that_scrolls(opened):
    page = opened("#machine=deltic&phi=30")
    chosen = page.locator(".pistons input:checked")
    chosen.focus()
    before = page.locator(".angle").inner_text()
    page.keyboard.press("End")
    last = page.locator(".pistons input").last.input_value()
    page.wait_for_url(re.compile(f"piston={re.escape(last)}"))
    assert page.evaluate("document.activeElement.value") == last
    page.keyboard.press("Home")
    page.wait_for_url(re.compile("piston=1A.exhaust"))
    assert page.locator(".angle").inner_text() == before


def test_tables_of_parts_are_told_apart_by_their_place_and_name(opened):
    page = opened("#machine=toggle_press&phi=30")
    legends = page.locator(".numbers legend").all_inner_texts()
    assert "[mechanism.part[0].rod] pitman" in legends
    assert "[mechanism.part[1].rod] lower" in legends
    assert len(set(legends)) == len(legends)


def test_another_piston_has_its_throw_and_its_curves(opened):
    page = opened("#machine=3d12&phi=30&tab=Largest+forces")
    page.locator("h3", has_text="Forces at piston 1L").wait_for()
    assert page.locator(".pistons label").all_text_contents()[:3] == ["1L 0°", "6R 60°", "5L 120°"]
    page.locator(".pistons label", has_text="4R").click()
    page.locator("h3", has_text="Forces at piston 4R").wait_for()
    page.wait_for_url(re.compile("piston=4R"))
    again = opened(page.url[page.url.index("#") :])
    again.locator("h3", has_text="Forces at piston 4R").wait_for()
    assert again.locator(".pistons input:checked").input_value() == "4R"
    again.locator("label", has_text="Machine").locator("select").select_option("burning_cylinder")
    again.locator("h1", has_text="Wiebe").wait_for()
    assert not again.locator(".pistons").is_visible()


def test_a_throw_is_chosen_by_keys_and_on_its_star(opened, axe):
    page = opened("#machine=3d12&phi=30&tab=Largest+forces&piston=6R")
    page.locator("h3", has_text="Forces at piston 6R").wait_for()
    chosen = page.locator(".crank-star .chosen text")
    assert (chosen.text_content(), page.locator(".crank-star text").count()) == ("1, 6", 3)
    tab_to(page, ".pistons input")
    for name, throws in (("5L", "2, 5"), ("2R", "2, 5"), ("3L", "3, 4")):
        page.keyboard.press("ArrowRight")
        page.locator("h3", has_text=f"Forces at piston {name}").wait_for()
        assert page.evaluate("document.activeElement.value") == name
        assert chosen.text_content() == throws
    assert page.locator("output.angle").inner_text() == "φ = 30°"  # keys of a choice turn no crank
    for name in ("1L", "6R", "6L"):  # in their order of firing
        page.locator(".crank-star g", has_text="1, 6").locator(".target").click()
        page.locator("h3", has_text=f"Forces at piston {name}").wait_for()
    page.evaluate(axe)
    assert faults(page) == []


def test_a_chosen_piston_is_seen_in_a_long_list_on_a_phone_too(chromium, address):
    context = chromium.new_context(viewport={"width": 390, "height": 844}, reduced_motion="reduce")
    page = Watched(context, f"{address}#machine=deltic&phi=0&piston=3C.scavenge").page
    page.locator(".pistons input:checked").wait_for()
    chosen, among = (page.locator(one).bounding_box() for one in (".pistons label:has(:checked)", ".pistons"))
    assert among["y"] <= chosen["y"] and chosen["y"] + chosen["height"] <= among["y"] + among["height"] + 1
    assert page.locator("svg.crank-star").count() == 3
    assert page.evaluate("document.documentElement.scrollWidth") <= 390
    context.close()


def test_what_was_meant_is_a_button(opened):
    page = opened("#machine=3d12&phi=0")
    settled(page, "stroke", "180.0")
    field = typed(page, "bore", "151")
    page.locator("button.instead", has_text="151 mm").click()
    page.wait_for_function("one => one.value === '151 mm'", arg=field.element_handle())
    typed(page, "speed", "1600 rpn")
    page.locator("button.instead", has_text="1600 rpm").click()
    page.locator(".head p", has_text="1600 rpm").wait_for()


def test_arrow_keys_step_a_number_and_the_arrow_back_undoes_it(opened):
    page = opened("#machine=textbook_78x78&phi=0")
    field = page.get_by_label("stroke", exact=True).first
    settled(page, "stroke", "78.00")
    field.focus()
    for key, expected in (("ArrowUp", "79.00"), ("Shift+ArrowUp", "89.00"), ("Alt+ArrowDown", "88.90")):
        page.keyboard.press(key)
        settled(page, "stroke", expected)
    page.locator(".changed .back").first.click()
    settled(page, "stroke", "78.00")


def test_another_machine_and_the_tab_that_it_has(opened):
    page = opened("#phi=0")
    assert "cylinder" in page.locator("h1").inner_text().lower()
    page.locator("label", has_text="Machine").locator("select").select_option("jaw_crusher")
    page.locator("h1", has_text="jaw crusher").wait_for()
    page.locator(".tabs button", has_text="Loads").click()
    typed(page, "speed", "300 rpm")
    page.locator(".head p", has_text="300 rpm").wait_for()
    assert page.locator(".tabs button[aria-selected=true]").inner_text() == "Loads"


def test_the_machine_file_is_saved_with_its_comments(opened):
    page = opened("#machine=3d12&phi=0&cylinder.bore=151+mm")
    page.locator("button", has_text="Save the machine file").wait_for()
    with page.expect_download() as download:
        page.locator("button", has_text="Save the machine file").click()
    assert download.value.suggested_filename == "3d12.toml"
    text = download.value.path().read_text(encoding="utf-8")
    assert tomllib.loads(text)["cylinder"]["bore"] == "151 mm"
    assert "# " in text


def test_a_case_is_kept_and_the_machine_stands_beside_it(opened):
    page = opened("#machine=3d12&phi=0")
    settled(page, "mean piston speed", "9.000")
    page.locator("button", has_text="Compare with this").click()
    compared = page.locator(".answers .table tr", has_text="mean piston speed").first
    compared.wait_for()
    typed(page, "speed", "1800 rpm")
    page.locator(".answers .table tr", has_text="+20.0 %").first.wait_for()
    saved, now, unit, more, percent = compared.locator("td").all_inner_texts()
    assert (saved, unit, percent) == ("9.000", "m/s", "+20.0 %")
    assert float(now) - float(saved) == pytest.approx(float(more), abs=0.01)
    page.locator("button.differ:not(.all-pistons)").click()
    page.locator("h3", has_text="now less saved").first.wait_for()
    page.wait_for_url(re.compile("beside="))
    again = opened(page.url[page.url.index("#") :])
    again.locator(".answers .table tr", has_text="+20.0 %").first.wait_for()
    again.locator("label", has_text="Compare").locator("select").select_option(index=0)
    again.locator(".answers .table").wait_for(state="detached")
    assert not again.locator("button.differ:not(.all-pistons)").is_visible()


def test_what_stays_the_same_stays_where_it_is(opened):
    page = opened("#machine=3d12&phi=70&tab=Largest+forces")
    page.locator(".panel").first.wait_for()
    page.evaluate("for (const one of document.querySelectorAll('svg.mechanism, .panel, .tabs button')) one.kept = true")
    typed(page, "speed", "1800 rpm")
    page.locator(".head p", has_text="1800 rpm").wait_for()
    panels = page.locator(".stack .panel")
    assert panels.evaluate_all("all => all.every(one => one.kept)") and panels.count() > 2
    assert page.locator("svg.mechanism").evaluate("one => one.kept")
    assert page.locator("output.angle").inner_text() == "φ = 70°"


def test_only_the_last_of_many_edits_is_shown(opened):
    page = opened("#machine=3d12&phi=0")
    settled(page, "mean piston speed", "9.000")
    field = page.get_by_label("speed", exact=True).first
    field.focus()
    for _edit in range(8):
        page.keyboard.press("Shift+ArrowUp")
    expected = ct.run("3d12", set={"shaft.main.speed": "1580 rpm"}).mean_piston_speed[0]
    settled(page, "mean piston speed", f"{expected:.3f}")


def test_vectors_that_are_wanted_stay_through_an_edit(opened):
    """On the tab of forces velocities are asked for anew, to the scale of the new speed."""
    page = opened("#machine=burning_cylinder&phi=20")
    page.locator(".choice", has_text="Velocities").wait_for()
    page.locator(".tabs button", has_text="Largest forces").click()
    page.locator(".choice", has_text="Crank pin").wait_for()
    page.locator(".choice", has_text="Velocities").click()
    scales = page.locator(".mechanism text.beside")
    before = scales.all_text_contents()
    assert [text.split()[1] for text in before] == ["m/s", "kN"]
    speed = ct.load("burning_cylinder").main_shaft.speed.si * 30 / 3.141592653589793
    typed(page, "speed", f"{10 * speed:.0f} rpm")
    page.locator(".mechanism text.beside", has_text="100 m/s").wait_for()
    assert len(scales.all_text_contents()) == 2
    names = page.locator(".vectors .choice").all_inner_texts()
    assert names == ["Velocities", "Gas force", "Side force", "Crank pin"]


def test_at_another_host_the_address_has_the_token_which_the_browser_keeps_out_of_sight(chromium, tmp_path):
    with served(tmp_path, "textbook_78x78", "--host", "0.0.0.0") as shown:
        token = shown.partition("?token=")[2]
        place = "http://localhost:" + shown.partition("?")[0].rstrip("/").rpartition(":")[2] + "/"
        context = chromium.new_context(viewport={"width": 1440, "height": 900}, reduced_motion="reduce")
        watched = Watched(context, f"{place}?token={token}")
        settled(watched.page, "stroke", "78.00")
        assert token
        assert token not in watched.page.url
        watched.page.reload()
        settled(watched.page, "stroke", "78.00")
        assert [fault for fault in watched.faults if not fault.startswith(place)] == []
        context.close()


@pytest.mark.parametrize("colours", ["light", "dark"])
def test_no_fault_beside_a_wrong_number(opened, axe, colours):
    page = opened("#machine=3d12&phi=0")
    page.emulate_media(color_scheme=colours)
    settled(page, "stroke", "180.0")
    typed(page, "bore", "-3 mm")
    page.locator("[aria-invalid]").wait_for()
    page.evaluate(axe)
    assert faults(page) == []


def test_no_fault_on_any_tab_nor_among_all_machines(opened, axe):
    page = opened("#machine=jaw_crusher&phi=70")
    page.locator(".checks").wait_for()
    page.evaluate(axe)
    for tab in page.locator(".tabs button").all():
        tab.click()
        page.locator(".sheets:visible:not(.computing)").wait_for()
        assert faults(page) == [], tab.inner_text()
    page.locator(".bar button", has_text="All machines").click()
    page.locator("dialog .card").first.wait_for()
    assert faults(page) == []


def test_a_number_with_which_there_is_no_machine_is_marked_and_taken_back(opened):
    """A rod so short that the jaw goes farther than its load says: told at the last place of that, and ↺ ends it."""
    page = opened("#machine=jaw_crusher&phi=30")
    page.locator("h1", has_text="jaw crusher").wait_for()
    rod = page.get_by_label("rod length", exact=True).first
    rod.fill("400 mm")
    rod.press("Enter")
    told = page.locator(".field:has([aria-invalid])")
    told.wait_for()
    assert told.locator("label").inner_text() == "travel 3"
    assert "must go as far as the part goes" in told.inner_text()
    changed = page.locator(".field.changed")
    assert changed.locator("label").all_inner_texts() == ["rod length"]
    changed.locator(".back").click()
    told.wait_for(state="detached")
    assert rod.input_value() == "1085 mm"


def test_a_whole_edit_by_keys_alone(opened):
    page = opened("#machine=textbook_78x78&phi=0")
    settled(page, "stroke", "78.00")
    tab_to(page, ".field input[value='78 mm']")
    page.keyboard.press("ControlOrMeta+a")
    page.keyboard.type("80 mm")
    page.keyboard.press("Enter")
    settled(page, "stroke", "80.00")
    tab_to(page, ".changed .back")
    page.keyboard.press("Enter")
    settled(page, "stroke", "78.00")
    tab_to(page, ".bar button", key="Shift+Tab")
    assert page.evaluate("document.activeElement.matches('.bar :is(button, select)')")
    tab_to(page, ".bar select", key="Shift+Tab")
    while not page.evaluate("document.activeElement.labels[0]?.textContent.startsWith('Machine')"):
        tab_to(page, ".bar select", key="Shift+Tab")
    page.keyboard.type("jaw")
    page.locator("h1", has_text="jaw crusher").wait_for()


def middle(page, pin):
    box = page.locator(f".handle:has(title:text-is('{pin}'))").bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def pulled(page, pin, across, up):
    """Take a pin by hand, pull it so many pixels, and wait; give by how much it is off then, and what is said."""
    start = middle(page, pin)
    page.mouse.move(*start)
    page.mouse.down()
    for part in (0.25, 0.5, 0.75, 1.0):
        page.mouse.move(start[0] + part * across, start[1] - part * up)
    page.locator(".moved:not([hidden])").wait_for()
    page.wait_for_timeout(1500)
    end = middle(page, pin)
    return (end[0] - start[0] - across, end[1] - start[1] + up), page.locator(".moved").inner_text()


def field(page, label):
    return page.get_by_label(label, exact=True).first.input_value()


def test_a_crank_pin_is_pulled_and_its_number_follows(opened):
    """At the left bank's axis, upright on the page but for 30°; the old mechanism is a ghost until it is let go."""
    page = opened("#machine=3d12&phi=0")
    settled(page, "stroke", "180.0")
    assert page.locator(".handle").count() == 0
    page.keyboard.press("e")
    page.locator(".handle").first.wait_for()
    off, said = pulled(page, "1L A", -10.0, 17.3)
    assert abs(off[0]) < 2.0 and abs(off[1]) < 2.0
    stroke = field(page, "stroke")
    assert re.fullmatch(r"\d+ mm", stroke)
    assert float(stroke.split()[0]) > 190.0
    assert said == f"stroke {stroke}"
    assert page.locator(".mechanism .old > path").count() > 0
    page.mouse.up()
    page.locator(".moved").wait_for(state="hidden")
    assert page.locator(".mechanism .old > path").count() == 0
    page.locator("h1").click()
    page.keyboard.press("Control+z")
    settled(page, "stroke", "180.0")
    assert page.get_by_role("button", name="Undo").is_disabled(), "all of a pull is one step"


def test_a_pivot_s_pull_stops_where_there_is_no_such_machine(opened):
    page = opened("#machine=jaw_crusher&phi=30")
    page.locator("h1", has_text="jaw crusher").wait_for()
    page.locator("button", has_text="Move pins").click()
    page.locator(".handle").first.wait_for()
    off, said = pulled(page, "1 A", 0.0, 300.0)
    assert off[1] > 100.0
    assert "✗" in said
    page.mouse.up()
    page.locator(".moved").wait_for(state="hidden")
    radius = field(page, "crank radius")
    assert re.fullmatch(r"[\d.]+ mm", radius)
    off, said = pulled(page, "1 B", 0.0, -3.0)
    page.mouse.up()
    page.locator(".moved").wait_for(state="hidden")
    lengths = field(page, "rod length"), field(page, "rocker length")
    assert lengths != ("1085 mm", "455 mm")
    assert all(re.fullmatch(r"[\d.]+ mm", one) for one in lengths)


def test_a_guide_is_turned_at_its_end_and_keeps_its_unit(opened):
    """Level on the page, through the ring that stands beyond the ram; all else stays as it is typed."""
    page = opened("#machine=shaper&phi=40")
    page.locator("h1", has_text="Shaper").wait_for()
    page.keyboard.press("e")
    page.locator(".handle").first.wait_for()
    typed = [one.input_value() for one in page.locator(".field input").all()]
    off, said = pulled(page, "1 ram.guide", 0.0, 12.0)
    assert abs(off[1]) < 2.0
    page.mouse.up()
    page.locator(".moved").wait_for(state="hidden")
    direction = field(page, "direction")
    assert re.fullmatch(r"[\d.]+ deg", direction)
    assert 1.0 < float(direction.split()[0]) < 10.0
    assert said == f"direction {direction}"
    now = [one.input_value() for one in page.locator(".field input").all()]
    assert [one for one in zip(typed, now, strict=True) if one[0] != one[1]] == [("0 deg", direction)]


def test_a_link_pasted_where_the_page_is_open_is_followed_and_the_browser_goes_back(opened):
    page = opened("#machine=3d12&phi=0")
    settled(page, "mean piston speed", "9.000")
    page.evaluate("location.hash = '#machine=textbook_78x78&phi=30&tab=Torque'")
    page.locator("h1", has_text="78 × 78").wait_for()
    page.locator("[role=tab][aria-selected=true]", has_text="Torque").wait_for()
    assert page.locator("output.angle").inner_text() == "φ = 30°"
    page.go_back()
    page.locator("h1", has_text="3D12").wait_for()
    assert page.locator("output.angle").inner_text() == "φ = 0°"


def test_an_address_that_is_written_late_does_not_undo_where_somebody_goes_meanwhile(opened):
    page = opened("#machine=textbook_78x78&phi=0")
    settled(page, "stroke", "78.00")
    page.wait_for_timeout(200)
    shown = page.evaluate(
        """() => {
          const late = [];
          const soon = window.setTimeout;
          window.setTimeout = (call) => late.push(call);
          const slider = document.querySelector(".turning-controls input[type=range]");
          slider.value = 40;
          slider.dispatchEvent(new Event("input"));
          window.setTimeout = soon;
          location.hash = "#machine=shaper&phi=30";
          for (const call of late) call();
          return [late.length, location.hash];
        }"""
    )
    assert shown == [1, "#machine=shaper&phi=30"]
    page.locator("h1", has_text="haper").wait_for()


def test_at_a_narrow_width_the_open_tab_of_a_link_and_the_crank_angle_are_in_view(opened):
    page = opened("#machine=compressor_start&phi=640.5&tab=Textbook")
    page.set_viewport_size({"width": 1024, "height": 768})
    page.evaluate("location.hash = '#machine=3d12&phi=640.5&tab=Main+bearings'")
    page.locator("h1", has_text="3D12").wait_for()
    tab = page.locator("[role=tab][aria-selected=true]", has_text="Main bearings").bounding_box()
    assert tab["x"] + tab["width"] < 1025  # a line scrolls by whole pixels
    right = "one => one.getBoundingClientRect().right"
    assert page.locator("output.angle").evaluate(right) <= page.locator("section.drawing").evaluate(right)


@pytest.mark.parametrize(
    ("place", "title", "said"),
    [
        ("#machine=no_such_machine", "Wiebe", "must be one of the examples"),
        ("#machine=3d12&cylinder.bore=big", "3D12", "must be a length"),
        ("#machine=3d12&no.such=1", "3D12", "no.such"),
        ("#file=nothing", "Wiebe", ""),
    ],
)
def test_of_a_link_that_cannot_be_it_is_said_why_and_the_page_can_be_used(opened, place, title, said):
    page = opened(place)
    page.locator("h1", has_text=title).wait_for()
    page.locator(".said, .problems").filter(has_text=said).first.wait_for(state="attached")
    page.get_by_role("button", name="All machines").wait_for()
    assert page.locator("button", has_text="Undo").is_disabled()


def test_a_machine_file_may_end_in_capitals(opened):
    page = opened("#machine=3d12&phi=0")
    text = page.request.post(page.url.partition("#")[0] + "api/file", data={"machine": "textbook_78x78"}).body()
    page.locator("input[type=file]").set_input_files({"name": "ENGINE.TOML", "mimeType": "", "buffer": text})
    page.locator("h1", has_text="78 × 78").wait_for()


def test_what_is_wrong_with_a_file_is_said_with_its_name_and_line_where_it_is_seen_on_a_phone_too(opened):
    page = opened("#machine=3d12&phi=0")
    page.set_viewport_size({"width": 390, "height": 844})
    text = b'[mechanism]\nkind = "chian"\n'
    page.locator("input[type=file]").set_input_files({"name": "press.toml", "mimeType": "", "buffer": text})
    said = page.locator(".problems p", has_text="press.toml:2:8 mechanism.kind chian")
    said.wait_for()
    page.wait_for_function("one => one.getBoundingClientRect().bottom < innerHeight - 60", arg=said.element_handle())


def test_behind_the_dots_of_a_phone_nothing_lies_on_anything_else(opened):
    page = opened("#machine=3d12&phi=0")
    page.set_viewport_size({"width": 390, "height": 844})
    page.locator(".others").click()
    parts = "header.bar :is(button, select, label > span)"
    boxes = [box for one in page.locator(parts).all() if (box := one.bounding_box()) is not None]
    assert len(boxes) > 8
    assert all(box["width"] > 30 for box in boxes)
    for one, other in itertools.combinations(boxes, 2):
        is_beside = one["x"] + one["width"] <= other["x"] or other["x"] + other["width"] <= one["x"]
        is_above = one["y"] + one["height"] <= other["y"] or other["y"] + other["height"] <= one["y"]
        assert is_beside or is_above, (one, other)


def test_what_does_not_answer_is_told_and_the_page_goes_on(chromium, tmp_path):
    with started(tmp_path, "burning_cylinder") as service:
        context = chromium.new_context(viewport={"width": 1440, "height": 900})
        watched = Watched(context, address_of(service))
        page = watched.page
        page.locator(".offers button").first.wait_for()
        service.terminate()
        service.wait(timeout=20)
        page.get_by_role("button", name="All machines").click()
        page.locator(".problems", has_text="the service does not answer").wait_for()
        page.locator("[role=tab]").nth(1).click()
        page.wait_for_timeout(300)
        before = page.locator("output.angle").inner_text()
        page.wait_for_timeout(300)
        assert page.locator("output.angle").inner_text() != before
        assert [fault for fault in watched.faults if "ERR_CONNECTION_REFUSED" not in fault] == []
        context.close()
