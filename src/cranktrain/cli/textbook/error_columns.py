"""Largest errors of displacement, velocity and acceleration as columns, with the crank angle of each."""

from collections.abc import Iterable, Iterator, Sequence

import numpy as np
from rich.text import Text

from cranktrain.cli.screen.columns import Column, column_tables
from cranktrain.grouping import grouped
from cranktrain.textbook.statements import Statement
from cranktrain.texts.largest_errors import LargestErrors
from cranktrain.texts.percents import percent
from cranktrain.wording import around_turn, figure

_SYMBOLS = ("Δx", "Δv", "Δj")


def error_columns(errors: Sequence[LargestErrors], labels: Sequence[str], width: int) -> Iterator[Text]:
    """Lay out errors, a row for each label."""
    rows = [tuple(text for one in each for text in _written(float(one.value), float(one.angle))) for each in errors]
    return _laid_out(rows, labels, width)


def stated_error_columns(errors: Iterable[Statement], width: int) -> Iterator[Text]:
    """Lay out errors, a row for each piston; those of which the same is written share one."""
    by_piston = grouped((one.of, _written(one.value, np.deg2rad(one.crank_angle))) for one in errors)
    rows = grouped((tuple(text for pair in each for text in pair), of) for of, each in by_piston.items())
    return _laid_out(list(rows), [", ".join(names) for names in rows.values()], width)


def _laid_out(rows: Sequence[tuple[str, ...]], labels: Sequence[str], width: int) -> Iterator[Text]:
    heads = [head for symbol in _SYMBOLS for head in ((symbol, "%"), ("φ", "deg"))]
    columns = [Column(*head, texts) for head, texts in zip(heads, zip(*rows, strict=True), strict=True)]
    return column_tables(columns, labels, width)


def _written(error: float, angle: float) -> tuple[str, str]:
    """An error and where it is [rad], if it is at a certain angle."""
    where = figure(float(around_turn(np.array(angle))), "deg") if np.isfinite(angle) else ""
    return percent(error), where
