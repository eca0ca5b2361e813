"""An indicator file as text, read: which columns it has, in which units, absolute or gauge."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.errors import InputError, Position, Problem
from cranktrain.language import Listed, Message, Words, _
from cranktrain.motion import Array
from cranktrain.number_table import NumberTable, read_table
from cranktrain.one_line import short
from cranktrain.quantities import Dimension, read, shown, unit_names
from cranktrain.quantities.heads import (
    AXES,
    Axis,
    axis_of,
    in_head,
    is_gauge,
    is_pressure,
    is_time,
    time_advice,
    unit_in,
)
from cranktrain.record import record

STANDARD_ATMOSPHERE = 101325.0
"""What gauge pressures count from, unless said. [Pa]"""

_PAIR = 2
"""Columns of a diagram."""
_DEGREES_BEYOND = 15.0
"""Angles that reach farther than two turns in radians are degrees."""


class Columns(NamedTuple):
    """What a machine file says of a trace whose own header does not, or says otherwise.

    Columns of axis and pressure, from 1; what the axis is; the units; whether pressures are gauge, and above what [Pa];
    whether they are raw, as their level is still to be found or their noise to be smoothed.
    """

    columns: tuple[int, int] | None = None
    axis: Axis | None = None
    axis_unit: str | None = None
    pressure_unit: str | None = None
    is_gauge: bool | None = None
    ambient: float = STANDARD_ATMOSPHERE
    is_raw: bool = False


@record
class Trace:
    """An indicator file as it was read, in the file's own order and counting.

    Attributes
    ----------
    name : str
        Of the file, for messages.
    axis : "angle", "displacement" or "volume"
        What the pressure is given over.
    places : Array, shape (n,)
        Crank angles [rad], volumes [m³], or displacements, of which only the ratios count.
    pressures : Array, shape (n,)
        Absolute, as far as the file knows their level. [Pa]
    lines : array of int, shape (n,)
    findings : tuple of Words
        What was found out, as sentences.
    """

    name: str
    axis: Axis
    places: Array
    pressures: Array
    lines: NDArray[np.intp]
    findings: tuple[Words, ...]

    def refused(self, allowed: Words, line: int | None = None, repair: Words | None = None) -> InputError:
        """Give the error that says what is wrong with the file, at a line of it if it has one."""
        if line is None:
            return InputError([Problem("file", self.name, allowed, repair)])
        return InputError([Problem("", None, allowed, repair, Position(self.name, line))])


def read_trace(text: str, name: str, said: Columns | None = None) -> Trace:
    r"""Read an indicator file.

    Parameters
    ----------
    text : str
        As `read_table` takes it; names and units of the columns may stand in its header.
    name : str
        Of the file, for messages.
    said : Columns, optional
        What the header does not say, or what is to go before it.

    Returns
    -------
    Trace

    Raises
    ------
    InputError
        With what is wrong, at line and column where it has one.

    Examples
    --------
    >>> trace = read_trace("Crank angle;Pressure\n°CA;bar\n0;50,5\n1;51", "trace.csv")
    >>> trace.axis, trace.pressures.tolist()
    ('angle', [5050000.0, 5100000.0])
    """
    said = Columns() if said is None else said
    table = read_table(text, name)
    axis, where, level = _columns(table, said, name)
    _refuse_time(table, where, said)
    labels = table.labels or ("",) * table.rows.shape[1]
    place_scale, findings = _place_scale(axis, labels[where], said, table, where)
    unit = said.pressure_unit or unit_in(labels[level], Dimension.PRESSURE)
    if unit is None:
        repair = _('write pressure_unit = "bar" (or {units})')
        said_of = in_head(_("the file names no unit of pressure"), labels[level])
        raise _without_unit("pressure_unit", said_of, repair, Dimension.PRESSURE)
    pressures, sentences, is_gauge_known = _absolute(table.rows[:, level], unit, labels[level], said)
    if not said.is_raw:
        _refuse_negative(pressures, table, level, is_gauge=is_gauge_known)
    return Trace(
        name=name,
        axis=axis,
        places=table.rows[:, where] * place_scale,
        pressures=pressures,
        lines=table.lines,
        findings=(*_columns_taken(table, said, level), *findings, *sentences),
    )


def _columns(table: NumberTable, said: Columns, name: str) -> tuple[Axis, int, int]:
    """Tell what the axis is, and which columns hold axis and pressure, counted from 0."""
    n_columns = table.rows.shape[1]
    if n_columns < _PAIR:
        allowed = _("has one column; an indicator diagram needs two, crank angle (or volume) and pressure")
        raise InputError([Problem("", None, allowed, None, Position(name, int(table.lines[0])))])
    if said.columns is not None:
        if max(said.columns) > n_columns or min(said.columns) < 1:
            allowed = _("must be columns of the file, 1 to {n}", n=n_columns)
            raise InputError([Problem("columns", None, allowed)])
        where, level = (column - 1 for column in said.columns)
        if where == level:
            raise InputError([Problem("columns", None, _("must be two columns, of the axis and of the pressure"))])
        meant = axis_of(table.labels[where]) if table.labels else None
        return said.axis or meant or "angle", where, level
    axes = {place: axis for place, label in enumerate(table.labels) if (axis := axis_of(label)) is not None}
    wanted: Sequence[Axis] = (said.axis,) if said.axis else ("angle", "volume", "displacement")
    levels = [place for place, label in enumerate(table.labels) if place not in axes and is_pressure(label)]
    for axis in wanted:
        found = [place for place in axes if axes[place] == axis]
        if found and levels:
            return axis, found[0], levels[0]
    return said.axis or "angle", 0, 1


def _refuse_time(table: NumberTable, where: int, said: Columns) -> None:
    """Refuse times as an axis, unless the table says that they are none."""
    label = table.labels[where] if table.labels else ""
    if said.axis is None and is_time(label):
        allowed = _(
            "has a time in column {column}, “{head}”, and an indicator diagram is over crank angle, volume or stroke"
        )
        said_of = allowed.format(column=where + 1, head=short(label))
        raise InputError([Problem("file", table.name, said_of, time_advice())])


def _columns_taken(table: NumberTable, said: Columns, level: int) -> Iterator[Words]:
    """Say which column is taken where there are more than the two that are needed."""
    if said.columns is None and table.rows.shape[1] > _PAIR:
        label = table.labels[level] if table.labels else ""
        sentence = _("The file has {n} columns; pressures are taken from column {column}: `columns` says otherwise.")
        column = Listed((str(level + 1), label)) if label else str(level + 1)
        yield sentence.format(n=table.rows.shape[1], column=column)


def _place_scale(
    axis: Axis, label: str, said: Columns, table: NumberTable, column: int
) -> tuple[float, tuple[Words, ...]]:
    """Give the SI value of one of the axis's units, and say what was taken for granted."""
    unit = said.axis_unit or unit_in(label, AXES[axis])
    if unit is not None:
        return read(f"1 {unit}", AXES[axis]), ()
    if axis == "displacement":
        return 1.0, ()
    if axis == "volume":
        repair = _('write axis_unit = "cm³" (or {units})')
        said_of = in_head(_("the file names no unit of volume"), label)
        raise _without_unit("axis_unit", said_of, repair, Dimension.VOLUME)
    farthest = float(np.ptp(table.rows[:, column]))
    unit = "deg" if farthest > _DEGREES_BEYOND else "rad"
    said_so = _("The file does not say the unit of its angles; they reach over {span:.6g}, so {unit} is taken.")
    return read(f"1 {unit}", Dimension.ANGLE), (said_so.format(span=farthest, unit=unit),)


def _without_unit(key: str, allowed: Words, repair: Message, dimension: Dimension) -> InputError:
    """Give the error that asks for a unit of the file."""
    return InputError([Problem(key, None, allowed, repair.format(units=", ".join(unit_names(dimension))))])


def _absolute(numbers: Array, unit: str, label: str, said: Columns) -> tuple[Array, tuple[Words, ...], bool]:
    """Give absolute pressures in SI, say how they were taken, and whether they are gauge."""
    offset = read(f"0 {unit}", Dimension.PRESSURE)
    scale = read(f"1 {unit}", Dimension.PRESSURE) - offset
    if offset:  # barg, ati, psig say it themselves
        gauge: bool | None = True
    else:
        gauge = said.is_gauge if said.is_gauge is not None else is_gauge(label)
    if gauge:
        sentence = _("Gauge pressures: {ambient} kPa added.", ambient=f"{shown(said.ambient, 'kPa'):.6g}")
        return numbers * scale + said.ambient, (sentence,), True
    if gauge is None:
        taken = _("The file does not say absolute or gauge; its pressures are taken as absolute.")
        return numbers * scale, (taken,), False
    return numbers * scale, (), False


def _refuse_negative(pressures: Array, table: NumberTable, level: int, *, is_gauge: bool) -> None:
    """Refuse absolute pressures that cannot be, at the first of them."""
    wrong = np.flatnonzero(pressures <= 0)
    if wrong.size:
        first = int(wrong[0])
        allowed = _("an absolute pressure must be more than 0 ({n} values are not)", n=wrong.size)
        repair: Words = peg_advice()
        if not is_gauge:
            repair = _('{advice}; if these are gauge pressures, write pressure = "gauge"', advice=repair)
        raise InputError([Problem("", f"{table.rows[first, level]:g}", allowed, repair, table.position(first, level))])


def peg_advice() -> Words:
    """How a table says the level of pressures that a sensor does not know."""
    return _(
        'as a sensor does not know its level, write peg.pressure = "1 bar" with the peg.angle at which it is known, or'
        " peg.exponent = 1.35"
    )
