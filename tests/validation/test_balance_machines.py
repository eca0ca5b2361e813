"""Balance of whole machines, through machine files: 29 layouts and twelve arrangements, order by order.

Sources as in test_balance_layouts: tests/golden/theory/balance_layouts.json and balance_orders.csv (amplitudes in units
m R ω² A_n, twelve digits), tests/golden/balance_orders (a 40-digit multibody solver, λ = 5/17). Rods are massless, so
the piston is all that reciprocates. φ_theory = φ + γ_1 − θ_1; their x is Y, their y lies in the sense of rotation.
"""

import csv
import json
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from tests.reference_case import ReferenceCase

import cranktrain as ct
from cranktrain.numerics.harmonics import delayed, harmonics
from cranktrain.questions.torque.rod_harmonics import acceleration_harmonics

GOLDEN = Path(__file__).parents[1] / "golden/theory"
LAYOUTS = json.loads((GOLDEN / "balance_layouts.json").read_text(encoding="utf-8"))["layouts"]
with (GOLDEN / "balance_orders.csv").open(encoding="utf-8", newline="") as table:
    ROWS = list(csv.DictReader(table))
CASE = ReferenceCase.load("balance_orders")
ARRANGEMENTS = CASE.machine["arrangements"]
RADIUS, SPEED, PITCH = 0.05, 100.0, 0.1
CLOSE = 1e-10
PISTON = {"piston": {"mass": "1 kg"}}
BIG_END = {"rod": {"mass": "1 kg", "along": "0 mm", "inertia": "0 kg*m^2"}}


def machine(throw_degrees, axis_degrees, z, rod_length, masses=PISTON, **fields):
    """A machine file's tables for cylinders of which each has its throw's angle, its axis, and its place."""
    cylinders = list(zip(np.round(z, 9), throw_degrees, axis_degrees, strict=True))
    throws = list(dict.fromkeys((along, angle) for along, angle, _axis in sorted(cylinders)))
    first = throws[0][1]
    main = {"throws": [f"{angle - first!r} deg" for _along, angle in throws], "speed": f"{SPEED!r} rad/s"}
    if len(throws) > 1:
        main["spacing"] = [f"{float(after[0] - before[0]) * PITCH!r} m" for before, after in pairwise(throws)]
    banks = {}
    for along, angle, axis in cylinders:
        bank = banks.setdefault(
            f"B{list(dict.fromkeys(axis_degrees)).index(axis)}",
            {
                "angle": f"{axis!r} deg",
                "mechanism": {"kind": "slider_crank", "crank_radius": f"{RADIUS} m", "rod_length": f"{rod_length!r} m"},
                "throws": [],
            },
        )
        bank["throws"].append(throws.index((along, angle)) + 1)
    # The angle at φ = 0 of throw 1, which stands along the first bank's axis.
    return ct.Machine(shaft={"main": main}, bank=banks, masses=masses, **fields), axis_degrees[0] - first


def layout(name, **fields):
    given = LAYOUTS[name]
    return ct.run(machine(given["throw_deg"], given["axis_deg"], given["z_in_spacing"], 4 * RADIUS, **fields)[0])


@pytest.mark.parametrize("name", LAYOUTS)
def test_every_order_of_a_layout(name):
    found = layout(name)
    unit = RADIUS * SPEED**2 * np.abs(acceleration_harmonics(0.25, 6))
    # Couples about the theory's middle: where a force is left, they depend on it.
    z = np.unique(LAYOUTS[name]["z_in_spacing"])
    assert (z[0] + z[-1]) / 2 == 0
    for row in (row for row in ROWS if row["layout"] == name):
        order = int(row["order"])
        for what, letter, size in (("force", "F", unit[order]), ("couple", "C", unit[order] * PITCH)):
            for sense, column in (("forward", "forward"), ("backward", "reverse")):
                amplitude = getattr(found, f"shaking_{what}_{sense}")[0, order - 1] / size
                assert amplitude == pytest.approx(float(row[f"{letter}_{column}"]), abs=CLOSE), (order, what, sense)
    assert all(np.all(check.passed) for check in found.checks)


@pytest.mark.parametrize("name", LAYOUTS)
def test_rotating_masses_of_a_layout_and_their_counterweights(name):
    found = layout(name, masses=BIG_END, balance={"counterweights": "rotating"})
    row = next(row for row in ROWS if row["layout"] == name)
    unit = RADIUS * SPEED**2
    force, couple = found.shaking_force_forward / unit, found.shaking_couple_forward / (unit * PITCH)
    assert force[0, 0] == pytest.approx(float(row["rotating_force"]), abs=CLOSE)
    assert couple[0, 0] == pytest.approx(float(row["rotating_couple"]), abs=CLOSE)
    for left in (force[1], couple[1], force[:, 1:], found.shaking_force_backward / unit):
        np.testing.assert_allclose(left, 0, atol=CLOSE)
    # one at each pin, opposite it, as heavy as the big ends there
    assert np.sum(found.balance_weight_moment) == pytest.approx(RADIUS * len(LAYOUTS[name]["throw_deg"]))


SENSES = [("clockwise", "ahead"), ("anticlockwise", "ahead"), ("clockwise", "astern")]


@pytest.mark.parametrize(("rotation", "running"), SENSES)
@pytest.mark.parametrize("name", ARRANGEMENTS)
def test_exact_orders_of_an_arrangement(name, rotation, running):
    given = ARRANGEMENTS[name]
    # Astern all angles count the other way: a machine of which they are the opposite does the same.
    turn = 1 if running == "ahead" else -1
    throw = [turn * cylinder["throw_angle_deg"] for cylinder in given]
    axis = [turn * cylinder["bank_angle_deg"] for cylinder in given]
    z = [cylinder["station_pitch"] for cylinder in given]
    of, ahead = machine(throw, axis, z, CASE.machine["rod_length_m"], rotation=rotation, running=running)
    found = ct.run(of)
    right = turn if rotation == "clockwise" else -turn
    unit = RADIUS * SPEED**2
    curves = {
        "Fx": found.shaking_force_y[0] / unit,
        "Fy": right * found.shaking_force_x[0] / unit,
        "Mx": found.shaking_couple_y[0] / (unit * PITCH),
        "My": right * found.shaking_couple_x[0] / (unit * PITCH),
        "Tdrive": found.driving_torque / (unit * RADIUS),
    }
    case = CASE.selected(name)
    orders = case.column("order").astype(int)
    columns = {}
    for what, curve in curves.items():
        one = delayed(harmonics(curve), turn * np.radians(ahead))
        columns |= {f"{what}_cos": one.cosine[orders], f"{what}_sin": one.sine[orders]}
    case.compare(columns)
    # masses that move through the shaft's centre keep no moment of momentum: the frame rolls by all that drives
    np.testing.assert_allclose(found.rolling_moment[0], found.driving_torque, atol=1e-11 * unit)
