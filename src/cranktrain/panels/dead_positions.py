"""Where a machine's output turns back, at which crank angles its drawing has ghosts."""

import numpy as np

from cranktrain.layout.places import PlacedMechanism
from cranktrain.machine import Machine
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import turn_grid
from cranktrain.numerics.extremes import turning_points
from cranktrain.plans.found_again import found_again
from cranktrain.plans.placement import motion_of_output
from cranktrain.quantities import shown

_EVENLY = 6
"""So many positions of a turn stand for those of a mechanism that does not turn all round."""


def dead_positions(machine: Machine, place: PlacedMechanism) -> Array:
    """Give the crank angles at which a mechanism's output turns back.

    Parameters
    ----------
    machine : Machine
    place : PlacedMechanism

    Returns
    -------
    Array, shape (2,) or (6,)
        As the machine shows them, within a turn [deg]: farthest and nearest of a slider, largest and smallest angle of
        a rocker; six even positions where the links do not close all round.
    """
    return found_again(machine, _positions, place, machine.zero)


def _positions(place: PlacedMechanism, zero: Array) -> Array:
    """Find them, from φ where the shown crank angle is 0. [rad]"""

    def output(angle: Array) -> Coefficient:
        """Give the output at any angles, which are one design's."""
        found = motion_of_output(place, zero, np.ravel(angle))
        return Coefficient(*(np.broadcast_to(part, np.size(angle)).reshape(np.shape(angle)) for part in found))

    samples = output(turn_grid()).value
    ends = turning_points(output, samples)
    angles = np.concatenate([ends.largest.angle, ends.smallest.angle])
    if not np.all(np.isfinite([*samples, *angles])):
        return np.arange(0.0, 360.0, 360.0 / _EVENLY)
    return np.mod(shown(angles, "deg"), 360.0)
