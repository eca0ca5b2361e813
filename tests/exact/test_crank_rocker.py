"""Crank-rocker kernel, with a coupler point, against 50 digits."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from tests.exact import oracles
from tests.exact.agreement import assert_exact
from tests.exact.geometries import crank_rockers

from cranktrain.linkage import LinkPoint, point
from cranktrain.mechanisms.crank_rocker.kinematics import CrankRocker, crank_rocker
from cranktrain.motion import Link, Point


class CoupledRocker(NamedTuple):
    """A crank-rocker and a point of its rod."""

    linkage: CrankRocker
    point: LinkPoint


class CoupledRockerMotion(NamedTuple):
    pin: Point
    joint: Point
    rod: Link
    rocker: Link
    coupler_point: Point


def coupled_rocker(angle: NDArray[np.float64], geometry: CoupledRocker) -> CoupledRockerMotion:
    motion = crank_rocker(angle, geometry.linkage)
    return CoupledRockerMotion(*motion, point(motion.rod, geometry.point))


def test_crank_rocker_and_coupler_point_are_exact():
    machines = crank_rockers(10_000, seed=1)
    random = np.random.default_rng(2)
    angle = machines.tested_angles(random)
    shape = machines.margin.shape
    coupler_point = LinkPoint(
        machines.geometry.rod_length * random.uniform(0.0, 2.0, size=shape), random.uniform(-np.pi, np.pi, size=shape)
    )
    exact = oracles.coefficients(oracles.crank_rocker, angle, *machines.geometry, *coupler_point)
    geometry = CoupledRocker(machines.geometry, coupler_point)
    assert_exact(coupled_rocker, geometry, angle, exact, machines.margin)
