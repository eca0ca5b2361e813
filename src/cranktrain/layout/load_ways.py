"""Rows of a load's file over a travel or a swing: which of them go out, and which come back."""

from collections.abc import Iterable, Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.errors import Problem, first_of, refuse
from cranktrain.language import Message, _
from cranktrain.layout.load_heads import LoadHeads
from cranktrain.motion import Array
from cranktrain.number_table import NumberTable


class BothWays(NamedTuple):
    """Rows of the way out and of the way back, each from the least travel to the greatest, from 0."""

    out: NDArray[np.intp]
    back: NDArray[np.intp]


def side_by_side(table: NumberTable, heads: LoadHeads) -> BothWays:
    """Rows of both ways, where each has its column: all, from the least travel on."""
    rows = np.arange(len(table.lines))
    refuse(_few_of(_falling(table, heads.where, rows), table.name))
    return BothWays(rows, rows)


def round_trip(table: NumberTable, heads: LoadHeads) -> BothWays:
    """Rows of the way out and of the way back, each from the least travel to the greatest, of rows that go round."""
    travel, sizes = table.rows[:, heads.where], table.rows[:, heads.levels[0]]
    refuse(_open(table, heads, travel, sizes))
    n_rows = len(travel) - (1 if sizes[-1] == sizes[0] else 0)  # a loop may say its first point again
    least, most = float(np.min(travel)), float(np.max(travel))
    leaves = (travel[:n_rows] == least) & (np.roll(travel[:n_rows], -1) != least)
    rows = np.roll(np.arange(n_rows), -int(np.flatnonzero(leaves)[0]))
    turned = travel[rows]
    top = int(np.argmax(turned == most))
    leaves_top = top + int(np.argmax(turned[top:] != most)) - 1 if turned[-1] != most else n_rows - 1
    ends = [k for k in range(leaves_top + 1, n_rows) if turned[k] == least]
    out, back = rows[: top + 1], np.append(rows[leaves_top : ends[0] if ends else n_rows], rows[ends[0] if ends else 0])
    beyond = rows[ends[0] :] if ends else rows[:0]
    refuse(
        _few_of(
            (
                *_falling(table, heads.where, out),
                *_rising(table, heads.where, back),
                *_rising(table, heads.where, beyond, is_end=True),
            ),
            table.name,
        )
    )
    return BothWays(out, back[::-1])


def _open(table: NumberTable, heads: LoadHeads, travel: Array, sizes: Array) -> Iterator[Problem]:
    """Find rows that go out and not back, or do not come back to where they began."""
    position = table.position(len(travel) - 1, heads.where)
    steps = np.diff(travel)
    if np.all(steps >= 0) or np.all(steps <= 0):
        allowed = _(
            "goes one way only, and a load over its {over} has a way out and a way back",
            over=_("swing") if heads.over == "swing" else _("travel"),
        )
        repair = _("give the way back in further rows, or as a third column")
        yield Problem("file", table.name, allowed, repair, position)
    elif travel[-1] != travel[0]:
        allowed = _("must come back to where it began, {first:g}", first=travel[0])
        yield Problem("", f"{travel[-1]:g}", allowed, _("give the first row again as the last"), position)
    elif sizes[-1] != sizes[0] and np.min(travel) < travel[0] < np.max(travel):
        allowed = _("must be as in the first row, {first:g}, as the loop closes there", first=sizes[0])
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


def _against(table: NumberTable, where: int, rows: NDArray[np.intp], sign: float, said: Message) -> Iterator[Problem]:
    """Find steps from row to row that are not of a sign; of the sign 0 that go anywhere."""
    steps = np.diff(table.rows[rows, where])
    wrong = steps != 0 if sign == 0 else sign * steps <= 0
    for step in np.flatnonzero(wrong).tolist():
        before, own = int(rows[step]), int(rows[step + 1])
        allowed = said.format(line=int(table.lines[before]), before=table.rows[before, where])
        yield Problem("", f"{table.rows[own, where]:g}", allowed, None, table.position(own, where))


def _few_of(problems: Iterable[Problem], name: str) -> Iterator[Problem]:
    """Keep the first problems, and count the others."""
    return first_of(problems, lambda n: Problem("file", name, _("{n} more places like these", n=n)))
