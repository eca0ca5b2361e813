"""Triads that fall apart into two pin groups, and their legs, against the closed forms."""

from typing import NamedTuple

import numpy as np
import pytest

from cranktrain.linkage import (
    GUIDE,
    ROD,
    Crank,
    Ends,
    Leg,
    LinkPoint,
    OnLine,
    Pin,
    PinMotion,
    Pose,
    Slide,
    Triad,
    TriadDriver,
    TriadEnds,
    block_along,
    crank,
    fixed,
    fixed_guide,
    pin,
    point,
    rod_between,
    rod_end,
    slide,
    triad,
)
from cranktrain.motion import Coefficient

TURN = np.arange(0, 360, 10) * (np.pi / 180)
PIN = crank(TURN, Crank(0.1))
FAR, NEAR = fixed(0.0 * TURN + 0.5, 0.0 * TURN + 0.05), fixed(0.0 * TURN + 0.75, 0.0 * TURN - 0.1)


def assert_close(found: Coefficient, expected: Coefficient) -> None:
    for order in Coefficient._fields:
        size = np.max(np.abs(getattr(expected, order)))
        assert getattr(found, order) == pytest.approx(getattr(expected, order), abs=1e-13 * size), order


class TwoPins(NamedTuple):
    """Joint B of two rods on crank and pivot; a link from B to a joint on a third rod."""

    joint: PinMotion
    link: PinMotion


@pytest.fixture(scope="module")
def two_pins() -> TwoPins:
    joint = pin(Ends(PIN, FAR), Pin(0.45, 0.3, 1.0))
    return TwoPins(joint, pin(Ends(joint.joint, NEAR), Pin(0.35, 0.4, -1.0)))


@pytest.fixture(scope="module")
def as_triad(two_pins):
    """The same links as a triad: two of its points are the joint B, its start is wrong by a few per cent."""
    legs = Triad(
        Leg(LinkPoint(0.0, 0.0), 0.45, ROD), Leg(LinkPoint(0.35, 0.0), 0.4, ROD), Leg(LinkPoint(0.0, 1.0), 0.3, ROD)
    )
    near = two_pins.link.rod
    start = Pose(near.origin.x.value + 0.01, near.origin.y.value - 0.01, near.angle.value + 0.02)
    return triad(TriadDriver(TriadEnds(rod_end(PIN), rod_end(NEAR), rod_end(FAR)), start), legs)


def test_triad_with_two_rods_on_one_joint_is_two_pins(two_pins, as_triad):
    link = as_triad.link
    assert_close(link.origin.x, two_pins.joint.joint.x)
    assert_close(link.origin.y, two_pins.joint.joint.y)
    assert_close(link.angle, two_pins.link.rod.angle)
    assert_close(Coefficient(link.cos, link.sin, link.cos), Coefficient(*(two_pins.link.rod[i] for i in (2, 3, 2))))


def test_rod_between_the_ends_of_a_leg(two_pins, as_triad):
    leg = rod_between(NEAR, point(as_triad.link, LinkPoint(0.35, 0.0)))
    assert_close(leg.angle, two_pins.link.rocker.angle)
    assert leg.cos == pytest.approx(two_pins.link.rocker.cos, abs=1e-13)
    assert leg.sin == pytest.approx(two_pins.link.rocker.sin, abs=1e-13)


def test_transmission_is_the_arm_of_the_third_rod_about_the_joint_of_the_others(two_pins, as_triad):
    """Unit normals n₁ × n₃ of the two rods on the joint, times the moment of the second about it."""
    (_, first, third), (_, link, second) = two_pins
    across = np.sin(third.angle.value - first.angle.value)
    arm = 0.35 * np.sin(second.angle.value - link.angle.value)
    assert np.abs(as_triad.transmission) == pytest.approx(np.abs(across * arm), rel=1e-12)


def test_block_on_a_fixed_line_is_a_slider():
    slider, rod = slide(PIN, Slide(0.4, 0.05, 1.0))
    assert_close(block_along(OnLine(fixed_guide(0.0, 0.02, 0.0), point(rod, LinkPoint(0.4, 0.0)))), slider)


def test_block_on_a_line_that_turns_is_not_moved_by_it():
    """Seen from the crank, its own pin stands still; another fixed point goes round backwards."""
    turning = fixed_guide(0.0, 0.0, TURN)._replace(angle=Coefficient(TURN, 0.0 * TURN + 1.0, 0.0 * TURN))
    pin_seen = block_along(OnLine(turning, crank(TURN + 0.3, Crank(0.2))))
    assert pin_seen.value == pytest.approx(0.2 * np.cos(0.3), rel=1e-15)
    assert pin_seen.first == pytest.approx(0.0, abs=1e-16)
    assert pin_seen.second == pytest.approx(0.0, abs=1e-15)


def test_links_that_cannot_close_are_nan():
    """An elliptic trammel half a metre long, its middle on a rod that is too short."""
    legs = Triad(
        Leg(LinkPoint(0.25, 0.0), 0.0, GUIDE),
        Leg(LinkPoint(0.25, np.pi), 0.0, GUIDE),
        Leg(LinkPoint(0.0, 0.0), 0.7, ROD),
    )
    ends = TriadEnds(fixed_guide(0.0, 0.0, 0.0), fixed_guide(0.0, 0.0, np.pi / 2), rod_end(fixed(1.0, 0.0)))
    with np.errstate(all="ignore"):
        motion = triad(TriadDriver(ends, Pose(0.2, 0.1, 0.5)), legs)
    link = motion.link
    assert np.isnan([*link.origin.x, *link.origin.y, *link.angle, link.cos, link.sin, motion.transmission]).all()
