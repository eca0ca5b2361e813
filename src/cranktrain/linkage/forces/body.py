"""Bodies: weight and inertia of a rigid link, and its inertia reduced to the crank."""

from typing import NamedTuple

from cranktrain.linkage.forces.wrench import Wrench, work
from cranktrain.linkage.vectors import Vector, cross, dot, rotated, swept
from cranktrain.motion import ZERO, Array, Link


class Body(NamedTuple):
    """Rigid body of a link: mass [kg], centroid and inertia about the centroid [kg·m²].

    The centroid lies `along` the link's direction from its first pin and `across`, to the left of it [m].
    """

    mass: Array
    along: Array
    across: Array
    inertia: Array


class Drive(NamedTuple):
    """How the crank turns: speed ω [rad/s] and acceleration ε [rad/s²]."""

    speed: Array
    acceleration: Array


class Gravity(NamedTuple):
    """Acceleration of a falling body, in the link's axes. [m/s²]"""

    x: Array
    y: Array


WEIGHTLESS = Gravity(ZERO, ZERO)


class ReducedInertia(NamedTuple):
    """Inertia reduced to the crank, J [kg·m²], and its derivative by the crank angle, J′ [kg·m²/rad]."""

    value: Array
    first: Array


class Reduced(NamedTuple):
    """All that an equation of motion needs: reduced inertia, and the loads' and weights' torque on the crank [N·m]."""

    inertia: ReducedInertia
    load: Array


class Momentum(NamedTuple):
    """Momentum of a link [kg·m] and its moment about the axes' origin [kg·m²], for each rad/s of the crank."""

    x: Array
    y: Array
    moment: Array


def _arm(link: Link, body: Body) -> Vector:
    """Centroid from the link's first pin."""
    return rotated(Vector(body.along, body.across), link.cos, link.sin)


def applied(link: Link, body: Body, drive: Drive, gravity: Gravity) -> Wrench:
    """Weight less inertia of a link: what it adds to the loads on itself.

    Parameters
    ----------
    link : Link, coefficients of shape (..., n)
    body : Body, fields broadcastable to (..., 1)
    drive : Drive, fields broadcastable to (..., n)
    gravity : Gravity, fields broadcastable to (..., 1)

    Returns
    -------
    Wrench, shape (..., n)
        About the link's first pin: m(g − a_G) and ρ × m(g − a_G) − Iθ̈. docs/theory/forces, eqs. (13.1) and (13.2).

    Examples
    --------
    A crank of 2 kg, centroid 30 mm out, at 100 rad/s: 600 N outward.

    >>> from cranktrain.linkage import Crank, crank
    >>> from cranktrain.linkage.forces.crank import crank_link
    >>> link = crank_link(crank(0.0, Crank(0.04)), Crank(0.04))
    >>> round(float(applied(link, Body(2.0, 0.03, 0.0, 0.001), Drive(100.0, 0.0), Gravity(0.0, 0.0)).x), 9)
    600.0
    """
    arm = _arm(link, body)
    v, a = swept(link.origin, arm, link.angle)
    square = drive.speed * drive.speed
    force = Vector(
        body.mass * (gravity.x - (a.x * square + v.x * drive.acceleration)),
        body.mass * (gravity.y - (a.y * square + v.y * drive.acceleration)),
    )
    turning = link.angle.second * square + link.angle.first * drive.acceleration
    return Wrench(force.x, force.y, cross(arm, force) - body.inertia * turning)


def weight(link: Link, body: Body, gravity: Gravity) -> Wrench:
    """Weight of a link, about its first pin."""
    arm = _arm(link, body)
    force = Vector(body.mass * gravity.x, body.mass * gravity.y)
    return Wrench(force.x + 0.0 * arm.x, force.y + 0.0 * arm.y, cross(arm, force))


def momentum(link: Link, body: Body) -> Momentum:
    """Momentum of a link and its moment about the origin for each rad/s of the crank.

    Parameters
    ----------
    link : Link, coefficients of shape (..., n)
    body : Body, fields broadcastable to (..., 1)

    Returns
    -------
    Momentum, shape (..., n)
        m r′, and r × m r′ + Iθ′. docs/theory/balance, eqs. (16.15) and (16.16).
    """
    arm = _arm(link, body)
    v, _ = swept(link.origin, arm, link.angle)
    place = Vector(link.origin.x.value + arm.x, link.origin.y.value + arm.y)
    of_mass = Vector(body.mass * v.x, body.mass * v.y)
    return Momentum(of_mass.x, of_mass.y, cross(place, of_mass) + body.inertia * link.angle.first)


def reduced_inertia(link: Link, body: Body) -> ReducedInertia:
    """Inertia of a link reduced to the crank, and its derivative.

    Parameters
    ----------
    link : Link, coefficients of shape (..., n)
    body : Body, fields broadcastable to (..., 1)

    Returns
    -------
    ReducedInertia, shape (..., n)
        J = m r′·r′ + Iθ′², J′ = 2(m r′·r″ + Iθ′θ″). docs/theory/forces, eq. (13.4).
    """
    v, a = swept(link.origin, _arm(link, body), link.angle)
    return _inertia_by_motion(v, a, link, body)


def _inertia_by_motion(v: Vector, a: Vector, link: Link, body: Body) -> ReducedInertia:
    """Reduced inertia by the derivatives of the centroid's place by the crank angle."""
    turn = link.angle.first
    return ReducedInertia(
        body.mass * dot(v, v) + body.inertia * (turn * turn),
        2.0 * (body.mass * dot(v, a) + body.inertia * (turn * link.angle.second)),
    )


def reduced(link: Link, body: Body, load: Wrench, gravity: Gravity) -> Reduced:
    """What one link adds to the equation of motion: its inertia, and the torque of its load and weight on the crank."""
    v, a = swept(link.origin, _arm(link, body), link.angle)
    of_weight = body.mass * (gravity.x * v.x + gravity.y * v.y)
    return Reduced(_inertia_by_motion(v, a, link, body), work(link, load) + of_weight)


def added_reduced(one: Reduced, other: Reduced) -> Reduced:
    """What two links add to the equation of motion."""
    return Reduced(
        ReducedInertia(one.inertia.value + other.inertia.value, one.inertia.first + other.inertia.first),
        one.load + other.load,
    )


def reduced_of(
    links: tuple[Link, ...], bodies: tuple[Body, ...], loads: tuple[Wrench, ...], gravity: Gravity
) -> Reduced:
    """What a mechanism's links add to the equation of motion.

    Parameters
    ----------
    links : tuple of Link, coefficients of shape (..., n)
    bodies : tuple of Body, fields broadcastable to (..., 1)
    loads : tuple of Wrench, shape (..., n)
        On each link, about its first pin.
    gravity : Gravity

    Returns
    -------
    Reduced, shape (..., n)
        Without friction, which depends on how the crank turns. docs/theory/forces, eqs. (13.4) and (13.6).
    """
    found = reduced(links[0], bodies[0], loads[0], gravity)
    for place in range(1, len(links)):
        found = added_reduced(found, reduced(links[place], bodies[place], loads[place], gravity))
    return found


def torque_by_work(equation: Reduced, drive: Drive) -> Array:
    """Driving torque that the motion takes, by virtual work. [N·m]

    M = Jε + ½J′ω² − Q; docs/theory/forces, eq. (13.7).
    """
    inertia = equation.inertia
    square = drive.speed * drive.speed
    return (inertia.value * drive.acceleration + 0.5 * inertia.first * square) - equation.load
