"""The steam engine's exact root, its forms from the crank-side dead centre, and Z: of cranks and eccentrics."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.language import N_, _
from cranktrain.motion import Array, Coefficient
from cranktrain.textbook.alike import AlikePistons
from cranktrain.textbook.statements import (
    LARGEST,
    MotionForm,
    Statement,
    StatementCurve,
    Verdict,
    error_statements,
    with_degrees,
)
from cranktrain.texts.largest_errors import from_bottom, from_top, largest_errors
from cranktrain.texts.ranges import EXACT_ROOT, RANGES
from cranktrain.texts.steam_engine import (
    exact_largest_difference,
    exact_root,
    largest_difference,
    two_harmonics_from_crank_side,
)

LARGEST_FROM_CRANK_SIDE = "largest, from the crank side"
"""Where an error is given: where it is largest over the turn, the angle counted from the crank-side dead centre."""

_SOURCE = EXACT_ROOT.source
_TWO_HARMONICS = next(one for one in RANGES if one.method == "two_harmonics")
_CURVES = (("S", "m"), ("c/ω", "m/rad"), ("j/ω²", "m/rad^2"))
_MINUS = N_("two harmonics from the crank-side dead centre")


def plain_crank_statements(pistons: Sequence[AlikePistons]) -> Iterator[Statement]:
    """Give all of them."""
    for find in (root_statements, crank_side_statements, difference_statements):
        for one in pistons:
            yield from find(one)


def root_statements(one: AlikePistons) -> Iterator[Statement]:
    """Give what the exact root is off: of a central mechanism rounding alone, at no certain angle."""
    radius, rod, offset = one.plain
    errors = largest_errors(lambda angle: exact_root(angle, radius, radius / rod), from_top(one.plain))
    is_central = float(offset) == 0.0
    verdict: Verdict = "right" if is_central else "out of range"
    found = [(error, np.nan if is_central else angle) for error, angle in with_degrees(errors)]
    yield from error_statements(
        MotionForm(_SOURCE, EXACT_ROOT.equations[:1], _(EXACT_ROOT.name)), one.of, found, verdict
    )


def crank_side_statements(one: AlikePistons) -> Iterator[Statement]:
    """Give the largest errors of (333), (336), (337) with the minus sign."""
    errors = largest_errors(lambda angle: _minus(angle, one), from_bottom(one.plain))
    form = MotionForm(_SOURCE, _TWO_HARMONICS.equations, _(_MINUS), LARGEST_FROM_CRANK_SIDE)
    yield from error_statements(form, one.of, with_degrees(errors), one.verdict(_TWO_HARMONICS))


def crank_side_curves(one: AlikePistons, angle: Array) -> Iterator[StatementCurve]:
    """Give displacement, velocity and acceleration away from the shaft, from the crank-side dead centre."""
    curves = zip(_CURVES, _TWO_HARMONICS.equations, _minus(angle, one), from_bottom(one.plain)(angle), strict=True)
    for (symbol, unit), equation, own, exact in curves:
        yield StatementCurve(
            _SOURCE, equation, symbol, _(_MINUS), one.of, unit, one.verdict(_TWO_HARMONICS), own, exact
        )


def difference_statements(one: AlikePistons) -> Iterator[Statement]:
    """Give Z, beside the largest difference of the exact displacement and (334); of an offset mechanism alone."""
    source = float(largest_difference(one.plain.crank_radius, one.plain.crank_radius / one.plain.rod_length))
    exact = float(exact_largest_difference(one.plain.crank_radius, one.plain.crank_radius / one.plain.rod_length))
    yield Statement(
        _SOURCE,
        "(335)",
        "Z",
        _("largest difference of (333) and (334)"),
        one.of,
        LARGEST,
        source,
        "m",
        one.verdict(_TWO_HARMONICS),
        exact if one.offset == 0.0 else np.nan,
        90.0,
    )


def _minus(angle: Array, one: AlikePistons) -> Coefficient:
    """The forms from the crank-side dead centre."""
    radius, rod, _offset = one.plain
    return two_harmonics_from_crank_side(angle, radius, radius / rod)
