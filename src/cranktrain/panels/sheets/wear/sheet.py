"""The sheet of wear: mean load on the rays of crank pins, journals and their bearings, and where oil holes go."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.analysis import Result
from cranktrain.errors import InputError, Problem
from cranktrain.language import Listed, Message, _
from cranktrain.panels.design import OneDesign
from cranktrain.panels.parts import Notes, Sheet, SheetColumn, WearCircles, sheet_of
from cranktrain.panels.shapes import Rays
from cranktrain.panels.sheets.crankshaft.panels import chosen_methods
from cranktrain.panels.sheets.wear.panels import journal_wear, pin_wear
from cranktrain.questions.crankshaft.methods import title_of

_ROW = 8
"""Circles in a row, at most."""


def sheet_wear(result: Result, *, design: int = 0, method: str | None = None) -> Sheet:
    """Collect the wear of crank pins, journals and bearings, by the rule of ±60°.

    Parameters
    ----------
    result : Result
        Of a machine with rods on crank pins; with [crankshaft] journals and bearings, too.
    design : int
        Which of the result's machines.
    method : str, optional
        By which method journals and bearings are loaded, `split`; several with commas between, or `all`, one below the
        other to one scale, without the pins. The most trusted unless given.

    Returns
    -------
    Sheet

    Raises
    ------
    InputError
        If nothing has a load, or none by a method.
    """
    shown = OneDesign(result, design)
    places = chosen_methods(shown, method)
    groups = [[one for one in group if np.all(np.isfinite(one.size))] for group in _groups(shown, places or (0,))]
    rows = [tuple(group[start : start + _ROW]) for group in groups for start in range(0, len(group), _ROW)]
    if not any(np.any(one.size > 0.0) for row in rows for one in row):
        raise InputError([Problem("masses", None, _("give no loads of crank pins, so there is no sheet of wear"))])
    circles = WearCircles(
        tuple(rows),
        _("{force} {unit}, mean over the cycle, inward from the circle"),
        _("{n} more diagrams are in the result."),
    )
    return sheet_of(
        result,
        design,
        _("Wear, and places for oil holes"),
        SheetColumn(1.0, (circles, Notes(tuple(_notes(shown, places or (0,)))))),
    )


def _groups(shown: OneDesign, places: Sequence[int]) -> Iterator[Sequence[Rays]]:
    """All that wears: pins with their rods, journals, bearings; by several methods journals and bearings of each."""
    if len(places) == 1:
        yield list(pin_wear(shown))
    if shown.has("journal_wear"):
        names = [title_of(shown.result.labels["bearing_method"][place]) if len(places) > 1 else "" for place in places]
        each = [tuple(zip(*journal_wear(shown, *one), strict=True)) for one in zip(places, names, strict=True)]
        for part in zip(*each, strict=True):
            yield from part


def _notes(shown: OneDesign, places: Sequence[int]) -> Iterator[Message]:
    """Say what counts from where, and by which methods."""
    yield _("Each load counts with its full size on all rays within 60° of its line; the hole goes where least acts.")
    yield _("Up is away from the shaft on a pin, along the rod on its bearing, and rotation is to the right.")
    if shown.has("journal_wear"):
        yield _(
            "Journals likewise, up is toward throw 1; main bearings as seen from the free end, by: {method}.",
            method=Listed([title_of(shown.result.labels["bearing_method"][place]) for place in places], "; "),
        )
    yield _("Degrees count from up in the sense of rotation.")
