"""Largest errors of displacement, velocity and acceleration as columns, with the crank angle of each."""

from collections.abc import Iterator, Sequence

from rich.text import Text

from cranktrain.cli.screen.columns import Column, column_tables
from cranktrain.motion import Array
from cranktrain.texts.largest_errors import LargestErrors
from cranktrain.texts.percents import percent
from cranktrain.wording import around_turn, figure

_SYMBOLS = ("Δx", "Δv", "Δj")


def error_columns(errors: Sequence[LargestErrors], labels: Sequence[str], width: int) -> Iterator[Text]:
    """Lay out errors, a row for each label."""
    rows = [[text for one in each for text in _written(one.value, one.angle)] for each in errors]
    heads = [head for symbol in _SYMBOLS for head in ((symbol, "%"), ("φ", "deg"))]
    columns = [Column(*head, texts) for head, texts in zip(heads, zip(*rows, strict=True), strict=True)]
    yield from column_tables(columns, labels, width)


def _written(error: Array, angle: Array) -> tuple[str, str]:
    """An error and where it is."""
    return percent(float(error)), figure(float(around_turn(angle)), "deg")
