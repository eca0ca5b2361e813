"""When a part of a run begins otherwise than planned, and what follows on the last one; plain, and to be compiled."""

import math

from cranktrain.transient import endings

NEARLY = 0.98
"""Of the mean speed of steady running: from there on a start is over but for two cycles more."""
MORE_CYCLES = 2.0
LONGEST = 60.0
"""Unless the file says how long. [s]"""
N_EVEN = 1001
"""Times from beginning to end at which every start is looked at."""
MOST_STEPS = 60_000
"""Some ten seconds of computing; a minute of a compressor at 1500 rpm takes 55 000."""
MOST_REVERSALS = 100
"""After which a crank that swings is taken not to get over."""


def is_there_already(speed: float, target: float) -> bool:
    """Whether a part of a run begins at the speed to reach, or faster: one that is to settle lasts some cycles then."""
    return target < math.inf and speed >= target


def some_cycles_on(time: float, cycle_time: float) -> float:
    """When two cycles more are over. [s]"""
    return time + MORE_CYCLES * cycle_time


def followed_until(
    reason: int, ended: float, target: float, speeds: tuple[float, float], steady_speed: float, cycle_time: float
) -> float:
    """When a part of a run is over that follows on the last one of a start that is to settle; its end where none does.

    By how the last one ended, when, the speed that it was to reach, and those at its beginning and end. [s, rad/s]
    """
    began, left = speeds
    began_fast = target == math.inf and began > steady_speed / NEARLY
    slows_yet = began_fast and began - left > (1 - NEARLY) * steady_speed
    if reason == endings.SPEED_REACHED or (reason == endings.TIME_OUT and slows_yet):
        return min(some_cycles_on(ended, cycle_time), LONGEST)
    return ended
