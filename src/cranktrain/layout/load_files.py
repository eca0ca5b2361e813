"""A load from a file: its sizes over the crank angle, or over a travel or swing there and back, as a card has them."""

import re
from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import islice
from typing import ClassVar, Literal, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from cranktrain.errors import InputError, Position, Problem, refuse
from cranktrain.fluids.indicator.heads import axis_of, unit_in
from cranktrain.fluids.indicator.table import NumberTable, held_text, read_table
from cranktrain.language import N_, _
from cranktrain.layout.cycle_table import CycleFileSpec, Words, given_curve
from cranktrain.motion import Array
from cranktrain.one_line import short
from cranktrain.quantities import Dimension, Given, read

Over: TypeAlias = Literal["crank_angles", "travel", "swing"]
Sort: TypeAlias = Literal["force", "torque"]

_SWING = re.compile(r"swing|ausschlag|schwing|размах|качани", re.IGNORECASE)
"""What tells the turn of a link from the crank angle in a column's head."""
_SORTS: dict[Sort, Dimension] = {"torque": Dimension.TORQUE, "force": Dimension.FORCE}
"""In the order in which heads are asked: N m has a newton in it."""
_ONE_WAY, _BOTH_WAYS = 2, 3
_MOST_PROBLEMS = 10


class LoadCard(NamedTuple):
    """What a file says of a load.

    Attributes
    ----------
    sort : "force" or "torque"
    over : "crank_angles", "travel" or "swing"
    places : tuple of Given
        Rising.
    out : tuple of Given
        Sizes there, of a travel on the way out.
    back : tuple of Given, or None
        Sizes on the way back; None over the crank angle.
    first, last : Position
        Where the file has the least place and the greatest.
    negative : tuple of (str, Position)
        Sizes of less than 0, as the file has them.
    """

    sort: Sort
    over: Over
    places: tuple[Given, ...]
    out: tuple[Given, ...]
    back: tuple[Given, ...] | None
    first: Position
    last: Position
    negative: tuple[tuple[str, Position], ...]


class _Heads(NamedTuple):
    """Which columns count, from 0, and what their heads say: what over what, and in which units."""

    where: int
    levels: tuple[int, ...]
    over: Over
    sort: Sort
    place_unit: str
    units: tuple[str, ...]


class _ForceCurve(CycleFileSpec, frozen=True):
    """Forces over the crank angle, whose unit stands in the head."""

    words: ClassVar[Words] = Words(N_("a load"), N_("force"), Dimension.FORCE, "file", ("", ""))

    @property
    def unit(self) -> str | None:
        """None: the table of the load names none."""
        return None


class _TorqueCurve(_ForceCurve, frozen=True):
    """Torques over the crank angle, whose unit stands in the head."""

    words: ClassVar[Words] = Words(N_("a load"), N_("torque"), Dimension.TORQUE, "file", ("", ""))


@lru_cache(maxsize=16)
def load_card(file: str, text: str | None, columns: tuple[int, ...] | None) -> LoadCard:
    r"""Read the file of a load.

    Parameters
    ----------
    file : str
        Its name, for messages.
    text : str or None
        What it holds.
    columns : tuple of int or None
        Of place and size, or of place, size on the way out and on the way back, from 1; as the file has them if None.

    Returns
    -------
    LoadCard

    Raises
    ------
    InputError
        With all that is wrong in it, at line and column where it has one; or if nobody has read it.

    Notes
    -----
    Over a travel either the size on the way back has a column of its own, or the rows go there and back: a closed loop,
    which may begin anywhere. Over the crank angle it is a curve as `given_curve` reads it.

    Examples
    --------
    >>> card = load_card("card.csv", "travel [mm];force [N]\n0;10\n80;30\n80;5\n0;5\n0;10", None)
    >>> [size.text for size in card.out], [size.text for size in card.back]
    (['10 N', '30 N'], ['5 N', '5 N'])
    """
    table = read_table(held_text(file, text), file)
    heads = _heads(table, columns)
    if heads.over == "crank_angles":
        return _over_angle(table, heads, text)
    rows = _branches(table, heads) if len(heads.levels) == 1 else _side_by_side(table, heads)
    travel = table.rows[:, heads.where]
    places = np.union1d(*(travel[branch] for branch in rows))
    levels = (heads.levels[0], heads.levels[-1])
    out, back = (
        np.interp(places, travel[branch], table.rows[branch, level]) for branch, level in zip(rows, levels, strict=True)
    )
    dimension = Dimension.LENGTH if heads.over == "travel" else Dimension.ANGLE
    return LoadCard(
        sort=heads.sort,
        over=heads.over,
        places=_given(places, heads.place_unit, dimension),
        out=_given(out, heads.units[0], _SORTS[heads.sort]),
        back=_given(back, heads.units[-1], _SORTS[heads.sort]),
        first=table.position(int(np.argmin(travel)), heads.where),
        last=table.position(int(np.argmax(travel)), heads.where),
        negative=_negative(table, heads),
    )


def _given(numbers: Array, unit: str, dimension: Dimension) -> tuple[Given, ...]:
    """Give numbers of a file as quantities."""
    scale = read(f"1 {unit}", dimension)
    return tuple(Given(scale * number, f"{number:.12g} {unit}") for number in numbers.tolist())


def _negative(table: NumberTable, heads: _Heads) -> tuple[tuple[str, Position], ...]:
    """Find sizes of less than 0."""
    found = ((row, level) for level in heads.levels for row in np.flatnonzero(table.rows[:, level] < 0).tolist())
    return tuple((f"{table.rows[row, level]:g}", table.position(row, level)) for row, level in found)


def _heads(table: NumberTable, columns: Sequence[int] | None) -> _Heads:
    """Tell which columns count and what they are; refuse what goes together in no load."""
    where, *levels = _columns(table, columns)
    labels = table.labels or ("",) * table.rows.shape[1]
    over, place_unit = _axis(labels[where])
    found = [
        next(((sort, unit) for sort, of in _SORTS.items() if (unit := unit_in(labels[level], of))), None)
        for level in levels
    ]
    problems = [_without_unit(table, _("travel or angle"), labels[where], "travel [mm]")] if place_unit is None else []
    problems += [
        _without_unit(table, _("force or torque"), labels[level], "force [kN]")
        for level, one in zip(levels, found, strict=True)
        if one is None
    ]
    refuse(problems)
    known = [one for one in found if one is not None]
    refuse(_unfit(table, over, [sort for sort, _unit in known]))
    return _Heads(where, tuple(levels), over, known[0][0], place_unit or "", tuple(unit for _sort, unit in known))


def _columns(table: NumberTable, columns: Sequence[int] | None) -> Sequence[int]:
    """Places in a row, from 0, of where, of the size, and of the size on the way back if it has its own."""
    n_columns = table.rows.shape[1]
    if n_columns < _ONE_WAY:
        allowed = _("has one column; a load needs two, its size after crank angle, travel or swing")
        raise InputError([Problem("", None, allowed, None, Position(table.name, int(table.lines[0])))])
    if columns is None:
        if n_columns > _BOTH_WAYS:
            allowed = _("must say which of the {n} columns are place and size").format(n=n_columns)
            repair = _("write columns = [1, 2], or [1, 2, 3] with the size on the way back")
            raise InputError([Problem("columns", None, allowed, repair)])
        return range(n_columns)
    if max(columns) > n_columns or len(set(columns)) < len(columns):
        allowed = _("must be columns of the file, 1 to {n}, each once").format(n=n_columns)
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


def _without_unit(table: NumberTable, noun: str, head: str, example: str) -> Problem:
    """Say that a head names no unit of what is meant."""
    said = _("names no unit of {noun}{where}").format(
        noun=noun, where=_(", in the head “{head}”").format(head=short(head)) if head else ""
    )
    return Problem("file", table.name, said, _("write it in the head: {example}").format(example=example))


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


def _over_angle(table: NumberTable, heads: _Heads, text: str | None) -> LoadCard:
    """Take sizes over the crank angle as any curve over it."""
    kind = _ForceCurve if heads.sort == "force" else _TorqueCurve
    columns = (heads.where + 1, heads.levels[0] + 1)
    curve = given_curve(kind.model_construct(file=table.name, text=text, columns=columns))
    unit = "N" if heads.sort == "force" else "N*m"
    # With the first point at the end again, it is plain whether they go on over one turn or two.
    angles, values = np.append(curve.angles, curve.angles[0] + curve.period), np.append(curve.values, curve.values[0])
    return LoadCard(
        sort=heads.sort,
        over=heads.over,
        places=_given(np.degrees(angles), "deg", Dimension.ANGLE),
        out=_given(values, unit, _SORTS[heads.sort]),
        back=None,
        first=table.position(0, heads.where),
        last=table.position(len(table.lines) - 1, heads.where),
        negative=_negative(table, heads),
    )


def _side_by_side(table: NumberTable, heads: _Heads) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Rows of both ways, where each has its column: all, from the least travel on."""
    rows = np.arange(len(table.lines))
    refuse(_first_of(_falling(table, heads.where, rows), table.name))
    return rows, rows


def _branches(table: NumberTable, heads: _Heads) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Rows of the way out and of the way back, each from the least travel to the greatest, of rows that go round."""
    travel, sizes = table.rows[:, heads.where], table.rows[:, heads.levels[0]]
    refuse(_open(table, heads, travel, sizes))
    n_rows = len(travel) - (1 if sizes[-1] == sizes[0] else 0)  # a loop may say its first point again
    least, most = float(np.min(travel)), float(np.max(travel))
    leaves = (travel[:n_rows] == least) & (np.roll(travel[:n_rows], -1) != least)
    rows = np.roll(np.arange(n_rows), -int(np.flatnonzero(leaves)[0]))
    turned = travel[rows]
    top = int(np.argmax(turned))
    leaves_top = top + int(np.argmax(turned[top:] != most)) - 1 if turned[-1] != most else n_rows - 1
    ends = [k for k in range(leaves_top + 1, n_rows) if turned[k] == least]
    out, back = rows[: top + 1], np.append(rows[leaves_top : ends[0] if ends else n_rows], rows[ends[0] if ends else 0])
    beyond = rows[ends[0] :] if ends else rows[:0]
    refuse(
        _first_of(
            (
                *_falling(table, heads.where, out),
                *_rising(table, heads.where, back),
                *_rising(table, heads.where, beyond, is_end=True),
            ),
            table.name,
        )
    )
    return out, back[::-1]


def _open(table: NumberTable, heads: _Heads, travel: Array, sizes: Array) -> Iterator[Problem]:
    """Find rows that go out and not back, or do not come back to where they began."""
    position = table.position(len(travel) - 1, heads.where)
    steps = np.diff(travel)
    if np.all(steps >= 0) or np.all(steps <= 0):
        allowed = _("goes one way only, and a load over its {over} has a way out and a way back").format(
            over=_("swing") if heads.over == "swing" else _("travel")
        )
        repair = _("give the way back in further rows, or as a third column")
        yield Problem("file", table.name, allowed, repair, position)
    elif travel[-1] != travel[0]:
        allowed = _("must come back to where it began, {first:g}").format(first=travel[0])
        yield Problem("", f"{travel[-1]:g}", allowed, _("give the first row again as the last"), position)
    elif sizes[-1] != sizes[0] and np.min(travel) < travel[0] < np.max(travel):
        allowed = _("must be as in the first row, {first:g}, as the loop closes there").format(first=sizes[0])
        yield Problem("", f"{sizes[-1]:g}", allowed, None, table.position(len(travel) - 1, heads.levels[0]))


def _falling(table: NumberTable, where: int, rows: NDArray[np.intp]) -> Iterator[Problem]:
    """Find places that do not rise from row to row."""
    said = _("must be more than in line {line}, {before:g}: on the way out there is one size at each place")
    yield from _against(table, where, rows, 1.0, said)


def _rising(table: NumberTable, where: int, rows: NDArray[np.intp], *, is_end: bool = False) -> Iterator[Problem]:
    """Find places that do not fall from row to row; where the way back has ended already, that rise again."""
    said = _("must be less than in line {line}, {before:g}: on the way back there is one size at each place")
    if is_end:
        said = _("must be as in line {line}, {before:g}, where the way back has ended")
    yield from _against(table, where, rows, -1.0 if not is_end else 0.0, said)


def _against(table: NumberTable, where: int, rows: NDArray[np.intp], sign: float, said: str) -> Iterator[Problem]:
    """Find steps from row to row that are not of a sign; of the sign 0 that go anywhere."""
    steps = np.diff(table.rows[rows, where])
    wrong = steps != 0 if sign == 0 else sign * steps <= 0
    for step in np.flatnonzero(wrong).tolist():
        before, own = int(rows[step]), int(rows[step + 1])
        allowed = said.format(line=int(table.lines[before]), before=table.rows[before, where])
        yield Problem("", f"{table.rows[own, where]:g}", allowed, None, table.position(own, where))


def _first_of(problems: Iterator[Problem] | Sequence[Problem], name: str) -> Iterator[Problem]:
    """Keep the first problems, and count the others."""
    each = iter(problems)
    yield from islice(each, _MOST_PROBLEMS)
    n_more = sum(1 for _problem in each)
    if n_more:
        yield Problem("file", name, _("{n} more places like these").format(n=n_more))
