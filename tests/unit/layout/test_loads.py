"""What is wrong with loads of a machine file, each said at its path."""

import numpy as np
import pytest
from tests.machines import ROCKER

import cranktrain as ct

CRANK = {"kind": "slider_crank", "stroke": "80 mm", "rod_length": "140 mm"}


@pytest.mark.parametrize(
    ("mechanism", "load", "said"),
    [
        (CRANK, {"on": "pistn", "force": "1 N"}, "load.x.on = pistn: must be a part that moves: crank, rod, piston"),
        (CRANK, {"on": "rod"}, "load.x.force: is missing; give force or torque"),
        (CRANK, {"on": "rod", "force": "1 N", "torque": "1 N*m"}, "load.x.torque = 1 N*m: must not stand beside force"),
        (CRANK, {"on": "piston", "torque": "1 N*m"}, "load.x.torque: is for what turns, and this slides"),
        (CRANK, {"on": "piston", "force": "1 N", "radius": "10 mm"}, "load.x.radius: is for what turns"),
        (CRANK, {"on": "piston", "force": "-5 N"}, "load.x.force = -5 N: must be at least 0 of a load that resists"),
        (CRANK, {"on": "rod", "force": "5 N", "sense": "active"}, "load.x.direction: is missing; a force on a link"),
        (CRANK, {"on": "rod", "force": "5 N", "exponent": 2}, "load.x.exponent = 2: needs at_speed"),
        (CRANK, {"on": "rod", "torque": "5 N*m", "at_speed": "1 m/s"}, "load.x.at_speed = 1 m/s: is for a force"),
        (CRANK, {"on": "rod", "force": "5 N", "at_turning": "1 rpm"}, "load.x.at_turning = 1 rpm: is for a torque"),
        (
            CRANK,
            {"on": "piston", "force": ["1 N", "2 N"], "travel": ["0 mm", "20 mm"]},
            "load.x.travel = 20 mm: must go as far as the part goes, 80 mm",
        ),
        (
            CRANK,
            {"on": "piston", "force": ["1 N", "2 N"], "travel": ["5 mm", "80 mm"]},
            "load.x.travel[0] = 5 mm: must be 0, where the travel begins",
        ),
        (
            CRANK,
            {"on": "piston", "force": ["1 N"], "travel": ["0 mm", "80 mm"]},
            "load.x.force = a list of 1: must be as many as the places that they are for: 2",
        ),
        (
            CRANK,
            {"on": "piston", "force": ["1 N", "2 N"], "travel": ["80 mm", "0 mm"]},
            "load.x.travel: must rise from one place to the next",
        ),
        (
            CRANK,
            {"on": "rod", "force": ["1 N", "2 N"], "travel": ["0 mm", "80 mm"]},
            "load.x.travel: needs a direction or a radius",
        ),
        (
            ROCKER,
            {"on": "rocker", "torque": ["1 N*m", "2 N*m"], "swing": ["0 deg", "30 deg"]},
            "load.x.swing = 30 deg: must go as far as the part goes, 42.8136",
        ),
        (CRANK, {"on": "piston", "force": "1 N", "along": "5 mm"}, "load.x.along = 5 mm: is for a link; without a"),
        (CRANK, {"on": "piston", "force": "1 N", "counts": "against"}, "load.x.counts = against: is for sizes over"),
        (CRANK, {"on": "piston", "force": "1 N", "force_back": ["2 N"]}, "load.x.force_back: is for sizes over the"),
        (
            CRANK,
            {"on": "crank", "torque": ["1 N*m", "2 N*m"], "swing": ["0 deg", "90 deg"]},
            "load.x.swing: is for what goes to and fro, and this turns all round",
        ),
        (ROCKER, {"on": "rocker", "force": "1 N", "radius": "0 mm"}, "load.x.radius = 0 mm: must not be 0"),
        (
            ROCKER,
            {"on": "rocker", "force": "1 N", "radius": "9 mm", "along": "2 mm"},
            "load.x.along = 2 mm: must not stand beside radius",
        ),
    ],
)
def test_refused(mechanism, load, said):
    with pytest.raises(ct.InputError) as caught:
        ct.run(ct.Machine(mechanism=mechanism, shaft={"main": {"speed": "100 rpm"}}, load={"x": load}))
    assert said in str(caught.value)


def test_all_at_once():
    load = {"a": {"on": "nothing", "force": "1 N"}, "b": {"on": "piston", "torque": "1 N*m"}}
    with pytest.raises(ct.InputError) as caught:
        ct.run(ct.Machine(mechanism=CRANK, load=load))
    assert [problem.path for problem in caught.value.problems] == ["load.a.on", "load.b.torque"]


def test_a_bank_has_a_load_of_its_own_in_place_of_the_common_one():
    """Over the travel from either end: −(0.5 · 100 N · 80 mm) on the way out, or the same of 300 N."""

    def work(common, own):
        rising = {"on": "piston", "travel": ["0 mm", "80 mm"], "force_back": ["0 N", "0 N"]}
        bank = {"A": {"mechanism": CRANK}}
        if own is not None:
            bank["A"]["load"] = {"x": {**rising, "force": ["0 N", own]}}
        tables = {"load": {"x": {**rising, "force": ["0 N", common]}}}
        return ct.run(ct.Machine(bank=bank, shaft={"main": {"speed": "100 rpm"}}, **tables)).load_work.tolist()

    assert work("100 N", None) == pytest.approx([-4.0], rel=1e-12)
    assert work("100 N", "300 N") == pytest.approx([-12.0], rel=1e-12)


def test_loads_without_a_speed_are_not_used():
    result = ct.run(ct.Machine(mechanism=CRANK, load={"x": {"on": "piston", "force": "1 N"}}))
    assert any("[load.x] is not used" in said for said in map(str, result.summary().splitlines()))


def test_loads_on_one_part_add_up():
    def torque(**load):
        machine = ct.Machine(mechanism=CRANK, shaft={"main": {"speed": "100 rpm"}}, load=load)
        return ct.run(machine).machine_torque

    one, other = {"on": "piston", "force": "30 N"}, {"on": "piston", "force": "-20 N", "sense": "active"}
    both = torque(one=one, other=other)
    assert abs(both - torque(one=one) - torque(other=other)).max() < 1e-12


def test_a_load_on_a_point_is_one_at_its_place():
    place = {"along": "150 mm", "across": "30 mm"}
    force = {"force": "900 N", "direction": "35 deg"}
    rocker = {**ROCKER, "points": {"jaw": {"link": "rod", **place}}}
    machine = {"mechanism": rocker, "shaft": {"main": {"speed": "120 rpm"}}}
    named, placed = (
        ct.run(ct.Machine(**machine, load={"x": {**on, **force}})) for on in ({"on": "jaw"}, {"on": "rod", **place})
    )
    np.testing.assert_array_equal(named.driving_torque, placed.driving_torque)
    np.testing.assert_array_equal(named.joint_force_x, placed.joint_force_x)
    for wrong, path, said in (
        ({"on": "jaw", "torque": "3 N*m"}, "load.x.torque", "on a point a force acts"),
        ({"on": "jaw", **force, "along": "1 mm"}, "load.x.along", "the point says where"),
        ({"on": "jav", **force}, "load.x.on", "or a point on one: jaw"),
    ):
        with pytest.raises(ct.InputError) as caught:
            ct.run(ct.Machine(**machine, load={"x": wrong}))
        (problem,) = caught.value.problems
        assert problem.path == path
        assert said in problem.allowed


def test_two_turns_are_for_a_four_stroke_wherever_the_load_stands():
    """The path is that of the table, whichever mechanism bears it."""
    law = {"on": "rod", "torque": ["1 N*m", "2 N*m"], "crank_angles": ["0 deg", "700 deg"], "sense": "active"}
    slider = {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "200 mm"}
    banks = {name: {"angle": f"{angle} deg", "mechanism": slider} for name, angle in (("A", 0), ("B", 60))}
    shaft = {"main": {"speed": "120 rpm"}}
    common = ct.Machine(bank=banks, shaft=shaft, load={"x": law})
    own = ct.Machine(bank={**banks, "B": {**banks["B"], "load": {"x": law}}}, shaft=shaft)
    for machine, path in ((common, "load.x.crank_angles"), (own, "bank.B.load.x.crank_angles")):
        with pytest.raises(ct.InputError) as caught:
            ct.run(machine)
        assert [problem.path for problem in caught.value.problems] == [path]
