"""The 15 inch cylinder of an engine-compressor calculation sheet: static rod loads of API 618, in pounds of force.

The sheet takes π as 3.14 and leaves the atmosphere on the piston rod out: 21 561 and 20 240 lbf. With π they are 21 572
and 20 250.
"""

import numpy as np
import pytest

import cranktrain as ct

POUND_FORCE = 0.45359237 * 9.80665


@pytest.fixture(scope="module")
def result():
    return ct.run(ct.load("gas_compressor"))


def test_rod_loads():
    """With no pressure on the piston rod, as the sheet has it: p_d A − p_s (A − a), p_d (A − a) − p_s A."""
    result = ct.run(ct.load("gas_compressor").with_({"cylinder.ambient": "0 bar"}))
    area, rod = np.pi / 4 * 15**2, np.pi / 4 * 2.5**2
    compression, tension = (
        peak[0, 0] / POUND_FORCE for peak in (result.largest_rod_compression, result.largest_rod_tension)
    )
    assert compression == pytest.approx(194.7 * area - 74.7 * (area - rod), rel=1e-12)
    assert tension == pytest.approx(194.7 * (area - rod) - 74.7 * area, rel=1e-12)
    assert (round(compression), round(tension)) == (21572, 20250)
    assert [load * 3.14 / np.pi for load in (compression, tension)] == pytest.approx([21561, 20240], abs=1)


def test_capacity_in_closed_form(result):
    part = 1 + 0.15 - 0.15 * (194.7 / 74.7) ** (1 / 1.279)
    assert result.volumetric_efficiency == pytest.approx([part, part], rel=1e-12)


def test_one_such_cylinder_sweeps_8_9_million_cubic_feet_a_day(result):
    """At standard conditions, 14.7 psi and 60 °F: as the machine's page derives it from the sheet's flow."""
    standard = result.swept_volume.sum() * (1000 / 60) * 86400 / 0.3048**3 * (74.7 / 14.7)
    assert standard == pytest.approx(8.9e6, rel=0.02)
