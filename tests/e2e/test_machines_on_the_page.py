"""Which machine a page has: one of the gallery, a new one, a file that is opened, one to which tables are added."""

import codecs
import csv
import re
import tomllib

import pytest
from tests.browser import pages
from tests.serving import served

import cranktrain as ct
from cranktrain.io.examples import EXAMPLES_FOLDER, example_names
from cranktrain.mechanisms import KINDS

MACHINE = """# of my own
name = "Pump of my own"
[shaft.main]
speed = "600 rpm"
[mechanism]
kind = "slider_crank"
crank_radius = "50 mm"
rod_length = "170 mm"   # measured
"""
CARD = """
[cylinder]
bore = "80 mm"
compression_ratio = 10
cycle = "four-stroke"
[gas]
kind = "indicator"
file = "card.csv"
"""


@pytest.fixture(scope="module")
def address(tmp_path_factory):
    folder = tmp_path_factory.mktemp("served")
    (folder / "card.csv").write_text("not to be read", encoding="utf-8")
    with served(folder) as one:
        yield one


@pytest.fixture
def opened(chromium, address):
    with pages(chromium, address, ".answers tr") as open_page:
        yield open_page


def opens(page, *files):
    page.locator("input[type=file]").set_input_files(
        [{"name": name, "mimeType": "text/plain", "buffer": text.encode()} for name, text in files]
    )


def test_every_example_and_every_kind_stands_in_the_gallery_with_a_drawing(opened):
    page = opened("#machine=textbook_78x78&phi=0")
    page.locator("button", has_text="All machines").click()
    cards = page.locator("dialog .card")
    cards.first.wait_for()
    names = cards.evaluate_all("all => all.map(one => one.value)")
    assert names == [*example_names(), *KINDS.names]
    shapes = cards.evaluate_all("all => all.map(one => one.querySelectorAll('.link, .slider').length)")
    assert min(shapes) >= 2
    page.locator("dialog input").fill("press 90")
    assert page.locator("dialog .card:visible").evaluate_all("all => all.map(one => one.value)") == ["eccentric_press"]
    page.locator("dialog input").fill("no such thing")
    assert page.locator("dialog .note").is_visible()
    page.locator("dialog input").fill("eccentric")
    page.locator("dialog .card[value=eccentric_press]").click()
    page.locator("h1", has_text="Eccentric press").wait_for()


def test_a_new_machine_of_a_kind_has_its_numbers_and_is_in_the_address(opened):
    page = opened("#machine=textbook_78x78&phi=0")
    page.locator("button", has_text="All machines").click()
    page.locator("dialog .card[value=crank_rocker]").click()
    page.locator("h1", has_text="My machine").wait_for()
    page.wait_for_url(re.compile("file="))
    again = opened(page.url[page.url.index("#") :])
    assert again.locator("h1").inner_text() == "My machine"


def test_the_gallery_is_left_by_a_key(opened):
    page = opened("#machine=textbook_78x78&phi=0")
    page.locator("button", has_text="All machines").click()
    page.locator("dialog .card").first.wait_for()
    page.keyboard.press("Escape")
    assert not page.locator("dialog.gallery").is_visible()


def test_a_machine_file_is_opened_changed_and_saved_with_its_comments(opened):
    page = opened("#machine=textbook_78x78&phi=0")
    opens(page, ("mine.toml", MACHINE))
    page.locator("h1", has_text="Pump of my own").wait_for()
    field = page.get_by_label("rod length", exact=True)
    field.fill("180 mm")
    field.press("Enter")
    page.locator(".changed label", has_text="rod length").wait_for()
    with page.expect_download() as download:
        page.locator("button", has_text="Save the machine file").click()
    assert download.value.suggested_filename == "mine.toml"
    text = download.value.path().read_text(encoding="utf-8")
    assert tomllib.loads(text)["mechanism"]["rod_length"] == "180 mm"
    assert "# of my own" in text and "# measured" in text


def test_a_table_is_added_with_values_of_a_machine_of_its_size_and_undone(opened):
    page = opened("#machine=textbook_78x78&phi=0")
    tabs = page.locator(".tabs button").count()
    page.locator(".chip", has_text="[gas]").click()
    page.get_by_label("start pressure", exact=True).wait_for()
    page.locator(".tabs button", has_text="Largest forces").wait_for()
    assert page.locator(".tabs button").count() > tabs
    page.locator("button", has_text="Undo").click()
    page.locator(".chip", has_text="[gas]").wait_for()
    assert page.locator(".tabs button").count() == tabs


def test_a_file_that_a_machine_names_is_taken_from_what_was_opened_and_never_from_the_disk(opened):
    page = opened("#machine=textbook_78x78&phi=0")
    opens(page, ("mine.toml", MACHINE + CARD))
    page.locator(".problems p").first.wait_for()
    said = page.locator(".problems").inner_text()
    assert "card.csv" in said
    assert "not to be read" not in page.locator("body").inner_text()


def test_files_of_which_the_machine_knows_nothing_are_said(opened):
    page = opened("#machine=textbook_78x78&phi=0")
    opens(page, ("photo.png", "no picture"))
    page.locator(".problems p", has_text="photo.png is named nowhere").wait_for()
    opens(page, ("mine.toml", MACHINE), ("other.toml", MACHINE))
    page.locator(".problems p", has_text="other.toml is a second machine file").wait_for()
    assert page.locator("h1").inner_text() == "Textbook engine 78 × 78 (Kolchin and Demidov)"


def test_a_broken_file_is_said_and_the_page_stays(opened):
    page = opened("#machine=textbook_78x78&phi=0")
    opens(page, ("mine.toml", "[mechanism\nkind = 3"))
    page.locator(".problems p").first.wait_for()
    assert page.locator("h1").inner_text() == "Textbook engine 78 × 78 (Kolchin and Demidov)"
    page.locator("button", has_text="Undo").click()
    page.locator(".problems p").first.wait_for(state="detached")


def test_a_machine_file_is_dropped_on_the_page(opened):
    page = opened("#machine=textbook_78x78&phi=0")
    page.evaluate(
        """text => {
          const files = new DataTransfer();
          files.items.add(new File([text], "mine.toml"));
          document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: files, bubbles: true, cancelable: true }));
        }""",
        MACHINE,
    )
    page.locator("h1", has_text="Pump of my own").wait_for()


def test_what_was_shown_last_is_shown_again(opened):
    page = opened("#machine=shaper&phi=0")
    page.locator("h1", has_text="haper").first.wait_for()
    page.wait_for_timeout(150)
    assert "haper" in opened().locator("h1").inner_text()


@pytest.mark.parametrize("name", ["gas_compressor"])
def test_an_example_as_a_file_of_ones_own_says_the_same(opened, name):
    text = (EXAMPLES_FOLDER / f"{name}.toml").read_text(encoding="utf-8")
    own = opened(f"#machine={name}&phi=0")
    expected = own.locator(".answers").inner_text()
    page = opened("#machine=textbook_78x78&phi=0")
    opens(page, (f"{name}.toml", text))
    page.locator("h1", has_text=own.locator("h1").inner_text()).wait_for()
    assert page.locator(".answers").inner_text() == expected


def test_files_are_taken_away(opened, tmp_path):
    page = opened("#machine=textbook_78x78&phi=0&bank.line.mechanism.stroke=80+mm")
    choice = page.get_by_label("Take away")
    page.locator("option", has_text=".csv").wait_for(state="attached")
    suffixes = [one for one in choice.evaluate("one => [...one.options].map(option => option.value)") if one]
    assert {".csv", ".xlsx", ".json", ".html", ".svg", ".pdf"} <= set(suffixes)
    begins = {".csv": b"#", ".xlsx": b"PK", ".html": b"<!doctype html>", ".svg": b"<?xml", ".pdf": b"%PDF"}
    for suffix, begin in begins.items():
        with page.expect_download(timeout=60_000) as download:
            choice.select_option(suffix)
        assert download.value.suggested_filename == f"textbook_78x78{suffix}"
        content = download.value.path().read_bytes().removeprefix(codecs.BOM_UTF8)
        assert content.startswith(begin) and len(content) > 1000
        if suffix == ".csv":
            heads, *lines = csv.reader(line for line in content.decode().splitlines() if not line.startswith("#"))
            place = next(place for place, head in enumerate(heads) if "displacement" in head)
            expected = ct.run("textbook_78x78", set={"bank.line.mechanism.stroke": "80 mm"}).piston_displacement[0]
            assert max(float(line[place]) for line in lines) == pytest.approx(float(expected.max()), rel=1e-6)
