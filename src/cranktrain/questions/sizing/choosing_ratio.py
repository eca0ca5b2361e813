"""Which ratio between motor and crank: preferred numbers near the wanted one, and the one of the least rms torque."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics.ties import first_smallest_along
from cranktrain.questions.sizing.choosing import TorqueHistory
from cranktrain.questions.sizing.duty import rms_torque

R20 = (1.0, 1.12, 1.25, 1.4, 1.6, 1.8, 2.0, 2.24, 2.5, 2.8, 3.15, 3.55, 4.0, 4.5, 5.0, 5.6, 6.3, 7.1, 8.0, 9.0)
"""Preferred numbers of a decade, in which makers of gears step their ratios; recalled of ISO 3, which was not read."""


class CrankDemand(NamedTuple):
    """What the crank asks of a motor behind one gear, at one pace; samples over a cycle, shape (..., n).

    Attributes
    ----------
    static_torque : Array
        Of loads and weights, which hang on no speed. [N·m]
    inertia_torque : Array
        J ε + ½ J′ ω² of all that moves at this pace. [N·m]
    acceleration : Array
        ε of the crank at this pace. [rad/s²]
    time : Array
        Rising. [s]
    efficiency, back_efficiency : Array, shape (...)
        Of the gear where power goes to the crank, and where it comes back. [1]
    """

    static_torque: Array
    inertia_torque: Array
    acceleration: Array
    time: Array
    efficiency: Array
    back_efficiency: Array


class NearestRatio(NamedTuple):
    """The preferred ratio nearest to the wanted one, its place, and the crank's speed over the wanted one with it."""

    ratio: Array
    place: NDArray[np.intp]
    speed_ratio: Array


class BestRatio(NamedTuple):
    """Ratio of the least rms torque of a motor, and that torque, shape (...). [1, N·m]"""

    ratio: Array
    rms: Array


def preferred_ratios(least: float, most: float) -> Array:
    """Preferred numbers from one ratio to another, both included, shape (ratio,).

    Examples
    --------
    >>> preferred_ratios(9.0, 14.0)
    array([ 9. , 10. , 11.2, 12.5, 14. ])
    """
    low, high = int(np.floor(np.log10(least))) - 1, int(np.ceil(np.log10(most))) + 1
    every = np.array([round(number * 10.0**decade, 10) for decade in range(low, high) for number in R20])
    return every[(every >= least * (1 - 1e-12)) & (every <= most * (1 + 1e-12))]


def nearest_ratio(wanted: Array, ratios: Array) -> NearestRatio:
    """Ratio of a list, shape (ratio,), that is nearest to a wanted one, shape (...), in parts of it."""
    away = np.abs(np.log(ratios / np.asarray(wanted)[..., np.newaxis]))
    place = first_smallest_along(away)
    return NearestRatio(ratios[place], place, wanted / ratios[place])


def transmitted_torque(demand: CrankDemand, pace: Array | float = 1.0) -> Array:
    """Torque at the gear's output times what its loss makes of it: over the ratio it is the motor's. [N·m]

    Parameters
    ----------
    demand : CrankDemand
        Of a crank that turns forward.
    pace : Array, shape (..., 1)
        Speed of the crank over that of the demand.

    Notes
    -----
    docs/theory/drive, eq. (25.40): the loss takes its sense from the transmitted torque, with inertia in it.
    """
    torque = demand.static_torque + pace * pace * demand.inertia_torque
    forward, back = (np.asarray(one)[..., np.newaxis] for one in (demand.efficiency, demand.back_efficiency))
    return np.where(torque > 0, torque / forward, torque * back)


def history_at(demand: CrankDemand, ratio: Array, pace: Array | float = 1.0) -> TorqueHistory:
    """Torque at the motor's shaft behind a ratio, without that of the rotor; ratio and pace of shape (...)."""
    along, quick = (np.asarray(one, dtype=float)[..., np.newaxis] for one in (ratio, pace))
    torque = transmitted_torque(demand, quick) / along
    acceleration = demand.acceleration * quick * quick * along
    return TorqueHistory(torque, demand.time / quick + 0 * along, np.broadcast_to(acceleration, torque.shape))


def rms_by_ratio(demand: CrankDemand, motor_inertia: Array, ratio: Array) -> Array:
    """Rms torque of a motor behind a ratio, all of shape (...). [N·m]

    docs/theory/drive, eq. (25.40).
    """
    history = history_at(demand, ratio)
    return rms_torque(history.torque + np.asarray(motor_inertia)[..., np.newaxis] * history.acceleration, history.time)


def best_ratio(demand: CrankDemand, motor_inertia: Array) -> BestRatio:
    """Ratio with which the rms torque of a motor is least.

    Parameters
    ----------
    demand : CrankDemand
    motor_inertia : Array, shape (...)
        Of the rotor. [kg·m²]

    Returns
    -------
    BestRatio
        Infinite where nothing accelerates: the higher the ratio, the less torque.

    Notes
    -----
    docs/theory/drive, eq. (25.41). Of a pure inertia it is √(J/J_m).
    """
    time = demand.time
    with np.errstate(divide="ignore", invalid="ignore"):
        own = motor_inertia * rms_torque(demand.acceleration, time)
        ratio = np.sqrt(rms_torque(transmitted_torque(demand), time) / own)
        rms = np.where(np.isfinite(ratio), rms_by_ratio(demand, motor_inertia, ratio), 0.0)
    return BestRatio(ratio, rms)
