"""A file of two columns, crank angle and what there is at it: a table's fields, and the file over one turn or two."""

from collections.abc import Iterable, Iterator
from functools import lru_cache
from typing import ClassVar, NamedTuple

import numpy as np
from pydantic import Field

from cranktrain.errors import InputError, Position, Problem, first_of, refuse
from cranktrain.language import N_, _
from cranktrain.listed import OF_FILE, FileColumns, FileText
from cranktrain.motion import Array
from cranktrain.number_table import NumberTable, held_text, read_table
from cranktrain.numerics.harmonics import TURN
from cranktrain.numerics.polyline import Polyline
from cranktrain.one_line import short
from cranktrain.quantities import Dimension, is_unit, one_of, read, unit_names
from cranktrain.quantities.heads import is_time, time_advice, unit_in
from cranktrain.spec import Spec

_SAME = 1e-6
"""Spans closer than this are one. [rad]"""
_CLOSED = 0.01
"""First and last value of a closed curve differ by less, in parts of the largest."""


class Words(NamedTuple):
    """What a file is and what it gives at each angle, untranslated; of that its dimension, and the key of its unit.

    without_unit: what is wrong where no unit is known, and what to write then.
    """

    curve: str
    value: str
    dimension: Dimension
    unit_key: str
    without_unit: tuple[str, str]


class CycleFileSpec(Spec, frozen=True):
    """A curve over the crank angle in a file of two columns.

    Whoever loads a machine file also reads the file that `file` names, and puts what it holds into `text`.
    """

    of_file: ClassVar = OF_FILE
    words: ClassVar[Words]

    file: str = Field(
        min_length=1, description=N_("File with the values over the crank angle, relative to the machine file.")
    )
    text: FileText = None
    columns: FileColumns = Field(
        default=None,
        min_length=2,
        max_length=2,
        description=N_("Columns of crank angle and value, counted from 1; needed where there are more than two."),
    )

    @property
    def unit(self) -> str | None:
        """Unit of the values, where the table gives it."""
        return getattr(self, self.words.unit_key)

    @property
    def needs_unit(self) -> bool:
        """Whether values without a unit say nothing."""
        return True

    def _problems(self) -> Iterator[Problem]:
        """Find a unit that is none, and what is wrong in the file."""
        if self.unit is not None and not is_unit(self.unit, self.words.dimension):
            yield Problem(self.words.unit_key, self.unit, one_of(unit_names(self.words.dimension)))
        elif self.text is not None:
            yield from self._curve_problems(given_curve(self))

    def _curve_problems(self, _curve: Polyline) -> Iterable[Problem]:
        """Find what this kind of curve must not be."""
        return ()


@lru_cache(maxsize=8)
def given_curve(spec: CycleFileSpec) -> Polyline:
    """Read the curve that the spec holds.

    Parameters
    ----------
    spec : CycleFileSpec

    Returns
    -------
    Polyline
        In SI, over the crank angle as it is shown, with the period of one turn or two; as the file has them where no
        unit is needed and none known. A last point that is the first one again is left out.

    Raises
    ------
    InputError
        With all that cannot be read in the file, at line and column; or if nobody has read it.
    """
    words = spec.words
    table = read_table(held_text(spec.file, spec.text), spec.file)
    where, level = _columns(spec, table)
    numbers = table.rows
    labels = table.labels or ("",) * numbers.shape[1]
    if is_time(labels[where]):
        allowed = _("has a time in column {column}, “{head}”, and {curve} is over the crank angle")
        said = allowed.format(column=where + 1, head=short(labels[where]), curve=_(words.curve))
        raise InputError([Problem("file", spec.file, said, time_advice())])
    angle_unit = unit_in(labels[where], Dimension.ANGLE) or "deg"
    angles, values = numbers[:, where] * read(f"1 {angle_unit}", Dimension.ANGLE), numbers[:, level]
    problems = [*_few_of(_order_problems(table, where), table.name)] or [
        *_span_problems(spec, table, angles, values, where)
    ]
    unit = spec.unit or unit_in(labels[level], words.dimension)
    if unit is None and spec.needs_unit:
        allowed, repair = map(_, words.without_unit)
        units = ", ".join(unit_names(words.dimension))
        problems.append(Problem(words.unit_key, None, allowed, repair.format(units=units)))
    refuse(problems)
    period = _period(angles) or TURN
    kept = slice(None, -1) if _is_closed(angles, period) else slice(None)
    factor = 1.0 if unit is None else read(f"1 {unit}", words.dimension)
    return Polyline(angles[kept], values[kept] * factor, period)


def _columns(spec: CycleFileSpec, table: NumberTable) -> tuple[int, int]:
    """Places of angle and value in a row, from 0."""
    words = spec.words
    n_columns = table.rows.shape[1]
    if n_columns < 2:
        allowed = _("has one column; {curve} needs two, crank angle and {value}")
        said = allowed.format(curve=_(words.curve), value=_(words.value))
        raise InputError([Problem("", None, said, None, Position(spec.file, int(table.lines[0])))])
    if spec.columns is None:
        if n_columns > 2:
            allowed = _("must say which of the {n} columns are crank angle and {value}")
            repair = _("write columns = [1, 2], or other two")
            raise InputError([Problem("columns", None, allowed.format(n=n_columns, value=_(words.value)), repair)])
        return 0, 1
    if max(spec.columns) > n_columns:
        raise InputError([Problem("columns", None, _("must be columns of the file, 1 to {n}", n=n_columns))])
    return spec.columns[0] - 1, spec.columns[1] - 1


def _few_of(problems: Iterator[Problem], name: str) -> Iterator[Problem]:
    """Keep the first problems, and count the others."""
    return first_of(problems, lambda n: Problem("file", name, _("{n} more angles like these", n=n)))


def _order_problems(table: NumberTable, where: int) -> Iterator[Problem]:
    """Find angles that are given twice or go back, each at its place."""
    angles = table.rows[:, where]
    for row in (np.flatnonzero(np.diff(angles) <= 0) + 1).tolist():
        before, own = float(angles[row - 1]), float(angles[row])
        allowed = _(
            "must be more than the angle in line {line}, {before:g}", line=int(table.lines[row - 1]), before=before
        )
        repair = _("for a jump, give two angles a little apart") if own == before else None
        yield Problem("", f"{own:g}", allowed, repair, table.position(row, where))


def _span_problems(
    spec: CycleFileSpec, table: NumberTable, angles: Array, values: Array, where: int
) -> Iterator[Problem]:
    """Find a curve that is not one turn or two, and one that does not close."""
    position = table.position(len(table.lines) - 1, where)
    period = _period(angles)
    if period is None:
        first, last = (f"{np.degrees(float(end)):.7g}°" for end in (angles[0], angles[-1]))
        allowed = _("reaches from {first} to {last}; it must go on over one turn, 360°, or over two, 720°")
        repair = _("give the {value} at both ends, or in equal steps all round", value=_(spec.words.value))
        if abs(float(angles[-1] - angles[0]) - np.radians(TURN)) < np.radians(TURN) / len(angles):
            repair = _("if these are radians, write so in the header: angle [rad]")
        yield Problem("file", spec.file, allowed.format(first=first, last=last), repair, position)
    elif _is_closed(angles, period) and abs(values[-1] - values[0]) > _CLOSED * np.max(np.abs(values)):
        allowed = _("must be as at the start of the turn, {start:g}, as it begins again there")
        yield Problem("", f"{values[-1]:g}", allowed.format(start=values[0]), None, position)


def _period(angles: Array) -> float | None:
    """One turn or two, if the angles are just that: with both ends, or in equal steps with one; else None. [rad]"""
    steps = np.diff(angles)
    span = float(angles[-1] - angles[0])
    is_even = len(steps) > 0 and float(np.ptp(steps)) < _SAME
    for period in (TURN, 2 * TURN):
        if abs(span - period) < _SAME or (is_even and abs(span + float(steps[0]) - period) < len(angles) * _SAME):
            return period
    return None


def _is_closed(angles: Array, period: float) -> bool:
    """Whether the last angle is the first one of the next turn."""
    return abs(float(angles[-1] - angles[0]) - period) < _SAME
