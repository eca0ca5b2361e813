"""Columns of numbers as texts, in the units and the language of whoever reads them."""

from dataclasses import replace

import numpy as np

from cranktrain.saying.amounts import figures
from cranktrain.saying.sections import Column, Decimals, How
from cranktrain.saying.wording import ABSENT, UnitOf, figure, seen, signless

_BY_ANGLE = "/rad"
"""Derivatives by an angle are shown in the unit of what they are of."""


def written_column(column: Column) -> Column:
    """Write the numbers of a column: its head, its unit and its values are texts then.

    Examples
    --------
    >>> from cranktrain.saying.sections import Column
    >>> made = written_column(Column("S", (0.18, ""), "mm"))
    >>> made.head, made.unit, made.values
    ('S', 'mm', ('180.00', ''))
    """
    if column.how == "amounts":
        texts, unit = figures(np.asarray(column.values, dtype=float), column.unit)
    else:
        texts = tuple(
            _text(value, column.unit, column.how) if isinstance(value, float) else str(value) for value in column.values
        )
        is_in_si = not isinstance(column.how, Decimals) and any(isinstance(value, float) for value in column.values)
        unit = _label(column.unit) if is_in_si else column.unit
    return replace(column, head=str(column.head), unit=unit, values=texts)


def _text(value: float, unit: str, how: How) -> str:
    """Write a number."""
    if not isinstance(how, Decimals):
        from cranktrain.saying.percents import percent  # an answer needs none

        return percent(value) if how == "percent" else figure(value, unit.partition(_BY_ANGLE)[0])
    if not np.isfinite(value):
        return ABSENT
    return signless(f"{value:.{seen(abs(value), how.n) if abs(value) > how.least else how.n}f}")


def _label(unit: str) -> str:
    """Unit in which numbers are shown, with what they are divided by; nothing of a plain number."""
    of, by, angle = unit.partition(_BY_ANGLE)
    return f"{UnitOf(of)}{by}{angle}"
