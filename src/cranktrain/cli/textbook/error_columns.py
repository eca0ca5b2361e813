"""Largest errors of displacement, velocity and acceleration as columns, with the crank angle of each."""

from collections.abc import Iterable, Iterator, Mapping, Sequence

import numpy as np
from rich.text import Text

from cranktrain.cli.screen.columns import Column, column_tables
from cranktrain.grouping import grouped
from cranktrain.textbook.error_statements import ERRORS
from cranktrain.textbook.statements import Statement
from cranktrain.texts.percents import percent
from cranktrain.wording import around_turn, figure


def error_columns(rows: Mapping[str, Sequence[Statement]], width: int) -> Iterator[Text]:
    """Lay out errors, a row for each label."""
    return _laid_out([_written(each) for each in rows.values()], list(rows), width)


def stated_error_columns(errors: Iterable[Statement], width: int) -> Iterator[Text]:
    """Lay out errors, a row for each piston; those of which the same is written share one."""
    by_piston = grouped((one.of, one) for one in errors)
    rows = grouped((_written(each), of) for of, each in by_piston.items())
    return _laid_out(list(rows), [", ".join(names) for names in rows.values()], width)


def _laid_out(rows: Sequence[tuple[str, ...]], labels: Sequence[str], width: int) -> Iterator[Text]:
    heads = [head for symbol in ERRORS for head in ((symbol, "%"), ("φ", "deg"))]
    columns = [Column(*head, texts) for head, texts in zip(heads, zip(*rows, strict=True), strict=True)]
    return column_tables(columns, labels, width)


def _written(errors: Sequence[Statement]) -> tuple[str, ...]:
    """Errors, and where each is, if it is at a certain angle."""
    return tuple(text for one in errors for text in (percent(one.value), _angle(one.crank_angle)))


def _angle(degrees: float) -> str:
    return figure(float(around_turn(np.deg2rad(np.array(degrees)))), "deg") if np.isfinite(degrees) else ""
