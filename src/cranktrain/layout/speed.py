"""Speed of the main shaft, and the accelerations that come of it."""

from typing import ClassVar

import numpy as np

from cranktrain.language import N_
from cranktrain.layout.speed_curve import SpeedCurve
from cranktrain.linkage.forces import Drive
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import Extreme
from cranktrain.record import record


@record
class Speed:
    """Speed of the main shaft.

    Attributes
    ----------
    value : Array, shape (design, 1, 1)
        The declared mean, of whichever kind it is; constant over the cycle where there is no curve. [rad/s]
    curve : SpeedCurve or None
        How it varies over the cycle, in a second run.
    """

    needs: ClassVar[str] = N_("[shaft.main] speed")

    value: Array
    curve: SpeedCurve | None = None

    @property
    def mean(self) -> Array:
        """Mean over time, shape (design, 1, 1). [rad/s]"""
        return self.value if self.curve is None else self.curve.mean

    def drive(self, angle: Array) -> Drive:
        """How the crank turns at φ [rad], shape (n,) or (design, m, n): arrays that broadcast to (design, m, n)."""
        return Drive(self.value, np.zeros_like(self.value)) if self.curve is None else self.curve.drive(angle)


@record
class SteadySpeed:
    """Speed over the cycle that a machine runs at by itself: what a second run may be at.

    Attributes
    ----------
    speed, acceleration : Array, shape (design, n)
        NaN where there is none. [rad/s, rad/s²]
    mean : Array, shape (design,)
        Of the speed over time. [rad/s]
    reasons : tuple of str
        Why there is none.
    """

    speed: Array
    acceleration: Array
    mean: Array
    reasons: tuple[str, ...]


@record
class DrivenSpeed:
    """Speed over the cycle of a machine with its motor, arrays of shape (design,) unless said otherwise; NaN for none.

    Attributes
    ----------
    speed, acceleration : Array, shape (design, n)
        [rad/s, rad/s²]
    over_time, over_angle : Array
        Means of the speed. [rad/s]
    largest, smallest : Extreme
        At shown crank angles. [rad/s, rad]
    """

    speed: Array
    acceleration: Array
    over_time: Array
    over_angle: Array
    largest: Extreme
    smallest: Extreme


def rates(place: Coefficient, drive: Drive) -> tuple[Array, Array]:
    """Velocity q′ω and acceleration q″ω² + q′ε of what goes with the crank by q′ and q″."""
    return place.first * drive.speed, place.second * drive.speed**2 + place.first * drive.acceleration
