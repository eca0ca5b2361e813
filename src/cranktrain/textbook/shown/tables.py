"""What a text states, in columns: curves at round angles of the crank beside what is exact, and largest errors."""

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from cranktrain.grouping import grouped
from cranktrain.language import N_, Words, _
from cranktrain.motion import Array
from cranktrain.saying.percents import percent
from cranktrain.saying.sections import Column, Grid, Part, Rows, ShownSection, Value
from cranktrain.saying.wording import around_turn, number
from cranktrain.textbook.statements import ERRORS, Statement, StatementCurve

_STEP = 30.0
"""Of the crank angle. [deg]"""
_TURN = 360.0
ROUND_ANGLES = np.arange(0.0, _TURN, _STEP)
"""Of a turn. [deg]"""

_SHOWN = {"m": "mm", "m/rad": "mm/rad", "m/rad^2": "mm/rad^2", "N": "N"}
"""Units of curves as shown."""

EXACT = N_("exact")
"""Head of what stands beside a curve."""


def curve_section(
    heading: Words,
    crank_angle: Array,
    curves: Iterable[tuple[Words, StatementCurve]],
    *,
    exact: str = EXACT,
    step: float = _STEP,
) -> ShownSection:
    """Give curves at round angles of a turn or a cycle, whose end is its beginning.

    Parameters
    ----------
    heading : Words
    crank_angle : Array, shape (crank_angle,)
        Of the curves. [deg]
    curves : iterable of (Words, StatementCurve)
        Each with the head of its column.
    exact : str
        Head of what stands beside each; translated here.
    step : float
        Between the angles. [deg]
    """
    open_end = crank_angle[:-1] if crank_angle[-1] % _TURN == 0.0 else crank_angle
    rows = np.flatnonzero(open_end % step == 0.0)
    columns = [
        Column(name, values[rows].tolist(), _SHOWN[curve.unit])
        for head, curve in curves
        for name, values in ((head, curve.values), (_(exact), curve.exact))
        if values is not None
    ]
    return ShownSection(heading, (Grid(columns, degrees(crank_angle[rows])),))


def degrees(angles: Array) -> list[str]:
    """Label rows with angles. [deg]"""
    return [f"{angle:g}°" for angle in angles.tolist()]


def error_grid(rows: Mapping[Words, Sequence[Statement]]) -> Grid:
    """Put the three errors of each label into columns, each with where it is, if that is at a certain angle."""
    columns: list[Column] = []
    for symbol, each in zip(ERRORS, zip(*rows.values(), strict=True), strict=True):
        columns.append(Column(symbol, [one.value for one in each], "%", "percent"))
        columns.append(Column("φ", [_angle(one) for one in each], "deg"))
    return Grid(columns, list(rows))


def stated_error_grid(errors: Iterable[Statement]) -> Grid:
    """Put errors into columns, a row for each piston; those of which the same is written share one."""
    by_piston = grouped((one.of, one) for one in errors)
    alike = grouped((tuple(map(_written, each)), of) for of, each in by_piston.items())
    return error_grid({", ".join(names): by_piston[names[0]] for names in alike.values()})


def _written(one: Statement) -> tuple[str, Value]:
    """What is written of an error, by which it is like another."""
    angle = _angle(one)
    return percent(one.value), number(angle, "deg") if isinstance(angle, float) else angle


def _angle(one: Statement) -> Value:
    return float(around_turn(np.deg2rad(np.array(one.crank_angle)))) if np.isfinite(one.crank_angle) else ""


def listed(sentences: Sequence[Words]) -> Sequence[Part]:
    """Give one sentence as a paragraph, several with dashes."""
    return sentences if len(sentences) == 1 else (Rows([("-", one) for one in sentences]),)
