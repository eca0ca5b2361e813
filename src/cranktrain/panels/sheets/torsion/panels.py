"""Modes along the shaft, and Campbell's diagram: frequencies over the speed, rays of orders, their crossings."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.analysis import Result
from cranktrain.motion import Array
from cranktrain.questions.torsion.critical import CriticalSpeeds, ModeVectorSums
from cranktrain.questions.torsion.modes import TorsionalModes, TorsionalTrain
from cranktrain.questions.torsion.train import nodes
from cranktrain.questions.torsion.trials import HolzerTrials

_BEYOND = 1.25
"""The diagram reaches beyond the declared speed by this factor."""
_ORDERS = 12.0
"""Highest order that has a ray."""
_IN_SIGHT = 3
"""So many of the lowest frequencies are in sight, if rays get there."""
_ABOVE = 1.15
"""Room above the highest frequency in sight."""


class ModeShape(NamedTuple):
    """A mode along the shaft.

    Attributes
    ----------
    mode : int
        From 1.
    frequency : float
        [rad/s]
    unit : str
        The disc whose amplitude is 1.
    amplitude : Array, shape (disc,)
        By the rows of Holzer's table.
    following : array of int, shape (disc − 1,)
        To which disc the shaft of each but the last leads.
    nodes : Array, shape (node,)
        Where nodes are: 2.3 is 0.3 of the way from disc 2 to the one that its shaft leads to, if that is disc 3.
    """

    mode: int
    frequency: float
    unit: str
    amplitude: Array
    following: NDArray[np.intp]
    nodes: Array


class TrialShape(NamedTuple):
    """Amplitudes by Holzer's table at a frequency of the file's own; as in `ModeShape`.

    residual: what it leaves over, for 1 rad at the free end. [N·m/rad]
    """

    frequency: float
    residual: float
    amplitude: Array
    following: NDArray[np.intp]
    nodes: Array


class Crossing(NamedTuple):
    """Where an order meets a natural frequency.

    Attributes
    ----------
    mode : int
        From 1.
    order : float
    speed, frequency : float
        [rad/s]
    vector_sum, weight : float
        Of amplitude 1 at the free end, and of amplitude 1 where the mode has its largest, which is at most the number
        of cylinders; NaN where no firing order says it.
    """

    mode: int
    order: float
    speed: float
    frequency: float
    vector_sum: float
    weight: float


class Campbell(NamedTuple):
    """Campbell's diagram of one design.

    Attributes
    ----------
    speed : float or None
        The declared one. [rad/s]
    largest_speed, highest_frequency : float
        How far it reaches. [rad/s]
    frequency : Array, shape (mode,)
        Levels, also those out of sight. [rad/s]
    order : Array, shape (ray,)
        A ray is the frequency order · speed.
    crossings : tuple of Crossing
        In sight, by rising speed.
    """

    speed: float | None
    largest_speed: float
    highest_frequency: float
    frequency: Array
    order: Array
    crossings: tuple[Crossing, ...]


def mode_shapes(result: Result, design: int = 0) -> Sequence[ModeShape]:
    """Every mode of a machine with [torsion], by rising frequency."""
    modes, following = result[TorsionalModes], result[TorsionalTrain].train.following
    shafts = np.arange(following.size)
    places = shafts + modes.mode_node[design, :, :-1] * (following - shafts)
    return [
        ModeShape(
            mode + 1,
            float(modes.natural_frequency[design, mode]),
            result.labels["disc"][int(modes.unit[design, mode])],
            modes.mode_shape[design, mode],
            following,
            places[mode, np.isfinite(places[mode])],
        )
        for mode in range(modes.natural_frequency.shape[-1])
    ]


def trial_shapes(result: Result, design: int = 0) -> Sequence[TrialShape]:
    """What Holzer's table gives at every frequency that the file names."""
    found = result.get(HolzerTrials)
    if found is None:
        return []
    train = result[TorsionalTrain].train
    shafts = np.arange(train.following.size)
    places = shafts + nodes(train, found.trial_amplitude)[design, :, :-1] * (train.following - shafts)
    return [
        TrialShape(
            float(found.trial_frequency[design, trial]),
            float(found.trial_residual[design, trial]),
            found.trial_amplitude[design, trial],
            train.following,
            places[trial, np.isfinite(places[trial])],
        )
        for trial in range(found.trial_frequency.shape[-1])
    ]


def campbell(result: Result, design: int = 0) -> Campbell:
    """Lay out Campbell's diagram: beyond the declared speed, or where there is none, as far as order 3 of mode 1.

    docs/theory/torsion, eq. (23.9).
    """
    modes, critical = result[TorsionalModes], result[CriticalSpeeds]
    sums = result.get(ModeVectorSums)
    frequency, speeds = modes.natural_frequency[design], critical.critical_speed[design]
    order = np.array([float(name) for name in result.labels["order"]])
    rays = order[order <= _ORDERS]
    running = None if critical.speed is None else float(critical.speed[design])
    largest = _BEYOND * (float(frequency[0]) / 3 if running is None else running)
    reached = frequency[:_IN_SIGHT][frequency[:_IN_SIGHT] <= largest * _ORDERS]
    highest = _ABOVE * float(np.max(reached, initial=frequency[0]))
    size = np.full_like(speeds, np.nan) if sums is None else sums.mode_vector_sum[design]
    weight = size / np.max(np.abs(modes.mode_shape[design]), axis=-1, keepdims=True)
    in_sight = (speeds[:, : rays.size] <= largest) & (frequency[:, np.newaxis] <= highest)
    found = [
        Crossing(
            mode + 1,
            float(order[k]),
            float(speeds[mode, k]),
            float(frequency[mode]),
            float(size[mode, k]),
            float(weight[mode, k]),
        )
        for mode, k in np.argwhere(in_sight).tolist()
    ]
    found.sort(key=lambda one: one.speed)
    return Campbell(running, largest, highest, frequency, rays, tuple(found))
