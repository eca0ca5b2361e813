"""Chains: as named mechanisms made of the same groups, astern, in a bank, and what is refused."""

import copy
import tomllib

import numpy as np
import pytest
from tests.machines import ROCKER

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.mechanisms import kind_named

EXAMPLE = tomllib.loads(kind_named("chain").example)["mechanism"]


def chain(**changes):
    return copy.deepcopy(EXAMPLE) | changes


def problems(mechanism):
    with pytest.raises(InputError) as caught:
        ct.run(ct.Machine(mechanism=mechanism))
    return caught.value.problems


def refusal(mechanism):
    (problem,) = problems(mechanism)
    return problem


def slider_crank(**changes):
    part = {
        "type": "slide",
        "rod": {"name": "link", "from": "main.pin", "length": "180 mm"},
        "slider": "piston",
        "guide": {"through": "O", "direction": "0 deg", "offset": "10 mm"},
        "side": "ahead",
    }
    return {"kind": "chain", "output": "piston", "crank": {"main": {"radius": "50 mm"}}, "part": [part | changes]}


def test_slider_crank_as_a_chain():
    own = {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "180 mm", "offset": "10 mm"}
    cylinder = {"bore": "80 mm", "compression_ratio": 9.5}
    one = ct.run(ct.Machine(mechanism=slider_crank(), cylinder=cylinder))
    other = ct.run(ct.Machine(mechanism=own, cylinder=cylinder))
    for name in ("piston_displacement", "piston_acceleration_coefficient", "stroke", "top_shift", "chamber_volume"):
        np.testing.assert_allclose(getattr(one, name), getattr(other, name), rtol=1e-13, atol=1e-15)
    np.testing.assert_allclose(one.link_angle, other.rod_angle, atol=1e-15)
    assert one.closing_margin == pytest.approx(other.closing_margin, rel=1e-9)
    assert "part[0].rod.length" in one.summary()
    assert one.labels["point"] == ("1.main.pin", "1.piston.pin")
    np.testing.assert_allclose(one.point_y[1], 0.01, atol=1e-16)


@pytest.mark.parametrize("running", ["ahead", "astern"])
def test_a_turned_guide_only_turns_the_machine(running):
    straight = ct.run(ct.Machine(running=running, mechanism=slider_crank()))
    guide = {"through": "O", "direction": "70 deg", "offset": "10 mm"}
    turned = ct.run(ct.Machine(running=running, mechanism=slider_crank(guide=guide)))
    sign = 1 if running == "ahead" else -1
    assert turned.top_shift[0] == pytest.approx(straight.top_shift[0] + sign * 70, abs=1e-9)
    assert turned.stroke == pytest.approx(straight.stroke, rel=1e-13)
    np.testing.assert_allclose(
        np.roll(turned.piston_displacement[0], -sign * 70), straight.piston_displacement[0], atol=1e-15
    )


@pytest.mark.parametrize("side", ["left", "right"])
@pytest.mark.parametrize("running", ["ahead", "astern"])
def test_crank_rocker_as_a_chain(side, running):
    part = {
        "type": "pin",
        "rod": {"name": "rod", "from": "main.pin", "length": "360 mm"},
        "rocker": {"name": "rocker", "from": "C", "length": "280 mm"},
        "joint": "B",
        "side": side,
    }
    mechanism = {
        "kind": "chain",
        "output": "rocker",
        "fixed": {"C": ["400 mm", "0 mm"]},
        "crank": {"main": {"radius": "100 mm"}},
        "part": [part],
    }
    one = ct.run(ct.Machine(mechanism=mechanism, running=running))
    other = ct.run(ct.Machine(mechanism=ROCKER | {"side": side}, running=running))
    for name in ("swing", "time_ratio", "rocker_angle", "rocker_acceleration_coefficient"):
        np.testing.assert_allclose(getattr(one, name), getattr(other, name), rtol=1e-12, atol=1e-14)
    assert "coupler_angle" not in one.catalogue
    assert all(check.passed.all() for check in one.checks)


def test_scotch_yoke_and_trammel():
    """A yoke along a turned guide; a block where the rod of a slider-crank crosses a line across the stroke."""
    yoke = {
        "type": "yoke",
        "pin": "main.pin",
        "slider": "piston",
        "guide": {"through": "O", "direction": "30 deg"},
    }
    result = ct.run(ct.Machine(mechanism=slider_crank() | {"part": [yoke]}))
    assert result.stroke == pytest.approx(0.1, rel=1e-14)
    assert result.top_shift[0] == pytest.approx(30, abs=1e-9)
    assert np.isnan(result.closing_margin[0])
    trammel = {
        "type": "trammel",
        "link": "link",
        "slider": "block",
        "guide": {"through": "C", "direction": "90 deg"},
    }
    table = slider_crank(guide={"through": "O", "direction": "0 deg"})
    table |= {"fixed": {"C": ["100 mm", "0 mm"]}, "output": "block", "part": [*table["part"], trammel]}
    result = ct.run(ct.Machine(mechanism=table))
    phi = np.radians(result.crank_angle)
    pin = 0.05 * np.exp(1j * phi)
    slope = np.tan(np.arcsin(-pin.imag / 0.18))
    height = pin.imag + slope * (0.1 - pin.real)
    np.testing.assert_allclose(np.max(height) - result.piston_displacement[0], height, atol=1e-4)
    assert result.labels["slider"] == ("1.piston",)


def test_chains_in_a_bank():
    machine = ct.Machine(
        shaft={"main": {"throws": ["0 deg", "180 deg"]}},
        bank={"L": {"mechanism": slider_crank()}, "R": {"angle": "60 deg", "mechanism": chain()}},
    )
    result = ct.run(machine)
    assert result.labels["piston"] == ("1L", "2L", "1R", "2R")
    assert result.stroke[0] == pytest.approx(result.stroke[1], rel=1e-13)
    assert result.stroke[2] == pytest.approx(result.stroke[3], rel=1e-13)


def with_part(place, **changes):
    table = chain()
    table["part"][place] |= changes
    return table


def test_a_name_used_before_it_exists():
    table = chain()
    table["part"].reverse()
    (problem,) = problems(table)
    assert (problem.path, problem.given) == ("mechanism.part[0].rod.from", "B")
    assert "further down" in problem.allowed


def test_an_unknown_name_is_guessed():
    problem = refusal(with_part(1, rod={"name": "link", "from": "main", "length": "250 mm"}))
    assert problem.path == "mechanism.part[1].rod.from"
    assert "main.pin" in problem.repair


def test_a_name_twice():
    problem = refusal(with_part(1, rod={"name": "pitman", "from": "B", "length": "250 mm"}))
    assert (problem.path, problem.given) == ("mechanism.part[1].rod.name", "pitman")


def test_a_part_that_nothing_drives():
    table = chain(fixed={"C": ["300 mm", "400 mm"], "D": ["100 mm", "400 mm"]})
    table["part"].append(
        {
            "type": "pin",
            "rod": {"name": "one", "from": "C", "length": "300 mm"},
            "rocker": {"name": "other", "from": "D", "length": "300 mm"},
            "joint": "E",
            "side": "left",
        }
    )
    problem = refusal(table)
    assert problem.path == "mechanism.part[2]"
    assert "not driven" in problem.allowed


@pytest.mark.parametrize(("output", "repair"), [("ram", "did you mean ram?"), ("ramm", "did you mean ram?")])
def test_an_output_that_does_not_exist(output, repair):
    table = chain(output=output)
    if output == "ram":
        table["part"][1]["slider"] = "plunger"
        assert refusal(table).path == "mechanism.output"
    else:
        problem = refusal(table)
        assert (problem.path, problem.repair) == ("mechanism.output", repair)


def test_no_output():
    table = chain()
    del table["output"]
    problem = refusal(table)
    assert problem.path == "mechanism.output"
    assert "is missing" in problem.allowed


def test_unknown_reference_of_a_guide():
    problem = refusal(with_part(1, guide={"through": "B", "direction": "-90 deg"}))
    assert problem.path == "mechanism.part[1].guide.through"
    assert "a fixed point" in problem.allowed


def test_unknown_type():
    problem = refusal(with_part(1, type="slid"))
    assert problem.path == "mechanism.part[1].type"
    assert "slide" in problem.repair


def test_two_cranks_at_different_speeds():
    table = chain(crank={"main": {"radius": "50 mm"}, "other": {"radius": "20 mm", "ratio": 2}})
    problem = refusal(table)
    assert problem.path == "mechanism.crank.other.ratio"
    assert "one shaft" in problem.allowed


def test_main_crank_is_needed_and_counts_from_zero():
    assert refusal(chain(crank={"main": {"radius": "50 mm", "angle": "5 deg"}})).path == "mechanism.crank.main.angle"
    assert "mechanism.crank.main" in {problem.path for problem in problems(chain(crank={"x": {"radius": "50 mm"}}))}


@pytest.mark.parametrize("name", ["O", "a b", "C"])
def test_bad_names(name):
    table = with_part(0, joint=name)
    table["part"][1]["rod"]["from"] = "main.pin"
    assert "mechanism.part[0].joint" in {problem.path for problem in problems(table)}


def test_a_part_that_cannot_close_says_where_and_by_how_much():
    problem = refusal(with_part(1, rod={"name": "link", "from": "B", "length": "80 mm"}))
    assert problem.path == "mechanism.part[1]"
    assert "link, ram" in problem.allowed
    assert "short by" in problem.allowed
    assert "deg" in problem.allowed
    problem = refusal(with_part(0, rod={"name": "pitman", "from": "main.pin", "length": "200 mm"}))
    assert problem.path == "mechanism.part[0]"


def test_slot_along_the_guide():
    yoke = {
        "type": "yoke",
        "pin": "main.pin",
        "slider": "piston",
        "guide": {"through": "O", "direction": "30 deg"},
        "slot_angle": "0 deg",
    }
    assert refusal(slider_crank() | {"part": [yoke]}).path == "mechanism.part[0].slot_angle"


def test_many_angles_are_as_few():
    few = ct.run(ct.Machine(mechanism=chain()), step_degrees=1)
    many = ct.run(ct.Machine(mechanism=chain()), step_degrees=0.05)
    np.testing.assert_allclose(many.piston_displacement[:, ::20], few.piston_displacement, atol=1e-15)
    np.testing.assert_allclose(many.point_x[:, ::20], few.point_x, atol=1e-15)
