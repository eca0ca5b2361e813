"""Way between two dead centres by a crank that turns at a constant speed, as a law."""

import numpy as np

from cranktrain.layout.wish.laws import Law, Moved
from cranktrain.layout.wish.stroke import Output
from cranktrain.layout.wish.turning import TurnOfWish, mirrored
from cranktrain.motion import Array
from cranktrain.numerics import turn_grid
from cranktrain.numerics.harmonics import TURN
from cranktrain.numerics.periodic import fourier_curve, spline_curve


def constant_crank(output: Output, *, is_falling: bool) -> Law:
    """Law of the stroke from the high to the low dead centre, or back.

    Notes
    -----
    x‴ is the slope of the Fourier series of x″, between 720 points of it a spline. docs/theory/servo, eq. (29.7).
    """
    begin, end = (output.high, output.low) if is_falling else (output.low, output.high)
    turned = float(np.mod(end.angle - begin.angle, TURN))
    grid = turn_grid()
    third = spline_curve(fourier_curve(output.motion(grid).second).slope(grid))
    rise = end.position - begin.position

    def way(share: Array) -> Array:
        return (output.motion(begin.angle + turned * share).value - begin.position) / rise

    def shape(share: Array) -> Moved:
        angle = begin.angle + turned * share
        place = output.motion(angle)
        return Moved(
            (place.value - begin.position) / rise,
            place.first * turned / rise,
            place.second * turned**2 / rise,
            third.value(angle) * turned**3 / rise,
        )

    return Law(
        shape,
        way,
        _series(begin.turning, turned, abs(rise)),
        _series(mirrored(end.turning), turned, abs(rise)),
        min(begin.turning.reach, end.turning.reach) / turned,
    )


def _series(turning: TurnOfWish, turned: float, rise: float) -> Array:
    """Share of the way by share of the time, from a dead centre."""
    own = turning.series * (turned / turning.reach) ** np.arange(turning.series.size) * turned**2 / rise
    return np.array([0.0, 0.0, *own])
