"""How hard a torque over time is on a motor: its mean and rms, and the heat of one body over periods of duty."""

import numpy as np

from cranktrain.motion import Array

CYCLIC_DURATIONS = (0.15, 0.25, 0.4, 0.6)
"""Usual shares of a period under load, duties S3 and S6; recalled of IEC 60034-1, which was not read."""
DUTY_PERIOD = 600.0
"""Their usual period. [s]"""
SHORT_TIMES = (600.0, 1800.0, 3600.0, 5400.0)
"""Usual times under load, duty S2; recalled likewise. [s]"""


def mean_torque(torque: Array, time: Array) -> Array:
    """Mean over time. [N·m]

    Parameters
    ----------
    torque : Array, shape (..., n)
        [N·m]
    time : Array, broadcastable to (..., n)
        Rising; twice the same where the torque jumps. [s]

    Returns
    -------
    Array, shape (...)
    """
    width = np.diff(time)
    area = np.sum(0.5 * (torque[..., 1:] + torque[..., :-1]) * width, axis=-1)
    return area / np.sum(width, axis=-1)


def rms_torque(torque: Array, time: Array, cooling: Array | float = 1.0) -> Array:
    """Torque that would heat as much if it were constant.

    Parameters
    ----------
    torque : Array, shape (..., n)
        Over the whole cycle; not over the crank angle, as a slow part of the turn lasts longer. [N·m]
    time : Array, broadcastable to (..., n)
        Rising; twice the same where the torque jumps. [s]
    cooling : Array, broadcastable to (..., n - 1)
        What each piece counts for as cooling: 1 at speed, less in a pause of a motor that ventilates itself.

    Returns
    -------
    Array, shape (...)
        [N·m]

    Notes
    -----
    docs/theory/drive, eq. (25.29). It holds while the torque is in proportion to the current: to about breakdown.

    Examples
    --------
    >>> float(rms_torque(np.array([0.0, 30.0, 30.0, 0.0, 0.0]), np.array([0.0, 1.0, 3.0, 3.0, 4.0])))
    22.9128784747792
    """
    width, begin, end = np.diff(time), torque[..., :-1], torque[..., 1:]
    heat = np.sum((begin * begin + begin * end + end * end) / 3 * width, axis=-1)
    return np.sqrt(heat / np.sum(cooling * width, axis=-1))


def intermittent_factor(
    on: Array, off: Array, time_constant: Array, *, cooling: Array | float = 1.0, constant_share: Array | float = 0.0
) -> Array:
    """Duty S3: by what factor the torque may be above the rated one, with pauses in which the motor stands.

    Parameters
    ----------
    on, off : Array
        Times under load and at rest. [s]
    time_constant : Array
        Of the motor's heat, at speed. [s]
    cooling : Array, optional
        How well it cools at rest, in parts of how well at speed; 0.25 to 0.5 where it ventilates itself.
    constant_share : Array, optional
        Losses that do not hang on the load, in parts of all at rated load.

    Returns
    -------
    Array, of the broadcast shape

    Notes
    -----
    The largest temperature over the period is that of steady rated load. docs/theory/drive, eq. (25.30).

    Examples
    --------
    >>> round(float(intermittent_factor(240.0, 360.0, 1800.0, cooling=0.5)), 8)
    1.2911991
    """
    return _factor(on / time_constant, off * cooling / time_constant, 0.0, constant_share)


def no_load_factor(on: Array, off: Array, time_constant: Array, *, constant_share: Array | float = 0.0) -> Array:
    """Duty S6: the same where the motor runs on without load.

    It cools as well as under load, and its constant losses go on. docs/theory/drive, eq. (25.30).
    """
    return _factor(on / time_constant, off / time_constant, constant_share, constant_share)


def short_time_factor(on: Array, time_constant: Array, *, constant_share: Array | float = 0.0) -> Array:
    """Duty S2: the same for one time under load from cold. docs/theory/drive, eq. (25.31)."""
    return np.sqrt((-1 / np.expm1(-on / time_constant) - constant_share) / (1 - constant_share))


def _factor(heating: Array, resting: Array, rest: Array | float, constant_share: Array | float) -> Array:
    """Factor for times under load and at rest in time constants, and the temperature to which the rest leads."""
    grown, fallen = -np.expm1(-heating), -np.expm1(-resting)
    losses = (-np.expm1(-heating - resting) - rest * np.exp(-heating) * fallen) / grown
    return np.sqrt((losses - constant_share) / (1 - constant_share))
