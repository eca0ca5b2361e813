"""The five texts: what each holds, how far it is right, and which command shows it. One table of data for each text."""

import re
from collections.abc import Sequence

from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.quantities import nearest
from cranktrain.texts.contents import bolotin, crankshaft, gandzha, steam_engine, synthesis
from cranktrain.texts.contents.text import Formula, Text

__all__ = ["TEXTS", "Formula", "Text", "numbers_in", "plain_number", "text_called", "text_named", "with_equation"]

TEXTS: tuple[Text, ...] = (steam_engine.TEXT, gandzha.TEXT, synthesis.TEXT, bolotin.TEXT, crankshaft.TEXT)
"""Every text, in the order in which the project came by them."""

_PART = 3
"""So many letters of a name may stand for it: fewer are in names by chance."""


def text_named(name: str) -> list[Text]:
    """Give the text of that very name, letter or author, in any case; none if there is none."""
    asked = _as_named(name)
    return [text for text in TEXTS if asked in map(str.casefold, (text.name, text.letter, *text.authors))]


def with_equation(number: str, texts: Sequence[Text] = TEXTS) -> list[tuple[Text, Formula]]:
    """Find the formulas and figures of some texts by the number that these give them, with or without brackets.

    Examples
    --------
    >>> [(text.name, formula.number) for text, formula in with_equation("i.13")][:1]
    [('bolotin', '(I.13)')]
    >>> with_equation("2000")
    []
    """
    asked = plain_number(number)
    return [(text, formula) for text in texts for formula in text.formulas if asked in numbers_in(formula.number)]


def numbers_in(numbered: str) -> set[str]:
    """What a formula may be asked for by: all that stands for its number, and each number in brackets there; plain."""
    return {plain_number(numbered), *map(plain_number, re.findall(r"\([^)]*\)", numbered))}


def plain_number(number: str) -> str:
    """Write a number without what people leave out: brackets, spaces, case; I is a letter in either alphabet."""
    return re.sub(r"[()\s]", "", number.casefold()).replace("і", "i")


def text_called(name: str, asked_as: str = "--source") -> Text:
    """Find a text by its name, letter or author, in any case, or by a part of its name that no other has.

    Parameters
    ----------
    name : str
    asked_as : str
        What a problem with it is called.

    Raises
    ------
    InputError
        If no text has that name, with the nearest.

    Examples
    --------
    >>> text_called("Bolotin").name, text_called("synthesis").name, text_called("ганджа").name, text_called("E").name
    ('bolotin', 'slider-crank-synthesis', 'gandzha', 'crankshaft-reactions')
    """
    asked = _as_named(name)
    found = text_named(name) or [text for text in TEXTS if len(asked) >= _PART and asked in text.name]
    if len(found) == 1:
        return found[0]
    names = [text.name for text in found or TEXTS]
    meant = nearest(asked, names)
    allowed = _("must be the name of a text, its letter or its author: {names}").format(
        names=", ".join(f"{text.letter} {text.name}" for text in found or TEXTS)
    )
    repair = _('write "{text}"').format(text=meant) if meant else None
    raise InputError([Problem(asked_as, name, allowed, repair)])


def _as_named(name: str) -> str:
    """Write a name as the texts' are."""
    return name.strip().casefold().replace("_", "-").replace(" ", "-")
