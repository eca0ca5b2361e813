"""A machine in a mirror: crank and y the other way round, the same forces mirrored, the torque with the other sign."""

import tomllib

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.linkage.forces import Body, Conditions, Drive, Friction, Gravity, Wrench
from cranktrain.mechanisms import KINDS
from cranktrain.mechanisms.kind import mirrored
from cranktrain.numerics.nested import mapped

PHI = np.linspace(0.1, 6.2, 40)
TURNED = {"y", "across", "moment"}
"""Of bodies, loads, weights and joints' forces what is the other way round where y is reversed."""


def seen_from_behind(parts):
    return mapped(lambda name, value: -value if name.rpartition(".")[2] in TURNED else value, parts)


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
def test_forces_in_a_mirror(kind):
    machine = ct.Machine(**tomllib.loads(kind.example))
    place = next(place for place in machine.places if place.kind.name == kind.name)
    own, geometry, random = place.kind, place.geometry, np.random.default_rng(6)
    bodies = tuple(Body(*random.uniform([1, -0.1, -0.1, 0.01], [4, 0.1, 0.1, 0.1])) for _ in own.dynamics.moving)
    loads = tuple(Wrench(*random.uniform(-90, 90, 3)) for _ in own.dynamics.moving)

    def forces(phi, geometry, bodies, loads, drive, gravity):
        motion = own.motion(phi, geometry)
        senses = [np.sign(own.named(motion, name).first * drive.speed) for name in own.dynamics.sliding]
        friction = tuple(Friction(0.05, sense) for sense in senses)
        acting = bodies, loads, Conditions(drive, gravity, friction)
        return own.dynamics.forces(motion, geometry, *acting)

    gravity = Gravity(-3.0, 9.0)
    one = forces(PHI, geometry, bodies, loads, Drive(40.0, 300.0), gravity)
    theirs = [seen_from_behind(own) for own in (bodies, loads)]
    other = forces(-PHI, mirrored(geometry), *theirs, Drive(-40.0, -300.0), seen_from_behind(gravity))
    for ours, theirs in zip(one.joints, seen_from_behind(other.joints), strict=True):
        np.testing.assert_allclose(ours, theirs, atol=1e-12 * np.max(np.abs(ours)))
    for ours, theirs in zip(one[1:], other[1:], strict=True):
        np.testing.assert_allclose(ours, -theirs, atol=1e-12 * np.max(np.abs(ours)))
