"""Sheets under a title as a page draws them; those of one piston of the one that is chosen."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import cache
from importlib import import_module
from inspect import signature
from itertools import zip_longest
from typing import Any, get_type_hints

from cranktrain.analysis import Result
from cranktrain.errors import InputError
from cranktrain.language import _
from cranktrain.layout.question import Question
from cranktrain.machine import Machine
from cranktrain.panels.parts import Notes, Sheet, SheetColumn, Stack
from cranktrain.panels.plotted import plot_of
from cranktrain.panels.shapes import Panel
from cranktrain.panels.sheets import pictures_of
from cranktrain.web.parts import page_curves, page_parts
from cranktrain.web.tabs import PageSheet, lacking_sheet

_MOST_PANELS = 4
"""Of curves of a question that has no sheet."""


def page_sheets(result: Result, title: str, saved: Result | None, piston: str) -> Iterator[PageSheet]:
    """Give the sheets of the questions of a title, with a saved case's curves; of those without one some curves."""
    makers = list(sheet_makers(result, title))
    for make in makers:
        try:
            sheet = made_sheet(result, make, piston)
        except InputError as error:
            yield lacking_sheet(error)
        else:
            beside = [column.parts for column in columns_beside(saved, title, make, piston)]
            parts = zip_longest((column.parts for column in sheet.columns), beside[: len(sheet.columns)], fillvalue=())
            yield PageSheet(sheet.title, tuple(tuple(page_parts(*each)) for each in parts))
    panels, others = (() if makers or one is None else tuple(_curves(one, title)) for one in (result, saved))
    if panels:
        curves = page_curves(Stack(panels), _("Crank angle φ, °"), Stack(others))
        yield PageSheet("", ((curves,),))


def without_repeated(sheets: Iterable[PageSheet]) -> Iterator[PageSheet]:
    """Leave out sheets that say of the file what one before has said."""
    told: set[tuple[str, ...]] = set()
    for sheet in sheets:
        match sheet.columns:
            case ((Notes(sentences=sentences),),):
                if (said := tuple(map(str, sentences))) in told:
                    continue
                told.add(said)
            case _:
                pass
        yield sheet


def sheet_makers(result: Result, title: str) -> Iterator[Callable[..., Any]]:
    """Find what makes pictures over the cycle that are sheets as data, of which the result has what they need."""
    for picture in (one for question in questions_under(result, title) for one in pictures_of(question.name)):
        if picture.over == "cycle" and all(name in result.catalogue for name in picture.needs):
            function = named(picture.home)
            if _makes_sheet(function):
                yield function


@cache
def _makes_sheet(function: Callable[..., Any]) -> bool:
    """Whether a picture is a sheet as data."""
    return get_type_hints(function).get("return") is Sheet


def questions_under(result: Result, title: str) -> list[Question]:
    """Questions of a title."""
    return [question for question in result.machines[0].questions if question.title == title]


def named(home: str) -> Callable[..., Any]:
    """Find a function, `module:function`."""
    place, _colon, name = home.partition(":")
    return getattr(import_module(place), name)


def is_of_one_piston(make: Callable[..., Any]) -> bool:
    """Whether a sheet is of a piston that may be chosen."""
    return "piston" in signature(make).parameters


def has_piston(machine: Machine, name: str) -> bool:
    """Whether a machine has a piston of a name."""
    return any(place.name == name for place in machine.design.pistons)


def made_sheet(result: Result, make: Callable[..., Any], piston: str) -> Sheet:
    """Make a sheet, of the piston where it is one's and there is one of that name.

    Raises
    ------
    InputError
        With what the file lacks.
    """
    chosen = {"piston": piston} if is_of_one_piston(make) and has_piston(result.machines[0], piston) else {}
    return make(result, **chosen)


def columns_beside(saved: Result | None, title: str, make: Callable[..., Any], piston: str) -> Sequence[SheetColumn]:
    """Make the same sheet of a saved case, if that has all for it; give its columns."""
    if saved is None or make not in sheet_makers(saved, title):
        return ()
    try:
        return made_sheet(saved, make, piston).columns
    except InputError:  # where it is the machine that is shown, it says what its file lacks
        return ()


def _curves(result: Result, title: str) -> Iterator[Panel]:
    """Give the first curves of the questions of a title, in SI."""
    names = [name for question in questions_under(result, title) for stage in question.stages for name in stage.results]
    curves = [name for name in names if name in result.catalogue and result.is_curve(result.catalogue[name])]
    for name in curves[:_MOST_PANELS]:
        for panel in plot_of(result, name).panels:
            if isinstance(panel, Panel):
                yield panel
