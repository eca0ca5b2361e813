"""The grid of crank angles over a cycle, and the orders of what repeats with it."""

from typing import ClassVar

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics.harmonics import TURN
from cranktrain.record import record

_ROUNDING = 16 * np.spacing(2 * np.pi)
"""Sums of a few angles differ by less. [rad]"""

HIGHEST_ORDER = 24
"""Up to which orders torque and shaking are told, and balance shafts may turn."""


@record
class CrankAngle:
    """The grid of crank angles.

    Attributes
    ----------
    shown : Array, shape (n,)
        As tables and plots count it, from the machine's `crank_zero`. [rad]
    zero : Array, shape (design, 1, 1)
        φ where the shown angle is 0. [rad]
    cycle : float
        2π, or 4π for a four-stroke. [rad]
    """

    reads: ClassVar[tuple[str, ...]] = ("crank_zero", "angle", "[cylinder]")

    shown: Array
    zero: Array
    cycle: float

    @property
    def angle(self) -> Array:
        """φ of every grid point, shape (design, 1, n). [rad]"""
        return self.shown + self.zero

    @property
    def first_turn(self) -> Array:
        """φ of the grid's first turn, shape (design, 1, n/turns). [rad]"""
        return self.angle[..., : self.shown.size // round(self.cycle / (2 * np.pi))]

    def over_cycle(self, values: Array) -> Array:
        """Give what repeats with every turn, shape (..., n/turns), at all angles, shape (..., n)."""
        return np.concatenate([values] * (self.shown.size // values.shape[-1]), axis=-1)

    def counted(self, angle: Array, period: float = 2 * np.pi) -> Array:
        """Count angles φ, shape (design, ..., 1), as they are shown: from `crank_zero`, in [0, period). [rad]"""
        return within(angle - self.zero, period)


def within(angle: Array, period: float | Array, rounding: float = _ROUNDING) -> Array:
    """Bring angles into [0, period); what rounding put just before the period's end stands at its start. [rad]"""
    counted = np.mod(angle, period)
    return np.where(period - counted < rounding, 0.0, counted)


def orders(cycle: float) -> Array:
    """Orders of a cycle up to 24, for 18 cylinders in a turn: ½, 1, 1½, … of a four-stroke, whole ones of others."""
    turns = round(cycle / TURN)
    return np.arange(1, HIGHEST_ORDER * turns + 1) / turns


def order_labels(cycle: float) -> dict[str, tuple[str, ...]]:
    """Names of a cycle's orders."""
    return {"order": tuple(f"{order:g}" for order in orders(cycle).tolist())}
