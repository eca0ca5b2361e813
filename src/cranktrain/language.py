"""Words for people, in their language: every string that a user reads passes through here."""

import gettext
from pathlib import Path

_catalogue = gettext.translation("cranktrain", Path(__file__).parent / "locale", fallback=True)


def translated(message: str) -> str:
    """Give a message in the user's language (from `LANGUAGE` or `LANG`), or as it stands."""
    return _catalogue.gettext(message) if message else ""


def marked(message: str) -> str:
    """Mark a message for translation where it is declared; it is translated where it is shown."""
    return message


_ = translated
N_ = marked
