"""How long a start lasts, what it heats the rotor by, and how often it may be."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics.subintervals import leggauss

_N_PANELS, _N_NODES = 32, 12


class StartTimeHeat(NamedTuple):
    """How long it lasts, and what turns to heat in the rotor and what is connected to it. [s, J]"""

    time: Array
    rotor_heat: Array


def unloaded_start(
    inertia: Array,
    synchronous_speed: Array,
    breakdown_torque: Array,
    breakdown_slip: Array,
    slip: Array | float,
    first_slip: Array | float = 1.0,
) -> StartTimeHeat:
    """Start without load of a motor by Kloss's simplified formula, in closed form.

    Parameters
    ----------
    inertia : Array
        Of all that turns, at its shaft. [kg·m²]
    synchronous_speed, breakdown_torque, breakdown_slip : Array
        [rad/s, N·m, 1]
    slip, first_slip : Array
        At its end and its beginning: 1 from rest, 2 where a motor at speed is switched over to turn back.

    Returns
    -------
    StartTimeHeat

    Notes
    -----
    docs/theory/drive, eqs. (25.24) and (25.25). The heat hangs on no motor curve.

    Examples
    --------
    >>> found = unloaded_start(0.2, 157.07963267948966, 95.0, 0.2, 0.05)
    >>> round(float(found.time), 9), round(float(found.rotor_heat), 4)
    (0.511401094, 2461.2326)
    """
    squares = (first_slip - slip) * (first_slip + slip)
    way = squares / (2 * breakdown_slip) + breakdown_slip * np.log(np.divide(first_slip, slip))
    time = inertia * synchronous_speed / (2 * breakdown_torque) * way
    return StartTimeHeat(time, 0.5 * inertia * synchronous_speed**2 * squares)


def quickest_breakdown_slip(slip: Array) -> Array:
    """Breakdown slip with which an unloaded start from rest to a slip is shortest. docs/theory/drive, eq. (25.24)."""
    return np.sqrt((1 - slip) * (1 + slip) / (-2 * np.log(slip)))


def loaded_start(
    torque: Callable[[Array], Array],
    load: Callable[[Array], Array],
    inertia: Array,
    synchronous_speed: Array,
    speeds: Array,
) -> StartTimeHeat:
    """Start against a load that hangs on the speed alone, with a constant inertia.

    Parameters
    ----------
    torque, load : callable
        From speeds, shape (..., k), to the motor's torque and to what it works against, at its shaft. [rad/s → N·m]
    inertia : Array, shape (...)
        [kg·m²]
    synchronous_speed : Array, shape (...)
        [rad/s]
    speeds : Array, shape (..., n)
        Rising from the first speed to the last; every break of both curves among them. [rad/s]

    Returns
    -------
    StartTimeHeat, shape (...)
        NaN where the motor's torque is not above the load all the way: it gets stuck.

    Notes
    -----
    docs/theory/drive, eq. (25.26), by Gauss's points. Where the motor only just gets past a speed they are too few.
    """
    node, weight = leggauss(_N_NODES)
    parts = np.linspace(0, 1, _N_PANELS + 1)[:-1]
    width = np.diff(speeds)[..., np.newaxis, np.newaxis] / _N_PANELS
    begins = speeds[..., :-1, np.newaxis, np.newaxis] + width * _N_PANELS * parts[:, np.newaxis]
    shape = (*speeds.shape[:-1], -1)
    speed = np.reshape(begins + 0.5 * width * (1 + node), shape)
    step = np.reshape(np.broadcast_to(0.5 * width * weight, (*begins.shape[:-1], _N_NODES)), shape)
    driving = torque(speed)
    excess = driving - load(speed)
    is_free = np.all(excess > 0, axis=-1) & np.all(torque(speeds) > load(speeds), axis=-1)
    held = np.where(is_free[..., np.newaxis] & (excess > 0), excess, np.nan)
    pace = step * np.asarray(inertia)[..., np.newaxis] / held
    heating = driving * (np.asarray(synchronous_speed)[..., np.newaxis] - speed)
    return StartTimeHeat(np.asarray(np.sum(pace, axis=-1)), np.asarray(np.sum(pace * heating, axis=-1)))


def starts_per_hour(
    unloaded_starts: Array, motor_inertia: Array, driven_inertia: Array, load_factor: Array | float = 1.0
) -> Array:
    """How many starts an hour the heat of a motor allows, from how many it may make by itself.

    Parameters
    ----------
    unloaded_starts : Array
        z₀, of the motor alone; of its maker. [1/h]
    motor_inertia, driven_inertia : Array
        At the motor's shaft. [kg·m²]
    load_factor : Array, optional
        What is left of them for the load while starting and running.

    Returns
    -------
    Array
        [1/h]

    Notes
    -----
    docs/theory/drive, eq. (25.33): a rule of thumb.
    """
    return unloaded_starts * load_factor * motor_inertia / (motor_inertia + driven_inertia)


def inertia_ratio(reduced_inertia: Array, ratio: Array, motor_inertia: Array) -> Array:
    """Inertia of what is driven over that of the motor, at the motor's shaft, which turns `ratio` times as fast. [1]

    docs/theory/drive, eq. (25.34).
    """
    return reduced_inertia / (ratio * ratio * motor_inertia)
