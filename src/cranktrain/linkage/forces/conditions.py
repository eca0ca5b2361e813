"""Under what a mechanism works: how its crank turns, gravity, friction; and what a link bears then."""

from typing import NamedTuple

from cranktrain.linkage.forces.body import Body, Drive, Gravity, applied
from cranktrain.linkage.forces.wrench import Wrench, added
from cranktrain.motion import ONE, ZERO, Array, Link


class Friction(NamedTuple):
    """Coulomb friction of a slider in its guide: coefficient μ, and sense: the sign of the slider's velocity.

    Where the slider stands still its friction jumps: whoever wants the values on both sides asks with +1 and with −1.
    Of the guide, per_length is 1/b [1/m], 0 where no length is known and moments count for nothing; middle is where its
    middle lies from the slider's pin, along the guide [m].
    """

    coefficient: Array
    sense: Array
    per_length: Array = ZERO
    middle: Array = ZERO


class Conditions(NamedTuple):
    """How the crank turns, gravity in the mechanism's axes, friction of each of its sliders."""

    drive: Drive
    gravity: Gravity
    friction: tuple[Friction, ...]


NO_FRICTION = Friction(ZERO, ONE)
"""A slider without friction."""


def borne(link: Link, body: Body, load: Wrench, conditions: Conditions) -> Wrench:
    """All that acts on a link but its joints: load, weight, inertia."""
    return added(applied(link, body, conditions.drive, conditions.gravity), load)
