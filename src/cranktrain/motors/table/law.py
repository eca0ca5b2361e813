"""Motor by a table of torques over speeds."""

from typing import NamedTuple

import numpy as np

from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.motors.declared import curve_limits
from cranktrain.motors.law import MotorBreaks, MotorLaw


class TableMotor(NamedTuple):
    """Torques [N·m] at two speeds [rad/s] or more that rise, both of shape (point,), or (point, ..., 1) of designs."""

    speeds: Array
    torques: Array


def table_torque(speed: Array, table: TableMotor) -> Array:
    """Torque on straight lines between the points of the table, and beyond its ends that of the last one. [N·m]

    Parameters
    ----------
    speed : Array, shape (..., n)
        [rad/s]
    table : TableMotor

    Notes
    -----
    docs/theory/drive, eq. (25.21), as a sum over the lines of what the way along each adds.
    """
    torque = table.torques[0]
    for i in range(table.speeds.shape[0] - 1):
        width = table.speeds[i + 1] - table.speeds[i]
        along = np.minimum(width, np.maximum(0.0, speed - table.speeds[i]))
        torque = torque + (table.torques[i + 1] - table.torques[i]) * (along / width)
    return torque


def table_breaks(table: TableMotor) -> MotorBreaks:
    """Every point of the table."""
    return MotorBreaks(tuple(table.speeds))


def _measured(table: TableMotor) -> tuple[Array, Array]:
    """First and last speed of the table."""
    return table.speeds[0], table.speeds[-1]


TABLE = MotorLaw(
    "table",
    N_("motor by a table"),
    table_torque,
    TableMotor,
    "docs/theory/drive, eq. (25.21)",
    N_("between the speeds of the table"),
    breaks=table_breaks,
    limits=curve_limits,
    measured=_measured,
)
