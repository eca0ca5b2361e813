"""Heads of a load's file: which columns count, what stands in them over what, and in which units."""

import re
from collections.abc import Iterator, Sequence
from typing import Literal, NamedTuple, TypeAlias

from cranktrain.errors import InputError, Position, Problem, refuse
from cranktrain.language import Words, _
from cranktrain.number_table import NumberTable
from cranktrain.one_line import short
from cranktrain.quantities import Dimension
from cranktrain.quantities.heads import axis_of, in_head, is_time, time_advice, unit_in

Over: TypeAlias = Literal["crank_angles", "travel", "swing"]
Sort: TypeAlias = Literal["force", "torque"]

SORTS: dict[Sort, Dimension] = {"torque": Dimension.TORQUE, "force": Dimension.FORCE}
"""In the order in which heads are asked: N m has a newton in it."""
_SWING = re.compile(r"swing|ausschlag|schwing|размах|качани", re.IGNORECASE)
"""What tells the turn of a link from the crank angle in a column's head."""
_ONE_WAY, _BOTH_WAYS = 2, 3


class LoadHeads(NamedTuple):
    """Which columns count, from 0, and what their heads say: what over what, and in which units."""

    where: int
    levels: tuple[int, ...]
    over: Over
    sort: Sort
    place_unit: str
    units: tuple[str, ...]


def load_heads(table: NumberTable, columns: Sequence[int] | None) -> LoadHeads:
    """Tell which columns count and what they are.

    Parameters
    ----------
    table : NumberTable
    columns : sequence of int or None
        Of place and size, or of place, size on the way out and on the way back, from 1.

    Returns
    -------
    LoadHeads

    Raises
    ------
    InputError
        With what no head says, and what goes together in no load.
    """
    where, *levels = _columns(table, columns)
    labels = table.labels or ("",) * table.rows.shape[1]
    if is_time(labels[where]):
        allowed = _("has a time in column {column}, “{head}”, and a load is over crank angle, travel or swing")
        said = allowed.format(column=where + 1, head=short(labels[where]))
        raise InputError([Problem("file", table.name, said, time_advice())])
    over, place_unit = _axis(labels[where])
    found = [_size(labels[level]) for level in levels]
    problems = (
        [_without_unit(table, _("travel or angle"), labels[where], "travel [mm], crank angle [deg]")]
        if place_unit is None
        else []
    )
    problems += [
        _without_unit(table, _("force or torque"), labels[level], "force [kN], torque [N·m]")
        for level, one in zip(levels, found, strict=True)
        if one is None
    ]
    refuse(problems)
    known = [one for one in found if one is not None]
    refuse(_unfit(table, over, [sort for sort, _unit in known]))
    return LoadHeads(where, tuple(levels), over, known[0][0], place_unit or "", tuple(unit for _sort, unit in known))


def _columns(table: NumberTable, columns: Sequence[int] | None) -> Sequence[int]:
    """Places in a row, from 0, of where, of the size, and of the size on the way back if it has its own."""
    n_columns = table.rows.shape[1]
    if n_columns < _ONE_WAY:
        allowed = _("has one column; a load needs two, its size after crank angle, travel or swing")
        raise InputError([Problem("", None, allowed, None, Position(table.name, int(table.lines[0])))])
    if columns is None:
        if n_columns > _BOTH_WAYS:
            allowed = _("must say which of the {n} columns are place and size", n=n_columns)
            repair = _("write columns = [1, 2], or [1, 2, 3] with the size on the way back")
            raise InputError([Problem("columns", None, allowed, repair)])
        return range(n_columns)
    if max(columns) > n_columns or len(set(columns)) < len(columns):
        allowed = _("must be columns of the file, 1 to {n}, each once", n=n_columns)
        raise InputError([Problem("columns", None, allowed)])
    return [column - 1 for column in columns]


def _axis(head: str) -> tuple[Over, str | None]:
    """Tell over what a column's head says that sizes are, and in which unit."""
    unit = unit_in(head, Dimension.ANGLE)
    if _SWING.search(head) is not None:
        return "swing", unit
    if unit is not None or axis_of(head) == "angle":
        return "crank_angles", unit or "deg"
    return "travel", unit_in(head, Dimension.LENGTH)


def _size(head: str) -> tuple[Sort, str] | None:
    """Tell from its unit what a column's head says that sizes are; None where it names none."""
    for sort, dimension in SORTS.items():
        if unit := unit_in(head, dimension):
            return sort, unit
    return None


def _without_unit(table: NumberTable, noun: Words, head: str, example: str) -> Problem:
    """Say that a head names no unit of what is meant."""
    said = in_head(_("names no unit of {noun}", noun=noun), head)
    return Problem("file", table.name, said, _("write it in the head: {example}", example=example))


def _unfit(table: NumberTable, over: Over, sorts: Sequence[Sort]) -> Iterator[Problem]:
    """Find sizes that do not go together, or not with that over which they are."""
    if len(set(sorts)) > 1:
        yield Problem("file", table.name, _("must have forces on both ways, or torques on both"))
    elif over == "crank_angles" and len(sorts) > 1:
        allowed = _("has two sizes for a crank angle; two are for a travel or a swing, there and back")
        yield Problem("file", table.name, allowed, _("write swing in the head of the turn of a link"))
    elif (over, sorts[0]) in (("travel", "torque"), ("swing", "force")):
        allowed = _("must have forces over the travel of a point, torques over the swing of a link")
        yield Problem("file", table.name, allowed)
