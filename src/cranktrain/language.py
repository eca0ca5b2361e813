"""Words for people, in the language of whoever reads them: every string that a user reads passes through here."""

import gettext
from collections.abc import Generator
from contextlib import contextmanager
from contextvars import ContextVar
from functools import cache
from pathlib import Path

_chosen: ContextVar[str | None] = ContextVar("chosen language", default=None)
"""None for that of the surroundings, `LANGUAGE` or `LANG`."""


@contextmanager
def in_language(language: str) -> Generator[None]:
    """Say words in a language for a while, such as `ru`: here, and not in other threads."""
    token = _chosen.set(language)
    try:
        yield
    finally:
        _chosen.reset(token)


def chosen_language() -> str | None:
    """Which language words are said in here: what is kept of them is kept for it alone."""
    return _chosen.get()


@cache
def _catalogue(language: str | None) -> gettext.NullTranslations:
    """Words of a language; those of the code where there are none."""
    languages = None if language is None else [language]
    return gettext.translation("cranktrain", Path(__file__).parent / "locale", languages, fallback=True)


def _(message: str, /, **pieces: object) -> str:
    """Say a message in the reader's language, `{name}` in it standing for a piece.

    Examples
    --------
    >>> _("{first} and {last}", first="1L", last="6L")
    '1L and 6L'
    """
    said = _catalogue(_chosen.get()).gettext(message) if message else ""
    return said.format(**pieces) if pieces else said


def N_(message: str) -> str:  # noqa: N802 - the name that gettext's tools look for
    """Mark a message for translation where it is declared; it is translated where it is shown."""
    return message
