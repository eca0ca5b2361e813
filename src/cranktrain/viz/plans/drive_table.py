"""The table of a drive: its shafts with their speeds and inertias, and below each what stands on it, by number."""

import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.language import said as _
from cranktrain.panels.figures import figure, with_unit
from cranktrain.panels.formulas import mathematics
from cranktrain.plans.drive_scheme import MEANINGS, ChainFact, DriveElement, DriveShaft
from cranktrain.quantities import shown
from cranktrain.saying.scales import scale_for
from cranktrain.viz.plans.drive_chain import roman

_LETTER = 1.56
"""Mean width of a letter of text. [mm]"""
_INDEXED = re.compile(r"(?:^|(?<=, ))[^\W\d_]_\w+")
"""A fact's letter with an index."""


class DriveRow(NamedTuple):
    """A row: what, and its numbers; bold of a shaft."""

    words: str
    facts: tuple[str, ...] = ()
    is_shaft: bool = False

    @property
    def cells(self) -> tuple[str, str]:
        """Words and numbers."""
        return self.words, ", ".join(self.facts)

    @property
    def cells_set(self) -> tuple[str, str]:
        """The same on paper, where letters have their indices below."""
        return self.words, with_indices(", ".join(self.facts))


def drive_rows(chain: Sequence[DriveShaft], shaft_letter: str, width: float) -> list[DriveRow]:
    """Rows of a drive's table, each no wider than a room [mm]; numbers that do not fit beside their words go on below.

    `shaft_letter` is that of the crank's shaft in the mechanism's own scheme.
    """
    return [part for row in _rows(chain, shaft_letter) for part in _folded(row, int(width / _LETTER))]


def meanings(chain: Sequence[DriveShaft], width: float) -> list[str]:
    """Lines, no wider than a room [mm], that say what the letters of a table stand for."""
    letters = {fact.letter for shaft in chain for one in shaft.elements for fact in one.facts}
    said = [f"{letter} {_(words)}" for letter, words in MEANINGS.items() if letter in letters]
    return [", ".join(row) for row in _filled(said, 0, int(width / _LETTER))]


def with_indices(facts: str) -> str:
    """Set the letters of facts that have an index as mathematics."""
    return _INDEXED.sub(lambda found: mathematics(found[0]), facts)


def _rows(chain: Sequence[DriveShaft], letter: str) -> Iterator[DriveRow]:
    """Rows before they are folded."""
    number = 0
    for place, shaft in enumerate(chain, start=1):
        inertia = (_written(ChainFact("J", shaft.inertia, "kg*m^2")),) if shaft.inertia > 0 else ()
        speed = (f"{figure(shown(shaft.speed, 'rpm'))} rpm",) if np.isfinite(shaft.speed) else ()
        yield DriveRow(_("Shaft {numeral}", numeral=roman(place)), (*speed, *inertia), is_shaft=True)
        for one in shaft.elements:
            number += 1
            yield DriveRow(f"{number}  {_words(one, letter)}", tuple(map(_written, one.facts)))


def _words(one: DriveElement, letter: str) -> str:
    """What an element is; of the crank's shaft that it is the mechanism's."""
    if one.symbol != "crank" or not letter:
        return str(one.words)
    return _("{shaft} {letter}, the same as in the mechanism", shaft=one.words, letter=letter.replace("_", ""))


def _written(fact: ChainFact) -> str:
    """A number with its letter and unit."""
    if fact.unit == "1":
        return f"{fact.letter} = {fact.value:.4g}".replace("-", "−")
    if fact.unit == "rad/s":
        return f"{fact.letter} = {figure(shown(fact.value, 'rpm'))} rpm"
    return f"{fact.letter} = {with_unit(fact.value, scale_for(fact.unit, fact.value))}"


def _folded(row: DriveRow, most: int) -> Iterator[DriveRow]:
    """A row, and what goes on below it."""
    first, *rest = _filled(row.facts, len(row.words) + 2, most)
    yield row._replace(facts=first)
    yield from (DriveRow("", facts) for facts in rest)


def _filled(words: Sequence[str], begun: int, most: int) -> list[tuple[str, ...]]:
    """Divide words among lines of so many letters at most, the first of which has some already."""
    lines: list[tuple[str, ...]] = [()]
    used = begun
    for one in words:
        size = len(one) + 2
        if used + size > most and used > 0:
            lines.append(())
            used = 0
        lines[-1] = (*lines[-1], one)
        used += size
    return lines
