"""Friction of a slider on its guide: forces put together by hand, and where it locks."""

from math import atan, cos, degrees, pi, radians, sin, tan

import pytest
from tests.told import texts_of

from cranktrain.errors import InputError
from cranktrain.synthesis.guide_friction import locking_angle_of, side_force_share_of
from cranktrain.synthesis.slider_crank import slider_crank_from_stroke


@pytest.mark.parametrize("friction", [0.05, 0.1, 0.3])
@pytest.mark.parametrize("angle", [10, 30, 60])
def test_forces_balance(angle, friction):
    """Along the guide S cos β = P + μN, across it S sin β = N."""
    beta = radians(angle)
    across = side_force_share_of(beta, friction)
    along = across / sin(beta) * cos(beta)
    assert along == pytest.approx(1 + friction * across, rel=1e-14)


def test_locking_angle_is_the_complement_of_the_angle_of_friction():
    assert degrees(locking_angle_of(0.1)) == pytest.approx(84.289406862500, abs=1e-11)
    assert locking_angle_of(1.0) == pytest.approx(pi / 4, rel=1e-15)
    near = locking_angle_of(0.2) - 1e-9
    assert side_force_share_of(near, 0.2) > 1e8


def test_proposal_has_friction_where_it_is_given():
    """β = 30°, μ = 0.1: N/P = tan 30°/(1 − 0.1 tan 30°); the numbers without friction stay."""
    plain = slider_crank_from_stroke(0.16, radians(30))
    with_friction = slider_crank_from_stroke(0.16, radians(30), friction=0.1)
    assert with_friction.numbers[: len(plain.numbers)] == plain.numbers
    share = tan(pi / 6) / (1 - 0.1 * tan(pi / 6))
    assert with_friction.value("side_force_with_friction") == pytest.approx(share, rel=1e-12)
    assert with_friction.value("friction_share") == pytest.approx(0.1 * share, rel=1e-12)
    assert with_friction.value("locking_angle") == pytest.approx(pi / 2 - atan(0.1), rel=1e-15)
    assert any("6.13 %" in remark and "84.29 deg" in remark for remark in texts_of(plain.remarks))


@pytest.mark.parametrize(
    "requirements",
    [{"pressure_angle": radians(70), "friction": 0.5}, {"rod_length": 0.085, "friction": 0.4}],
)
def test_a_slider_that_locks_is_refused(requirements):
    with pytest.raises(InputError, match="locks the slider"):
        slider_crank_from_stroke(0.16, **requirements)


def test_steep_rods_without_friction_are_no_error():
    remark = slider_crank_from_stroke(0.16, radians(86)).remarks[-1]
    assert "–" in str(remark)
