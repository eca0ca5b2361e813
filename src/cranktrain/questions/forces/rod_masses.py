"""A rod replaced by point masses: what textbooks do, beside the rigid body that it is."""

from collections.abc import Callable, Mapping
from typing import NamedTuple

import numpy as np

from cranktrain.linkage.forces import Body, Drive, Gravity, Wrench, added, applied
from cranktrain.linkage.vectors import Vector, at_arm, swept
from cranktrain.motion import Array, Link


class TwoMasses(NamedTuple):
    """Masses at the rod's first pin and at its second, with the rod's mass and centroid. [kg]"""

    first: Array
    second: Array


class ThreeMasses(NamedTuple):
    """Masses at the rod's first pin, centroid and second pin, with its inertia too; the middle may be negative. [kg]"""

    first: Array
    middle: Array
    second: Array


def weighed_ends(body: Body, rod_length: Array) -> TwoMasses:
    """Rotating and reciprocating share of a rod: m b/L and m a/L, a = `along`, b = L − a.

    What its ends weigh where it lies on two scales; docs/theory/forces, eq. (13.27). Of a rod whose centroid is beside
    its line, as a master's often is, they are no more than that.
    """
    return TwoMasses(body.mass * ((rod_length - body.along) / rod_length), body.mass * (body.along / rod_length))


def two_masses(body: Body, rod_length: Array) -> TwoMasses:
    """Masses at both pins with the rod's mass and centroid: the rod's shares, as `weighed_ends` has them.

    NaN for a centroid beside the rod's line, which no masses on it can have.
    """
    return weighed_ends(Body(_mass_on_line(body), body.along, body.across, body.inertia), rod_length)


def three_masses(body: Body, rod_length: Array) -> ThreeMasses:
    """Masses that move as the rod does: I/(aL), m − I/(ab), I/(bL).

    NaN for a centroid beside the rod's line, infinite for one in a pin. docs/theory/forces, eq. (13.29).
    """
    mass = _mass_on_line(body)
    rest = rod_length - body.along
    first = body.inertia / (body.along * rod_length)
    second = body.inertia / (rest * rod_length)
    return ThreeMasses(first, mass - body.inertia / (body.along * rest), second)


def excess_inertia(body: Body, rod_length: Array) -> Array:
    """By how much two masses turn harder than the rod: ΔI = m a b − I; docs/theory/forces, eq. (13.28). [kg·m²]"""
    return _mass_on_line(body) * (body.along * (rod_length - body.along)) - body.inertia


def _mass_on_line(body: Body) -> Array:
    """Mass of a body with its centroid on the link's line; NaN otherwise."""
    return body.mass + 0.0 * np.sqrt(-np.abs(body.across))


def by_two_masses(rod: Link, body: Body, rod_length: Array, drive: Drive, gravity: Gravity) -> Wrench:
    """Weight less inertia of a rod, by two masses: force exact, moment not; as `applied`, about its first pin."""
    masses = two_masses(body, rod_length)
    return added(
        _of_first_pin(rod, masses.first, drive, gravity),
        _of_mass(rod, rod_length, masses.second, drive, gravity),
    )


def by_two_masses_and_couple(rod: Link, body: Body, rod_length: Array, drive: Drive, gravity: Gravity) -> Wrench:
    """Weight less inertia of a rod, by two masses and the couple ΔI θ̈ that makes them exact; as `applied`."""
    wrench = by_two_masses(rod, body, rod_length, drive, gravity)
    turning = rod.angle.second * (drive.speed * drive.speed) + rod.angle.first * drive.acceleration
    return Wrench(wrench.x, wrench.y, wrench.moment + excess_inertia(body, rod_length) * turning)


def by_three_masses(rod: Link, body: Body, rod_length: Array, drive: Drive, gravity: Gravity) -> Wrench:
    """Weight less inertia of a rod, by three masses: exact; as `applied`."""
    masses = three_masses(body, rod_length)
    pins = added(
        _of_first_pin(rod, masses.first, drive, gravity),
        _of_mass(rod, rod_length, masses.second, drive, gravity),
    )
    return added(pins, _of_mass(rod, body.along, masses.middle, drive, gravity))


def as_rigid_body(rod: Link, body: Body, rod_length: Array, drive: Drive, gravity: Gravity) -> Wrench:
    """Weight less inertia of a rod as it is; the length plays no part."""
    wrench = applied(rod, body, drive, gravity)
    return Wrench(wrench.x, wrench.y, wrench.moment + 0.0 * rod_length)


def _of_first_pin(rod: Link, mass: Array, drive: Drive, gravity: Gravity) -> Wrench:
    """Weight less inertia of a point mass at the rod's first pin."""
    x = rod.origin.x
    y = rod.origin.y
    force = _of_acceleration(Vector(x.first, y.first), Vector(x.second, y.second), mass, drive, gravity)
    return Wrench(force.x, force.y, 0.0 * force.x)


def _of_mass(rod: Link, along: Array, mass: Array, drive: Drive, gravity: Gravity) -> Wrench:
    """Weight less inertia of a point mass on the rod's line, about its first pin."""
    arm = Vector(along * rod.cos, along * rod.sin)
    v, a = swept(rod.origin, arm, rod.angle)
    return at_arm(arm, _of_acceleration(v, a, mass, drive, gravity))


def _of_acceleration(v: Vector, a: Vector, mass: Array, drive: Drive, gravity: Gravity) -> Vector:
    """Weight less inertia of a point mass, by the derivatives of its place by the crank angle."""
    square = drive.speed * drive.speed
    return Vector(
        mass * (gravity.x - (a.x * square + v.x * drive.acceleration)),
        mass * (gravity.y - (a.y * square + v.y * drive.acceleration)),
    )


ROD_METHODS: Mapping[str, Callable[[Link, Body, Array, Drive, Gravity], Wrench]] = {
    "exact": as_rigid_body,
    "two_masses": by_two_masses,
    "two_masses_and_couple": by_two_masses_and_couple,
    "three_masses": by_three_masses,
}
"""What a rod bears of weight and inertia, by method: the load of a rod without mass."""
