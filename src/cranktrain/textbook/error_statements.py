"""Largest errors of a form of motion as statements: of displacement, velocity and acceleration."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.textbook.statements import Statement, Verdict
from cranktrain.texts.largest_errors import LargestErrors

ERRORS = ("Δx", "Δv", "Δj")
"""Of displacement in parts of the stroke, of velocity and acceleration in parts of the exact peaks."""
_ROUNDING = 1e-12
LARGEST = "largest"
"""Where an error is given: where it is largest over the turn."""


class MotionForm(NamedTuple):
    """Whose form it is, the numbers of its three equations or of one for all, what it is in words, where it is off."""

    source: str
    equations: Sequence[str]
    name: str
    at: str = LARGEST


def error_statements(
    form: MotionForm, of: str, errors: Sequence[tuple[float, float]], verdict: Verdict
) -> Iterator[Statement]:
    """Give the three errors [1], each with its angle [deg]; what is but rounding is at none."""
    for order, (symbol, (error, angle)) in enumerate(zip(ERRORS, errors, strict=True)):
        equation = form.equations[min(order, len(form.equations) - 1)]
        where = angle % 360.0 if abs(error) > _ROUNDING else np.nan
        yield Statement(form.source, equation, symbol, form.name, of, form.at, error, "1", verdict, 0.0, where)


def with_degrees(errors: LargestErrors) -> list[tuple[float, float]]:
    """Give errors with their angles. [1, deg]"""
    return [(float(error.value), float(np.rad2deg(error.angle))) for error in errors]
