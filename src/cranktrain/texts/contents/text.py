"""What a text holds: its formulas and figures, each with its range, its verdict and the command that shows it."""

import re
from typing import Literal

from cranktrain.language import N_, Words, _
from cranktrain.record import record

Verdict = Literal["right", "right in a range", "wrong"]

_VERDICTS = {
    ("right", True): N_("right"),
    ("right", False): N_("right, not computed"),
    ("right in a range", True): N_("right in a range"),
    ("right in a range", False): N_("right in a range, not computed"),
    ("wrong", True): N_("wrong, corrected"),
    ("wrong", False): N_("wrong, not computed"),
}


_SHORT = 12
"""A longer number is a formula, by which nobody asks."""


@record
class Formula:
    """A formula or figure of a text, or what it says without a number.

    Attributes
    ----------
    number : str
        The text's own: `(333)`, `fig. 147`; of what has none the formula itself or the page.
    subject : str
        What it is, in a few words; translated where it is shown, like `valid` and `note`.
    verdict : "right", "right in a range" or "wrong"
        Wrong is what is printed; what is computed is right.
    command : str
        What shows it, on the text's own numbers or an example; empty where nothing computes it.
    valid : str
        Its range of validity; empty where it needs none.
    note : str
        How far it is off, what is wrong with it, and what is right.
    of_machine : str
        What shows it of an engine, drive or mechanism of the examples; empty where `command` does.
    """

    number: str
    subject: str
    verdict: Verdict
    command: str = ""
    valid: str = ""
    note: str = ""
    of_machine: str = ""

    @property
    def commands(self) -> tuple[str, ...]:
        """All that show it."""
        return tuple(filter(None, (self.command, self.of_machine)))

    @property
    def verdict_words(self) -> Words:
        """The verdict in words, with whether anything computes it."""
        return _(_VERDICTS[self.verdict, bool(self.command)])

    @property
    def said_verdict(self) -> str:
        """The same, in the reader's language."""
        return str(self.verdict_words)


@record
class Text:
    """One of the texts.

    Attributes
    ----------
    name : str
        By which it is asked for: its citation key, see `cranktrain.references`.
    title : str
        What it is about; translated where it is shown, like `said_of`.
    said_of : str
        What it speaks of.
    formulas : tuple of Formula
        In its order.
    letter : str
        By which the texts are counted, A to E.
    authors : tuple of str
        As they are written; none where the text names none.
    of_machine : str
        The module of `cranktrain.textbook.shown` that gives what it has for a machine; none where it has nothing.
    """

    name: str
    title: str
    said_of: str
    formulas: tuple[Formula, ...]
    letter: str
    authors: tuple[str, ...] = ()
    of_machine: str = ""

    @property
    def number_ranges(self) -> tuple[str, ...]:
        """By what its formulas, figures and pages are asked for, with numbers that follow one another as a range."""
        found: list[list[str]] = []
        for number in dict.fromkeys(one.number for one in self.formulas if len(one.number) <= _SHORT):
            if found and number.startswith("(") and _after(found[-1][-1]) == number:
                found[-1].append(number)
            else:
                found.append([number])
        return tuple(f"{one[0]}–{one[-1]}" if len(one) > 1 else one[0] for one in found)


def _after(number: str) -> str:
    """The next number in brackets: `(I.12)` after `(I.11)`; none after what is no number."""
    match = re.fullmatch(r"(\(\D*)(\d+)\)", number)
    return f"{match[1]}{int(match[2]) + 1})" if match else ""
