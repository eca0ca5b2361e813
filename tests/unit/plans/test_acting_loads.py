"""Loads of the file where they act: by hand on a slider-crank and a pumping unit, and the couples that they make."""

import numpy as np
import pytest
from tests.contract.test_loads import loaded
from tests.loaded_machines import LOADED

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.mechanisms import KINDS
from cranktrain.plans.acting import made_ready
from cranktrain.plans.acting_loads import acting_loads
from cranktrain.plans.force_polygons import force_polygons
from cranktrain.plans.shown_loads import shown_loads
from cranktrain.plans.zhukovsky import zhukovsky_lever

CRANK, ROD, FORCE = 0.05, 0.2, 700.0

PRESS = ct.Machine(
    rotation="anticlockwise",
    angle="-90 deg",  # x is X, y is Y
    shaft={"main": {"speed": "30 rad/s"}},
    mechanism={"kind": "slider_crank", "crank_radius": f"{CRANK} m", "rod_length": f"{ROD} m"},
    load={
        "cut": {"on": "piston", "force": f"{FORCE} N"},
        "side": {"on": "rod", "along": "80 mm", "across": "15 mm", "direction": "120 deg", "force": "90 N"},
        "drag": {"on": "rod", "along": "80 mm", "force": "40 N"},
        "brake": {"on": "rod", "torque": "6 N*m"},
    },
)


def at(machine, degrees):
    loads = shown_loads(machine, machine.places).at(np.array([degrees]))
    return {load.name: load for load in loads}


@pytest.mark.parametrize("degrees", [40.0, 250.0])
def test_loads_on_a_slider_crank_by_hand(degrees):
    phi = np.deg2rad(degrees)
    beta = np.arcsin(CRANK * np.sin(phi) / ROD)
    turning = -CRANK * np.cos(phi) / (ROD * np.cos(beta))
    along, across = np.array([np.cos(beta), -np.sin(beta)]), np.array([np.sin(beta), np.cos(beta)])
    pin, slider = CRANK * np.array([np.cos(phi), np.sin(phi)]), CRANK * np.cos(phi) + ROD * np.cos(beta)
    slide = CRANK * (-np.sin(phi) - np.cos(phi) * np.tan(beta))
    found = at(PRESS, degrees)
    assert found["cut"].place[:, 0] == pytest.approx((slider, 0.0), abs=1e-15)
    assert found["cut"].force[:, 0] == pytest.approx((-FORCE * np.sign(slide), 0.0), abs=1e-12)
    assert found["cut"].on_crank[0] == pytest.approx(-FORCE * abs(slide), rel=1e-12)
    arm = 0.08 * along + 0.015 * across
    velocity = CRANK * np.array([-np.sin(phi), np.cos(phi)]) + turning * np.array([-arm[1], arm[0]])
    way = np.array([np.cos(np.deg2rad(120)), np.sin(np.deg2rad(120))])
    side = found["side"]
    assert side.place[:, 0] == pytest.approx(pin + arm, rel=1e-12)
    assert side.force[:, 0] == pytest.approx(-90.0 * np.sign(velocity @ way) * way, rel=1e-12)
    arm = 0.08 * along
    velocity = CRANK * np.array([-np.sin(phi), np.cos(phi)]) + turning * np.array([-arm[1], arm[0]])
    assert found["drag"].force[:, 0] == pytest.approx(-40.0 * velocity / np.hypot(*velocity), rel=1e-12)
    assert found["brake"].size[0] == pytest.approx(-6.0 * np.sign(turning), rel=1e-12)
    assert found["brake"].on_crank[0] == pytest.approx(-6.0 * abs(turning), rel=1e-12)
    lever = zhukovsky_lever(PRESS, degrees)
    by_hand = sum(load.on_crank[0] for load in found.values())
    assert lever.driving_torque == pytest.approx(-by_hand, rel=1e-12)
    moments = {force.symbol: force.moment for force in lever.forces}
    assert moments["Q_3"] == pytest.approx(found["side"].on_crank[0], rel=1e-12)
    assert moments["Q_3,2"] == pytest.approx(found["drag"].on_crank[0], rel=1e-12)
    assert moments["M_3"] == pytest.approx(found["brake"].on_crank[0], rel=1e-12)
    assert {force.point for force in lever.forces} == {"B", "q_3", "q_3,2", ""}


def test_polygons_of_a_machine_with_loads_alone():
    """Without masses and gas: the rod bears its loads, the slider its force, and both are named."""
    group, crank = force_polygons(PRESS, [40.0])
    sides = {force.symbol: force for force in group.forces}
    assert {"Q_3": "side", "Q_3,2": "drag", "Q_4": "cut"}.items() <= {s: one.name for s, one in sides.items()}.items()
    assert [(one.symbol, one.name, abs(one.value)) for one in group.torques] == [("M_3", "brake", 6.0)]
    assert crank.torques == ()


def test_a_rope_leaves_its_arc_where_it_touches_it():
    """The rope of a pumping unit hangs straight down from the arc about the saddle, beside which it does not move."""
    unit = LOADED["pumping_unit"]
    loads = shown_loads(unit, unit.places).at(np.array([0.0, 70.0, 200.0]))
    (rope,) = loads
    arm = rope.place - rope.pin
    assert rope.is_rope
    assert np.hypot(*arm) == pytest.approx(64 * 0.0254, rel=1e-12)
    assert np.ptp(rope.place, axis=1) == pytest.approx((0.0, 0.0), abs=1e-12)
    assert rope.way[0] == pytest.approx(0.0, abs=1e-12)
    assert rope.way[1] == pytest.approx(-1.0, rel=1e-12)
    assert np.sum(arm * rope.way, axis=0) == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
def test_where_it_acts_a_load_has_its_moment(kind):
    """The arm of a force crossed with it is the moment that the mechanics has for it."""
    machine = loaded(kind)
    ready = made_ready(machine, "constant")
    angle = np.deg2rad([10.0, 130.0, 275.0])
    for place in machine.places:
        index = ready.mechanisms.names.index(place.name)
        for load, acting in zip(ready.loads.of(index), acting_loads(machine, ready, place, angle), strict=True):
            moment = np.ravel(ready.load_way(load, angle[np.newaxis, np.newaxis]).unit.moment)
            x, y = acting.place - acting.pin
            own = acting.sense * (x * acting.way[1] - y * acting.way[0])
            assert own == pytest.approx(0.0 * own if load.is_torque else moment + 0.0 * own, abs=1e-12)


def test_without_a_speed_no_load_is_shown():
    still = PRESS.with_({"shaft": {}})
    assert shown_loads(still, still.places) is None
    with pytest.raises(InputError, match="speed"):
        force_polygons(still, [40.0])
