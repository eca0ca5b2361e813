"""Careless machines are asked about, those similar to them in the same words, and right ones are not.

Right machines are made up by the proportions that built ones have, from models to slow marine engines.
"""

import inspect
from pathlib import Path

import numpy as np
import pytest
from tests.gas_engines import DUAL_CYCLE
from tests.similar_machines import similar
from tests.told import texts_of

import cranktrain as ct
from cranktrain.analysis import every_stage, run
from cranktrain.analysis.stages import leading_to
from cranktrain.cli.check import show_check
from cranktrain.io.examples import example_names

STEEL = 206e9


def mm(length):
    return f"{float(length)!r} mm"


# Name, bore and stroke in mm, λ, rpm, strokes, throws, banks' angles, firing order, compression ratio.
FLAT4, LIKE4 = ("0", "180", "180", "0"), ("0", "0", "180", "180")
SIX, CROSS = ("0", "240", "120", "120", "240", "0"), ("0", "90", "270", "180")
FIVE, THREE = ("0", "144", "216", "288", "72"), ("0", "240", "120")
ENGINES = [
    ("glow model", 15, 14, 0.30, 14000, "two", ("0",), (0,), "1", 9),
    ("four-stroke model", 24, 20, 0.31, 9000, "four", ("0",), (0,), "1", 9.5),
    ("chainsaw", 44.7, 32, 0.28, 9500, "two", ("0",), (0,), "1", 9.5),
    ("mower", 65.1, 44.4, 0.25, 3600, "four", ("0",), (0,), "1", 8),
    ("stationary diesel", 114.3, 139.7, 0.24, 650, "four", ("0",), (0,), "1", 17),
    ("twin of 360°", 67, 56, 0.26, 6500, "four", ("0", "0"), (0,), "1-2", 9),
    ("twin of 180°", 74, 58, 0.26, 8000, "four", ("0", "180"), (0,), "1-2", 10.5),
    ("twin of 270°", 98, 79, 0.29, 6000, "four", ("0", "270"), (0,), "1-2", 10.5),
    ("V twin of 45°", 88.9, 108, 0.27, 4500, "four", ("0",), (-22.5, 22.5), "1L-1R", 8.5),
    ("V twin of 90°", 94, 71.5, 0.29, 7500, "four", ("0",), (-45, 45), "1L-1R", 11),
    ("three", 71, 81, 0.30, 5000, "four", THREE, (0,), "1-3-2", 10.5),
    ("four, cross-plane", 78, 52.2, 0.28, 9500, "four", CROSS, (0,), "1-3-2-4", 12.7),
    ("car's four", 82, 80, 0.30, 5200, "four", FLAT4, (0,), "1-3-4-2", 9.5),
    ("diesel five", 90.9, 92.4, 0.31, 3800, "four", FIVE, (0,), "1-3-5-4-2", 19),
    ("car's six", 84, 75, 0.28, 6000, "four", SIX, (0,), "1-2-3-6-5-4", 10),
    ("V8", 101.6, 88.4, 0.305, 5000, "four", CROSS, (-45, 45), "1L-1R-4L-2L-2R-3L-3R-4R", 9.5),
    ("V4 of 90°", 76, 55.2, 0.28, 10000, "four", ("0", "180"), (-45, 45), "1L-2L-2R-1R", 11.5),
    ("medium-speed six", 320, 440, 0.22, 750, "four", SIX, (0,), "1-2-3-6-5-4", 15),
    ("large six", 460, 580, 0.23, 500, "four", SIX, (0,), "1-2-3-6-5-4", 14),
    ("crosshead of λ 0.49", 500, 2000, 0.488, 127, "two", ("0", "120", "240"), (0,), "1-3-2", 18),
    ("crosshead of 960 mm", 960, 2500, 0.43, 102, "two", THREE, (0,), "1-2-3", 18),
]


def engine(name, bore, stroke, ratio, speed, strokes, throws, banks, order, compression):
    """An engine by the proportions that built ones have, in mm and kg; with weights for what turns at each throw."""
    radius, rod = stroke / 2, stroke / 2 / ratio
    piston, rod_mass = 0.9e-6 * bore**3, 1.0e-6 * bore**3
    journal, pin = 0.70 * bore, 0.65 * bore
    in_v = len(banks) > 1
    width = 0.38 * bore
    pin_length = (2.1 if in_v else 1.1) * width
    spacing = pin_length + 2 * 0.22 * bore + 0.45 * bore
    crank = 0.9e-6 * bore**3
    moment = crank + 0.7 * rod_mass * len(banks)
    mechanism = {"kind": "slider_crank", "crank_radius": mm(radius), "rod_length": mm(rod)}
    names = ("L", "R") if in_v else ("line",)
    stagger = [-0.525 * width, 0.525 * width] if in_v else [0.0]
    return {
        "shaft": {
            "main": {
                "throws": [f"{angle} deg" for angle in throws],
                "speed": f"{speed} rpm",
                "spacing": mm(spacing),
            }
        },
        "bank": {
            bank: {"angle": f"{angle} deg", "mechanism": mechanism, "stagger": mm(aside)}
            for bank, angle, aside in zip(names, banks, stagger, strict=True)
        },
        "cylinder": {
            "bore": mm(bore),
            "compression_ratio": compression,
            "cycle": f"{strokes}-stroke",
            "firing_order": order,
            "mechanical_efficiency": 0.85,
        },
        "gas": {**DUAL_CYCLE, **({} if strokes == "four" else {"exhaust_pressure": "100 kPa"})},
        "masses": {
            "piston": {"mass": f"{piston!r} kg"},
            "rod": {
                "mass": f"{rod_mass!r} kg",
                "along": mm(0.3 * rod),
                "inertia": f"{0.2e-6 * rod_mass * rod**2!r} kg·m²",
            },
            "crank": {"mass": f"{crank!r} kg", "along": mm(radius), "inertia": f"{1e-6 * crank * bore**2!r} kg·m²"},
        },
        "balance": {
            "weight": [{"throw": n + 1, "mass": f"{moment!r} kg", "radius": mm(radius)} for n in range(len(throws))]
        },
        "crankshaft": {
            "journal_diameter": mm(journal),
            "pin_diameter": mm(pin),
            "pin_length": mm(pin_length),
            "web_thickness": mm(0.22 * bore),
            "web_width": mm(1.1 * bore),
            "bearing_distance": mm(spacing / 2),
            "bearing_width": mm(0.36 * bore),
            "rod_bearing_width": mm(width),
            "bearing_stiffness": f"{0.1 * STEEL * journal / 1e3!r} N/m",
            "bearing_clearance": mm(1e-3 * journal),
        },
    }


BY_NAME = {row[0]: engine(*row) for row in ENGINES}


def compressor(bore, stroke, ratio, speed, suction, discharge, exponent):
    return {
        "shaft": {"main": {"speed": f"{speed} rpm"}},
        "mechanism": {"kind": "slider_crank", "stroke": mm(stroke), "crank_to_rod_ratio": ratio},
        "cylinder": {"bore": mm(bore), "clearance": "8 %"},
        "gas": {
            "kind": "compressor",
            "suction_pressure": f"{suction} bar",
            "discharge_pressure": f"{discharge} bar",
            "compression_exponent": exponent,
        },
    }


# Of a refrigerator and an aquarium to process gas, with air, refrigerants and hydrocarbons.
COMPRESSORS = [
    compressor(*row)
    for row in (
        (21, 14, 0.25, 2900, 1.2, 7.8, 1.09),
        (12, 4, 0.2, 3000, 1, 1.3, 1.38),
        (25.4, 18, 0.28, 2900, 1.5, 14, 1.12),
        (34, 20, 0.3, 1450, 1, 7, 1.3),
        (42, 25, 0.3, 1450, 1, 8, 1.34),
        (47, 38, 0.33, 2800, 1, 8, 1.3),
        (55, 40, 0.3, 1100, 2, 16, 1.15),
        (65, 50, 0.28, 1450, 3.5, 15, 1.18),
        (70, 60, 0.26, 970, 1, 9, 1.3),
        (79.4, 82.8, 0.286, 1500, 1.01, 9.1, 1.13),
        (90, 70, 0.25, 1450, 2.4, 17, 1.22),
        (105, 80, 0.24, 980, 1, 4, 1.3),
        (125, 100, 0.22, 970, 1, 8, 1.25),
        (150, 120, 0.2, 750, 5, 20, 1.27),
        (200, 110, 0.2, 980, 4, 16, 1.24),
        (240, 140, 0.2, 735, 1, 3.3, 1.35),
        (381, 152, 0.2, 1000, 5.15, 13.4, 1.279),
        (450, 200, 0.18, 500, 1, 3, 1.35),
        (600, 320, 0.17, 375, 20, 45, 1.3),
        (900, 450, 0.16, 250, 1, 2.8, 1.38),
    )
]


def radial(bore, stroke, ratio, knuckle, n_slaves):
    """A star whose slaves' rods are the shorter by the knuckle radius, whose pins stand on their own axes."""
    radius, rod = stroke / 2, stroke / 2 / ratio
    angles = [360 / (n_slaves + 1) * (n + 1) for n in range(n_slaves)]
    master = {"kind": "slider_crank", "crank_radius": mm(radius), "rod_length": mm(rod)}
    slave = {
        "kind": "articulated_rod",
        "master": "M",
        "knuckle_radius": mm(knuckle * radius),
        "rod_length": mm(rod - knuckle * radius),
        "articulation_angle": [f"{angle!r} deg" for angle in angles],
    }
    banks = {"M": {"mechanism": master}, "S": {"angle": slave["articulation_angle"], "mechanism": slave}}
    return {"bank": banks, "cylinder": {"bore": mm(bore), "compression_ratio": 6.5}}


RADIALS = [
    radial(*row)
    for row in (
        (25, 20, 0.3, 0.75, 4),
        (40, 36, 0.29, 0.8, 4),
        (70, 68, 0.28, 0.8, 2),
        (80, 85, 0.28, 0.85, 4),
        (105, 120, 0.26, 0.8, 4),
        (108, 114, 0.27, 0.8, 4),
        (108, 114, 0.27, 0.85, 6),
        (114, 140, 0.27, 0.8, 8),
        (120, 140, 0.25, 0.9, 4),
        (127, 139.7, 0.26, 0.85, 6),
        (130, 152, 0.28, 0.8, 6),
        (131, 152, 0.28, 0.85, 8),
        (140, 140, 0.25, 0.85, 6),
        (146, 146, 0.276, 0.85, 8),
        (146, 165, 0.28, 0.87, 8),
        (155.6, 160, 0.27, 0.9, 6),
        (155.6, 174.5, 0.27, 0.85, 8),
        (156, 170, 0.27, 0.85, 8),
        (160, 170, 0.26, 0.8, 6),
        (216, 216, 0.25, 0.8, 10),
    )
]


def stroke_of_work(stroke, points, back=None, counts=None, ratio=0.1, angle="180 deg", speed="60 rpm"):
    """A tool on a slider-crank: kN at places of its travel, in parts of the stroke."""
    places, sizes = zip(*points, strict=True)
    load = {
        "on": "piston",
        "travel": [mm(stroke * place * (1 + 1e-3 * (place == 1))) for place in places],
        "force": [f"{size} kN" for size in sizes],
        "force_back": [f"{size} kN" for size in back or [0] * len(sizes)],
    }
    return {
        "angle": angle,
        "shaft": {"main": {"speed": speed}},
        "mechanism": {"kind": "slider_crank", "stroke": mm(stroke), "crank_to_rod_ratio": ratio},
        "load": {"tool": load | ({} if counts is None else {"counts": counts})},
    }


def from_on(part, size):
    """From a part of the stroke on."""
    return [(0, 0), (part, 0), (part + 0.002, size), (1, size)]


def between(begin, end, size):
    """From a part of the stroke to another."""
    return [(0, 0), (begin, 0), (begin + 0.002, size), (end, size), (end + 0.002, 0), (1, 0)]


STROKES = [
    stroke_of_work(6, from_on(0.8, 2)),  # eyelets
    stroke_of_work(20, from_on(0.9, 60)),  # a bench press
    stroke_of_work(60, from_on(0.95, 250)),
    stroke_of_work(130, from_on(0.954, 1000)),
    stroke_of_work(200, from_on(0.97, 2500)),  # coining
    stroke_of_work(400, from_on(0.95, 25000)),  # forging
    stroke_of_work(250, from_on(0.5, 800)),  # deep drawing
    stroke_of_work(500, from_on(0.6, 4000)),
    stroke_of_work(100, between(0.73, 0.92, 250)),  # shears
    stroke_of_work(80, between(0.6, 0.8, 3200)),  # hot billets
    stroke_of_work(50, between(0.85, 0.9, 63)),  # punching
    stroke_of_work(100, [(0, 0), (0.4, 0), (0.41, 40), (0.9, 160), (1, 160)]),
    stroke_of_work(400, between(0.05, 0.95, 5), counts="against", ratio=0.2),  # a shaper that draws
    stroke_of_work(600, between(0.03, 0.97, 8), ratio=0.2),  # and one that pushes
    stroke_of_work(300, [(0, 12), (1, 12)], ratio=0.2),  # a plunger pump presses over all of its stroke
    stroke_of_work(80, [(0, 5), (1, 5)], ratio=0.25, speed="300 rpm"),
    stroke_of_work(450, [(0, 90), (0.03, 110), (1, 110)], ratio=0.2),
    stroke_of_work(150, [(0, 0), (1, 0)], back=[12, 12], ratio=0.2),  # a pump that delivers as it comes back
    stroke_of_work(700, [(0, 0.5), (0.5, 15), (1, 120)]),  # a baler, denser and denser
    stroke_of_work(150, [(0, 0.3), (1, 0.3)], back=[0.3, 0.3], ratio=0.1),  # a saw that cuts both ways
    stroke_of_work(250, [(0, 2), (0.3, 0), (1, 0)], back=[2, 0.5, 0.5], ratio=0.1),  # wire both ways
]


def servo(stroke, blank, durations, size, counts_from="near"):
    """A servo press whose ram meets its blank on the way down, in mm and s."""
    far = counts_from == "far"

    def at(place):
        return mm(stroke - place if far else place)

    down, through, rest, up, fed = durations
    pieces = [
        {"duration": f"{down} s", "to": at(blank * 0.98)},
        {"duration": f"{through} s", "to": at(stroke)},
        {"duration": f"{rest} s"},
        {"duration": f"{up} s", "to": at(0)},
        {"duration": f"{fed} s"},
    ]
    made = stroke_of_work(stroke, from_on(blank / stroke, size))
    shaft = {
        "motion": {
            "of": "piston",
            "counts_from": counts_from,
            "piece": [one for one in pieces if one["duration"] != "0 s"],
        }
    }
    stage = {"kind": "gear", "ratio": 30, "efficiency": 0.95}
    masses = {"piston": {"mass": f"{0.6e-3 * stroke**3!r} kg"}}
    return {**made, "shaft": {"main": shaft}, "masses": masses, "drive": {"stage": [stage]}}


SERVOS = [
    servo(stroke, blank, durations, size, counts_from)
    for stroke, blank, size in ((40, 34, 30), (100, 88, 400), (160, 120, 1600), (300, 150, 3000), (500, 440, 10000))
    for durations, counts_from in (
        ((0.5, 0.6, 0.15, 0.5, 0.25), "near"),
        ((0.5, 0.6, 0.15, 0.5, 0.25), "far"),
        ((1, 0.3, 0, 0.8, 0.4), "near"),
        ((0.4, 0.9, 0.4, 0.4, 0), "far"),
    )
]


def driven(stroke, points, ratio, efficiency, kind="gear", power="5.5 kW"):
    """A tool with a motor, through one stage."""
    stage = {"kind": kind, "ratio": ratio, "efficiency": efficiency}
    made = stroke_of_work(stroke, points)
    motor = {"kind": "wound_rotor", "power": power, "speed": "1440 rpm", "synchronous_speed": "1500 rpm"}
    motor |= {"breakdown_ratio": 2.5, "resistance_ratio": 3, "inertia": "0.03 kg·m²"}
    return {
        **made,
        "drive": {"motor": motor, "stage": [stage]},
        "evenness": {"flywheel": "800 kg·m²"},
    }


DRIVES = [
    driven(stroke, points, ratio, efficiency, kind)
    for stroke, points in (
        (60, from_on(0.95, 20)),
        (100, between(0.6, 0.8, 10)),
        (300, [(0, 2), (1, 2)]),
        (150, from_on(0.5, 3)),
    )
    for ratio, efficiency, kind in (
        (24, 0.95, "gear"),
        (25, 0.7, "worm"),
        (25, 0.35, "worm"),
        (24, 0.97, "chain"),
        (25, 0.2, "worm"),
    )
]
RIGHT = {
    "engine": list(BY_NAME.values()),
    "compressor": COMPRESSORS,
    "radial": RADIALS,
    "stroke": STROKES,
    "servo": SERVOS,
    "drive": DRIVES,
}


SETS = "unlikely="
"""What is written where a stage asks."""


def module_of(stage):
    return inspect.getmodule(stage.function)


ASKING = [stage.gives for stage in every_stage() if SETS in inspect.getsource(module_of(stage))]
NEEDED = leading_to(every_stage(), ASKING)
"""What a machine is asked about comes of these: none of the others can add to it."""


def asked(machine):
    return texts_of(run(machine, step_degrees=10, stages=NEEDED).unlikely)


def test_no_other_stage_asks():
    """Nor what stages call: what may ask stands in the module of a stage."""
    modules = {Path(module_of(stage).__file__) for stage in every_stage()}
    source = Path(ct.__file__).parent
    asking = {path for path in source.rglob("*.py") if SETS in path.read_text(encoding="utf-8")}
    assert len(asking) > 10
    assert asking <= modules


@pytest.mark.parametrize("name", ["crusher", "four", "press"])
def test_asked_is_what_a_run_of_everything_asks(name):
    table, changes, _ = CARELESS[{"crusher": "cm as mm of a point", "four": "wide rods", "press": "ways swapped"}[name]]
    machine = ct.Machine(**changed(table, changes))
    assert asked(machine) == texts_of(ct.run(machine).unlikely)
    assert asked(machine) != ()


@pytest.mark.parametrize(("kind", "place"), [(kind, n) for kind, tables in RIGHT.items() for n in range(len(tables))])
def test_right_machines_are_not_asked_about(kind, place):
    assert asked(ct.Machine(**RIGHT[kind][place])) == ()


@pytest.mark.parametrize("kind", RIGHT)
def test_there_are_twenty_of_a_kind(kind):
    assert len(RIGHT[kind]) >= 20


@pytest.mark.parametrize("name", example_names())
def test_examples_are_not_asked_about(name):
    assert asked(ct.load(name)) == ()


def changed(table, changes):
    """A machine's tables with other values at paths; None takes a key away."""
    found = ct.Machine(**table).declared
    copied = dict(found)
    for path, value in changes.items():
        copied = _with(copied, path.split("."), value)
    return copied


def _with(table, path, value):
    key, *rest = path
    if isinstance(table, tuple | list):
        return [_with(one, rest, value) if n == int(key) and rest else one for n, one in enumerate(table)]
    if rest:
        return {**table, key: _with(table.get(key, {}), rest, value)}
    return {name: one for name, one in table.items() if name != key} | ({} if value is None else {key: value})


CRUSHER = {
    "rotation": "clockwise",
    "angle": "177 deg",
    "shaft": {"main": {"speed": "290 rpm"}},
    "mechanism": {
        "kind": "crank_rocker",
        "crank_radius": "15 mm",
        "rod_length": "1085 mm",
        "rocker_length": "455 mm",
        "ground_length": "817 mm",
    },
    "masses": {"rod": {"mass": "1200 kg", "along": "500 mm", "inertia": "150 kg*m^2"}},
    "load": {"stone": {"on": "rod", "along": "700 mm", "force": "400 kN"}},
}
FOUR, ONE, V8 = (BY_NAME[name] for name in ("car's four", "stationary diesel", "V8"))
JOURNAL = 0.70 * 82
ACTIVE = {"on": "main", "sense": "active", "torque": "5000 N·m"}
# Each a right machine with one thing wrong, and how what is said of it begins.
CARELESS = {
    "kN/mm as N/m": (FOUR, {"crankshaft.bearing_stiffness": "1e6 N/m"}, "The stiffness of bearing 1 is "),
    "N/mm as kN/mm": (FOUR, {"crankshaft.bearing_stiffness": "1e6 kN/mm"}, "The stiffness of bearing 1 is "),
    "clearance of 1 mm": (FOUR, {"crankshaft.bearing_clearance": "1 mm"}, "The clearance of bearing 1 is 1.742 %"),
    "MPa as GPa": (
        FOUR,
        {"crankshaft.young_modulus": "206e3 GPa", "crankshaft.bearing_stiffness": None},
        "Young's modulus of a shaft is 2.06e+05 GPa",
    ),
    "GPa as MPa": (FOUR, {"crankshaft.young_modulus": "206 MPa", "crankshaft.bearing_stiffness": None}, "Young's"),
    "cm as mm of a pin": (FOUR, {"crankshaft.pin_diameter": "5.33 mm"}, "Its largest load bends pin "),
    "cm as mm of journals": (
        FOUR,
        {"crankshaft.journal_diameter": "5.74 mm"}
        | {f"crankshaft.bearing_{key}": None for key in ("stiffness", "clearance")},
        "The largest load beside it bends the journal at pin ",
    ),
    "weight beside its throw": (
        ONE,
        {"balance.weight.0.angle": "0 deg"},
        "With [balance] the largest shaking force is ",
    ),
    "crank without mass": (
        ONE,
        {"masses.crank.mass": "1e-3 kg", "balance.weight.0.mass": "9 kg"},
        "With [balance] the largest shaking force is ",
    ),
    "ends of a rod": (FOUR, {"masses.rod.along": "93 mm"}, "The rod of 1 has its centre 0.6975 of its length"),
    "percent of a percent": (FOUR, {"cylinder.mechanical_efficiency": "0.85 %"}, "A mechanical_efficiency of 0.0085 "),
    "half a rod": (FOUR, {"bank.line.mechanism.rod_length": "80 mm"}, "Crank radius over rod length of 1 is 0.5"),
    "short rod of a long stroke": (
        BY_NAME["crosshead of λ 0.49"],
        {"bank.line.mechanism.rod_length": "1750 mm"},
        "Crank radius over rod length of 1 is 0.5714",
    ),
    "wide bearings": (FOUR, {"crankshaft.bearing_width": "38 mm"}, "Bearing 1 is 38.00 mm wide"),
    "wide rods": (FOUR, {"crankshaft.rod_bearing_width": "36 mm"}, "Rods 36.00 mm wide take 36.00 mm of pin 1"),
    "wide rods side by side": (
        V8,
        {"crankshaft.rod_bearing_width": "42 mm"},
        "Rods 42.00 mm wide take 84.00 mm of pin 1",
    ),
    "mm as m": (
        FOUR,
        {"crankshaft.bearing_width": None, "crankshaft.bearing.outboard.z": "375.5 mm"},
        "Bearings 5 and outboard are only ",
    ),
    "an uneven order": (
        BY_NAME["three"],
        {"cylinder.firing_order": "1-2-3"},
        "Cylinders fire 120.00 deg to 480.00 deg apart, and the same throws fire evenly in the order 1-3-2: ",
    ),
    "banks of another angle": (
        V8,
        {"bank.L.angle": "-40 deg", "bank.R.angle": "40 deg"},
        "Cylinders fire 80.00 deg to 100.00 deg apart, and with banks 90.00 deg apart in place of 80.00 deg ",
    ),
    "isothermal": (COMPRESSORS[3], {"gas.compression_exponent": 1.0}, "An exponent of 1 is "),
    "a slave's rod": (RADIALS[7], {"bank.S.mechanism.rod_length": "195 mm"}, "The compression ratio of 2S is 4.877, "),
    "a slave's own ratio": (RADIALS[7], {"cylinder.2S.compression_ratio": 9}, "The compression ratio of 2S is 9, "),
    "ways swapped": (
        STROKES[3],
        {
            "load.tool.force": STROKES[3]["load"]["tool"]["force_back"],
            "load.tool.force_back": STROKES[3]["load"]["tool"]["force"],
        },
        "tool acts on the way back alone, with up to ",
    ),
    "travel from the bottom": (
        STROKES[3],
        {
            "load.tool.travel": ["0 mm", "6 mm", "6.2 mm", "131 mm"],
            "load.tool.force": ["1000 kN", "1000 kN", "0 kN", "0 kN"],
        },
        "tool begins at the start of its stroke and acts on 4.6",
    ),
    "travel beyond the stroke": (
        STROKES[3],
        {
            "load.tool.travel": ["0 mm", "1250 mm", "1270 mm", "1310 mm"],
            "load.tool.force": ["0 kN", "0 kN", "1000 kN", "1000 kN"],
        },
        "tool acts nowhere",
    ),
    "cm as mm of a point": (CRUSHER, {"load.stone.along": "7000 mm"}, "A load acts 7000 mm from the first pin"),
    "crank angles from the bottom": (
        STROKES[3],
        {
            "load.tool": {
                "on": "piston",
                "crank_angles": ["0 deg", "1 deg", "24 deg", "25 deg"],
                "force": ["0 kN", "1000 kN", "1000 kN", "0 kN"],
            }
        },
        "tool begins at the start of its stroke and acts on ",
    ),
    "motion from the other end": (SERVOS[4], {"shaft.main.motion.counts_from": "far"}, "tool is first met at "),
    "rest at the blank": (
        SERVOS[4],
        {
            "shaft.main.motion.piece": [
                {"duration": "0.5 s", "to": "88 mm"},
                {"duration": "0.2 s"},
                {"duration": "0.6 s", "to": "100 mm"},
                {"duration": "0.7 s", "to": "0 mm"},
            ]
        },
        "tool is first met at 0.7",
    ),
    "a load that drives": (DRIVES[0], {"load.belt": ACTIVE}, "belt drives the machine with "),
    "a load beyond its engine": (
        {**ONE, "evenness": {"flywheel": "80 kg·m²"}},
        {"load.mill": {"on": "main", "torque": "9000 N·m"}},
        "Loads on the shaft take 9000",
    ),
    "a load beyond an engine whose evenness nobody asks for": (
        ONE,
        {"load.mill": {"on": "main", "torque": "9000 N·m"}},
        "Loads on the shaft take 9000",
    ),
    "a stage that loses all": (
        DRIVES[0],
        {"drive.stage.0.efficiency": "0.95 %"},
        "A stage with an efficiency of 0.0095 ",
    ),
}


@pytest.mark.parametrize("torque", np.geomspace(0.1, 100, 20).tolist())
def test_loads_that_an_engine_turns_are_not_asked_about(torque):
    """This one has a mean torque of some hundred N·m."""
    load = {"mill": {"on": "main", "torque": f"{torque} N·m"}}
    assert asked(ct.Machine(**ONE, evenness={"flywheel": "80 kg·m²"}, load=load)) == ()


def test_of_what_acts_nowhere_to_speak_of_no_way_is_doubted():
    """Its force begins 10 nm before the end of the stroke, where rounding turns the ram about."""
    machine = changed(STROKES[3], {"load.tool.travel": ["0 mm", "129.99999 mm", "130 mm", "131 mm"]})
    machine["load"]["tool"]["force"] = ["0 kN", "0 kN", "1000 kN", "1000 kN"]
    machine["load"]["tool"]["force_back"] = ["0 kN"] * 4
    assert asked(ct.Machine(**machine)) == ()


@pytest.mark.parametrize("size", [1, 0.1, 7.3])
@pytest.mark.parametrize("name", CARELESS)
def test_careless_machines_and_those_similar_are_asked_about(name, size):
    table, changes, head = CARELESS[name]
    (said,) = asked(ct.Machine(**similar(changed(table, changes), size)))
    # Lengths and times are others; what is free of size is the same.
    assert said.startswith(head if size == 1 else head.partition(" ")[0])


def test_check_tells_what_is_unlikely(tmp_path, capsys):
    file = tmp_path / "press.toml"
    lines = ("[mechanism]", 'kind = "slider_crank"', 'stroke = "6 mm"', 'rod_length = "3.000001 mm"')
    file.write_text("\n".join(lines), encoding="utf-8")
    show_check(str(file))
    said = ct.run(
        ct.Machine(mechanism={"kind": "slider_crank", "stroke": "6 mm", "rod_length": "3.000001 mm"})
    ).unlikely
    assert len(said) == 1
    assert f"! {said[0]}" in capsys.readouterr().out
