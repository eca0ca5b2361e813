"""Forces of friction of one mechanism, taken from the reactions in its guides and slots."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.linkage.forces import Wrench
from cranktrain.machine import Machine
from cranktrain.mechanisms.dynamics import FRAME, Contact
from cranktrain.motion import Array, Link, Point
from cranktrain.plans.acting import Member, turned_to_machine

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
        About the link's first pin, shape (1, 1).
    velocity : Array, shape (2,)
        Of the link's point there, by the crank angle. [m/rad]
    """

    on: str
    by: str
    pin: str
    wrench: Wrench
    velocity: Array


def friction_on_links(one: Member) -> Iterator[Rubbing]:
    """Friction on the links of a mechanism at one crank angle.

    Parameters
    ----------
    one : Member
        At one angle.

    Yields
    ------
    Rubbing
        On both links that rub on one another, of the machine's exact reactions: a master's guide bears its slaves, too.

    Notes
    -----
    Friction is what a reaction has along the relative velocity of the two links. docs/theory/forces, eq. (13.9).
    """
    coefficients = one.loaded.masses.batches[one.batch].friction
    links = one.dynamics.by_link(one.dynamics.links(one.motion, one.size))
    if not any(np.any(coefficient) for coefficient in coefficients):
        return
    batch = one.loaded.mechanisms.batches[one.batch]
    joints = one.loaded.solved(one.angle)[one.batch].forces.joints
    pins = one.place.kind.drawing(one.angle + batch.members.phase[0, one.member], one.place.geometry).pins
    fastest = max(float(np.hypot(*_velocity(pin))) for pin in pins.values())
    for contact in one.dynamics.contacts:
        yield from _of_contact(one, contact, joints, links, pins[contact.pin], fastest)


def rubbing_force(machine: Machine, one: Member, rubbing: Rubbing) -> Array:
    """Friction in machine axes, shape (2, 1). [N]"""
    return turned_to_machine(machine, one.place, rubbing.wrench.x[0], rubbing.wrench.y[0])


def _of_contact(
    one: Member, contact: Contact, joints: Sequence[Wrench], links: dict[str, Link], pin: Point, fastest: float
) -> Iterator[Rubbing]:
    """Friction of one contact on its two links; nothing where they do not slide."""
    names = [reaction.name for reaction in one.dynamics.reactions]
    reaction, wrench = one.dynamics.reactions[names.index(contact.joint)], joints[names.index(contact.joint)]
    on, by = (_carried(links.get(body), pin) for body in (reaction.on, reaction.by))
    rate = float(np.hypot(*(on - by)))
    if rate <= _STANDING * fastest:
        return
    along = (on - by) / rate
    force = np.array([one.own(part)[0] for part in (wrench.x, wrench.y)])
    drag = float(along @ force) * along
    bodies = ((reaction.on, reaction.by, drag, on), (reaction.by, reaction.on, -drag, by))
    for body, other, value, velocity in bodies:
        if body != FRAME and np.any(value):
            is_pin = np.hypot(*(velocity - _velocity(pin))) <= _STANDING * fastest
            name = contact.pin if is_pin else f"{contact.pin}'"
            yield Rubbing(body, other, name, _about_origin(links[body], pin, value), velocity)


def _velocity(pin: Point) -> Array:
    """Velocity of a pin by the crank angle; one that stands still may have no axis for it. [m/rad]"""
    return np.array([float(np.ravel(part.first)[0]) for part in pin])


def _carried(link: Link | None, pin: Point) -> Array:
    """Velocity of a link's point at a pin; the frame has none. [m/rad]"""
    if link is None:
        return np.zeros(2)
    x, y = _arm(link, pin)
    turn = float(np.ravel(link.angle.first)[0])
    return _velocity(link.origin) + turn * np.array([-y, x])


def _arm(link: Link, pin: Point) -> tuple[float, float]:
    """Pin from a link's first pin. [m]"""
    x, y = (float(np.ravel(place.value - start.value)[0]) for place, start in zip(pin, link.origin, strict=True))
    return x, y


def _about_origin(link: Link, pin: Point, force: Array) -> Wrench:
    """Force at a pin as a wrench about a link's first pin."""
    x, y = _arm(link, pin)
    parts = (force[0], force[1], x * force[1] - y * force[0])
    return Wrench(*(np.full((1, 1), part) for part in parts))
