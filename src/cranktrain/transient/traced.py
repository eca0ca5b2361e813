"""Steps of a run as they were taken: where each ends, and what gives the state anywhere within it."""

from typing import Any

import numpy as np

from cranktrain.motion import Array
from cranktrain.transient.compiling import kept
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


def states_within(steps: Array, start: Array, samples: Array, *, is_compiled: bool) -> Array:
    """States at samples of a run that never waited, to the last bit as the run itself writes them down.

    Parameters
    ----------
    steps : Array, shape (n, `N_TRACED`)
    start : Array, shape (6,)
        State at the beginning.
    samples : Array, ascending, shape (m,)
        [s]
    is_compiled : bool
        With Numba.

    Returns
    -------
    Array, shape (k, 6)
        Of those that the run came to.
    """
    n_before = int(np.searchsorted(samples, 0.0, side="right"))
    table = np.empty((len(samples), N_STATE))
    table[:n_before] = start
    fill = kept(fill_one_by_one) if is_compiled else _fill_at_once
    return table[: fill(steps, samples, n_before, table)]


def fill_one_by_one(steps: Any, samples: Any, row: int, table: Any) -> int:
    """Fill a table of states from a row on; gives behind which row the steps end."""
    for step in range(len(steps)):
        begin, width = steps[step, BEGIN], steps[step, WIDTH]
        state, slopes = steps[step, _STATE : _STATE + N_STATE], steps[step, _STATE + N_STATE :]
        while width > 0 and row < len(samples) and samples[row] <= begin + width:
            theta = (samples[row] - begin) / width
            for part in range(N_STATE):
                table[row, part] = within(state, slopes, width, theta, part)
            row += 1
    return row


def _fill_at_once(steps: Array, samples: Array, row: int, table: Array) -> int:
    """The same by NumPy, which is quicker where nothing is compiled."""
    taken = steps[steps[:, WIDTH] > 0].T.copy()
    step = np.searchsorted(taken[BEGIN] + taken[WIDTH], samples[row:])
    own = taken[:, step[step < taken.shape[1]]]
    end = row + own.shape[1]
    theta = (samples[row:end] - own[BEGIN]) / own[WIDTH]
    state, slopes = own[_STATE : _STATE + N_STATE], own[_STATE + N_STATE :]
    every: Any = np.arange(N_STATE)
    table[row:end] = np.asarray(within(state, slopes, own[WIDTH], theta, every)).T
    return end
