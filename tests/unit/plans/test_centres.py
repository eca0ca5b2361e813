"""Instant centres against lines that meet, in 40 digits, and against the kernels' own velocity ratios."""

import tomllib
from itertools import combinations

import mpmath as mp
import numpy as np
import pytest
from tests.sentences import CANNOT_CLOSE_THERE

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.mechanisms import KINDS
from cranktrain.plans.centres import instant_centres
from cranktrain.texts.crank_rocker import pin_velocity_ratio

ANGLES = (17.0, 75.0, 158.0, 222.0, 301.0)
R, L, S, G = 0.1, 0.36, 0.28, 0.4
ROCKER = {
    "rotation": "anticlockwise",
    "angle": "-90 deg",  # its x is X, its y is Y
    "mechanism": {
        "kind": "crank_rocker",
        "crank_radius": f"{R} m",
        "rod_length": f"{L} m",
        "rocker_length": f"{S} m",
        "ground_length": f"{G} m",
    },
}


def crossing(p, q, r, s):
    """Where the lines p q and r s meet."""
    along, other = (q[0] - p[0], q[1] - p[1]), (s[0] - r[0], s[1] - r[1])
    part = ((r[0] - p[0]) * other[1] - (r[1] - p[1]) * other[0]) / (along[0] * other[1] - along[1] * other[0])
    return p[0] + part * along[0], p[1] + part * along[1]


def four_bar(degrees):
    """Pins O, A, B, C of the crank-rocker, B left of the line from A to C, in 40 digits."""
    phi = mp.radians(mp.mpf(degrees))
    radius, rod, rocker, ground = (mp.mpf(str(value)) for value in (R, L, S, G))
    a = radius * mp.cos(phi), radius * mp.sin(phi)
    apart = mp.hypot(ground - a[0], a[1])
    along = (apart**2 + rod**2 - rocker**2) / (2 * apart)
    height = mp.sqrt(rod**2 - along**2)
    x, y = (ground - a[0]) / apart, -a[1] / apart
    return (
        (mp.mpf(0), mp.mpf(0)),
        a,
        (a[0] + along * x - height * y, a[1] + along * y + height * x),
        (ground, mp.mpf(0)),
    )


@pytest.mark.parametrize("angle", ANGLES)
def test_crank_rocker_centres_are_where_lines_meet(angle):
    found = instant_centres(ct.Machine(**ROCKER), angle)
    with mp.workdps(40):
        o, a, b, c = four_bar(angle)
        expected = {
            (1, 2): o,
            (2, 3): a,
            (3, 4): b,
            (1, 4): c,
            (1, 3): crossing(o, a, c, b),
            (2, 4): crossing(a, b, o, c),
        }
        for pair, place in expected.items():
            there = np.array([float(part) for part in place])
            np.testing.assert_allclose(found.centre(*pair).place, there, rtol=1e-12, atol=1e-14, err_msg=str(pair))


@pytest.mark.parametrize("angle", ANGLES)
def test_velocity_ratio_of_the_rocker_three_ways(angle):
    """By the kernel, by P_24, and by AC : BC of (7), (10), both pins' distances from the rod's centre."""
    machine = ct.Machine(**ROCKER)
    found = instant_centres(machine, angle)
    place = machine.places[0]
    exact = float(place.kind.motion(np.array([np.radians(angle)]), place.geometry).rocker.angle.first[0])
    shaft, pivot, both = (found.centre(*pair).place for pair in ((1, 2), (1, 4), (2, 4)))
    assert found.bodies[3].turning == pytest.approx(exact, rel=1e-12)
    # outside the two pivots both turn alike, between them against each other
    between = np.dot(shaft - both, pivot - both)
    assert np.sign(between) * np.hypot(*(shaft - both)) / np.hypot(*(pivot - both)) == pytest.approx(exact, rel=1e-11)
    o, a, b, c = (np.array([float(part) for part in pin]) for pin in four_bar(angle))
    crank, rod, rocker = (np.arctan2(*(end - start)[::-1]) for start, end in ((o, a), (a, b), (c, b)))
    ratio = float(pin_velocity_ratio(crank, rod, rocker))
    assert R / S * ratio == pytest.approx(exact, rel=1e-12)
    centre = found.centre(1, 3).place
    assert np.hypot(*(b - centre)) / np.hypot(*(a - centre)) == pytest.approx(abs(ratio), rel=1e-11)


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
@pytest.mark.parametrize("angle", ANGLES)
def test_three_centres_lie_on_one_line(kind, angle):
    """Kennedy's theorem for every three bodies of every kind; and all are as many as there are pairs."""
    found = instant_centres(ct.Machine(**tomllib.loads(kind.example)), angle)
    n = len(found.bodies)
    assert len(found.centres) == n * (n - 1) // 2
    for one, other, third in combinations(range(1, n + 1), 3):
        three = [found.centre(*pair) for pair in ((one, other), (one, third), (other, third))]
        if any(np.isnan(centre.place[0]) and np.isnan(centre.direction) for centre in three):
            continue  # two of them move together
        # homogeneous coordinates: a centre that is infinitely far is a direction
        size = max(1.0, *(np.max(np.abs(np.nan_to_num(centre.place))) for centre in three))
        rows = [
            [*(centre.place / size), 1.0 / size]
            if np.isfinite(centre.place[0])
            else [np.cos(centre.direction), np.sin(centre.direction), 0.0]
            for centre in three
        ]
        rows = [np.array(row) / np.linalg.norm(row) for row in rows]
        assert abs(np.linalg.det(rows)) < 1e-10, (one, other, third)


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
def test_velocity_ratios_are_those_of_the_centres(kind):
    found = instant_centres(ct.Machine(**tomllib.loads(kind.example)), 40.0)
    shaft = found.centre(1, 2).place
    assert found.bodies[1].turning == pytest.approx(1.0, abs=1e-14)
    for number, body in enumerate(found.bodies[2:], start=3):
        own, both = found.centre(1, number).place, found.centre(2, number).place
        if np.isnan(own[0]):
            assert body.turning == pytest.approx(0.0, abs=1e-12)
        elif np.all(own == both):  # of one shaft with the crank
            assert body.turning == pytest.approx(1.0, abs=1e-12)
        else:
            ratio = np.hypot(*(shaft - both)) / np.hypot(*(own - both))
            assert abs(body.turning) == pytest.approx(ratio, rel=1e-10)


def test_centre_of_a_rod_that_only_moves_along_is_infinitely_far():
    """Crank across the line of stroke: its line and the perpendicular in the piston are parallel, both along X."""
    pump = ct.Machine(mechanism={"kind": "slider_crank", "crank_radius": "30 mm", "rod_length": "50 mm"})
    centre = instant_centres(pump, 90.0).centre(1, 3)
    assert np.all(np.isnan(centre.place))
    assert centre.direction % np.pi == pytest.approx(0.0, abs=1e-12) or centre.direction % np.pi == pytest.approx(np.pi)
    assert instant_centres(pump, 90.0).bodies[2].turning == pytest.approx(0.0, abs=1e-15)


def test_eccentric_and_crank_are_of_one_shaft():
    found = instant_centres(ct.load("lms_class5"), 60.0, mechanism="1valve")
    names = [body.name for body in found.bodies]
    assert found.bodies[names.index("return")].turning == pytest.approx(1.0, abs=1e-14)


def test_links_that_cannot_close_have_none():
    short = ct.Machine(mechanism={"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "40 mm"})
    with pytest.raises(InputError, match=CANNOT_CLOSE_THERE):
        instant_centres(short, 90.0)


def test_centres_are_nowhere_where_links_only_just_close():
    even = ct.Machine(mechanism={"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "50 mm"})
    found = instant_centres(even, 90.0)
    assert np.all(np.isnan(found.centre(1, 3).place))
