"""Mean and rms of a torque over time, on straight lines between its points."""

import numpy as np

from cranktrain.motion import Array


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
