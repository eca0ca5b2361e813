"""The five texts: what each holds, how far it is right, and which command shows it. One table of data for each text."""

from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.quantities import nearest
from cranktrain.textbook.texts import bolotin, crankshaft, gandzha, steam_engine, synthesis
from cranktrain.textbook.texts.text import Formula, Text

__all__ = ["TEXTS", "Formula", "Text", "text_called", "text_named"]

TEXTS: tuple[Text, ...] = (steam_engine.TEXT, gandzha.TEXT, synthesis.TEXT, bolotin.TEXT, crankshaft.TEXT)
"""Every text, in the order in which the project came by them."""


def text_named(name: str) -> list[Text]:
    """Give the text of that very name, in any case; none if there is none."""
    return [text for text in TEXTS if text.name == _as_named(name)]


def text_called(name: str) -> Text:
    """Find a text by its name, in any case, or by a part of its name that no other has.

    Raises
    ------
    InputError
        If no text has that name, with the nearest.

    Examples
    --------
    >>> text_called("Bolotin").name, text_called("synthesis").name
    ('bolotin', 'slider-crank-synthesis')
    """
    asked = _as_named(name)
    found = text_named(name) or [text for text in TEXTS if asked and asked in text.name]
    if len(found) == 1:
        return found[0]
    names = [text.name for text in found or TEXTS]
    meant = nearest(asked, names)
    allowed = _("must be the name of a text: {names}").format(names=", ".join(names))
    repair = _('write "{text}"').format(text=meant) if meant else None
    raise InputError([Problem("--source", name, allowed, repair)])


def _as_named(name: str) -> str:
    """Write a name as the texts' are."""
    return name.strip().casefold().replace("_", "-").replace(" ", "-")
