"""Tables beside plans: every number is what `run` gives at that crank angle, with its sign."""

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.layout.frames import in_machine_axes
from cranktrain.plans.placement import frame, placed
from cranktrain.plans.polygons import acceleration_polygons, velocity_polygons
from cranktrain.plans.position_table import output_columns, point_columns
from cranktrain.plans.positions import position_plan

ANGLES = np.array([0.0, 30.0, 111.0, 217.0, 300.0])
AT = ANGLES.astype(int)

FOUR_BAR = {
    "kind": "crank_rocker",
    "crank_radius": "50 mm",
    "rod_length": "120 mm",
    "rocker_length": "100 mm",
    "ground_length": "140 mm",
    "points": {"P": {"link": "rod", "along": "60 mm", "across": "80 mm"}},
}


def four_bar(**more):
    return ct.Machine(**({"mechanism": FOUR_BAR, "shaft": {"main": {"speed": "60 rpm"}}} | more))


@pytest.mark.parametrize("name", ["3d12", "vaz_21213", "eccentric_press", "great_northern", "jumo_205", "toggle_press"])
def test_sliders_are_the_results(name):
    machine = ct.load(name)
    result = ct.run(machine)
    for place in machine.places[:2]:
        number = result.labels["piston"].index(place.name)
        x, s, v, a = output_columns(machine, place, ANGLES)
        scale = result.stroke[number]
        travel = result.piston_displacement[number, AT]
        np.testing.assert_allclose(s.values, travel, rtol=0, atol=1e-12 * max(scale, np.max(np.abs(x.values))))
        np.testing.assert_allclose(x.values + travel, result.top_position[number], rtol=1e-12)
        np.testing.assert_allclose(v.values, result.piston_velocity[number, AT], rtol=1e-10, atol=1e-10)
        np.testing.assert_allclose(a.values, result.piston_acceleration[number, AT], rtol=1e-10, atol=1e-8)


@pytest.mark.parametrize("more", [{}, {"rotation": "anticlockwise", "angle": "-90 deg"}, {"running": "astern"}])
def test_a_coupler_point_is_where_the_result_has_it(more):
    machine = four_bar(**more)
    result = ct.run(machine)
    (place,) = machine.places
    number = result.labels["point"].index("1.P")
    ((name, (x, y, v, a)),) = point_columns(machine, place, ANGLES)
    assert name == "P"
    path = result.point_x[number, AT], result.point_y[number, AT]
    np.testing.assert_allclose([x.values, y.values], path, rtol=0, atol=1e-15)
    omega = 2 * np.pi
    step = 1e-4
    drawing = placed(machine, place, np.deg2rad(ANGLES) + machine.zero)
    there = in_machine_axes(*path, frame(machine, place))
    np.testing.assert_allclose(drawing.positions["P"], there, rtol=0, atol=1e-15)

    def where(angle):
        return placed(machine, place, np.deg2rad(ANGLES) + machine.zero + angle).positions["P"]

    before, now, after = where(-step), where(0.0), where(step)
    np.testing.assert_allclose(v.values, omega * np.hypot(*(after - before)) / (2 * step), rtol=1e-6)
    np.testing.assert_allclose(a.values, omega**2 * np.hypot(*(after - 2 * now + before)) / step**2, rtol=1e-5)


def test_a_coupler_point_is_in_the_polygons():
    """Its velocity and acceleration from the pole, and about the crank pin the rod's turning times its distance."""
    machine = four_bar()
    result = ct.run(machine)
    ((_name, (_x, _y, v, a)),) = point_columns(machine, machine.places[0], ANGLES)
    turning = result.coupler_angular_velocity[0, AT]
    for polygons, values in ((velocity_polygons, v), (acceleration_polygons, a)):
        for number, polygon in enumerate(polygons(machine, ANGLES.tolist())):
            whole = next(one for one in polygon.vectors if one.pins == ("P",))
            assert whole.size == pytest.approx(values.values[number], rel=1e-12)
    about = [
        next(one.size for one in polygon.vectors if one.symbol == "v_PA")
        for polygon in velocity_polygons(machine, ANGLES.tolist())
    ]
    np.testing.assert_allclose(about, 0.1 * np.abs(turning), rtol=1e-12)  # 60, 80: 100 mm from A


def test_a_point_with_a_pin_s_name_has_its_own():
    points = {"C": {"link": "rocker", "along": "50 mm", "across": "0 mm"}}
    plan = position_plan(four_bar(mechanism=FOUR_BAR | {"points": points}), [30.0])
    assert plan.drawing.points == ("C_p",)
    lever, pivot, joint = (plan.drawing.positions[name][:, 0] for name in ("C_p", "C", "B"))
    np.testing.assert_allclose(lever, 0.5 * (pivot + joint), rtol=0, atol=1e-9)


def test_a_point_on_a_link_that_is_drawn_by_another_name():
    """A slotted lever's `rocker` is drawn as its `lever`: the point is on it, and no other link has it."""
    mechanism = {
        "kind": "slotted_lever",
        "crank_radius": "50 mm",
        "ground_length": "140 mm",
        "points": {"P": {"link": "rocker", "along": "100 mm", "across": "20 mm"}},
    }
    plan = position_plan(ct.Machine(mechanism=mechanism), [30.0])
    assert [link.name for link in plan.drawing.links if "P" in link.pins] == ["lever"]
