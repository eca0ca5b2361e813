"""The counterbalance of a pumping unit that is best: for equal peaks of both strokes, and for the least rms."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics import bracketed_roots, integral_motion
from cranktrain.questions.pumping.turn_pieces import TurnPieces, highest

_MOST_TRIALS = 10
_SETTLED = 1e-7
"""A step of Newton's method, in parts of the share, after which the next one is less than rounding."""


class BalancedUnit(NamedTuple):
    """How much of the declared counterbalance is best: for equal peaks of up- and downstroke, and for the least rms."""

    equal_peaks: float
    least_rms: float


def balanced(pieces: TurnPieces, of_rod: Array, of_weights: Array, ends: tuple[float, float]) -> BalancedUnit:
    """Find the best counterbalances, in parts of the declared one; NaN where none makes both peaks equal.

    Parameters
    ----------
    pieces : TurnPieces
    of_rod, of_weights : Array, shape (point,)
        Torques that the crank must be given for the rod with what hangs beside it, and for the weights. [N·m]
    ends : (float, float)
        Where the upstroke begins and ends. [rad]

    Notes
    -----
    docs/theory/pumping-unit, eqs. (28.9) and (28.10).
    """
    squares = pieces.mean(of_weights**2)
    if not squares > 0:
        return BalancedUnit(np.nan, np.nan)
    return BalancedUnit(_equal_peaks(pieces, of_rod, of_weights, ends), -pieces.mean(of_rod * of_weights) / squares)


def _equal_peaks(pieces: TurnPieces, of_rod: Array, of_weights: Array, ends: tuple[float, float]) -> float:
    """Share of the weights at which both strokes have the same peak, by Newton's method from all of them on."""
    is_up = pieces.within(*ends)

    def peaks(share: float) -> tuple[float, float]:
        """By how much the peak going up is higher, and its rise with the share: the weights' torque at the peaks."""
        tops = pieces.tops((of_rod + share * of_weights)[np.newaxis])
        up, down = highest(tops, is_up), highest(tops, ~is_up)
        # Within a stroke a peak moves to where it changes nothing.
        at_up, at_down = integral_motion(pieces.cut, of_weights, np.concatenate([up.angle, down.angle]))[0].first
        return float(up.value[0] - down.value[0]), float(at_up - at_down)

    most = 4 * float(np.max(np.abs(of_rod)) / np.max(np.abs(of_weights)))
    share = 1.0
    for _trial in range(_MOST_TRIALS):
        higher, rise = peaks(share)
        if not abs(rise) > 0 or not 0 <= share <= most:
            break
        move = -higher / rise
        share += move
        if abs(move) <= _SETTLED * abs(share):
            return share
    # Peaks that change places with the share are searched for.
    return float(
        bracketed_roots(lambda shares: np.array([peaks(one)[0] for one in shares]), *np.array([[0.0], [most]]))[0]
    )
