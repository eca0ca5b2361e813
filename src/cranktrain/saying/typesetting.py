"""How units and signs stand on the screen and on pages: a true minus, ° for degrees, dots; commands stay as typed."""

import re
from collections.abc import Generator
from contextlib import contextmanager
from contextvars import ContextVar

from cranktrain.saying.amounts import KEPT
from cranktrain.saying.wording import in_print

_TYPESET = (
    (r"(?<=\d) deg\b", "°"),
    (r"(?<=\d) (?=%|[a-zA-Z]+[/·²³]|[kM]?[NWJ]\b|bar\b|mm\b|m\b|L\b|rpm\b)", KEPT),
)
"""Patterns of how sentences write units and signs, and what they are here."""

_TYPED = re.compile(r"(`[^`]*`|^cranktrain .*)")
"""What is to be typed: a command in a sentence, or that is a cell by itself."""

_is_printed: ContextVar[bool] = ContextVar("is_printed", default=False)


def typeset(sentence: str) -> str:
    """Write the units and signs of a stage's sentence as they stand in rows.

    Examples
    --------
    >>> typeset("at -4.50 deg, 3 N*m").replace(KEPT, " ")
    'at −4.50°, 3 N·m'
    """
    sentence = in_print(sentence)
    for pattern, instead in _TYPESET:
        sentence = re.sub(pattern, instead, sentence)
    return sentence


@contextmanager
def printed() -> Generator[None]:
    """Typeset all that is shown while this lasts."""
    before = _is_printed.set(True)
    try:
        yield
    finally:
        _is_printed.reset(before)


def as_printed(text: str) -> str:
    """Typeset a sentence, a cell or the head of a column, where a page is to be; what is to be typed stays.

    Examples
    --------
    >>> with printed():
    ...     print(as_printed("-2 deg"), as_printed("deg"), as_printed("mm/rad^2"), as_printed("`run a --set x=-2`"))
    −2° ° mm/rad² `run a --set x=-2`
    >>> as_printed("-2 deg")
    '-2 deg'
    """
    return in_type(text) if _is_printed.get() else text


def in_type(text: str) -> str:
    """Typeset a sentence, a cell or the head of a column; what is to be typed stays."""
    if text == "deg":
        return "°"
    return "".join(part if _TYPED.fullmatch(part) else typeset(part) for part in _TYPED.split(text))
