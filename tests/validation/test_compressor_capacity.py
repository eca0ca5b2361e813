"""What compressors take in and deliver, by chamber, stage and machine, in closed forms and as users reported it."""

import tomllib

import numpy as np
import pytest

import cranktrain as ct

R_AIR = 8.31446261815324 / 0.0289647

TWO_STAGES = """
[shaft.main]
throws = ["0 deg", "180 deg"]
spacing = "400 mm"
speed = "500 rpm"
[bank.I]
angle = "90 deg"
throws = [1]
mechanism = { kind = "slider_crank", stroke = "200 mm", rod_length = "500 mm" }
[bank.II]
angle = "-90 deg"
throws = [2]
mechanism = { kind = "slider_crank", stroke = "200 mm", rod_length = "500 mm" }
[cylinder.I]
bore = "480 mm"
piston_rod = "60 mm"
chambers = ["head", "crank"]
clearance = "10 %"
[cylinder.II]
bore = "280 mm"
piston_rod = "60 mm"
chambers = ["head", "crank"]
clearance = "12 %"
[gas.I]
kind = "compressor"
suction_pressure = "0 barg"
compression_exponent = 1.4
[gas.II]
kind = "compressor"
takes_from = "I"
discharge_pressure = "12 barg"
suction_temperature = "40 °C"
compression_exponent = 1.4
[masses.piston]
mass = "95 kg"
"""
"""A compressor that a user reported: 1855 m³/h at the inlet, 2233 kg/h."""

AREAS = np.array([0.48**2, 0.48**2 - 0.06**2, 0.28**2, 0.28**2 - 0.06**2]) * np.pi / 4
CLEARANCE = np.array([0.10, 0.10, 0.12, 0.12])
TURNS = 500 / 60


@pytest.fixture(scope="module")
def two_stages():
    return ct.run(ct.Machine(**tomllib.loads(TWO_STAGES)))


def by_hand(between):
    """Flows of the four chambers [m³/s, kg/s] and temperatures [K], from the pressure between the stages."""
    low, high = np.array([101325.0] * 2 + [between] * 2), np.array([between] * 2 + [12e5 + 101325.0] * 2)
    taken = 1 + CLEARANCE - CLEARANCE * (high / low) ** (1 / 1.4)
    volume = taken * AREAS * 0.2 * TURNS
    temperature = np.array([293.15, 293.15, 313.15, 313.15])
    return volume, low * volume / (R_AIR * temperature), temperature * (high / low) ** (0.4 / 1.4)


def test_the_pressure_between_is_where_both_pass_on_one_mass(two_stages):
    """By bisection of the closed forms."""
    low, high = 101325.0, 13e5
    for _halving in range(200):
        middle = (low + high) / 2
        mass = by_hand(middle)[1]
        low, high = (middle, high) if mass[0] + mass[1] > mass[2] + mass[3] else (low, middle)
    assert two_stages.discharge_line_pressure[0] == pytest.approx(low, rel=1e-12)
    volume, mass, temperature = by_hand(low)
    np.testing.assert_allclose(two_stages.inlet_flow, volume, rtol=1e-11)
    np.testing.assert_allclose(two_stages.mass_flow, mass, rtol=1e-11)
    np.testing.assert_allclose(two_stages.discharge_temperature, temperature, rtol=1e-11)


def test_in_all_it_takes_in_what_the_user_was_told(two_stages):
    assert round(two_stages.total_inlet_flow * 3600) == 1855
    assert round(two_stages.total_mass_flow * 3600) == 2233
    assert two_stages.labels["gas_stage"] == ("I", "II")
    np.testing.assert_allclose(two_stages.stage_inlet_flow, two_stages.inlet_flow.reshape(2, 2).sum(axis=1), rtol=1e-14)
    np.testing.assert_allclose(two_stages.stage_mass_flow, two_stages.total_mass_flow, rtol=1e-11)
    assert two_stages.stage_power.sum() == pytest.approx(-two_stages.indicated_power, rel=1e-14)
    assert two_stages.specific_power == pytest.approx(
        -two_stages.indicated_power / two_stages.total_inlet_flow, rel=1e-14
    )


def test_power_of_a_stage_in_closed_form(two_stages):
    """n/(n − 1) p_s V λ_v (π^((n−1)/n) − 1) a turn, of both ends."""
    between = float(two_stages.discharge_line_pressure[0])
    volume = by_hand(between)[0]
    first = 3.5 * 101325.0 * (volume[0] + volume[1]) * ((between / 101325.0) ** (0.4 / 1.4) - 1)
    assert two_stages.stage_power[0] == pytest.approx(first, rel=1e-11)


def test_standard_cubic_feet(two_stages):
    """A standard state at the inlet's own gives the inlet's flow; 0 °C unless given, 1.01325 bar."""
    assert two_stages.total_standard_flow == pytest.approx(two_stages.total_inlet_flow * 273.15 / 293.15, rel=1e-12)
    tables = tomllib.loads(TWO_STAGES)
    tables["gas"]["I"] |= {"standard_temperature": "20 °C", "molar_mass": "16.04 g/mol"}
    methane = ct.run(ct.Machine(**tables))
    assert methane.total_standard_flow == pytest.approx(methane.total_inlet_flow, rel=1e-12)
    assert methane.total_mass_flow / two_stages.total_mass_flow == pytest.approx(16.04 / 28.9647, rel=1e-12)


def test_valves_open_where_the_volume_is_that_of_the_polytrope():
    """R 80, L 400, D 250 mm, 1 to 4.5 bar, 8 %: suction at 46.05425021155403°, discharge at 301.6109157127746°."""
    machine = {
        "shaft": {"main": {"speed": "600 rpm"}},
        "mechanism": {"kind": "slider_crank", "crank_radius": "80 mm", "rod_length": "400 mm"},
        "cylinder": {"bore": "250 mm", "clearance": 0.08},
        "gas": {
            "kind": "compressor",
            "suction_pressure": "1 bar",
            "discharge_pressure": "4.5 bar",
            "compression_exponent": 1.35,
            "expansion_exponent": 1.28,
        },
    }
    result = ct.run(ct.Machine(**machine))
    assert result.suction_opening_angle[0] == pytest.approx(46.05425021155403, abs=1e-9)
    assert result.discharge_opening_angle[0] == pytest.approx(301.6109157127746, abs=1e-9)
    assert result.suction_end_temperature[0] / 293.15 == pytest.approx(1.01865, abs=5e-6)
    assert result.discharge_temperature[0] == pytest.approx(
        result.suction_end_temperature[0] * 4.5 ** (0.35 / 1.35), rel=1e-13
    )


def test_each_end_has_a_clearance_of_its_own():
    """Head 8 %, crank 9 %: λ_v 0.8209329001553256 and 0.7985495126747414, by the case of the theory."""
    machine = {
        "shaft": {"main": {"speed": "600 rpm"}},
        "mechanism": {"kind": "slider_crank", "crank_radius": "80 mm", "rod_length": "400 mm"},
        "cylinder": {
            "bore": "250 mm",
            "piston_rod": "50 mm",
            "chambers": ["head", "crank"],
            "clearance": 0.08,
            "1.crank": {"clearance": 0.09},
        },
        "gas": {
            "kind": "compressor",
            "suction_pressure": "1 bar",
            "discharge_pressure": "4.5 bar",
            "compression_exponent": 1.35,
            "expansion_exponent": 1.28,
        },
    }
    result = ct.run(ct.Machine(**machine))
    assert result.volumetric_efficiency == pytest.approx([0.8209329001553256, 0.7985495126747414], rel=1e-13)
    assert result.indicated_work == pytest.approx([-1197.9096026067791, -1120.3758997150794], rel=1e-12)


@pytest.mark.parametrize("key", ["bore", "piston_rod", "ambient"])
def test_one_side_of_a_piston_has_no_bore_of_its_own(key):
    tables = tomllib.loads(TWO_STAGES)
    value = "1 bar" if key == "ambient" else "50 mm"
    tables["cylinder"]["1I.crank"] = {key: value}
    with pytest.raises(ct.InputError, match=rf'cylinder\."1I\.crank"\.{key}'):
        ct.run(ct.Machine(**tables))


def test_ambient_is_what_presses_where_no_chamber_is():
    """Under a single-acting piston: a crankcase at 3 bar takes 2 bar times the area off the force, at every angle."""
    machine = {
        "shaft": {"main": {"speed": "600 rpm"}},
        "mechanism": {"kind": "slider_crank", "crank_radius": "80 mm", "rod_length": "400 mm"},
        "cylinder": {"bore": "250 mm", "clearance": 0.08, "ambient": "1 bar"},
        "gas": {
            "kind": "compressor",
            "suction_pressure": "1 bar",
            "discharge_pressure": "4.5 bar",
            "compression_exponent": 1.35,
        },
    }
    one = ct.run(ct.Machine(**machine))
    other = ct.run(ct.Machine(**machine).with_({"cylinder.ambient": "3 bar"}))
    np.testing.assert_allclose(one.gas_force - other.gas_force, 2e5 * np.pi / 4 * 0.25**2, rtol=1e-12)
    assert one.mean_torque == pytest.approx(other.mean_torque, rel=1e-12)
    np.testing.assert_allclose(one.indicated_work, other.indicated_work, rtol=1e-15)
