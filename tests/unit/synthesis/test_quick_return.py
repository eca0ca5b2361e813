import tomllib
from math import asin, degrees, pi, sin

import numpy as np
import pytest
from scipy.optimize import brentq

from cranktrain.analysis import run
from cranktrain.errors import InputError
from cranktrain.machine import Machine
from cranktrain.synthesis.four_bars import excess_angle
from cranktrain.synthesis.quick_return import (
    least_pressure_parameter,
    offset_slider_crank,
    quick_return,
    slotted_share,
    slotted_time_ratio,
)


@pytest.mark.parametrize("ratio", [1.05, 1.2, 1.6, 2.5])
@pytest.mark.parametrize("slow_stroke", ["toward", "away"])
def test_run_of_the_offset_slider_crank_gives_the_requirements(ratio, slow_stroke):
    proposal = quick_return(0.3, ratio, slow_stroke=slow_stroke, speed=2.0)
    result = run(Machine(**tomllib.loads(proposal.machine_file())))
    assert result.stroke[0] == pytest.approx(0.3, rel=1e-13)
    toward = (result.bottom_dead_centre[0] - result.top_dead_centre[0]) % 360
    slow, quick = (toward, 360 - toward) if slow_stroke == "toward" else (360 - toward, toward)
    assert slow / quick == pytest.approx(ratio, rel=1e-12)
    assert result.stroke_time_ratio[0] == pytest.approx(ratio, rel=1e-12)


def test_given_rod():
    proposal = quick_return(0.3, 1.2, rod_length=0.4)
    assert proposal.value("rod_length") == pytest.approx(0.4, rel=4e-16)
    assert proposal.value("stroke") == pytest.approx(0.3, rel=1e-14)
    assert proposal.value("time_ratio") == pytest.approx(1.2, rel=1e-14)


@pytest.mark.parametrize("ratio", [1.001, 1.05, 1.2, 2.0, 2.9])
def test_pressure_angle_has_one_least_value_over_the_range_of_the_parameter(ratio):
    excess = excess_angle(ratio)
    grid = np.linspace(excess / 2, (pi - excess) / 2, 2003)[1:-1]
    sines = np.array([(one.crank_radius + one.offset) / one.rod_length for one in _family(excess, grid)])
    assert np.count_nonzero(np.diff(np.sign(np.diff(sines)))) == 1
    (best,) = _family(excess, [least_pressure_parameter(excess)])
    assert (best.crank_radius + best.offset) / best.rod_length <= sines.min()
    assert np.all(sines < 1)


def _family(excess, parameters):
    return [offset_slider_crank(1.0, excess, parameter) for parameter in parameters]


@pytest.mark.parametrize("ratio", [0.2, 0.5, 0.9])
def test_slotted_lever_by_its_motion(ratio):
    """The lever's direction from its pivot at distance 1; its extremes by a root of its angular velocity."""

    def turn(phi):
        x, y = 1 + ratio * np.cos(phi), ratio * np.sin(phi)
        return (x * ratio * np.cos(phi) + y * ratio * np.sin(phi)) / (x * x + y * y)

    forth = brentq(turn, pi / 2, pi, xtol=1e-15)
    slow, quick = 2 * forth, 2 * pi - 2 * forth
    assert slotted_time_ratio(ratio) == pytest.approx(slow / quick, rel=1e-13)
    assert slotted_share(slow / quick) == pytest.approx(ratio, rel=1e-13)
    swing = 2 * np.arctan2(ratio * np.sin(forth), 1 + ratio * np.cos(forth))
    assert excess_angle(slow / quick) == pytest.approx(swing, rel=1e-12)


@pytest.mark.parametrize("distance", [0.2, 0.5, 0.9])
@pytest.mark.parametrize("line", [0.4, 1.2, pi / 2])
def test_whitworth_by_its_motion(distance, line):
    """Crank pin on the unit circle, link's shaft at x = −distance: when does the link lie along the line of stroke."""

    def across(phi):
        return np.sin(phi) * np.cos(line) - (np.cos(phi) + distance) * np.sin(line)

    crossings = [brentq(across, a, a + 0.1) for a in np.arange(0, 2 * pi, 0.1) if across(a) * across(a + 0.1) < 0]
    travel = crossings[1] - crossings[0]
    slow = max(travel, 2 * pi - travel)
    assert slotted_time_ratio(distance * sin(line)) == pytest.approx(slow / (2 * pi - slow), rel=1e-11)


def test_whitworth_back():
    assert slotted_share(slotted_time_ratio(0.37)) == pytest.approx(0.37, rel=1e-15)
    # k = 2: ϑ = 60°
    assert slotted_share(2.0) == pytest.approx(0.5, rel=1e-15)


def test_alternatives_have_the_same_stroke_and_time_ratio():
    lever, drive = quick_return(0.3, 2.0).alternatives
    numbers = {one.name: one.value for one in (*lever.numbers, *drive.numbers)}
    assert numbers["crank_to_distance"] == pytest.approx(0.5, rel=1e-15)
    assert degrees(numbers["swing"]) == pytest.approx(60, rel=1e-15)
    assert 2 * numbers["lever_length"] * sin(numbers["swing"] / 2) == pytest.approx(0.3, rel=1e-15)
    assert 2 * asin(numbers["distance_to_crank"]) == pytest.approx(numbers["swing"], rel=1e-14)
    assert numbers["output_radius"] == 0.15


@pytest.mark.parametrize(
    ("requirements", "path", "words"),
    [
        ({"stroke": 0.3, "time_ratio": 3.0}, "time_ratio", "crank of 0.7071 of the distance"),
        ({"stroke": 0.3, "time_ratio": 1.0}, "time_ratio", "between 1 and 3"),
        ({"stroke": 0.0, "time_ratio": 1.5}, "stroke", "more than 0"),
        # ϑ = 36°: S/2·cot 18° = 461.653 mm
        ({"stroke": 0.3, "time_ratio": 1.5, "rod_length": 1.0}, "rod_length", "between 150 mm and 461.6525 mm"),
    ],
)
def test_impossible_requirements_say_what_is_possible(requirements, path, words):
    with pytest.raises(InputError) as caught:
        quick_return(**requirements)
    (problem,) = caught.value.problems
    assert problem.path == path
    assert words in str(problem)
