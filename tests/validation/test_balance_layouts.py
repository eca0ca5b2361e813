"""Shaking forces and couples by order of 29 layouts and of twelve arrangements with exact rods.

Sources: tests/golden/theory/balance_layouts.json and balance_orders.csv (amplitudes in units m R ω² A_n, twelve
digits), tests/golden/balance_orders (a 40-digit multibody solver, λ = 5/17). All count as this code does: angles in the
sense of rotation, α = φ + θ − γ, x along the axis γ = 0, couples Σ (z − z̄) F. The case's throws stand anticlockwise
and its crank turns that way, which is the same. Its torque is what must be applied, minus the machine's.
"""

import csv
import json
from pathlib import Path

import numpy as np
import pytest
from tests.layouts_by_order import Cylinders, inertia_roll, reciprocating_vectors
from tests.reference_case import ReferenceCase
from tests.vectors_by_order import turned_vectors

from cranktrain.numerics.harmonics import curve, harmonics
from cranktrain.numerics.plane_vectors import curve_vectors
from cranktrain.questions.balance.rotating_weights import on_crank, weight_vectors
from cranktrain.questions.balance.unit_shaking import shaking
from cranktrain.questions.torque.rod_harmonics import acceleration_harmonics

GOLDEN = Path(__file__).parents[1] / "golden/theory"
LAYOUTS = json.loads((GOLDEN / "balance_layouts.json").read_text(encoding="utf-8"))["layouts"]
with (GOLDEN / "balance_orders.csv").open(encoding="utf-8", newline="") as table:
    ROWS = list(csv.DictReader(table))
CASE = ReferenceCase.load("balance_orders")
ARRANGEMENTS = CASE.machine["arrangements"]
RATIO = 0.25
PRINTED = 1e-11


def layout(name):
    given = LAYOUTS[name]
    throw, axis = np.radians(given["throw_deg"]), np.radians(given["axis_deg"])
    one = np.ones_like(throw)
    return Cylinders(throw, axis, one, one, RATIO * one), np.array(given["z_in_spacing"])


def test_all_layouts_are_in_the_table():
    assert {row["layout"] for row in ROWS} == set(LAYOUTS)
    assert len(LAYOUTS) == 29


@pytest.mark.parametrize("name", LAYOUTS)
def test_every_order_of_a_layout(name):
    cylinders, position = layout(name)
    found = shaking(reciprocating_vectors(cylinders, 6), position)
    unit = acceleration_harmonics(RATIO, 6)
    for row in (row for row in ROWS if row["layout"] == name):
        order = int(row["order"])
        for vectors, what in ((found.force, "F"), (found.couple, "C")):
            for part, sense in ((vectors.forward, "forward"), (vectors.backward, "reverse")):
                expected = float(row[f"{what}_{sense}"])
                assert abs(abs(part[order] / unit[order]) - expected) <= PRINTED, (order, what, sense)


@pytest.mark.parametrize("name", LAYOUTS)
def test_rotating_masses_of_a_layout(name):
    # one at each rod's big end
    cylinders, position = layout(name)
    row = next(row for row in ROWS if row["layout"] == name)
    vectors = weight_vectors(on_crank(np.exp(1j * cylinders.throw_angle), position), np.array([1.0]))
    found = shaking(vectors, position)
    assert abs(abs(found.force.forward[0]) - float(row["rotating_force"])) <= PRINTED
    assert abs(abs(found.couple.forward[0]) - float(row["rotating_couple"])) <= PRINTED
    assert found.force.backward[0] == found.couple.backward[0] == 0


@pytest.mark.parametrize("name", LAYOUTS)
def test_orders_of_the_forces_curves_are_the_closed_form(name):
    cylinders, position = layout(name)
    phi = np.arange(144) * (2 * np.pi / 144)
    own = (phi + (cylinders.throw_angle - cylinders.axis_angle)[:, np.newaxis])[..., np.newaxis]
    force = np.sum(acceleration_harmonics(RATIO, 60) * np.cos(np.arange(61) * own), axis=-1)
    own_axes = curve_vectors(force, np.zeros_like(force), 6)
    by_curves = shaking(turned_vectors(own_axes, cylinders.axis_angle), position, mid_plane=0.3)
    closed = shaking(reciprocating_vectors(cylinders, 6), position, mid_plane=0.3)
    for found, expected in ((by_curves.force, closed.force), (by_curves.couple, closed.couple)):
        np.testing.assert_allclose(found.forward, expected.forward, atol=2e-14)
        np.testing.assert_allclose(found.backward, expected.backward, atol=2e-14)


def arrangement(name):
    given = ARRANGEMENTS[name]
    throw = np.radians([cylinder["throw_angle_deg"] for cylinder in given])
    axis = np.radians([cylinder["bank_angle_deg"] for cylinder in given])
    one = np.ones_like(throw)
    ratio = CASE.machine["crank_radius_m"] / CASE.machine["rod_length_m"]
    return Cylinders(throw, axis, one, one, ratio * one), np.array([cylinder["station_pitch"] for cylinder in given])


@pytest.mark.parametrize("name", ARRANGEMENTS)
def test_exact_orders_of_an_arrangement(name):
    cylinders, position = arrangement(name)
    found = shaking(reciprocating_vectors(cylinders, 8), position, np.mean(position))
    roll = inertia_roll(cylinders, 8)
    columns = {"Tdrive_cos": roll.cosine, "Tdrive_sin": roll.sine}
    for vectors, what in ((found.force, "F"), (found.couple, "M")):
        _, forward, backward = vectors
        columns[f"{what}x_cos"] = (forward + backward).real
        columns[f"{what}x_sin"] = -(forward - backward).imag
        columns[f"{what}y_cos"] = (forward + backward).imag
        columns[f"{what}y_sin"] = (forward - backward).real
    case = CASE.selected(name)
    orders = case.column("order").astype(int)
    # the torque that must be applied is minus the machine's, and so is what rolls the frame
    case.compare({column: values[orders] for column, values in columns.items()})


def test_single_cylinder():
    ratio = CASE.machine["rod_ratio"]
    found = acceleration_harmonics(ratio, 10)
    for order in (1, 2, 4, 6, 8, 10):
        CASE.compare_value(f"single_cylinder_force_order_{order}", found[order])


def test_roll_is_minus_the_torque_of_the_masses():
    # against the derivative of their kinetic energy, −½ m d(x′²)/dφ on the shaft, so its opposite on the frame
    cylinders, _ = layout("I3 120 (1-3-2)")
    phi = np.arange(256) * (2 * np.pi / 256)
    own = phi + cylinders.throw_angle[:, np.newaxis]
    slope = np.sin(own) * (1 + RATIO * np.cos(own) / np.sqrt(1 - (RATIO * np.sin(own)) ** 2))
    energy = harmonics(0.5 * np.sum(slope**2, axis=0))
    derivative = energy._replace(cosine=energy.order * energy.sine, sine=-energy.order * energy.cosine)
    expected = curve(derivative, phi)
    np.testing.assert_allclose(curve(inertia_roll(cylinders, 40), phi), expected, atol=1e-13)
