"""Torque of several pistons: one piston's curve laid over itself at the firing angles, and gathered along the shaft."""

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics.harmonics import TURN, curve, delayed, harmonics

_WHOLE = 1e-9
"""A firing angle nearer than this to a step of the grid, in steps, is on it."""


def firing_angles(order: NDArray[np.intp], cycle: float) -> Array:
    """Firing angle of each cylinder that fires at equal intervals in a given order.

    Parameters
    ----------
    order : integer array, shape (cylinder,)
        The firing order: indices of the cylinders, the one that fires first in front.
    cycle : float
        2π or 4π. [rad]

    Returns
    -------
    Array, shape (cylinder,)
        In [0, cycle), by cylinder. [rad]

    Examples
    --------
    >>> np.degrees(firing_angles(np.array([0, 2, 3, 1]), 4 * np.pi))
    array([  0., 540., 180., 360.])
    """
    angles = np.empty(len(order))
    angles[order] = np.arange(len(order)) * cycle / len(order)
    return angles


def fired(torque: Array, firing_angle: Array, cycle: float = TURN) -> Array:
    """Each cylinder's torque over the shaft's cycle: its own curve, counted from its firing, laid at its firing angle.

    Parameters
    ----------
    torque : Array, shape (..., cylinder, n)
        Torque by the angle since the cylinder's own firing, in equal steps over a cycle, endpoint excluded; the
        cylinder's axis may have length 1, one curve for all. [N·m]
    firing_angle : Array, shape (..., cylinder)
        φ_i. [rad]
    cycle : float
        2π or 4π. [rad]

    Returns
    -------
    Array, shape (..., cylinder, n)
        M_i(φ) = M(φ − φ_i): firing later shifts a curve to the right. [N·m]

    Notes
    -----
    A shift by whole steps moves the numbers; another goes through the Fourier series, exact for what the grid can show.
    docs/theory/harmonics-and-orders, eq. (15.12).
    """
    n_points = torque.shape[-1]
    angle = np.asarray(firing_angle, dtype=float)
    steps = angle * (n_points / cycle)
    whole = np.rint(steps)
    rest = (steps - whole) * (cycle / n_points)
    spread = np.broadcast_to(torque, (*np.broadcast_shapes(torque.shape[:-1], angle.shape), n_points))
    if np.any(np.abs(steps - whole) > _WHOLE):
        later = delayed(harmonics(spread, cycle), rest)
        spread = curve(later, np.arange(n_points, dtype=float) * (cycle / n_points))
    place = np.mod(np.arange(n_points, dtype=float) - whole[..., np.newaxis], n_points).astype(np.intp)
    return np.take_along_axis(spread, np.broadcast_to(place, spread.shape), axis=-1)
