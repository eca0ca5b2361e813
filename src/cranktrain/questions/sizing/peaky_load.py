"""Flywheel and slip together for a load that comes in peaks, with a motor whose speed falls in a line."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics.roots import bracketed_roots


class PeakyLoad(NamedTuple):
    """Torques of a peak and between peaks, and how long each lasts; any shapes that broadcast. [N·m, s]"""

    peak_torque: Array
    peak_time: Array
    low_torque: Array
    low_time: Array

    def mean(self) -> Array:
        """Mean torque over the period. [N·m]"""
        work = self.peak_torque * self.peak_time + self.low_torque * self.low_time
        return work / (self.peak_time + self.low_time)


class SlipLine(NamedTuple):
    """Motor whose torque rises with the slip in a line: rated torque [N·m], rated slip, synchronous speed [rad/s]."""

    rated_torque: Array
    rated_slip: Array
    synchronous_speed: Array


class PeriodicTorques(NamedTuple):
    """Motor torque of the steady period: at the end of a peak, before the next one, and its rms. [N·m]"""

    high: Array
    low: Array
    rms: Array


def slip_time_constant(inertia: Array, line: SlipLine) -> Array:
    """Time in which a motor with a flywheel comes nearer to a constant load by a factor of e. [s]

    docs/theory/drive, eq. (25.35).
    """
    return inertia * line.synchronous_speed * line.rated_slip / line.rated_torque


def recovered_inertia(load: PeakyLoad, line: SlipLine, allowed: Array) -> Array:
    """Inertia with which one peak, come after a full recovery, stays within an allowed motor torque.

    Parameters
    ----------
    load : PeakyLoad
    line : SlipLine, broadcastable
    allowed : Array, broadcastable
        Motor torque. [N·m]

    Returns
    -------
    Array
        At the motor's shaft, its own included; 0 where the peak is within. [kg·m²]

    Notes
    -----
    docs/theory/drive, eq. (25.36). Too little where the motor does not recover between peaks.
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        constant = load.peak_time / np.log((load.peak_torque - load.low_torque) / (load.peak_torque - allowed))
    constant = np.where(allowed >= load.peak_torque, 0.0, np.where(allowed > load.low_torque, constant, np.nan))
    return constant * line.rated_torque / (line.synchronous_speed * line.rated_slip)


def periodic_torques(load: PeakyLoad, time_constant: Array) -> PeriodicTorques:
    """Motor torque where every period is as the one before.

    Parameters
    ----------
    load : PeakyLoad
    time_constant : Array, broadcastable
        More than 0. [s]

    Notes
    -----
    docs/theory/drive, eqs. (25.37) and (25.38).
    """
    (above, peak_time, below, low_time), constant = load, time_constant
    grown, fallen = -np.expm1(-peak_time / constant), -np.expm1(-low_time / constant)
    whole = -np.expm1(-(peak_time + low_time) / constant)
    high = below + (above - below) * grown / whole
    low = above - (above - below) * fallen / whole
    rise, fall = above - low, high - below
    peak = above * above * peak_time - constant * rise * grown * (2 * above - 0.5 * rise * (2 - grown))
    rest = below * below * low_time + constant * fall * fallen * (2 * below + 0.5 * fall * (2 - fallen))
    return PeriodicTorques(high, low, np.sqrt((peak + rest) / (peak_time + low_time)))


def periodic_inertia(load: PeakyLoad, line: SlipLine, allowed: Array) -> Array:
    """Inertia with which the motor torque stays within what is allowed, period after period.

    Parameters
    ----------
    load : PeakyLoad
    line : SlipLine, broadcastable
    allowed : Array, broadcastable
        Motor torque. [N·m]

    Returns
    -------
    Array
        At the motor's shaft, its own included; 0 where the peak is within, NaN where no flywheel is large enough, as
        the mean is above. [kg·m²]

    Notes
    -----
    docs/theory/drive, eq. (25.37). The root lies above that of a full recovery, and below the constant with which
    the whole swing of a straight line would be above the mean.

    Examples
    --------
    >>> press, motor = PeakyLoad(260.0, 0.6, 25.0, 3.4), SlipLine(70.0, 0.08, 157.07963267948966)
    >>> round(float(periodic_inertia(press, motor, 120.0)), 6), round(float(recovered_inertia(press, motor, 120.0)), 6)
    (6.781139, 6.452936)
    """
    per_second = line.synchronous_speed * line.rated_slip / line.rated_torque
    least = recovered_inertia(load, line, allowed) * per_second
    above, peak_time, below, low_time = load
    over = np.where(allowed > load.mean(), allowed - load.mean(), np.nan)
    most = (above - below) * peak_time * low_time / ((peak_time + low_time) * over)

    def excess(constant: Array) -> Array:
        return periodic_torques(load, constant).high - allowed

    # A little wider: where the motor recovers fully the root is the lower end itself.
    found = bracketed_roots(excess, np.asarray(0.999 * least), np.asarray(1.001 * most))
    return np.where(np.greater_equal(allowed, above), 0.0, found / per_second)
