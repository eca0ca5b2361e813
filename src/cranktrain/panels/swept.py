"""Facts of a sweep as panels: curves over one number, families, maps over two, clouds of listed designs."""

import itertools
from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from cranktrain.errors import InputError, Problem
from cranktrain.language import Listed, Words, _
from cranktrain.motion import Array
from cranktrain.one_line import short
from cranktrain.panels.plotted import Plot, letter_of, role_at, unknown
from cranktrain.panels.shapes import Curve, Map, Panel, is_level
from cranktrain.saying.catalogue import Entry
from cranktrain.saying.names import spelled
from cranktrain.study.sweep import Sweep
from cranktrain.study.sweep.varied import Varied

_MOST_CURVES = 6
"""Of a family: with more values of a second number there is a map."""
_MOST_DRAWN, _MOST_PANELS = 12, 6
"""Curves of one fact; facts that are drawn unless they are named."""
_ROOM = 0.04
"""Beside the points of a cloud, in parts of its width."""


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
    if sweep.designs.is_listed:
        return _cloud(sweep, names)
    if sweep.axis is None:
        allowed = _("needs a number that is varied, for the axis; words alone give a table")
        raise InputError([Problem("plot", None, allowed, _("write a .csv or .xlsx"))])
    numbers = [place for place, one in enumerate(sweep.along) if one.numbers is not None]
    is_map = len(sweep.along) == len(numbers) == 2 and min(sweep.shape) > _MOST_CURVES
    panels = [one for name in names for one in (_maps if is_map else _curves)(sweep, name)]
    over = next(_labelled(one) for one in sweep.along if one.numbers is not None)
    is_hatched = any(_is_hatched(panel) for panel in panels)
    note = _("hatched: designs that cannot be") if is_hatched and sweep.refused else ""
    return Plot(tuple(panels), sweep.subject, over=over, note=note)


def _is_hatched(panel: Panel | Map) -> bool:
    return bool(np.isnan(panel.values).any()) if isinstance(panel, Map) else bool(panel.hatched)


def _labelled(one: Varied) -> Words:
    """What is written along an axis."""
    return Listed(tuple(filter(None, (_(spelled(one.spoken).capitalize()), one.unit))), ", ")


def _cloud(sweep: Sweep, names: Sequence[str]) -> Plot:
    """Designs of a list as points: over the one number that differs, else over the first of several facts."""
    numbers = [one for one in sweep.designs.varied if one.numbers is not None]
    largest = {name: sweep.worst_of(name, is_least_wanted=True) for name in names}
    different = [name for name in names if not is_level(largest[name])]
    if numbers and (len(numbers) == 1 or len(different) < 2):
        first, own = numbers[0], list(names)
        across, unit, over = _numbers(first.numbers), "", _labelled(first)
    elif len(different) > 1:
        over_name, *own = different
        entry = sweep.found.entries[over_name]
        across, unit, over = largest[over_name], entry.shown, _title(entry)
    else:
        allowed = _("needs a number that differs among the designs, or two facts that do")
        raise InputError([Problem("plot", None, allowed, _("write a .csv or .xlsx"))])
    known = across[np.isfinite(across)]
    least, most = float(np.min(known)), float(np.max(known))
    room = _ROOM * (most - least) or 1.0
    panels: list[Panel] = []
    for name in own:
        entry = sweep.found.entries[name]
        title = _title(entry)
        if len(sweep.apart(name)) > 1:
            title = _("{fact}, the largest of its members", fact=title)
        points = Curve(largest[name], "main", letter_of(entry), is_cloud=True)
        panels.append(Panel(title, entry.shown, across, (points,), across_unit=unit, reach=(least - room, most + room)))
    n_refused, n_designs = len(sweep.refused), len(sweep.designs)
    note = _("{n} of {all} designs cannot be", n=n_refused, all=n_designs) if n_refused else ""
    name = short(sweep.machine.name) or _("Machine without a name")
    return Plot(tuple(panels), _("{name}: {n} designs", name=name, n=n_designs), over=over, note=note)


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
    drawn = tuple(curves[:_MOST_DRAWN])
    hatched = tuple(_hatched(axis.values, np.all([np.isnan(curve.values) for curve in drawn], axis=0)))
    # What it is over stands below in the unit that was typed.
    return [Panel(title, entry.shown, axis.values, drawn, across_unit="", hatched=hatched)]


def _hatched(across: Array, is_missing: NDArray[np.bool_]) -> Iterator[tuple[float, float]]:
    """From where to where an end has no value."""
    for place in np.flatnonzero(is_missing[1:] | is_missing[:-1]).tolist():
        yield float(across[place]), float(across[place + 1])


def _called(one: Varied) -> tuple[str, ...]:
    """What values are called in a key: plain numbers by what they are, too."""
    if one.unit or one.numbers is None:
        return one.texts
    return tuple(f"{spelled(one.spoken)} {text}" for text in one.texts)


def _maps(sweep: Sweep, name: str) -> list[Map]:
    """A fact over two numbers: a map for each member."""
    entry, (first, second) = sweep.found.entries[name], sweep.along
    maps: list[Map] = []
    for whose, values in sweep.apart(name):
        title: Words = _("{fact} ({of})", fact=_title(entry), of=whose) if whose else _title(entry)
        across, up = _numbers(first.numbers), _numbers(second.numbers)
        upward = _(spelled(second.spoken).capitalize())
        maps.append(Map(title, entry.shown, across, up, values.T, second.unit, upward))
    return maps


def _numbers(numbers: Array | None) -> Array:
    assert numbers is not None  # of a map
    return numbers


def _title(entry: Entry) -> Words:
    return _(entry.message)
