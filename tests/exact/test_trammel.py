"""Trammel kernel against 50 digits: on a rocking lever, and on a rod whose pin moves."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from tests.exact import oracles
from tests.exact.agreement import assert_exact
from tests.exact.geometries import SwivelCrank, slider_cranks, swivel_cranks

from cranktrain.linkage import (
    AHEAD,
    Crank,
    Ends,
    Slide,
    Swivel,
    Trammel,
    crank,
    fixed,
    slide,
    swivel,
    trammel,
    turned_link,
)
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank

Array = NDArray[np.float64]

N = 5_000


class SlottedLever(NamedTuple):
    lever: SwivelCrank
    trammel: Trammel


class SlottedRod(NamedTuple):
    slider_crank: SliderCrank
    trammel: Trammel


def slotted_lever(angle: Array, geometry: SlottedLever) -> NamedTuple:
    radius, ground, offset, _ = geometry.lever
    ends = Ends(crank(angle, Crank(radius)), fixed(0.0 * ground, -ground))
    return trammel(swivel(ends, Swivel(offset, AHEAD)).guide, geometry.trammel)


def slotted_rod(angle: Array, geometry: SlottedRod) -> NamedTuple:
    radius, length, offset = geometry.slider_crank
    rod = slide(crank(angle, Crank(radius)), Slide(length, offset, AHEAD)).rod
    return trammel(turned_link(rod, np.pi / 2), geometry.trammel)


def random_trammel(random: np.random.Generator, size: Array) -> Trammel:
    """Guide up to twice the size away, slot up to the size beside its link."""
    n = len(size)
    return Trammel(size * random.uniform(-2.0, 2.0, size=(n, 1)), size * random.uniform(-1.0, 1.0, size=(n, 1)))


def test_on_a_lever_that_swings_nearly_along_the_guide():
    """The lever is parallel to the guide with its line beside the crank circle, at |e| + R = g: the swivel's margin."""
    machines = swivel_cranks(N, seed=1, is_crank_longer=False)
    random = np.random.default_rng(2)
    radius, ground, offset, _ = machines.geometry
    lean = np.sign(offset) * np.arccos((np.abs(offset) + radius) / ground)
    machines = machines._replace(opening_angle=np.where(offset == 0, 1.0, np.sign(offset)) * (-np.pi / 2) + lean)
    angle = machines.tested_angles(random)
    geometry = SlottedLever(machines.geometry, random_trammel(random, ground))
    exact = oracles.coefficients(oracles.slotted_lever, angle, radius, ground, offset, *geometry.trammel)
    assert_exact(slotted_lever, geometry, angle, exact, machines.margin)


def test_on_a_rod_that_swings_nearly_along_the_guide():
    """The guide crosses the line of stroke: the rod is parallel to it where it can hardly reach its own slider."""
    machines = slider_cranks(N, seed=1)
    random = np.random.default_rng(2)
    angle = machines.tested_angles(random)
    geometry = SlottedRod(machines.geometry, random_trammel(random, machines.geometry.rod_length))
    exact = oracles.coefficients(oracles.slotted_rod, angle, *machines.geometry, np.pi / 2, *geometry.trammel)
    assert_exact(slotted_rod, geometry, angle, exact, machines.margin)
