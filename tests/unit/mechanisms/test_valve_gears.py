"""Valve gears: what is known of each, in any notch; beside a cylinder, astern, in banks; and what is refused."""

import copy
import tomllib

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.mechanisms import KINDS

QUANTITIES = ["stroke", "piston_displacement", "top_position"]


def example(kind):
    return tomllib.loads(KINDS.named(kind).example)


def gear_of(data):
    return data["bank"]["valve"]["mechanism"] if "bank" in data else data["mechanism"]


def changed(kind, **changes):
    data = example(kind)
    gear_of(data).update(changes)
    return data


def valve(data, **machine):
    """Travel and position along its line, by degree."""
    result = ct.run(ct.Machine(**data, **machine), quantities=QUANTITIES)
    return float(result.stroke[-1]), result.top_position[-1] - result.piston_displacement[-1]


def refusal(data):
    with pytest.raises(InputError) as caught:
        ct.run(ct.Machine(**data))
    (problem,) = caught.value.problems
    return problem


@pytest.mark.parametrize(("rods", "sign", "swing"), [("open", 1, "-18 deg"), ("crossed", -1, "18 deg")])
def test_lead_of_stephensons_motion_grows_toward_mid_gear_with_open_rods_and_falls_with_crossed(rods, sign, swing):
    at_dead_centres = []
    for notch in (1, 0.8, 0.6, 0.4, 0.2, 0):
        _travel, place = valve(changed("stephenson", rods=rods, lifting_arm_swing=swing, notch=notch))
        at_dead_centres.append(abs(place[180] - place[0]) / 2)
    assert np.all(np.diff(at_dead_centres) * sign > 0)
    # 70 mm sin 15°, and near it in full gear; Zeuner's r c cos δ/l more or less at mid gear, 7.2 mm.
    assert at_dead_centres[-1] - 0.070 * np.sin(np.radians(15)) == pytest.approx(sign * 7.2e-3, rel=0.03)


@pytest.mark.parametrize("kind", ["stephenson", "walschaerts"])
def test_astern_the_valve_moves_as_ahead_but_for_what_the_rods_slope_makes(kind):
    """Half a turn of the crank taken backward: the reverser set back is the engine seen in a mirror, nearly."""
    travel, ahead = valve(changed(kind, notch=1))
    _travel, back = valve(changed(kind, notch=-1))
    reversed_crank = np.roll(back[::-1], 1)
    assert np.max(np.abs(ahead - np.mean(ahead) - (reversed_crank - np.mean(reversed_crank)))) < 0.06 * travel


@pytest.mark.parametrize("kind", ["eccentric", "stephenson", "walschaerts"])
def test_running_astern_is_the_same_metal_at_the_opposite_angle(kind):
    data = example(kind)
    _travel, ahead = valve(data)
    _travel, astern = valve(data, running="astern")
    np.testing.assert_allclose(astern, np.roll(ahead[::-1], 1), atol=1e-13)


def test_walschaerts_has_one_lead_in_all_notches():
    leads = []
    for notch in (1, 0.5, 0, -0.5, -1):
        _travel, place = valve(changed("walschaerts", notch=notch))
        leads.append((place[0] - place[180]) / 2)
    assert np.ptp(leads) < 0.1e-3
    # 330 mm · 95/850, but for the lever's slope.
    assert np.mean(leads) == pytest.approx(0.330 * 95 / 850, rel=2e-3)


def test_walschaerts_at_mid_gear_has_lap_and_lead_for_its_travel():
    travel, place = valve(changed("walschaerts", notch=0))
    assert travel == pytest.approx(place[0] - place[180], rel=1e-9)
    assert travel == pytest.approx(2 * 0.330 * 95 / 850, rel=2e-3)


def test_walschaerts_against_the_textbooks_picture():
    """A valve of parts in and across the crank, (p/L) R cos φ + (1 − p/L)(nd/f) r sin φ, to what slopes leave out."""
    travel, place = valve(changed("walschaerts", notch=0.6))
    phi = np.radians(np.arange(360))
    part = 95 / 850
    picture = part * 0.330 * np.cos(phi) + (1 - part) * 0.6 * 190 / 420 * 0.160 * np.sin(phi)
    assert np.max(np.abs(place - np.mean(place) - picture)) < 0.05 * travel


def test_the_valves_middle_with_inside_and_outside_admission():
    """An eccentric for inside admission is half a turn away: the valve is where the other's is half a turn later."""
    _travel, outside = valve(changed("eccentric", admission="outside"))
    _travel, inside = valve(changed("eccentric", admission="inside"))
    np.testing.assert_allclose(inside, np.roll(outside, 180), atol=1e-14)
    table = changed("eccentric")
    for name in ("angle_of_advance", "admission"):
        del table["mechanism"][name]
    _travel, direct = valve({"mechanism": table["mechanism"] | {"angle_ahead": "120 deg"}})
    np.testing.assert_allclose(direct, outside, atol=1e-14)


def test_eccentric_without_an_offset_and_an_eccentric_crank_are_one():
    _travel, own = valve(changed("eccentric"))
    chain = {
        "kind": "chain",
        "output": "valve",
        "crank": {"main": {"radius": "300 mm"}, "sheave": {"radius": "60 mm", "angle": "120 deg"}},
        "part": [
            {
                "type": "slide",
                "rod": {"name": "rod", "from": "sheave.pin", "length": "1400 mm"},
                "slider": "valve",
                "guide": {"through": "O", "direction": "0 deg"},
            }
        ],
    }
    _travel, made = valve({"mechanism": chain})
    np.testing.assert_allclose(made, own, atol=1e-14)


def test_notches_as_designs():
    machines = [ct.Machine(**changed("walschaerts", notch=notch)) for notch in (1, 0.3, -0.8)]
    together = ct.run(machines, quantities=QUANTITIES)
    for design, machine in enumerate(machines):
        alone = ct.run(machine, quantities=QUANTITIES)
        np.testing.assert_allclose(together.piston_displacement[design], alone.piston_displacement, atol=1e-14)


def test_a_valve_has_no_cylinder():
    data = example("walschaerts")
    data["shaft"] = {"main": {"throws": ["0 deg", "90 deg"]}}
    data["cylinder"] = {"bore": "470 mm", "chambers": ["head", "crank"], "piston_rod": "80 mm", "compression_ratio": 9}
    for order in (("cylinder", "valve"), ("valve", "cylinder")):
        data["bank"] = {name: data["bank"][name] for name in order}
        result = ct.run(ct.Machine(**data), quantities=["displacement", "compression_ratio", "swept_volume"])
        assert set(result.labels["chamber"]) == {f"{n}cylinder.{side}" for n in (1, 2) for side in ("head", "crank")}
        litres = np.pi / 4 * (2 * 0.47**2 - 0.08**2) * 0.66 * 2
        assert float(result.displacement) == pytest.approx(litres, rel=1e-12)
    data["cylinder"] = {"valve": {"bore": "100 mm"}}
    assert refusal(data).path == "cylinder.valve"
    assert refusal(example("eccentric") | {"cylinder": {"bore": "100 mm"}}).path == "cylinder"


def test_walschaerts_needs_a_crosshead():
    data = changed("walschaerts", crosshead="cylindr")
    problem = refusal(data)
    assert (problem.path, problem.given) == ("bank.valve.mechanism.crosshead", "cylindr")
    assert "cylinder" in str(problem.allowed)
    bare = {"mechanism": copy.deepcopy(gear_of(data))}
    assert refusal(bare).path == "mechanism.crosshead"


@pytest.mark.parametrize(
    ("kind", "changes", "path"),
    [
        ("stephenson", {"notch": 1.2}, "mechanism.notch"),
        ("stephenson", {"eccentric_rod_length": "60 mm"}, "mechanism.eccentric_rod_length"),
        ("stephenson", {"lifting_link_length": "100 mm", "reverse_shaft_x": "3 m"}, "mechanism.eccentric_rod_length"),
        ("walschaerts", {"notch": -2}, "bank.valve.mechanism.notch"),
        ("walschaerts", {"union_link_length": "100 mm"}, "bank.valve.mechanism.radius_rod_length"),
        ("eccentric", {"rod_length": "50 mm"}, "mechanism.rod_length"),
    ],
)
def test_what_cannot_be_is_refused_with_its_field(kind, changes, path):
    assert refusal(changed(kind, **changes)).path == path


def test_an_eccentric_is_set_one_way():
    """Both fields of the other way are named at once."""
    with pytest.raises(InputError) as caught:
        ct.Machine(**changed("eccentric", angle_ahead="5 deg"))
    paths = [problem.path for problem in caught.value.problems]
    assert paths == ["mechanism.angle_of_advance", "mechanism.admission"]


def test_an_eccentric_must_be_set():
    data = example("eccentric")
    del data["mechanism"]["angle_of_advance"]
    assert refusal(data).path == "mechanism.angle_of_advance"
