"""Gas at the beginning of a start, against the closed polytropic form of a slider-crank's chamber."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from tests.sentences import GAS_PRESSURE_UNUSED, NOT_POSITIVE
from tests.told import texts_of

import cranktrain as ct

RADIUS, ROD, BORE, CLEARANCE = 0.04, 0.16, 0.08, 0.1
SUCTION, DISCHARGE, N_COMPRESSION = 1e5, 8e5, 1.3
AREA = np.pi * BORE**2 / 4


def compressor(**start):
    return ct.Machine(
        mechanism={"kind": "slider_crank", "stroke": "80 mm", "rod_length": "160 mm"},
        masses={"piston": {"mass": "1 kg"}},
        cylinder={"bore": "80 mm", "clearance": CLEARANCE, "ambient": "1 bar"},
        gas={
            "kind": "compressor",
            "suction_pressure": "1 bar",
            "discharge_pressure": "8 bar",
            "compression_exponent": N_COMPRESSION,
        },
        shaft={"main": {"speed": "1000 rpm"}},
        drive={
            "part": {"wheel": {"on": "motor", "inertia": "2 kg*m^2"}},
            "start": {"angle": "40 deg", "speed": "5 rpm", "duration": "0.5 s", **start},
        },
    )


def volume(angle):
    """Of the chamber over the piston, by the crank angle."""
    x = RADIUS * np.cos(angle) + np.sqrt(ROD**2 - (RADIUS * np.sin(angle)) ** 2)
    return AREA * (CLEARANCE * 2 * RADIUS + RADIUS + ROD - x)


def torque(angle, pressure, step=1e-6):
    """That the crank must be given: −(p − p₀) dV/dφ, by a central difference."""
    return -(pressure - 1e5) * (volume(angle + step) - volume(angle - step)) / (2 * step)


def test_it_expands_along_its_polytrope():
    """No valve opens between: p Vⁿ stays, and the crank feels just that pressure."""
    found = ct.start(compressor(gas_pressure="6 bar"))
    angle = found.crank_angle_turned
    polytrope = 6e5 * (volume(np.radians(40)) / volume(angle)) ** N_COMPRESSION
    shut = np.logical_and.accumulate(polytrope > 1.05 * SUCTION)
    assert shut.sum() > 50 and found.gas_pressure.shape == (1, found.time.size)
    assert_allclose(found.gas_pressure[0][shut], polytrope[shut], rtol=1e-9)
    assert_allclose(found.load_torque[shut], torque(angle[shut], polytrope[shut]), rtol=1e-6, atol=1e-3)
    assert np.min(found.gas_pressure) == pytest.approx(SUCTION, rel=1e-12)


def test_its_work_is_that_of_the_closed_form():
    """What the gas gives until the suction valve opens: ∫(p − p₀)dV of the polytrope."""
    found = ct.start(compressor(gas_pressure="6 bar"))
    angle = found.crank_angle_turned
    first, now = volume(np.radians(40)), volume(angle)
    polytrope = 6e5 * (first / now) ** N_COMPRESSION
    shut = np.logical_and.accumulate(polytrope > 1.05 * SUCTION)
    given = (6e5 * first - polytrope * now) / (N_COMPRESSION - 1) - 1e5 * (now - first)
    assert_allclose(-found.load_work[shut], given[shut], rtol=1e-6, atol=1e-5)


def test_unless_given_it_is_that_of_suction():
    one, other = ct.start(compressor()), ct.start(compressor(gas_pressure="100 kPa"))
    for name in ("gas_pressure", "load_torque", "crank_speed"):
        np.testing.assert_array_equal(getattr(one, name), getattr(other, name))
    assert one.gas_pressure[0, 0] == pytest.approx(SUCTION, rel=1e-12)


def test_held_valves_let_it_go():
    """While suction valves are held open there is suction pressure, and the curve of the load has no other."""
    found = ct.start(compressor(gas_pressure="6 bar", unloaded_until="0.3 s"))
    held = found.time < 0.3
    assert_allclose(found.gas_pressure[0][held], SUCTION, rtol=1e-12)
    assert_allclose(found.load_torque[held], 0.0, atol=1e-6)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ("9 bar", "the discharge's 800"),
        ("0.5 bar", "from the suction's 100"),
        ("0 bar", NOT_POSITIVE),
        ("-1 bar", NOT_POSITIVE),
        ("6 mm", "must be a pressure"),
        ("6", "must be a pressure"),
    ],
)
def test_what_no_valve_leaves_there_is_refused(given, said):
    with pytest.raises(ct.InputError, match=said):
        ct.start(compressor(gas_pressure=given))


def test_it_is_for_a_compressor():
    machine = ct.Machine(
        mechanism={"kind": "slider_crank", "stroke": "80 mm", "rod_length": "160 mm"},
        masses={"piston": {"mass": "1 kg"}},
        shaft={"main": {"speed": "1000 rpm"}},
        drive={"start": {"speed": "5 rpm", "gas_pressure": "2 bar"}},
    )
    with pytest.raises(ct.InputError, match="is for chambers of a compressor"):
        ct.start(machine)
    assert GAS_PRESSURE_UNUSED in texts_of(ct.run(machine).flags)
    assert GAS_PRESSURE_UNUSED not in texts_of(ct.run(compressor(gas_pressure="6 bar")).flags)


def test_an_engine_has_its_gas_by_the_crank_angle():
    """An Otto cycle of two strokes: p₁ (V₁/V)^n₁ before the top, ψ p₁ ε^n₁ (V_c/V)^n₂ behind it."""
    begin, compression, expansion, heat = 1e5, 1.32, 1.25, 3.0
    machine = ct.Machine(
        mechanism={"kind": "slider_crank", "stroke": "80 mm", "rod_length": "160 mm"},
        masses={"piston": {"mass": "1 kg"}},
        cylinder={"bore": "80 mm", "clearance": CLEARANCE, "cycle": "two-stroke", "firing_order": "1"},
        gas={
            "kind": "otto",
            "start_pressure": "1 bar",
            "compression_exponent": compression,
            "expansion_exponent": expansion,
            "pressure_ratio": heat,
        },
        shaft={"main": {"speed": "1000 rpm"}},
        drive={
            "part": {"wheel": {"on": "motor", "inertia": "2 kg*m^2"}},
            "start": {"angle": "40 deg", "speed": "100 rpm", "duration": "0.5 s"},
        },
    )
    found = ct.start(machine)
    turned = found.crank_angle_turned
    room, smallest, largest = volume(turned), volume(0.0), volume(np.pi)
    rising = begin * (largest / room) ** compression
    falling = heat * begin * (largest / smallest) ** compression * (smallest / room) ** expansion
    is_falling = np.mod(turned, 2 * np.pi) < np.pi
    assert is_falling.any() and not is_falling.all() and found.gas_pressure.shape == (1, found.time.size)
    assert_allclose(found.gas_pressure[0], np.where(is_falling, falling, rising), rtol=1e-12)
