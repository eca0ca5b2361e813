"""What a text states, in tables: curves by round angles of the crank beside what is exact, and largest errors."""

from collections.abc import Iterable, Iterator, Mapping, Sequence

import numpy as np
from rich.console import Console
from rich.text import Text

from cranktrain.cli.screen.columns import Column, column_tables, section_of_columns
from cranktrain.grouping import grouped
from cranktrain.motion import Array
from cranktrain.saying.wording import around_turn, figure
from cranktrain.textbook.statements import ERRORS, Statement, StatementCurve
from cranktrain.texts.percents import percent

_STEP = 30.0
"""Of the crank angle. [deg]"""
_TURN = 360.0
ROUND_ANGLES = np.arange(0.0, _TURN, _STEP)
"""Of a turn. [deg]"""

_SHOWN = {"m": "mm", "m/rad": "mm/rad", "m/rad^2": "mm/rad^2", "N": "N"}
"""Units of curves as shown; lengths have the decimals of mm, by whatever angle they are divided."""


def show_curves(
    console: Console,
    heading: str,
    crank_angle: Array,
    curves: Iterable[tuple[str, StatementCurve]],
    exact: str,
    step: float = _STEP,
) -> None:
    """Show curves at round angles of a turn or a cycle, whose end is its beginning.

    Parameters
    ----------
    console : Console
    heading : str
    crank_angle : Array, shape (crank_angle,)
        Of the curves. [deg]
    curves : iterable of (str, StatementCurve)
        Each with the head of its column.
    exact : str
        Head of what stands beside each.
    step : float
        Between the angles. [deg]
    """
    open_end = crank_angle[:-1] if crank_angle[-1] % _TURN == 0.0 else crank_angle
    rows = np.flatnonzero(open_end % step == 0.0)
    columns = [
        Column(name, _SHOWN[curve.unit], _written(values[rows], curve.unit))
        for head, curve in curves
        for name, values in ((head, curve.values), (exact, curve.exact))
        if values is not None
    ]
    section_of_columns(console, heading, columns, [f"{angle:g}°" for angle in crank_angle[rows]])


def _written(values: Array, unit: str) -> tuple[str, ...]:
    return tuple(figure(value, _SHOWN[unit[:1]]) for value in values.tolist())


def error_columns(rows: Mapping[str, Sequence[Statement]], width: int) -> Iterator[Text]:
    """Lay out errors, a row for each label."""
    return _laid_out([_errors_written(each) for each in rows.values()], list(rows), width)


def stated_error_columns(errors: Iterable[Statement], width: int) -> Iterator[Text]:
    """Lay out errors, a row for each piston; those of which the same is written share one."""
    by_piston = grouped((one.of, one) for one in errors)
    rows = grouped((_errors_written(each), of) for of, each in by_piston.items())
    return _laid_out(list(rows), [", ".join(names) for names in rows.values()], width)


def _laid_out(rows: Sequence[tuple[str, ...]], labels: Sequence[str], width: int) -> Iterator[Text]:
    heads = [head for symbol in ERRORS for head in ((symbol, "%"), ("φ", "deg"))]
    columns = [Column(*head, texts) for head, texts in zip(heads, zip(*rows, strict=True), strict=True)]
    return column_tables(columns, labels, width)


def _errors_written(errors: Sequence[Statement]) -> tuple[str, ...]:
    """Errors, and where each is, if it is at a certain angle."""
    return tuple(text for one in errors for text in (percent(one.value), _angle(one.crank_angle)))


def _angle(degrees: float) -> str:
    return figure(float(around_turn(np.deg2rad(np.array(degrees)))), "deg") if np.isfinite(degrees) else ""
