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

_SPELLINGS = (
    (r"^(?:eqs?|equation|ф-?ла|формула)\.?(?=[\di])", ""),
    (r"^(?:figs?|figure|рис|рисунок)\.?(?=\d)", "fig."),
    (r"^(?:pp?|page|с|стр)\.?(?=\d)", "p."),
    (r"^i(?=\d)", "i."),
)
"""How people write numbers of formulas, figures and pages, and how the texts' contents have them, plain."""

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
    spelt = (asked, f"fig.{asked}", f"p.{asked}") if re.fullmatch(r"\d[\d.]*", asked) else (asked,)
    found: list[tuple[Text, Formula]] = []
    for one in spelt:
        found = [(text, formula) for text in texts for formula in text.formulas if one in numbers_in(formula.number)]
        if found:
            break
    return found


def numbers_in(numbered: str) -> set[str]:
    """What a formula may be asked for by: all that stands for its number, and each number in brackets there; plain."""
    figures = re.findall(r"(?:fig|p)\.\s*\d[\d.]*", numbered)
    return {*map(plain_number, (numbered, *re.findall(r"\([^)]*\)", numbered), *figures))}


def plain_number(number: str) -> str:
    """Write a number without what people leave out: brackets, spaces, case; I is a letter in either alphabet.

    Examples
    --------
    >>> plain_number("(I.13)"), plain_number("I13"), plain_number("eq 44"), plain_number("Рис. 35"), plain_number("p14")
    ('i.13', 'i.13', '44', 'fig.35', 'p.14')
    """
    plain = re.sub(r"[()\s]", "", number.casefold()).replace("і", "i")
    for pattern, instead in _SPELLINGS:
        plain = re.sub(pattern, instead, plain)
    return plain


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
    allowed = _(
        "must be the name of a text, its letter or its author: {names}",
        names=", ".join(f"{text.letter} {text.name}" for text in found or TEXTS),
    )
    repair = _('write "{text}"', text=meant) if meant else None
    raise InputError([Problem(asked_as, name, allowed, repair)])


def _as_named(name: str) -> str:
    """Write a name as the texts' are."""
    return name.strip().casefold().replace("_", "-").replace(" ", "-")
