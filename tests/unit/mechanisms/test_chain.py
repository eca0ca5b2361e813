"""Chains: as named mechanisms made of the same groups, astern, in a bank, and what is refused."""

import copy
import tomllib

import numpy as np
import pytest
from tests.machines import ROCKER

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.mechanisms import KINDS
from cranktrain.questions.motion.closing import Closing

EXAMPLE = tomllib.loads(KINDS.named("chain").example)["mechanism"]


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
    assert one[Closing].length_names == (("part[0].rod.length",),)
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
    assert "further down" in str(problem.allowed)


def test_an_unknown_name_is_guessed():
    problem = refusal(with_part(1, rod={"name": "link", "from": "main", "length": "250 mm"}))
    assert problem.path == "mechanism.part[1].rod.from"
    assert "main.pin" in str(problem.repair)


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
    assert "not driven" in str(problem.allowed)


@pytest.mark.parametrize(("output", "repair"), [("ram", "did you mean ram?"), ("ramm", "did you mean ram?")])
def test_an_output_that_does_not_exist(output, repair):
    table = chain(output=output)
    if output == "ram":
        table["part"][1]["slider"] = "plunger"
        assert refusal(table).path == "mechanism.output"
    else:
        problem = refusal(table)
        assert (problem.path, str(problem.repair)) == ("mechanism.output", repair)


def test_no_output():
    table = chain()
    del table["output"]
    problem = refusal(table)
    assert problem.path == "mechanism.output"
    assert "is missing" in str(problem.allowed)


def test_unknown_reference_of_a_guide():
    problem = refusal(with_part(1, guide={"through": "B", "direction": "-90 deg"}))
    assert problem.path == "mechanism.part[1].guide.through"
    assert "a fixed point" in str(problem.allowed)


def test_unknown_type():
    problem = refusal(with_part(1, type="slid"))
    assert problem.path == "mechanism.part[1].type"
    assert "slide" in str(problem.repair)


def test_two_cranks_at_different_speeds():
    table = chain(crank={"main": {"radius": "50 mm"}, "other": {"radius": "20 mm", "ratio": 2}})
    problem = refusal(table)
    assert problem.path == "mechanism.crank.other.ratio"
    assert "one shaft" in str(problem.allowed)


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
    assert "link, ram" in str(problem.allowed)
    assert "short by" in str(problem.allowed)
    assert "deg" in str(problem.allowed)
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


def triad(**near):
    """A plate on three rods, of which it fits two ways."""
    legs = [
        {"joint": "P", "rod": {"name": "first", "from": "main.pin", "length": "1200 mm"}} | near,
        {"joint": "Q", "along": "800 mm", "rod": {"name": "second", "from": "A", "length": "1100 mm"}},
        {
            "joint": "S",
            "along": "500 mm",
            "across": "1200 mm",
            "rod": {"name": "lever", "from": "B", "length": "900 mm"},
        },
    ]
    return {
        "kind": "chain",
        "output": "lever",
        "crank": {"main": {"radius": "100 mm"}},
        "fixed": {"A": ["1500 mm", "200 mm"], "B": ["400 mm", "1600 mm"]},
        "part": [{"type": "triad", "link": "plate", "leg": legs}],
    }


def position(result, name):
    place = result.labels["point"].index(f"1.{name}")
    return result.point_x[..., place, :] + 1j * result.point_y[..., place, :]


@pytest.mark.parametrize("running", ["ahead", "astern"])
@pytest.mark.parametrize("near", [["0 m", "1.2 m"], ["1.2 m", "0.4 m"]])
def test_a_triad_is_put_together_as_the_file_says(near, running):
    wanted = ["point_x", "rocker_angle"]
    result = ct.run(ct.Machine(mechanism=triad(near=near), running=running), quantities=wanted)
    sign = 1 if running == "ahead" else -1
    first = position(result, "P")[0]
    assert abs(first - complex(float(near[0].split()[0]), sign * float(near[1].split()[0]))) < 0.1
    apart = np.abs(position(result, "P") - position(result, "main.pin"))
    np.testing.assert_allclose(apart, 1.2, rtol=1e-14)
    np.testing.assert_allclose(np.abs(position(result, "S") - (0.4 + sign * 1.6j)), 0.9, rtol=1e-14)
    np.testing.assert_allclose(np.abs(position(result, "Q") - position(result, "P")), 0.8, rtol=1e-14)
    assert all(check.passed.all() for check in result.checks)


def test_designs_with_triads_are_as_alone():
    tables = [triad(near=["0 m", "1.2 m"]) | {"crank": {"main": {"radius": f"{r} mm"}}} for r in (80, 100, 150)]
    machines = [ct.Machine(mechanism=table) for table in tables]
    together = ct.run(machines, quantities=["rocker_angle", "swing"])
    for design, machine in enumerate(machines):
        alone = ct.run(machine, quantities=["rocker_angle", "swing"])
        np.testing.assert_allclose(together.rocker_angle[design], alone.rocker_angle, atol=1e-13)
        assert together.swing[design] == pytest.approx(alone.swing, rel=1e-12)


def test_a_triad_of_unclear_mode_names_the_ways():
    problem = refusal(triad())
    assert problem.path == "mechanism.part[0].link"
    assert "2 ways" in str(problem.allowed)
    assert "P (9.17" in str(problem.allowed)


def test_a_triad_that_cannot_turn_says_where_and_by_how_much():
    table = triad(near=["0 m", "1.2 m"])
    table["crank"]["main"]["radius"] = "500 mm"
    problem = refusal(table)
    assert problem.path == "mechanism.part[0]"
    assert "cannot close at crank angles 33.87 deg to 142.66 deg (short by 282.53 mm)" in str(problem.allowed)
    assert "plate" in str(problem.allowed)
    partial = ct.run(ct.Machine(mechanism=table), partial=True, quantities=["rocker_angle"])
    np.testing.assert_array_equal(np.flatnonzero(np.isnan(partial.rocker_angle[0])), np.arange(34, 143))


def test_a_triad_that_does_not_close_at_all():
    table = triad()
    table["crank"]["main"]["radius"] = "5000 mm"
    assert "at no crank angle" in str(refusal(table).allowed)


def test_a_triad_of_two_pin_groups_is_what_they_are():
    """Two joints of the link on one point: a rod of the triad carries the first pin group's joint."""
    pins = chain()
    links = (("link", "B", 300), ("out", "D", 350))
    rod, rocker = ({"name": name, "from": start, "length": f"{length} mm"} for name, start, length in links)
    pins["part"][1] = {"type": "pin", "rod": rod, "rocker": rocker, "joint": "E", "side": "left"}
    pins |= {"output": "out", "fixed": {"C": ["300 mm", "400 mm"], "D": ["600 mm", "200 mm"]}}
    one = ct.run(ct.Machine(mechanism=pins))
    at = {name: position(one, name)[0] for name in ("B", "E")}
    legs = [
        {"joint": "B", "rod": {"name": "pitman", "from": "main.pin", "length": "400 mm"}},
        {"joint": "B2", "rod": {"name": "lever", "from": "C", "length": "250 mm"}},
        {"joint": "E", "along": "300 mm", "rod": {"name": "out", "from": "D", "length": "350 mm"}},
    ]
    for leg, name in zip(legs, ("B", "B", "E"), strict=True):
        leg["near"] = [f"{float(at[name].real)!r} m", f"{float(at[name].imag)!r} m"]
    other = ct.run(ct.Machine(mechanism=pins | {"part": [{"type": "triad", "link": "link", "leg": legs}]}))
    np.testing.assert_allclose(other.rocker_angle, one.rocker_angle, atol=1e-13)
    for order in ("velocity", "acceleration"):
        name = f"rocker_{order}_coefficient"
        np.testing.assert_allclose(getattr(other, name), getattr(one, name), atol=1e-12)


def test_a_leg_is_a_rod_or_a_guide():
    table = triad(near=["0 m", "1.2 m"])
    table["part"][0]["leg"][1]["slider"] = "block"
    assert refusal(table).path == "mechanism.part[0].leg[1]"
    table = triad(near=["0 m", "1.2 m"])
    table["part"][0]["leg"].pop()
    assert refusal(table).path == "mechanism.part[0].leg"
    table = triad(near=["0 m", "1.2 m"])
    table["part"][0]["leg"][0]["rod"]["from"] = "pin"
    assert refusal(table).path == "mechanism.part[0].leg[0].rod.from"


def test_a_point_on_a_slider_moves_with_it():
    arm = {"type": "point", "name": "arm", "link": "piston", "along": "30 mm", "across": "-20 mm"}
    table = slider_crank(guide={"through": "O", "direction": "90 deg"})
    table["part"].append(arm)
    for running, sign in (("ahead", 1), ("astern", -1)):
        result = ct.run(ct.Machine(mechanism=table, running=running))
        moved = position(result, "arm") - position(result, "piston.pin")
        np.testing.assert_allclose(moved, 0.02 + sign * 0.03j, atol=1e-15)


def test_a_block_in_a_rocking_guide_carries_no_point():
    table = chain()
    swivel = {"type": "swivel", "pin": "main.pin", "guide": {"name": "slot", "from": "C"}, "slider": "block"}
    table["part"] += [swivel, {"type": "point", "name": "P", "link": "block", "along": "1 mm"}]
    assert refusal(table).path == "mechanism.part[3].link"


def swivel(ground):
    part = {"type": "swivel", "pin": "main.pin", "guide": {"name": "lever", "from": "C"}, "slider": "block"}
    return {
        "kind": "chain",
        "output": "lever",
        "fixed": {"C": [f"{ground} mm", "0 mm"]},
        "crank": {"main": {"radius": "100 mm"}},
        "part": [part],
    }


@pytest.mark.parametrize(("ground", "margin"), [(110, 10 / 110), (90, 10 / 100)])
def test_a_swivel_cannot_pass_where_its_pivot_lies_on_the_pins_circle(ground, margin):
    result = ct.run(ct.Machine(mechanism=swivel(ground)))
    assert result.closing_margin[0] == pytest.approx(margin, rel=1e-9)


def test_a_triad_that_is_elsewhere_after_a_turn_is_refused():
    """One whose link goes over to another assembly mode without ever being loose; found among random ones."""
    legs = [
        {"joint": "P", "along": f"{0.9126752006841798 * np.cos(-2.131787870635355)} m"},
        {"joint": "Q", "along": f"{0.20490304593019504 * np.cos(0.4095501403288182)} m"},
        {"slider": "block", "along": f"{0.3577143214166978 * np.cos(-2.4872976134728964)} m"},
    ]
    across = (
        0.9126752006841798 * np.sin(-2.131787870635355),
        0.20490304593019504 * np.sin(0.4095501403288182),
        0.3577143214166978 * np.sin(-2.4872976134728964),
    )
    legs = [leg | {"across": f"{value} m"} for leg, value in zip(legs, across, strict=True)]
    legs[0]["rod"] = {"name": "first", "from": "main.pin", "length": "0.7242548468413007 m"}
    legs[1]["rod"] = {"name": "second", "from": "A", "length": "1.7427752319628997 m"}
    legs[2]["guide"] = {"through": "B", "direction": "-0.11776628844784076 rad", "offset": "-0.0067475478667854485 m"}
    origin, direction = 0.42064509230060004 + 0.022428509547091385j, -0.20498818834430946
    first = origin + (0.9126752006841798 * np.exp(1j * (direction - 2.131787870635355)))
    legs[0]["near"] = [f"{first.real} m", f"{first.imag} m"]
    table = {
        "kind": "chain",
        "output": "block",
        "crank": {"main": {"radius": "0.13562929260572187 m"}},
        "fixed": {
            "A": ["1.7841999602341219 m", "1.3620788116852358 m"],
            "B": ["-0.08770258618699905 m", "-0.10412440142359436 m"],
        },
        "part": [{"type": "triad", "link": "plate", "leg": legs}],
    }
    problem = refusal(table)
    assert "at no crank angle" in str(problem.allowed)
    assert "on each turn its link goes over to another assembly mode" in str(problem.allowed)
