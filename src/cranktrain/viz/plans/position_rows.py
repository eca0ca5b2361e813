"""Tables of positions as a sheet writes them: number, crank angle, motion of the output, of followed points."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.language import said as _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.layout.speed import SpeedCurve
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.one_line import short
from cranktrain.panels.figures import aligned
from cranktrain.panels.formulas import INDICES
from cranktrain.plans.acting_loads import ActingLoad
from cranktrain.plans.position_table import PositionColumn, output_columns, point_columns
from cranktrain.saying.scales import scale_for

_LETTERS = 46
"""Of the heads of all columns of a table of loads, of which each has its part."""

N_HEADS = 2
"""Rows of the head of these tables: symbols, units."""


def position_rows(
    machine: Machine,
    places: Sequence[PlacedMechanism],
    angles: Array,
    curve: SpeedCurve | None,
    more: Sequence[PositionColumn] = (),
) -> Iterator[tuple[str, ...]]:
    """Head and rows of a table: number, crank angle and motion of the output; of opposed pistons both, without x."""
    columns = [
        column._replace(symbol=f"{column.symbol}{_index(i) if len(places) > 1 else ''}")
        for i, place in enumerate(places)
        for column in output_columns(machine, place, angles, curve)
        if len(places) == 1 or column.symbol != "x"
    ]
    return rows_of(angles, [*columns, *more])


def point_tables(
    machine: Machine, place: PlacedMechanism, angles: Array, curve: SpeedCurve | None
) -> Iterator[tuple[str, list[tuple[str, ...]]]]:
    """Table of each point that is followed, by its name."""
    for name, columns in point_columns(machine, place, angles, curve):
        yield name, list(rows_of(angles, columns))


def load_rows(angles: Array, loads: Sequence[ActingLoad]) -> list[tuple[str, ...]]:
    """Table of loads: sizes of forces along their ways, of torques in the sense of rotation; less than 0 against it."""
    columns = [
        PositionColumn(
            short(load.name.replace("_", " "), _LETTERS // (len(loads) + 1)),
            "N*m" if load.is_torque else "N",
            load.counted,
        )
        for load in loads
    ]
    return list(rows_of(angles, columns))


def every(table: Sequence[tuple[str, ...]], step: int) -> list[tuple[str, ...]]:
    """Give the head of a table and every so manyth of its rows."""
    return [*table[:N_HEADS], *table[N_HEADS::step]]


def rows_of(angles: Array, columns: Sequence[PositionColumn]) -> Iterator[tuple[str, ...]]:
    """Two rows of a head, symbols and units, and rows: number, crank angle, columns as they are shown."""
    scales = [scale_for(one.unit, float(np.max(np.abs(one.values)))) for one in columns]
    yield (_("no."), "φ", *(one.symbol for one in columns))
    yield ("", "°", *(scale.label for scale in scales))
    cells = [aligned(scale.of(one.values)) for scale, one in zip(scales, columns, strict=True)]
    yield from (
        (f"{i}", f"{angle:g}", *row)
        for i, (angle, row) in enumerate(zip(angles, zip(*cells, strict=True), strict=True))
    )


def _index(i: int) -> str:
    """Number of one of several mechanisms as an index."""
    return str(i + 1).translate(INDICES)
