"""The constant speed at which a motor's mean torque balances the machine's: the limit of very even running."""

import numpy as np

from cranktrain.motion import Array
from cranktrain.questions.drive.at_angles import ReducedAt
from cranktrain.questions.drive.running.gearing import overall_ratio, turning_inertia
from cranktrain.questions.drive.steady_turn import DriveInTurn
from cranktrain.questions.evenness.speed_law import Power

_N_SPEEDS = 400
_N_ANGLES = 96
"""At which the first guess of the speed looks: the cycle itself does not hang on them."""
_SLOWEST = 0.02
"""Of the motor's top speed: slower it counts as stalled."""
_FASTEST = 1e5
"""Of a motor without a top speed: no crank turns so fast. [rad/s]"""


def balanced_speed(turning: DriveInTurn, cycle: float) -> float | None:
    """Highest constant speed of the crank at which the mean acceleration falls through 0; None without one.

    Parameters
    ----------
    turning : DriveInTurn
    cycle : float
        [rad]

    Returns
    -------
    float or None
        [rad/s] Where the motor has neither a top speed nor a rated point, speeds are looked at upward until its torque
        falls below the load.
    """
    there = turning.at((np.arange(_N_ANGLES) + 0.5) * cycle / _N_ANGLES)
    speeds = np.linspace(_SLOWEST, 1.3, _N_SPEEDS) * _top(there)
    means = _mean_work(there, speeds)
    falls = np.flatnonzero((means[:-1] > 0) & (means[1:] <= 0))
    if falls.size == 0:
        return None
    low = falls[-1]
    return float(speeds[low] + (speeds[low + 1] - speeds[low]) * means[low] / (means[low] - means[low + 1]))


def _top(turning: DriveInTurn) -> float:
    """Speed of the crank above which the motor drives no more, or not against this load. [rad/s]"""
    highest = turning.motor.highest_speed(turning.design)
    if np.isfinite(highest):
        return highest / overall_ratio(turning.gearing)
    speeds: Array = np.geomspace(1.0, _FASTEST, 18)
    drives = np.flatnonzero(_mean_work(turning, speeds) > 0)
    return float(speeds[min(drives[-1] + 1, speeds.size - 1)]) if drives.size else 1.0


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
