"""Where loads of pins and guides change sides: roots of closed forms, and what people found."""

import tomllib

import mpmath
import numpy as np
import pytest

import cranktrain as ct

PISTON = """
[shaft.main]
speed = "{speed}"
[mechanism]
kind = "slider_crank"
crank_radius = "100 mm"
rod_length = "{rod}"
[masses.piston]
mass = "2 kg"
"""


def changes(result, joint):
    place = [name.partition(".")[2] for name in result.labels["joint"]].index(joint)
    angles = result.side_change_at[place]
    assert result.side_changes[place] == np.sum(np.isfinite(angles))
    return angles[np.isfinite(angles)]


def run(rod="200 mm", speed="600 rpm", more="", **options):
    return ct.run(ct.Machine(**tomllib.loads(PISTON.format(rod=rod, speed=speed) + more)), **options)


@pytest.mark.parametrize("step", [1.0, 0.1, 7.2])
def test_inertia_alone_changes_sides_where_the_piston_is_not_sped_up(step):
    """R 100, L 200 mm: the second derivative is 0 at 67.7000 (a root in 40 digits); across, at the dead centres too."""
    result = run(step_degrees=step)
    with mpmath.workdps(40):
        place = lambda phi: mpmath.cos(phi) + 2 * mpmath.sqrt(1 - (mpmath.sin(phi) / 2) ** 2)  # noqa: E731 - differentiated
        root = float(mpmath.degrees(mpmath.findroot(lambda phi: mpmath.diff(place, phi, 2), 1.18)))
    assert root == pytest.approx(67.7000, abs=1e-4)
    for joint in ("wrist_pin", "crank_pin"):
        assert changes(result, joint) == pytest.approx([root, 360 - root], abs=1e-9)
    assert changes(result, "guide") == pytest.approx([0, root, 180, 360 - root], abs=1e-9)


def test_a_pin_that_is_pushed_all_round_changes_no_side():
    """2 kN toward the shaft are more than the piston's inertia, 2 kg · 0.1 m · (2π)² · 1.5 = 11.8 N."""
    result = run(speed="60 rpm", more='[load.gas]\non = "piston"\nforce = "-2 kN"\nsense = "active"\n')
    assert changes(result, "wrist_pin").size == 0
    assert changes(result, "guide") == pytest.approx([0, 180], abs=1e-9)


def test_where_a_load_is_nothing_it_is_on_neither_side():
    """Gas alone of a four-stroke at ambient pressure while it changes: compression and tension leave its 360° out."""
    more = """
[cylinder]
bore = "80 mm"
compression_ratio = 9
cycle = "four-stroke"
[gas]
kind = "otto"
start_pressure = "101.325 kPa"
compression_exponent = 1.3
expansion_exponent = 1.3
pressure_ratio = 3
inlet_pressure = "101.325 kPa"
exhaust_pressure = "101.325 kPa"
[rod_load]
compression = "50 kN"
"""
    result = run(more=more)
    gas = result.labels["rod_load_place"].index("gas")
    assert result.compression_arc[gas, 0] == pytest.approx(360, abs=1e-9)
    assert result.tension_arc[gas, 0] == pytest.approx(0, abs=1e-9)
