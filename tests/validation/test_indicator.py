"""Indicator diagrams: the measured and the computed Diesel, a table with gauge pressures, Wiebe, Otto and steam cards.

Torque of the first two by a 40-digit multibody solver; the Wiebe trace is a closed form with one integral, and how a
misplaced or badly summed trace errs was computed from it independently (`gas_pressure`), and so was the Otto cycle's
mean pressure. Steam cards are drawn here, with the plateau and the corners that they have.
"""

import json

import numpy as np
import pytest
from tests.gas_engines import FOUR_STROKE, TWO_STROKE, Engine, csv, indicated_work, wiebe, wiebe_cycle
from tests.reference_case import GOLDEN, ReferenceCase
from tests.told import texts_of

import cranktrain.fluids as gas
from cranktrain.fluids.indicator import IndicatorSpec, card_of, diagram_work, indicator_diagram, pressure_at
from cranktrain.fluids.indicator.curve import crest
from cranktrain.fluids.indicator.pegging import polytropic_offset
from cranktrain.fluids.work import indicated_power
from cranktrain.spec import validated

PRESSURE = json.loads((GOLDEN / "gas_pressure/case.json").read_text(encoding="utf-8"))
WIEBE, IMPORT = PRESSURE["wiebe"], PRESSURE["import"]
ENGINE = Engine(0.045, 0.15, 0.08, WIEBE["eps"])
DEGREE = np.radians(1.0)


def diagram_of(text, engine, cycle=FOUR_STROKE, **more):
    spec = validated(IndicatorSpec, {"kind": "indicator", "file": "trace.csv", "text": text, **more})
    return indicator_diagram(card_of(spec).card[0], engine.chamber(cycle))


def golden_text(path):
    return (GOLDEN / path).read_text(encoding="utf-8")


def engine_of(case, ratio=16.0):
    """The case's cylinder; work does not depend on the clearance, which only the machine file of a user knows."""
    machine = case.machine
    radius = machine.get("crank_radius_m", machine.get("stroke_m", 0.0) / 2)
    return Engine(radius, machine["rod_length_m"], machine["bore_m"], machine.get("compression_ratio", ratio))


def test_measured_diesel():
    case = ReferenceCase.load("gas_measured_diesel")
    engine = engine_of(case)
    diagram = diagram_of(golden_text("gas_measured_diesel/raw_pressure.csv"), engine)
    angle = case.crank_angle
    pressure = pressure_at(diagram, angle)
    torque = (pressure - case.machine["ambient_Pa"]) * engine.slope(angle)
    case.compare({"T_gas_Nm": torque, "p_abs_bar": pressure / 1e5})
    case.compare_value("p_max_Pa", np.max(diagram.curve.starts))
    case.compare_value("p_max_at_deg", np.degrees(diagram.curve.places[np.argmax(diagram.curve.starts)]))
    case.compare_value("mean_torque_Nm", diagram_work(diagram, engine.slope) / FOUR_STROKE)
    turn = gas.chamber_state(engine.volume(angle), engine.limits, angle, FOUR_STROKE).turn
    net, gross = (
        indicated_work(part, engine.slope(angle), FOUR_STROKE) / engine.swept
        for part in (pressure, np.where(turn > 0, pressure, 0.0))
    )
    case.compare_value("imep_net_Pa", net)
    case.compare_value("imep_gross_Pa", gross)
    assert diagram_work(diagram, engine.slope) / engine.swept == pytest.approx(net, rel=1e-6)
    assert diagram.flags == ()


def test_computed_diesel_with_firing_at_360_degrees():
    case = ReferenceCase.load("gas_computed_diesel")
    engine = engine_of(case)
    diagram = diagram_of(golden_text("gas_computed_diesel/indicator_diagram.csv"), engine)
    angle = case.crank_angle - 2 * np.pi
    torque = (pressure_at(diagram, angle) - case.machine["ambient_Pa"]) * engine.slope(angle)
    case.compare({"T_drive_Nm": -torque})
    case.compare_value("mean_torque_rod145mm_Nm", diagram_work(diagram, engine.slope) / FOUR_STROKE)
    swept, radius = case.machine["swept_volume_m3"], case.machine["crank_radius_m"]
    harmonic = swept / (2 * radius) * radius

    def harmonic_slope(at):
        return harmonic * np.sin(at)

    work = diagram_work(diagram, harmonic_slope)
    case.compare_value("work_per_cycle_harmonic_J", work)
    case.compare_value("imep_harmonic_Pa", work / swept)
    speed = case.machine["speed_rpm"] * np.pi / 30
    case.compare_value("indicated_power_harmonic_W", indicated_power(work, FOUR_STROKE, speed))
    assert any("360°" in finding for finding in texts_of(diagram.findings))


def test_gauge_table_gives_the_torque_of_the_multibody_solver():
    """Torque with gas less torque without, the same machine: both cases are golden."""
    loaded, idle = ReferenceCase.load("slider_crank_gas"), ReferenceCase.load("slider_crank_inertia")
    assert loaded.machine["crank_speed_rad_s"] == idle.machine["crank_speed_rad_s"]
    engine = engine_of(loaded)
    diagram = diagram_of(golden_text("slider_crank_gas/gas_table.csv"), engine)
    angle = loaded.crank_angle
    torque = (pressure_at(diagram, angle) - 101325.0) * engine.slope(angle)
    inertia = idle.column("T_drive_Nm")[np.arange(721) % 360]
    loaded.compare({"T_drive_Nm": inertia - torque})


def test_wiebe_trace_is_that_of_the_reference():
    """The helper of these tests itself, against `gas_pressure`."""
    peak = np.radians(WIEBE["phi_pmax_deg"])
    assert wiebe(ENGINE, WIEBE, np.array(peak)) == pytest.approx(WIEBE["p_max"], rel=1e-12)
    assert wiebe(ENGINE, WIEBE, np.array(np.pi)) == pytest.approx(WIEBE["p_end"], rel=1e-12)


def wiebe_text(step=1.0, start=0.0, **options):
    """The cycle from firing as a file; one row more than a cycle where it is to close."""
    n_rows = round(720 / step) + options.pop("more", 0)
    degrees = start + step * np.arange(n_rows)
    return csv(degrees, wiebe_cycle(ENGINE, WIEBE, np.radians(degrees)))


@pytest.mark.parametrize(("step", "error"), [(1, -2e-6), (2, -1e-5), (5, -5e-5), (10, -2e-4)])
def test_sum_over_equal_steps(step, error):
    """To the one digit that the reference prints."""
    diagram = diagram_of(wiebe_text(step), ENGINE)
    angle = np.radians(np.arange(0, 720, step))
    found = indicated_work(pressure_at(diagram, angle), ENGINE.slope(angle), FOUR_STROKE) / ENGINE.swept
    assert float(f"{found / IMPORT['imep_net'] - 1:.0e}") == pytest.approx(error, rel=0.5)


@pytest.mark.parametrize(("shift", "change"), IMPORT["relative_imep_change_by_tdc_shift_deg"])
def test_misplaced_dead_centre(shift, change):
    """A dead centre that the user gives wrongly by so much puts the trace late by so much.

    The reference shifts the closed form. A shift by whole steps is exact; between steps the curve stands for the
    trace, and errs a little where the exhaust opens.
    """
    angle = np.arange(720) * DEGREE
    true = indicated_work(wiebe_cycle(ENGINE, WIEBE, angle), ENGINE.slope(angle), FOUR_STROKE)
    diagram = diagram_of(wiebe_text(), ENGINE, firing_angle=f"{-shift} deg")
    found = indicated_work(pressure_at(diagram, angle), ENGINE.slope(angle), FOUR_STROKE)
    assert found / true - 1 == pytest.approx(change, abs=2e-8 if shift in (-1, 1) else 2e-4)


def test_duplicate_endpoint_is_left_out():
    """Kept, it would take 0.14 % from the mean torque, which is 1/721."""
    closed, open_ended = diagram_of(wiebe_text(more=1), ENGINE), diagram_of(wiebe_text(), ENGINE)
    np.testing.assert_array_equal(closed.curve.places, open_ended.curve.places)
    np.testing.assert_array_equal(closed.curve.starts, open_ended.curve.starts)
    assert any("the last is left out" in finding for finding in texts_of(closed.findings))
    degrees = np.arange(721)
    torque = wiebe_cycle(ENGINE, WIEBE, np.radians(degrees)) * ENGINE.slope(np.radians(degrees))
    assert np.mean(torque) / np.mean(torque[:-1]) - 1 == pytest.approx(-0.0014, abs=5e-5)


@pytest.mark.parametrize(("exponent", "error"), [(1.33, 0.0), (1.31, IMPORT["pegging_error_n_minus_0p02"])])
def test_pegging_by_the_exponent(exponent, error):
    """Two points of the compression, at −100° and −65°."""
    angle = np.radians([-100.0, -65.0])
    measured = wiebe(ENGINE, WIEBE, angle) - IMPORT["pegging_offset"]
    found = polytropic_offset(measured, ENGINE.volume(angle).value, exponent)
    assert found == pytest.approx(IMPORT["pegging_offset"] + error, abs=1e-6)


def test_pegging_restores_the_level_and_leaves_the_work():
    degrees = np.arange(720.0)
    measured = wiebe_cycle(ENGINE, WIEBE, np.radians(degrees)) + 4.2e4
    text = csv(degrees, measured)
    raw, pegged = diagram_of(text, ENGINE), diagram_of(text, ENGINE, peg={"exponent": 1.33})
    assert pegged.curve.starts == pytest.approx(measured - 4.2e4, abs=1e-6)
    assert diagram_work(pegged, ENGINE.slope) == pytest.approx(diagram_work(raw, ENGINE.slope), rel=1e-12)
    known = diagram_of(text, ENGINE, peg={"pressure": "0.97 bar", "angle": "-270 deg"})
    assert known.curve.starts == pytest.approx(measured - 4.2e4, abs=1e-6)


def by_volume(n_points=200):
    """Strokes of the Wiebe cycle, each with as many points uniform in volume: p(V) as files give it."""
    part = np.linspace(0, 1, n_points)
    low, high = ENGINE.limits
    rows = []
    for stroke in range(4):
        outward = stroke % 2 == 0
        travelled = part if outward else part[::-1]
        # cos φ = (s² + R² − L²)/(2Rs), the exact inverse of the central slider-crank.
        radius, rod = 0.045, 0.15
        position = radius + rod - travelled * 2 * radius
        cosine = np.clip((position**2 + radius**2 - rod**2) / (2 * radius * position), -1, 1)
        angle = 2 * np.pi * (stroke // 2) + (np.arccos(cosine) if outward else 2 * np.pi - np.arccos(cosine))
        inside = np.clip(angle, stroke * np.pi + 1e-9, (stroke + 1) * np.pi - 1e-9)
        rows += list(zip(low + travelled * (high - low), wiebe_cycle(ENGINE, WIEBE, inside), strict=True))
    return np.array(rows).T


def test_pressure_over_volume_is_unrolled():
    """Within 0.07 % of the peak; linear interpolation in the volume errs by 6.7 %."""
    volume, pressure = by_volume()
    text = csv(volume * 1e6, pressure, header="V [cm³],p [Pa]")
    diagram = diagram_of(text, ENGINE)
    angle = np.radians(np.arange(-120, 120, 0.1))
    error = np.abs(pressure_at(diagram, angle) - wiebe(ENGINE, WIEBE, angle)) / WIEBE["p_max"]
    assert np.max(error) < 7e-4
    assert not any("in one step" in flag for flag in texts_of(diagram.flags))
    outward = slice(0, 200)
    at = angle[angle > 0]
    linear = np.interp(ENGINE.volume(at).value, volume[outward], pressure[outward])
    assert np.max(np.abs(linear - wiebe(ENGINE, WIEBE, at))) / WIEBE["p_max"] == pytest.approx(0.067, abs=1e-3)


def test_torque_orders():
    """Gas and inertia (m_j 0.62 kg, 350 rad/s) from a file in steps of 1°.

    Heat begins with a kink, which such steps leave uncertain by 1e-5 of the largest order.
    """
    case = json.loads((GOLDEN / "torque_orders/case.json").read_text(encoding="utf-8"))
    diagram = diagram_of(wiebe_text(), ENGINE)
    angle = np.arange(720) * DEGREE
    motion = ENGINE.volume(angle)
    inertia = 0.62 * 350**2 * motion.first * motion.second / ENGINE.area**2
    torque = (pressure_at(diagram, angle) - 1e5) * motion.first - inertia
    series = np.fft.rfft(torque) / 720
    largest = max(expected["amplitude"] for expected in case["orders"].values())
    for order, expected in case["orders"].items():
        found = series[round(2 * float(order))] * (2 if float(order) else 1)
        assert abs(found - (expected["a_cos"] - 1j * expected["b_sin"])) < 1e-5 * largest, order


@pytest.mark.parametrize("shift", np.arange(0, 10, 0.25))
def test_coarse_rows_of_a_burning_cycle(shift):
    """Rows each 10°, wherever they fall: the true peak stands up to 5 % above the largest sample."""
    degrees = np.arange(0, 720, 10) + shift
    diagram = diagram_of(csv(degrees, wiebe_cycle(ENGINE, WIEBE, np.radians(degrees))), ENGINE)
    assert crest(diagram.curve)[1] == pytest.approx(WIEBE["p_max"], rel=0.015)
    assert diagram_work(diagram, ENGINE.slope) / ENGINE.swept == pytest.approx(IMPORT["imep_net"], rel=0.002)
    assert not any("in one step" in flag for flag in texts_of(diagram.flags))


OTTO = PRESSURE["ideal"]["cycles"]["otto"]
TURNS = np.arange(4) * 180


def otto(degrees, stroke):
    """Pressure of the ideal cycle on its strokes from firing on: expansion, exhaust, inlet, compression."""
    _eps, start, compression, expansion, _psi, _rho, inlet, exhaust = OTTO["input"]
    low, high = ENGINE.limits
    volume = ENGINE.volume(np.radians(degrees)).value
    of_strokes = [OTTO["p3"] * (low / volume) ** expansion, 0 * volume + exhaust, 0 * volume + inlet]
    return np.choose(stroke, [*of_strokes, start * (high / volume) ** compression])


def otto_text(jumps, shift=0.0):
    """Rows each 10°; at the dead centres of `jumps`, which are on such rows, the pressure before stands there too."""
    degrees = np.arange(0.0, 720, 10) + shift
    rows = [(angle, after) for angle, after in zip(degrees, otto(degrees, degrees.astype(int) // 180 % 4), strict=True)]
    before = otto(np.array(TURNS), (TURNS // 180 - 1) % 4)
    for angle, pressure in zip(TURNS[jumps], before[jumps], strict=True):
        rows.insert(next(place for place, row in enumerate(rows) if row[0] == angle), (float(angle), pressure))
    return csv(*np.array(rows).T)


@pytest.mark.parametrize("jumps", [[0, 1, 2], [0, 1], [0]], ids=["all", "firing and exhaust", "firing"])
def test_otto_with_its_jumps_as_two_rows(jumps):
    """Mean pressure in closed form; beside the given jumps nothing is passed. Between inlet and compression is none."""
    diagram = diagram_of(otto_text(jumps), ENGINE)
    assert np.degrees(diagram.curve.jumps) == pytest.approx(TURNS[jumps], abs=1e-9)
    assert diagram_work(diagram, ENGINE.slope) / ENGINE.swept == pytest.approx(OTTO["imep_net"], rel=1e-3)
    assert crest(diagram.curve) == pytest.approx((0.0, OTTO["p3"]), rel=1e-12)
    assert pressure_at(diagram, np.array([-1e-12, 0.0])) == pytest.approx([OTTO["p2"], OTTO["p3"]], rel=1e-9)
    assert diagram.flags == ()
    assert any("The pressure jumps where the file gives two" in finding for finding in texts_of(diagram.findings))


@pytest.mark.parametrize("shift", range(10))
def test_otto_with_its_jumps_lost_between_rows(shift):
    """2 % of the mean pressure, and a sentence that says where to look."""
    diagram = diagram_of(otto_text([], shift), ENGINE)
    assert diagram_work(diagram, ENGINE.slope) / ENGINE.swept == pytest.approx(OTTO["imep_net"], rel=0.02)
    (told,) = (flag for flag in texts_of(diagram.flags) if "in one step" in flag)
    assert f"Between {710 + shift}° and {720 + shift}°" in told
    assert crest(diagram.curve)[1] < 1.01 * np.max(diagram.curve.starts)


STEAM = Engine(0.3, 1.9, 0.5, 13.5)


def steam(degrees, cut_off=60.0, lead=3.0, release=150.0, compression=290.0):
    """A locomotive's card: admission at 12 bar to a sharp cut-off, pV = const, release, exhaust at 1.2 bar."""
    clearance = 1 / 12.5

    def volume(at):
        return (1 - np.cos(np.radians(at))) / 2 + clearance

    def expanded(at):
        return 12 * volume(cut_off) / volume(at)

    def compressed(at):
        return 1.2 * volume(compression) / volume(at)

    ends = [cut_off, release, 185.0, compression, 360 - lead]
    before_lead = compressed(360 - lead)
    pieces = [
        0 * degrees + 12,
        expanded(degrees),
        expanded(release) + (1.2 - expanded(release)) * (degrees - release) / (185 - release),
        0 * degrees + 1.2,
        compressed(degrees),
        before_lead + (12 - before_lead) * (degrees - 360 + lead) / lead,
    ]
    return 1e5 * np.choose(np.searchsorted(ends, degrees, side="left"), pieces)


@pytest.mark.parametrize("step", [10, 5, 1])
@pytest.mark.parametrize("cut_off", [40.0, 60.0, 95.0])
def test_plateau_and_corners_of_a_steam_card(cut_off, step):
    """Its true peak is its plateau: not passed by 0.5 % of the range anywhere, nor its exhaust line undercut."""
    for shift in np.arange(0, step, step / 10):
        degrees = np.arange(0, 360, step) + shift
        curve = diagram_of(csv(degrees, steam(degrees, cut_off)), STEAM, TWO_STROKE).curve
        assert crest(curve)[1] < 12e5 + 0.005 * 10.8e5
        lowest = np.min(pressure_at(gas.indicator.Diagram(curve), np.radians(np.arange(0, 360, 0.1))))
        assert lowest > 1.2e5 - 1e-6


def test_the_spline_rings_for_those_who_want_it():
    degrees = np.arange(0.0, 360, 10)
    text = csv(degrees, steam(degrees))
    by_spline = diagram_of(text, STEAM, TWO_STROKE, interpolation="spline")
    assert crest(by_spline.curve)[1] > 12.5e5
    by_limits = texts_of(diagram_of(text, STEAM, TWO_STROKE).findings)
    assert any("largest sample is 12.00 bar" in told and "crest 12.00 bar" in told for told in by_limits)


@pytest.mark.parametrize("n_points", [20, 50, 200])
def test_a_steam_card_over_the_stroke_keeps_plateau_and_admission(n_points):
    """Admission at the dead centre itself, where the strokes meet with two pressures; cut-off at 35 % of the stroke."""
    part = np.linspace(0, 1, n_points)
    clearance = 1 / 12.5
    outward = np.where(part <= 0.35, 12.0, 12 * (0.35 + clearance) / (part + clearance))
    back = np.where(part[::-1] >= 0.2, 1.2, 1.2 * (0.2 + clearance) / (part[::-1] + clearance))
    places, pressures = np.append(part, part[::-1]), 1e5 * np.append(outward, back)
    diagram = diagram_of(csv(120 * places, pressures, header="s [mm],p abs [Pa]"), STEAM, TWO_STROKE)
    at = np.radians(np.arange(0, 360, 0.05))
    assert np.max(pressure_at(diagram, at)) == pytest.approx(12e5, rel=1e-12)
    assert np.min(pressure_at(diagram, at)) == pytest.approx(1.2e5, rel=1e-12)
    assert np.degrees(diagram.curve.jumps) == pytest.approx([0.0, 180.0], abs=1e-9)
    before, after = pressure_at(diagram, np.array([-1e-11, 0.0]))
    assert before == pytest.approx(pressures[-1], rel=1e-6)
    assert after == 12e5
