"""The synthetic in-line four as a machine file: from masses and pressures through the joints to its main bearings.

The case's `bearing_loads.csv` has all five methods; forces come here from the reactions of the machine's joints, and
its pressures from a table of the case's gas law in whole degrees, at which alone a table is exact.
"""

import numpy as np
import pytest
from tests.crankshaft_i4 import CASE, CENTRIFUGAL, MACHINE, RADIUS, SPEED, pressure

import cranktrain as ct

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
