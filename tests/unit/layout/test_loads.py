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
        (CRANK, {"on": "rod", "force": "5 N"}, "load.x.along: is missing: where on the rod the force acts"),
        (CRANK, {"on": "crank", "force": "5 N", "across": "3 mm"}, "load.x.along: is missing: where on the crank"),
        (ROCKER, {"on": "rocker", "force": "5 N", "direction": "9 deg"}, "load.x.along: is missing: where on the rock"),
        (CRANK, {"on": "rod", "force": "5 N", "exponent": 2}, "load.x.exponent = 2: needs at_speed"),
        (CRANK, {"on": "rod", "torque": "5 N*m", "at_speed": "1 m/s"}, "load.x.at_speed = 1 m/s: is for a force"),
        (CRANK, {"on": "rod", "force": "5 N", "at_turning": "1 rpm"}, "load.x.at_turning = 1 rpm: is for a torque"),
        (
            CRANK,
            {"on": "piston", "force": ["1 N", "2 N"], "travel": ["0 mm", "20 mm"]},
            "load.x.travel[1] = 20 mm: must go as far as the part goes, 80 mm",
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
            "load.x.travel[1] = 0 mm: must be more than 80 mm, the place before it",
        ),
        (
            CRANK,
            {"on": "rod", "force": ["1 N", "2 N"], "travel": ["0 mm", "80 mm"]},
            "load.x.travel: needs a direction or a radius",
        ),
        (
            ROCKER,
            {"on": "rocker", "torque": ["1 N*m", "2 N*m"], "swing": ["0 deg", "30 deg"]},
            "load.x.swing[1] = 30 deg: must go as far as the part goes, 42.8136",
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
        assert said in str(problem.allowed)


def test_two_turns_are_the_cycle_wherever_the_load_stands():
    """Whichever mechanism bears it, and whether cylinders work once a turn or say nothing."""
    law = {"on": "rod", "torque": ["1 N*m", "2 N*m"], "crank_angles": ["0 deg", "700 deg"], "sense": "active"}
    slider = {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "200 mm"}
    banks = {name: {"angle": f"{angle} deg", "mechanism": slider} for name, angle in (("A", 0), ("B", 60))}
    shaft = {"main": {"speed": "120 rpm"}}
    common = {"bank": banks, "shaft": shaft, "load": {"x": law}}
    own = {"bank": {**banks, "B": {**banks["B"], "load": {"x": law}}}, "shaft": shaft}
    for tables in (common, own):
        for cylinder in ({}, {"cycle": "two-stroke"}):
            assert ct.run(ct.Machine(**tables, cylinder=cylinder)).crank_angle.size == 720


def crusher(**load):
    """A jaw crusher as one of its builders types it: 400 kN of stone on the jaw, which is the rod."""
    return ct.Machine(
        angle="177 deg",
        shaft={"main": {"speed": "290 rpm"}},
        mechanism={
            "kind": "crank_rocker",
            "crank_radius": "15 mm",
            "rod_length": "1085 mm",
            "rocker_length": "455 mm",
            "ground_length": "817 mm",
        },
        load={"stone": {"on": "rod", "force": "400 kN", **load}},
    )


def jaw_along(angles, along, direction):
    """How far a point of the crusher's rod is along a direction: the four-bar's loop closed by hand. [m]"""
    crank, rod, rocker, ground = 0.015, 1.085, 0.455, 0.817
    pin = crank * np.exp(1j * angles)
    reach = ground - pin
    bend = np.arccos((rod**2 + np.abs(reach) ** 2 - rocker**2) / (2 * rod * np.abs(reach)))
    found = [(pin + along * np.exp(1j * (np.angle(reach) + side * bend))) for side in (-1, 1)]
    return [np.real(one * np.exp(-1j * direction)) for one in found]


def test_a_force_on_a_link_asks_where_it_acts():
    """Of the stone it was said 200 kW at the crank pin; at the jaw 39.27 kW, one way half of it, by its own stroke."""
    with pytest.raises(ct.InputError) as caught:
        ct.run(crusher())
    said = str(caught.value)
    assert 'along = "200 mm"' in said
    assert 'on = "seat"' in said
    at = {"along": "700 mm", "direction": "-112.5 deg"}
    strokes = [np.ptp(one) for one in jaw_along(np.linspace(0, 2 * np.pi, 20001), 0.7, np.radians(-112.5))]
    stroke = min(strokes, key=lambda one: abs(one - 10.1548e-3))
    assert stroke == pytest.approx(10.1548e-3, abs=1e-7)
    rate = 400e3 * stroke * 290 / 60
    one_way = {"travel": ["0 mm", "20 mm"], "force": ["400 kN", "400 kN"], "force_back": ["0 kN", "0 kN"]}
    for more, power in (({}, 2 * rate), (one_way, rate)):
        result = ct.run(crusher(**at, **more))
        assert -float(result.load_work[0]) * 290 / 60 == pytest.approx(power, rel=1e-6)


def test_a_point_that_is_followed_is_named():
    """Of a mechanism with one on that link, the example is that point."""
    machine = crusher().declared | {"load": {"stone": {"on": "rod", "force": "400 kN"}}}
    machine["mechanism"]["points"] = {"jaw": {"link": "rod", "along": "700 mm", "across": "0 mm"}}
    with pytest.raises(ct.InputError, match='on = "jaw"'):
        ct.run(ct.Machine(**machine))
