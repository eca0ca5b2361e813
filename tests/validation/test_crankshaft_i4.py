"""The synthetic in-line four: bearing loads by five methods, a sweep of counterweights, torque along the shaft.

The reference prints four decimals of a newton, or of a kilonewton; forces are made here from its masses and gas law.
"""

import csv

import numpy as np
import pytest
from tests.crankshaft_i4 import CASE, SIZES, N, crankshaft, pin_forces, shaft_loads
from tests.reference_case import GOLDEN

from cranktrain.questions.crankshaft.bending.equivalent_stiffness import (
    end_slopes,
    equivalent_stiffness,
    pin_displacement,
)
from cranktrain.questions.crankshaft.bending.torque_along import torque_along
from cranktrain.questions.crankshaft.methods import BEARING_METHODS

METHODS = {method.name: method for method in BEARING_METHODS}
LINEAR = ("split", "three_moment", "five_moment", "frame_rigid", "frame_elastic")
PRINTED = 0.5e-4
"""Half of the last decimal, in newtons and in kilonewtons."""


def rows(name):
    with (GOLDEN / "crankshaft_I4" / name).open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def largest_and_mean(method, degrees, balanced=0.0):
    """Of the bearings' loads on a grid, in kilonewtons."""
    found = METHODS[method].loads(crankshaft(), shaft_loads(degrees, balanced)).load[0]
    size = np.hypot(found[:, 0], found[:, 1]) * 1e-3
    return size.max(axis=-1), size.mean(axis=-1)


@pytest.mark.parametrize("method", LINEAR)
def test_bearing_loads(method):
    table = CASE.selected(method)
    degrees = table.column("crank_angle_deg")
    found = METHODS[method].loads(crankshaft(), shaft_loads(degrees)).load[0]
    peak = np.max(np.abs(found))
    for bearing in range(N + 1):
        for i, axis in enumerate("XY"):
            off = table.deviation(f"Q{bearing + 1}{axis}_N", found[bearing, i])
            assert off <= max(1.1 * PRINTED, 2e-9 * peak)
            assert off <= 2e-8 * peak


@pytest.mark.parametrize("method", LINEAR)
def test_largest_and_mean_loads(method):
    largest, mean = largest_and_mean(method, np.arange(0, 720, 2.0))
    expected = CASE.document["expected_values"]
    np.testing.assert_allclose(largest, expected[f"max_Q_kN.{method}"]["value"], rtol=0, atol=PRINTED + 1e-6)
    np.testing.assert_allclose(mean, expected[f"mean_Q_kN.{method}"]["value"], rtol=0, atol=2e-4)


@pytest.mark.parametrize(
    "row", rows("counterweight_sweep.csv"), ids=lambda row: f"{row['method']}-{row['fraction_balanced']}"
)
def test_counterweights(row):
    largest, mean = largest_and_mean(row["method"], np.arange(0, 720, 4.0), float(row["fraction_balanced"]))
    for name, values in (("max", largest), ("mean", mean)):
        printed = [float(row[f"{name}_Q{bearing + 1}_kN"]) for bearing in range(N + 1)]
        np.testing.assert_allclose(values, printed, rtol=0, atol=PRINTED + 1e-6)


def test_stiffness_of_a_throw():
    found = equivalent_stiffness(crankshaft(), end_slopes(crankshaft()), np.array([1]), np.array([3]))
    for i, direction in enumerate(("in_plane", "out_of_plane")):
        stated = CASE.document["summary"]["EI"][direction]
        wanted = [stated[name] * 1e-6 for name in ("EI_const_moment", "EI_near", "EI_far", "EI_pin_force")]
        # Across the throw the web's torsion counts, of which the reference sums fewer terms.
        np.testing.assert_allclose([values[0, 0, i] for values in found], wanted, rtol=(1e-12, 3e-9)[i])
        moved = pin_displacement(crankshaft(), np.array([1]), np.array([3]))[0, 0, i] * 1e9
        CASE.compare_value(f"throw_deflection_{direction}_um_per_kN", moved)


def test_forces_on_pins():
    table = rows("pin_forces_torque.csv")
    degrees = np.array([float(row["crank_angle_deg"]) for row in table])
    for name, curves in zip("KT", pin_forces(degrees), strict=True):
        for throw in range(N):
            printed = [float(row[f"{name}{throw + 1}_1_N"]) for row in table]
            np.testing.assert_allclose(curves[throw], printed, rtol=0, atol=1.1 * PRINTED)


@pytest.mark.parametrize("method", LINEAR)
def test_torque_along_the_shaft(method):
    """The shaft turns clockwise: torques from X toward Y are against its rotation."""
    table = rows("pin_forces_torque.csv")
    degrees = np.array([float(row["crank_angle_deg"]) for row in table])
    shaft, loads = crankshaft(), shaft_loads(degrees)
    bearings = METHODS[method].loads(shaft, loads)
    found = torque_along(shaft, loads, bearings.load)
    for throw in range(N):
        printed = [float(row[f"M_after_throw{throw + 1}_Nm"]) for row in table]
        np.testing.assert_allclose(-found.begin[0, 2 * throw + 2], printed, rtol=0, atol=6e-6)
    # M_pin = M_main + R_TL r, with one throw between bearings: R_TL is the reaction along T of the split shaft.
    if method == "split":
        _normal, tangential = pin_forces(degrees)
        half = tangential * SIZES["crankpin_middle"] / SIZES["span"]
        for throw in range(N):
            pin = -found.begin[0, 2 * throw] + half[throw] * 0.039
            np.testing.assert_allclose(-found.begin[0, 2 * throw + 1], pin, rtol=0, atol=1e-9)
    np.testing.assert_allclose(found.end, found.begin, rtol=0, atol=1e-9)
