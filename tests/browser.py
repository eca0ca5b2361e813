"""A real browser for tests: Debian's Chromium, or another that is there."""

import shutil
from contextlib import contextmanager

import pytest

_CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
_QUIET = (
    *("--no-sandbox", "--disable-gpu", "--disable-quic", "--disable-background-networking", "--disable-sync"),
    "--disable-dev-shm-usage",
)


@contextmanager
def browser():
    """Start it; skip where there is none."""
    playwright = pytest.importorskip("playwright.sync_api", reason="needs Playwright: pip install playwright")
    if _CHROMIUM is None:
        pytest.skip("needs Chromium: apt install chromium")
    with playwright.sync_playwright() as started:
        one = started.chromium.launch(executable_path=_CHROMIUM, args=list(_QUIET))
        yield one
        one.close()


class Watched:
    """A page of a browser, and what it should not have done: errors, and requests beyond its own address."""

    def __init__(self, context, address, waits_for=".tabs button"):
        self.faults = []
        self.page = context.new_page()
        self.page.on("console", lambda said: self.faults.append(said.text) if said.type == "error" else None)
        self.page.on("pageerror", lambda error: self.faults.append(str(error)))
        own = address.partition("#")[0], "data:", "blob:", "about:srcdoc"
        self.page.on("request", lambda asked: None if asked.url.startswith(own) else self.faults.append(asked.url))
        self.page.goto(address)
        self.page.wait_for_selector(waits_for)


_WCAG = ("wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa")
_FAULTS = """async (rules) => (await axe.run({ runOnly: rules })).violations
    .flatMap((rule) => rule.nodes.map((node) => `${rule.id}: ${node.target} ${node.any[0]?.message ?? rule.help}`))"""


def faults(page, *rules):
    """What axe-core, which the page has, finds against WCAG 2.2 AA, or by some rules."""
    return page.evaluate(_FAULTS, rules or _WCAG)


def focused(page):
    """What keys go to, as HTML."""
    return page.evaluate("document.activeElement.outerHTML")


def tab_to(page, query, key="Tab", most=120):
    """Go on by a key until an element is reached; each on the way shows that it is."""
    for _step in range(most):
        page.keyboard.press(key)
        outline = page.evaluate("getComputedStyle(document.activeElement).outline")
        assert "solid 2px" in outline, focused(page)
        if page.evaluate("(query) => document.activeElement.matches(query)", query):
            return
    pytest.fail(f"{query} is not reached")


REFUSED = "the server responded with a status of 422"
"""What a browser says of its own where a number is wrong."""


@contextmanager
def pages(chromium, address, waits_for=".tabs button", height=900):
    """Open pages of a service, and look in the end that none did what it should not."""
    context = chromium.new_context(viewport={"width": 1440, "height": height}, reduced_motion="reduce")
    found = []

    def open_page(place=""):
        found.append(Watched(context, address + place, waits_for))
        return found[-1].page

    yield open_page
    assert [fault for one in found for fault in one.faults if REFUSED not in fault] == []
    context.close()
