"""What is wrong in the texts: each wrong step with the number that it gives and the right one."""

import re
from collections.abc import Iterator

import numpy as np

from cranktrain.language import N_, Words, _
from cranktrain.saying.wording import in_print
from cranktrain.textbook.statements import Heading, Statement, Statements
from cranktrain.texts.contents import TEXTS, text_called
from cranktrain.texts.errata import ERRATA
from cranktrain.texts.wrong_step import WrongStep

LARGEST_ERROR = "largest error"
"""What the number is of a step that is off by that: in parts of the stroke, or of the exact peak."""

_IN_SI = {"mm": ("m", 1e-3), "kN": ("N", 1e3), "%": ("1", 1e-2)}
_SHOWN = {"m": ("mm", 1e3, 5), "rad": ("°", 180 / np.pi, 4)}
"""How they are written: unit, how many of it one in SI is, and figures; the rest with four figures as they are."""


def errata(source: str | None = None) -> Statements:
    """Give what is wrong in the texts, or in one of them.

    Parameters
    ----------
    source : str, optional
        A text by its name, letter or author; all unless given.

    Returns
    -------
    Statements
        Of each wrong step `symbol` is what is printed, `value` what that gives and `exact` what is right, NaN where the
        step has no such number; why it is wrong is among the notes by its name.

    Raises
    ------
    InputError
        If no text has that name.

    Examples
    --------
    >>> rod = errata("C").each[0]
    >>> rod.name, rod.symbol, round(rod.value, 4), round(rod.exact, 4), rod.unit
    ('Rod from the permissible pressure angle', 'l = r/tg [α]', 0.1386, 0.16, 'm')
    >>> errata("C").notes[rod.name]
    ('the pressure angle is largest at 90°, sin α = r/l, not where crank and rod stand square, at 60°',)
    """
    names = [text.name for text in TEXTS] if source is None else [text_called(str(source), "source").name]
    steps = [(name, step) for name in names for step in ERRATA[name]()]
    return Statements(
        _("Errors of the sources, each with what is right"),
        tuple(_statement(name, step) for name, step in steps),
        np.zeros(0),
        sentences={_words(step): (_(step.why),) for _source, step in steps},
    )


def amounts(one: Statement) -> Iterator[tuple[str, str]]:
    """Write the number that a wrong step gives and the right one, as far as there are such.

    Each has its head, which is translated where it is shown.

    Examples
    --------
    >>> list(amounts(errata("C").each[1]))
    [('gives', '35.26°'), ('right', '30°')]
    """
    if np.isfinite(one.value):
        yield N_("gives"), _written(one.value, one)
    if np.isfinite(one.exact):
        yield N_("right"), _written(one.exact, one)


def _statement(source: str, step: WrongStep) -> Statement:
    unit, size = _IN_SI.get(step.unit, (step.unit, 1.0))
    return Statement(
        source=source,
        equation=" ".join(re.findall(r"\((?:I\.)?\d+\)", step.step)),
        symbol=step.printed,
        words=_words(step),
        of="",
        at=LARGEST_ERROR if step.unit == "%" else "",
        value=np.nan if step.got is None else size * step.got,
        unit=unit,
        verdict="printed",
        exact=np.nan if step.right is None else size * step.right,
    )


def _words(step: WrongStep) -> Words:
    """What a step is, as a heading."""
    return Heading(_(step.step))


def _written(value: float, one: Statement) -> str:
    """Write a number with the figures that the sources have at most."""
    unit, size, figures = ("%", 100.0, 4) if one.at == LARGEST_ERROR else _SHOWN.get(one.unit, (one.unit, 1.0, 4))
    between = "" if unit == "°" else " "
    return in_print(f"{size * value:.{figures}g}{between}{unit}".removesuffix(" 1"))
