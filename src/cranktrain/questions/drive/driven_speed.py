"""Speed of the machine with its motor, as evenness and a second run take it."""

import numpy as np
from numpy.typing import NDArray

from cranktrain.layout.crank_angle import CrankAngle, within
from cranktrain.layout.speed import DrivenSpeed
from cranktrain.motion import Array
from cranktrain.numerics import Extreme, largest_between
from cranktrain.questions.drive.steady_cycle import SpeedOverTurn
from cranktrain.questions.drive.steady_drive import SteadyDrive
from cranktrain.questions.reduction.machines import ReducedMachines


def driven_speed(steady: SteadyDrive, machines: ReducedMachines, crank_angle: CrankAngle) -> DrivenSpeed:
    """Give the speed over the cycle, its means and extremes."""
    zeros = np.broadcast_to(crank_angle.zero[:, 0, 0], len(steady.running)).tolist()
    most, least = (
        [_extreme(found, crank_angle, zero, sign) for found, zero in zip(steady.running, zeros, strict=True)]
        for sign in (1.0, -1.0)
    )
    over_time = machines.cycle / steady.cycle_time
    over_angle = np.array(
        [np.nan if found is None else float(found.mesh.mean(found.speed)) for found in steady.running]
    )
    return DrivenSpeed(
        steady.drive_speed,
        steady.drive_acceleration,
        over_time,
        over_angle,
        _together(most),
        _together(least),
    )


def _extreme(found: SpeedOverTurn | None, crank_angle: CrankAngle, zero: float, sign: float) -> Extreme:
    """Largest or smallest speed of a design, between the ends of its pieces, at the shown crank angle."""
    if found is None:
        return Extreme(np.full(1, np.nan), np.full(1, np.nan))

    def curves(_which: NDArray[np.intp], shown: Array) -> Array:
        return sign * found.at(np.ravel(shown) + zero).reshape(shown.shape)

    samples = sign * found.at(crank_angle.shown + zero)[np.newaxis]
    peak = largest_between(curves, crank_angle.shown, samples, (found.mesh.start - zero)[np.newaxis])
    return Extreme(within(peak.angle, crank_angle.cycle), sign * peak.value)


def _together(each: list[Extreme]) -> Extreme:
    """Extremes of all designs, shape (design,)."""
    return Extreme(np.concatenate([own.angle for own in each]), np.concatenate([own.value for own in each]))
