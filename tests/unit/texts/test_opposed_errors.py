"""(I.11), (I.12), their sum and the minus signs of (333), (336), (337): largest errors against 20-digit arithmetic."""

import mpmath as mp
import numpy as np
import pytest

from cranktrain.mechanisms.slider_crank import SliderCrank
from cranktrain.texts.largest_errors import errors_by_ratio, from_bottom, from_top, largest_errors
from cranktrain.texts.opposed_errors import OpposedPair, opposed_errors
from cranktrain.texts.steam_engine import two_harmonics_from_crank_side

ZERO = np.array(0.0)
PAIR = OpposedPair(
    SliderCrank(np.array(0.127), np.array(0.508), ZERO),
    SliderCrank(np.array(0.12), np.array(0.4), ZERO),
    np.radians(12.0),
)


def exact(theta, radius, ratio):
    return radius * (1 - mp.cos(theta)) + radius / ratio * (1 - mp.sqrt(1 - (ratio * mp.sin(theta)) ** 2))


def printed(theta, radius, ratio):
    """S = R[1 + λ/4 − (cos θ + (λ/4) cos 2θ)]."""
    return radius * (1 + ratio / 4 - (mp.cos(theta) + ratio / 4 * mp.cos(2 * theta)))


def motions(alpha, form):
    first = form(alpha, mp.mpf("0.127"), mp.mpf("0.25"))
    second = form(alpha - mp.pi / 15, mp.mpf("0.12"), mp.mpf("0.3"))
    return first, second, first + second


@pytest.mark.parametrize("part", range(3), ids=["exhaust", "scavenge", "both"])
def test_largest_errors_of_travel(part):
    """On a grid of half degrees in 20 digits: within what the grid leaves of a smooth top."""
    with mp.workdps(20):
        angles = [mp.pi * step / 360 for step in range(720)]
        true = [motions(angle, exact)[part] for angle in angles]
        off = [motions(angle, printed)[part] - one for angle, one in zip(angles, true, strict=True)]
        share = max(map(abs, off)) / (max(true) - min(true))
    found = opposed_errors(PAIR)[part].displacement
    assert float(found.value) == pytest.approx(float(share), rel=2e-4)
    assert float(found.value) >= float(share) * (1 - 1e-6)


def test_both_together_at_a_quarter_is_half_a_millimetre():
    """docs/theory/textbook-forms: λ = ¼, R = 127 mm, Δ = 12°, 0.50 mm of 505 mm."""
    alike = PAIR._replace(scavenge=PAIR.exhaust)
    assert alike.is_alike
    assert not PAIR.is_alike
    error = float(opposed_errors(alike).combined.displacement.value)
    assert round(error * 4 * 127 * float(mp.cos(mp.pi / 30)), 2) == 0.50


@pytest.mark.parametrize("ratio", [0.1, 0.25, 0.3])
def test_minus_signs_have_the_errors_of_the_plus_signs(ratio):
    """The two describe one motion; so its errors are alike, of displacement at 90°."""
    one = SliderCrank(np.array(1.0), np.array(1.0 / ratio), ZERO)
    found = largest_errors(lambda angle: two_harmonics_from_crank_side(angle, 1.0, ratio), from_bottom(one))
    plus = errors_by_ratio("two_harmonics", ratio)
    np.testing.assert_allclose([error.value for error in found], [error.value for error in plus], rtol=1e-9)
    by_hand = (1 - np.sqrt(1 - ratio**2)) / ratio - ratio / 2
    assert float(found.displacement.value) == pytest.approx(by_hand / 2, rel=1e-12)


def test_motion_from_either_end_is_one():
    one = SliderCrank(np.array(0.05), np.array(0.18), np.array(0.01))
    angle = np.radians(np.arange(0.0, 360.0, 15.0))
    top, bottom = from_top(one)(angle + np.pi), from_bottom(one)(angle)
    stroke = np.sqrt(0.23**2 - 0.01**2) - np.sqrt(0.13**2 - 0.01**2)
    np.testing.assert_allclose(top.value + bottom.value, stroke, rtol=1e-14)
    np.testing.assert_allclose(top.first, -bottom.first, atol=1e-16)
