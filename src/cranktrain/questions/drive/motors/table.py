"""Motor by a table of torques over speeds."""

from typing import NamedTuple

import numpy as np

from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.questions.drive.motors.motor import Motor, MotorBreaks


class TableMotor(NamedTuple):
    """Torques [N·m] at speeds [rad/s] that rise, both of shape (point,): all designs have one table."""

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
    docs/theory/drive, eq. (25.21).
    """
    return np.interp(speed, table.speeds, table.torques)


def table_breaks(table: TableMotor) -> MotorBreaks:
    """Every point of the table."""
    return MotorBreaks(tuple(table.speeds))


TABLE = Motor(
    "table",
    N_("motor by a table"),
    table_torque,
    TableMotor,
    "docs/theory/drive, eq. (25.21)",
    N_("between the speeds of the table"),
    breaks=table_breaks,
)
