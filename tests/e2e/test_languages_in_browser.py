"""Pages in a language that no one speaks: all that people read is in it, and another language changes nothing else."""

import re
import threading
from contextlib import contextmanager

import pytest
import uvicorn
from tests.browser import Watched
from tests.pseudo_locale import PSEUDO, joints_of, keys, marked, names_of, pseudo, unmarked, write_catalogue

import cranktrain as ct
from cranktrain import language
from cranktrain.web.service import service
from cranktrain.web.standalone import standalone_page

__all__ = ["pseudo"]

READ = """() => {
    const found = [];
    const walk = (node) => {
        if (node.nodeType === Node.TEXT_NODE) { if (node.textContent.trim()) found.push(node.textContent); return; }
        if (node.nodeType !== Node.ELEMENT_NODE || ["SCRIPT", "STYLE"].includes(node.tagName)) return;
        if (node.matches(".symbol, .mechanism :is(g, circle) > title, .side legend, option[lang]")) return;
        for (const name of ["title", "aria-label"]) if (node.hasAttribute(name)) found.push(node.getAttribute(name));
        for (const child of node.childNodes) walk(child);
    };
    walk(document.body);
    return found;
}"""
"""Whatever is read of a page: what it shows, what it says where somebody points, what it calls its parts. Not names
from the file: of tables, links and pins; not what languages call themselves."""
SYMBOLS = r"() => [...document.querySelectorAll('.symbol')].flatMap((one) => one.textContent.split(/\W+/))"
"""Which are read out with their index, too."""
NAMES = {"evenness", "fig", "html"}
"""Of a table that a file lacks, of places in texts, of files."""


def nothing_plain(texts, *names):
    found = {text: words for text in texts if (words := unmarked(text, *names))}
    assert found == {}


@pytest.mark.parametrize("name", ["3d12", "jaw_crusher", "burning_cylinder"])
@pytest.mark.usefixtures("pseudo")
def test_a_page_that_stands_alone(chromium, tmp_path, name):
    result = ct.run(name)
    path = tmp_path / "page.html"
    with language.in_language(PSEUDO):
        path.write_text(standalone_page(result), encoding="utf-8")
    context = chromium.new_context(viewport={"width": 1440, "height": 900}, reduced_motion="reduce")
    watched = Watched(context, path.as_uri())
    for tab in watched.page.locator(".tabs button").all():
        tab.click()
        for button in watched.page.locator(".numbers-of").all():
            button.click()
        symbols = watched.page.evaluate(SYMBOLS)
        nothing_plain(watched.page.evaluate(READ), names_of(name), joints_of(result), symbols, NAMES)
    assert watched.faults == []
    context.close()


@contextmanager
def serving():
    """The service in a thread of this process."""
    server = uvicorn.Server(uvicorn.Config(service(), port=0, log_level="error", ws="none"))
    thread = threading.Thread(target=server.run)
    thread.start()
    try:
        while not server.started:
            pass
        yield f"http://127.0.0.1:{server.servers[0].sockets[0].getsockname()[1]}/"
    finally:
        server.should_exit = True
        thread.join()


@pytest.fixture
def spoken(tmp_path, monkeypatch):
    """The language has a catalogue, as any that is translated to."""
    write_catalogue(tmp_path)
    monkeypatch.setattr(language, "_LOCALE", tmp_path)
    language._catalogue.cache_clear()
    yield
    language._catalogue.cache_clear()


@pytest.mark.usefixtures("spoken")
def test_another_language_keeps_tab_angle_and_numbers(chromium):
    context = chromium.new_context(viewport={"width": 1440, "height": 900}, reduced_motion="reduce")
    with serving() as address:
        page = (watched := Watched(context, f"{address}#machine=3d12&phi=70&tab=Gas&cylinder.bore=151+mm")).page
        assert page.locator(":root").get_attribute("lang") == "en"
        assert page.locator("select.language option").all_inner_texts() == ["English", marked("English")]
        page.locator("select.language").select_option(PSEUDO)
        page.locator(".tabs button", has_text=marked("Gas")).wait_for()
        page.locator(".checks summary", has_text=marked("Checks")).wait_for()
        assert page.locator(":root").get_attribute("lang") == PSEUDO
        assert page.locator(".tabs button[aria-selected=true]").inner_text() == marked("Gas")
        assert page.locator("output.angle").inner_text() == "φ = 70°"
        assert page.locator(".changed input").input_value() == "151 mm"
        page.wait_for_url(re.compile(f"lang={PSEUDO}"))
        nothing_plain(
            page.evaluate(READ), names_of("3d12"), joints_of(ct.run("3d12")), keys(), page.evaluate(SYMBOLS), NAMES
        )
        page.reload()
        page.locator(".tabs button", has_text=marked("Gas")).wait_for()
        page.get_by_label("bore", exact=True).or_(page.get_by_label(marked("bore"), exact=True)).first.fill("-1 mm")
        page.keyboard.press("Enter")
        page.locator("[aria-invalid]").wait_for()
        nothing_plain(page.locator(".said").all_inner_texts())
        page.locator("h1").click()
        page.keyboard.press("ControlOrMeta+z")
        page.locator("select.language").select_option("en")
        page.locator(".tabs button", has_text="Gas").wait_for()
    assert [fault for fault in watched.faults if "422" not in fault] == []
    context.close()


def test_one_language_alone_is_no_choice(chromium):
    context = chromium.new_context()
    with serving() as address:
        page = Watched(context, f"{address}#machine=textbook_78x78&phi=0&lang=xx").page
        assert page.locator("h1").is_visible()
        assert not page.locator("select.language").is_visible()
    context.close()
