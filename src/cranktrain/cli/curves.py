"""`run --at` and `run --table`: curves at some crank angles as numbers, on the screen or in a file."""

import itertools
import math
from collections.abc import Sequence
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from cranktrain.analysis import Result
from cranktrain.analysis.curve_columns import (
    CurveColumn,
    CurvesAtAngle,
    at_angles,
    by_default,
    curve_columns,
    of_member,
)
from cranktrain.cli.asked import CurvesAsked
from cranktrain.cli.number_lists import exact, numbers_listed
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.grouping import grouped
from cranktrain.io.title import title
from cranktrain.language import said as _
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.quantities import unlisted
from cranktrain.record import record
from cranktrain.saying.sections import Column, FactTables, Grid, ShownSection

_HUNDREDTHS = 100
"""Parts of a degree of which angles that can be asked for are whole numbers."""
_NAMED = 5
"""Members that a heading names."""
_LINES = 24
"""Of a table for which nobody says how far apart its lines are."""


def angles_asked(asked: CurvesAsked, cycle: int) -> list[Fraction]:
    """Crank angles that are asked for, within a cycle of so many degrees; refuse what is none. [deg]"""
    if asked.at is not None:
        example = f"0,30..{cycle}"
        allowed = _(
            "must be crank angles from 0 to {cycle} deg, such as 140 or {example}", cycle=cycle, example=example
        )
        angles = numbers_listed("--at", asked.at, allowed, example, lambda word: _in_hundredths("--at", word))
        refuse([] if all(0 <= angle <= cycle for angle in angles) else [Problem("--at", asked.at, allowed)])
        return angles
    every = Fraction(cycle, _LINES)
    if asked.every is not None:
        allowed = _("must be a number of degrees from 0.01 to {cycle}, such as 30", cycle=cycle)
        every, *more = numbers_listed(
            "--every", asked.every, allowed, "30", lambda word: _in_hundredths("--every", word)
        )
        refuse([] if 0 < every <= cycle and not more else [Problem("--every", asked.every, allowed)])
    return [every * line for line in range(math.floor(cycle / every) + 1)]


def _in_hundredths(option: str, word: str) -> Fraction:
    """Read a number that is a whole number of hundredths."""
    number = exact(word)
    if (number * _HUNDREDTHS).denominator != 1:
        raise InputError([Problem(option, word, _("must be a whole number of hundredths of a degree"))])
    return number


def step_for(angles: Sequence[Fraction]) -> float:
    """Widest step, of at most a degree, on which all of some angles stand. [deg]"""
    return math.gcd(_HUNDREDTHS, *(int(angle * _HUNDREDTHS) for angle in angles)) / _HUNDREDTHS


def names_asked(machine: Machine, asked: CurvesAsked, quantities: tuple[str, ...] | None) -> tuple[str, ...] | None:
    """Names of the curves of a table, or those that were asked for; None for all."""
    if asked.table is None:
        return quantities
    tables = [question.curve_tables for question in machine.questions]
    known = tuple(dict.fromkeys(itertools.chain(*tables)))
    refuse([unlisted("--table", asked.table, known)] if asked.table not in known else ())
    return tuple(itertools.chain(*(own.get(asked.table, ()) for own in tables)))


@record
class ChosenCurves:
    """Curves at some crank angles.

    Attributes
    ----------
    columns : tuple of CurveColumn
        With values at these angles alone.
    angles : Array, shape (n,)
        [deg]
    places : array of int, shape (n,)
        Of these angles on the result's grid.
    member : str
        Of whom a table is; empty where it is no table, or of the machine.
    others : tuple of str
        Of whom it could be, too.
    """

    columns: tuple[CurveColumn, ...]
    angles: Array
    places: NDArray[np.intp]
    member: str = ""
    others: tuple[str, ...] = ()


def chosen_curves(
    result: Result, asked: CurvesAsked, names: tuple[str, ...] | None, angles: Sequence[Fraction]
) -> ChosenCurves:
    """Pick what is asked for from a result on whose grid the angles stand."""
    degrees = np.array([float(angle) for angle in angles])
    places = np.rint(degrees / result.crank_angle[1]).astype(np.intp) % result.crank_angle.size
    wanted = by_default(result) if names is None else names
    columns = at_angles(curve_columns(result, wanted, of_each_method=False), places)
    if not columns:
        raise InputError([_absence(result, asked, wanted)])
    if asked.table is None:
        return ChosenCurves(tuple(columns), degrees, places)
    order = {name: i for i, name in enumerate(wanted)}
    columns = sorted(columns, key=lambda column: order[column.entry.name])
    members = tuple(dict.fromkeys(column.member for column in columns if column.member))
    whole = tuple(name for name in members if not any(name.startswith(f"{other}.") for other in members))
    if asked.of is not None and asked.of not in members:
        raise InputError([unlisted("--of", asked.of, whole)])
    member = asked.of if asked.of is not None else next(iter(whole), "")
    own = [column for column in of_member(columns, member) if not np.all(np.isnan(column.values))]
    return ChosenCurves(tuple(own), degrees, places, member, tuple(name for name in whole if name != member))


def _absence(result: Result, asked: CurvesAsked, names: Sequence[str]) -> Problem:
    """Say why there are no curves."""
    needs = [need for missing in result.missing if not set(names).isdisjoint(missing.results) for need in missing.needs]
    said = _("needs {needs} in the file", needs=", ".join(dict.fromkeys(map(str, needs))))
    option, given = ("--at", asked.at) if asked.table is None else ("--table", asked.table)
    return Problem(option, given, said if needs else _("has no curve that this machine has"))


def show_curves(result: Result, asked: CurvesAsked, names: tuple[str, ...] | None, chosen: ChosenCurves) -> None:
    """Show curves at some crank angles."""
    from cranktrain.cli.screen.sections import show_page  # an answer needs none

    if asked.table is None and chosen.angles.size == 1:
        heading = _("At {angle}", angle=f"{chosen.angles[0]:g}°")
        facts = CurvesAtAngle(result, int(chosen.places[0]), by_default(result) if names is None else names)
        show_page(title(result.machines[0]), [ShownSection(heading, (FactTables(facts, tuple(facts.catalogue)),))])
        return
    tables = {chosen.member: chosen.columns} if asked.table is not None else _by_member(chosen.columns)
    show_page(
        title(result.machines[0]),
        (
            ShownSection(_heading(asked, chosen, member), (_grid(columns, chosen.angles),))
            for member, columns in tables.items()
        ),
    )


def _by_member(columns: Sequence[CurveColumn]) -> dict[str, list[CurveColumn]]:
    """Columns by whose they are."""
    return grouped((column.member, column) for column in columns)


def _heading(asked: CurvesAsked, chosen: ChosenCurves, member: str) -> str:
    """Say what a table is of."""
    if asked.table is None:
        return member or _("Machine")
    if not chosen.others:
        return table_title(asked, chosen)
    named = ", ".join((*chosen.others[:_NAMED], *(["…"] if len(chosen.others) > _NAMED else [])))
    return _("Table {table} of {member} (others by --of: {others})", table=asked.table, member=member, others=named)


def table_title(asked: CurvesAsked, chosen: ChosenCurves) -> str:
    """Say what a table is of, alone."""
    if not chosen.member:
        return _("Table {table}", table=asked.table)
    return _("Table {table} of {member}", table=asked.table, member=chosen.member)


def _grid(columns: Sequence[CurveColumn], angles: Array) -> Grid:
    """Columns at some angles, and what they are below."""
    return Grid(
        [
            Column(one.entry.symbol or one.entry.name, one.values.tolist(), one.entry.shown, "amounts", one.entry.name)
            for one in columns
        ],
        [f"{angle:g}" for angle in angles.tolist()],
        "φ °",
        names_quantities=True,
    )
