"""The synthetic in-line four as a machine file: from masses and pressures through the joints to its main bearings.

The case's `bearing_loads.csv` has all five methods; forces come here from the reactions of the machine's joints, and
its pressures from a table of the case's gas law in whole degrees, at which alone a table is exact.
"""

import csv

import numpy as np
import pytest
from tests.crankshaft_i4 import CASE, CENTRIFUGAL, MACHINE, RADIUS, SPEED, pin_forces, pressure
from tests.reference_case import GOLDEN

import cranktrain as ct
from cranktrain.questions.wear.rays import wear_sums

AMBIENT = 101325.0 - 1e6 * MACHINE["gas"]["ambient_MPa"]
"""Forces count from the standard atmosphere, the case's from its own ambient. [Pa]"""
DEGREES = np.arange(720.0)


def mm(value):
    return f"{value!r} mm"


def in_line_four(**more):
    """Pin and rods' rotating masses on the pins, webs as weights of each throw, firing 1-2-4-3."""
    table = "\n".join(
        f"{at:g};{p:.12g}" for at, p in zip(DEGREES, pressure((DEGREES + 360) % 720) + AMBIENT, strict=True)
    )
    web = 2 * CENTRIFUGAL["web"][0] / SPEED**2
    geometry = MACHINE["throw_geometry_mm"]
    return ct.Machine(
        shaft={
            "main": {
                "throws": [f"{angle:g} deg" for angle in MACHINE["throw_angles_deg"]],
                "spacing": mm(geometry["span"]),
                "speed": f"{MACHINE['speed_rpm']:g} rpm",
            }
        },
        bank={
            "A": {
                "mechanism": {
                    "kind": "slider_crank",
                    "crank_radius": mm(MACHINE["crank_radius_mm"]),
                    "rod_length": mm(MACHINE["rod_length_mm"]),
                }
            }
        },
        cylinder={
            "bore": mm(MACHINE["bore_mm"]),
            "compression_ratio": MACHINE["gas"]["compression_ratio"],
            "cycle": "four-stroke",
            "firing_order": "1 2 4 3",
        },
        gas={"kind": "indicator", "file": "law.csv", "text": f"angle [deg];pressure [Pa] absolute\n{table}"},
        masses={
            "piston": {"mass": f"{MACHINE['piston_mass_kg']!r} kg"},
            "rod": {
                "big_end": f"{MACHINE['rod_mass_at_crankpin_kg'] + MACHINE['crankpin_mass_kg']!r} kg",
                "small_end": f"{MACHINE['rod_mass_at_piston_kg']!r} kg",
            },
        },
        balance={
            "weight": [
                {"mass": f"{web / RADIUS!r} kg", "radius": f"{RADIUS!r} m", "angle": f"{angle:g} deg", "throw": n + 1}
                for n, angle in enumerate(MACHINE["throw_angles_deg"])
            ]
        },
        crankshaft={
            "journal_diameter": mm(geometry["main_diameter"]),
            "pin_diameter": mm(geometry["crankpin_diameter"]),
            "pin_length": mm(geometry["crankpin_length"]),
            "web_thickness": mm(geometry["web_thickness"]),
            "web_width": mm(geometry["web_width"]),
            "web_length": "whole",
            "bearing_stiffness": f"{MACHINE['support_stiffness_N_per_mm']!r} N/mm",
            **more,
        },
    )


@pytest.fixture(scope="module")
def four():
    return ct.run(in_line_four())


@pytest.mark.parametrize("method", ["split", "three_moment", "five_moment", "frame_rigid", "frame_elastic"])
def test_bearing_loads(four, method):
    table = CASE.selected(method)
    at = table.column("crank_angle_deg").astype(int)
    row = four.labels["bearing_method"].index(method)
    loads = {"X": four.main_bearing_load_x[row], "Y": four.main_bearing_load_y[row]}
    peak = max(np.max(np.abs(own)) for own in loads.values())
    for bearing in range(5):
        for axis, own in loads.items():
            off = np.max(np.abs(own[bearing, at] - table.column(f"Q{bearing + 1}{axis}_N")))
            assert off <= 2e-8 * peak + 1e-4


def test_bearings_balance(four):
    (check,) = (check for check in four.checks if check.name == "bearing_loads")
    assert np.all(check.passed)


def column(name, file):
    with (GOLDEN / "crankshaft_I4" / file).open(encoding="utf-8", newline="") as table:
        return np.array([float(row[name]) for row in csv.DictReader(table)])


def without_the_pin(radial):
    """The reference's crank pin load has the rod's rotating mass; here the pin's own hangs on the rod, too."""
    return radial + CENTRIFUGAL["pin"]


@pytest.mark.parametrize("throw", range(4))
def test_crank_pin_loads(four, throw):
    """By the angle of each cylinder, which is 360° where it fires; printed to a thousandth of a newton."""
    fired = MACHINE["firing_dead_centre_shaft_angle_deg"][throw][0]
    at = (column("cylinder_crank_angle_deg", "crankpin_polar.csv").astype(int) + fired - 360) % 720
    radial = without_the_pin(four.crankpin_load_radial[throw, at])
    tangential = four.crankpin_load_tangential[throw, at]
    np.testing.assert_allclose(radial, column("R_K_N", "crankpin_polar.csv"), rtol=0, atol=6e-4)
    np.testing.assert_allclose(tangential, column("T_N", "crankpin_polar.csv"), rtol=0, atol=6e-4)
    spot = np.degrees(np.arctan2(-tangential, radial)) - column("loaded_spot_angle_deg", "crankpin_polar.csv")
    np.testing.assert_allclose((spot + 180) % 360 - 180, 0.0, atol=6e-4)


def test_wear_of_a_crank_pin_by_the_reference_s_own_table(four):
    """The rule of ±60° on the 72 loads of the table and its 24 rays."""
    fired = MACHINE["firing_dead_centre_shaft_angle_deg"][0][0]
    at = (np.arange(0, 720, 10) + fired - 360) % 720
    radial, tangential = without_the_pin(four.crankpin_load_radial[0, at]), four.crankpin_load_tangential[0, at]
    rays = np.radians(column("ray_deg", "crankpin_wear.csv"))
    sums = wear_sums(np.arctan2(-tangential, radial), np.hypot(radial, tangential), rays)
    np.testing.assert_allclose(sums, column("sum_R_N", "crankpin_wear.csv"), rtol=0, atol=0.05)


def test_wear_of_a_crank_pin_over_the_cycle(four):
    """72,000 loads of the reference's laws put on their rays one by one; between degrees a law is not its table."""
    degrees = np.arange(0.005, 720, 0.01)
    radial, tangential = (own[0] for own in pin_forces(degrees))
    radial = radial - CENTRIFUGAL["rod"] - CENTRIFUGAL["pin"]
    spot, size = np.degrees(np.arctan2(-tangential, radial)), np.hypot(radial, tangential)
    wear = [np.mean(np.where(np.abs((spot - ray + 180) % 360 - 180) <= 60, size, 0.0)) for ray in range(0, 360, 10)]
    np.testing.assert_allclose(four.crankpin_wear[0], wear, rtol=0, atol=1e-3 * np.mean(size))
    assert four.mean_crankpin_load[0] == pytest.approx(np.mean(size), rel=1e-4)
    least = np.flatnonzero(np.array(wear) <= np.min(wear) + 1e-3 * np.mean(size))
    assert np.degrees(four.crankpin_oil_hole[0]) == pytest.approx(5.0 * (least[0] + least[-1]))


def test_bearing_loads_in_axes_of_the_shaft(four):
    """Throw 1 points up at 0 and turns clockwise; the reference's loads turned by hand."""
    for row, method in enumerate(four.labels["bearing_method"]):
        table = CASE.selected(method)
        at = table.column("crank_angle_deg").astype(int)
        cos, sin = np.cos(np.radians(at)), np.sin(np.radians(at))
        for bearing in range(5):
            x, y = (table.column(f"Q{bearing + 1}{axis}_N") for axis in "XY")
            peak = np.max(np.hypot(x, y))
            for found, wanted in (
                (four.journal_load_along, x * sin + y * cos),
                (four.journal_load_across, x * cos - y * sin),
            ):
                np.testing.assert_allclose(found[row, bearing, at], wanted, rtol=0, atol=1e-6 * peak)


def test_wear_of_main_journals_against_the_curves(four):
    """The rule on the loads at each degree: what is between two of them counts within a step."""
    rays = np.arange(0, 360, 10)
    cases = (
        (four.journal_load_along, four.journal_load_across, four.journal_wear),
        (four.main_bearing_load_y, four.main_bearing_load_x, four.bearing_wear),
    )
    for first, second, found in cases:
        spot, size = np.degrees(np.arctan2(second, first)), np.hypot(first, second)
        wear = np.stack([np.mean(size * (np.abs((spot - r + 180) % 360 - 180) <= 60), axis=-1) for r in rays], axis=-1)
        np.testing.assert_allclose(found, wear, rtol=0, atol=0.02 * np.max(size))


def test_torque_along_the_shaft(four):
    degrees = column("crank_angle_deg", "pin_forces_torque.csv").astype(int)
    for throw in range(4):
        printed = column(f"M_after_throw{throw + 1}_Nm", "pin_forces_torque.csv")
        own = four.section_torque[:, four.labels["section"].index(f"journal {throw + 2}")]
        np.testing.assert_allclose(own[:, degrees], np.broadcast_to(printed, (5, printed.size)), rtol=0, atol=2e-5)
    # With one throw between bearings of equal distance the split shaft's pin has half of its throw's torque more.
    split = four.section_torque[four.labels["bearing_method"].index("split")]
    np.testing.assert_allclose(split[1::2], (split[:-2:2] + split[2::2]) / 2, rtol=0, atol=1e-9)


def test_how_stiff_a_throw_bends(four):
    """By equal moments, by one at an end, by a force in mid-pin; in its plane and across: as the case prints them."""
    printed = {"constant_moment": (7.77, 9.77), "end_moment": (7.99, 9.06), "pin_force": (8.56, 5.14)}
    for name, wanted in printed.items():
        found = getattr(four, f"bending_by_{name}")
        np.testing.assert_allclose(found, np.broadcast_to(1e3 * np.array(wanted), found.shape), rtol=0, atol=5.0)
