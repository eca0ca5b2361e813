"""A page that stands alone: one file with all that it needs, which a browser opens from a disk or a mail."""

import gzip
from base64 import b64encode
from html import escape
from importlib.resources import files

from cranktrain.analysis import Result
from cranktrain.language import spoken_language
from cranktrain.web.packed import packed
from cranktrain.web.page import machine_page

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
