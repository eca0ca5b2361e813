"""The head of a sheet: the machine, its speed and conventions, where its numbers are from, and what is not used."""

from collections.abc import Sequence
from textwrap import wrap

from cranktrain.io.description import counted_by_status, given_numbers, layout_words, longer_cycle_words
from cranktrain.language import said as _
from cranktrain.layout.speed import SpeedCurve
from cranktrain.machine import Machine
from cranktrain.one_line import short
from cranktrain.panels.parts import Sheet
from cranktrain.quantities import shown
from cranktrain.saying.wording import as_given, first_that_holds
from cranktrain.viz.paper.page import MARGIN, Box, Page, paper
from cranktrain.viz.paper.style import MUTED, TITLE

_LONGEST_NAME = 100
"""Characters of a title."""

_LETTERS = 60
"""Letters in a line, for each 100 mm."""


def headed_page(sheet: Sheet, size: str) -> tuple[Page, Box]:
    """Begin a sheet; give the room below its head."""
    page = Page(*paper(size))
    top = title_block(page, sheet.machine, str(sheet.title), str(sheet.at_speed), list(map(str, sheet.unused)))
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
    zero = _zero_words(machine)
    page.text(MARGIN, top - 14.5, f"{title}. {zero}" if title else zero, color=MUTED)
    page.text(page.width - MARGIN, top - 10.0, provenance_words(machine), ha="right")
    letters = int((page.width - 2 * MARGIN) * _LETTERS / 100.0)
    for line in [*([at_speed] if at_speed else []), *(line for sentence in unused for line in wrap(sentence, letters))]:
        page.text(MARGIN, top - 19.0, line)
        top -= 4.5
    page.rule(top - 17.5)
    return top - 17.5


def running_words(machine: Machine) -> str:
    """Say speed and sense of rotation, at one moment the angular acceleration; and that a cycle has two turns."""
    senses = {
        ("clockwise", "ahead"): _("clockwise"),
        ("anticlockwise", "ahead"): _("anticlockwise"),
        ("clockwise", "astern"): _("astern, anticlockwise"),
        ("anticlockwise", "astern"): _("astern, clockwise"),
    }
    shaft = machine.main_shaft
    given = (("n", shaft.speed, "rpm"), ("ε", shaft.acceleration, "rad/s²"))
    said = [f"{symbol} = {as_given(one, usual)}" for symbol, one, usual in given if one is not None]
    sense = senses[machine.rotation, machine.running]
    turning = sense if said else sense[:1].upper() + sense[1:]
    return ", ".join(filter(None, (*said, turning, longer_cycle_words(machine))))


def speed_words(curve: SpeedCurve | None, design: int = 0) -> str:
    """Say at which speed over the cycle a picture is, as the terminal does; nothing of a constant one."""
    return "" if curve is None else str(curve.condition(design))


def _zero_words(machine: Machine) -> str:
    """Say where the crank angle is 0 and how it counts."""
    axis = first_that_holds(
        (len(machine.bank) > 1, _("the axis of bank {bank}")),
        (len(machine.bank) == 1, _("the first cylinder's axis")),
        (True, _("the mechanism's x")),
    ).format(bank=next(iter(machine.bank), ""))
    ahead = 0.0 if machine.crank_zero == "Y" else machine.crank_zero.si
    start = first_that_holds(
        (machine.crank_zero == "Y", _("φ = 0 where crank 1 points up")),
        (ahead > 0.0, _("φ = 0 where crank 1 is {angle} ahead of {axis}")),
        (ahead < 0.0, _("φ = 0 where crank 1 is {angle} behind {axis}")),
        (True, _("φ = 0 where crank 1 is on {axis}")),
    ).format(angle=f"{shown(abs(ahead), 'deg'):.2f}°", axis=axis)
    return _("{start}; counted in the sense of running; seen from the free end", start=start)


def provenance_words(machine: Machine) -> str:
    """Count the numbers that a machine's file gives by where they are from."""
    return _("Inputs: {counts}", counts=counted_by_status(given_numbers(machine)))
