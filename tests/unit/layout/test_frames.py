"""Mechanisms' axes in machine axes, X right and Y up as seen from the free end; expected by hand."""

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.layout.frames import frame_of, in_machine_axes
from cranktrain.plans.placement import placed

V12 = {
    "shaft": {"main": {"throws": ["0 deg"]}},
    "bank": {
        "L": {
            "angle": "-30 deg",
            "mechanism": {"kind": "slider_crank", "crank_radius": "30 mm", "rod_length": "50 mm", "offset": "10 mm"},
        },
        "R": {"angle": "30 deg", "mechanism": {"kind": "slider_crank", "crank_radius": "30 mm", "rod_length": "50 mm"}},
    },
}
HALF, ROOT = 0.5, np.sqrt(3) / 2


def axes_of(**options):
    """Directions of x and y of both banks."""
    machine = ct.Machine(**(V12 | options))
    found = []
    for place in machine.places:
        frame = frame_of(place, machine.orientation)
        found.append([in_machine_axes(np.array(x), np.array(y), frame) for x, y in ((1.0, 0.0), (0.0, 1.0))])
    return np.array(found)


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        # Bank L lies 30° to the left of Y; y is x turned in the sense of running.
        ({}, [[(-HALF, ROOT), (ROOT, HALF)], [(HALF, ROOT), (ROOT, -HALF)]]),
        # Angles count anticlockwise: the banks change sides.
        ({"rotation": "anticlockwise"}, [[(HALF, ROOT), (-ROOT, HALF)], [(-HALF, ROOT), (-ROOT, -HALF)]]),
        # Astern the metal stays, and y is turned the other way.
        ({"running": "astern"}, [[(-HALF, ROOT), (-ROOT, -HALF)], [(HALF, ROOT), (-ROOT, HALF)]]),
        (
            {"rotation": "anticlockwise", "running": "astern"},
            [[(HALF, ROOT), (ROOT, -HALF)], [(-HALF, ROOT), (ROOT, HALF)]],
        ),
    ],
)
def test_directions_of_both_banks(options, expected):
    np.testing.assert_allclose(axes_of(**options), expected, rtol=0, atol=1e-15)


def test_offset_is_the_same_metal_ahead_and_astern():
    """Offset 10 mm toward +y of a bank 30° left of Y, its pin 40 mm along: the 30-40-50 triangle at φ = 90°."""
    ahead, astern = (ct.Machine(**(V12 | {"running": running})) for running in ("ahead", "astern"))
    for machine, phi in ((ahead, 90.0), (astern, -90.0)):
        pins = placed(machine, machine.places[0], np.array([np.deg2rad(phi)])).positions
        # crank 90° clockwise from the bank's axis: (cos 30°, sin 30°) · 30 mm
        np.testing.assert_allclose(np.ravel(pins["A"]), [0.03 * ROOT, 0.03 * HALF], rtol=0, atol=1e-15)
        # y_A − e = 20 mm, so that the pin is √(50² − 20²) mm along the axis
        along = np.sqrt(50.0**2 - 20.0**2) * 1e-3
        expected = [-HALF * along + ROOT * 0.01, ROOT * along + HALF * 0.01]
        np.testing.assert_allclose(np.ravel(pins["B"]), expected, rtol=0, atol=1e-15)


def test_pumping_unit_stands_as_its_maker_draws_it():
    """Saddle bearing 56 in to the right and 68 in up; the crank at twelve o'clock where the angle is shown as 0."""
    machine = ct.load("pumping_unit_c57")
    pins = placed(machine, machine.places[0], np.array([machine.zero])).positions
    np.testing.assert_allclose(np.ravel(pins["C"]) / 0.0254, [56.0, 68.0], rtol=1e-14)
    np.testing.assert_allclose(np.ravel(pins["A"]) / 0.0254, [0.0, 21.0], rtol=0, atol=1e-13)
