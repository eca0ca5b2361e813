"""Roots and extremes of many curves at once, to rounding: curves are kernels, so nothing is read off a grid."""

from cranktrain.numerics.extremes import Extremes, extremes, largest, smallest, turning_points
from cranktrain.numerics.roots import Curve, bracketed_roots, near_roots
from cranktrain.numerics.series import (
    DERIVATIVES_LIMIT,
    derivatives_residual,
    has_ended,
    spectral_derivative,
    turn_grid,
    unwrapped,
)
from cranktrain.numerics.tops import Extreme

__all__ = [
    "DERIVATIVES_LIMIT",
    "Curve",
    "Extreme",
    "Extremes",
    "bracketed_roots",
    "derivatives_residual",
    "extremes",
    "has_ended",
    "largest",
    "near_roots",
    "smallest",
    "spectral_derivative",
    "turn_grid",
    "turning_points",
    "unwrapped",
]
