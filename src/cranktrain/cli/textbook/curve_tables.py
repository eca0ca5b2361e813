"""Curves that a text states, in tables by round angles of the crank, each beside what is exact."""

from collections.abc import Iterable

import numpy as np
from rich.console import Console

from cranktrain.cli.screen.columns import Column, section_of_columns
from cranktrain.motion import Array
from cranktrain.textbook.statements import StatementCurve
from cranktrain.wording import figure

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
