import tomllib
from math import asin, degrees, pi, radians

import mpmath
import pytest
from tests.told import texts_of

from cranktrain.analysis import run
from cranktrain.errors import InputError
from cranktrain.machine import Machine
from cranktrain.mechanisms.articulated_rod import ArticulatedRod
from cranktrain.mechanisms.slider_crank import SliderCrank
from cranktrain.synthesis.knuckle import knuckle_from_requirements
from cranktrain.synthesis.knuckle_equations import distance_slope, slave_dead_centres, stroke_product

MASTER = (0.09, 0.32)
BANK = radians(60)
FACTS = ("stroke", "top_position", "top_shift", "bottom_shift", "compression_ratio")
ROD = ArticulatedRod(SliderCrank(0.09, 0.32, 0.004), 0.085, radians(67), BANK, 0.235, 0.0)


def run_of(proposal):
    return run(Machine(**tomllib.loads(proposal.machine_file())), quantities=FACTS)


def names(proposal):
    return {one.name: one.value for one in proposal.numbers}


@pytest.mark.parametrize(
    ("requirements", "known", "expected"),
    [
        # 3D12, fitted by others to stroke and pin height and published with these digits
        (
            {"stroke": 0.1867, "same_height": True},
            {"knuckle_radius": 0.078256},
            {"rod_length": (0.242426, 6e-7), "articulation_angle": (radians(67.458), radians(6e-4))},
        ),
        # ζ = 66.63° gives 186.70 mm with r 85, l 235: 0.98 mm per degree
        (
            {"stroke": 0.1867},
            {"knuckle_radius": 0.085, "rod_length": 0.235},
            {"articulation_angle": (radians(66.63), radians(0.006))},
        ),
        # and 187.07 mm belong to 67°
        (
            {"stroke": 0.18707},
            {"rod_length": 0.235, "articulation_angle": radians(67)},
            {"knuckle_radius": (0.085, 6e-5)},
        ),
        # no shift of the top: ζ = 60° + asin(0.28125 sin 60°), H = R + r + l
        (
            {"unshifted": "top", "same_height": True},
            {"rod_length": 0.235},
            {
                "knuckle_radius": (0.085, 1e-15),
                "articulation_angle": (pi / 3 + asin(0.28125 * 0.75**0.5), 1e-15),
            },
        ),
    ],
)
def test_known_dimensions(requirements, known, expected):
    found = names(knuckle_from_requirements(*MASTER, BANK, **requirements, **known))
    for name, (value, allowed) in expected.items():
        assert abs(found[name] - value) <= allowed


@pytest.mark.parametrize("master_offset", [0.0, 0.012])
@pytest.mark.parametrize("bank", [60, -60, 45, 120])
@pytest.mark.parametrize(
    "requirements",
    [
        {"stroke": 0.1867, "knuckle_radius": 0.085, "rod_length": 0.235},
        {"stroke": 0.1867, "same_height": True, "knuckle_radius": 0.08},
        {"stroke": 0.1867, "same_height": True, "rod_length": 0.24},
        {"stroke": 0.1867, "unshifted": "top", "rod_length": 0.24},
        {"stroke": 0.1867, "unshifted": "top", "same_height": True},
        {"unshifted": "bottom", "same_height": True, "rod_length": 0.24},
        {"unshifted": "bottom", "knuckle_radius": 0.08, "rod_length": 0.24},
        {"stroke": 0.1867, "same_ratio": 14.5, "knuckle_radius": 0.08},
        {"same_height": True, "same_ratio": 14.5, "rod_length": 0.24},
        {"unshifted": "top", "same_ratio": 14.5, "rod_length": 0.24},
    ],
)
def test_run_gives_the_requirements(bank, master_offset, requirements):
    proposal = knuckle_from_requirements(*MASTER, radians(bank), master_offset=master_offset, bore=0.15, **requirements)
    result = run_of(proposal)
    found = names(proposal)
    for name, value in (("stroke", result.stroke[1]), ("top_distance", result.top_position[1])):
        assert found[name] == pytest.approx(value, rel=1e-13)
    assert degrees(found["top_shift"]) == pytest.approx(result.top_shift[1], abs=1e-11)
    assert degrees(found["bottom_shift"]) == pytest.approx(result.bottom_shift[1], abs=1e-11)
    if "stroke" in requirements:
        assert result.stroke[1] == pytest.approx(requirements["stroke"], rel=1e-13)
    if "same_height" in requirements:
        assert result.top_position[1] == pytest.approx(result.top_position[0], rel=1e-13)
    if "unshifted" in requirements:
        shift = result.top_shift if requirements["unshifted"] == "top" else result.bottom_shift
        assert abs(shift[1]) < 1e-11
    if "same_ratio" in requirements:
        assert result.compression_ratio[1] == pytest.approx(14.5, rel=1e-11)


def test_same_wants_by_other_dimensions_have_the_same_stroke_but_not_the_same_dimensions():
    proposal = knuckle_from_requirements(*MASTER, BANK, stroke=0.1867, same_height=True, knuckle_radius=0.08)
    same = [one for one in proposal.alternatives if str(one.label).startswith("the same requirements")]
    assert len(same) == 4
    for one in same:
        numbers = {number.name: number.value for number in one.numbers}
        assert numbers["stroke"] == pytest.approx(0.1867, rel=1e-13)
        assert abs(numbers["height_over_master"]) < 1e-15
        # 13.6 … 13.1 mm over r = 60 … 100 mm
        assert 0.0131 < numbers["stroke_product"] < 0.0136
    assert any("r(1 + r/l) sin(ζ − γ), here 13.4" in remark for remark in texts_of(proposal.remarks))


def test_several_solutions_are_all_told():
    # opposite to the master everything is even about ζ = γ
    proposal = knuckle_from_requirements(*MASTER, pi, stroke=0.19, knuckle_radius=0.1, rod_length=0.22)
    (other,) = [one for one in proposal.alternatives if str(one.label) == "another solution"]
    numbers = {number.name: number.value for number in other.numbers}
    assert numbers["stroke"] == pytest.approx(0.19, rel=1e-13)
    assert numbers["articulation_angle"] - pi == pytest.approx(pi - names(proposal)["articulation_angle"], rel=1e-12)


def test_slopes_in_40_digits():
    at = slave_dead_centres(ROD)
    with mpmath.workdps(40):
        for angle in (float(at.top_angle), 1.0, float(at.bottom_angle)):

            def distance(radius, zeta, rod, angle=angle):
                beta = mpmath.asin((0.09 * mpmath.sin(angle) - 0.004) / 0.32)
                w = zeta - BANK - beta
                along = 0.09 * mpmath.cos(angle - BANK) + radius * mpmath.cos(w)
                across = 0.09 * mpmath.sin(angle - BANK) + radius * mpmath.sin(w)
                return along + mpmath.sqrt(rod**2 - across**2)

            point = (0.085, radians(67), 0.235)
            for order, name in enumerate(("knuckle_radius", "articulation_angle", "rod_length")):
                expected = mpmath.diff(distance, point, tuple(int(i == order) for i in range(3)))
                assert distance_slope(angle, ROD, name) == pytest.approx(float(expected), rel=1e-12, abs=1e-15)


def test_product_that_a_stroke_fixes():
    rod = ROD._replace(articulation_angle=BANK + pi / 6)
    assert stroke_product(rod) == pytest.approx(0.085 * (1 + 85 / 235) / 2, rel=1e-14)


@pytest.mark.parametrize(
    ("requirements", "path", "words"),
    [
        ({"knuckle_radius": 0.08, "rod_length": 0.24}, "stroke", "ask for a stroke"),
        ({"stroke": 0.1867, "knuckle_radius": 0.08}, "", "give more of articulation_angle, rod_length"),
        (
            {"stroke": 0.1867, "same_height": True, "knuckle_radius": 0.08, "rod_length": 0.24},
            "",
            "requirements: 2, free dimensions: 1; leave out more of knuckle_radius, rod_length",
        ),
        (
            {"unshifted": "top", "articulation_angle": 1.2, "rod_length": 0.24},
            "articulation_angle",
            "an unshifted dead centre decides it",
        ),
        ({"stroke": 0.1867, "same_height": True, "same_ratio": 15.0}, "same_height", "decide the height"),
        ({"stroke": 0.3, "knuckle_radius": 0.085, "rod_length": 0.235}, "stroke", "must lie between"),
        (
            {"stroke": 0.175, "knuckle_radius": 0.085, "articulation_angle": radians(67)},
            "stroke",
            "can give",
        ),
        ({"stroke": -0.1, "knuckle_radius": 0.08, "rod_length": 0.24}, "stroke", "more than 0"),
        ({"unshifted": "top", "knuckle_radius": 0.08, "rod_length": 0.05}, "rod_length", "too short"),
    ],
)
def test_impossible_requirements_say_what_is_possible(requirements, path, words):
    with pytest.raises(InputError) as caught:
        knuckle_from_requirements(*MASTER, BANK, **requirements)
    (problem,) = caught.value.problems
    assert problem.path == path
    assert words in str(problem)


def test_master_that_cannot_turn():
    with pytest.raises(InputError, match="master_rod_length"):
        knuckle_from_requirements(0.09, 0.08, BANK, stroke=0.18, knuckle_radius=0.02, rod_length=0.06)
