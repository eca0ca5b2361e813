"""Friction of sliders: the normal force that belongs to itself, both sides of a standstill, and wedging."""

import numpy as np
import pytest

from cranktrain.linkage import AHEAD, Crank, Slide, Yoke, crank, slide
from cranktrain.linkage.forces import (
    Friction,
    SlideLoads,
    Wrench,
    YokeLoads,
    slide_reactions,
    yoke_reactions,
)
from cranktrain.linkage.forces.conditions import dragged, pressed

NOTHING = Wrench(0.0, 0.0, 0.0)


def slid(angle, load, friction, rod_length=0.5):
    rod = slide(crank(angle, Crank(0.3)), Slide(rod_length, 0.0, AHEAD)).rod
    return slide_reactions(rod, Slide(rod_length, 0.0, AHEAD), SlideLoads(NOTHING, Wrench(load, 0.0, 0.0)), friction)


@pytest.mark.parametrize("frictionless", [-70.0, 0.0, 40.0])
@pytest.mark.parametrize("sense", [-1.0, 1.0])
@pytest.mark.parametrize("lever", [-2.0, 0.5, 3.0])
def test_normal_force_belongs_to_its_friction(frictionless, sense, lever):
    friction = Friction(0.3, sense)
    normal = pressed(frictionless, lever, friction)
    assert normal == pytest.approx(frictionless + lever * dragged(normal, friction), rel=1e-15, abs=1e-15)
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
    found = yoke_reactions(0.2, Yoke(0.0, np.pi / 2), YokeLoads(NOTHING, Wrench(500.0, 0.0, 0.0)), Friction(0.3, 1.0))
    assert found.guide.x == pytest.approx(0.0, abs=1e-13)
    assert found.slot.x == pytest.approx(-500.0)
    assert found.guide.moment == pytest.approx(-0.2 * 500.0)
