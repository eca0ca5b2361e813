"""Curves of results by name over the crank angle, of one machine or of two."""

from collections.abc import Collection, Iterable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from cranktrain.analysis import Result
from cranktrain.analysis.comparison import Comparison
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.language import Listed, Words, _
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.one_line import short
from cranktrain.panels.design import OneDesign, closed
from cranktrain.panels.shapes import Curve, Map, Panel, Role
from cranktrain.plans.placement import first_throw
from cranktrain.quantities import nearest
from cranktrain.record import record
from cranktrain.saying.catalogue import Entry
from cranktrain.saying.names import spelled
from cranktrain.saying.run import Axis, Run

_MAIN = (
    ("piston_displacement", "rocker_angle"),
    ("piston_velocity", "piston_velocity_coefficient", "rocker_angular_velocity", "rocker_velocity_coefficient"),
    (
        *("piston_acceleration", "piston_acceleration_coefficient"),
        *("rocker_angular_acceleration", "rocker_acceleration_coefficient"),
    ),
    ("gas_pressure",),
    ("machine_torque",),
)
"""Curves that say most: of each line the first that there is."""

_LETTERS = {"m": "s", "m/s": "v", "m/s^2": "j", "Pa": "p", "N*m": "T", "N": "F"}
"""By whose letter a curve's colour is chosen, from the unit of its quantity."""

_MOST_CURVES = 4
"""Of one quantity, unless members are named."""

_LONGEST_KEY = 60
"""Characters of a machine's name in the key."""

ROLES: tuple[Role, ...] = ("main", "side", "radial", "resultant", "formula")
"""Of the curves of one panel that are alike; further ones are thin."""

_OF_BOTH: tuple[Role, Role] = ("whole", "side")
"""Of the first and the second machine's curves: told apart in grey."""

_EXACT = "exact"


@record
class Plot:
    """Panels of curves one above the other, each over the whole axis, and what heads them.

    Attributes
    ----------
    panels : tuple of Panel, or of Map
    title : Words
    keys : tuple of Curve
        Explained above all panels, by their names; each panel has its own names unless there are such.
    over : Words, optional
        What they are over, without its unit, if that is not the crank angle.
    note : Words
        What stands below all.
    """

    panels: tuple[Panel | Map, ...]
    title: Words = ""
    keys: tuple[Curve, ...] = ()
    over: Words | None = None
    note: Words = ""


def plot_of(run: Run, *quantities: str, design: int = 0, **members: "str | Sequence[str]") -> Plot:
    """Collect curves of a run.

    Parameters
    ----------
    run : Run
    *quantities : str
        Names of curves; the main ones unless given.
    design : int
    **members : str or sequence of str
        Whose, by dimension; the first few unless given.

    Returns
    -------
    Plot

    Raises
    ------
    InputError
        Where there is no such curve, or member.
    """
    names = quantities or _main_names([run])
    entries = [_curve_called(name, [run]) for name in names]
    _refuse_members(members, [dimension for entry in entries for dimension in run.labels_of(entry)])
    panels = tuple(_panel_of(run, entry, design, members) for entry in entries)
    heading = run.machines[design].name if isinstance(run, Result) else str(run.subject)
    title: Words = short(heading, 100) or _("Machine without a name")
    if run.n_designs is not None:
        title = _("{name}, design {design}", name=title, design=design + 1)
    return Plot(panels, title, over=_over(run.axis))


def plot_of_both(comparison: Comparison, *quantities: str) -> Plot:
    """Collect curves of two machines over each other: the first thick, the second thin, dashed and black.

    Parameters
    ----------
    comparison : Comparison
    *quantities : str
        Names of curves; those that were asked for, or the main ones, unless given.

    Returns
    -------
    Plot

    Raises
    ------
    InputError
        Where neither machine has such a curve.
    """
    results = comparison.results
    asked = [
        name
        for name in comparison.asked or ()
        if any(name in one.catalogue and one.is_curve(one.catalogue[name]) for one in results)
    ]
    if not quantities and not asked:
        _refuse_facts(comparison.asked or ())
    names = quantities or asked or _main_names(results)
    keys = tuple(
        Curve(np.zeros(1), role, letter, name=short(name, _LONGEST_KEY))
        for name, role, letter in zip(comparison.names, _OF_BOTH, ("", "F"), strict=True)
    )
    return Plot(tuple(_panel_of_both(comparison, _curve_called(name, results)) for name in names), keys=keys)


def _refuse_facts(asked: Iterable[str]) -> None:
    """Refuse to draw what was asked for, if none of it is a curve."""
    refuse(Problem("quantities", name, _("has one value for the whole cycle, and no curve")) for name in asked)


def _over(axis: Axis | None) -> Words | None:
    """What is written along an axis that is not the crank angle."""
    if axis is None or axis.name == "crank_angle":
        return None
    name = _(spelled(axis.name).capitalize())
    return Listed((name, axis.symbol), " ") if axis.symbol else name


def _main_names(results: Sequence[Run]) -> tuple[str, ...]:
    """Curves that say most and that one of the runs has."""
    asked = [(one, name) for one in results for name in getattr(one, "asked", None) or ()]
    found = [name for one, name in asked if one.is_curve(one.catalogue[name])]
    if found:
        return tuple(dict.fromkeys(found))
    _refuse_facts(dict.fromkeys(name for _one, name in asked))
    for alternatives in _MAIN:
        for result in results:
            first = next((name for name in alternatives if name in result.catalogue), None)
            if first is not None and first not in found:
                found.append(first)
    if not found:
        found += [name for name, entry in results[0].catalogue.items() if results[0].is_curve(entry)][:_MOST_CURVES]
    if not found:
        raise InputError([Problem("plot", None, _("needs a result with curves; this one has only facts"))])
    return tuple(found)


def _curve_called(name: str, results: Sequence[Run]) -> Entry:
    """Find a curve; say of a fact that it is none, of what is missing what it needs."""
    found = next((one for one in results if name in one.catalogue), None)
    if found is None:
        needs = next((needs for one in results if (needs := one.needs_of(name))), ())
        if needs:
            raise InputError([Problem("plot", name, _("needs {needs}", needs=Listed(needs)))])
        curves = [curve for one in results for curve, held in one.catalogue.items() if one.is_curve(held)]
        raise InputError([unknown("plot", name, curves)])
    entry = found.catalogue[name]
    if not found.is_curve(entry):
        raise InputError([Problem("plot", name, _("has one value for the whole cycle, and no curve"))])
    return entry


def unknown(path: str, name: str, known: "Sequence[str] | Mapping[str, object]") -> Problem:
    """Refuse a name that is not among those that are known, with what was meant."""
    allowed = _("must be one of: {names}", names=", ".join(known))
    if len(known) > 16:
        allowed = _("is no curve of this result")
    meant = nearest(name, known)
    return Problem(path, name, allowed, _("did you mean {name}?", name=meant) if meant else None)


def _refuse_members(members: Mapping[str, object], dimensions: Sequence[str]) -> None:
    """Refuse members of a dimension that none of the curves has."""
    there = list(dict.fromkeys(dimensions))
    wrong = [name for name in members if name not in there]
    if wrong:
        raise InputError(unknown("plot", name, there) for name in wrong)


def _panel_of(run: Run, entry: Entry, design: int, members: Mapping[str, "str | Sequence[str]"]) -> Panel:
    """Curves of some members of one machine."""
    curves = tuple(
        Curve(closed(values) if isinstance(run, Result) else values, role_at(place), letter_of(entry), name=name)
        for place, (name, values) in enumerate(_curves(run, entry, design, members))
    )
    across, unit = _along(run)
    return Panel(_(entry.message), entry.shown, across, curves, across_unit=unit)


def role_at(place: int) -> Role:
    """Role of the curve at a place among several alike."""
    return ROLES[place] if place < len(ROLES) else "each"


def _panel_of_both(comparison: Comparison, entry: Entry) -> Panel:
    """The first member's curve of both machines, the shorter cycle repeated."""
    found = [
        (_curves(result, entry, 0, {})[0] if entry.name in result.catalogue else None) for result in comparison.results
    ]
    ends = [float(_cycle(result)[-1]) for result in comparison.results]
    curves: list[Curve] = []
    looks = zip(_OF_BOTH, (letter_of(entry), "F"), strict=True)
    for result, own, one, (role, letter) in zip(comparison.results, ends, found, looks, strict=True):
        if one is not None:
            times = round(max(ends) / own)
            angle = np.concatenate([result.crank_angle + k * own for k in range(times)])
            curves.append(Curve(closed(np.tile(one[1], times)), role, letter, across=np.append(angle, max(ends))))
    of = " / ".join(one[0] for one in found if one is not None and one[0])
    title = Listed((_(entry.message), f"({of})"), " ") if of else _(entry.message)
    return Panel(title, entry.shown, np.array([0.0, max(ends)]), tuple(curves))


def letter_of(entry: Entry) -> str:
    """By whose letter its colour is chosen."""
    return _LETTERS.get(entry.unit, "F")


def _curves(
    run: Run, entry: Entry, design: int, members: Mapping[str, "str | Sequence[str]"]
) -> list[tuple[str, Array]]:
    """Names and values of the curves of some members; of methods the exact one, of many the first few."""
    assert run.axis is not None  # of a curve
    values: Array = np.asarray(getattr(run, entry.name))
    values = np.moveaxis(
        values[design] if run.n_designs is not None else values, entry.dimensions.index(run.axis.name), -1
    )
    labels, titles = run.labels_of(entry), run.titles_of(entry)
    usual = _usual(run.machines[design]) if isinstance(run, Result) else set[str]()
    chosen = [_chosen(dimension, names, members.get(dimension), usual) for dimension, names in labels.items()]
    found = values[np.ix_(*chosen)] if chosen else values[np.newaxis]
    words: list[str] = [""]
    for (dimension, names), places in zip(titles.items(), chosen, strict=True):
        is_said = len(names) > 1 and (dimension in members or names[0] != _EXACT)
        each = [names[int(place)] if is_said else "" for place in places]
        words = [", ".join(filter(None, (before, word))) for before in words for word in each]
    curves = list(zip(words, found.reshape(-1, values.shape[-1]), strict=True))
    return curves if members else curves[:_MOST_CURVES]


def _usual(machine: Machine) -> set[str]:
    """Names of the first throw's mechanisms and cylinders, of which curves are unless others are wanted."""
    return {name for place in first_throw(machine) for name in (place.name, place.cylinder)}


def _chosen(
    dimension: str, names: Sequence[str], wanted: "str | Sequence[str] | None", usual: Collection[str]
) -> NDArray[np.intp]:
    """Places of the members that are wanted."""
    if wanted is None:
        first = [place for place, name in enumerate(names) if name.partition(".")[0] in usual or name in usual]
        return np.array(first[:_MOST_CURVES] or range(1 if names[0] == _EXACT else len(names)), dtype=np.intp)
    each = [wanted] if isinstance(wanted, str) else [str(one) for one in np.atleast_1d(np.array(wanted))]
    wrong = [name for name in each if name not in names]
    if wrong:
        raise InputError(unknown(dimension, name, names) for name in wrong)
    return np.array([list(names).index(name) for name in each], dtype=np.intp)


def _along(run: Run) -> tuple[Array, str]:
    """Where the points of curves stand, and in what; of a cycle its end, too."""
    if isinstance(run, Result):
        return _cycle(run), "deg"
    assert run.axis is not None  # of a curve
    return run.axis.values, run.axis.unit


def _cycle(result: Result) -> Array:
    """Crank angles of the cycle, its end included. [deg]"""
    return OneDesign(result, 0).cycle
