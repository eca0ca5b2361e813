"""Plans as data: positions, polygons and Klein's construction against closed forms in 40 digits."""

import mpmath as mp
import numpy as np
import pytest
from tests.sentences import CANNOT_CLOSE_THERE, NOT_ITS_MECHANISM

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.plans.klein import klein
from cranktrain.plans.placement import placed
from cranktrain.plans.polygons import acceleration_polygons, velocity_polygons
from cranktrain.plans.positions import position_plan, rescaled, rounded_scale

ANGLES = (20.0, 75.0, 200.0, 310.0)
R, L, OFFSET, OMEGA = 0.05, 0.18, 0.012, 150.0
CRANK = {
    "shaft": {"main": {"speed": f"{OMEGA} rad/s"}},
    "mechanism": {
        "kind": "slider_crank",
        "crank_radius": f"{R} m",
        "rod_length": f"{L} m",
        "offset": f"{OFFSET} m",
    },
}


@pytest.fixture(scope="module")
def crank():
    """A slider-crank whose x is Y, running clockwise: (x, y) = (Y, X)."""
    return ct.Machine(**CRANK)


def pins_exact(phi):
    """A and B of the slider-crank as (X, Y), from its triangle."""
    rise = mp.mpf(str(R)) * mp.sin(phi)
    along = mp.mpf(str(R)) * mp.cos(phi)
    reach = mp.sqrt(mp.mpf(str(L)) ** 2 - (rise - mp.mpf(str(OFFSET))) ** 2)
    return {"A": (rise, along), "B": (mp.mpf(str(OFFSET)), along + reach)}


def derivative_exact(name, degrees, order):
    """Derivative of a pin's position by time, by differentiating the closed form in 40 digits."""
    with mp.workdps(40):
        phi = mp.radians(degrees)
        return [
            float(mp.mpf(OMEGA) ** order * mp.diff(lambda t, i=i: pins_exact(t)[name][i], phi, order)) for i in (0, 1)
        ]


@pytest.mark.parametrize(
    ("polygons_of", "letter", "order"), [(velocity_polygons, "v", 1), (acceleration_polygons, "a", 2)]
)
def test_slider_crank_polygons(crank, polygons_of, letter, order):
    for polygon in polygons_of(crank, ANGLES):
        vectors = {vector.symbol: vector for vector in polygon.vectors}
        for name in "AB":
            expected = derivative_exact(name, polygon.angle, order)
            size = np.hypot(*expected)
            np.testing.assert_allclose(
                vectors[f"{letter}_{name}"].value, expected, rtol=0, atol=1e-12 * max(size, R * OMEGA**order)
            )


@pytest.mark.parametrize("name", ["3d12", "pumping_unit_c57", "vaz_21213", "r_1340"])
@pytest.mark.parametrize("polygons_of", [velocity_polygons, acceleration_polygons])
def test_polygons_close_and_lengths_times_scale_are_the_values(name, polygons_of):
    for polygon in polygons_of(ct.load(name), ANGLES):
        points = {key: np.array(point) * polygon.scale for key, point in polygon.points.items()}
        largest = max(vector.size for vector in polygon.vectors)
        for vector in polygon.vectors:
            np.testing.assert_allclose(
                points[vector.end] - points[vector.start],
                vector.value,
                rtol=0,
                atol=1e-12 * largest,
                err_msg=vector.symbol,
            )
            assert polygon.length(vector) * polygon.scale == pytest.approx(vector.size, rel=1e-15)


@pytest.mark.parametrize("name", ["3d12", "pumping_unit_c57", "vaz_21213"])
def test_polygons_equal_the_kernels_values(name):
    machine = ct.load(name)
    place = next((one for one in machine.places if one.kind.name == "articulated_rod"), machine.places[0])
    omega = machine.main_shaft.speed.si
    zero = machine.zero
    for polygon in acceleration_polygons(machine, ANGLES):
        moving = placed(machine, place, np.array([np.deg2rad(polygon.angle) + zero])).pins
        for vector in polygon.vectors:
            if vector.part == "absolute":
                pin = moving[vector.symbol[2:]]
                exact = omega**2 * np.array([pin.x.second[0], pin.y.second[0]])
                np.testing.assert_allclose(vector.value, exact, rtol=0, atol=1e-12 * np.hypot(*exact))


@pytest.mark.parametrize("name", ["3d12", "pumping_unit_c57", "vaz_21213"])
def test_normal_parts_point_along_their_links_and_tangential_ones_across(name):
    """A right angle, and ω² l: the rod's angular velocity is found a second time, from the velocities."""
    machine = ct.load(name)
    plan = position_plan(machine, ANGLES)
    velocities, accelerations = velocity_polygons(machine, ANGLES), acceleration_polygons(machine, ANGLES)
    for i, (velocity, acceleration) in enumerate(zip(velocities, accelerations, strict=True)):
        relative = {vector.symbol[2:]: vector.size for vector in velocity.vectors}
        values = {vector.symbol: np.array(vector.value) for vector in acceleration.vectors}
        for pair in {symbol[2:4] for symbol in values if symbol.endswith("^n")}:
            pin, known = (plan.drawing.positions[end][:, i] * plan.scale for end in pair)
            arm = known - pin
            normal, tangential = values[f"a_{pair}^n"], values[f"a_{pair}^t"]
            speed = relative.get(pair, relative[pair[0]])
            size = np.hypot(*values[f"a_{pair[0]}"]) + np.hypot(*normal)
            np.testing.assert_allclose(normal, speed**2 / np.dot(arm, arm) * arm, rtol=0, atol=1e-12 * size)
            assert abs(np.dot(tangential, arm)) < 1e-11 * size * np.hypot(*arm)


def test_polygons_of_no_speed_are_for_one_radian_a_second(crank):
    slow = ct.Machine(mechanism=CRANK["mechanism"])
    fast, one = velocity_polygons(crank, [40.0])[0], velocity_polygons(slow, [40.0])[0]
    assert (fast.unit, one.unit) == ("m/s", "m/rad")
    np.testing.assert_allclose(fast.vectors[1].value, OMEGA * np.array(one.vectors[1].value), rtol=1e-14)


@pytest.mark.parametrize("angle", ANGLES)
def test_klein_gives_velocity_and_acceleration(crank, angle):
    """OC turned clockwise, as the machine runs, is v_B/ω; ON turned round is a_B/ω²; the circles meet on the chord."""
    found = klein(crank, angle)
    v_x, v_y = derivative_exact("B", angle, 1)
    a_x, a_y = derivative_exact("B", angle, 2)
    np.testing.assert_allclose(
        np.array([found.points["C"][1], -found.points["C"][0]]) * OMEGA, [v_x, v_y], rtol=0, atol=1e-12 * R * OMEGA
    )
    np.testing.assert_allclose(-found.points["N"] * OMEGA**2, [a_x, a_y], rtol=0, atol=1e-12 * R * OMEGA**2)
    middle = (found.points["A"] + found.points["B"]) / 2
    for point in (found.points["K"], found.points["L"]):
        assert np.hypot(*(point - middle)) == pytest.approx(L / 2, rel=1e-13)
        assert np.hypot(*(point - found.points["A"])) == pytest.approx(
            np.hypot(*(found.points["C"] - found.points["A"])), rel=1e-12
        )


def test_instant_centre_makes_both_pins_velocities(crank):
    """About the centre, v = ω_rod × arm: both arms stand across their velocities, and the ratios agree."""
    found = klein(crank, 75.0)
    rates = []
    for name, pin in (("A", found.points["A"]), ("B", found.points["B"])):
        velocity = np.array(derivative_exact(name, 75.0, 1))
        arm = pin - found.centre
        assert abs(np.dot(velocity, arm)) < 1e-12 * np.hypot(*velocity) * np.hypot(*arm)
        rates.append(np.hypot(*velocity) / np.hypot(*arm))
    assert rates[0] == pytest.approx(rates[1], rel=1e-12)


def test_klein_at_right_angles_has_no_centre():
    """With crank and line of stroke at right angles the rod only moves along: its centre is infinitely far."""
    plain = ct.Machine(mechanism={"kind": "slider_crank", "crank_radius": "30 mm", "rod_length": "50 mm"})
    found = klein(plain, 90.0)
    np.testing.assert_allclose(found.points["C"], found.points["A"], rtol=0, atol=1e-15)
    assert np.all(np.isnan(found.centre))


def test_positions_times_scale_are_the_pins():
    machine = ct.load("3d12")
    plan = position_plan(machine, 12, mechanism="2R")
    place = next(place for place in machine.places if place.name == "2R")
    exact = placed(machine, place, np.deg2rad(plan.angles)).positions
    for name, pin in plan.drawing.positions.items():
        np.testing.assert_allclose(pin * plan.scale, exact[name], rtol=0, atol=1e-15)
    np.testing.assert_allclose(np.hypot(*plan.drawing.positions["A"]) * plan.scale, 0.09, rtol=1e-14)
    half = rescaled(plan, 2 * plan.scale)
    np.testing.assert_allclose(2 * half.drawing.positions["D"][0], plan.drawing.positions["D"][0], rtol=1e-15)


@pytest.mark.parametrize(("least", "scale"), [(1.0, 1.0), (1.01, 2.0), (0.0021, 0.0025), (0.026, 0.04), (7.3, 10.0)])
def test_scales_are_round(least, scale):
    assert rounded_scale(least) == scale


def test_positions_that_cannot_close_are_left_out_or_refused():
    short = ct.Machine(mechanism={"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "40 mm"})
    assert list(position_plan(short, 12).angles) == [0, 30, 150, 180, 210, 330]
    with pytest.raises(InputError, match=f"φ = 90°: the links of 1 {CANNOT_CLOSE_THERE}"):
        velocity_polygons(short, [0.0, 90.0])
    with pytest.raises(InputError, match="cannot close"):
        klein(short, 90.0)


def test_unknown_mechanisms_are_refused():
    with pytest.raises(InputError, match=f"9X: {NOT_ITS_MECHANISM}: 1L, "):
        position_plan(ct.load("3d12"), mechanism="9X")
    with pytest.raises(InputError, match="no slider-crank"):
        klein(ct.load("pumping_unit_c57"), 30.0)


SLOTS = {
    "slotted_lever": ({"crank_radius": "100 mm", "ground_length": "250 mm"}, "rocker", "block", 1.0),
    "oscillating_cylinder": ({"crank_radius": "20 mm", "ground_length": "90 mm"}, "cylinder", "slider", -1.0),
    "scotch_yoke": ({"crank_radius": "40 mm", "slot_angle": "70 deg"}, None, "block", 1.0),
}
"""Length of each, the link with the slot, what slides, and its sign along the slot."""


@pytest.mark.parametrize("kind", SLOTS)
@pytest.mark.parametrize("angle", ANGLES)
@pytest.mark.parametrize("offset", ["0 mm", "7 mm"])
def test_sliding_along_a_slot(kind, angle, offset):
    """Relative velocity and acceleration are the kernel's of the block, along the slot; Coriolis' part is 2ωv_r."""
    lengths, link, block, sign = SLOTS[kind]
    machine = ct.Machine(mechanism={"kind": kind, "offset": offset, **lengths})
    place = machine.places[0]
    motion = place.kind.motion(np.radians([angle]), place.geometry)
    sliding = getattr(motion, block)
    velocities = {vector.symbol: vector for vector in velocity_polygons(machine, [angle])[0].vectors}
    accelerations = {vector.symbol: vector for vector in acceleration_polygons(machine, [angle])[0].vectors}
    if link is None:
        turning, slot = 0.0, place.geometry.slot_angle
        relative, along = velocities["v_AB"], accelerations["a_AB"]
        assert "a_AB^c" not in accelerations
    else:
        turning, slot = (float(part[0]) for part in getattr(motion, link).angle[1::-1])
        relative, along = velocities["v_AA'"], accelerations["a_AA'^r"]
        coriolis = np.array(accelerations["a_AA'^c"].value)
        expected = 2 * abs(turning * sliding.first[0])
        assert np.hypot(*coriolis) == pytest.approx(float(expected), rel=1e-11)
        # turned by 90° from the sliding in the sense of the link's turning: clockwise here where it is positive
        turned = np.array([relative.value[1], -relative.value[0]]) * 2 * turning
        np.testing.assert_allclose(coriolis, turned, rtol=0, atol=1e-13)
    direction = np.array([np.sin(slot), np.cos(slot)])  # x is Y and y is X
    np.testing.assert_allclose(relative.value, sign * sliding.first[0] * direction, rtol=0, atol=1e-14)
    np.testing.assert_allclose(along.value, sign * sliding.second[0] * direction, rtol=0, atol=1e-14)


def test_velocities_without_bound_are_refused():
    """Crank and rod of one length: across the line of stroke the piston may stop at the shaft or go on."""
    even = ct.Machine(mechanism={"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "50 mm"})
    with pytest.raises(InputError, match="velocities have no bound"):
        velocity_polygons(even, [90.0])


def test_names_of_a_chains_pins_are_words():
    """The crank pin `main.pin` goes by `main`; a pin called P is not the pole."""
    machine = ct.load("shaper")
    symbols = {vector.symbol for vector in velocity_polygons(machine, [60.0])[0].vectors}
    assert {"v_main", "v_main'", "v_main,main'", "v_D", "v_ram,D"} <= symbols
    chain = {
        "kind": "chain",
        "output": "ram",
        "crank": {"main": {"radius": "50 mm"}},
        "fixed": {"C": ["300 mm", "0 mm"]},
        "part": [
            {
                "type": "pin",
                "rod": {"name": "rod", "from": "main.pin", "length": "300 mm"},
                "rocker": {"name": "lever", "from": "C", "length": "200 mm"},
                "joint": "P",
                "side": "right",
            },
            {
                "type": "slide",
                "rod": {"name": "link", "from": "P", "length": "400 mm"},
                "slider": "ram",
                "guide": {"through": "C", "direction": "0 deg"},
            },
        ],
    }
    ends = {vector.symbol: vector.end for vector in velocity_polygons(ct.Machine(mechanism=chain), [60.0])[0].vectors}
    assert ends["v_P"] == "p'"


def test_plans_of_opposed_pistons():
    """Both mechanisms about the first one's shaft; what lies between the pistons is the cylinder's volume."""
    engine = ct.load("10d100")
    first, second = engine.places[0], next(one for one in engine.places if one.name == "1.scavenge")
    result = ct.run(engine, step_degrees=10.0, quantities=("chamber_volume",))
    angles = [40.0, 130.0, 250.0]
    plan = position_plan(engine, angles)
    assert plan.mechanism == "1"
    pins = {name: plan.scale * pin for name, pin in plan.drawing.positions.items()}
    assert list(pins) == ["O", "A", "B", "O2", "A2", "B2"]
    for place, mark in ((first, ""), (second, "2")):
        for start, end, length in (("O", "A", place.geometry.crank_radius), ("A", "B", place.geometry.rod_length)):
            np.testing.assert_allclose(np.hypot(*(pins[end + mark] - pins[start + mark])), length, rtol=1e-12)
    between = np.hypot(*(pins["B2"] - pins["B"]))
    area = np.pi / 4 * engine.cylinder.bore.si**2
    rows = [result.crank_angle.tolist().index(angle) for angle in angles]
    volume = result.chamber_volume[result.labels["chamber"].index("1"), rows]
    np.testing.assert_allclose(np.diff(between) * area, np.diff(volume), rtol=1e-9)


@pytest.mark.parametrize("polygons_of", [velocity_polygons, acceleration_polygons])
def test_polygons_of_opposed_pistons_are_those_of_each(polygons_of):
    engine = ct.load("deltic")
    (both,) = polygons_of(engine, [40.0], mechanism="1A")
    (one,), (other,) = (polygons_of(engine, [40.0], mechanism=f"1A.{side}") for side in ("exhaust", "scavenge"))
    values = [vector.value for vector in both.vectors]
    np.testing.assert_allclose(
        values, [vector.value for vector in (*one.vectors, *other.vectors)], rtol=1e-12, atol=1e-9
    )
    assert both.points["b2"] == pytest.approx([part * other.scale / both.scale for part in other.points["b"]])
