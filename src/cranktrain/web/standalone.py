"""A page that stands alone: one file with all that it needs, which a browser opens from a disk or a mail."""

import gzip
from base64 import b64encode
from dataclasses import replace
from html import escape
from importlib.resources import files

from cranktrain.analysis import Result
from cranktrain.language import spoken_language
from cranktrain.web.other_pistons import other_pistons
from cranktrain.web.packed import packed
from cranktrain.web.page import ShownMachine, machine_page

_MOST = 500_000
"""Bytes of a page: with more it has no curves of the other pistons."""

_PAGE = """<!doctype html>
<html lang="{language}">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'unsafe-inline'; \
style-src 'unsafe-inline'; img-src data:">
<title>{title}</title>
<style>{style}</style>
<main id="page"></main>
<script type="text/plain" id="data">{data}</script>
<script>{script}</script>
</html>
"""


def standalone_page(result: Result) -> str:
    """Write a machine with all its answers as a page that needs no server and no network.

    Parameters
    ----------
    result : Result
        Of one machine, with everything that it allows.

    Returns
    -------
    str
        HTML, in the language and the units that are chosen.
    """
    page = machine_page(result)
    if not any(tab.content is not None and tab.content.has_others for tab in page.tabs):
        return _written(page)
    whole = _written(_with_others(page, result))
    return whole if len(whole.encode()) < _MOST else _written(_with_others(page, None))


def _with_others(page: ShownMachine, result: Result | None) -> ShownMachine:
    """Give a page with the curves of the other pistons, or such that nobody asks for them."""
    tabs = tuple(
        tab
        if tab.content is None or not tab.content.has_others
        else replace(
            tab,
            content=replace(
                tab.content,
                has_others=result is not None,
                others=None if result is None else other_pistons(result, tab.name),
            ),
        )
        for tab in page.tabs
    )
    return replace(page, tabs=tabs)


def _written(page: ShownMachine) -> str:
    """Write all that it has and needs into one text."""
    built = files("cranktrain.web") / "built"
    return _PAGE.format(
        language=spoken_language(),
        title=escape(page.name or page.made_of),
        style=(built / "standalone.css").read_text(encoding="utf-8"),
        script=(built / "standalone.js").read_text(encoding="utf-8"),
        data=_letters(packed(page).content),
    )


def _letters(content: bytes) -> str:
    """Give content as letters, compressed; the same content as the same letters."""
    return b64encode(gzip.compress(content, mtime=0)).decode("ascii")
