"""What is beyond everything built is doubted, just within it is not; every limit by numbers of one machine, by hand."""

import importlib
import pkgutil

import numpy as np
import pytest
from tests.gas_engines import DUAL_CYCLE
from tests.sentences import MORE_THAN_LUBRICATED
from tests.told import texts_of

import cranktrain as ct
from cranktrain import questions
from cranktrain.io.examples import example_names
from cranktrain.io.machine_file import read_machine
from cranktrain.saying.checks import Limit

BORE, RADIUS = 0.085, 0.05
AREA = np.pi / 4 * BORE**2
LIMITS = {
    name.strip("_").lower(): value
    for found in pkgutil.walk_packages(questions.__path__, "cranktrain.questions.")
    for name, value in vars(importlib.import_module(found.name)).items()
    if isinstance(value, Limit)
}
FIRED = {"cycle": "four-stroke", "firing_order": "1"}


def machine(*, speed="600 rpm", cylinder=None, gas=None, masses=None, friction=None):
    tables = {
        "shaft": {"main": {"speed": speed}},
        "mechanism": {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "180 mm"},
        "cylinder": {"bore": "85 mm", **(cylinder or {})},
    }
    others = {"gas": gas, "masses": masses, "friction": friction}
    return ct.Machine(**tables, **{name: table for name, table in others.items() if table})


def doubted(made):
    heads = tuple(limit.sentence.partition("{")[0] for limit in LIMITS.values())
    return tuple(flag for flag in texts_of(ct.run(made, step_degrees=10).flags) if flag.startswith(heads))


def by_speed(value):
    """2 S n with a stroke of 0.1 m."""
    return machine(speed=f"{value / 0.2 * 60!r} rpm")


def by_bore(value):
    return machine(cylinder={"bore": f"{value!r} m"})


def by_ratio(value):
    return machine(cylinder={"compression_ratio": value})


def by_ratio_of_engine(value):
    return machine(cylinder={"compression_ratio": value, **FIRED}, gas={**DUAL_CYCLE, "start_pressure": "50 kPa"})


def by_pressure(value):
    """The dual cycle's peak: start pressure times ε^1.36 times the rise of pressure."""
    start = value / (20**1.36 * DUAL_CYCLE["pressure_ratio"])
    return machine(cylinder={"compression_ratio": 20, **FIRED}, gas={**DUAL_CYCLE, "start_pressure": f"{start!r} Pa"})


def by_density(value):
    """Mass over area and diameter, of a machine too slow for its inertia to matter."""
    masses = {"piston": {"mass": f"{value * AREA * BORE!r} kg"}}
    return machine(speed="60 rpm", cylinder={"compression_ratio": 16, **FIRED}, gas=DUAL_CYCLE, masses=masses)


def by_inertia(value):
    """p = m R ω²/A at 600 rpm."""
    mass = value * AREA / (RADIUS * (2 * np.pi * 10) ** 2)
    return machine(masses={"piston": {"mass": f"{mass!r} kg"}})


def by_friction(value):
    return machine(masses={"piston": {"mass": "1 kg"}}, friction={"piston": value})


def by_closeness(value):
    """A rod longer than the crank by a margin 1/value of itself, at 1 rpm."""
    return alone({"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": f"{50 / (1 - 1 / value)!r} mm"})


def by_distance(value):
    """The top lies R + L from the shaft, and the stroke is 2 R."""
    return alone({"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": f"{100 * value - 50!r} mm"})


def by_swing(value):
    """A yoke-like four-bar, a long rod square to the rocker: it swings 2 R/280 mm, but for R²."""
    lengths = {"rod_length": "400 mm", "rocker_length": "280 mm", "ground_length": f"{float(np.hypot(400, 280))!r} mm"}
    return alone({"kind": "crank_rocker", "crank_radius": f"{140 / value!r} mm", **lengths})


def by_slider_speed(value):
    """As `by_speed`, without a cylinder."""
    return alone({"kind": "slider_crank", "stroke": "100 mm", "rod_length": "180 mm"}, f"{value / 0.2 * 60!r} rpm")


def on_shaft(force="1 kN", **crankshaft):
    """A massless machine whose piston is pressed: in its bearings, 100 mm apart."""
    sizes = {
        "journal_diameter": "60 mm",
        "pin_diameter": "50 mm",
        "pin_length": "30 mm",
        "web_thickness": "15 mm",
        "web_width": "80 mm",
        "bearing_distance": "50 mm",
    }
    return ct.Machine(
        mechanism={"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "180 mm"},
        shaft={"main": {"speed": "60 rpm"}},
        load={"pressing": {"on": "piston", "force": force}},
        crankshaft={**sizes, **crankshaft},
    )


def by_young(value):
    return on_shaft(young_modulus=f"{value!r} Pa")


def by_stiffness(value):
    """In parts of 206 GPa times 60 mm."""
    return on_shaft(bearing_stiffness=f"{value * 206e9 * 0.06!r} N/m")


def by_clearance(value):
    return on_shaft(bearing_clearance=f"{60 * value!r} mm")


def pressed_to(stress, diameter):
    """Force on the piston so that σ = 32 M/(π d³), M = S·100 mm/4, where S = F/cos β at its most: sin β = R/L."""
    moment = stress * np.pi * diameter**3 / 32
    return f"{float(moment / 0.025 * np.sqrt(1 - (RADIUS / 0.18) ** 2))!r} N"


def by_pin_stress(value):
    return on_shaft(force=pressed_to(value, 0.05))


def by_journal_stress(value):
    return on_shaft(force=pressed_to(value, 0.04), journal_diameter="40 mm")


def by_lambda(value):
    gas, cylinder = {**DUAL_CYCLE, "start_pressure": "50 kPa"}, {"compression_ratio": 8, **FIRED}
    made = machine(speed="60 rpm", cylinder={"bore": "85 mm", **cylinder}, gas=gas)
    return made.with_({"mechanism.rod_length": f"{50 / value!r} mm"})


def burning(**gas):
    """A cylinder that burns 300 J, with 20 W/(m²·K) to walls of 400 K."""
    wiebe = {
        "kind": "wiebe",
        "start_pressure": "100 kPa",
        "exhaust_pressure": "100 kPa",
        "heat": "300 J",
        "heat_start": "-10 deg",
        "heat_duration": "50 deg",
        "form_factor": "1.5",
        "heat_capacity_ratio": "1.33",
        "heat_transfer": "20 W/(m²·K)",
        "start_temperature": "330 K",
        "wall_temperature": "400 K",
    }
    return machine(speed="1500 rpm", cylinder={"compression_ratio": 9, **FIRED}, gas={**wiebe, **gas})


def by_heat(value):
    """In parts of 43 MJ/kg over 15.7 kg of mixture for one of fuel, of p V/(R T) of mixture in 9/8 of the stroke."""
    charge = 100e3 * AREA * 0.1 * 9 / 8 / (287 * 330)
    return burning(
        heat=f"{float(value * charge * 43e6 / 15.7)!r} J", wall_temperature="330 K", heat_transfer="1e-6 W/(m²·K)"
    )


def by_wall(value):
    return burning(wall_temperature=f"{value!r} K")


def by_exponent(value):
    gas = {"kind": "compressor", "suction_pressure": "1 bar", "discharge_pressure": "4 bar"}
    return machine(cylinder={"clearance": "6 %"}, gas={**gas, "compression_exponent": value})


def by_arm(value):
    """In parts of 230 mm, as far as the wrist pin of 50 and 180 mm comes."""
    load = {"on": "rod", "along": f"{230 * value!r} mm", "force": "1 N"}
    return alone({"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "180 mm"}, load={"push": load})


def by_efficiency(value):
    return machine(cylinder={"compression_ratio": 9, "mechanical_efficiency": value, **FIRED}, gas=DUAL_CYCLE)


def by_stage(value):
    return on_shaft().with_({"drive": {"stage": [{"ratio": 3, "efficiency": value}]}})


def by_centre(value):
    rod = {"mass": "1 kg", "along": f"{180 * value!r} mm", "inertia": "0.006 kg·m²"}
    return machine(masses={"piston": {"mass": "1 kg"}, "rod": rod})


def alone(mechanism, speed="1 rpm", **tables):
    return ct.Machine(mechanism=mechanism, shaft={"main": {"speed": speed}}, **tables)


MACHINES = {
    "closeness": by_closeness,
    "distance": by_distance,
    "swing": by_swing,
    "mean_speed": by_speed,
    "slider_speed": by_slider_speed,
    "ratio": by_ratio,
    "engine_ratio": by_ratio_of_engine,
    "peak_pressure": by_pressure,
    "density": by_density,
    "inertia_pressure": by_inertia,
    "friction": by_friction,
    "centre": by_centre,
    "lambda": by_lambda,
    "least_heat": by_heat,
    "coldest_wall": by_wall,
    "bore": by_bore,
    "least_exponent": by_exponent,
    "least_efficiency": by_efficiency,
    "young": by_young,
    "stiffness": by_stiffness,
    "clearance": by_clearance,
    "pin_stress": by_pin_stress,
    "journal_stress": by_journal_stress,
    "stage_efficiency": by_stage,
    "far_load": by_arm,
}
BELOW_NOTHING = {"least_share"}
"""Limits of 0, about which nothing lies within a part of them."""
NEVER_ALONE = {"fastest_cooling"}
"""What is so cooled does no work either; it is tried in `gas/test_fast_cooling.py`."""
ENDS = [
    (name, end, side)
    for name in MACHINES
    for end, side in ((LIMITS[name].most, 1), (LIMITS[name].least, -1))
    if np.isfinite(end)
]


def test_every_limit_is_tried():
    assert set(MACHINES) | BELOW_NOTHING | NEVER_ALONE == set(LIMITS)


@pytest.mark.parametrize(("name", "end", "side"), ENDS)
def test_within_a_limit_nothing_is_doubted_beyond_it_that_alone(name, end, side):
    assert doubted(MACHINES[name](float(end * (1 - side * 1e-3)))) == ()
    (said,) = doubted(MACHINES[name](float(end * (1 + side * 1e-3))))
    assert said.partition("{")[0].startswith(LIMITS[name].sentence.partition("{")[0])


def test_heat_that_becomes_no_work_is_doubted():
    """Walls that take 2 kW/(m²·K) of 30 J leave less than the gas lost to them while it was compressed."""
    assert doubted(burning()) == ()
    (said,) = doubted(burning(heat="30 J", heat_transfer="2000 W/(m²·K)"))
    assert said.startswith("Of the heat in 1 −")


@pytest.mark.parametrize("name", example_names())
def test_no_example_is_doubted(name):
    assert doubted(ct.load(name)) == ()


@pytest.mark.parametrize(
    ("made", "said"),
    [
        (by_ratio(93), "A compression ratio of 93 is more than engines or compressors have: "),
        (by_friction(0.99), f"A coefficient of friction of 0.99 {MORE_THAN_LUBRICATED}"),
        (by_speed(32.5), "A mean piston speed of 32.5 m/s is more than any piston bears: "),
        (by_pressure(140e6), "A pressure of 140 MPa is more than engines bear: "),
    ],
)
def test_the_number_is_told(made, said):
    assert doubted(made)[0].startswith(said)


def test_a_mass_in_grams_is_doubted():
    """450 for 0.45: mRω²/A is 450 kg · 40 mm · (5200 rpm)² on 82 mm."""
    file = read_machine("vaz_21213", ["masses.piston.mass=450 kg"])
    found = doubted(file.machine)
    assert found[0].startswith("A piston of 450 kg is heavier than ten of its diameters of solid steel")
    inertia = 450 * 0.04 * (5200 * np.pi / 30) ** 2 / (np.pi / 4 * 0.082**2)
    assert f"mRω²/A, is {inertia / 1e6:.4g} MPa" in found[1]


def test_a_valve_is_no_piston():
    """A valve's mean speed is that of its travel, and no one knows how fast valves are."""
    eccentric = {"kind": "eccentric", "eccentricity": "60 mm", "rod_length": "1.4 m", "angle_of_advance": "30 deg"}
    assert doubted(ct.Machine(mechanism=eccentric, shaft={"main": {"speed": "9000 rpm"}})) == ()


def test_of_several_designs_the_worst_is_told():
    result = ct.run([by_friction(value) for value in (0.1, 0.4, 0.5)])
    assert [flag for flag in texts_of(result.flags) if "friction" in flag] == [
        f"A coefficient of friction of 0.5 {MORE_THAN_LUBRICATED}do these run dry?"
    ]


def test_what_is_computed_is_doubted():
    """Asked for one result, one hears what is beyond the limits in what it takes, and no more is computed."""
    fast = by_speed(33.0)
    assert len(ct.run(fast, quantities="mean_piston_speed").flags) == 1
    assert ct.run(fast, quantities="stroke").flags == ()
