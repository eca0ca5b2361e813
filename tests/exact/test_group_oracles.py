"""The oracles of swivel, yoke, trammel and triad: their blocks lie on their lines, to forty digits."""

import numpy as np
import pytest
from flint import arb, arb_series
from tests.exact import oracles

ANGLES = np.linspace(-3.0, 3.0, 7).tolist()


def assert_zero(residual: arb_series) -> None:
    for order in range(oracles.ORDER):
        assert residual[order].contains(0)
        assert residual[order].abs_upper() < 1e-38


@pytest.mark.parametrize("angle", ANGLES)
@pytest.mark.parametrize(("offset", "side"), [(0.11, 1.0), (-0.07, -1.0), (0.0, 1.0)])
def test_slider_of_a_swivel_is_on_its_guide(angle, offset, side):
    with oracles.series_arithmetic():
        motion = oracles.swivel_crank(angle, 0.3, 0.5, offset, side)
        along = motion["guide.cos"], motion["guide.sin"]
        apart = oracles.difference(oracles.crank_pin(angle, arb(0.3)), (oracles.constant(0.5), oracles.constant(0)))
        assert_zero(oracles.dot(along, along) - 1)
        assert_zero(oracles.dot(oracles.left_of(along), apart) - offset)
        assert_zero(oracles.dot(along, apart) - motion["slider"])
        assert (motion["slider"][0] > 0) == (side > 0)
        sin, cos = motion["guide.angle"].sin_cos()
        assert_zero(cos - along[0])
        assert_zero(sin - along[1])


@pytest.mark.parametrize("angle", ANGLES)
def test_block_of_a_yoke_is_on_the_pin(angle):
    with oracles.series_arithmetic():
        motion = oracles.yoke_crank(angle, 0.3, 0.1, 1.2)
        slot = oracles.unit(arb(1.2))
        block = oracles.along((motion["slider"], oracles.constant(0.1)), slot, motion["block"])
        for residual in oracles.difference(block, oracles.crank_pin(angle, arb(0.3))):
            assert_zero(residual)


@pytest.mark.parametrize("angle", ANGLES)
def test_block_of_a_trammel_is_on_the_lever(angle):
    with oracles.series_arithmetic():
        motion = oracles.slotted_lever(angle, 0.3, 0.5, 0.05, 0.4, 0.02)
        pivot = oracles.constant(0), oracles.constant(-0.5)
        _, along = oracles.swivel_on_line(oracles.crank_pin(angle, arb(0.3)), pivot, arb(0.05), 1.0)
        slider = oracles.difference((motion["slider"], oracles.constant(0.4)), pivot)
        assert_zero(oracles.dot(along, slider) - motion["block"])
        assert_zero(oracles.dot(oracles.left_of(along), slider) - arb(0.02))


def test_legs_of_a_triad_hold():
    legs = [
        oracles.LegNumbers(0.1, 0.2, 0.1, 0.5, 0.0, 0.0, 0.0, 0.4, 0.3, 0.9, 0.0),
        oracles.LegNumbers(1.5, 0.2, 0.0, 0.0, 0.4, 0.2, 1.0, 0.5, 2.0, 0.1, 1.0),
        oracles.LegNumbers(0.4, 1.6, 0.0, 0.0, 0.0, 0.0, 0.0, 0.6, 4.0, 0.9, 0.0),
    ]
    near = 0.94979698, 0.22102457, -1.87358008
    with oracles.series_arithmetic():
        # Eight digits are a start too.
        motion = oracles.triad(0.3, *near, *(number for leg in legs for number in leg))
        pose = [motion[f"link.{name}"] for name in ("origin.x", "origin.y", "angle")]
        vectors = [oracles.leg_vectors(arb_series([0.3, 1]), leg) for leg in legs]
        for opening in oracles.triad_openings(pose, legs, vectors):
            assert_zero(opening)
        sin, cos = pose[2].sin_cos()
        assert_zero(cos - motion["link.cos"])
        assert_zero(sin - motion["link.sin"])
        assert [float(part[0]) for part in pose] == pytest.approx(near, abs=1e-8)
