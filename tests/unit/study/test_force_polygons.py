"""Polygons of forces and Zhukovsky's lever: they close, their lengths are the joints' reactions, numbers by hand."""

import numpy as np
import pytest
from tests.unit.engine.test_friction import CHAIN
from tests.weighed_machines import WEIGHED as MACHINES

import cranktrain as ct
from cranktrain.engine.masses import part_name
from cranktrain.engine.torque import ShaftTorques
from cranktrain.errors import InputError
from cranktrain.study.force_polygons import force_polygons, rescaled
from cranktrain.study.zhukovsky import zhukovsky_lever

ANGLES = [33.0, 200.0]


def members(machine):
    """One mechanism of each kind."""
    return {place.kind.name: place.name for place in machine.places}.values()


@pytest.mark.parametrize("name", MACHINES)
def test_polygons_close(name):
    """Inertia is found apart from the reactions, so that only right ones close a polygon."""
    for mechanism in members(MACHINES[name]):
        found = force_polygons(MACHINES[name], ANGLES, mechanism=mechanism)
        assert {polygon.angle for polygon in found} == set(ANGLES)
        for polygon in found:
            assert polygon.gap < 1e-12, (mechanism, polygon.link)
            sides = np.hypot(*np.diff(polygon.corners, axis=1)) * polygon.scale
            assert sides == pytest.approx([force.size for force in polygon.forces], rel=1e-12, abs=1e-6)


@pytest.mark.parametrize("name", MACHINES)
def test_lengths_are_the_joints_reactions(name):
    """Side times μ_F is what the result says of the joint."""
    machine = MACHINES[name]
    result = ct.run(machine, step_degrees=10.0, quantities=("joint_force_x", "joint_force_y"))
    at = result.crank_angle.tolist().index(40.0)
    for mechanism in members(machine):
        compared = 0
        for polygon in force_polygons(machine, [40.0], mechanism=mechanism):
            for force in polygon.forces:
                joint = force.joint if "." in force.joint and "/" not in force.joint else f"{mechanism}.{force.joint}"
                if force.cause == "reaction" and joint in result.labels["joint"]:
                    row = result.labels["joint"].index(joint)
                    size = np.hypot(result.joint_force_x[row, at], result.joint_force_y[row, at])
                    assert polygon.length(force) * polygon.scale == pytest.approx(size, rel=1e-9)
                    compared += 1
        assert compared >= 3


@pytest.mark.parametrize("name", MACHINES)
def test_lever_balances(name):
    """The driving torque is by reactions, which the lever does without."""
    for mechanism in members(MACHINES[name]):
        for angle in ANGLES:
            lever = zhukovsky_lever(MACHINES[name], angle, mechanism=mechanism)
            assert lever.residual < 1e-12
            assert lever.driving_torque != 0.0


def test_levers_of_all_mechanisms_are_the_torque_of_the_machine():
    engine = MACHINES["3d12"]
    levers = [zhukovsky_lever(engine, 30.0, mechanism=place.name) for place in engine.places]
    result = ct.run(engine, step_degrees=10.0, quantities=("machine_torque",))
    assert any(isinstance(gift, ShaftTorques) for gift in result.gifts)
    torque = result.machine_torque[result.crank_angle == 30.0]
    assert -sum(lever.driving_torque for lever in levers) == pytest.approx(float(torque[0]), rel=1e-12)


def rubbing(machine):
    """The machine with friction in everything that slides, of another coefficient each."""
    sliding = sorted({part_name(name) for place in machine.places for name in place.kind.dynamics.sliding})
    given = {name: getattr(machine, name) for name in machine.model_fields_set}
    return ct.Machine(**given | {"friction": {name: 0.1 - 0.01 * n for n, name in enumerate(sliding)}})


RUBBING = [name for name in MACHINES if name != "crank_rocker"]


@pytest.mark.parametrize("name", [*RUBBING, "slots and a triad"])
def test_levers_with_friction_are_the_exact_torque(name):
    """All mechanisms' levers together, a master's guide bearing its slaves, against the torque with friction."""
    chain = ct.Machine(shaft={"main": {"speed": "900 rpm"}}, gravity=True, **CHAIN)
    machine = rubbing(MACHINES.get(name, chain))
    torque = ct.run(machine, quantities=("driving_torque",)).driving_torque
    smooth = ct.run(MACHINES.get(name, chain), quantities=("driving_torque",)).driving_torque
    for angle in (33, 130):
        levers = [zhukovsky_lever(machine, angle, mechanism=place.name) for place in machine.places]
        assert max(lever.residual for lever in levers) < 1e-10
        assert sum(lever.driving_torque for lever in levers) == pytest.approx(torque[angle], rel=1e-10)
        drags = [force for lever in levers for force in lever.forces if force.symbol.startswith("f_")]
        assert len(drags) >= len(levers)
        assert sum(force.moment for force in drags) < 0
        assert torque[angle] != pytest.approx(smooth[angle], rel=1e-6)


def test_friction_by_hand():
    """As above with μ = 0.1: the piston goes toward the shaft, tan θ = −5/12 of the rod from its crank pin.

    N = N₀/(1 + k), N₀ = 416.67 N · 5/12, k = 0.1 · 5/12; friction is 16.67 N away from the shaft.
    """
    machine = ct.Machine(
        shaft={"main": {"speed": "100 rad/s"}},
        mechanism={"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "130 mm"},
        masses={"piston": {"mass": "2 kg"}},
        friction={"piston": 0.1},
    )
    lever = zhukovsky_lever(machine, 90.0)
    _inertia, friction = lever.forces
    assert (friction.symbol, friction.point) == ("f_14", "B")
    assert friction.value == pytest.approx((0.0, 50 / 3), abs=1e-9)
    assert friction.velocity == pytest.approx((0.0, -5.0), abs=1e-12)
    assert friction.moment == pytest.approx(-5 / 6, rel=1e-13)
    assert lever.driving_torque == pytest.approx(-20.0, rel=1e-13)


def test_what_stands_still_has_no_friction_on_the_lever():
    machine = rubbing(MACHINES["slider_crank"])
    for angle in (0.0, 180.0):
        assert not [force for force in zhukovsky_lever(machine, angle).forces if force.symbol.startswith("f_")]


def test_numbers_by_hand():
    """Crank across the line of stroke, massless rod, 2 kg on the piston: R 50 mm, L 130 mm, 100 rad/s.

    cos β = 12/13. s″ = R²/(L cos β) = R tan β away from the shaft, so that the piston's inertia is m R ω² tan β =
    416.67 N toward it; the wall bears tan β of it, the rod 1/cos β. It drives the crank with −s′ = R.
    """
    machine = ct.Machine(
        shaft={"main": {"speed": "100 rad/s"}},
        mechanism={"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "130 mm"},
        masses={"piston": {"mass": "2 kg"}},
    )
    polygons = {polygon.link: polygon for polygon in force_polygons(machine, [90.0])}
    inertia = 2.0 * 0.05 * 100.0**2 * 5.0 / 12.0
    slider = {force.symbol: force for force in polygons["slider"].forces}
    assert list(slider) == ["Φ_4", "F_34", "F_14"]
    assert slider["Φ_4"].value == pytest.approx((0.0, -inertia), abs=1e-9)
    assert slider["F_14"].size == pytest.approx(inertia * 5.0 / 12.0)
    assert slider["F_34"].size == pytest.approx(inertia * 13.0 / 12.0)
    assert [force.symbol for force in polygons["rod"].forces] == ["F_23", "F_43"]
    lever = zhukovsky_lever(machine, 90.0)
    (force,) = lever.forces
    assert (force.symbol, force.point) == ("Φ_4", "s_4")
    assert np.hypot(*force.velocity) == pytest.approx(0.05 * 100.0)
    assert lever.driving_torque == pytest.approx(-inertia * 0.05)


def test_a_polygon_to_another_scale():
    polygon = force_polygons(MACHINES["vaz_21213"], [30.0])[0]
    twice = rescaled(polygon, 2 * polygon.scale)
    assert twice.corners * 2 == pytest.approx(polygon.corners)
    assert twice.length(twice.forces[0]) == pytest.approx(polygon.length(polygon.forces[0]) / 2)


def test_what_nothing_acts_on():
    idle = ct.Machine(mechanism={"kind": "slider_crank", "stroke": "160 mm", "rod_length": "320 mm"})
    with pytest.raises(InputError) as refused:
        force_polygons(idle, [30.0])
    assert [problem.path for problem in refused.value.problems] == ["shaft.main.speed", "masses"]
