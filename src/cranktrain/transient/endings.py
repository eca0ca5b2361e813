"""Why a run ends, what is noted on the way, and the limits that it is given."""

from typing import NamedTuple

(
    TIME_OUT, SPEED_REACHED, AT_REST, STALLED, OVERSPEED, SWINGS, TOO_MANY_STEPS, NO_STEP_SHORT_ENOUGH, LINKS_OPEN,
    GEARING_JAMS, STOPPED,
) = range(11)  # fmt: skip
"""Why a run ended."""
GOING = -1
"""That it has not."""
REVERSAL, DEAD_POSITION, SPEED_PASSED, HELD, SET_OFF = range(5)
"""What is noted on the way."""


class RunLimits(NamedTuple):
    """When a run ends and how closely it is computed.

    Attributes
    ----------
    end_time : float
        [s]
    target_speed, overspeed : float
        Of the crank, by amount; infinite where nobody asks. [rad/s]
    stops_at_target : bool
    most_reversals, most_steps : int
    tolerance : float
        Error of a step, of the angle in rad and of the speed in parts of the largest so far.
    is_timed : bool
        Whether motor or brake depend on the time: a crank that is held may then be let go.
    """

    end_time: float
    target_speed: float
    overspeed: float
    stops_at_target: bool
    most_reversals: int
    most_steps: int
    tolerance: float
    is_timed: bool
