"""A triad's reactions, with legs of every kind, against rigid bodies with joints and multipliers."""

import functools
import itertools

import numpy as np
import pytest
from tests.exact.test_kind_forces import xy
from tests.multibody import FRAME, Multibody

from cranktrain.linkage import (
    GUIDE,
    ROD,
    Crank,
    Leg,
    LinkPoint,
    Pose,
    Triad,
    TriadDriver,
    TriadEnds,
    crank,
    fixed_guide,
    point,
    rod_between,
    rod_end,
    triad,
)
from cranktrain.linkage.forces import (
    Body,
    Conditions,
    Drive,
    Gravity,
    LegReactions,
    TriadLoads,
    Wrench,
    added,
    added_reduced,
    borne,
    crank_link,
    crank_reactions,
    handed_back,
    reduced,
    swivel_slider_link,
    torque_by_work,
    triad_reactions,
)
from cranktrain.linkage.point import fixed
from cranktrain.motion import Link

CLOSE = 1e-12
"""Of the largest force in a joint; some of these links are nearly loose."""


def ends_of(random, kinds, wheel: Link) -> TriadEnds:
    """The first leg is carried by the crank: a rod on its pin, or a guide along it; the others stand still."""
    first = wheel if kinds[0] == GUIDE else rod_end(point(wheel, LinkPoint(0.3, 0.0)))
    places, directions = random.uniform(-2, 2, (2, 2)), random.uniform(-3, 3, 2)
    others = [
        fixed_guide(*place, direction) if kind == GUIDE else rod_end(fixed(*place))
        for kind, place, direction in zip(kinds[1:], places, directions, strict=True)
    ]
    return TriadEnds(first, *others)


def legs_of(random, kinds, ends, pose: Pose) -> Triad:
    """Legs as long as they are between those ends and any points of a link in that pose."""
    legs = []
    for kind, end in zip(kinds, ends, strict=True):
        place = LinkPoint(random.uniform(0.3, 1.0), random.uniform(-3, 3))
        x = pose.x + place.radius * np.cos(pose.angle + place.angle) - end.origin.x.value
        y = pose.y + place.radius * np.sin(pose.angle + place.angle) - end.origin.y.value
        length = end.cos * y - end.sin * x if kind == GUIDE else np.hypot(x, y)
        legs.append(Leg(place, float(length), kind))
    return Triad(*legs)


@pytest.mark.parametrize("kinds", list(itertools.product([ROD, GUIDE], repeat=3)), ids=str)
@pytest.mark.parametrize("seed", range(4))
def test_joints_and_torques(kinds, seed):
    random = np.random.default_rng(seed)
    phi, pose = random.uniform(0, 6), Pose(*random.uniform(-1, 1, 2), random.uniform(-3, 3))
    pin = crank(phi, Crank(0.3))
    wheel = crank_link(pin, Crank(0.3))
    ends = ends_of(random, kinds, wheel)
    geometry = legs_of(random, kinds, ends, pose)
    link = triad(TriadDriver(ends, pose), geometry).link
    places = [point(link, leg.point) for leg in geometry]
    bars = [
        swivel_slider_link(place, end) if kind == GUIDE else rod_between(end.origin, place)
        for kind, end, place in zip(kinds, ends, places, strict=True)
    ]
    links = [wheel, link, *bars]
    bodies = [Body(*random.uniform(0.3, 3, 1), *random.uniform(-0.3, 0.3, 2), random.uniform(0.01, 0.5)) for _ in links]
    loads = [Wrench(*random.uniform(-900, 900, 2), random.uniform(-90, 90)) for _ in links]
    conditions = Conditions(Drive(*random.uniform(-20, 20, 2)), Gravity(*random.uniform(-9, 9, 2)), ())
    on_wheel, *on_group = (borne(*each, conditions) for each in zip(links, bodies, loads, strict=True))
    found = triad_reactions(link, ends, geometry, TriadLoads(*on_group))
    # A guide's block is held where it stands, a rod at its end.
    held_at = places[0] if kinds[0] == GUIDE else bars[0].origin
    shaft = crank_reactions(added(on_wheel, handed_back(wheel, held_at, found.first.end)))
    shares = (reduced(*each, conditions.gravity) for each in zip(links, bodies, loads, strict=True))
    equation = functools.reduce(added_reduced, shares)
    system, joints = Multibody(), {"bearing": shaft.bearing}
    carrier, floating, *legs = (system.body(*each) for each in zip(links, bodies, loads, strict=True))
    system.pin("bearing", carrier, FRAME, (0, 0))
    for i, (kind, leg, end, reaction) in enumerate(zip(kinds, legs, ends, found, strict=True)):
        assert isinstance(reaction, LegReactions)
        other = carrier if i == 0 else FRAME
        joints |= {f"joint {i}": reaction.joint, f"end {i}": reaction.end}
        system.pin(f"joint {i}", floating, leg, xy(places[i]))
        if kind == GUIDE:
            system.line(f"end {i}", leg, other, xy(places[i]), np.arctan2(end.sin, end.cos))
        else:
            system.pin(f"end {i}", leg, other, xy(end.origin))
    system.drive(carrier)
    torques = shaft.driving_torque, torque_by_work(equation, conditions.drive)
    apart, largest = system.compare(joints, torques, conditions)
    assert apart < CLOSE * largest


def test_a_block_where_its_line_begins():
    """The distance from a guide's first pin is not divided by."""
    geometry = Triad(
        Leg(LinkPoint(0.0, 0.0), 0.0, GUIDE), Leg(LinkPoint(1.0, 0.0), 1.0, ROD), Leg(LinkPoint(1.0, 1.0), 1.0, ROD)
    )
    link = fixed_guide(0.0, 0.0, 0.0)
    ends = TriadEnds(fixed_guide(0.0, 0.0, 0.0), rod_end(fixed(1.0, -1.0)), rod_end(fixed(3.0, 1.0)))
    nothing = Wrench(0.0, 0.0, 0.0)
    found = triad_reactions(link, ends, geometry, TriadLoads(Wrench(0.0, -2.0, 0.0), nothing, nothing, nothing))
    assert np.all(np.isfinite([part for leg in found for wrench in leg for part in wrench]))
