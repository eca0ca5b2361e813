"""Pictures of forces: that their words can be read, what they say, lengths to scale, the same bytes."""

from functools import cache

import numpy as np
import pytest
from tests.gas_engines import DUAL_CYCLE
from tests.machines import slider, throws
from tests.sentences import OF_INERTIA_ALONE, TOO_MANY_FORCES, WITHOUT_ROD
from tests.told import texts_of
from tests.unit.plans.test_force_polygons import rubbing
from tests.weighed_machines import WEIGHED
from tests.words_on_paper import assert_words_are_readable, words_of

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.io.machine_file import read_machine
from cranktrain.panels.shapes import Curve, Panel, as_shown
from cranktrain.panels.sheets.forces.panels import force_panels
from cranktrain.plans.force_polygons import force_polygons
from cranktrain.plans.pin_loads import pin_loads
from cranktrain.plans.polygons import velocity_polygons
from cranktrain.plans.zhukovsky import zhukovsky_lever
from cranktrain.quantities import shown_by, units_by_dimension
from cranktrain.saying.scales import Scale
from cranktrain.viz import (
    plan_accelerations,
    plan_forces,
    plan_polar,
    plan_positions,
    plan_velocities,
    plan_zhukovsky,
    save,
    sheet,
    sheet_forces,
)
from cranktrain.viz.paper.rings import PolarRings
from cranktrain.viz.paper.sketch import label_outline
from cranktrain.viz.plans.force_rooms import force_polygon_sketch
from cranktrain.viz.plans.pin_polar import polar_sketch
from cranktrain.viz.plans.zhukovsky import lever_sketch

NO_ROD = ("scotch_yoke", "oscillating_cylinder", "slotted_lever", "stephenson", "chain")
ENGINES = ("3d12", "r_1340", "deltic", "vaz_21213")

KILONEWTON = Scale("kN")


@pytest.fixture(scope="module")
def results():
    return {name: ct.run(WEIGHED[name]) for name in (*ENGINES, "crank_rocker")}


@pytest.fixture(scope="module")
def sheets(results):
    """Sheets of their forces, each drawn once for all that is asked of it."""
    return cache(lambda name, size="A4": sheet_forces(results[name], size=size))


@cache
def polar_of(name):
    """The polar diagrams of a machine, drawn once for all that is asked of them."""
    return plan_polar(WEIGHED[name])


@pytest.mark.parametrize("name", WEIGHED)
@pytest.mark.parametrize("draw", [plan_forces, plan_zhukovsky])
def test_plan_is_readable(name, draw):
    mechanism = "1valve" if name == "walschaerts" else None
    assert_words_are_readable(draw(WEIGHED[name], [60.0], mechanism=mechanism))


@pytest.mark.parametrize("name", ["slider_crank", "scotch_yoke", "slotted_lever", "chain", "3d12"])
def test_lever_with_friction_is_readable(name):
    drawn = plan_zhukovsky(rubbing(WEIGHED[name]), [60.0])
    assert_words_are_readable(drawn)
    assert any(text.startswith("$f_{") for text, _box in words_of(drawn))


@pytest.mark.parametrize("name", [*ENGINES, "crank_rocker"])
@pytest.mark.parametrize("draw", [plan_forces, plan_zhukovsky])
def test_two_angles_are_readable(name, draw):
    size = "A3" if name == "r_1340" else "A4"  # eight slaves load its master
    assert_words_are_readable(draw(WEIGHED[name], [30.0, 200.0], size=size))
    with pytest.raises(InputError, match="3 crank angles: must be at most 2"):
        draw(WEIGHED[name], 3)


def test_too_many_forces_for_the_paper():
    """No room for the tables of a valve gear at two angles; the polygon of a radial's master would be a speck."""
    for name in ("stephenson", "r_1340"):
        with pytest.raises(InputError, match=f"{TOO_MANY_FORCES} this paper: ask for one crank angle, or for A3"):
            plan_forces(WEIGHED[name], [30.0, 200.0])
        assert_words_are_readable(plan_forces(WEIGHED[name], [30.0, 200.0], size="A3"))


@pytest.mark.parametrize("name", [name for name in WEIGHED if name not in (*NO_ROD, "eccentric")])
def test_polar_diagram_is_readable(name):
    assert_words_are_readable(polar_of(name))


@pytest.mark.parametrize("name", NO_ROD)
def test_no_polar_diagram_without_a_rod(name):
    with pytest.raises(InputError, match=WITHOUT_ROD):
        plan_polar(WEIGHED[name])


@pytest.mark.parametrize("name", [*ENGINES, "crank_rocker"])
@pytest.mark.parametrize("size", ["A4", "A3"])
def test_sheet_is_readable(sheets, name, size):
    assert_words_are_readable(sheets(name, size=size))


def test_sheet_of_a_slave_has_its_forces_and_its_share_of_the_pin(results):
    drawn = sheet_forces(results["3d12"], piston="1R")
    assert_words_are_readable(drawn)
    words = " | ".join(text for text, _box in words_of(drawn))
    assert "1R hangs on the rod of 1L" in words
    assert "Forces at piston 1R, kN" in words
    assert "Its share of the crank pin's load, kN" in words
    assert "Forces at its crank pin" not in words


def test_sheet_of_a_master_has_the_formula_beside(results):
    for name, piston in (("3d12", "1L"), ("r_1340", "1M")):
        drawn = sheet_forces(results[name], piston=piston)
        assert_words_are_readable(drawn)
        words = [text for text, _box in words_of(drawn)]
        assert {"$N_f$", "$T_f$", "$S_A$"} <= set(words)
        assert any(text.startswith("f: the textbook's P·f(β), off by up to") for text in words)


def test_sheet_says_what_it_shows(results):
    words = " | ".join(text for text, _box in words_of(sheet_forces(results["3d12"], piston="2L")))
    for part in (
        "Forces. φ = 0 where crank 1 is on the axis of bank L",
        "Gas pressure at piston 2L, absolute, bar",
        "Forces at piston 2L, kN",
        "Forces at its crank pin, kN",
        f"Torque on the shaft, mean {results['3d12'].mean_torque:.0f}, N·m",
        "Indicator diagram, pressure in bar over volume in L",
        "6: sum 12.00 of 12",
        "Crank angle φ, °",
    ):
        assert part in words


def test_sheet_of_what_has_no_forces():
    with pytest.raises(InputError, match=r"a sheet of forces needs \[masses\]"):
        sheet_forces(ct.run(ct.load("jaw_crusher", set={"load": {}})))
    with pytest.raises(InputError, match="--mechanism = 9Z: must be one of this machine's pistons"):
        sheet_forces(ct.run(WEIGHED["vaz_21213"]), piston="9Z")


def test_orders_reach_as_far_as_eighteen_cylinders_need(sheets):
    words = [text for text, _box in words_of(sheets("deltic", size="A4"))]
    assert "18" in words
    assert "The orders of the torque up to 24 cancel" not in words


def slider_with(**tables):
    """A slider-crank without masses."""
    mechanism = {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "200 mm"}
    return ct.Machine(mechanism=mechanism, shaft={"main": {"speed": "300 rpm"}}, **tables)


@pytest.mark.parametrize(
    ("load", "alone", "are_none"),
    [
        (
            {"on": "main", "torque": "5 N·m"},
            "and neither gas nor a load acts on a part: forces and torque are 0.",
            True,
        ),
        ({"on": "piston", "force": "5 N"}, "forces and torque are of the loads alone.", False),
    ],
)
def test_what_acts_without_masses_is_said(load, alone, are_none):
    """A torque on the shaft beside the machine goes through none of its parts; nor is it gas."""
    result = ct.run(slider_with(load={"x": load}))
    said = next(flag for flag in texts_of(result.flags) if flag.startswith("No masses are given"))
    assert said.endswith(alone)
    words = " ".join(text for text, _box in words_of(sheet_forces(result)))
    assert said in words
    assert ("The torque is the same at every angle: it has no orders" in words) == are_none
    assert "cancel" not in words


def test_curves_are_the_results(results):
    result = results["3d12"]
    pressure, at_piston, at_pin, torque = force_panels(result, "2L")
    row, place = (result.labels[name].index("2L") for name in ("piston", "mechanism"))
    assert pressure.values[0, :-1] == pytest.approx(result.gas_pressure[row])
    assert [curve.symbol for curve in at_piston.curves] == ["P", "S", "N", "N_f"]
    assert at_piston.values[2, :-1] == pytest.approx(result.side_force[0, row])
    assert at_piston.values[3, :-1] == pytest.approx(result.side_force[1, row])
    assert [curve.symbol for curve in at_pin.curves] == ["T", "K", "S_A", "T_f"]
    assert at_pin.values[0, :-1] == pytest.approx(result.crankpin_load_tangential[place])
    _, _, share, _ = force_panels(result, "2R")
    place = result.labels["mechanism"].index("2R")
    assert [curve.symbol for curve in share.curves] == ["T_i", "K_i"]
    assert share.values[0, :-1] == pytest.approx(result.crankpin_share_tangential[place])
    each = [curve.values for curve in torque.curves if curve.role == "each"]
    assert len(each) == 12
    assert sum(each) == pytest.approx(torque.values[-2], abs=1e-6)
    for panel in (pressure, at_piston, at_pin, share, torque):
        assert panel.across.tolist() == list(range(721))
        assert panel.values[:, -1] == pytest.approx(panel.values[:, 0])


def test_sides_of_a_drawn_polygon_are_to_scale():
    """Drawn beside or not: length times μ_F is the force; parts of a reaction, then the whole, then chords."""
    for polygon in force_polygons(WEIGHED["r_1340"], [40.0], mechanism="1M"):
        sketch = force_polygon_sketch(polygon)
        lines = [line for line in sketch.lines if not line.is_closed]
        lengths = [float(np.hypot(*(line.points[:, 1] - line.points[:, 0]))) for line in lines]
        drawn = [*polygon.forces, *(span.force for span in (*polygon.wholes, *polygon.chords))]
        assert lengths == pytest.approx([force.size / polygon.scale for force in drawn], rel=1e-9, abs=1e-9)
        assert [line.habit for line in lines].count("chord") == len(polygon.chords)


def test_sheet_of_polygons_says_what_it_shows():
    words = [text for text, _box in words_of(plan_forces(WEIGHED["3d12"], [30.0]))]
    for part in ("4, 5: group RRP", "3, 6: group RRP", "2: initial link", "3 master rod, 6 master slider", "about D"):
        assert part in words
    assert any("$F_{34}^{t}$" in text for text in words)
    assert any("\\mu_F$ = 0.5 kN/mm" in text for text in words)


def test_drawn_lever_balances_about_its_pole():
    """Moments of the drawn arrows about the pole, in mm², are zero with the couples of inertia."""
    machine = WEIGHED["vaz_21213"]
    lever = zhukovsky_lever(machine, 30.0)
    (polygon,) = velocity_polygons(machine, [30.0])
    newton = 50.0
    arrows = [
        line.points
        for line in lever_sketch(lever, polygon, newton).lines
        if line.layer == "LINKS" and not line.is_closed
    ]
    moments = [float(start[0] * (end - start)[1] - start[1] * (end - start)[0]) for start, end in (a.T for a in arrows)]
    couples = sum(force.moment for force in lever.forces if not force.point)
    whole = sum(moments) * newton * polygon.scale / lever.speed + couples
    assert whole == pytest.approx(0.0, abs=1e-9 * abs(lever.driving_torque))


def test_polar_curves_are_to_scale():
    loads = pin_loads(WEIGHED["vaz_21213"])
    sketch = polar_sketch(loads, (loads.on_pin, loads.on_pin_without), PolarRings(5.0, KILONEWTON, 400.0))
    (full,) = (line.points for line in sketch.lines if line.habit == "vector")
    assert full[:, :-1] * 400.0 == pytest.approx(loads.on_pin)
    assert full[:, -1] == pytest.approx(full[:, 0])
    words = [label.text for label in sketch.labels]
    assert "0°" in words and "10" in words


@pytest.mark.parametrize("name", ["10d100", "vaz_21213"])
def test_no_angle_stands_over_a_mark(name):
    """Neither over the ring of the largest load."""
    loads = pin_loads(ct.load(name))
    for pair in ((loads.on_pin, loads.on_pin_without), (loads.in_rod, loads.in_rod_without)):
        rings = PolarRings(20.0, KILONEWTON, 2000.0) if name == "10d100" else PolarRings(5.0, KILONEWTON, 400.0)
        sketch = polar_sketch(loads, pair, rings)
        ring = max(sketch.circles, key=lambda circle: circle.radius)
        for label in sketch.labels:
            box = label_outline(label, 1.0)
            nearest = np.clip(ring.centre, np.min(box, axis=1), np.max(box, axis=1))
            assert np.hypot(*(nearest - ring.centre)) >= ring.radius, label.text


def test_lever_says_what_is_too_short_to_be_drawn():
    """All that rubs in an engine is small beside the gas."""
    words = [text for text, _box in words_of(plan_zhukovsky(rubbing(WEIGHED["vaz_21213"]), [30.0]))]
    assert "Too short to be drawn:" in words
    assert words[words.index("Too short to be drawn:") + 1] == "$f_{14}$"


def test_a_valve_gears_lever_with_friction_is_readable():
    gear = rubbing(WEIGHED["walschaerts"])
    assert_words_are_readable(plan_zhukovsky(gear, [60.0], mechanism="1valve"))
    with pytest.raises(InputError, match=rf"{TOO_MANY_FORCES} this paper: ask for one crank angle$"):
        plan_zhukovsky(gear, [60.0, 200.0], mechanism="1valve", size="A3")


def star(n_sliders):
    """Sliders all round a crank pin, each with a rod of its own."""
    parts = [
        {
            "type": "slide",
            "rod": {"name": f"rod{i}", "from": "main.pin", "length": "200 mm"},
            "slider": f"slider{i}",
            "guide": {"through": "O", "direction": f"{i * 360 // n_sliders} deg"},
            "side": "ahead",
        }
        for i in range(n_sliders)
    ]
    still = {"along": "1 mm", "inertia": "0.001 kg*m^2"}
    masses = {f"slider{i}": {"mass": f"{i + 1} kg", **still} for i in range(n_sliders)}
    chain = {"kind": "chain", "output": "slider0", "crank": {"main": {"radius": "50 mm"}}, "part": parts}
    return ct.Machine(mechanism=chain, shaft={"main": {"speed": "600 rpm"}}, masses=masses, gravity=True)


def test_more_forces_than_a_sheet_has_room_for():
    with pytest.raises(InputError, match=rf"{TOO_MANY_FORCES} A4: ask for A3, --size A3$"):
        plan_zhukovsky(star(18), [60.0])
    assert_words_are_readable(plan_zhukovsky(star(18), [60.0], size="A3"))
    with pytest.raises(InputError, match=rf"{TOO_MANY_FORCES} a sheet$"):
        plan_zhukovsky(star(40), [60.0], size="A3")


@pytest.mark.parametrize("draw", [plan_forces, plan_positions, plan_velocities, plan_accelerations])
@pytest.mark.parametrize("name", ["10d100", "deltic"])
def test_plans_of_opposed_pistons_are_readable(name, draw):
    figure = draw(ct.load(name))
    assert_words_are_readable(figure)
    words = " | ".join(text for text, _box in words_of(figure))
    assert f", cylinder {'1' if name == '10d100' else '1A'}. " in words


@pytest.mark.parametrize("name", ["vaz_21213", "3d12", "r_1340", "deltic"])
def test_polar_sheet_says_its_scales_and_covers_the_cycle(name):
    """Every diagram has a scale of its own, and the table a row each 30° of the whole cycle."""
    figure = polar_of(name)
    words = [text for text, _box in words_of(figure)]
    assert sum("kN/mm, rings each" in text for text in words) == 2
    cycle = pin_loads(WEIGHED[name]).cycle
    angles = [float(text) for text in words if text.isdigit()]
    assert set(np.arange(0.0, cycle, 30.0)) <= set(angles)


def test_same_bytes(tmp_path, results):
    for name in ("one", "other"):
        save(lambda: sheet_forces(results["vaz_21213"]), str(tmp_path / f"{name}.svg"))
    assert (tmp_path / "one.svg").read_bytes() == (tmp_path / "other.svg").read_bytes()


def test_sheet_of_a_valve():
    """One on an eccentric has a rod, as a piston has, unless nothing acts on it; one of a gear has none."""
    engine = read_machine("great_northern", ["masses.piston.mass=300 kg"]).machine
    for machine, has_rod in ((engine, True), (WEIGHED["walschaerts"], False)):
        said = " ".join(text for text, _box in words_of(sheet_forces(ct.run(machine), piston="1valve")))
        assert ("Forces at valve 1valve" in said) is has_rod
        assert ("P, S, N, K, T: by the reactions" in said) is has_rod


@pytest.mark.parametrize("draw", [sheet, sheet_forces])
def test_a_table_that_is_not_used_is_told_in_the_head(draw):
    machine = ct.Machine(
        mechanism=slider(),
        shaft=throws(0, speed="1500 rpm"),
        cylinder={"bore": "80 mm", "cycle": "four-stroke"},
        masses={"piston": {"mass": "1 kg"}},
        gas=DUAL_CYCLE,
    )
    figure = draw(ct.run(machine))
    said = f"[gas] is not used: [cylinder] compression_ratio or clearance is missing; {OF_INERTIA_ALONE}"
    assert said in [text for text, _box in words_of(figure)]
    assert_words_are_readable(figure)


def test_a_panel_in_the_units_that_a_reader_chose():
    """1 psi = 6894.757293168 Pa."""
    panel = Panel("Pressure", "Pa", np.array([0.0, 1.0]), (Curve(np.array([1e5, 2e5]), "main", "p"),))
    assert (as_shown(panel).unit, as_shown(panel).values.tolist()) == ("bar", [[1.0, 2.0]])
    with shown_by(units_by_dimension(["psi"])):
        found = as_shown(panel)
    assert found.unit == "psi"
    assert found.values[0] == pytest.approx([14.503773773, 29.007547546], rel=1e-9)


def test_a_double_acting_machine_says_which_chamber():
    """Its legend would else have the same letter twice; the cards of both sides have their mean pressures."""
    tables = {
        "shaft": {"main": {"speed": "500 rpm"}},
        "cylinder": {"bore": "300 mm", "clearance": "10 %", "chambers": ["head", "crank"], "piston_rod": "60 mm"},
        "gas": {
            "kind": "compressor",
            "suction_pressure": "1 bar",
            "discharge_pressure": "4 bar",
            "compression_exponent": 1.3,
        },
        "masses": {"piston": {"mass": "20 kg"}, "rod": {"big_end": "20 kg", "small_end": "10 kg"}},
    }
    drawn = sheet_forces(ct.run(ct.Machine(mechanism=slider(), **tables)))
    assert_words_are_readable(drawn)
    words = " ".join(text for text, _box in words_of(drawn))
    for said in (r"p_\mathrm{head}", r"p_\mathrm{crank}", "head: mean", "crank (thin): mean"):
        assert said in words
