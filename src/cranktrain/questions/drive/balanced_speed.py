"""The constant speed at which a motor's mean torque balances the machine's: the limit of very even running."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.questions.drive.steady_turn import DriveInTurn, together
from cranktrain.questions.reduction.gear_train import through_stages
from cranktrain.transient.gearing import Gearing, overall_ratio, turning_inertia

_N_SPEEDS, _AT_ONCE = 400, 10
"""Speeds that are looked at; how many at once, of which a first look takes one in so many."""
_N_ANGLES = 96
"""At which the first guess of the speed looks: the cycle itself does not hang on them."""
_SLOWEST, _BEYOND = 0.02, 1.3
"""Of the motor's top speed: slower it counts as stalled, and beyond it a load may drive it."""
_FASTEST = 1e5
"""How many times as fast as it is first tried a motor without a top speed is looked at."""


class SpeedBalance(NamedTuple):
    """What drives a crank at constant speeds, less what holds it, on the mean over the cycle.

    Attributes
    ----------
    speeds : Array, shape (n,)
        Rising; from below the highest balance on, fewer beyond it; or all where there is none. [rad/s]
    excess : Array, shape (n,)
        [N·m]
    """

    speeds: Array
    excess: Array

    @property
    def fall(self) -> int | None:
        """The last place behind which the excess falls through 0; None without one."""
        falls = np.flatnonzero(_falls(self.excess))
        return int(falls[-1]) if falls.size else None

    @property
    def speed(self) -> float | None:
        """Highest speed at which the excess falls through 0; None without one. [rad/s]"""
        fall = self.fall
        if fall is None:
            return None
        (low, high), (over, under) = self.speeds[fall:][:2].tolist(), self.excess[fall:][:2].tolist()
        return low + (high - low) * over / (over - under)

    def with_more(self, between: "SpeedBalance") -> "SpeedBalance":
        """The same with more speeds between those where it falls, and none below."""
        beyond = slice((self.fall or 0) + 2, None)
        return SpeedBalance(*(np.append(own, all_[beyond]) for own, all_ in zip(between, self, strict=True)))


def balances(each: Sequence[DriveInTurn], cycle: float) -> list[SpeedBalance]:
    """Look for the constant speeds at which motors give on the mean what their machines take.

    Parameters
    ----------
    each : sequence of DriveInTurn
        Designs of one structure.
    cycle : float
        [rad]

    Returns
    -------
    list of SpeedBalance
        Up to 1.3 times the motor's top speed; where it has none or still drives there, and neither speed is a balance,
        as far as the torque falls below the load.
    """
    angle = np.broadcast_to((np.arange(_N_ANGLES) + 0.5) * cycle / _N_ANGLES, (len(each), _N_ANGLES))
    there = together(each, angle)
    highest = np.array([one.motor.highest_speed(0) / overall_ratio(one.gearing) for one in each])
    found = _up_to(there, np.where(np.isfinite(highest), highest, 1.0))
    for place, (top, own) in enumerate(zip(highest.tolist(), found, strict=True)):
        if np.isinf(top) or (own.speed is None and own.excess[-1] > 0):
            alone = together(each[place : place + 1], angle[:1])
            (found[place],) = _up_to(alone, _end(alone, top if np.isfinite(top) else 1.0))
    return found


def _up_to(turning: DriveInTurn, tops: Array) -> list[SpeedBalance]:
    """Look from the highest speeds down, shape (design,), for a balance between few of them; where none is, at all."""
    speeds = np.linspace(_SLOWEST, _BEYOND, _N_SPEEDS) * tops[:, np.newaxis]
    few = _downwards(turning, speeds[:, (_N_SPEEDS - 1) % _AT_ONCE :: _AT_ONCE])
    all_of_them = _downwards(turning, speeds) if any(own.speed is None for own in few) else few
    falls = [own.fall or 0 for own in few]
    near = np.array([np.count_nonzero(own < one.speeds[at]) for own, one, at in zip(speeds, few, falls, strict=True)])
    between = np.take_along_axis(speeds, near[:, np.newaxis] + np.arange(_AT_ONCE + 1), axis=1)
    closely = zip(between, _mean_work(turning, between), strict=True)
    return [
        whole if own.fall is None else own.with_more(SpeedBalance(*more))
        for own, whole, more in zip(few, all_of_them, closely, strict=True)
    ]


def _downwards(turning: DriveInTurn, speeds: Array) -> list[SpeedBalance]:
    """Look at rising speeds, shape (design, n), from the highest down, as far as a balance of each."""
    excess, first = np.empty((len(speeds), 0)), speeds.shape[1]
    while first > 0 and not np.all(np.any(_falls(excess), axis=1)):
        after, first = first, max(first - _AT_ONCE, 0)
        excess = np.append(_mean_work(turning, speeds[:, first:after]), excess, axis=1)
    return [SpeedBalance(*own) for own in zip(speeds[:, first:], excess, strict=True)]


def _falls(excess: Array) -> NDArray[np.bool_]:
    """Whether what drives falls through 0 behind a speed, shape (..., n) → (..., n − 1)."""
    return (excess[..., :-1] > 0) & (excess[..., 1:] <= 0)


def _end(turning: DriveInTurn, first: float) -> Array:
    """Speed from which on a motor without a top speed does not drive against this load, shape (1,). [rad/s]"""
    speeds: Array = np.geomspace(first, _FASTEST * first, 18)
    drives = np.flatnonzero(_mean_work(turning, speeds[np.newaxis])[0] > 0)
    return speeds[[min(drives[-1] + 1, speeds.size - 1)]] if drives.size else np.array([first])


def _mean_work(turning: DriveInTurn, speeds: Array) -> Array:
    """Mean over the cycle of what drives the crank at constant speeds, less what holds it, shape (design, n). [N·m]"""
    here = turning.here.changed(lambda curve: curve[:, np.newaxis])
    widened: tuple[Any, ...] = tuple(np.asarray(part)[..., np.newaxis] for part in turning.gearing)
    gearing = Gearing(*widened)
    torque, speed = turning.motor_torque(speeds)[..., np.newaxis], speeds[..., np.newaxis]
    passed = through_stages(torque, here.inertia, here.taken(speed), gearing)
    # what inertia would take
    work = (here.inertia + turning_inertia(gearing)) * passed.acceleration + 0.5 * here.slope * speed**2
    return np.mean(work, axis=-1)
