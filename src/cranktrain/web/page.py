"""What a page shows of a machine: its answer, a tab for each title of its questions, its drawing over the cycle."""

from collections.abc import Iterator
from dataclasses import replace
from functools import cache

import numpy as np

from cranktrain.analysis import Result
from cranktrain.analysis.answer import answer_titles, rows_that_say_most, rows_under
from cranktrain.analysis.minded import to_mind
from cranktrain.io.rests_on import rests_on
from cranktrain.io.title import headed
from cranktrain.language import Words, _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.layout.speed import SpeedCurve
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.panels.dead_positions import dead_positions
from cranktrain.panels.drawing import MachineDrawing
from cranktrain.panels.drawing_of_machine import machine_drawing
from cranktrain.panels.sheets import vectors_of
from cranktrain.panels.vectors import VectorsToScale, vectors_as_shown
from cranktrain.plans.placement import first_throw, place_called, throw_of
from cranktrain.record import record
from cranktrain.saying.row_table import written_group
from cranktrain.saying.row_words import row_sentence
from cranktrain.web.as_seen import in_bits_seen
from cranktrain.web.members_table import PageMembers, page_members
from cranktrain.web.other_pistons import has_others
from cranktrain.web.saved_facts import facts_beside
from cranktrain.web.start_tab import START
from cranktrain.web.tab_sheets import has_piston, named, page_sheets, questions_under, sheet_makers, without_repeated
from cranktrain.web.tabs import TabContent
from cranktrain.web.textbook_tab import TEXTBOOK
from cranktrain.web.throws import PagePiston, PageThrow, page_pistons, page_throws

_STEP = 2.0
"""Between positions of the drawing, between which a page goes on smoothly. [deg]"""
_STEP_AT_SPEEDS = 1.0
"""Between numbers of pins and links of a crank whose speed varies and may rest, about which they turn fast. [deg]"""
_VECTOR_STEP = 4.0
"""Between vectors, likewise: what stands evenly over the cycle. [deg]"""
ASKED_TABS = (START, TEXTBOOK)
"""Tabs of what is asked when somebody opens them, behind those of the questions."""


@record
class PageTab:
    """What some questions of one title answer, or what is asked when somebody opens it.

    Attributes
    ----------
    name : str
        The title whatever the language: what a link has.
    title : Words
    content : TabContent or None
        None of a tab that was not asked for.
    """

    name: str
    title: Words
    content: TabContent | None


@record
class PageCheck:
    """A check: what is compared, how it came out, and whether it holds; None where it could not be judged."""

    sentence: Words
    verdict: Words
    holds: bool | None


@record
class PageTrust:
    """What is to be minded of a machine, and its checks: of these everything has to be computed."""

    to_mind: tuple[Words, ...]
    checks: tuple[PageCheck, ...]


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
    numbers: Words
    left_out: Words
    differences: Words
    vectors: Words
    colours: Words
    colours_of_system: Words
    light: Words
    dark: Words
    ghosts: Words
    pistons: Words
    others: Words
    others_hint: Words
    throws: Words
    members: Words


@cache
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
        numbers=_("Numbers"),
        left_out=_("Not drawn, as their shaft has no place in the file:"),
        differences=_("Differences from the saved case"),
        vectors=_("Vectors on the drawing"),
        colours=_("Colours"),
        colours_of_system=_("as the system"),
        light=_("light"),
        dark=_("dark"),
        ghosts=_("Dead centres"),
        pistons=_("Piston whose throw and curves are shown"),
        others=_("Other pistons"),
        others_hint=_(
            "Thin grey: the same of the other pistons. Point at a line to see whose it is, or press their name for one"
            " after the other."
        ),
        throws=_("Throws at φ = 0, as seen from the free end"),
        members=_("Pins and links at the crank angle"),
    )


@record
class ShownMachine:
    """All that a page shows of a machine.

    Attributes
    ----------
    name, made_of : str
        Which machine it is.
    cycle : float
        Crank angle at which all begins again. [deg]
    tabs : tuple of PageTab
    trust : PageTrust or None
        None where they were not asked for.
    drawing : MachineDrawing
        A throw over the cycle, both ends included.
    members : PageMembers or None
        Its pins and links; None where they were not asked for.
    pistons : tuple of PagePiston
        Those whose throw and curves may be shown; none where there is one alone.
    throws : tuple of PageThrow
        On which they are, of shafts that have several.
    ghosts : Array
        Crank angles of its ghosts, at which its first mechanism turns back; none where nothing is drawn. [deg]
    words : PageWords
    """

    name: str
    made_of: str
    cycle: float
    tabs: tuple[PageTab, ...]
    trust: PageTrust | None
    drawing: MachineDrawing
    members: PageMembers | None
    pistons: tuple[PagePiston, ...]
    throws: tuple[PageThrow, ...]
    ghosts: Array
    words: PageWords


def machine_page(result: Result, tab: str | None = None, saved: Result | None = None, piston: str = "") -> ShownMachine:
    """Collect what a page shows of a machine.

    Parameters
    ----------
    result : Result
        Of one machine, with everything that it allows.
    tab : str, optional
        Which tab alone has its content, by its name, or the first where there is none of it; all tabs unless given, and
        what else people may ask for.
    saved : Result, optional
        Of a machine that stands beside it.
    piston : str
        Whose throw and curves are shown; the first one's where there is none of that name.

    Returns
    -------
    ShownMachine
    """
    machine = result.machines[0]
    name, made_of = headed(result)
    throw = shown_throw(machine, piston)
    titles = tab_names(result)
    asked = titles if tab is None else (tab if tab in titles else titles[0],)
    return ShownMachine(
        name=name,
        made_of=made_of,
        cycle=result.cycle,
        tabs=tuple(
            PageTab(title, _(title), tab_content(result, title, saved, piston) if title in asked else None)
            for title in titles
        ),
        trust=page_trust(result) if tab is None else None,
        drawing=machine_drawing(
            machine, _evenly(result, _STEP), mechanism=throw[0].name if throw else None, result=result
        ),
        members=page_members_of(result, piston) if tab is None else None,
        pistons=page_pistons(result),
        throws=page_throws(machine),
        ghosts=dead_positions(machine, throw[0]) if throw else np.empty(0),
        words=_page_words(),
    )


def page_members_of(result: Result, piston: str) -> PageMembers:
    """Collect pins and links of the throw of a piston; the first one's where there is none of that name."""
    step = _STEP if result.get(SpeedCurve) is None else _STEP_AT_SPEEDS
    return page_members(result, shown_throw(result.machines[0], piston), _evenly(result, step))


def _evenly(result: Result, step: float) -> Array:
    """Crank angles over the cycle, both ends included. [deg]"""
    return np.arange(0.0, result.cycle + step / 2, step)


def shown_throw(machine: Machine, piston: str) -> tuple[PlacedMechanism, ...]:
    """Give the throw of a piston, the first where there is none of that name."""
    if has_piston(machine, piston):
        return throw_of(machine, place_called(machine, piston))
    return first_throw(machine)


def tab_names(result: Result) -> tuple[str, ...]:
    """Titles of questions that have an answer or a picture, in the order in which people ask them, and what else is."""
    with_rows = answer_titles(result)
    titles = dict.fromkeys(question.title for question in result.machines[0].questions)
    of_questions = (title for title in titles if title in with_rows or any(sheet_makers(result, title)))
    return (*of_questions, *(tab.name for tab in ASKED_TABS if tab.is_there(result)))


def tab_content(result: Result, title: str, saved: Result | None = None, piston: str = "") -> TabContent:
    """Collect what stands under a title, which is the name of a tab, with rows and curves of a saved case beside."""
    for tab in ASKED_TABS:
        if tab.name == title:
            return tab.content(result)
    rows = rows_under(result, title)
    sheets = tuple(page_sheets(result, title, saved, piston))
    first = rows_that_say_most(result, title, rows)
    return TabContent(
        sentence=row_sentence(_(title), first),
        rests_on=rests_on(result, title, first),
        answer=written_group(_(title), rows),
        beside=None if saved is None else facts_beside(result, saved, title),
        sheets=tuple(without_repeated(sheets)),
        has_others=has_others(result, title, sheets),
        vectors=tuple(map(_vectors_as_seen, _vectors(result, title, piston))),
    )


def page_trust(result: Result) -> PageTrust:
    """Collect what is to be minded, and how checks came out."""
    checks = (
        PageCheck(check.sentence, check.verdict(), bool(check.passed[0]) if check.judged[0] else None)
        for check in result.checks
    )
    return PageTrust(tuple(sentence for of_sort in to_mind(result) for sentence in of_sort), tuple(checks))


def _vectors(result: Result, title: str, piston: str) -> Iterator[VectorsToScale]:
    """Give vectors of some questions on the throw that is drawn."""
    angles = _evenly(result, _VECTOR_STEP)
    for home in (one for question in questions_under(result, title) for one in vectors_of(question.name)):
        yield from named(home)(result, shown_throw(result.machines[0], piston), angles)


def _vectors_as_seen(found: VectorsToScale) -> VectorsToScale:
    """Give vectors in the unit in which they are shown, as arrows have them."""
    shown = vectors_as_shown(found)
    vectors = tuple(replace(one, value=in_bits_seen(one.value, shown.largest)) for one in shown.vectors)
    return replace(shown, vectors=vectors)
