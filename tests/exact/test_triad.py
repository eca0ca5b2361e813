"""Triads against 50 digits, with rods and guides in any order, on starts from a walk round the turn."""

from typing import NamedTuple

import numpy as np
import pytest
from numpy.typing import NDArray
from tests.exact import oracles
from tests.exact.agreement import quantities
from tests.exact.geometries import CrankedEnd, CrankedTriad, PosedTriads, triads
from tests.walks import comes_back

from cranktrain.linkage import (
    GUIDE,
    Pose,
    Triad,
    TriadDriver,
    TriadEnds,
    TriadMotion,
    Walk,
    pose_at,
    triad,
    triad_walk,
)
from cranktrain.motion import Coefficient, Link, Point

Array = NDArray[np.float64]

N = 1_000
TURN = np.arange(360) * (np.pi / 180)
LEAST_MARGIN = 0.01
SIZE = 1.0  # of the largest links: radii of 0.2 to 1 m, rods of 0.4 to 2.5 m


class Turning(NamedTuple):
    """Triads whose crank turns, with the walk round it."""

    geometry: CrankedTriad
    walk: Walk


def end_at(angle: Array, end: CrankedEnd) -> Link:
    cos, sin = end.radius * np.cos(angle + end.ahead), end.radius * np.sin(angle + end.ahead)
    point = Point(Coefficient(end.x + cos, -sin, -cos), Coefficient(end.y + sin, cos, -sin))
    swing, swing1 = end.swing * np.sin(angle + end.swing_ahead), end.swing * np.cos(angle + end.swing_ahead)
    direction = end.direction + swing
    return Link(point, Coefficient(direction, swing1, -swing), np.cos(direction), np.sin(direction))


def ends_at(angle: Array, geometry: CrankedTriad) -> TriadEnds:
    return TriadEnds(*(end_at(angle, end) for end in geometry.ends))


def walked(machines: PosedTriads) -> Walk:
    return triad_walk(lambda angle: ends_at(angle, machines.geometry), machines.geometry.legs, machines.pose)


def motion_at(angle: Array, machines: Turning) -> TriadMotion:
    driver = TriadDriver(ends_at(angle, machines.geometry), pose_at(machines.walk, angle))
    return triad(driver, machines.geometry.legs)


def turns(walk: Walk) -> NDArray[np.bool_]:
    """Whether the link could be followed all the way, (n,)."""
    return ~np.isnan(walk.pose.value[0, :, -1])


def rows(value, which):
    """Some of the machines, of any nested tuple of columns."""
    if isinstance(value, tuple):
        parts = [rows(part, which) for part in value]
        return type(value)(*parts) if hasattr(value, "_fields") else tuple(parts)
    return value[which]


def lengthened(geometry: CrankedTriad, i: int, length: str, factor: float) -> CrankedTriad:
    """One length of leg i changed: from the shaft to its end, of its crank, on the link, of its rod or shift."""
    end, leg = geometry.ends[i], geometry.legs[i]
    match length:
        case "end":
            end = end._replace(x=end.x * factor, y=end.y * factor)
        case "crank":
            end = end._replace(radius=end.radius * factor)
        case "point":
            leg = leg._replace(point=leg.point._replace(radius=leg.point.radius * factor))
        case _:
            leg = leg._replace(length=leg.length * factor)
    ends, legs = list(geometry.ends), list(geometry.legs)
    ends[i], legs[i] = end, leg
    return CrankedTriad(tuple(ends), Triad(*legs))


@pytest.fixture(scope="module")
def drawn() -> PosedTriads:
    return triads(3 * N, seed=1)


@pytest.fixture(scope="module")
def turning(drawn) -> Turning:
    """Triads whose crank still turns with any one of the lengths one per cent longer or shorter."""
    walk = walked(drawn)
    machines = rows(drawn, turns(walk) & comes_back(walk, drawn.geometry.legs)[:, 0])
    for i in range(3):
        for length in ("end", "crank", "point", "leg"):
            for factor in (1 - LEAST_MARGIN, 1 + LEAST_MARGIN):
                changed = machines._replace(geometry=lengthened(machines.geometry, i, length, factor))
                machines = rows(machines, turns(walked(changed)))
    machines = rows(machines, slice(N))
    assert len(machines.pose.x) == N
    return Turning(machines.geometry, walked(machines))


@pytest.fixture(scope="module")
def round_the_turn(turning) -> TriadMotion:
    return motion_at(TURN, turning)


def test_triads_are_exact(turning, round_the_turn):
    """To 1e-12 of the peaks at a margin of one per cent and more: where the link is loosest, and anywhere."""
    loosest = np.argmin(np.abs(round_the_turn.transmission), axis=-1)
    anywhere = np.random.default_rng(2).uniform(-2 * np.pi, 4 * np.pi, size=N)
    angle = np.stack([TURN[loosest], anywhere], axis=-1)
    found = motion_at(angle, turning)
    pose = (found.link.origin.x.value, found.link.origin.y.value, found.link.angle.value)
    legs = zip(turning.geometry.ends, turning.geometry.legs, strict=True)
    columns = [column for end, leg in legs for column in (*end, *leg.point, leg.length, leg.kind)]
    exact = oracles.coefficients(oracles.triad, angle, *pose, *columns)
    given, cycle = quantities(found, set(exact)), quantities(round_the_turn, set(exact))
    assert len(given) == 3 * 3 + 2
    for name, values in given.items():
        quantity, order = name.rsplit(".", 1)
        peak = np.max(np.abs(cycle[name]), axis=-1, keepdims=True)
        assert np.all(np.abs(values - getattr(exact[quantity], order)) <= 1e-12 * peak), name


def test_legs_are_held_all_round(turning, round_the_turn):
    link = round_the_turn.link
    for end, leg in zip(ends_at(TURN, turning.geometry), turning.geometry.legs, strict=True):
        x = link.origin.x.value + leg.point.radius * np.cos(link.angle.value + leg.point.angle) - end.origin.x.value
        y = link.origin.y.value + leg.point.radius * np.sin(link.angle.value + leg.point.angle) - end.origin.y.value
        opening = np.where(leg.kind == GUIDE, end.cos * y - end.sin * x, np.hypot(x, y)) - leg.length
        assert np.max(np.abs(opening)) <= 1e-14 * 2.5


def test_no_jump_from_branch_to_branch(turning):
    """At a thousand angles each pose follows from the one before by its own derivatives, to a thousandth."""
    angle = np.linspace(0.0, 2 * np.pi, 1001)
    link = motion_at(angle, turning).link
    for coefficient in (link.origin.x, link.origin.y, link.angle):
        value, first, second = (order[:, :-1] for order in coefficient)
        jump = value + angle[1] * (first + 0.5 * angle[1] * second) - coefficient.value[:, 1:]
        if coefficient is link.angle:
            jump -= 2 * np.pi * np.round(jump / (2 * np.pi))
        assert np.max(np.abs(jump)) < 1e-3 * SIZE


def test_the_transmission_keeps_its_sign(round_the_turn):
    assert np.all(np.abs(np.sum(np.sign(round_the_turn.transmission), axis=-1)) == len(TURN))


def test_what_cannot_be_followed_is_loose(drawn):
    """Where a walk ends the transmission is zero but for the root of the last step, and beyond that all is NaN."""
    whole = walked(drawn)
    is_lost = ~turns(whole)
    machines = rows(drawn, is_lost)
    walk = Walk(whole.angle[is_lost], Coefficient(*(order[:, is_lost] for order in whole.pose)))
    last = np.sum(~np.isnan(walk.pose.value[0]), axis=-1, keepdims=True) - 1
    angle = np.take_along_axis(walk.angle, last, axis=-1)
    pose = Pose(*np.take_along_axis(walk.pose.value, last[np.newaxis], axis=-1))
    there = triad(TriadDriver(ends_at(angle, machines.geometry), pose), machines.geometry.legs)
    with np.errstate(invalid="ignore"):
        beyond = motion_at((angle + 2 * np.pi) / 2, Turning(machines.geometry, walk))
    assert len(angle) > N
    assert np.all(np.abs(there.transmission) < 0.02 * SIZE)
    assert np.all(np.isnan(beyond.link.origin.x.value))
