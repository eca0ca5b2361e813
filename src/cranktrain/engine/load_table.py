"""The table of a machine file that names a load curve, and the file read: torque over the crank angle."""

from collections.abc import Iterator
from functools import lru_cache
from typing import Annotated, ClassVar, Literal, Self

import numpy as np
from pydantic import Field, model_validator

from cranktrain.errors import InputError, Position, Problem
from cranktrain.gas.indicator.reading import unit_in
from cranktrain.gas.indicator.table import Table, read_table
from cranktrain.language import N_, _
from cranktrain.loads.polyline import Polyline, polyline_mean
from cranktrain.motion import Array
from cranktrain.quantities import Dimension, QuantityError, one_of, read, unit_names
from cranktrain.spec import Spec

_TURN = 2 * np.pi
_SAME = 1e-6
"""Spans closer than this are one. [rad]"""
_CLOSED = 0.01
"""First and last torque of a closed curve differ by less, in parts of the largest."""
_MOST_PROBLEMS = 10


class LoadCurveSpec(Spec, frozen=True):
    """Load torque over the crank angle from a file of two columns; it stands beside what balances the rest.

    Whoever loads a machine file also reads the file that `file` names, and puts what it holds into `text`.
    """

    of_file: ClassVar[frozenset[str]] = frozenset({"file", "text", "columns", "torque_unit"})

    file: str = Field(
        min_length=1, description=N_("File with the load torque over the crank angle, relative to the machine file.")
    )
    text: str | None = Field(
        default=None, description=N_("What the file holds, where it is not to be read; `file` is then only its name.")
    )
    scale: Literal["given", "balanced"] = Field(
        default="given",
        description=N_(
            "Whether the torques count as given, and the rest of the mean is balanced besides,"
            " or times one factor, so that they balance it."
        ),
    )
    columns: tuple[Annotated[int, Field(ge=1)], ...] | None = Field(
        default=None,
        min_length=2,
        max_length=2,
        description=N_("Columns of crank angle and torque, counted from 1; needed where there are more than two."),
    )
    torque_unit: str | None = Field(
        default=None, description=N_("Unit of the torques, where the header does not say it.")
    )

    @model_validator(mode="after")
    def _readable(self) -> Self:
        """Refuse a unit that is none, and a file that cannot be read as a load curve."""
        if self.torque_unit is not None:
            try:
                read(f"1 {self.torque_unit}", Dimension.TORQUE)
            except QuantityError:
                allowed = one_of(unit_names(Dimension.TORQUE))
                raise InputError([Problem("torque_unit", self.torque_unit, allowed)]) from None
        if self.text is not None:
            load_polyline(self)
        return self


@lru_cache(maxsize=8)
def load_polyline(spec: LoadCurveSpec) -> Polyline:
    """Read the load curve that the spec holds.

    Parameters
    ----------
    spec : LoadCurveSpec

    Returns
    -------
    Polyline
        Torque, positive where it resists, over the crank angle as it is shown, with the period of one turn or two.
        [rad, N·m]

    Raises
    ------
    InputError
        With all that is wrong in the file, at line and column; or if nobody has read it.
    """
    if spec.text is None:
        allowed = _("has not been read: load the machine from its file, or give what the file holds in `text`")
        raise InputError([Problem("file", spec.file, allowed)])
    table = read_table(spec.text, spec.file)
    where, level = _columns(spec, table)
    numbers = table.rows
    labels = table.labels or ("",) * numbers.shape[1]
    angle_unit = unit_in(labels[where], Dimension.ANGLE) or "deg"
    angles = numbers[:, where] * read(f"1 {angle_unit}", Dimension.ANGLE)
    problems = [*_order_problems(table, where)]
    if not problems:
        problems = [*_span_problems(spec, table, angles, numbers[:, level], where)]
    torque_unit = spec.torque_unit or unit_in(labels[level], Dimension.TORQUE)
    if torque_unit is None and spec.scale == "given":
        problems.append(_missing_unit())
    if problems:
        raise InputError(problems)
    factor = 1.0 if torque_unit is None else read(f"1 {torque_unit}", Dimension.TORQUE)
    curve = _one_period(angles, numbers[:, level] * factor)
    if spec.scale == "balanced" and not polyline_mean(curve) > 0:
        allowed = _('has a mean torque of 0 or less, which no factor makes a load; write scale = "given"')
        raise InputError([Problem("file", spec.file, allowed)])
    return curve


def _columns(spec: LoadCurveSpec, table: Table) -> tuple[int, int]:
    """Places of angle and torque in a row, from 0."""
    n_columns = table.rows.shape[1]
    if n_columns < 2:
        allowed = _("has one column; a load curve needs two, crank angle and torque")
        raise InputError([Problem("", None, allowed, None, Position(spec.file, int(table.lines[0])))])
    if spec.columns is None:
        if n_columns > 2:
            allowed = _("must say which of the {n} columns are crank angle and torque").format(n=n_columns)
            raise InputError([Problem("columns", None, allowed, _("write columns = [1, 2], or other two"))])
        return 0, 1
    if max(spec.columns) > n_columns:
        raise InputError([Problem("columns", None, _("must be columns of the file, 1 to {n}").format(n=n_columns))])
    return spec.columns[0] - 1, spec.columns[1] - 1


def _order_problems(table: Table, where: int) -> Iterator[Problem]:
    """Find angles that are given twice or go back, each at its place."""
    angles = table.rows[:, where]
    wrong = np.flatnonzero(np.diff(angles) <= 0) + 1
    for row in wrong[:_MOST_PROBLEMS].tolist():
        before, own = float(angles[row - 1]), float(angles[row])
        allowed = _("must be more than the angle in line {line}, {before:g}").format(
            line=int(table.lines[row - 1]), before=before
        )
        repair = _("for a jump, give two angles a little apart") if own == before else None
        yield Problem("", f"{own:g}", allowed, repair, table.position(row, where))
    if wrong.size > _MOST_PROBLEMS:
        yield Problem("file", table.name, _("{n} more angles like these").format(n=wrong.size - _MOST_PROBLEMS))


def _span_problems(spec: LoadCurveSpec, table: Table, angles: Array, torques: Array, where: int) -> Iterator[Problem]:
    """Find a curve that is not one turn or two, and one that does not close."""
    position = table.position(len(table.lines) - 1, where)
    period = _period(angles)
    if period is None:
        first, last = (f"{np.degrees(float(end)):.7g}°" for end in (angles[0], angles[-1]))
        allowed = _("reaches from {first} to {last}; it must go on over one turn, 360°, or over two, 720°")
        repair = _("give the torque at both ends, or in equal steps all round")
        if abs(float(angles[-1] - angles[0]) - np.radians(_TURN)) < np.radians(_TURN) / len(angles):
            repair = _("if these are radians, write so in the header: angle [rad]")
        yield Problem("file", spec.file, allowed.format(first=first, last=last), repair, position)
    elif _is_closed(angles, period) and abs(torques[-1] - torques[0]) > _CLOSED * np.max(np.abs(torques)):
        allowed = _("must be as at the start of the turn, {start:g}, as it begins again there")
        yield Problem("", f"{torques[-1]:g}", allowed.format(start=torques[0]), None, position)


def _missing_unit() -> Problem:
    """Refuse torques without a unit, where they are to count as they are."""
    allowed = _("the file names no unit of torque")
    repair = _('write torque_unit = "N·m" (or {units}), or scale = "balanced"')
    return Problem("torque_unit", None, allowed, repair.format(units=", ".join(unit_names(Dimension.TORQUE))))


def _period(angles: Array) -> float | None:
    """One turn or two, if the angles are just that: with both ends, or in equal steps with one; else None. [rad]"""
    steps = np.diff(angles)
    span = float(angles[-1] - angles[0])
    is_even = len(steps) > 0 and float(np.ptp(steps)) < _SAME
    for period in (_TURN, 2 * _TURN):
        if abs(span - period) < _SAME or (is_even and abs(span + float(steps[0]) - period) < len(angles) * _SAME):
            return period
    return None


def _is_closed(angles: Array, period: float) -> bool:
    """Whether the last angle is the first one of the next turn."""
    return abs(float(angles[-1] - angles[0]) - period) < _SAME


def _one_period(angles: Array, torques: Array) -> Polyline:
    """Leave out the last point where it is the first one again."""
    period = _period(angles) or _TURN
    kept = slice(None, -1) if _is_closed(angles, period) else slice(None)
    return Polyline(angles[kept], torques[kept], period)
