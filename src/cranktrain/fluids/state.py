"""The state of a working chamber that a gas model needs: volumes, which way the volume goes, which turn it is."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array, Coefficient, chosen

_STANDSTILL = 1e-11
"""|V′| of a volume at rest, in parts of its swing: rounding moves a dead centre by some 1e-15 rad."""
_BETWEEN_CYCLES = 3 * np.pi
"""Tells the two turns of a four-stroke from the one of a two-stroke. [rad]"""


class ChamberState(NamedTuple):
    """A working chamber at each crank angle, shapes (..., n) or broadcastable to it.

    Attributes
    ----------
    volume : Array [m³]
    smallest, largest : Array
        At the true dead centres. [m³]
    sense : Array
        +1 where the volume grows, −1 where it shrinks; at a dead centre as just after it.
    turn : Array
        +1 in the working turn, compression and expansion; −1 in the turn of gas exchange.
    angle_from_firing : Array
        Crank angle since the chamber's nominal firing; any multiple of the cycle may be added. [rad]
    """

    volume: Array
    smallest: Array
    largest: Array
    sense: Array
    turn: Array
    angle_from_firing: Array


class VolumeLimits(NamedTuple):
    """Smallest and largest volume of a chamber, at its true dead centres. [m³]"""

    smallest: Array
    largest: Array


def chamber_state(volume: Coefficient, limits: VolumeLimits, angle_from_firing: Array, cycle: Array) -> ChamberState:
    """State of a chamber from its motion: what a gas model takes.

    Parameters
    ----------
    volume : Coefficient, shape (..., n)
        With its derivatives by the crank angle. [m³, m³/rad, m³/rad²]
    limits : VolumeLimits, fields broadcastable to (..., 1)
    angle_from_firing : Array, shape (..., n)
        Since the chamber's own nominal firing: of a chamber on the crank's side half a turn after its piston's. [rad]
    cycle : Array, broadcastable
        2π of a two-stroke, 4π of a four-stroke. [rad]

    Returns
    -------
    ChamberState, shape (..., n)

    Notes
    -----
    Which way the volume goes is the sign of V′, and at a dead centre that of V″. In a four-stroke the turns meet at a
    *true* bottom dead centre, which an offset moves away from 180°: within 90° of it the stroke says which turn it is,
    elsewhere the angle does. docs/theory/gas, eqs. (14.1) and (14.2).
    """
    swing = limits.largest - limits.smallest
    is_at_rest = np.abs(volume.first) <= _STANDSTILL * swing
    sense = chosen(chosen(is_at_rest, volume.second, volume.first) > 0, 1.0, -1.0)
    half = angle_from_firing / 2
    cos = np.cos(half)
    sin = np.sin(half)
    near_top = chosen(cos > 0, 1.0, -1.0)
    near_bottom = chosen(sin > 0, sense, -sense)
    # Within 90° of firing cos φ = cos² ½φ − sin² ½φ is positive.
    turn = chosen(cos * cos >= sin * sin, near_top, near_bottom)
    return ChamberState(
        volume.value,
        limits.smallest,
        limits.largest,
        sense,
        chosen(cycle > _BETWEEN_CYCLES, turn, 1.0),
        angle_from_firing,
    )
