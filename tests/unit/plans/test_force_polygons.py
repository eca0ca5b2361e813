"""Polygons of forces and Zhukovsky's lever: they close, their lengths are the joints' reactions, numbers by hand."""

import numpy as np
import pytest
from tests.gas_engines import DUAL_CYCLE
from tests.unit.questions.forces.test_friction import CHAIN
from tests.weighed_machines import WEIGHED as MACHINES

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.layout.masses import part_name
from cranktrain.plans.force_polygons import force_polygons, rescaled
from cranktrain.plans.zhukovsky import zhukovsky_lever
from cranktrain.questions.torque.torques import ShaftTorques

ANGLES = [33.0, 200.0]


def gap_of(polygon, link):
    """By how much one link's own sides do not close with the chords, in parts of the largest of them."""
    values = [
        *(force.value for force in polygon.forces if force.link == link),
        *(chord.force.value for chord in polygon.chords if chord.force.link == link),
        *(np.negative(chord.force.value) for chord in polygon.chords if chord.by == link),
    ]
    return np.hypot(*np.sum(values, axis=0)) / np.max(np.hypot(*np.transpose(values))) if values else 0.0


def members(machine):
    """One mechanism of each kind."""
    return {place.kind.name: place.name for place in machine.places}.values()


@pytest.mark.parametrize("name", MACHINES)
def test_polygons_close(name):
    """Inertia is found apart from the reactions, so that only right ones close polygons and links' parts of them."""
    for mechanism in members(MACHINES[name]):
        found = force_polygons(MACHINES[name], ANGLES, mechanism=mechanism)
        assert {polygon.angle for polygon in found} == set(ANGLES)
        for polygon in found:
            assert polygon.gap < 1e-12, (mechanism, polygon.links)
            assert max(gap_of(polygon, link) for link in polygon.links) < 1e-12, (mechanism, polygon.links)
            sides = np.hypot(*np.diff(polygon.corners, axis=1)) * polygon.scale
            assert sides == pytest.approx([force.size for force in polygon.forces], rel=1e-12, abs=1e-6)


@pytest.mark.parametrize("name", MACHINES)
def test_chords_and_whole_reactions_lie_between_their_corners(name):
    """A whole reaction is the sum of its parts; a chord, exact from the joint, ends on the corners it splits at."""
    for mechanism in members(MACHINES[name]):
        for polygon in force_polygons(MACHINES[name], ANGLES, mechanism=mechanism):
            largest = max(force.size for force in polygon.forces)
            for span in (*polygon.wholes, *polygon.chords):
                drawn = (polygon.corners[:, span.end] - polygon.corners[:, span.start]) * polygon.scale
                assert drawn == pytest.approx(span.force.value, abs=1e-12 * largest)
            for span in polygon.wholes:
                parts = polygon.parts(span)
                assert {part.joint for part in parts} == {span.force.joint}
                assert np.sum([part.value for part in parts], axis=0) == pytest.approx(span.force.value, rel=1e-12)
                assert np.dot(*(part.value for part in parts)) == pytest.approx(0.0, abs=1e-12 * largest**2)


@pytest.mark.parametrize("name", MACHINES)
def test_lengths_are_the_joints_reactions(name):
    """Whole sides, whole reactions and chords times μ_F are what the result says of the joints."""
    machine = MACHINES[name]
    result = ct.run(machine, step_degrees=10.0, quantities=("joint_force_x", "joint_force_y"))
    at = result.crank_angle.tolist().index(40.0)
    for mechanism in members(machine):
        place = next(place for place in machine.places if place.name == mechanism)
        compared = set()
        for polygon in force_polygons(machine, [40.0], mechanism=mechanism):
            if place.kind.name == "articulated_rod" and polygon.links[0] != "rod":
                continue  # of its master, whose own test this is
            whole = [span.force for span in polygon.wholes]
            split = {force.joint for force in whole}
            for force in (*polygon.forces, *whole, *(span.force for span in polygon.chords)):
                if force.cause == "reaction" and not (force in polygon.forces and force.joint in split):
                    joint = force.joint if force.joint in result.labels["joint"] else f"{mechanism}.{force.joint}"
                    row = result.labels["joint"].index(joint)
                    size = np.hypot(result.joint_force_x[row, at], result.joint_force_y[row, at])
                    assert polygon.length(force) * polygon.scale == pytest.approx(size, rel=1e-9)
                    compared.add(force.joint)
        assert len(compared) >= 3


def test_all_joints_of_a_chain_are_on_its_polygons():
    """Every group has its sort, and every joint is a side, a whole reaction or a chord of some polygon."""
    machine = ct.Machine(shaft={"main": {"speed": "900 rpm"}}, gravity=True, **CHAIN)
    dynamics = machine.places[0].kind.dynamics
    polygons = force_polygons(machine, [40.0])
    assert [polygon.sort for polygon in polygons] == [*(g.sort for g in reversed(dynamics.groups)), "initial"]
    drawn = {force.joint for polygon in polygons for force in polygon.forces if force.cause == "reaction"}
    drawn |= {chord.force.joint for polygon in polygons for chord in polygon.chords}
    assert drawn == {reaction.name for reaction in dynamics.reactions}


@pytest.mark.parametrize("slave", ["1R", "6R"])
def test_a_slave_loads_its_master(slave):
    """The slave's knuckle pin gets from the master's rod what that rod gets back in the next polygon."""
    engine = MACHINES["3d12"]
    of_slave, of_master, crank = force_polygons(engine, [40.0], mechanism=slave)
    (knuckle,) = (span.force for span in of_slave.wholes)
    (load,) = (force for force in of_master.forces if force.symbol == "F_43")
    assert (knuckle.symbol, of_master.links) == ("F_34", ("master_rod", "master_slider"))
    assert np.add(knuckle.value, load.value) == pytest.approx((0.0, 0.0), abs=1e-9)
    own = force_polygons(engine, [40.0], mechanism=slave.replace("R", "L"))
    assert [force.value for force in own[0].forces] == [force.value for force in of_master.forces]
    assert crank.moment == own[1].moment


def test_balancing_moment():
    """Without weight and mass of its own the crank passes the rod's force on: M_b = −r × F_32, F_12 = −F_32.

    X right, Y up, the crank runs clockwise; r of 40 mm stands at 33° from Y.
    """
    machine = MACHINES["vaz_21213"]
    crank = force_polygons(machine, [33.0])[-1]
    load, bearing = crank.forces
    radius = machine.places[0].geometry.crank_radius
    angle = np.deg2rad(33.0)
    x, y = radius * np.sin(angle), radius * np.cos(angle)
    assert crank.moment == pytest.approx(x * load.value[1] - y * load.value[0], rel=1e-12)
    assert np.add(load.value, bearing.value) == pytest.approx((0.0, 0.0), abs=1e-9)


@pytest.mark.parametrize("name", ["10d100", "deltic"])
def test_opposed_pistons(name):
    """The gas presses both apart alike; both cranks together take the cylinder's torque."""
    engine = ct.load(name)
    polygons = force_polygons(engine, [40.0])
    assert [polygon.numbers for polygon in polygons] == [(3, 4), (2,), (6, 7), (5,)]
    assert max(polygon.gap for polygon in polygons) < 1e-12
    loads = [force.value for polygon in polygons for force in polygon.forces if force.cause == "gas"]
    assert np.sum(loads, axis=0) == pytest.approx((0.0, 0.0), abs=1e-6)
    mechanisms = list(dict.fromkeys(polygon.mechanism for polygon in polygons))
    result = ct.run(engine, step_degrees=10.0, quantities=("mechanism_torque",))
    at = result.crank_angle.tolist().index(40.0)
    torques = [result.mechanism_torque[result.labels["mechanism"].index(one), at] for one in mechanisms]
    moments = [polygon.moment for polygon in polygons if polygon.sort == "initial"]
    assert moments == pytest.approx([-torque for torque in torques], rel=1e-10)
    assert [force.about for force in polygons[2].forces if force.about] == ["B2"]
    alone = force_polygons(engine, [40.0], mechanism=mechanisms[1])
    assert [force.value for force in alone[0].forces] == [force.value for force in polygons[2].forces]


@pytest.mark.parametrize("friction", [0.0, 0.12])
def test_slider_crank_by_hand(friction):
    """One position by the closed formulas: the part across the rod from moments about B, the rest from the slider.

    Axes of the mechanism are the machine's, X along the stroke: anticlockwise, 90° behind Y.
    """
    crank_radius, length, offset, omega, phi = 0.05, 0.13, 0.008, 120.0, np.deg2rad(65.0)
    rod_mass, u, w, inertia, slider_mass, area = 1.4, 0.043, 0.006, 0.0035, 2.2, np.pi / 4 * 0.09**2
    machine = ct.Machine(
        rotation="anticlockwise",
        shaft={"main": {"speed": f"{omega} rad/s"}},
        bank={
            "A": {
                "angle": "-90 deg",
                "mechanism": {
                    "kind": "slider_crank",
                    "crank_radius": f"{crank_radius} m",
                    "rod_length": f"{length} m",
                    "offset": f"{offset} m",
                },
            }
        },
        cylinder={"bore": "90 mm", "compression_ratio": 9, "cycle": "four-stroke", "firing_order": "1"},
        gas=DUAL_CYCLE,
        masses={
            "rod": {
                "mass": f"{rod_mass} kg",
                "along": f"{u} m",
                "across": f"{w} m",
                "inertia": f"{inertia} kg*m^2",
            },
            "piston": {"mass": f"{slider_mass} kg"},
        },
        friction={"piston": friction},
        gravity=True,
    )
    gas = ct.run(machine, step_degrees=5.0, quantities=("gas_pressure",))
    pressed = (gas.gas_pressure[0, 13] - 101325.0) * area

    beta = np.arcsin((crank_radius * np.sin(phi) - offset) / length)
    beta1 = crank_radius * np.cos(phi) / (length * np.cos(beta))
    beta2 = beta1**2 * np.tan(beta) - crank_radius * np.sin(phi) / (length * np.cos(beta))
    along = np.array([np.cos(beta), -np.sin(beta)])
    across = np.array([np.sin(beta), np.cos(beta)])
    pin = crank_radius * np.array([np.cos(phi), np.sin(phi)])
    turning, rate = -beta1 * omega, -beta2 * omega**2
    slide = -pin[1] - length * np.sin(beta) * beta1
    slide2 = -pin[0] - length * (np.cos(beta) * beta1**2 + np.sin(beta) * beta2)
    weight = np.array([0.0, -9.80665])
    arm = u * along + w * across
    turned = np.array([-arm[1], arm[0]])
    on_rod = rod_mass * (weight - (-(omega**2) * pin + rate * turned - turning**2 * arm))

    def cross(one, other):
        return one[0] * other[1] - one[1] * other[0]

    tangential = (cross(arm - length * along, on_rod) - inertia * rate) / length
    x0 = slider_mass * slide2 * omega**2 + pressed
    y0 = (cross(arm, on_rod) - inertia * rate) / (length * np.cos(beta))
    lean = -np.tan(beta)
    n0 = -x0 * lean - y0 - slider_mass * weight[1]
    normal = n0 / (1 + friction * np.sign(slide) * np.sign(n0) * lean)
    rubbing = -friction * np.sign(slide) * abs(normal)
    on_slider = np.array([x0 - rubbing, (x0 - rubbing) * lean + y0])
    on_crank_pin = on_slider - on_rod

    group, crank = force_polygons(machine, [65.0])
    forces = {force.symbol: force.value for force in group.forces}
    expected = {
        "F_23^t": tangential * across,
        "F_23^n": (on_crank_pin @ along) * along,
        "G_3": rod_mass * weight,
        "Φ_3": on_rod - rod_mass * weight,
        "P_4": (-pressed, 0.0),
        "G_4": slider_mass * weight,
        "Φ_4": (-slider_mass * slide2 * omega**2, 0.0),
        **({"N_14": (0.0, normal), "f_14": (rubbing, 0.0)} if friction else {"F_14": (0.0, normal)}),
    }
    assert set(forces) == set(expected)
    for symbol, value in expected.items():
        assert forces[symbol] == pytest.approx(value, rel=1e-9, abs=1e-6), symbol
    (chord,) = group.chords
    assert (chord.force.symbol, chord.force.link, chord.by) == ("F_34", "slider", "rod")
    assert chord.force.value == pytest.approx(on_slider, rel=1e-9)
    assert crank.forces[0].value == pytest.approx(-on_crank_pin, rel=1e-9)
    assert crank.moment == pytest.approx(cross(pin, on_crank_pin), rel=1e-9)


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
    assert result.get(ShaftTorques) is not None
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


@pytest.mark.parametrize("name", [*RUBBING, "slots and a triad"])
def test_polygons_with_friction_close(name):
    """A rubbing guide's reaction is pressure and friction, which are across one another and make the whole."""
    chain = ct.Machine(shaft={"main": {"speed": "900 rpm"}}, gravity=True, **CHAIN)
    machine = rubbing(MACHINES.get(name, chain))
    pairs = 0
    for mechanism in members(machine):
        for polygon in force_polygons(machine, [33.0, 130.0], mechanism=mechanism):
            assert polygon.gap < 1e-12
            assert max(gap_of(polygon, link) for link in polygon.links) < 1e-12
            for span in polygon.wholes:
                pressure, drag = polygon.parts(span)
                if drag.symbol.startswith("f_"):
                    assert abs(np.dot(pressure.value, drag.value)) < 1e-9 * pressure.size**2
                    assert drag.size / pressure.size == pytest.approx(0.1, abs=0.06)
                    pairs += 1
    assert pairs or name in ("slotted_lever", "oscillating_cylinder")


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
    group, crank = force_polygons(machine, [90.0])
    inertia = 2.0 * 0.05 * 100.0**2 * 5.0 / 12.0
    forces = {force.symbol: force for force in group.forces}
    assert list(forces) == ["Φ_4", "F_14", "F_23"]
    assert forces["Φ_4"].value == pytest.approx((0.0, -inertia), abs=1e-9)
    assert forces["F_14"].size == pytest.approx(inertia * 5.0 / 12.0)
    (chord,) = group.chords
    assert chord.force.size == pytest.approx(inertia * 13.0 / 12.0)
    assert chord.force.value == pytest.approx(forces["F_23"].value)
    assert [force.symbol for force in crank.forces] == ["F_32", "F_12"]
    assert crank.moment == pytest.approx(-inertia * 0.05)
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
