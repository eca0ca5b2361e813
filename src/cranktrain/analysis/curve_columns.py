"""Curves as columns over the crank angle: one for each member, of rivals the one that is meant; and tables of them."""

import itertools
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.analysis.dimensions import dimension_named
from cranktrain.analysis.result import Result
from cranktrain.motion import Array
from cranktrain.saying.catalogue import Entry
from cranktrain.saying.run import Run


class CurveColumn(NamedTuple):
    """A curve of one member.

    Attributes
    ----------
    entry : Entry
    labels : mapping of str to str
        Whose it is, along each dimension.
    values : Array, shape (crank_angle,)
        In the unit of the entry.
    """

    entry: Entry
    labels: Mapping[str, str]
    values: Array

    @property
    def of(self) -> str:
        """Whose it is, and by which method, in one text."""
        return " ".join(self.labels.values())

    @property
    def member(self) -> str:
        """Whose it is; empty where it is the machine's."""
        return " ".join(name for dimension, name in self.labels.items() if dimension_named(dimension).own is None)


def by_default(run: Run) -> tuple[str, ...]:
    """Name the curves that nobody has to ask for: all but those that are there to be compared."""
    return tuple(
        name
        for name, entry in run.catalogue.items()
        if run.is_curve(entry) and not any(dimension_named(one).is_compared for one in run.labels_of(entry))
    )


def curve_columns(run: Run, names: Collection[str], *, of_each_method: bool = True) -> Iterator[CurveColumn]:
    """Give curves, member by member.

    Parameters
    ----------
    run : Run
        Of one design.
    names : collection of str
        Which curves; facts, which are not over the axis, are left out.
    of_each_method : bool
        Whether by each method, and by other rivals; else by that which is meant where none is named.
    """
    for name, entry in run.catalogue.items():
        if name not in names or run.axis is None or not run.is_curve(entry):
            continue
        curves: Array = np.moveaxis(getattr(run, name), entry.dimensions.index(run.axis.name), -1)
        labels = run.labels_of(entry)
        places = [_places(dimension, len(members), all_of=of_each_method) for dimension, members in labels.items()]
        for place in itertools.product(*places):
            chosen = zip(labels.items(), place, strict=True)
            yield CurveColumn(entry, {dimension: members[at] for (dimension, members), at in chosen}, curves[place])


def _places(dimension: str, n_members: int, *, all_of: bool) -> Sequence[int]:
    """Members along a dimension, or of rivals the one that is meant."""
    own = dimension_named(dimension).own
    return range(n_members) if all_of or own is None or not n_members else (own % n_members,)


class CurvesAtAngle:
    """Curves of one machine at one crank angle, as facts: of rivals that which is meant."""

    def __init__(self, result: Result, place: int, names: Collection[str]) -> None:
        self._result, self._place, self.cycle = result, place, result.cycle
        self.catalogue = {
            name: replace(entry, dimensions=tuple(filter(_is_beside, entry.dimensions)))
            for name, entry in result.catalogue.items()
            if name in names and not entry.is_fact
        }

    def titles_of(self, entry: Entry) -> dict[str, tuple[str, ...]]:
        """What people call the members along each dimension of a quantity."""
        return {dimension: tuple(map(str, self._result.titles[dimension])) for dimension in entry.dimensions}

    def __getattr__(self, name: str) -> Array:
        """Give a curve's values at the angle, in the unit of its entry."""
        columns = curve_columns(self._result, (name,), of_each_method=False)
        values = np.array([column.values[self._place] for column in columns])
        return values.reshape([len(titles) for titles in self.titles_of(self.catalogue[name]).values()])


def _is_beside(dimension: str) -> bool:
    """Whether values along a dimension stand beside each other at one crank angle."""
    return dimension != "crank_angle" and dimension_named(dimension).own is None


def of_member(columns: Iterable[CurveColumn], member: str) -> list[CurveColumn]:
    """Those columns that are of a member, of its parts, or of the machine."""
    return [column for column in columns if column.member in ("", member) or column.member.startswith(f"{member}.")]


def at_angles(columns: Iterable[CurveColumn], places: NDArray[np.intp]) -> list[CurveColumn]:
    """The same columns at some places of the grid alone."""
    return [column._replace(values=column.values[places]) for column in columns]
