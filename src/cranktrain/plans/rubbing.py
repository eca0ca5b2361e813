"""Forces of friction of one mechanism, taken from the reactions in its guides and slots."""

from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np

from cranktrain.linkage.forces import Wrench, handed_back
from cranktrain.mechanisms.dynamics import FRAME, Contact
from cranktrain.motion import ZERO, Array, Coefficient, Link, Point
from cranktrain.plans.acting import LoadedMechanism
from cranktrain.plans.vectors import in_plane, turned_left

_STANDING = 1e-12
"""Of the crank pin's velocity: what slides less than this stands still, and its friction does no work."""


class Rubbing(NamedTuple):
    """Friction on one link of a mechanism at one crank angle, in the mechanism's axes.

    Attributes
    ----------
    on, by : str
        The link, and the one or the frame that rubs on it.
    pin : str
        Where it acts; with a prime where the link's own point there is not the pin, but passes under it.
    wrench : Wrench
        About the link's first pin, shape (1,).
    velocity : Array, shape (2,)
        Of the link's point there, by the crank angle. [m/rad]
    """

    on: str
    by: str
    pin: str
    wrench: Wrench
    velocity: Array


def friction_on_links(one: LoadedMechanism) -> Iterator[Rubbing]:
    """Friction on the links of a mechanism at one crank angle.

    Parameters
    ----------
    one : LoadedMechanism

    Yields
    ------
    Rubbing
        On both links that rub on one another, of the machine's exact reactions: a master's guide bears its slaves, too.

    Notes
    -----
    Friction is what a reaction has along the relative velocity of the two links. docs/theory/forces, eq. (13.9).
    """
    if not any(np.any(friction.coefficient) for friction in one.solved.conditions.friction):
        return
    links = one.dynamics.by_link(one.links)
    pins = one.place.kind.drawing(one.angle + one.place.phase, one.place.geometry).pins
    fastest = max(float(np.hypot(*in_plane(pin).first)) for pin in pins.values())
    for contact in one.dynamics.contacts:
        yield from _of_contact(one, contact, links, pins[contact.pin], fastest)


def _of_contact(
    one: LoadedMechanism, contact: Contact, links: Mapping[str, Link], pin: Point, fastest: float
) -> Iterator[Rubbing]:
    """Friction of one contact on its two links; nothing where they do not slide."""
    reaction = next(reaction for reaction in one.dynamics.reactions if reaction.name == contact.joint)
    wrench = one.dynamics.by_joint(one.solved.forces.joints)[contact.joint]
    place = in_plane(pin)
    on, by = (_carried(links.get(body), place) for body in (reaction.on, reaction.by))
    rate = float(np.hypot(*(on - by)))
    if rate <= _STANDING * fastest:
        return
    along = (on - by) / rate
    force = np.ravel([wrench.x, wrench.y])
    drag = float(along @ force) * along
    bodies = ((reaction.on, reaction.by, drag, on), (reaction.by, reaction.on, -drag, by))
    for body, other, value, velocity in bodies:
        if body != FRAME and np.any(value):
            is_pin = np.hypot(*(velocity - place.first)) <= _STANDING * fastest
            name = contact.pin if is_pin else f"{contact.pin}'"
            acting = handed_back(links[body], pin, Wrench(-value[:1], -value[1:], ZERO))
            yield Rubbing(body, other, name, acting, velocity)


def _carried(link: Link | None, pin: Coefficient) -> Array:
    """Velocity of a link's point at a pin; the frame has none. [m/rad]"""
    if link is None:
        return np.zeros(2)
    origin = in_plane(link.origin)
    return origin.first + np.ravel(link.angle.first)[0] * turned_left(pin.value - origin.value)
