"""Modes of triads at one angle, against closed forms and against a search from a thousand starts."""

import numpy as np
import pytest
from tests.exact.geometries import triads

from cranktrain.linkage import (
    GUIDE,
    ROD,
    Leg,
    LinkPoint,
    Pose,
    Triad,
    TriadDriver,
    TriadEnds,
    fixed,
    fixed_guide,
    rod_end,
    triad,
    triad_modes,
)

N = 150
N_STARTS = 1000
"""A mode whose basin takes one start in a hundred is missed once in 20,000 searches."""


def number(value, i: int):
    """One machine's numbers, of any nested tuple of columns."""
    return type(value)(*(number(part, i) for part in value)) if isinstance(value, tuple) else float(value[i, 0])


def ends_of(machine) -> TriadEnds:
    """The ends at crank angle 0, standing still."""
    return TriadEnds(
        *(
            fixed_guide(
                end.x + end.radius * np.cos(end.ahead),
                end.y + end.radius * np.sin(end.ahead),
                end.direction + end.swing * np.sin(end.swing_ahead),
            )
            for end in machine
        )
    )


def as_points(pose: Pose):
    """Poses by their origin and direction, which do not jump."""
    return np.stack([pose.x, pose.y, np.cos(pose.angle), np.sin(pose.angle)], axis=-1)


def are_among(some, all_of_them) -> bool:
    return all(np.min(np.max(np.abs(all_of_them - one), axis=-1)) < 1e-6 for one in some)


@pytest.fixture(scope="module")
def machines():
    drawn = triads(N, seed=3)
    random = np.random.default_rng(4)
    found = []
    for i in range(N):
        ends, legs = ends_of(number(end, i) for end in drawn.geometry.ends), number(drawn.geometry.legs, i)
        modes = triad_modes(ends, legs)
        start = Pose(*random.uniform(-3.0, 3.0, size=(2, N_STARTS)), random.uniform(-np.pi, np.pi, size=N_STARTS))
        with np.errstate(all="ignore"):
            link = triad(TriadDriver(ends, start), legs).link
        searched = as_points(Pose(link.origin.x.value, link.origin.y.value, link.angle.value))
        n_guides = int(sum(leg.kind for leg in legs))
        found.append((n_guides, number(drawn.pose, i), modes, searched[~np.isnan(searched[:, 0])]))
    return found


def test_every_mode_is_found_and_once(machines):
    for _, _, modes, searched in machines:
        assert are_among(searched, as_points(modes))
        for i, pose in enumerate(as_points(modes)):
            assert np.all(np.max(np.abs(np.delete(as_points(modes), i, axis=0) - pose), axis=-1) > 1e-6)


def test_the_pose_that_a_machine_was_made_for_is_a_mode(machines):
    for _, pose, modes, _ in machines:
        assert are_among(as_points(pose)[np.newaxis], as_points(modes))


def test_as_many_modes_as_the_polynomial_allows(machines):
    counts = {n: {len(modes.x) for n_guides, _, modes, _ in machines if n_guides == n} for n in range(4)}
    assert counts[0] <= {2, 4, 6}
    assert counts[1] <= {2, 4, 6}
    assert counts[2] <= {2, 4}
    assert counts[3] == {2}
    assert 6 in counts[0] | counts[1]


def test_elliptic_trammel_on_a_rod():
    """The middle of a link whose ends slide on the axes goes round their crossing: two circles meet twice."""
    legs = Triad(
        Leg(LinkPoint(0.25, 0.0), 0.0, GUIDE),
        Leg(LinkPoint(0.25, np.pi), 0.0, GUIDE),
        Leg(LinkPoint(0.0, 0.0), 0.6, ROD),
    )
    ends = TriadEnds(fixed_guide(0.0, 0.0, 0.0), fixed_guide(0.0, 0.0, np.pi / 2), rod_end(fixed(0.7, 0.0)))
    x = (0.25**2 + 0.7**2 - 0.6**2) / 1.4
    y = np.sqrt(0.25**2 - x**2)
    modes = triad_modes(ends, legs)
    # From the end on the y axis to that on x: the link leans away from the middle's direction.
    np.testing.assert_allclose(modes.angle, [-np.arctan2(y, x), np.arctan2(y, x)], rtol=1e-14)
    np.testing.assert_allclose(modes.x, [x, x], rtol=1e-14)
    np.testing.assert_allclose(modes.y, [y, -y], rtol=1e-14)


def test_parallel_guides():
    """Two points on lines half a metre apart, the third on a rod: two angles, and two places for each."""
    legs = Triad(
        Leg(LinkPoint(0.0, 0.0), 0.0, GUIDE), Leg(LinkPoint(1.0, 0.0), 0.0, GUIDE), Leg(LinkPoint(0.0, 0.0), 0.5, ROD)
    )
    ends = TriadEnds(fixed_guide(0.0, 0.0, 0.0), fixed_guide(0.0, 0.5, 0.0), rod_end(fixed(0.3, 0.3)))
    modes = triad_modes(ends, legs)
    np.testing.assert_allclose(modes.angle, np.deg2rad([30.0, 30.0, 150.0, 150.0]), rtol=1e-12)
    np.testing.assert_allclose(np.sort(modes.x), [-0.1, -0.1, 0.7, 0.7], rtol=1e-12)
    np.testing.assert_allclose(modes.y, 0.0, atol=1e-14)


def test_legs_that_cannot_close_have_no_mode():
    legs = Triad(*(Leg(LinkPoint(0.1, angle), 0.1, ROD) for angle in (0.0, 2.0, 4.0)))
    ends = TriadEnds(*(rod_end(fixed(x, 0.0)) for x in (0.0, 1.0, 2.0)))
    assert triad_modes(ends, legs).x.shape == (0,)
