"""A sweep as other programs take it: what is varied, and facts over it as arrays."""

from collections.abc import Callable
from dataclasses import replace
from math import prod

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.language import Words, _
from cranktrain.motion import Array
from cranktrain.panels.parts import Notes, Stack
from cranktrain.panels.shapes import Map, Panel, map_as_shown
from cranktrain.panels.swept import plot_of_sweep
from cranktrain.record import record
from cranktrain.saying.names import said_name
from cranktrain.saying.scales import in_asked_unit
from cranktrain.study.facts_of_rows import FactsOfRows
from cranktrain.study.sweep import Sweep, swept
from cranktrain.study.sweep.blocks import Blocks
from cranktrain.study.sweep.kept import InMemory, Plan
from cranktrain.study.sweep.varied import n_values
from cranktrain.web.asked import HowFar, SweepQuestion
from cranktrain.web.case import machine_file_of
from cranktrain.web.packed import Packed, packed
from cranktrain.web.parts import PageMaps, page_curves
from cranktrain.web.tabs import PageSheet

_MOST_DESIGNS = 10_000
"""Of one sweep."""


@record
class SweptValues:
    """Values of a place of the file.

    Attributes
    ----------
    path : str
    name : Words
        What people call it.
    texts : tuple of str
        As they would be typed.
    numbers : Array or None, shape (value,)
        In `unit`; None of words.
    unit : str
    """

    path: str
    name: Words
    texts: tuple[str, ...]
    numbers: Array | None
    unit: str


@record
class SweptFact:
    """A fact of all designs.

    Attributes
    ----------
    name : str
        As results have it.
    title, of : Words
        What people call it, and of which member it is; nothing where all are alike.
    unit : str
    values : Array, along what is varied
        NaN where a design cannot be.
    """

    name: str
    title: Words
    of: Words
    unit: str
    values: Array


@record
class SweptDesignsOfPage:
    """A sweep: what is varied, facts, how they are drawn, and what is to be minded of them."""

    varied: tuple[SweptValues, ...]
    facts: tuple[SweptFact, ...]
    sheet: PageSheet
    minded: tuple[Words, ...]


class _Counted(InMemory):
    """Keeps facts, and says how many designs have theirs."""

    def __init__(self, say: Callable[[HowFar], None]) -> None:
        super().__init__()
        self._say, self._how_far = say, HowFar()

    def begin(self, plan: Plan, blocks: Blocks) -> None:
        """Make room."""
        super().begin(plan, blocks)
        self._how_far = HowFar(0, len(plan.designs))

    def add(self, number: int, found: FactsOfRows, *, is_lost: bool = False) -> None:
        """Keep a block."""
        super().add(number, found, is_lost=is_lost)
        self._how_far = self._how_far._replace(done=self._how_far.done + len(found.refused))
        self._say(self._how_far)


def packed_sweep(question: SweepQuestion, say: Callable[[HowFar], None]) -> Packed:
    """Compute a sweep, and pack it; `say` is called when some designs are done.

    Raises
    ------
    InputError
        With all that is wrong with the machine, or with what is asked.
    """
    vary = dict(question.vary)
    n_designs = prod(map(n_values, vary.values()))
    if n_designs > _MOST_DESIGNS:
        allowed = _("is {n} designs, and may be {most} here", n=n_designs, most=_MOST_DESIGNS)
        raise InputError([Problem("vary", None, allowed, _("ask for fewer values, or use `cranktrain sweep`"))])
    file = machine_file_of(question.case)
    set_before = [setting.partition("=")[0].strip() for setting in question.case.settings]
    found = swept(file.machine, vary, question.wanted or None, settings=set_before, store=_Counted(say))
    with found.in_its_units():
        return packed(_columns(found))


def _columns(found: Sweep) -> SweptDesignsOfPage:
    """Give a sweep as columns."""
    varied = tuple(
        SweptValues(one.path, said_name(one.spoken), tuple(map(str, one.texts)), one.numbers, one.unit)
        for one in found.designs.varied
    )
    facts: list[SweptFact] = []
    for name, entry in found.catalogue.items():
        for of, own in found.apart(name):
            unit, values = in_asked_unit(entry.unit, own, entry.shown)
            facts.append(SweptFact(name, said_name(name), of, unit, values))
    minded = tuple(words for head, words in found.about() if head == "minded")
    return SweptDesignsOfPage(varied, tuple(facts), _sheet(found), minded)


def _whole(panel: Panel) -> Panel:
    """Give a panel that is drawn from its first design to its last."""
    return replace(panel, reach=(float(np.min(panel.across)), float(np.max(panel.across))))


def _sheet(found: Sweep) -> PageSheet:
    """Draw a sweep: curves over one number, maps over two."""
    try:
        plot = plot_of_sweep(found)
    except InputError as error:  # words alone are varied
        return PageSheet("", ((Notes(tuple(str(problem) for problem in error.problems)),),))
    maps = tuple(one for one in plot.panels if isinstance(one, Map))
    panels = tuple(one for one in plot.panels if isinstance(one, Panel))
    over = plot.over or ""
    drawn = (
        PageMaps(tuple(map(map_as_shown, maps)), over) if maps else page_curves(Stack(tuple(map(_whole, panels))), over)
    )
    return PageSheet("", ((drawn, *([Notes((plot.note,))] if plot.note else [])),))
