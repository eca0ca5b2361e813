"""(I.11) and (I.12) against the printed formulas in 40 digits, and their errors against the exact triangle."""

import mpmath as mp
import numpy as np
import pytest

from cranktrain.texts.opposed import (
    OpposedSize,
    combined_stroke,
    opposed_pistons,
    volumetric_dead_centres,
    volumetric_dead_centres_to_first_order,
)

SIZE = OpposedSize(0.127, 0.22, 0.12, 0.26, np.radians(12.0))
ANGLES = np.radians([0.0, 6.0, 33.0, 90.0, 171.0, 186.0, 300.0])


def printed(theta, radius, ratio):
    """S = R[1 + λ/4 − (cos θ + (λ/4) cos 2θ)]."""
    return radius * (1 + ratio / 4 - (mp.cos(theta) + ratio / 4 * mp.cos(2 * theta)))


def exact(theta, radius, ratio):
    """Displacement from the inner dead centre, from the triangle of crank and rod."""
    rod = radius / ratio
    return radius * (1 - mp.cos(theta)) + rod * (1 - mp.sqrt(1 - (ratio * mp.sin(theta)) ** 2))


def both(form, alpha, size=SIZE):
    exhaust, scavenge = (size.exhaust_radius, size.exhaust_ratio), (size.scavenge_radius, size.scavenge_ratio)
    first = form(alpha, *map(mp.mpf, exhaust))
    return first, form(alpha - mp.mpf(float(size.lead)), *map(mp.mpf, scavenge))


@pytest.mark.parametrize("order", [0, 1, 2])
def test_pistons_are_as_printed(order):
    found = opposed_pistons(ANGLES, SIZE)
    with mp.workdps(40):
        for place, alpha in enumerate(ANGLES):
            for which, motion in enumerate((found.exhaust, found.scavenge)):
                expected = float(mp.diff(lambda x, which=which: both(printed, x)[which], mp.mpf(alpha), order))
                assert motion[order][place] == pytest.approx(expected, rel=0, abs=2e-16)
    np.testing.assert_allclose(found.combined[order], found.exhaust[order] + found.scavenge[order], rtol=1e-15)


def root(alpha):
    """Where the exact combined displacement is stationary, near an angle. [rad]"""
    with mp.workdps(30):
        slope = lambda x: mp.diff(lambda y: sum(both(exact, y)), x)  # noqa: E731 - a function of one line
        return float(mp.findroot(slope, mp.mpf(alpha)))


def test_volumetric_dead_centres():
    """The source's Δ/2 misses by up to a quarter of a degree; to first order in the lead by less than 0.001°."""
    true = [root(0.1), root(np.pi + 0.1)]
    source, better = volumetric_dead_centres(SIZE.lead), volumetric_dead_centres_to_first_order(SIZE)
    np.testing.assert_allclose(np.degrees(source), [6.0, 186.0], rtol=1e-15)
    for plain, first_order, angle in zip(source, better, true, strict=True):
        assert abs(np.degrees(first_order - angle)) < 1.2e-3
        assert 0.05 < abs(np.degrees(plain - angle)) < 0.6


def test_equal_sizes_have_half_the_lead_and_the_stroke_of_the_closed_form():
    size = OpposedSize(0.08, 0.25, 0.08, 0.25, np.radians(11.0))
    inner, outer = volumetric_dead_centres_to_first_order(size)
    np.testing.assert_allclose([inner, outer], volumetric_dead_centres(size.lead), rtol=1e-15)
    motion = opposed_pistons(np.array([inner, outer]), size).combined
    assert motion.value[1] - motion.value[0] == pytest.approx(float(combined_stroke(0.08, size.lead)), rel=1e-14)
    np.testing.assert_allclose(motion.first, 0.0, atol=1e-16)
    # Jumo 205: 318.5267834775 mm from the exact triangles, in 40 digits
    with mp.workdps(40):
        stroke = sum(both(exact, mp.mpf(float(outer)), size)) - sum(both(exact, mp.mpf(float(inner)), size))
    assert float(combined_stroke(0.08, size.lead)) == pytest.approx(float(stroke), rel=1e-14)
    assert float(stroke) == pytest.approx(0.3185267834775, abs=1e-13)


def test_error_of_the_combined_displacement():
    """At λ = ¼, R = 127 mm and Δ = 12° the sum is off by 0.50 mm of the 505 mm that both travel."""
    size = OpposedSize(0.127, 0.25, 0.127, 0.25, np.radians(12.0))
    angles = np.radians(np.arange(0.0, 360.0, 2.0))
    found = opposed_pistons(angles, size).combined.value
    with mp.workdps(20):
        off = [float(sum(both(exact, mp.mpf(angle), size))) for angle in angles] - found
    assert round(1e3 * np.max(np.abs(off)), 2) == 0.50
    assert round(1e3 * float(combined_stroke(0.127, size.lead))) == 505
