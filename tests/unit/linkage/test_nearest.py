"""Legs that do not reach, by how much one lacks: closed forms of links that two legs hold, and by trying."""

import numpy as np
import pytest

from cranktrain.linkage import GUIDE, ROD, Leg, LinkPoint, Pose, Triad, TriadEnds, fixed, fixed_guide, rod_end
from cranktrain.linkage.nearest import nearest_pose

START = Pose(0.4, 0.3, 0.2)


def test_two_rods_to_one_joint_lack_what_their_ends_are_apart():
    """The third leg only turns the link, and closes."""
    legs = Triad(
        Leg(LinkPoint(0.0, 0.0), 0.5, ROD), Leg(LinkPoint(0.0, 0.0), 0.3, ROD), Leg(LinkPoint(0.7, 0.0), 0.6, ROD)
    )
    ends = TriadEnds(rod_end(fixed(0.0, 0.0)), rod_end(fixed(1.0, 0.0)), rod_end(fixed(0.6, 0.8)))
    found = nearest_pose(ends, legs, START)
    assert found.opening == pytest.approx(1.0 - 0.5 - 0.3, rel=1e-8)
    assert (found.pose.x, found.pose.y) == (pytest.approx(0.6), pytest.approx(0.0, abs=1e-7))


def test_a_rod_that_does_not_reach_a_guide():
    """Rod and guide on one joint: the guide 0.9 m off, the rod 0.5 m long."""
    legs = Triad(
        Leg(LinkPoint(0.0, 0.0), 0.5, ROD), Leg(LinkPoint(0.0, 0.0), 0.9, GUIDE), Leg(LinkPoint(0.7, 0.0), 0.6, ROD)
    )
    ends = TriadEnds(rod_end(fixed(0.0, 0.0)), fixed_guide(0.0, 0.0, 0.3), rod_end(fixed(0.0, 1.2)))
    assert nearest_pose(ends, legs, START).opening == pytest.approx(0.4, rel=1e-8)


def test_where_the_legs_close_nothing_lacks():
    joints = [LinkPoint(0.3, angle) for angle in (0.5, 2.5, 4.5)]
    pose = Pose(0.5, 0.1, 0.0)
    at = [complex(0.5, 0.1) + 0.3 * np.exp(1j * joint.angle) for joint in joints]
    ends = (0.1 - 0.4j, 1.2 + 0.6j, -0.5 + 0.9j)
    legs = Triad(*(Leg(joint, abs(one - end), ROD) for joint, one, end in zip(joints, at, ends, strict=True)))
    found = nearest_pose(TriadEnds(*(rod_end(fixed(end.real, end.imag)) for end in ends)), legs, Pose(0.45, 0.15, 0.1))
    assert found.opening < 1e-15
    assert (*found.pose,) == pytest.approx((*pose,), abs=1e-13)


def test_many_at_once_are_as_each_alone():
    radius = np.linspace(0.0, 3.0, 7)
    legs = Triad(
        Leg(LinkPoint(0.0, 0.0), 0.5, ROD), Leg(LinkPoint(0.8, 0.0), 0.3, ROD), Leg(LinkPoint(0.7, 1.0), 0.6, ROD)
    )

    def found(x):
        ends = TriadEnds(rod_end(fixed(x, 0.0 * x)), rod_end(fixed(1.0, 0.0)), rod_end(fixed(0.6, 0.8)))
        return nearest_pose(ends, legs, START).opening

    np.testing.assert_allclose(found(radius), [found(x) for x in radius], rtol=1e-9, atol=1e-14)


def test_ends_that_are_nowhere():
    legs = Triad(*(Leg(LinkPoint(0.3, angle), 0.4, ROD) for angle in (0.5, 2.5, 4.5)))
    ends = TriadEnds(*(rod_end(fixed(np.nan, 0.0)) for _ in range(3)))
    assert np.isnan(nearest_pose(ends, legs, START).opening)
