"""Indicated and brake powers against closed forms, and keys that say friction."""

from typing import Any

import numpy as np
import pytest
from tests.machines import slider, throws
from tests.told import line_of, lines_of, problems_told, texts_of

import cranktrain as ct

GAS = {
    "kind": "otto",
    "start_pressure": "95 kPa",
    "compression_exponent": 1.34,
    "expansion_exponent": 1.27,
    "pressure_ratio": 3.6,
    "exhaust_pressure": "108 kPa",
}
"""The Otto cycle of tests/golden/gas_pressure: a mean pressure of 1.043763 MPa at a ratio of 10."""
NET = 1043762.8696463
SWEPT = np.pi / 4 * 0.08**2 * 0.1
SPEED = 100.0


def engine(gas: dict[str, Any] = GAS, **cylinder: Any) -> ct.Machine:
    common = {"bore": "80 mm", "compression_ratio": 10, "cycle": "four-stroke", "firing_order": "1L-1R"}
    banks = {"L": {"angle": "-45 deg", "mechanism": slider()}, "R": {"angle": "45 deg", "mechanism": slider()}}
    return ct.Machine(shaft=throws(0, speed=f"{SPEED!r} rad/s"), bank=banks, cylinder=common | cylinder, gas=gas)


INDICATED = 2 * NET * SWEPT * SPEED / (4 * np.pi)


def test_indicated_power():
    result = ct.run(engine(), step_degrees=0.25)
    # Equal steps across the jump at firing, where V′ is 0.
    assert result.indicated_power == pytest.approx(INDICATED, rel=1e-4)
    assert result.mean_indicated_pressure == pytest.approx(NET, rel=1e-4)
    np.testing.assert_allclose(result.bank_indicated_power, INDICATED / 2, rtol=1e-4)
    assert result.mean_torque * SPEED == pytest.approx(float(result.indicated_power), rel=1e-9)
    assert line_of(result, "Gas", "indicated power") == f"{INDICATED / 1e3:.3f} kW, {NET / 1e3:.0f} kPa"
    assert not any(line.startswith("brake power: ") for line in lines_of(result, "Gas"))
    assert "brake_power" not in result.catalogue


def test_mechanical_efficiency():
    result = ct.run(engine(mechanical_efficiency=0.82))
    gas = float(result.indicated_power)
    assert result.brake_power == pytest.approx(0.82 * gas, rel=1e-14)
    assert result.friction_power == pytest.approx(0.18 * gas, rel=1e-14)
    assert result.brake_torque == pytest.approx(0.82 * gas / SPEED, rel=1e-14)
    assert result.brake_efficiency == pytest.approx(0.82, rel=1e-14)
    assert result.mean_brake_pressure == pytest.approx(0.82 * float(result.mean_indicated_pressure), rel=1e-14)
    mean = 0.82 * float(result.mean_indicated_pressure)
    said = f"{0.82e-3 * gas:.3f} kW, {0.82 * gas / SPEED:.2f} N·m, {mean / 1e3:.1f} kPa"
    assert line_of(result, "Gas", "brake power") == said


def test_friction_pressure():
    result = ct.run(engine(friction_pressure="1.5 bar"))
    lost = 1.5e5 * 2 * SWEPT * SPEED / (4 * np.pi)
    assert result.friction_power == pytest.approx(lost, rel=1e-13)
    assert result.brake_power == pytest.approx(float(result.indicated_power) - lost, rel=1e-13)
    assert result.mean_brake_pressure == pytest.approx(float(result.mean_indicated_pressure) - 1.5e5, rel=1e-12)


def test_a_machine_that_is_driven():
    """Expansion that loses more than compression took: the gas is worked on, and friction has to be driven as well."""
    driven = GAS | {"pressure_ratio": 1, "expansion_exponent": 1.4}
    result = ct.run(engine(driven, mechanical_efficiency=0.8))
    gas = float(result.indicated_power)
    assert gas < 0
    assert result.brake_power == pytest.approx(gas / 0.8, rel=1e-14)
    assert result.friction_power == pytest.approx(-gas / 4, rel=1e-13)
    assert result.brake_efficiency == pytest.approx(0.8, rel=1e-14)
    said = f"{-gas / 800:.4f} kW, {-gas / 0.8 / SPEED:.3f} N·m, "
    assert line_of(result, "Gas", "driven with").startswith(said)
    assert line_of(result, "Gas", "indicated power taken").startswith(f"{-gas / 1e3:.4f} kW, ")


def test_designs():
    result = ct.run([engine(mechanical_efficiency=eta) for eta in (0.7, 0.9)], step_degrees=10)
    np.testing.assert_allclose(result.brake_efficiency, [0.7, 0.9], rtol=1e-14)


@pytest.mark.parametrize(
    ("cylinder", "path", "allowed"),
    [
        ({"mechanical_efficiency": 1.1}, "mechanical_efficiency", "at most 1"),
        ({"mechanical_efficiency": 0}, "mechanical_efficiency", "more than 0"),
        ({"mechanical_efficiency": "80 mm"}, "mechanical_efficiency", "a number without a unit"),
        ({"friction_pressure": "-1 bar"}, "friction_pressure", "at least"),
        ({"friction_pressure": "1.5 barg"}, "friction_pressure", "not gauge"),
        ({"friction_pressure": "1.5 bar", "mechanical_efficiency": 0.8}, "friction_pressure", "must not stand beside"),
    ],
)
def test_bad_input(cylinder, path, allowed):
    with pytest.raises(ct.InputError) as refused:
        engine(**cylinder)
    (problem,) = problems_told(refused.value.problems)
    assert problem.path == f"cylinder.{path}"
    assert allowed in problem.allowed


def test_friction_of_the_machine_is_no_cylinders_own():
    with pytest.raises(ct.InputError, match="mechanical_efficiency"):
        engine(L={"mechanical_efficiency": 0.8})


def test_what_is_missing():
    result = ct.run(engine())
    (missing,) = (one for one in result.missing if "brake_power" in one.results)
    assert texts_of(missing.needs) == ("[cylinder] mechanical_efficiency or friction_pressure",)
