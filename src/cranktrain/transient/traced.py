"""Steps of a run as they were taken: where each ends, and what gives the state anywhere within it."""

from typing import Any

import numpy as np

from cranktrain.motion import Array
from cranktrain.transient.step import N_STATE, ROW, within

TIME_AFTER, SPEED_AFTER, BEGIN, WIDTH, _STATE = range(5)
"""Places in the row of a step: where the run stands after it [s, rad/s]; when it begins, and how wide it is, 0 of one
that was not taken [s]; the state at its beginning, and the slopes of its stages."""
N_TRACED = _STATE + N_STATE + 7 * ROW


def trace_step(steps: Any, row: int, time: float, width: float, state: Any, slopes: Any) -> None:
    """Write down a step that is taken."""
    steps[row, BEGIN] = time
    steps[row, WIDTH] = width
    for part in range(N_STATE):
        steps[row, _STATE + part] = state[part]
    for part in range(7 * ROW):
        steps[row, _STATE + N_STATE + part] = slopes[part]


def states_within(steps: Array, start: Array, samples: Array) -> Array:
    """States at samples of a run that never waited, to the last bit as the run itself writes them down.

    Parameters
    ----------
    steps : Array, shape (n, `N_TRACED`)
    start : Array, shape (6,)
        State at the beginning.
    samples : Array, ascending, shape (m,)
        [s]

    Returns
    -------
    Array, shape (k, 6)
        Of those that the run came to.
    """
    taken = steps[steps[:, WIDTH] > 0].T.copy()
    step = np.searchsorted(taken[BEGIN] + taken[WIDTH], samples)
    is_later = samples > 0
    own = taken[:, step[is_later & (step < taken.shape[1])]]
    times = samples[is_later][: own.shape[1]]
    theta = (times - own[BEGIN]) / own[WIDTH]
    state, slopes = own[_STATE : _STATE + N_STATE], own[_STATE + N_STATE :]
    every: Any = np.arange(N_STATE)
    later = np.asarray(within(state, slopes, own[WIDTH], theta, every))
    return np.concatenate([np.tile(start, (np.sum(~is_later), 1)), later.T])
