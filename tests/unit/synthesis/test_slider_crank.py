import tomllib
from math import asin, degrees, pi, radians, sin

import numpy as np
import pytest

from cranktrain.analysis import run
from cranktrain.errors import InputError
from cranktrain.machine import Machine
from cranktrain.synthesis.slider_crank import slider_crank_from_stroke
from cranktrain.synthesis.slider_crank_lengths import best_offset, crank_radius_for, stroke_of

STROKE = 0.16


def run_of(proposal):
    return run(Machine(**tomllib.loads(proposal.machine_file())))


def worst_angles(crank_radius, rod_length, offset):
    """Largest |pressure angle| on the stroke toward the shaft and on the way back, sampled between dead centres."""
    top, bottom = asin(offset / (rod_length + crank_radius)), pi + asin(offset / (rod_length - crank_radius))
    sines = [
        np.abs((crank_radius * np.sin(np.linspace(start, end, 2001)) - offset) / rod_length)
        for start, end in ((top, bottom), (bottom, top + 2 * pi))
    ]
    return tuple(float(np.arcsin(part.max())) for part in sines)


def keeps(rod_length, offset, toward, away):
    """Whether a rod keeps both limits, by sampling alone; the rod may be too short for the stroke."""
    if 4 * rod_length * (rod_length - abs(offset)) <= STROKE**2:
        return False
    angles = worst_angles(crank_radius_for(STROKE, rod_length, offset), rod_length, offset)
    return angles[0] <= toward and angles[1] <= away


def test_central_run_gives_the_requirements():
    proposal = slider_crank_from_stroke(STROKE, radians(30), mean_speed=6.3)
    result = run_of(proposal)
    assert result.stroke[0] == pytest.approx(STROKE, rel=1e-15)
    assert result.mean_piston_speed[0] == pytest.approx(6.3, rel=4e-15)
    assert degrees(result.largest_pressure_angle[0]) == pytest.approx(30, rel=1e-14)


@pytest.mark.parametrize("offset", [0.03, -0.03, 0.2])
@pytest.mark.parametrize(("working", "back"), [(20, 35), (35, 20), (25, 25)])
@pytest.mark.parametrize("working_stroke", ["toward", "away"])
def test_shortest_rod_with_a_given_offset(offset, working, back, working_stroke):
    proposal = slider_crank_from_stroke(
        STROKE, radians(working), return_pressure_angle=radians(back), offset=offset, working_stroke=working_stroke
    )
    rod = proposal.value("rod_length")
    limits = radians(working), radians(back)
    toward, away = limits if working_stroke == "toward" else limits[::-1]
    assert keeps(rod * (1 + 1e-12), offset, toward, away)
    for shorter in (1 - 1e-5, 0.999, 0.95, 0.8, 0.6):  # 2000 samples miss a peak by up to (π/2000)²/2
        assert not keeps(rod * shorter, offset, toward, away)
    angles = worst_angles(proposal.value("crank_radius"), rod, offset)
    expected = angles if working_stroke == "toward" else angles[::-1]
    assert proposal.value("working_pressure_angle") == pytest.approx(expected[0], rel=1e-6)
    assert proposal.value("return_pressure_angle") == pytest.approx(expected[1], rel=1e-6)
    assert run_of(proposal).stroke[0] == pytest.approx(STROKE, rel=4e-15)


@pytest.mark.parametrize(("working", "back"), [(20, 24), (20, 40), (10, 89), (35, 20)])
def test_shortest_rod_with_a_free_offset_beats_every_offset(working, back):
    proposal = slider_crank_from_stroke(STROKE, radians(working), return_pressure_angle=radians(back), offset=None)
    rod, offset = proposal.value("rod_length"), proposal.value("offset")
    assert (offset > 0) == (working < back)
    assert keeps(rod * (1 + 1e-12), offset, radians(working), radians(back))
    for other in np.linspace(-rod, rod, 401):
        assert not keeps(rod * (1 - 1e-4), other, radians(working), radians(back))
    result = run_of(proposal)
    assert result.stroke[0] == pytest.approx(STROKE, rel=4e-15)
    travel = (result.bottom_dead_centre[0] - result.top_dead_centre[0]) % 360
    slow = max(travel, 360 - travel)
    assert proposal.value("time_ratio") == pytest.approx(slow / (360 - slow), rel=1e-12)


def test_two_limits_decide_the_rod_by_their_mean():
    proposal = slider_crank_from_stroke(STROKE, radians(20), return_pressure_angle=radians(25), offset=None)
    assert proposal.value("rod_length") == pytest.approx(STROKE / (2 * sin(radians(22.5))), rel=1e-14)


def test_equal_limits_gain_nothing_by_an_offset():
    proposal = slider_crank_from_stroke(STROKE, radians(30), offset=None)
    assert proposal.value("offset") == 0.0
    assert proposal.value("rod_length") == pytest.approx(0.16, rel=4e-16)


@pytest.mark.parametrize("rod", [0.09, 0.17, 0.27, 1.0])
def test_best_offset_for_a_rod_beats_every_other(rod):
    proposal = slider_crank_from_stroke(STROKE, rod_length=rod, offset=None)
    best = proposal.value("working_pressure_angle")
    most = rod - STROKE**2 / (4 * rod)
    for offset in np.linspace(0, most, 801)[:-1]:
        assert worst_angles(crank_radius_for(STROKE, rod, offset), rod, offset)[0] >= best * (1 - 1e-9)
    assert run_of(proposal).stroke[0] == pytest.approx(STROKE, rel=4e-15)


def test_return_limit_holds_the_best_offset_back():
    proposal = slider_crank_from_stroke(
        STROKE, radians(17), return_pressure_angle=radians(20), rod_length=0.27, offset=None
    )
    assert degrees(proposal.value("return_pressure_angle")) == pytest.approx(20, rel=1e-13)
    assert proposal.value("working_pressure_angle") < radians(17)
    assert proposal.value("working_pressure_angle") > asin(best_offset(STROKE, 0.27).offset / 0.27)


def test_stroke_grows_all_along_the_line_of_best_offsets():
    radius = np.linspace(0.001, 0.999, 999)
    strokes = [stroke_of((r, 1.0, r * (1 - r) / (2 - r))) for r in radius]
    assert np.all(np.diff(strokes) > 0)
    assert strokes[-1] > 2 * 0.9989


@pytest.mark.parametrize(
    ("requirements", "paths", "words"),
    [
        ({"stroke": 0.0, "pressure_angle": 0.5}, ["stroke"], "more than 0"),
        ({"stroke": 0.1}, ["pressure_angle"], "missing"),
        ({"stroke": 0.1, "pressure_angle": 1.6}, ["pressure_angle"], "between 0 and 90 deg"),
        ({"stroke": 0.1, "pressure_angle": 0.5, "mean_speed": 1.0, "speed": 2.0}, ["speed"], "mean_speed"),
        ({"stroke": -0.1, "pressure_angle": 0.5, "speed": -2.0}, ["stroke", "speed"], "more than 0"),
        # (e + √(e² + S²))/2 with e = 30, S = 40 mm
        ({"stroke": 0.04, "rod_length": 0.035, "offset": 0.03}, ["rod_length"], "more than 40 mm"),
        # asin(80/270) = 17.235°
        ({"stroke": 0.16, "pressure_angle": 0.2, "rod_length": 0.27}, ["pressure_angle"], "at least 17.24 deg"),
    ],
)
def test_impossible_requirements_say_what_is_possible(requirements, paths, words):
    with pytest.raises(InputError) as caught:
        slider_crank_from_stroke(**requirements)
    assert [problem.path for problem in caught.value.problems] == paths
    assert words in str(caught.value)
