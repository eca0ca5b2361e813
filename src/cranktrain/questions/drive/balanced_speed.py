"""The constant speed at which a motor's mean torque balances the machine's: the limit of very even running."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.questions.drive.steady_turn import DriveInTurn
from cranktrain.questions.evenness.speed_law import Power
from cranktrain.questions.reduction.at_angles import ReducedAt
from cranktrain.transient.gearing import overall_ratio, turning_inertia

_N_SPEEDS, _AT_ONCE = 400, 40
_N_ANGLES = 96
"""At which the first guess of the speed looks: the cycle itself does not hang on them."""
_SLOWEST, _BEYOND = 0.02, 1.3
"""Of the motor's top speed: slower it counts as stalled, and beyond it a load may drive it."""
_FASTEST = 1e5
"""How many times as fast as it is first tried a motor without a top speed is looked at."""


class SpeedBalance(NamedTuple):
    """What drives a crank at constant speeds, less what holds it, on the mean over the cycle.

    Attributes
    ----------
    speeds : Array, shape (n,)
        Rising; from below the highest balance on, or all that were looked at where there is none. [rad/s]
    excess : Array, shape (n,)
        [N·m]
    """

    speeds: Array
    excess: Array

    @property
    def speed(self) -> float | None:
        """Highest speed at which the excess falls through 0; None without one. [rad/s]"""
        falls = np.flatnonzero((self.excess[:-1] > 0) & (self.excess[1:] <= 0))
        if falls.size == 0:
            return None
        (low, high), (over, under) = self.speeds[falls[-1] :][:2].tolist(), self.excess[falls[-1] :][:2].tolist()
        return low + (high - low) * over / (over - under)


def balance(turning: DriveInTurn, cycle: float) -> SpeedBalance:
    """Look for the constant speed at which the motor gives on the mean what the machine takes.

    Parameters
    ----------
    turning : DriveInTurn
    cycle : float
        [rad]

    Returns
    -------
    SpeedBalance
        Up to 1.3 times the motor's top speed; where it has none or still drives there, and neither speed is a balance,
        as far as the torque falls below the load.
    """
    there = turning.at((np.arange(_N_ANGLES) + 0.5) * cycle / _N_ANGLES)
    highest = turning.motor.highest_speed(0) / overall_ratio(turning.gearing)
    if np.isfinite(highest):
        found = _up_to(there, highest)
        if found.speed is not None or found.excess[-1] <= 0:
            return found
    return _up_to(there, _end(there, highest if np.isfinite(highest) else 1.0))


def _up_to(turning: DriveInTurn, top: float) -> SpeedBalance:
    """Look from the highest speed down, some speeds at once, as far as a balance."""
    speeds = np.linspace(_SLOWEST, _BEYOND, _N_SPEEDS) * top
    excess = np.empty(0)
    for first in range(_N_SPEEDS - _AT_ONCE, -1, -_AT_ONCE):
        excess = np.append(_mean_work(turning, speeds[first : first + _AT_ONCE]), excess)
        found = SpeedBalance(speeds[first:], excess)
        if found.speed is not None:
            return found
    return SpeedBalance(speeds, excess)


def _end(turning: DriveInTurn, first: float) -> float:
    """Speed from which on a motor without a top speed does not drive against this load. [rad/s]"""
    speeds: Array = np.geomspace(first, _FASTEST * first, 18)
    drives = np.flatnonzero(_mean_work(turning, speeds) > 0)
    return float(speeds[min(drives[-1] + 1, speeds.size - 1)]) if drives.size else first


def _mean_work(turning: DriveInTurn, speeds: Array) -> Array:
    """Mean over the cycle of what drives the crank at constant speeds, less what holds it, shape (n,). [N·m]"""
    here, n = turning.here, speeds.size
    powers = tuple(Power(np.tile(one.coefficient, n), one.exponent) for one in here.powers)
    inertia, slope, load, output = (np.tile(each, n) for each in (here.inertia, here.slope, here.load, here.output))
    along = ReducedAt(inertia, slope, load, powers, output)
    work = _work(turning._replace(here=along), np.repeat(speeds, here.load.size))
    return np.mean(work.reshape(n, -1), axis=1)


def _work(turning: DriveInTurn, speed: Array) -> Array:
    """What drives the crank at a constant speed, less what holds it: what inertia would take. [N·m]"""
    whole = turning.here.inertia + turning_inertia(turning.gearing)
    return whole * turning.passed(speed).acceleration + 0.5 * turning.here.slope * speed**2
