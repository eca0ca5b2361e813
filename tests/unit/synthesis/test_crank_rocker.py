import tomllib
from math import degrees, pi, radians

import mpmath
import numpy as np
import pytest

from cranktrain.analysis import run
from cranktrain.errors import InputError
from cranktrain.machine import Machine
from cranktrain.synthesis.crank_rocker import crank_rocker_from_swing
from cranktrain.synthesis.four_bars import (
    FourBarRequirements,
    best_parameter,
    excess_angle,
    four_bar,
    judged,
    largest_time_ratio,
    parameter_range,
)

# swing and time ratio, side of the chord on the pivot's side: ξ, R/r, l/r, g/r, smallest transmission angle; by an
# independent optimisation whose ξ is good to the square root of rounding, its angles to rounding
REFERENCE = [
    ((50.0, 1.2), 19.70520952026503, 0.4019610744739019, 1.0012925573425584, 1.139660206033096, 43.25994072597975),
    ((40.0, 1.1), 13.602619277497324, 0.33335870236643667, 1.0763874676815541, 1.2676153946191602, 53.32582206585577),
    ((70.0, 1.25), 20.556731126427366, 0.5453388646263987, 1.1598311270377064, 1.2135949020881722, 35.06514338102088),
    ((60.0, 1.05), 7.728420950970219, 0.4958221513916749, 1.7554587159138257, 1.8578171899886728, 50.63972620875512),
]
WANTS = [(50, 1.2), (10, 1.5), (70, 2.0), (120, 1.3), (170, 1.01), (50, 4.5), (3, 1.001)]


def run_of(proposal):
    return run(Machine(**tomllib.loads(proposal.machine_file())))


@pytest.mark.parametrize(("requirements", "xi", "radius", "rod", "ground", "transmission"), REFERENCE)
def test_reference_numbers(requirements, xi, radius, rod, ground, transmission):
    proposal = crank_rocker_from_swing(radians(requirements[0]), requirements[1], 1.0)
    assert degrees(proposal.value("transmission_angle")) == pytest.approx(transmission, rel=3e-14)
    assert degrees(proposal.value("parameter")) == pytest.approx(xi, abs=1e-6)
    for name, expected in (("crank_radius", radius), ("rod_length", rod), ("ground_length", ground)):
        assert proposal.value(name) == pytest.approx(expected, abs=1e-7)


def test_best_parameter_in_40_digits():
    swing, ratio = 50, 1.2
    with mpmath.workdps(40):
        gamma, theta = mpmath.radians(swing), mpmath.pi * (mpmath.mpf("1.2") - 1) / (mpmath.mpf("1.2") + 1)

        def cosine(xi):
            """Cosine of μ with the crank toward the pivot, from the shaft's coordinates."""
            c = 2 * mpmath.sin(gamma / 2)
            r = c / 2 * mpmath.cos(xi) / mpmath.cos(theta / 2)
            l = c / 2 * mpmath.sin(xi) / mpmath.sin(theta / 2)
            x = -2 * l * r / c
            y = -mpmath.sqrt(l**2 + r**2 - c**2 / 4 - x**2)
            d = mpmath.hypot(x, y + mpmath.cos(gamma / 2))
            return (l**2 + 1 - (d - r) ** 2) / (2 * l)

        expected = mpmath.findroot(lambda xi: mpmath.diff(cosine, xi), mpmath.radians(19.7))
    found = crank_rocker_from_swing(radians(swing), ratio, 1.0).value("parameter")
    assert found == pytest.approx(float(expected), rel=1e-14)


@pytest.mark.parametrize("slow_swing", ["forward", "backward"])
@pytest.mark.parametrize(("swing", "ratio"), [(50, 1.2), (100, 1.1), (20, 2.0)])
def test_run_gives_the_requirements(swing, ratio, slow_swing):
    proposal = crank_rocker_from_swing(radians(swing), ratio, 0.4, slow_swing=slow_swing, speed=3.0)
    result = run_of(proposal)
    assert degrees(result.swing[0]) == pytest.approx(swing, rel=1e-13)
    assert result.time_ratio[0] == pytest.approx(ratio, rel=1e-13)
    assert result.grashof_class[0] == 0
    forward = (result.largest_rocker_angle_at[0] - result.smallest_rocker_angle_at[0]) % 360
    assert (forward > 180) == (slow_swing == "forward")
    smallest = min(result.smallest_transmission_angle[0], pi - result.largest_transmission_angle[0])
    assert smallest == pytest.approx(proposal.value("transmission_angle"), rel=1e-12)


@pytest.mark.parametrize("side", [-1, 1])
@pytest.mark.parametrize(("swing", "ratio"), WANTS)
def test_range_holds_all_crank_rockers_of_one_branch_and_the_best(swing, ratio, side):
    requirement = FourBarRequirements(radians(swing), excess_angle(ratio), 1.0)
    start, end = parameter_range(requirement, side)
    assert (start < end) == (ratio < largest_time_ratio(requirement.swing, side))
    every = np.linspace(requirement.excess / 2, pi / 2, 1001)[1:-1]
    verdict = judged(requirement, four_bar(requirement, every, side))
    usable = (verdict.grashof_class == 0) & verdict.is_one_branch
    np.testing.assert_array_equal(usable, (every > start) & (every < end))
    if start < end:
        best = four_bar(requirement, np.array(best_parameter(requirement, side)), side)
        assert judged(requirement, best).transmission_angle >= np.max(verdict.transmission_angle[usable])


def test_largest_time_ratio_is_the_end():
    swing = radians(50)
    most = largest_time_ratio(swing, -1)
    assert crank_rocker_from_swing(swing, most * 0.999, 1.0).value("transmission_angle") > 0
    with pytest.raises(InputError, match=r"less than 4\.538 for a swing of 50\.00 deg"):
        crank_rocker_from_swing(swing, most * 1.001, 1.0)


@pytest.mark.parametrize("swing", [20, 60, 120])
def test_equal_swings_with_a_transmission_angle(swing):
    proposal = crank_rocker_from_swing(radians(swing), 1.0, 0.5, transmission_angle=radians(25))
    result = run_of(proposal)
    assert degrees(result.swing[0]) == pytest.approx(swing, rel=1e-13)
    assert result.time_ratio[0] == pytest.approx(1, rel=1e-13)
    assert degrees(result.smallest_transmission_angle[0]) == pytest.approx(25, rel=1e-12)
    assert degrees(result.largest_transmission_angle[0]) == pytest.approx(155, rel=1e-12)


def test_equal_swings_with_a_rod():
    # swing 60°: R = r/2, g² = l² + 3r²/4 = 1 + 0.75·0.36
    proposal = crank_rocker_from_swing(radians(60), 1.0, 0.6, rod_length=1.0)
    assert proposal.value("crank_radius") == pytest.approx(0.3, rel=1e-15)
    assert proposal.value("ground_length") == pytest.approx(1.27**0.5, rel=1e-15)


def test_alternatives_say_why_they_are_none():
    labels = [str(one.label) for one in crank_rocker_from_swing(radians(60), 1.05, 1.0).alternatives]
    assert any("different branches" in label for label in labels)
    assert sum("against the sense of rotation" in label for label in labels) == 1


@pytest.mark.parametrize(
    ("requirements", "options", "path", "words"),
    [
        ((50, 1.2), {"transmission_angle": radians(45)}, "transmission_angle", "at most 43.26 deg"),
        ((50, 1.2), {"rod_length": 1.0}, "rod_length", "left out"),
        ((50, 3.0), {"slow_swing": "backward"}, "time_ratio", "up to 4.538"),
        ((50, 0.9), {}, "time_ratio", "at least 1"),
        ((180, 1.1), {}, "swing", "between 0 and 180 deg"),
        ((50, 1.0), {}, "rod_length", "the rod is free"),
        ((50, 1.0), {"rod_length": 1.0, "transmission_angle": 0.5}, "rod_length", "must not stand beside"),
        # sin 25° = 0.42262
        ((50, 1.0), {"rod_length": 0.4}, "rod_length", "more than the crank radius, 422.6183 mm"),
        ((50, 1.0), {"transmission_angle": radians(65)}, "transmission_angle", "less than 65.00 deg"),
    ],
)
def test_impossible_requirements_say_what_is_possible(requirements, options, path, words):
    with pytest.raises(InputError) as caught:
        crank_rocker_from_swing(radians(requirements[0]), requirements[1], 1.0, **options)
    (problem,) = caught.value.problems
    assert problem.path == path
    assert words in str(problem)
