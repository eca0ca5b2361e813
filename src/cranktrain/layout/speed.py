"""Speed of the main shaft: one, or as it varies over the cycle, found by the machine's own evenness or given."""

from typing import ClassVar, Literal, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from cranktrain.language import N_, Words, _
from cranktrain.linkage.forces import Drive
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import Extreme
from cranktrain.numerics.periodic import PeriodicCurve, hermite_curve
from cranktrain.record import record
from cranktrain.saying.wording import number


@record
class SpeedCurve:
    """How the main shaft turns over the cycle: what a second run is at.

    Attributes
    ----------
    square : PeriodicCurve, shape (design, n)
        ω² from the first point of the grid. [rad²/s²]
    zero : Array, shape (design, 1, 1)
        φ of that point. [rad]
    mean : Array, shape (design, 1, 1)
        Mean of ω over time. [rad/s]
    is_steady_running : bool
        Whether it is what the machine's torques, load and flywheel make of it, and not given.
    moment : Array, shape (design, 1, 1), or None
        Of one moment, which may be at any crank angle, the angular acceleration; the speed is then one. [rad/s²]
    corners : Array, shape (design, corner), or None
        φ at which the angular acceleration jumps, over the cycle; NaN for none. [rad]
    """

    reads: ClassVar[tuple[str, ...]] = ("[shaft.main]",)

    square: PeriodicCurve
    zero: Array
    mean: Array
    is_steady_running: bool
    moment: Array | None = None
    corners: Array | None = None

    def drive(self, angle: Array) -> Drive:
        """How the crank turns at φ [rad], shape (n,) or (design, m, n): arrays of shape (design, m or 1, n)."""
        turning = self.along_angle(angle)
        if self.moment is None:
            return turning
        return turning._replace(acceleration=turning.acceleration + self.moment)

    def along_angle(self, angle: Array) -> Drive:
        """The same with what of the acceleration is the speed's own change by the crank angle: of one moment, none.

        Notes
        -----
        ε = ω dω/dφ = ½ (ω²)′. docs/theory/evenness, eq. (17.19).
        """
        shown = angle - self.zero
        square = self.square.motion(shown.reshape(len(shown), -1))
        return Drive(np.sqrt(square.value).reshape(shown.shape), square.first.reshape(shown.shape) / 2)

    def condition(self, design: int) -> Words:
        """At which speed everything is."""
        speeds = np.sqrt(self.square.samples[design])
        if self.moment is not None:
            said = _(
                "All of this is of one moment, whatever the crank angle then, at {speed} and an angular acceleration of"
                " {acceleration}. What only steady running has is left out."
            )
            acceleration = number(float(self.moment[design, 0, 0]), "rad/s^2")
            return said.format(speed=number(float(speeds[0]), "rpm"), acceleration=acceleration)
        if self.corners is not None:
            said = _("All of this is at the speed that the wanted motion takes, {least} to {most}, {mean} over time.")
            return said.format(**_speeds(speeds, float(self.mean[design, 0, 0])))
        said = (
            _("All of this is at the speed of steady running, {least} to {most} over the cycle, {mean} over time.")
            if self.is_steady_running
            else _("All of this is at the speed that was given, {least} to {most} over the cycle, {mean} over time.")
        )
        return said.format(**_speeds(speeds, float(self.mean[design, 0, 0])))


SpeedWanted: TypeAlias = Literal["constant", "running"] | ArrayLike | SpeedCurve
"""Constant; that of the steady running which the machine's file makes; one's own on the grid; or a curve there is."""


def _speeds(speeds: Array, mean: float) -> dict[str, Words]:
    """Write the least speed, the greatest and their mean over time."""
    found = {"least": float(np.min(speeds)), "most": float(np.max(speeds)), "mean": mean}
    return {name: number(speed, "rpm") for name, speed in found.items()}


def speed_curve(
    speed: Array, acceleration: Array, cycle: float, *, zero: Array, mean: Array, is_steady_running: bool
) -> SpeedCurve:
    """Curve through speeds and accelerations on the grid: cubics of ω², so that both meet everywhere.

    Parameters
    ----------
    speed, acceleration : Array, shape (design, n)
        ω and ε in equal steps over the cycle. [rad/s, rad/s²]
    cycle : float
        [rad]
    zero : Array, shape (design, 1, 1)
        φ of the first point. [rad]
    mean : Array, shape (design,)
        Mean of the speed over time. [rad/s]
    is_steady_running : bool

    Returns
    -------
    SpeedCurve
    """
    square = hermite_curve(speed**2, 2 * acceleration, cycle)
    return SpeedCurve(square, zero, mean[:, np.newaxis, np.newaxis], is_steady_running)


def speed_at_moment(speed: Array, acceleration: Array, cycle: float, *, zero: Array) -> SpeedCurve:
    """Give one moment's speed and angular acceleration, shape (design,), at all crank angles. [rad/s, rad/s²]"""
    square = hermite_curve(speed[:, np.newaxis] ** 2, np.zeros((len(speed), 1)), cycle)
    mean, moment = (part[:, np.newaxis, np.newaxis] for part in (speed, acceleration))
    return SpeedCurve(square, zero, mean, is_steady_running=False, moment=moment)


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
    reasons: tuple[Words, ...]


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
