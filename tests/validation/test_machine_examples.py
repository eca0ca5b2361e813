"""Presses, pump, crusher, shaper and locomotive against what their sources, or closed forms of their numbers, give.

* Jaw crusher: toggle swings 4.40°, its jaw end travels 34.9 mm, transmission angle 41.8 to 45.1°: a second code.
* Eccentric press: 1000 kN at 6 mm before the bottom: nominal angle 23.7°, torque 28.5 kN·m without friction.
* 12-P-160: 772 gallons a minute with 7 1/4 in liners at 120 strokes a minute (a public drilling database's pump table),
  132 klbf of rod load at 3200 psi; ripple of the flow 25.3 % at a ratio of 0.2, 23.1 % at 1/6, 14.03 % with an
  infinite rod: sums of three half-rectified curves.
* Great Northern: full-gear cut-off 87.9 % of the stroke without rod effect, 89.2 and 86.5 % at the two ends.
* LMS Class 5: tractive effort 25 455 lbf from bore, stroke, 225 psi and drivers of 72 in at 0.85 (Wikipedia); the
  motion's travel 6 1/2, lap 1 1/2 and lead 1/4 in as it was laid out, by the lever's 5/40 of the crosshead's way.
* Traction engine: 57.6 psi for 40 ihp at 180 rpm; travel 2 1/2, lap 1/2 and lead 1/16 in; Zeuner's formula for the lead
  of Stephenson's motion, r (sin δ + (c² − u²)/(c l) cos δ).
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
    cylinder, drive = (result.labels["piston"].index(name) for name in ("1cylinder", "1valve"))
    valve = (result.piston_displacement[drive] - result.stroke[drive] / 2) / INCH
    travel = result.piston_displacement[cylinder] / float(result.stroke[cylinder])
    closes = np.flatnonzero((np.abs(valve) > lap) & (np.abs(np.roll(valve, -1)) <= lap))
    head, crank = travel[closes]
    assert 100 * head == printed("89.2")
    assert 100 * (1 - crank) == printed("86.5")
    assert 50 * (1 - np.cos(np.radians(result.crank_angle[closes[0]]))) == pytest.approx(87.9, abs=0.06)
    assert np.ptp(valve) == pytest.approx(7.0, abs=1e-4)


def in_notch(name: str, notch: float) -> tuple[float, float]:
    """Travel of the valve, and half of what it moves from one dead centre of the crank to the other. [in]"""
    data = example(name)
    data["bank"]["valve"]["mechanism"]["notch"] = notch
    result = ct.run(ct.Machine(**data), quantities=["stroke", "piston_displacement"])
    valve = result.labels["piston"].index("1valve")
    moved = result.piston_displacement[valve]
    return float(result.stroke[valve]) / INCH, float(moved[180] - moved[0]) / 2 / INCH


def test_lms_class_5():
    result = ct.run(ct.Machine(**example("lms_class5")), quantities=["swept_volume"])
    assert result.labels["chamber"] == ("1cylinder.head", "1cylinder.crank", "2cylinder.head", "2cylinder.crank")
    area_and_stroke = float(result.swept_volume[0]) / INCH**3 * 4 / np.pi
    assert 0.85 * 225 * area_and_stroke / 72 == printed("25455")
    assert in_notch("lms_class5", 1)[0] == pytest.approx(6.5, abs=0.02)
    assert in_notch("lms_class5", 0)[0] == pytest.approx(2 * 1.75, abs=0.01)
    for notch in (1, 0.6, 0.2, 0, -0.4, -1):
        assert in_notch("lms_class5", notch)[1] == pytest.approx(14 * 5 / 40, abs=0.005)


def test_traction_engine():
    result = ct.run(ct.Machine(**example("traction_engine")), quantities=["swept_volume"])
    watts_per_ihp, pascals_per_psi, strokes = 745.6999, 6894.757, 2 * 180 / 60
    assert 40 * watts_per_ihp / (float(result.swept_volume[0]) * strokes) / pascals_per_psi == printed("57.6")
    travel, lap_and_lead = in_notch("traction_engine", 1)
    assert travel == pytest.approx(2.5, rel=0.01)
    # With outside admission the valve is toward the shaft on the far dead centre.
    assert -lap_and_lead == pytest.approx(0.5 + 1 / 16, rel=0.01)


@pytest.mark.parametrize(("rods", "sign"), [("open", 1), ("crossed", -1)])
@pytest.mark.parametrize("admission", ["outside", "inside"])
def test_lead_of_a_link_motion_by_zeuners_formula(rods, sign, admission):
    """A gear of long rods: the formula leaves out what is of the order of r/l and c/l."""
    data = example("traction_engine")
    gear = data["bank"]["valve"]["mechanism"] | {"rods": rods, "admission": admission}
    long = {"eccentric_rod_length": "54 in", "link_radius": "54 in", "reverse_shaft_x": "62 in", "pin_setback": "0 in"}
    data["bank"]["valve"]["mechanism"] = gear | long
    if rods == "crossed":
        data["bank"]["valve"]["mechanism"]["lifting_arm_swing"] = "19.7 deg"
    delta = np.radians(22.3)
    leads = []
    for notch in (1, 0.5, 0):
        data["bank"]["valve"]["mechanism"]["notch"] = notch
        result = ct.run(ct.Machine(**data), quantities=["piston_displacement", "point_y"])
        moved = result.piston_displacement[result.labels["piston"].index("1valve")]
        along = np.mean(result.point_y[result.labels["point"].index("1valve.saddle"), [0, 180]]) / INCH
        leads.append(abs(float(moved[180] - moved[0])) / 2 / INCH)
        zeuner = 1.37 * (np.sin(delta) + sign * (9 - along**2) / (3 * 54) * np.cos(delta))
        assert leads[-1] == pytest.approx(zeuner, rel=0.01)
    assert np.all(np.diff(leads) * sign > 0)


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
