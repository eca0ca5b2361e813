"""Walks of one machine: the branch that the start names, any number of machines at once, other turns."""

from functools import partial

import numpy as np
import pytest
from tests.walks import comes_back

from cranktrain.linkage import (
    ROD,
    Crank,
    Leg,
    LinkPoint,
    Pose,
    Triad,
    TriadDriver,
    TriadEnds,
    crank,
    fixed,
    pose_at,
    rod_end,
    triad,
    triad_modes,
    triad_walk,
)

LEGS = Triad(Leg(LinkPoint(0.0, 0.0), 1.2, ROD), Leg(LinkPoint(0.8, 0.0), 1.1, ROD), Leg(LinkPoint(0.5, 1.2), 0.9, ROD))


def ends_at(angle, radius=0.1) -> TriadEnds:
    return TriadEnds(rod_end(crank(angle, Crank(radius))), rod_end(fixed(1.5, 0.2)), rod_end(fixed(0.4, 1.6)))


TURN = np.arange(0, 360, 5) * (np.pi / 180)


@pytest.fixture(scope="module")
def modes() -> Pose:
    return triad_modes(ends_at(0.0), LEGS)


def test_each_mode_is_followed_on_a_branch_of_its_own_and_comes_back(modes):
    assert len(modes.x) == 2
    links = []
    for mode in zip(*modes, strict=True):
        walk = triad_walk(ends_at, LEGS, Pose(*mode))
        assert comes_back(walk, LEGS).all()
        motion = triad(TriadDriver(ends_at(TURN), pose_at(walk, TURN)), LEGS)
        assert np.all(motion.transmission * motion.transmission[0] > 0)
        links.append(motion.link)
        link = motion.link
        for found, expected in zip((link.origin.x, link.origin.y, link.angle), mode, strict=True):
            assert found.value[0] == pytest.approx(expected, rel=1e-14)
    assert np.all(np.abs(links[0].origin.x.value - links[1].origin.x.value) > 0.1)


def test_nodes_give_starts_to_a_millionth(modes):
    walk = triad_walk(ends_at, LEGS, Pose(*(field[0] for field in modes)))
    start = pose_at(walk, TURN)
    link = triad(TriadDriver(ends_at(TURN), start), LEGS).link
    assert start.x == pytest.approx(link.origin.x.value, abs=1e-6)
    assert start.y == pytest.approx(link.origin.y.value, abs=1e-6)
    assert start.angle == pytest.approx(link.angle.value, abs=1e-6)


@pytest.mark.parametrize("shift", [-4 * np.pi, 2 * np.pi])
def test_all_turns_are_alike_wherever_the_walk_begins(modes, shift):
    first = triad_walk(ends_at, LEGS, Pose(*(field[0] for field in modes)))
    later = triad_walk(lambda angle: ends_at(angle + 1.0), LEGS, pose_at(first, np.array([1.0])))
    np.testing.assert_allclose(pose_at(later, TURN - 1.0 + shift), pose_at(first, TURN), rtol=0, atol=2e-6)


def test_machines_are_walked_together_each_in_its_own_steps(modes):
    """Crank radii of which the last two cannot turn: NaN from where the link is loose."""
    radius = np.array([[0.05], [0.1], [0.5], [0.7]])
    start = Pose(*(field[1] for field in modes))
    walk = triad_walk(lambda angle: ends_at(angle, radius), LEGS, start)
    assert comes_back(walk, LEGS).tolist() == [[True], [True], [False], [False]]
    together = pose_at(walk, TURN)
    for i, own_radius in enumerate(radius):
        alone = pose_at(triad_walk(partial(ends_at, radius=own_radius), LEGS, start), TURN)
        np.testing.assert_allclose([field[i] for field in together], alone, rtol=0, atol=1e-12)
    assert np.isnan(together.x).any(axis=-1).tolist() == [False, False, True, True]


def test_a_start_that_does_not_close_is_lost_from_the_beginning():
    walk = triad_walk(lambda angle: ends_at(angle, 5.0), LEGS, Pose(0.5, 1.0, -1.7))
    assert np.isnan(pose_at(walk, TURN).x).all()
    assert not comes_back(walk, LEGS).any()
