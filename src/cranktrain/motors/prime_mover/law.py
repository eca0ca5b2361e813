"""Prime mover with a governor: an engine that gives what its droop asks for, up to its full load."""

from typing import NamedTuple

import numpy as np

from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.motors.law import BriefLimits, MotorBreaks, MotorLaw
from cranktrain.motors.table.law import TableMotor, table_torque


class PrimeMover(NamedTuple):
    """An engine and its governor.

    Attributes
    ----------
    no_load_speed, rated_speed, rated_torque : Array
        Two points of the governor's line: no torque at the first speed, the rated one at the second.
        [rad/s, rad/s, N·m]
    full_load : TableMotor
        The most that the engine gives, by speed; 0 below the speed at which it runs by itself.
    """

    no_load_speed: Array
    rated_speed: Array
    rated_torque: Array
    full_load: TableMotor


def prime_mover_torque(speed: Array, engine: PrimeMover) -> Array:
    """Torque by the governor's line, between 0 and full load. [N·m]

    Parameters
    ----------
    speed : Array, shape (..., n)
        [rad/s]
    engine : PrimeMover, fields broadcastable to (..., 1)

    Notes
    -----
    docs/theory/drive, eq. (25.22). Fuel is cut, and the engine's own friction is a load.
    """
    asked = engine.rated_torque * (engine.no_load_speed - speed) / (engine.no_load_speed - engine.rated_speed)
    return np.maximum(0, np.minimum(asked, table_torque(speed, engine.full_load)))


def prime_mover_breaks(engine: PrimeMover) -> MotorBreaks:
    """Points of the full-load curve, the speed without load, and where the governor's line leaves that curve."""
    speeds, torques = engine.full_load
    slope = engine.rated_torque / (engine.no_load_speed - engine.rated_speed)
    over = slope * (engine.no_load_speed - speeds) - torques
    crosses = over[:-1] * over[1:] < 0
    along = over[:-1] / np.where(crosses, over[:-1] - over[1:], np.nan)
    # beyond the ends of the curve full load is that of the end
    before, behind = (engine.no_load_speed - torques[end] / slope for end in (0, -1))
    level = (np.where(before < speeds[0], before, np.nan), np.where(behind > speeds[-1], behind, np.nan))
    return MotorBreaks((*speeds, engine.no_load_speed, *(speeds[:-1] + np.diff(speeds, axis=0) * along), *level))


def _limits(_motor: object, _design: int) -> BriefLimits:
    """Nothing is known of what it can do for a moment."""
    return BriefLimits(unknown=N_("largest torque and start: it gives no more than full load, and starts without load"))


PRIME_MOVER = MotorLaw(
    "prime_mover",
    N_("engine with a governor"),
    prime_mover_torque,
    PrimeMover,
    "docs/theory/drive, eq. (25.22)",
    N_("mean torque over the engine's own cycle; the governor has no delay"),
    breaks=prime_mover_breaks,
    limits=_limits,
)
