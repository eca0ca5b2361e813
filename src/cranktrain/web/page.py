"""What a page shows of a machine: its answer, a tab for each title of its questions, its drawing over the cycle."""

from collections.abc import Callable, Iterator, Sequence
from importlib import import_module
from typing import Any, get_type_hints

import numpy as np

from cranktrain.analysis import Result
from cranktrain.analysis.minded import to_mind
from cranktrain.errors import InputError
from cranktrain.grouping import grouped
from cranktrain.io.title import headed
from cranktrain.language import Words, _
from cranktrain.layout.question import Question
from cranktrain.panels.drawing import MachineDrawing
from cranktrain.panels.drawing_of_machine import machine_drawing
from cranktrain.panels.parts import Sheet
from cranktrain.panels.picture import Picture
from cranktrain.panels.plotted import plot_of
from cranktrain.panels.shapes import Panel, as_shown
from cranktrain.panels.sheets import pictures_of
from cranktrain.plans.placement import first_throw
from cranktrain.record import record
from cranktrain.saying.row_table import WrittenGroup, written_group
from cranktrain.web.parts import PageCurves, PageNotes, PagePart, page_parts

_STEP = 2.0
"""Between positions of the drawing, between which a page goes on smoothly. [deg]"""
_MOST_PANELS = 4
"""Of curves of a question that has no sheet."""


@record
class PageSheet:
    """A sheet: its title, none of the only one of its tab, and its columns of parts."""

    title: Words
    columns: tuple[tuple[PagePart, ...], ...]


@record
class PageTab:
    """What some questions of one title answer.

    Attributes
    ----------
    title : Words
    answer : WrittenGroup
        Its rows; none where nothing can be said.
    sheets : tuple of PageSheet
    """

    title: Words
    answer: WrittenGroup
    sheets: tuple[PageSheet, ...]


@record
class PageCheck:
    """A check: what is compared, how it came out, and whether it holds; None where it could not be judged."""

    sentence: Words
    verdict: Words
    holds: bool | None


@record
class PageWords:
    """Words of a page's own: of what is on it whatever the machine."""

    drawing: Words
    angle: Words
    play: Words
    stop: Words
    back: Words
    on: Words
    keys: Words
    checks: Words
    left_out: Words


def _page_words() -> PageWords:
    """Give them."""
    return PageWords(
        drawing=_("The mechanism at a crank angle; drag to turn the crank"),
        angle=_("Crank angle"),
        play=_("Turn the crank"),
        stop=_("Stop the crank"),
        back=_("1° back"),
        on=_("1° on"),
        keys=_("space turns and stops · ← → 1°, with shift 10° · Home 0°"),
        checks=_("Checks"),
        left_out=_("Not drawn, as their shaft has no place in the file:"),
    )


@record
class ShownMachine:
    """All that a page shows of a machine.

    Attributes
    ----------
    name, made_of : str
        Which machine it is.
    to_mind : tuple of Words
        What is to be minded of it.
    cycle : float
        Crank angle at which all begins again. [deg]
    speed : float
        Of the main shaft, 0 of one that is not said. [rad/s]
    tabs : tuple of PageTab
    checks : tuple of PageCheck
    drawing : MachineDrawing
        Its first throw over the cycle, both ends included.
    words : PageWords
    """

    name: str
    made_of: str
    to_mind: tuple[Words, ...]
    cycle: float
    speed: float
    tabs: tuple[PageTab, ...]
    checks: tuple[PageCheck, ...]
    drawing: MachineDrawing
    words: PageWords


def machine_page(result: Result) -> ShownMachine:
    """Collect what a page shows of a machine.

    Parameters
    ----------
    result : Result
        Of one machine, with everything that it allows.

    Returns
    -------
    ShownMachine
    """
    machine = result.machines[0]
    name, made_of = headed(result)
    throw = first_throw(machine)
    speed = machine.main_shaft.speed
    return ShownMachine(
        name=name,
        made_of=made_of,
        to_mind=tuple(sentence for of_sort in to_mind(result) for sentence in of_sort),
        cycle=result.cycle,
        speed=0.0 if speed is None else speed.si,
        tabs=tuple(_tabs(result)),
        checks=tuple(_checks(result)),
        drawing=machine_drawing(
            machine, np.arange(0.0, result.cycle + _STEP / 2, _STEP), mechanism=throw[0].name if throw else None
        ),
        words=_page_words(),
    )


def _tabs(result: Result) -> Iterator[PageTab]:
    """Give the tabs of questions that answer something, in the order in which people ask them."""
    rows = {str(title): lines for title, lines in result.answer_rows()}
    questions = grouped((question.title, question) for question in result.machines[0].questions)
    for title, alike in questions.items():
        said = _(title)
        sheets = tuple(_sheets(result, alike))
        if sheets or str(said) in rows:
            yield PageTab(said, written_group(said, rows.get(str(said), ())), sheets)


def _sheets(result: Result, questions: Sequence[Question]) -> Iterator[PageSheet]:
    """Give the sheets of some questions; of those without one some of their curves."""
    makers = [maker for question in questions for one in pictures_of(question.name) if (maker := _maker(one, result))]
    for make in makers:
        try:
            sheet: Sheet = make(result)
        except InputError as error:  # it says what the file lacks
            yield PageSheet("", ((PageNotes(tuple(str(problem) for problem in error.problems)),),))
        else:
            yield PageSheet(sheet.title, tuple(tuple(page_parts(column.parts)) for column in sheet.columns))
    panels = () if makers else tuple(_curves(result, questions))
    if panels:
        yield PageSheet("", ((PageCurves(panels, _("Crank angle φ, °"), is_stack=True),),))


def _maker(picture: Picture, result: Result) -> Callable[..., Any] | None:
    """Find what makes a picture over the cycle, if it is a sheet as data of which the result has what it needs."""
    if picture.over != "cycle" or not all(name in result.catalogue for name in picture.needs):
        return None
    home, _colon, name = picture.home.partition(":")
    function = getattr(import_module(home), name)
    return function if get_type_hints(function).get("return") is Sheet else None


def _curves(result: Result, questions: Sequence[Question]) -> Iterator[Panel]:
    """Give the first curves of some questions."""
    names = [name for question in questions for stage in question.stages for name in stage.results]
    curves = [name for name in names if name in result.catalogue and result.is_curve(result.catalogue[name])]
    for name in curves[:_MOST_PANELS]:
        for panel in plot_of(result, name).panels:
            if isinstance(panel, Panel):
                yield as_shown(panel)


def _checks(result: Result) -> Iterator[PageCheck]:
    """Say of every check whether it holds."""
    for check in result.checks:
        yield PageCheck(check.sentence, check.verdict(), bool(check.passed[0]) if check.judged[0] else None)
