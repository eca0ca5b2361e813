"""Under what a mechanism works: how its crank turns, gravity, friction; and what a link bears then."""

from typing import NamedTuple

import numpy as np

from cranktrain.linkage.forces.body import Body, Drive, Gravity, applied
from cranktrain.linkage.forces.wrench import Wrench, added
from cranktrain.motion import Array, Link, single


class Friction(NamedTuple):
    """Coulomb friction of a slider in its guide: coefficient μ, and sense: the sign of the slider's velocity.

    Where the slider stands still its friction jumps: whoever wants the values on both sides asks with +1 and with −1.
    """

    coefficient: Array
    sense: Array


class Conditions(NamedTuple):
    """How the crank turns, gravity in the mechanism's axes, friction of each of its sliders."""

    drive: Drive
    gravity: Gravity
    friction: tuple[Friction, ...]


NO_FRICTION = Friction(single(0.0), single(1.0))
"""A slider without friction."""


def borne(link: Link, body: Body, load: Wrench, conditions: Conditions) -> Wrench:
    """All that acts on a link but its joints: load, weight, inertia."""
    return added(applied(link, body, conditions.drive, conditions.gravity), load)


def pressed(frictionless: Array, lever: Array, friction: Friction) -> Array:
    """Normal force N of a guide where friction f = −μσ|N| adds lever·f to it; NaN where the guide wedges. [N]

    N = N₀ − k|N| with k = μσ·lever has for |k| < 1 one solution, of the sign of N₀, and for |k| ≥ 1 two or none;
    docs/theory/forces, eqs. (13.9) and (13.10).
    """
    slope = friction.coefficient * friction.sense * lever
    # 0 where friction lets the slider go, NaN where it is too much.
    held = 0.0 * np.sqrt(1.0 - slope * slope)
    return frictionless / (1.0 + slope * np.sign(frictionless)) + held


def dragged(normal: Array, friction: Friction) -> Array:
    """Force of friction on a slider, against its motion. [N]"""
    return -(friction.coefficient * friction.sense) * np.abs(normal)
