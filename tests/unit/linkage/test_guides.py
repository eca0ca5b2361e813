"""Guides with two edges, against equilibrium with a force at each edge, for all choices of signs."""

import itertools

import numpy as np
import pytest

from cranktrain.linkage import (
    AHEAD,
    GUIDE,
    ROD,
    Crank,
    Leg,
    LinkPoint,
    OnLine,
    Slide,
    Swivel,
    Triad,
    TriadEnds,
    Yoke,
    crank,
    fixed,
    fixed_guide,
    rod_end,
    slide,
)
from cranktrain.linkage.forces import (
    NOTHING,
    CrossingFriction,
    CrossingLoads,
    Friction,
    SlideLoads,
    SwivelLoads,
    TriadFriction,
    TriadLoads,
    Wrench,
    edge_forces,
    slide_reactions,
    swivel_reactions,
    trammel_reactions,
    triad_reactions_with_friction,
    yoke_reactions,
)


def guide_friction(random, most=0.4):
    """Any friction, and a guide of any length about a pin within it or beyond its edges."""
    return Friction(
        random.uniform(0, most), random.choice([-1.0, 1.0]), random.uniform(1, 9), random.uniform(-0.4, 0.4)
    )


def edges(friction, normal, along):
    """Columns of a guide's two edges, ahead and behind: force of unit size and its friction, moments about the pin."""
    half = 0.5 / friction.per_length
    places = friction.middle + half, friction.middle - half
    rub = -friction.coefficient * friction.sense
    return [([*normal, place], [*(rub * part for part in along), 0.0]) for place in places]


def agreeing(columns, load):
    """The one set of forces that holds a load and agrees with the signs for which it leans; None where that is not so.

    It is one for every load where all choices have determinants of one sign.
    """
    normals, leans = (np.array(part, dtype=float).T for part in zip(*columns, strict=True))
    found, determinants = [], []
    for signs in itertools.product([-1.0, 1.0], repeat=len(load)):
        matrix = normals + leans * signs
        determinants.append(np.linalg.det(matrix))
        forces = np.linalg.solve(matrix, -np.asarray(load))
        if np.all(forces * signs >= 0):
            found.append(forces)
    if not (np.all(np.array(determinants) > 0) or np.all(np.array(determinants) < 0)):
        return None
    assert np.ptp(found, axis=0) == pytest.approx(0.0, abs=1e-9)
    return found[0]


def of_edges(wrench, friction, along=(1.0, 0.0)):
    """Forces of both edges from a guide's reaction, along a guide's direction."""
    normal = along[0] * wrench.y - along[1] * wrench.x
    return edge_forces(normal, wrench.moment, friction.per_length, friction.middle)


def same(found, expected):
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-11 * np.max(np.abs(expected)))


def is_wedged(*wrenches):
    return np.all(np.isnan([[wrench.x, wrench.y] for wrench in wrenches]))


@pytest.mark.parametrize("seed", range(200))
def test_slide(seed):
    """A rod that bears nothing pushes along itself; the slider is held by it and by two edges."""
    random = np.random.default_rng(seed)
    friction, load = guide_friction(random, 1.2), random.uniform(-9, 9, 3)
    rod = slide(crank(random.uniform(0, 6), Crank(0.3)), Slide(0.35, 0.0, AHEAD)).rod
    expected = agreeing([([rod.cos, rod.sin, 0.0], [0.0, 0.0, 0.0]), *edges(friction, (0, 1), (1, 0))], load)
    with np.errstate(invalid="ignore"):
        found = slide_reactions(rod, Slide(0.35, 0.0, AHEAD), SlideLoads(NOTHING, Wrench(*load)), friction)
    if expected is None:
        assert is_wedged(found.guide, found.joint, found.pin)
        return
    same([found.joint.x * rod.cos + found.joint.y * rod.sin, *of_edges(found.guide, friction)], expected)
    assert found.guide.x == pytest.approx(
        -friction.coefficient * friction.sense * np.sum(np.abs(expected[1:])), rel=1e-12, abs=1e-12
    )


@pytest.mark.parametrize("seed", range(200))
def test_yoke(seed):
    """The block pushes where it stands along the slot, and rubs there too: eight choices of signs."""
    random = np.random.default_rng(seed)
    friction = CrossingFriction(guide_friction(random), Friction(random.uniform(0, 0.4), random.choice([-1.0, 1.0])))
    angle, place, load = random.uniform(-3, 3), random.uniform(-0.2, 0.2), random.uniform(-9, 9, 3)
    cos, sin = np.cos(angle), np.sin(angle)
    rub = friction.slot.coefficient * friction.slot.sense
    slot = [-sin, cos, place], [rub * cos, rub * sin, 0.0]
    expected = agreeing([slot, *edges(friction.guide, (0, 1), (1, 0))], load)
    with np.errstate(invalid="ignore"):
        found = yoke_reactions(place, Yoke(0.0, angle), CrossingLoads(NOTHING, Wrench(*load)), friction)
    if expected is None:
        assert is_wedged(found.guide, found.slider)
        return
    same([cos * found.slider.y - sin * found.slider.x, *of_edges(found.guide, friction.guide)], expected)


@pytest.mark.parametrize("seed", range(100))
def test_trammel(seed):
    """As a yoke whose block is the slider's: friction of the slot is against it, at the pin."""
    random = np.random.default_rng(seed)
    friction = CrossingFriction(guide_friction(random), Friction(random.uniform(0, 0.4), random.choice([-1.0, 1.0])))
    angle, load = random.uniform(-3, 3), random.uniform(-9, 9, 3)
    link = fixed_guide(0.1, 0.2, angle)
    rub = -friction.slot.coefficient * friction.slot.sense
    slot = [-link.sin, link.cos, 0.0], [rub * link.cos, rub * link.sin, 0.0]
    expected = agreeing([slot, *edges(friction.guide, (0, 1), (1, 0))], load)
    with np.errstate(invalid="ignore"):
        found = trammel_reactions(link, CrossingLoads(NOTHING, Wrench(*load)), friction)
    if expected is None:
        assert is_wedged(found.guide, found.block)
        return
    same([link.cos * found.block.y - link.sin * found.block.x, *of_edges(found.guide, friction.guide)], expected)


@pytest.mark.parametrize("seed", range(200))
def test_swivel(seed):
    """Moments of the guide about its pivot, and of the slider about its pin: the two edges are all that both have."""
    random = np.random.default_rng(seed)
    friction, angle, offset = guide_friction(random, 0.8), random.uniform(-3, 3), random.uniform(-0.2, 0.2)
    reach, (on_slider, on_guide) = random.uniform(0.1, 0.6), random.uniform(-9, 9, 2)
    guide = fixed_guide(0.1, -0.2, angle)
    pin = fixed(0.1 + reach * guide.cos - offset * guide.sin, -0.2 + reach * guide.sin + offset * guide.cos)
    columns = []
    for (unit, _lean), _ in zip(edges(friction, (0, 1), (1, 0)), range(2), strict=True):
        # On the guide, where the slider's motion drags it along: at the offset from the pivot.
        drag = friction.coefficient * friction.sense
        columns.append(([reach + unit[2], -unit[2]], [-offset * drag, 0.0]))
    expected = agreeing(columns, [on_guide, on_slider])
    loads = SwivelLoads(Wrench(0.0, 0.0, on_slider), Wrench(0.0, 0.0, on_guide))
    with np.errstate(invalid="ignore"):
        found = swivel_reactions(OnLine(guide, pin), Swivel(offset, AHEAD), loads, friction)
    if expected is None:
        assert is_wedged(found.slider, found.pin, found.pivot)
        return
    same(of_edges(found.slider, friction, (guide.cos, guide.sin)), expected)


@pytest.mark.parametrize("kinds", [kinds for kinds in itertools.product([ROD, GUIDE], repeat=3) if GUIDE in kinds])
@pytest.mark.parametrize("seed", range(25))
def test_triad(kinds, seed):
    """Link and blocks, each of which its line holds with two edges: up to 64 choices of signs."""
    random = np.random.default_rng(seed)
    link = fixed_guide(*random.uniform(-1, 1, 2), random.uniform(-3, 3))
    ends = TriadEnds(
        *(
            fixed_guide(*random.uniform(-2, 2, 2), random.uniform(-3, 3))
            if kind == GUIDE
            else rod_end(fixed(*random.uniform(-2, 2, 2)))
            for kind in kinds
        )
    )
    legs = Triad(*(Leg(LinkPoint(random.uniform(0.3, 1), random.uniform(-3, 3)), 1.0, kind) for kind in kinds))
    friction = TriadFriction(*(guide_friction(random, 0.3) for _ in range(3)))
    loads = TriadLoads(
        Wrench(*random.uniform(-9, 9, 3)),
        *(Wrench(0.0, 0.0, random.uniform(-3, 3) if kind == GUIDE else 0.0) for kind in kinds),
    )
    columns, blocks = [], [i for i, kind in enumerate(kinds) if kind == GUIDE]
    for i, (kind, end, leg, rub) in enumerate(zip(kinds, ends, legs, friction, strict=True)):
        turn, own = link.angle.value + leg.point.angle, np.zeros(len(blocks))
        arm = leg.point.radius * np.array([np.cos(turn), np.sin(turn)])
        if kind == ROD:
            x, y = (
                link.origin.x.value + arm[0] - end.origin.x.value,
                link.origin.y.value + arm[1] - end.origin.y.value,
            )
            columns.append(([x, y, arm[0] * y - arm[1] * x, *own], np.zeros(3 + len(blocks))))
            continue
        for unit, lean in edges(rub, (-end.sin, end.cos), (end.cos, end.sin)):
            moments = own.copy()
            moments[blocks.index(i)] = unit[2]
            screws = [[*part[:2], arm[0] * part[1] - arm[1] * part[0]] for part in (unit, lean)]
            columns.append(([*screws[0], *moments], [*screws[1], *own]))
    expected = agreeing(columns, [*loads.link, *(loads[1 + i].moment for i in blocks)])
    with np.errstate(invalid="ignore"):
        found = triad_reactions_with_friction(link, ends, legs, loads, friction)
    if expected is None:
        assert is_wedged(*(leg.joint for leg in found))
        return
    at = 0
    largest = np.max(np.abs(expected))
    for kind, end, rub, leg in zip(kinds, ends, friction, found, strict=True):
        if kind == GUIDE:
            np.testing.assert_allclose(
                of_edges(leg.end, rub, (end.cos, end.sin)), expected[at : at + 2], rtol=0, atol=1e-10 * largest
            )
        at += 2 if kind == GUIDE else 1


def test_a_guide_longer_than_any_moment_needs_is_one_without_length():
    load, rod = Wrench(700.0, -90.0, 40.0), slide(crank(0.7, Crank(0.3)), Slide(0.5, 0.0, AHEAD)).rod
    without, long, short = (
        slide_reactions(rod, Slide(0.5, 0.0, AHEAD), SlideLoads(NOTHING, load), Friction(0.2, 1.0, per_length, 0.03))
        for per_length in (0.0, 1e-9, 10.0)
    )
    assert long == without
    assert abs(short.guide.x) > 1.1 * abs(without.guide.x)


def test_a_drawer_sticks_where_its_guide_is_short():
    """A force at a distance t from a guide of length b: friction is 2μt/b of what passes; at 1 nothing passes."""
    yoke, load = Yoke(0.0, np.pi / 2), CrossingLoads(NOTHING, Wrench(500.0, 0.0, 0.0))
    for length in (0.2001, 0.5, 3.0):
        found = yoke_reactions(0.5, yoke, load, CrossingFriction(Friction(0.2, 1.0, 1 / length), Friction(0.0, 1.0)))
        # Along: N₁ = X + f, f = −μ 2tN₁/b.
        assert -found.slider.x == pytest.approx(500.0 / (1 + 2 * 0.2 * 0.5 / length), rel=1e-12)
    with np.errstate(invalid="ignore"):
        stuck = yoke_reactions(0.5, yoke, load, CrossingFriction(Friction(0.2, 1.0, 1 / 0.1999), Friction(0.0, 1.0)))
    assert is_wedged(stuck.guide, stuck.slider)
