"""Which motor of a range is enough: what governs, and by how much the next smaller one misses."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.motors.cage.catalogue import MotorRange
from cranktrain.numerics.ties import first_largest_along

VOLTAGE_RESERVE = 0.81
"""What is left of torques where the voltage is down by 10 %."""

CRITERIA = ("rms", "peak", "start")
"""What a motor is checked for, in this order along the last axis of its uses."""


class TorqueDemand(NamedTuple):
    """What is asked of a motor at its shaft, shape (...). [N·m]

    Attributes
    ----------
    rms : Array
        Over the whole cycle, divided by the factor of its duty.
    peak : Array
        The largest one.
    start : Array
        With which it has to start at the worst position.
    """

    rms: Array
    peak: Array
    start: Array


class MotorChoice(NamedTuple):
    """The smallest motor that is enough, shape (...).

    Attributes
    ----------
    motor : Array of int
        Its place in the range; −1 where none is enough.
    uses : Array, shape (..., criterion)
        What is asked over what it can do, of each of `CRITERIA`; NaN where there is no motor.
    governs : Array of int
        Which of them is the largest; −1 where there is no motor.
    smaller_uses : Array, shape (..., criterion)
        The same of the next smaller motor, or of the largest where none is enough; NaN where there is none smaller.
    misses : Array of int
        Which of these is the largest; −1 where there is none.
    misses_by : Array
        By how much that is above 1.
    """

    motor: NDArray[np.intp]
    uses: Array
    governs: NDArray[np.intp]
    smaller_uses: Array
    misses: NDArray[np.intp]
    misses_by: Array


def motor_uses(demand: TorqueDemand, motors: MotorRange, reserve: float = VOLTAGE_RESERVE) -> Array:
    """What is asked of every motor over what it can do.

    Parameters
    ----------
    demand : TorqueDemand, fields of shape (..., motor) or (..., 1)
        Of each motor its own, where its inertia matters.
    motors : MotorRange
    reserve : float
        What is left of breakdown, pull-up and starting torque at the lowest voltage.

    Returns
    -------
    Array, shape (..., motor, criterion)
        Up to 1 is enough.

    Notes
    -----
    docs/theory/drive, eq. (25.32).
    """
    values = motors.values
    least = np.minimum(values.starting_ratio, values.pull_up_ratio)
    able = (np.ones_like(least), reserve * values.breakdown_ratio, reserve * least)
    uses = (asked / (can * values.rated_torque) for asked, can in zip(demand, able, strict=True))
    return np.stack(np.broadcast_arrays(*uses), axis=-1)


def motor_choice(demand: TorqueDemand, motors: MotorRange, reserve: float = VOLTAGE_RESERVE) -> MotorChoice:
    """Smallest motor of a range that passes all checks.

    Parameters
    ----------
    demand : TorqueDemand, fields of shape (..., motor) or (..., 1)
    motors : MotorRange
    reserve : float
        As of `motor_uses`.

    Returns
    -------
    MotorChoice

    Examples
    --------
    >>> from cranktrain.motors.cage.catalogue import four_pole_motors
    >>> asked = TorqueDemand(np.array([22.20445]), np.array([35.48465]), np.array([35.48465]))
    >>> found = motor_choice(asked, four_pole_motors())
    >>> float(four_pole_motors().power[found.motor]), CRITERIA[found.misses], round(float(found.misses_by), 4)
    (4000.0, 'start', 0.171)
    """
    return choice_of(motor_uses(demand, motors, reserve))


def choice_of(uses: Array) -> MotorChoice:
    """Smallest motor whose uses are all up to 1.

    Parameters
    ----------
    uses : Array, shape (..., motor, criterion)
        By rising size; of any criteria, of which `MotorChoice` then speaks.
    """
    is_enough = np.all(uses <= 1, axis=-1)
    n_motors = uses.shape[-2]
    is_any = np.any(is_enough, axis=-1)
    motor = np.where(is_any, np.argmax(is_enough, axis=-1), -1)
    smaller = np.where(is_any, motor - 1, n_motors - 1)
    own, other = _of_motor(uses, motor), _of_motor(uses, smaller)
    misses = _largest(other)
    by = np.where(misses >= 0, np.max(other, axis=-1) - 1, np.nan)
    return MotorChoice(motor, own, _largest(own), other, misses, by)


def _of_motor(uses: Array, motor: NDArray[np.intp]) -> Array:
    """Uses of one motor, shape (..., criterion); NaN where there is none."""
    place = np.maximum(motor, 0)[..., np.newaxis, np.newaxis]
    taken = np.take_along_axis(uses, place, axis=-2)[..., 0, :]
    return np.where(motor[..., np.newaxis] >= 0, taken, np.nan)


def _largest(uses: Array) -> NDArray[np.intp]:
    """Which criterion is the largest; −1 where nothing is known."""
    is_known = ~np.isnan(uses[..., 0])
    return np.where(is_known, first_largest_along(np.nan_to_num(uses)), -1)
