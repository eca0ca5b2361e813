"""The head of a sheet: the machine, at which speed, where its numbers are from, and what is not used."""

from collections.abc import Sequence
from textwrap import wrap

from cranktrain.analysis import Result, sentences
from cranktrain.io.description import layout_words
from cranktrain.language import _
from cranktrain.layout.speed import SpeedCurve
from cranktrain.machine import Machine
from cranktrain.one_line import short
from cranktrain.viz.paper.page import MARGIN, Box, Page, paper
from cranktrain.viz.paper.style import MUTED, TITLE
from cranktrain.viz.paper.words import (
    provenance_words,
    running_words,
    speed_words,
    zero_words,
)

_LONGEST_NAME = 100
"""Characters of a title."""

_LETTERS = 60
"""Letters in a line, for each 100 mm."""


def result_page(result: Result, design: int, size: str, title: str = "") -> tuple[Page, Box]:
    """Begin a sheet of a result; give the room below its head."""
    page = Page(*paper(size))
    at_speed = speed_words(result.get(SpeedCurve), design)
    top = title_block(page, result.machines[design], title, at_speed, sentences(result.unused))
    return page, Box(MARGIN, MARGIN, page.width - 2 * MARGIN, top - 4.0 - MARGIN)


def title_block(page: Page, machine: Machine, title: str = "", at_speed: str = "", unused: Sequence[str] = ()) -> float:
    """Head a sheet, and say where not at a constant speed at which one, and what is not used; give where it ends. [mm]

    Each sentence of unused has lines of its own.
    """
    top = page.height - MARGIN
    name = short(machine.name, _LONGEST_NAME) or _("Machine without a name")
    page.text(MARGIN, top - 4.5, name, fontsize=TITLE, fontweight="bold")
    layout = layout_words(machine)
    page.text(MARGIN, top - 10.0, f"{layout[:1].upper()}{layout[1:]}. {running_words(machine)}")
    zero = zero_words(machine)
    page.text(MARGIN, top - 14.5, f"{title}. {zero}" if title else zero, color=MUTED)
    page.text(page.width - MARGIN, top - 10.0, provenance_words(machine), ha="right")
    letters = int((page.width - 2 * MARGIN) * _LETTERS / 100.0)
    for line in [*([at_speed] if at_speed else []), *(line for sentence in unused for line in wrap(sentence, letters))]:
        page.text(MARGIN, top - 19.0, line)
        top -= 4.5
    page.rule(top - 17.5)
    return top - 17.5
