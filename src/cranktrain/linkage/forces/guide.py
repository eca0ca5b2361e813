"""Guides: what their two edges press on what slides in them, with the friction that this makes."""

from typing import NamedTuple

import numpy as np

from cranktrain.linkage.forces.conditions import Friction
from cranktrain.motion import Array


class Guided(NamedTuple):
    """What a guide bears where nothing rubs, and what each newton of friction along it adds.

    normal: to the left [N]; moment: about the pin [N·m]; lever: of the normal force [1]; arm: of the moment [m].
    """

    normal: Array
    moment: Array
    lever: Array
    arm: Array


class EdgeForces(NamedTuple):
    """Normal forces of a guide's two edges, to the left: of the one that lies ahead along it, of the other. [N]"""

    ahead: Array
    behind: Array


def edge_forces(normal: Array, moment: Array, per_length: Array, middle: Array) -> EdgeForces:
    """Forces of the edges that together are a normal force and a moment about the pin.

    N± = N/2 ± (C − cN)/b; docs/theory/forces, eq. (13.43).

    Parameters
    ----------
    normal : Array. [N]
    moment : Array. [N·m]
    per_length : Array
        1/b. [1/m]
    middle : Array
        Where the guide's middle lies from the pin, along the guide. [m]

    Returns
    -------
    EdgeForces

    Examples
    --------
    Pressed at its very end, a guide bears with that edge alone.

    >>> edge_forces(600.0, 600.0 * 0.05, 1 / 0.1, 0.0)
    EdgeForces(ahead=600.0, behind=0.0)
    """
    couple = (moment - middle * normal) * per_length
    return EdgeForces(0.5 * normal + couple, 0.5 * normal - couple)


def friction_force(guided: Guided, friction: Friction) -> Array:
    """Force of friction on a slider, against its motion, from the sum of what both edges press. [N]

    That is max(|N|, 2|C − cN|/b), where friction has its part in it: both numbers are linear in the sum itself, each
    alone has one solution, and the greater of the two is the answer. NaN where the guide wedges: where there are loads
    for which two sums would do, or none. docs/theory/forces, eqs. (13.44) and (13.45).
    """
    rub = friction.coefficient * friction.sense
    doubled = 2.0 * friction.per_length
    slope = rub * guided.lever
    turning = (rub * doubled) * (guided.arm - friction.middle * guided.lever)
    # 0 where friction lets the slider go, NaN where it is too much.
    held = 0.0 * np.sqrt(1.0 - np.maximum(slope * slope, turning * turning))
    overturning = doubled * (guided.moment - friction.middle * guided.normal)
    pressed = np.maximum(_pressing_alone(guided.normal, slope), _pressing_alone(overturning, turning)) + held
    return -rub * pressed


def _pressing_alone(frictionless: Array, slope: Array) -> Array:
    """|N| of N = N₀ − k|N|, which for |k| < 1 has the sign of N₀; docs/theory/forces, eqs. (13.9) and (13.10)."""
    return np.abs(frictionless) / (1.0 + slope * np.sign(frictionless))
