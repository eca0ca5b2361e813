"""The same mechanisms in pylinkage, compiled to its solver's arrays, with velocities and accelerations.

Its crank steps before it solves, so it starts one step behind zero; after a turn it stands there again, and the next
call repeats the turn. With ω = 1 and α = 0 its velocities and accelerations are the derivatives by the crank angle.
It finds points only: no angles of links, nor their derivatives.
"""

from math import tau

from pylinkage.actuators import Crank
from pylinkage.components import Ground
from pylinkage.dyads import RRPDyad, RRRDyad
from pylinkage.simulation import Linkage


def slider_crank(n, crank_radius, rod_length, offset):
    """Linkage of n steps a turn; crank pin and slider are its last two components."""
    shaft, near, far = Ground(0.0, 0.0), Ground(0.0, offset), Ground(1.0, offset)
    crank = _crank(shaft, crank_radius, n)
    slider = RRPDyad(crank.output, near, far, distance=rod_length, x=crank_radius + rod_length, y=offset)
    return _compiled([shaft, near, far, crank, slider], crank)


def crank_rocker(n, crank_radius, rod_length, rocker_length, ground_length, side):
    """Linkage of n steps a turn; crank pin and joint are its last two components."""
    shaft, pivot = Ground(0.0, 0.0), Ground(ground_length, 0.0)
    crank = _crank(shaft, crank_radius, n)
    # It takes the solution nearest to the last one, so the first place needs only the right side.
    x, y = 0.5 * ground_length, side * rod_length
    rocker = RRRDyad(crank.output, pivot, distance1=rod_length, distance2=rocker_length, x=x, y=y)
    return _compiled([shaft, pivot, crank, rocker], crank)


def _crank(shaft, radius, n):
    return Crank(shaft, radius, angular_velocity=tau / n, initial_angle=-tau / n)


def _compiled(components, crank):
    linkage = Linkage(components)
    linkage.compile()
    linkage.set_input_velocity(crank, omega=1.0, alpha=0.0)
    return linkage


def columns(simulated):
    """Crank pin and output as the first columns of `by_hand`: (x, x', x'', y, y', y'') of each."""
    return [order[:, component, axis] for component in (-2, -1) for axis in (0, 1) for order in simulated]
