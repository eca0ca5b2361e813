"""Words for people, in their language: every string that a user reads passes through here."""

import gettext
from pathlib import Path

_catalogue = gettext.translation("cranktrain", Path(__file__).parent / "locale", fallback=True)


def _(message: str) -> str:
    """Give a message in the user's language (from `LANGUAGE` or `LANG`), or as it stands."""
    return _catalogue.gettext(message) if message else ""


def N_(message: str) -> str:  # noqa: N802 - the name that gettext's tools look for
    """Mark a message for translation where it is declared; it is translated where it is shown."""
    return message
