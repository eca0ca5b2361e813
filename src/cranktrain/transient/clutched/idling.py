"""A flywheel that idles beside a crank at rest: nothing changes any more until something happens."""

import numpy as np

from cranktrain.motion import Array
from cranktrain.transient.clutched.equation import N_PRESS_ROW, N_PRESS_STATE, WHEEL
from cranktrain.transient.clutched.phases import Ahead
from cranktrain.transient.clutched.step import Derive

_ASIDE = 1e-6
"""Of the speed: so far beside it the pull back is asked for."""


def idle_slopes(derive: Derive, ahead: Ahead, time: float, state: Array, closeness: float) -> Array | None:
    """Slopes with which the whole rest of a phase goes on, shape (9,); None of a flywheel that does not idle yet.

    Parameters
    ----------
    derive : Derive
    ahead : Ahead
        A flywheel beside a crank that is held, with a clutch whose grip does not change, has one speed to which all
        pulls it. It idles where it is as near to that as a step's error: then a step of any width ends there.
    time : float
        [s]
    state : Array, shape (9,)
    closeness : float
        [rad/s]

    Notes
    -----
    docs/theory/clutched-drive, eq. (30.16).
    """
    phase, width = ahead.acting.phase, ahead.until - time
    if ahead.sense != 0 or phase.is_locked or phase.clutch_slope != 0 or not 0 < width < np.inf:
        return None
    now, slopes, others = state.tolist(), [0.0] * N_PRESS_ROW, [0.0] * N_PRESS_ROW
    aside = _ASIDE * abs(now[WHEEL])
    beside = [now[WHEEL] + aside, *now[1:]]
    if derive(time, now, slopes, 0.0, ahead.acting) or derive(time, beside, others, 0.0, ahead.acting):
        return None
    pull = slopes[WHEEL] - others[WHEEL]
    if not (pull > 0 and abs(slopes[WHEEL]) * aside <= closeness * pull):
        return None
    # twice: what is left of the way there would count over a long pause
    for _ in range(2):
        now[WHEEL] += slopes[WHEEL] * aside / pull
        if derive(time, now, slopes, 0.0, ahead.acting):
            return None
    # what depends on the time, as a starter does, may pull elsewhere at the end
    if derive(ahead.until, now, others, 0.0, ahead.acting) or others != slopes:
        return None
    return np.array([(now[WHEEL] - state[WHEEL]) / width, *slopes[1:N_PRESS_STATE]])
