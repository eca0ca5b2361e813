"""Main bearings of the examples, by levers from what their crank pins carry.

Where a shaft lies in two bearings, or is cut at each, a bearing's load is statics: forces on the pins, weights that
turn, belts, flywheels and gears, each by the lever between the bearings beside it. Pin loads are from the results,
`crankpin_load_radial` inward and `_tangential` with the rotation; directions and levers are put down here, from the
numbers in the files. Of the V-engines this is (50)-(53) of the source with two rods on a pin, and its sum over two
neighbouring throws; weights of [balance] are (44) and (46) with half of each on either web.
"""

import numpy as np
import pytest
from tests.validation.test_examples import INCH, example, run

import cranktrain as ct

LBF = 4.4482216152605


def seen(degrees):
    """Directions outward and with the rotation of a clockwise shaft, counted from straight up; X to the right, Y up."""
    angle = np.radians(degrees)
    return np.stack([np.sin(angle), np.cos(angle)]), np.stack([np.cos(angle), -np.sin(angle)])


def on_pin(result, mechanism, degrees):
    """Force of a rod on its pin, shape (2, n); degrees: where the pin stands from straight up."""
    outward, ahead = seen(degrees)
    return result.crankpin_load_tangential[mechanism] * ahead - result.crankpin_load_radial[mechanism] * outward


def borne(loads, first, last):
    """Loads of two bearings at z = first and last, by levers, from pairs of a place and a force there."""
    one = sum(force * (last - z) / (last - first) for z, force in loads)
    other = sum(force * (z - first) / (last - first) for z, force in loads)
    return one, other


def found(result, method, bearing):
    row, column = result.labels["bearing_method"].index(method), result.labels["bearing"].index(bearing)
    return np.stack([result.main_bearing_load_x[row, column], result.main_bearing_load_y[row, column]])


def agrees(result, method, bearing, expected):
    np.testing.assert_allclose(found(result, method, bearing), expected, rtol=0, atol=1e-11 * np.max(np.abs(expected)))


def pull(newton, degrees):
    return newton * seen(degrees)[0][:, np.newaxis]


@pytest.mark.parametrize("method", ["split", "three_moment", "frame_rigid"])
def test_two_throws_between_two_bearings(method):
    """Bearings 2 in outside of the pins, which are 4 in apart; flywheel and belt at 8.5 in.

    Cranks of 5.4 lb whose centroids are 1 in from the axis: half in the middle of the web outside, 0.95 in from its
    pin, and half in that of the web between the pins.
    """
    result = run("two_throw_compressor")
    loads = [(4 * n, on_pin(result, n, result.crank_angle + 180 * n)) for n in range(2)]
    centrifugal = 5.4 * 0.45359237 * INCH * (1500 * np.pi / 30) ** 2
    for z, n in ((-0.95, 0), (2, 0), (2, 1), (4.95, 1)):
        loads.append((z, centrifugal / 2 * seen(result.crank_angle + 180 * n)[0]))
    loads += [(8.5, pull(60 * LBF, 180)), (8.5, pull(90 * LBF, 90))]
    for bearing, expected in zip(("1", "3"), borne(loads, -2, 6), strict=True):
        agrees(result, method, bearing, expected)


def test_what_hangs_behind_a_bearing_lifts_the_other_one():
    """(8.5 - 6)/8 of the pull lifts bearing 1, and (8.5 + 2)/8 load bearing 3: 33.8 and 142 lbf of 108.2 lbf."""
    data = example("two_throw_compressor")
    data["crankshaft"].pop("pull")
    without, result = ct.run(ct.Machine(**data)), run("two_throw_compressor")
    for bearing, part in (("1", -2.5 / 8), ("3", 10.5 / 8)):
        more = found(result, "split", bearing) - found(without, "split", bearing)
        np.testing.assert_allclose(np.hypot(*more), abs(part) * np.hypot(60, 90) * LBF, rtol=1e-11)
        np.testing.assert_allclose(more[0] / more[1], -90 / 60, rtol=1e-11)
        assert np.all(more[0] * part > 0)


@pytest.mark.parametrize("method", ["split", "three_moment", "frame_rigid"])
def test_an_overhung_pin(method):
    """Main bearing 9.25 in behind the pin, outboard one at 46 in, flywheel and belt at 28 in; cylinder at 90 deg."""
    result = run("mill_engine")
    loads = [(0, on_pin(result, 0, result.crank_angle + 90))]
    loads += [(28, pull(2000 * LBF, 180)), (28, pull(650 * LBF, 270))]
    for bearing, expected in zip(("2", "outboard"), borne(loads, 9.25, 46), strict=True):
        agrees(result, method, bearing, expected)


def test_mill_engine():
    """40 indicated horsepower at 180 rpm, as of the traction engine."""
    result = run("mill_engine")
    assert float(result.indicated_power) / 745.7 == pytest.approx(40, abs=0.05)


@pytest.fixture(scope="module", params=["kamaz_740", "ls3"])
def v8(request):
    return request.param, run(request.param)


V8 = {"kamaz_740": ("R", 155e-3, 14.75e-3, -45, 2600), "ls3": ("L", 4.40 * INCH, -12e-3, 45, 5900)}
"""First bank, pitch, its stagger, where its cylinders stand; speed."""


def test_a_v8_cut_at_its_bearings(v8):
    """Rods side by side, (50)-(53), and a counterweight in the middle of every throw, (44) and (46)."""
    name, result = v8
    bank, pitch, aside, stands, speed = V8[name]
    other = "LR"[bank == "L"]
    centrifugal = result.balance_weight_moment * (speed * np.pi / 30) ** 2
    whole = np.zeros((5, 2, 720))
    for throw, ahead in enumerate([0, 90, 270, 180]):
        at = result.crank_angle + stands + ahead
        rods = [
            (place, on_pin(result, result.labels["mechanism"].index(f"{throw + 1}{own}"), at))
            for own, place in ((bank, aside), (other, -aside))
        ]
        each = borne([*rods, (0, centrifugal[throw] * seen(at + 180)[0])], -pitch / 2, pitch / 2)
        whole[throw : throw + 2] += each
    for bearing in range(5):
        agrees(result, "split", str(bearing + 1), whole[bearing])


def test_counterweights_of_a_v8(v8):
    """Each takes both big ends and half of what reciprocates, and stands in the middle of its throw."""
    name, result = v8
    radius, big_end, reciprocating = {"kamaz_740": (60e-3, 2.4, 3.7), "ls3": (46e-3, 0.44, 0.77)}[name]
    np.testing.assert_allclose(result.balance_weight_moment, radius * (2 * big_end + reciprocating), rtol=1e-12)
    np.testing.assert_allclose(result.balance_weight_position, V8[name][1] * np.arange(4), atol=1e-15)


def test_ls3():
    """6.162 L = 8 pi/4 103.25² 92 mm³; 18.1 m/s = 2 · 92 mm · 5900/min; 10.6 bar at 430 hp; the maker's order."""
    result = run("ls3")
    assert float(result.displacement) / 1e-3 == pytest.approx(6.162, abs=5e-4)
    assert result.mean_piston_speed == pytest.approx(np.full(8, 18.093), abs=5e-4)
    assert float(result.brake_power) / 745.7 == pytest.approx(430, abs=0.05)
    order = np.array(result.labels["piston"])[np.argsort(result.firing_angle)]
    assert "-".join(order) == "1L-4R-4L-1R-3R-3L-2R-2L"  # 1-8-7-2-6-5-4-3
    assert result.firing_interval == pytest.approx(np.full(8, 90.0), abs=1e-9)


def test_a_v12_cut_at_its_bearings():
    """One resultant of both rods on every pin, (50)-(53); summed over throws by the angle between them, (24.35)."""
    result = run("3d12")
    at, ahead = result.crank_angle - 30, [0, 240, 120, 120, 240, 0]
    radial, tangential = result.crankpin_load_radial[:6] / 2, result.crankpin_load_tangential[:6] / 2
    for journal in range(1, 6):
        gamma = np.radians(ahead[journal] - ahead[journal - 1])
        inward = radial[journal - 1] + radial[journal] * np.cos(gamma) + tangential[journal] * np.sin(gamma)
        forward = tangential[journal - 1] - radial[journal] * np.sin(gamma) + tangential[journal] * np.cos(gamma)
        outward, with_it = seen(at + ahead[journal - 1])
        agrees(result, "split", str(journal + 1), forward * with_it - inward * outward)
    for journal in (0, 5):
        outward, with_it = seen(at + ahead[journal])
        expected = tangential[journal] * with_it - radial[journal] * outward
        agrees(result, "split", str(journal + 1 + (journal == 5)), expected)


def test_the_gear_of_a_shaft_of_the_deltic():
    """Its teeth are 3.25 in behind the last bearing: (3.25 + 7)/7 of their force on that, 3.25/7 off the one before."""
    data = example("deltic")
    data.pop("gear")
    without, result = ct.run(ct.Machine(**data)), run("deltic")
    on_main = [i for i, name in enumerate(result.labels["mechanism"]) if machine_shaft(data, name) == "main"]
    assert len(on_main) == 12
    torque = np.sum(result.crankpin_load_tangential[on_main], axis=0) * 7.25 * INCH / 2
    toward, with_it = (one[:, np.newaxis] for one in seen(120))
    teeth = -torque / (7 * INCH) * (with_it + np.tan(np.radians(20)) * toward)
    assert np.all(torque > 0)
    for bearing, part in (("main.7", 10.25 / 7), ("main.6", -3.25 / 7)):
        more = found(result, "split", bearing) - found(without, "split", bearing)
        np.testing.assert_allclose(more, part * teeth, rtol=0, atol=1e-11 * np.max(np.abs(teeth)))


def machine_shaft(data, name):
    """Which shaft a piston of opposed ones works on, `main` unless its table says another."""
    bank, side = name[1:].split(".")
    return data["bank"][bank][side].get("shaft", "main")


def test_pins_and_bearings_bear_what_engines_bear():
    """Specific pressures, load over diameter and width: 10 to 40 MPa in these engines, a few in slow machines."""
    for name, diameter, width, least, most in (
        ("kamaz_740", 95e-3, 32e-3, 10e6, 20e6),
        ("ls3", 65e-3, 20e-3, 30e6, 40e6),
        ("3d12", 95e-3, 48e-3, 8e6, 15e6),
        ("deltic", 4.75 * INCH, 1.75 * INCH, 10e6, 20e6),
        ("two_throw_compressor", 1.5 * INCH, 1.25 * INCH, 1e6, 4e6),
        ("mill_engine", 4.5 * INCH, 8 * INCH, 1e6, 2e6),
    ):
        assert least < np.max(run(name).largest_bearing_load[0]) / (diameter * width) < most, name
