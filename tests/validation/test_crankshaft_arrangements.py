"""Crankshafts of machine files against statics: levers, momentum, levers of gears, and equal wordings of one shaft."""

import numpy as np
import pytest
from tests.told import texts_of

import cranktrain as ct
from cranktrain.analysis.outcomes import run_stages
from cranktrain.analysis.parts import parts_of
from cranktrain.analysis.stages import every_stage, lacking
from cranktrain.questions.crankshaft.bending.torque_along import torque_along
from cranktrain.questions.crankshaft.loads.loaded_shafts import LoadedShafts
from cranktrain.questions.crankshaft.methods import BEARING_METHODS

METHODS = {method.name: method for method in BEARING_METHODS}
SECTIONS = {
    "journal_diameter": "70 mm",
    "pin_diameter": "65 mm",
    "pin_length": "60 mm",
    "web_thickness": "28 mm",
    "web_width": "110 mm",
}
PLAIN = {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "220 mm"}


def machine(throws, *, angles=("0 deg",), crankshaft=None, **more):
    """Plain slider-cranks with masses on one shaft, without gas."""
    table = {
        "shaft": {"main": {"throws": throws, "spacing": "150 mm", "speed": "750 rpm"}},
        "bank": {f"b{i}": {"angle": angle, "mechanism": PLAIN} for i, angle in enumerate(angles)},
        "masses": {
            "piston": {"mass": "5 kg"},
            "rod": {"big_end": "3 kg", "small_end": "2 kg", "inertia": "0.03 kg·m²"},
            "crank": {"mass": "6 kg", "along": "20 mm", "inertia": "0.02 kg·m²"},
        },
        "crankshaft": {**SECTIONS, "bearing_distance": "130 mm", **(crankshaft or {})},
        **more,
    }
    if len(throws) == 1:
        del table["shaft"]["main"]["spacing"]
    return ct.Machine(**table)


def loads(result, method="split"):
    """Loads of all bearings, shape (bearing, 2, n)."""
    own = result.dataset.sel(bearing_method=method)
    return np.stack([own.main_bearing_load_x.values, own.main_bearing_load_y.values], axis=1)


def on_pins(result, turned=1.0):
    """Forces of the rods on their pins in X, Y, from the pin loads in the pins' axes, shape (mechanism, 2, n)."""
    angle = np.radians(result.dataset.crank_angle.values)
    throws = np.radians([0.0, 180.0])[: result.dataset.mechanism.size, np.newaxis]
    sin, cos = np.sin(turned * (angle + throws)), np.cos(angle + throws)
    k, t = result.dataset.crankpin_load_radial.values, result.dataset.crankpin_load_tangential.values
    return np.stack([-k * sin + turned * t * cos, -k * cos - turned * t * sin], axis=1)


def loaded_shafts(declared):
    """Its crankshafts, with what acts on them."""
    parts = parts_of([declared], step=np.radians(1.0))
    return run_stages(every_stage(), parts, lacking(every_stage(), parts))[LoadedShafts]


WITHOUT_CRANKS = {
    "masses": {"piston": {"mass": "5 kg"}, "rod": {"big_end": "3 kg", "small_end": "2 kg", "inertia": "0.03 kg·m²"}}
}


@pytest.mark.parametrize("rotation", ["clockwise", "anticlockwise"])
def test_two_throws_between_two_bearings_are_levers(rotation):
    """By (50) to (53) of each pin, over the whole distance."""
    result = ct.run(machine(["0 deg", "180 deg"], crankshaft={"journals": [1, 3]}, rotation=rotation, **WITHOUT_CRANKS))
    assert result.dataset.bearing.values.tolist() == [1, 3]
    np.testing.assert_allclose(result.dataset.rod_place, [0.0, 0.15], rtol=1e-14)
    np.testing.assert_allclose(result.dataset.bearing_place, [-0.13, 0.28], rtol=1e-14)
    force = on_pins(result, 1.0 if rotation == "clockwise" else -1.0)
    last = (130 * force[0] + 280 * force[1]) / 410
    wanted = np.stack([force[0] + force[1] - last, last])
    np.testing.assert_allclose(loads(result), wanted, rtol=0, atol=1e-12 * np.max(np.abs(wanted)))


@pytest.mark.parametrize("journals", [[2, 3], [1, 2]])
def test_a_pin_that_hangs_over(journals):
    """The lever over both bearings, 75 and 280 mm from the pin at the end."""
    result = ct.run(machine(["0 deg", "180 deg"], crankshaft={"journals": journals}, **WITHOUT_CRANKS))
    force = on_pins(result)
    places = {1: -130.0, 2: 75.0, 3: 280.0}
    first, last = (places[number] for number in journals)
    second = ((0 - first) * force[0] + (150 - first) * force[1]) / (last - first)
    wanted = np.stack([force[0] + force[1] - second, second])
    np.testing.assert_allclose(loads(result), wanted, rtol=0, atol=1e-12 * np.max(np.abs(wanted)))


ARRANGED = {
    "two in a span": (["0 deg", "180 deg"], {"journals": [1, 3]}),
    "three in a span": (["0 deg", "120 deg", "240 deg"], {"journals": [1, 4]}),
    "journals without bearings": (["0 deg", "120 deg", "240 deg"], {"bearings": [1, 4]}),
    "both ends hang over": (["0 deg", "90 deg", "270 deg"], {"journals": [2, 3]}),
    "a flywheel and a belt": (
        ["0 deg"],
        {
            "pull": {
                "belt": {"z": "320 mm", "force": "3 kN", "direction": "100 deg"},
                "flywheel": {"z": "250 mm", "force": "4 kN", "direction": "180 deg"},
            }
        },
    ),
}


@pytest.mark.parametrize("name", ARRANGED)
def test_on_two_bearings_all_rigid_methods_agree(name):
    throws, table = ARRANGED[name]
    weight = {"weight": [{"mass": "4 kg", "radius": "60 mm", "angle": "170 deg", "z": "-200 mm"}]}
    hangs_over = "journals" in table and 1 not in table["journals"]
    result = ct.run(
        machine(throws, angles=("-20 deg",), crankshaft=table, **({} if hangs_over else {"balance": weight}))
    )
    split = loads(result)
    for method in ("three_moment", "frame_rigid"):
        np.testing.assert_allclose(loads(result, method), split, rtol=0, atol=1e-12 * np.max(np.abs(split)))


@pytest.mark.parametrize("rotation", ["clockwise", "anticlockwise"])
def test_loads_against_the_change_of_momentum(rotation):
    """Without gas the frame is shaken by its main bearings and by pistons on their walls, and by nothing else."""
    angles = ("-30 deg", "30 deg")
    result = ct.run(machine(["0 deg", "120 deg"], angles=angles, rotation=rotation))
    data, sense = result.dataset, 1.0 if rotation == "clockwise" else -1.0
    walls = np.zeros((2, data.crank_angle.size))
    for piston, force in zip(data.piston.values, data.side_force.sel(force_method="exact").values, strict=True):
        gamma = np.radians(-30.0 if piston.endswith("b0") else 30.0)
        walls = walls - force * np.array([[sense * np.cos(gamma)], [-np.sin(gamma)]])
    shaken = np.stack([data.shaking_force_x.values[0], data.shaking_force_y.values[0]])
    borne = np.sum(loads(result, "frame_rigid"), axis=0)
    np.testing.assert_allclose(borne + walls, shaken, rtol=0, atol=1e-12 * np.max(np.abs(borne)))


TWO_SHAFTS = {
    "shaft": {
        "main": {"throws": ["0 deg", "180 deg"], "spacing": "150 mm", "speed": "750 rpm"},
        "upper": {
            "throws": ["0 deg", "180 deg"],
            "spacing": "150 mm",
            "ratio": -1,
            "phase": "40 deg",
            "place": ["300 mm", "400 mm"],
        },
    },
    "bank": {"low": {"mechanism": PLAIN}, "high": {"angle": "30 deg", "shaft": "upper", "mechanism": PLAIN}},
    "masses": {"piston": {"mass": "5 kg"}, "rod": {"big_end": "3 kg", "small_end": "2 kg"}},
    "crankshaft": {**SECTIONS, "bearing_distance": "130 mm"},
}
GEAR = {"shafts": ["upper", "main"], "z": "350 mm", "radius": "250 mm", "helix_angle": "20 deg"}


def acting_on(table):
    """The crankshafts of a machine, and what acts on them over the turn."""
    declared = ct.Machine(**table)
    loaded = loaded_shafts(declared)
    angle = np.radians(np.arange(0.0, 360.0))[np.newaxis, np.newaxis]
    return loaded, [own.loads for own in loaded.loads(angle)], ct.run(declared)


@pytest.mark.parametrize("rotation", ["clockwise", "anticlockwise"])
def test_a_gear_between_two_shafts(rotation):
    """Its teeth push both shafts by the same force, the other way; each turns what the other gives."""
    loaded, acting, result = acting_on({**TWO_SHAFTS, "rotation": rotation, "gear": {"drive": GEAR}})
    low, high = acting
    force = [one.force[0, -1] for one in acting]
    size = np.max(np.abs(force[0]))
    np.testing.assert_allclose(force[0], -force[1], rtol=0, atol=1e-12 * size)
    np.testing.assert_allclose(low.thrust[0, -1], -high.thrust[0, -1], rtol=0, atol=1e-12 * size)
    of_shafts = result.dataset.shaft_torque
    torque = of_shafts.sel(shaft="upper").values
    toward = np.array([0.6, 0.8])
    tangent, along = np.abs(torque) / 0.25, np.sum(force[0] * toward[:, np.newaxis], axis=0)
    np.testing.assert_allclose(np.abs(low.torque[0, -1]), np.abs(torque), rtol=0, atol=1e-11 * np.max(tangent))
    # Apart by tan 20° over the cosine of the helix, whichever way the torque goes: the lower one away from the mesh.
    np.testing.assert_allclose(-along, tangent * np.tan(np.pi / 9) / np.cos(np.pi / 9), atol=1e-11 * np.max(tangent))
    np.testing.assert_allclose(np.abs(low.thrust[0, -1]), tangent * np.tan(np.pi / 9), atol=1e-11 * np.max(tangent))
    # Nothing is left of the upper shaft's torque beyond its gear; all of both is at the end of the lower one.
    for one, own, wanted in zip(loaded.each, acting, (np.sum(of_shafts.values, axis=0), 0 * torque), strict=True):
        borne = METHODS["split"].loads(one.metal, own).load
        last = torque_along(one.metal, own, borne).end[0, -1]
        turn = one.layout.turn
        np.testing.assert_allclose(turn * last, wanted, rtol=0, atol=1e-10 * np.max(np.abs(torque)))


def test_the_reaction_of_a_gear_at_the_end():
    """On a shaft of one throw: what the gear adds to both bearings is its lever; nothing else moves."""
    shafts = {name: {**table, "throws": ["0 deg"]} for name, table in TWO_SHAFTS["shaft"].items()}
    for table in shafts.values():
        del table["spacing"]
    table = {**TWO_SHAFTS, "shaft": shafts}
    gear = {**GEAR, "z": "300 mm", "helix_angle": "0 deg"}
    without, with_gear = ct.run(ct.Machine(**table)), ct.run(ct.Machine(**table, gear={"drive": gear}))
    _loaded, acting, _result = acting_on({**table, "gear": {"drive": gear}})
    added = loads(with_gear, "frame_rigid") - loads(without, "frame_rigid")
    assert with_gear.dataset.bearing.values.tolist() == ["main.1", "main.2", "upper.1", "upper.2"]
    for place, own in ((0, acting[0]), (2, acting[1])):
        force = own.force[0, -1]
        wanted = np.stack([-170 / 260 * force, 430 / 260 * force])
        np.testing.assert_allclose(added[place : place + 2], wanted, rtol=0, atol=1e-11 * np.max(np.abs(wanted)))


SAME = {
    "lists": {name: [value, value] for name, value in SECTIONS.items() if name.startswith(("pin", "web"))}
    | {"journal_diameter": ["70 mm"] * 3},
    "of each web": {"web_thickness": ["28 mm"] * 4, "web_width": ["110 mm"] * 4},
    "all journals named": {"journals": [3, 1, 2], "bearings": [2, 3, 1]},
    "places given": {"bearing": {"3": {"z": "280 mm"}, "1": {"z": "-130 mm"}}},
    "stiffness of each": {"bearing": {name: {"stiffness": "400 kN/mm"} for name in "321"}},
    "stiffness both ways": {"bearing_stiffness": ["400 kN/mm", "0.4e9 N/m"]},
    "inches": {"pin_length": "2.36220472440944881890 in", "bearing_distance": "0.13 m"},
    "own table": {"main": SECTIONS},
}


@pytest.mark.parametrize("name", SAME)
def test_equal_wordings(name):
    elastic = {"bearing_stiffness": "400 kN/mm"}
    first = ct.run(machine(["0 deg", "90 deg"], crankshaft=elastic))
    other = ct.run(machine(["0 deg", "90 deg"], crankshaft={**elastic, **SAME[name]}))
    for method in ("frame_elastic", "five_moment", "split"):
        wanted = loads(first, method)
        np.testing.assert_allclose(loads(other, method), wanted, rtol=0, atol=1e-12 * np.max(np.abs(wanted)))


def test_a_mirror_turns_only_x():
    one, other = (
        ct.run(machine(["0 deg", "90 deg"], angles=("20 deg",), rotation=sense))
        for sense in ("clockwise", "anticlockwise")
    )
    wanted = loads(one, "frame_rigid") * np.array([[-1.0], [1.0]])
    np.testing.assert_allclose(loads(other, "frame_rigid"), wanted, rtol=0, atol=1e-12 * np.max(np.abs(wanted)))


def test_side_rods_share_their_piston():
    """Two pins on either side of the near piston's: bearings at equal distances bear alike, and half of all."""
    near, far = (
        {**PLAIN, "crank_radius": f"{radius} mm", "rod_length": f"{rod} mm"} for radius, rod in ((80, 300), (60, 700))
    )
    made = ct.Machine(
        shaft={"main": {"throws": ["0 deg", "180 deg"], "spacing": "0 mm", "speed": "600 rpm"}},
        bank={
            "A": {
                "exhaust": {"mechanism": far, "throws": [2], "side_rods": True},
                "scavenge": {"mechanism": near, "throws": [1]},
            }
        },
        masses={"piston": {"mass": "4 kg"}, "rod": {"big_end": "3 kg", "small_end": "2 kg"}},
        crankshaft={
            **SECTIONS,
            "pin_length": "50 mm",
            "side_rod_distance": "170 mm",
            "journals": [1, 4],
            "bearing_distance": "90 mm",
        },
    )
    result = ct.run(made)
    for method in ("split", "three_moment", "frame_rigid"):
        both = loads(result, method)
        np.testing.assert_allclose(both[0], both[1], rtol=0, atol=1e-11 * np.max(np.abs(both)))


def test_settlement_of_the_middle_bearing():
    """Two spans whose middle bearing sinks by Δ: −6EIΔ/l³ on the outer ones, with the EI that stands for each throw."""
    plain = machine(["0 deg", "180 deg"], crankshaft={"bearing_distance": "75 mm"})
    sunk = machine(
        ["0 deg", "180 deg"],
        crankshaft={"bearing_distance": "75 mm", "bearing": {"2": {"settlement": ["0 mm", "-0.05 mm"]}}},
    )
    bending = loaded_shafts(plain).each[0].metal.straight.bending[0]
    assert bending[0] == pytest.approx(bending[1], rel=1e-12)
    added = loads(ct.run(sunk), "three_moment") - loads(ct.run(plain), "three_moment")
    wanted = 3 * bending[0] * 0.05e-3 / 0.15**3
    size = np.max(np.abs(loads(ct.run(plain), "three_moment")))
    np.testing.assert_allclose(added[:, 1, 0], [-wanted, 2 * wanted, -wanted], rtol=0, atol=1e-11 * (wanted + size))
    np.testing.assert_allclose(added[:, 0], 0.0, atol=1e-11 * (wanted + size))


def test_housings_half_and_twice_as_stiff():
    """What is said of other housings is what the file with these housings says."""
    shaft = {"bearing_stiffness": ["300 kN/mm", "500 kN/mm"]}
    spread = ct.run(machine(["0 deg", "90 deg"], crankshaft=shaft)).dataset
    for name, stiffness in (("soft", ["150 kN/mm", "250 kN/mm"]), ("stiff", ["600 kN/mm", "1000 kN/mm"])):
        other = ct.run(machine(["0 deg", "90 deg"], crankshaft={"bearing_stiffness": stiffness})).dataset
        wanted = other.largest_bearing_load.sel(bearing_method="frame_elastic").values
        np.testing.assert_allclose(spread[f"bearing_load_{name}_housing"].values, wanted, rtol=1e-11)


def test_what_pins_and_webs_weigh():
    """Cylinder and two blocks, in grams by hand; a web from pin to pin is halved between them."""
    data = ct.run(machine(["0 deg", "180 deg"], crankshaft={"density": "8000 kg/m³", "pin_bore": "25 mm"})).dataset
    pin = 8000 * np.pi / 4 * (0.065**2 - 0.025**2) * 0.06
    web = 8000 * 0.11 * 0.028 * (0.05 + 0.0675)
    np.testing.assert_allclose(data.pin_mass, [pin, pin], rtol=1e-13)
    np.testing.assert_allclose(data.web_mass, [2 * web, 2 * web], rtol=1e-13)
    moment = pin * 0.05 + 2 * web * (0.05 - 0.0025) / 2
    np.testing.assert_allclose(data.crank_moment, [moment, moment], rtol=1e-13)
    own = {"journals": [1, 3], "web_height": "100 mm", "pin_bore": "25 mm", "density": "8000 kg/m³"}
    data = ct.run(machine(["0 deg", "180 deg"], crankshaft=own)).dataset
    web, between = 8000 * 0.11 * 0.028 * 0.1, 8000 * 0.11 * 0.09 * 0.1
    np.testing.assert_allclose(data.web_mass, [web + between / 2] * 2, rtol=1e-13)
    # By halves at both pins: together they have its moment about the shaft, here none.
    moment = pin * 0.05 + web * (0.05 - 0.0025) / 2 + between / 2 * 0.05
    np.testing.assert_allclose(data.crank_moment, [moment, moment], rtol=1e-13)


def test_what_is_doubtful_about_a_crank():
    """A web of 13 mm at hollow pins of 65 mm, and [masses.crank] of much more than these sizes can be."""
    result = ct.run(machine(["0 deg", "180 deg"], crankshaft={"web_width": "13 mm", "pin_bore": "50 mm"}))
    assert "A web is narrower than the pin that it holds: 1, 2." in texts_of(result.flags)
    assert any(flag.startswith("[masses.crank] acts like 2.400 kg at pin 1") for flag in texts_of(result.flags))
    assert not any("masses.crank" in flag for flag in texts_of(ct.run(machine(["0 deg", "180 deg"])).flags))
    bare = ct.run(machine(["0 deg", "180 deg"], **WITHOUT_CRANKS))
    assert any(flag.startswith("Cranks have no mass without [masses.crank]") for flag in texts_of(bare.flags))


def test_astern_is_the_same_backward():
    """Inertia knows no sense of time: what the bearings carry at φ they carry astern at −φ."""
    more = {
        "crankshaft": {"pull": {"belt": {"z": "400 mm", "force": "3 kN", "direction": "60 deg"}}},
        "balance": {"weight": [{"mass": "4 kg", "radius": "60 mm", "angle": "30 deg", "z": "40 mm"}]},
    }
    ahead, astern = (
        loads(ct.run(machine(["0 deg", "90 deg"], angles=("20 deg",), running=running, **more)), "frame_rigid")
        for running in ("ahead", "astern")
    )
    backward = np.roll(ahead[..., ::-1], 1, axis=-1)
    np.testing.assert_allclose(astern, backward, rtol=0, atol=1e-12 * np.max(np.abs(ahead)))
