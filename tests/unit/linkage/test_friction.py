"""Friction: normal forces that belong to themselves, against all choices of signs; standstill; wedging."""

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
    Slide,
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
    TriadFriction,
    TriadLoads,
    Turning,
    Wrench,
    crossing_forces,
    slide_reactions,
    triad_reactions,
    triad_reactions_with_friction,
    yoke_reactions,
)
from cranktrain.linkage.forces.guide import Guided, friction_force

GUIDE_ALONE = CrossingFriction(Friction(0.3, 1.0), Friction(0.0, 1.0))


def slid(angle, load, friction, rod_length=0.5):
    rod = slide(crank(angle, Crank(0.3)), Slide(rod_length, 0.0, AHEAD)).rod
    return slide_reactions(rod, Slide(rod_length, 0.0, AHEAD), SlideLoads(NOTHING, Wrench(load, 0.0, 0.0)), friction)


@pytest.mark.parametrize("frictionless", [-70.0, 0.0, 40.0])
@pytest.mark.parametrize("sense", [-1.0, 1.0])
@pytest.mark.parametrize("lever", [-2.0, 0.5, 3.0])
def test_normal_force_belongs_to_its_friction(frictionless, sense, lever):
    friction = Friction(0.3, sense)
    force = friction_force(Guided(frictionless, 5.0, lever, 0.2), friction)
    normal = frictionless + lever * force
    assert force == pytest.approx(-0.3 * sense * abs(normal), rel=1e-15, abs=1e-15)
    assert np.sign(normal) == np.sign(frictionless)


@pytest.mark.parametrize("load", [-1000.0, 1000.0])
def test_friction_is_against_the_motion(load):
    for sense in (-1.0, 1.0):
        guide = slid(0.9, load, Friction(0.1, sense)).guide
        assert guide.x == pytest.approx(-sense * 0.1 * abs(guide.y), rel=1e-15)


def test_both_sides_of_a_standstill():
    """At its dead centre a slider with a weight jumps by 2μN; its rod turns no shaft there."""
    rod = slide(crank(0.0, Crank(0.3)), Slide(0.5, 0.0, AHEAD)).rod
    sides = [
        slide_reactions(
            rod, Slide(0.5, 0.0, AHEAD), SlideLoads(NOTHING, Wrench(-900.0, -50.0, 0.0)), Friction(0.2, sense)
        )
        for sense in (-1.0, 1.0)
    ]
    assert [side.guide.y for side in sides] == pytest.approx([50.0, 50.0])
    assert sides[0].guide.x - sides[1].guide.x == pytest.approx(2 * 0.2 * 50.0)
    assert [side.pin.y for side in sides] == pytest.approx([0.0, 0.0], abs=1e-12)


def test_wedging_is_not_a_number():
    """μ tan β = 1 at β = 45°: a little less friction lets the slider go, a little more does not."""
    angle, rod_length = np.pi / 2, 0.3 * np.sqrt(2)
    for sense in (-1.0, 1.0):
        assert np.isfinite(slid(angle, -100.0, Friction(1.0 - 1e-9, sense), rod_length).guide.y)
        with np.errstate(invalid="ignore"):
            wedged = slid(angle, -100.0, Friction(1.0 + 1e-9, sense), rod_length)
        assert np.all(np.isnan([wedged.guide.x, wedged.guide.y, wedged.joint.y, wedged.pin.x]))


def test_a_yoke_across_its_guide_has_no_friction_from_its_load():
    """Its slot at right angles presses along the guide alone."""
    found = yoke_reactions(0.2, Yoke(0.0, np.pi / 2), CrossingLoads(NOTHING, Wrench(500.0, 0.0, 0.0)), GUIDE_ALONE)
    assert found.guide.x == pytest.approx(0.0, abs=1e-13)
    assert found.slider.x == pytest.approx(-500.0)
    assert found.guide.moment == pytest.approx(-0.2 * 500.0)


def choices(normals, leans, load):
    """All sets of forces that hold a load and agree with the signs for which they lean; and the determinants.

    `normals`, `leans` : columns by contact, of unit forces across and of the friction of a positive one.
    """
    found, determinants = [], []
    for signs in itertools.product([-1.0, 1.0], repeat=len(load)):
        matrix = normals + leans * signs
        forces = np.linalg.solve(matrix, -load)
        determinants.append(np.linalg.det(matrix))
        if np.all(forces * signs >= 0):
            found.append(matrix * forces)
    return found, np.array(determinants)


@pytest.mark.parametrize("seed", range(200))
def test_crossing_against_all_choices_of_signs(seed):
    """Of the four choices one agrees with itself, or the slider wedges and for some load two do, or none."""
    random = np.random.default_rng(seed)
    angle, (x, y), most = random.uniform(-3, 3), random.uniform(-9, 9, 2), random.choice([0.2, 1.5])
    guide, slot = (Friction(random.uniform(0, most), random.choice([-1.0, 1.0])) for _ in range(2))
    cos, sin = np.cos(angle), np.sin(angle)
    normals = np.array([[-sin, 0.0], [cos, 1.0]])
    of_guide, of_slot = guide.coefficient * guide.sense, slot.coefficient * slot.sense
    leans = np.array([[of_slot * cos, -of_guide], [of_slot * sin, 0.0]])
    expected, determinants = choices(normals, leans, np.array([x, y]))
    with np.errstate(invalid="ignore"):
        found = crossing_forces(cos, sin, Wrench(x, y, 0.0), Turning(0.0, 0.0), CrossingFriction(guide, slot))
    if np.all(determinants > 0) or np.all(determinants < 0):
        assert len(expected) == 1
        (pressed_by_slot, held) = expected[0].T
        np.testing.assert_allclose(found, [*pressed_by_slot, *held], rtol=0, atol=1e-13 * np.max(np.abs(expected[0])))
    else:
        assert np.all(np.isnan(found))
        # Beside the ray that two choices share both hold, where their determinants differ in sign.
        rays = itertools.product(itertools.product([-1.0, 1.0], repeat=2), ([1.0, 1e-6], [1e-6, 1.0]))
        loads = [-(normals + leans * signs) @ (np.array(signs) * share) for signs, share in rays]
        assert {len(choices(normals, leans, load)[0]) for load in loads} - {1}


def any_triad(random, kinds):
    """A link at any place and three legs about it, which need not be as long as they say: forces only ask where."""
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
    loads = TriadLoads(*(Wrench(*random.uniform(-9, 9, 3)) for _ in range(4)))
    return link, ends, legs, loads


def determinants_of(link, ends, legs, friction):
    """Of the legs' forces of unit size for all choices of signs, friction leaning with them; with them every arm."""
    turn, units, leans, arms = complex(link.cos, link.sin), [], [], []
    for end, leg, rub in zip(ends, legs, friction, strict=True):
        arm = leg.point.radius * np.exp(1j * leg.point.angle) * turn
        along = complex(end.cos, end.sin)
        far = complex(link.origin.x.value, link.origin.y.value) + arm
        far -= complex(end.origin.x.value, end.origin.y.value)
        forces = 1j * along if leg.kind == GUIDE else far, -leg.kind * rub.coefficient * rub.sense * along
        for column, force in zip((units, leans), forces, strict=True):
            column.append([force.real, force.imag, (arm.conjugate() * force).imag])
        arms.append((arm, far, along))
    signs = itertools.product([-1.0, 1.0], repeat=3)
    found = [np.linalg.det(np.array(units) + np.array(leans) * np.array([choice]).T) for choice in signs]
    return np.array(found), arms


@pytest.mark.parametrize("kinds", list(itertools.product([ROD, GUIDE], repeat=3)), ids=str)
@pytest.mark.parametrize("seed", range(40))
def test_a_triad_with_friction_is_in_equilibrium(kinds, seed):
    """Link, rods and blocks, each with the friction that its own normal force asks for; or all is NaN."""
    random = np.random.default_rng(seed)
    link, ends, legs, loads = any_triad(random, kinds)
    friction = TriadFriction(*(Friction(random.uniform(0, 0.4), random.choice([-1.0, 1.0])) for _ in range(3)))
    with np.errstate(invalid="ignore"):
        found = triad_reactions_with_friction(link, ends, legs, loads, friction)
    determinants, arms = determinants_of(link, ends, legs, friction)
    if np.any(determinants > 0) and np.any(determinants < 0):
        assert np.all(np.isnan([[leg.joint.x, leg.joint.y, leg.end.x, leg.end.y] for leg in found]))
        return
    joints = [complex(leg.joint.x, leg.joint.y) for leg in found]
    left = [sum(joints) + complex(loads.link.x, loads.link.y)]
    left.append(
        sum((arm.conjugate() * f).imag for (arm, _, _), f in zip(arms, joints, strict=True)) + loads.link.moment
    )
    for leg, joint, (_, far, along), load, kind, rub in zip(
        found, joints, arms, loads[1:], kinds, friction, strict=True
    ):
        held = complex(leg.end.x, leg.end.y)
        left.append(held - joint + complex(load.x, load.y))
        if kind == ROD:
            left.append(load.moment - (far.conjugate() * joint).imag)
        else:
            normal, drag = (along.conjugate() * held).imag, (along.conjugate() * held).real
            left += [drag + rub.coefficient * rub.sense * abs(normal), leg.end.moment + load.moment]
    assert np.max(np.abs(left)) < 1e-13 * (np.max(np.abs(joints)) + 9) * max(1, np.max(np.abs(arms)))


def test_without_friction_a_triad_is_as_before():
    link, ends, legs, loads = any_triad(np.random.default_rng(1), [GUIDE, ROD, GUIDE])
    free = triad_reactions(link, ends, legs, loads)
    smooth = TriadFriction(*(Friction(0.0, sense) for sense in (1.0, -1.0, 0.0)))
    np.testing.assert_allclose(triad_reactions_with_friction(link, ends, legs, loads, smooth), free, rtol=1e-14)
