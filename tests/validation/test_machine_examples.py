"""Presses, pump, crusher, shaper and locomotive against what their sources, or closed forms of their numbers, give.

* Jaw crusher: toggle swings 4.40°, its jaw end travels 34.9 mm, transmission angle 41.8 to 45.1°: a second code.
* Eccentric press: 1000 kN at 6 mm before the bottom: nominal angle 23.7°, torque 28.5 kN·m without friction.
* 12-P-160: 772 gallons a minute with 7 1/4 in liners at 120 strokes a minute (a public drilling database's pump table),
  132 klbf of rod load at 3200 psi; ripple of the flow 25.3 % at a ratio of 0.2, 23.1 % at 1/6, 14.03 % with an
  infinite rod: sums of three half-rectified curves.
* Great Northern: full-gear cut-off 87.9 % of the stroke without rod effect, 89.2 and 86.5 % at the two ends.
* Shaper: ψ = 2 asin(R/g), the lever's end travels 2 r sin(ψ/2) across.
* Toggle press: its ram by crossing circles in complex numbers.
"""

import numpy as np
import pytest
from tests.validation.test_examples import INCH, example, printed, run

import cranktrain as ct


def test_jaw_crusher():
    result = run("jaw_crusher")
    assert np.degrees(result.swing[0]) == printed("4.40")
    assert np.degrees(result.smallest_transmission_angle[0]) == printed("41.8")
    assert np.degrees(result.largest_transmission_angle[0]) == printed("45.1")
    x, y = result.point_x[0], result.point_y[0]
    apart = np.hypot(x[:, np.newaxis] - x, y[:, np.newaxis] - y)
    assert np.max(apart) * 1e3 == printed("34.9")


def test_eccentric_press():
    result = ct.run(ct.Machine(**example("eccentric_press")), step_degrees=0.05)
    before = result.crank_angle < 180
    at = int(np.argmin(np.abs(result.piston_displacement[0, before] - 6e-3)))
    assert result.crank_angle[at] == printed("23.7")
    assert 1000e3 * result.piston_velocity_coefficient[0, at] / 1e3 == printed("28.5")


def ripple(**rod) -> float:
    data = example("mud_pump_12p160")
    mechanism = {"kind": "slider_crank", "stroke": "12 in", **rod}
    data["bank"]["pump"]["mechanism"] = mechanism
    result = ct.run(ct.Machine(**data), step_degrees=0.1)
    flow = np.sum(np.maximum(-result.piston_velocity, 0.0), axis=0)
    return 100 * float(np.ptp(flow) / np.mean(flow))


def test_mud_pump():
    result = run("mud_pump_12p160")
    gallons = float(result.displacement) * 120 / 3.785411784e-3
    assert round(gallons) == 772
    assert np.pi / 4 * 7.25**2 * 3200 / 1e3 == pytest.approx(132.1, abs=0.1)
    assert ripple(rod_length="30 in") == printed("25.3")
    assert ripple(rod_length="36 in") == printed("23.1")
    assert ripple(rod_length="1e6 in") == printed("14.03")


def test_great_northern_cut_off():
    result = ct.run(ct.Machine(**example("great_northern")), step_degrees=0.05)
    lap = 1.25
    valve = result.slider_position[0] / INCH
    travel = result.piston_displacement[0] / float(result.stroke[0])
    closes = np.flatnonzero((np.abs(valve) > lap) & (np.abs(np.roll(valve, -1)) <= lap))
    head, crank = travel[closes]
    assert 100 * head == printed("89.2")
    assert 100 * (1 - crank) == printed("86.5")
    assert 50 * (1 - np.cos(np.radians(result.crank_angle[closes[0]]))) == pytest.approx(87.9, abs=0.06)
    assert np.ptp(valve) == pytest.approx(7.0, abs=1e-4)


def test_shaper():
    result = run("shaper")
    swing = 2 * np.arcsin(0.4)
    assert result.stroke[0] == pytest.approx(2 * 0.5 * np.sin(swing / 2), rel=1e-9)
    forward = (result.bottom_dead_centre[0] - result.top_dead_centre[0]) % 360
    slow = max(forward, 360 - forward)
    assert slow / (360 - slow) == pytest.approx((np.pi + swing) / (np.pi - swing), rel=1e-9)
    lever = result.link_angle[result.labels["link"].index("1.lever")]
    assert np.ptp(lever) == pytest.approx(swing, abs=1e-3)


def test_toggle_press():
    result = run("toggle_press")
    pin = 0.05 * np.exp(1j * np.radians(result.crank_angle))
    pivot = 0.4 + 0.25j
    apart = pivot - pin
    along = (np.abs(apart) ** 2 + 0.32**2 - 0.25**2) / (2 * np.abs(apart))
    knee = pin + apart / np.abs(apart) * (along - 1j * np.sqrt(0.32**2 - along**2))
    ram = knee.imag - np.sqrt(0.25**2 - (knee.real - 0.4) ** 2)
    below = result.labels["point"].index("1.ram.pin")
    np.testing.assert_allclose(result.point_y[below], ram, atol=1e-14)
    np.testing.assert_allclose(result.point_x[below], 0.4, atol=1e-15)
    assert result.stroke[0] == pytest.approx(np.ptp(ram), rel=1e-3)
