"""What the frame bears is the mechanism's momentum, differentiated: by its Fourier series over the turn.

Constant speed, no loads: nothing but the frame acts from outside. The links close with five per cent to spare.
"""

import numpy as np
import pytest
from tests.exact.test_kind_forces import GEOMETRIES, LINKS, N, circumstances
from tests.virtual_work import torque_of_work

from cranktrain.linkage import LinkPoint, Pin, point
from cranktrain.linkage.forces import Drive, Gravity, Wrench, momentum
from cranktrain.mechanisms import KINDS
from cranktrain.mechanisms.chain.forces import chain_dynamics, chain_links
from cranktrain.mechanisms.chain.gaps import chain_gap
from cranktrain.mechanisms.chain.kinematics import chain_motion
from cranktrain.mechanisms.chain.steps import (
    ChainSize,
    Coordinates,
    CrankSize,
    PinStep,
    PointStep,
    SlideSize,
    SlideStep,
    Structure,
    SwivelSize,
    SwivelStep,
    TrammelSize,
    TrammelStep,
    YokeSize,
    YokeStep,
)
from cranktrain.mechanisms.dynamics import FRAME
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank
from cranktrain.numerics import spectral_derivative, turn_grid

PHI = turn_grid(1440)
CLOSE = 1e-11
"""Of the largest force over the turn, as asked of a machine with that margin."""


def momentum_change(links, bodies, speed):
    """Change of momentum in time, x and y."""
    change = 0.0
    for link, body in zip(links, bodies, strict=True):
        centre = point(link, LinkPoint(np.hypot(body.along, body.across), np.arctan2(body.across, body.along)))
        change = change + body.mass * np.array(np.broadcast_arrays(centre.x.first, centre.y.first))
    return speed**2 * spectral_derivative(change)


def steady(random, dynamics, senses):
    """Any bodies, no loads, constant speed, no gravity."""
    bodies, loads, conditions = circumstances(random, dynamics, senses, 0.0)
    nothing = Wrench(*3 * [np.zeros((N, 1))])
    drive = Drive(conditions.drive.speed, 0.0 * conditions.drive.speed)
    return bodies, [nothing for _ in loads], conditions._replace(drive=drive, gravity=Gravity(0.0, 0.0))


def of_frame(dynamics, joints):
    """Sum of the frame's forces, x and y."""
    named = zip(dynamics.reactions, joints, strict=True)
    return sum(np.array(np.broadcast_arrays(*wrench[:2])) for joint, wrench in named if joint.by == FRAME)


def assert_borne(total, change):
    apart = np.max(np.abs(total - change), axis=(0, -1))
    assert np.all(apart <= CLOSE * np.max(np.abs(change), axis=(0, -1)))


@pytest.mark.parametrize("name", GEOMETRIES)
def test_kinds(name):
    kind, geometry = KINDS.named(name), GEOMETRIES[name]()
    motion = kind.motion(PHI, geometry)
    bodies, loads, conditions = steady(np.random.default_rng(2), kind.dynamics, [1.0] * len(kind.dynamics.sliding))
    joints = kind.dynamics.forces(motion, geometry, bodies, loads, conditions).joints
    change = momentum_change(LINKS[name](motion, geometry), bodies, conditions.drive.speed)
    assert_borne(of_frame(kind.dynamics, joints), change)


@pytest.mark.parametrize("name", GEOMETRIES)
def test_links_and_their_momentum(name):
    kind, geometry = KINDS.named(name), GEOMETRIES[name]()
    motion = kind.motion(PHI, geometry)
    bodies, _loads, conditions = steady(np.random.default_rng(2), kind.dynamics, [1.0] * len(kind.dynamics.sliding))
    links = kind.dynamics.links(motion, geometry)
    assert len(links) == len(kind.dynamics.moving)
    parts = [momentum(*each) for each in zip(links, bodies, strict=True)]
    change = conditions.drive.speed**2 * spectral_derivative(
        np.array([sum(p.x for p in parts), sum(p.y for p in parts)])
    )
    expected = momentum_change(LINKS[name](motion, geometry), bodies, conditions.drive.speed)
    np.testing.assert_allclose(change, expected, atol=1e-10 * np.max(np.abs(expected)))
    # about the origin: of each centroid's momentum, and of the link's own turning
    for link, body, part in zip(links, bodies, parts, strict=True):
        centre = point(link, LinkPoint(np.hypot(body.along, body.across), np.arctan2(body.across, body.along)))
        orbit = body.mass * (centre.x.value * centre.y.first - centre.y.value * centre.x.first)
        spin = body.inertia * link.angle.first
        scale = np.max(np.abs(orbit) + np.abs(spin))
        np.testing.assert_allclose(part.moment, orbit + spin, atol=1e-13 * scale)


def test_a_rod_hardly_longer_than_the_crank():
    """λ = 0.93: the rod's angle swings by 137°."""
    kind, geometry = KINDS.named("slider_crank"), SliderCrank(*(np.full((N, 1), x) for x in (0.093, 0.1, 0.0)))
    motion = kind.motion(PHI, geometry)
    bodies, loads, conditions = steady(np.random.default_rng(2), kind.dynamics, [1.0])
    forces = kind.dynamics.forces(motion, geometry, bodies, loads, conditions)
    change = momentum_change(LINKS["slider_crank"](motion, geometry), bodies, conditions.drive.speed)
    assert_borne(of_frame(kind.dynamics, forces.joints), change)
    by_work = torque_of_work(kind.dynamics, motion, geometry, bodies, loads, conditions, forces)
    scale = np.max(np.abs(by_work), axis=-1, keepdims=True)
    assert np.max(np.abs(forces.driving_torque - by_work) / scale) < 1e-12


CHAIN = Structure(
    ("main", "second"),
    ("C", "D"),
    (
        PinStep("main.pin", "C", "rod", "rocker", "knee"),
        PointStep("rocker", "horn"),
        SlideStep("horn", "link", "ram", "C"),
        SwivelStep("second.pin", "D", "lever", "block"),
        TrammelStep("lever", "valve", "O"),
        YokeStep("ram.pin", "feed", "D"),
        PointStep("lever", "tip"),
        PinStep("tip", "C", "arm", "bell", "end"),
    ),
    "ram",
)
"""All groups, one on the other: a toggle whose rocker drives a ram, on it a yoke; a slotted lever with all on it."""


def test_a_chain_of_all_groups():
    random = np.random.default_rng(4)

    def about(value):
        return value * (1 + random.uniform(-0.05, 0.05, (N, 1)))

    zero = np.zeros((N, 1))
    size = ChainSize(
        (CrankSize(about(0.1), zero), CrankSize(about(0.08), about(1.0))),
        (Coordinates(about(0.7), about(0.3)), Coordinates(about(-0.1), about(-0.5))),
        (
            Pin(about(0.7), about(0.5), zero + 1),
            LinkPoint(about(0.6), about(0.4)),
            SlideSize(about(0.9), zero + 1, about(0.3), about(0.1)),
            SwivelSize(about(0.05), zero + 1, zero),
            TrammelSize(about(0.02), about(0.2), about(0.1), zero + 1),
            YokeSize(about(1.2), about(-0.6), about(0.2)),
            LinkPoint(about(0.7), about(0.1)),
            Pin(about(0.8), about(0.9), zero - 1),
        ),
    )
    assert np.all(chain_gap(CHAIN, PHI, size) > 0.02)
    motion, dynamics = chain_motion(CHAIN, PHI, size), chain_dynamics(CHAIN, lambda size: size)
    bodies, loads, conditions = steady(random, dynamics, [1.0] * len(dynamics.sliding))
    forces = dynamics.forces(motion, size, tuple(bodies), tuple(loads), conditions)
    change = momentum_change(chain_links(CHAIN, motion, size).values(), bodies, conditions.drive.speed)
    assert_borne(of_frame(dynamics, forces.joints), change)
    by_work = torque_of_work(dynamics, motion, size, tuple(bodies), tuple(loads), conditions, forces)
    scale = np.max(np.abs(by_work), axis=-1, keepdims=True)
    assert np.max(np.abs(forces.driving_torque - by_work) / scale) < 1e-12
