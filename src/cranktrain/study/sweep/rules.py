"""Rules asked of many designs at once: those of the tables by numbers that are followed, and whether links close."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any, NamedTuple, cast

import numpy as np
from numpy.typing import NDArray

from cranktrain.columns import with_numbers
from cranktrain.errors import InputError
from cranktrain.language import Said
from cranktrain.machine import Machine
from cranktrain.mechanisms.closing import closing_all_round
from cranktrain.mechanisms.kind import AnyGeometry, AnyKind, rows
from cranktrain.motion import Array
from cranktrain.numerics.designs import by_design
from cranktrain.numerics.nested import each_changed, leaves
from cranktrain.paths import PathParts, item_at
from cranktrain.quantities import Given
from cranktrain.spec import Spec
from cranktrain.study.sweep.followed import FollowedNumber, NotFollowed, RuleCourse
from cranktrain.study.sweep.numbers import bits

_MOST_WAYS = 256
"""Ways through the rules that are followed; designs that go yet others are asked one by one."""
_MOST_LOST = 2
"""Ways that could not be followed, after which no more are tried."""


class JudgedDesigns(NamedTuple):
    """What rules say of designs, each of shape (design,).

    Attributes
    ----------
    is_wrong : array of bool
        Something is wrong.
    is_unknown : array of bool
        It is not to be told together.
    cycle : Array
        Crank angle after which all repeats, of those with which nothing is wrong, which may be one turn or two. [rad]
    """

    is_wrong: NDArray[np.bool_]
    is_unknown: NDArray[np.bool_]
    cycle: Array


def judged_together(machine: Machine, columns: Mapping[PathParts, Array], n_designs: int) -> JudgedDesigns:
    """Ask rules of designs that differ in some numbers, as `machine_problems` does of one.

    Parameters
    ----------
    machine : Machine
        One of them, or another like them, whose own tables are right each by itself.
    columns : mapping of Array, shape (design,)
        The numbers, by where they stand.
    n_designs : int

    Returns
    -------
    JudgedDesigns

    Notes
    -----
    The rules go the way of the first design; those that go along are judged with it, and of the others again the first
    is looked at, until none is left.
    """
    judged = _by_tables(machine, columns, n_designs)
    right = np.flatnonzero(~judged.is_wrong & ~judged.is_unknown)
    if right.size:
        own = {where: column[right] for where, column in columns.items()}
        try:
            judged.is_wrong[right], judged.is_unknown[right] = _by_closing(machine, own, right.size)
        except Exception:  # of one whose geometry cannot be put together, each is to say so
            judged.is_unknown[right] = True
    return judged


def _by_tables(machine: Machine, columns: Mapping[PathParts, Array], n_designs: int) -> JudgedDesigns:
    is_wrong, is_unknown = np.zeros((2, n_designs), dtype=bool)
    cycle = np.full(n_designs, np.nan)
    left, n_lost = np.arange(n_designs), 0
    for _way in range(_MOST_WAYS):
        if not left.size or n_lost == _MOST_LOST:
            break
        course = RuleCourse(left.size)
        given = {
            where: replace(_given(machine, where), si=cast("Any", FollowedNumber(course, column[left])))
            for where, column in columns.items()
        }
        try:
            found = _cycle_of(machine, given)
        except (NotFollowed, Exception):  # of a rule that fails itself, each design is to say so
            is_unknown[left[course.goes_along]] = True
            n_lost += 1
        else:
            is_wrong[left[course.goes_along]] = found is None
            cycle[left[course.goes_along]] = np.nan if found is None else found
        left = left[~course.goes_along]
    is_unknown[left] = True
    return JudgedDesigns(is_wrong, is_unknown, cycle)


def _given(machine: Machine, where: PathParts) -> Given:
    """A quantity of the tables."""
    given = item_at(machine, where)
    assert isinstance(given, Given)
    return given


def _cycle_of(machine: Machine, given: Mapping[PathParts, Given]) -> float | None:
    """The cycle with these numbers; None where rules find anything, of tables in which one stands or of all."""
    design = with_numbers(machine, given)
    try:
        with np.errstate(all="ignore"):
            if any(True for table in _tables(design, given) for _problem in table._problems()):  # pyright: ignore[reportPrivateUsage]
                return None
        return None if design.table_problems else design.cycle
    except InputError:
        return None


def _tables(machine: Machine, given: Mapping[PathParts, Given]) -> Iterator[Spec]:
    """Tables in which one of the numbers stands."""
    for above in dict.fromkeys(where[:n] for where in given for n in range(len(where))):
        if isinstance(table := item_at(machine, above), Spec):
            yield table


def _by_closing(
    machine: Machine, columns: Mapping[PathParts, Array], n_designs: int
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Which of designs whose tables are right have links that do not close, and of which it is not to be told."""
    given = {where: replace(_given(machine, where), column=column) for where, column in columns.items()}
    places, problems = with_numbers(machine, given).arranged
    is_wrong, is_unknown = np.zeros((2, n_designs), dtype=bool)
    if problems:
        return is_wrong, ~is_unknown
    for place in {id(place.geometry): place for place in places}.values():
        geometry = _by_design(place.geometry, n_designs)
        different, which = _different(geometry)
        closes, is_unclear = (truths[which] for truths in closing_all_round(place.kind, different))
        stuck = np.flatnonzero(~closes & ~is_unclear)
        if stuck.size and _is_refused_whole(place.kind, rows(geometry, stuck[:1])):
            is_wrong[stuck] = True
        else:
            is_unknown[stuck] = True
        is_unknown |= is_unclear
    return is_wrong, is_unknown & ~is_wrong


def _is_refused_whole(kind: AnyKind, geometry: AnyGeometry) -> bool:
    """Whether a mechanism that does not close is refused, whichever of its parts it is that does not."""
    return isinstance(kind.closing_advice(each_changed(lambda value: value[0, 0], geometry)), Said | str)


def _by_design(geometry: AnyGeometry, n_designs: int) -> AnyGeometry:
    """Give a geometry that is laid out of designs together as arrays of shape (design, 1)."""
    members: AnyGeometry = by_design([geometry], n_designs)
    return each_changed(lambda value: value[:, 0], members)


def _different(geometry: AnyGeometry) -> tuple[AnyGeometry, NDArray[np.intp]]:
    """Take what differs among geometries, shape (design, 1), and which of these each is: of a map most are alike."""
    which = np.zeros(len(leaves(geometry)[0]), dtype=np.intp)
    for leaf in leaves(geometry):
        _numbers, own = np.unique(bits(leaf[:, 0]), return_inverse=True)
        which = np.unique(which * (own.max() + 1) + own, return_inverse=True)[1]
    _which, first = np.unique(which, return_index=True)
    return rows(geometry, first), which
