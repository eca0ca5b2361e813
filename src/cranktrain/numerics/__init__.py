"""Roots and extremes of many curves at once, to rounding: curves are kernels, so nothing is read off a grid."""

from cranktrain.numerics.extremes import Extremes, extremes, largest, smallest, turning_points
from cranktrain.numerics.pieces import Curves, Peak, largest_between
from cranktrain.numerics.roots import Curve, bracketed_roots, near_roots
from cranktrain.numerics.series import (
    DERIVATIVES_LIMIT,
    around_zero,
    derivatives_residual,
    has_ended,
    slower_over_faster,
    spectral_derivative,
    turn_grid,
    unwrapped,
)
from cranktrain.numerics.subintervals import (
    Subintervals,
    integral_motion,
    integral_to,
    points_together,
    shows,
    subintervals,
)
from cranktrain.numerics.tops import Extreme
from cranktrain.numerics.windows import in_slots, in_windows

__all__ = [
    "DERIVATIVES_LIMIT",
    "Curve",
    "Curves",
    "Extreme",
    "Extremes",
    "Peak",
    "Subintervals",
    "around_zero",
    "bracketed_roots",
    "derivatives_residual",
    "extremes",
    "has_ended",
    "in_slots",
    "in_windows",
    "integral_motion",
    "integral_to",
    "largest",
    "largest_between",
    "near_roots",
    "points_together",
    "shows",
    "slower_over_faster",
    "smallest",
    "spectral_derivative",
    "subintervals",
    "turn_grid",
    "turning_points",
    "unwrapped",
]
