"""Facts of a sweep as panels: curves over one number, families over words or few numbers, maps over two."""

import itertools

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.language import Listed, Words, _
from cranktrain.motion import Array
from cranktrain.panels.plotted import Plot, letter_of, role_at, unknown
from cranktrain.panels.shapes import Curve, Map, Panel
from cranktrain.saying.catalogue import Entry
from cranktrain.saying.names import spelled
from cranktrain.study.sweep import Sweep
from cranktrain.study.sweep.varied import Varied

_MOST_CURVES = 6
"""Of a family: with more values of a second number there is a map."""
_MOST_DRAWN, _MOST_PANELS = 12, 6
"""Curves of one fact; facts that are drawn unless they are named."""


def plot_of_sweep(sweep: Sweep, *quantities: str) -> Plot:
    """Collect what is drawn of a sweep.

    Parameters
    ----------
    sweep : Sweep
    *quantities : str
        Names of facts; all unless given.

    Returns
    -------
    Plot

    Raises
    ------
    InputError
        Where there is no such fact, or nothing that is a number is varied.
    """
    names = quantities or tuple(sweep.catalogue)[:_MOST_PANELS]
    wrong = [name for name in names if name not in sweep.catalogue]
    if wrong:
        raise InputError(unknown("plot", name, list(sweep.catalogue)) for name in wrong)
    if sweep.axis is None:
        allowed = _("needs a number that is varied, for the axis; words alone give a table")
        raise InputError([Problem("plot", None, allowed, _("write a .csv or .xlsx"))])
    numbers = [place for place, one in enumerate(sweep.along) if one.numbers is not None]
    is_map = len(sweep.along) == len(numbers) == 2 and min(sweep.shape) > _MOST_CURVES
    panels = [one for name in names for one in (_maps if is_map else _curves)(sweep, name)]
    over = Listed(tuple(filter(None, (_(spelled(sweep.axis.name).capitalize()), sweep.axis.unit))), ", ")
    return Plot(tuple(panels), sweep.subject, over=over)


def _curves(sweep: Sweep, name: str) -> list[Panel]:
    """A fact over the axis: a curve for each member, and for each combination of whatever else is varied."""
    entry, axis = sweep.found.entries[name], sweep.axis
    assert axis is not None  # of curves
    over = next(place for place, one in enumerate(sweep.along) if one.name == axis.name)
    beside = [one for place, one in enumerate(sweep.along) if place != over]
    curves: list[Curve] = []
    for whose, values in sweep.apart(name):
        own = np.moveaxis(values, over, -1)
        others = itertools.product(*map(_called, beside))
        for said, curve in zip(others, own.reshape(-1, own.shape[-1]), strict=True):
            words = ", ".join(filter(None, (whose, *said)))
            curves.append(Curve(curve, role_at(len(curves)), letter_of(entry), name=words))
    title = _title(entry)
    if len(curves) > _MOST_DRAWN:
        title = _("{fact}: {most} curves of {n}", fact=title, most=_MOST_DRAWN, n=len(curves))
    # What it is over stands below in the unit that was typed.
    return [Panel(title, entry.shown, axis.values, tuple(curves[:_MOST_DRAWN]), across_unit="")]


def _called(one: Varied) -> tuple[str, ...]:
    """What values are called in a key: plain numbers by what they are, too."""
    return one.texts if one.unit or one.numbers is None else tuple(f"{spelled(one.name)} {text}" for text in one.texts)


def _maps(sweep: Sweep, name: str) -> list[Map]:
    """A fact over two numbers: a map for each member."""
    entry, (first, second) = sweep.found.entries[name], sweep.along
    maps: list[Map] = []
    for whose, values in sweep.apart(name):
        title: Words = _("{fact} ({of})", fact=_title(entry), of=whose) if whose else _title(entry)
        across, up = _numbers(first.numbers), _numbers(second.numbers)
        upward = _(spelled(second.name).capitalize())
        maps.append(Map(title, entry.shown, across, up, values.T, second.unit, upward))
    return maps


def _numbers(numbers: Array | None) -> Array:
    assert numbers is not None  # of a map
    return numbers


def _title(entry: Entry) -> Words:
    return _(entry.message)
