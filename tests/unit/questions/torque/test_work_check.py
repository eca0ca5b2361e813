"""The work of the torque against that of the gas: for every gas model and mechanism, and where it must fail."""

from typing import Any

import numpy as np
import pytest
from tests.gas_engines import Engine, csv, wiebe_cycle
from tests.machines import V12, slave, slider, throws

import cranktrain as ct
from cranktrain.analysis.outcomes import run_stages
from cranktrain.analysis.parts import parts_of
from cranktrain.analysis.stages import every_stage, lacking
from cranktrain.questions.gas.pressures import GasPressures
from cranktrain.questions.torque.work_check import WorkBalance, work_balance

DUAL = {
    "kind": "dual",
    "start_pressure": "120 kPa",
    "compression_exponent": 1.36,
    "expansion_exponent": 1.25,
    "pressure_ratio": 1.55,
    "cut_off_ratio": 1.45,
    "exhaust_pressure": "105 kPa",
}
OTTO = {name: value for name, value in DUAL.items() if name != "cut_off_ratio"} | {"kind": "otto"}
DIESEL = {name: value for name, value in DUAL.items() if name != "pressure_ratio"} | {
    "kind": "diesel",
    "cut_off_ratio": 2.1,
}
GASES = {"otto": OTTO, "diesel": DIESEL, "dual": DUAL}
MASSES = {"piston": {"mass": "0.6 kg"}}
ROD = {"rod": {"mass": "0.8 kg", "along": "50 mm", "across": "3 mm", "inertia": "0.004 kg·m²"}}


def machine(gas: dict[str, Any], cylinder: dict[str, Any] | None = None, **tables: Any) -> ct.Machine:
    common = {"bore": "80 mm", "compression_ratio": 18, "cycle": "four-stroke"}
    tables = {"shaft": throws(0, speed="900 rpm"), "bank": {"A": {"mechanism": slider()}}, "masses": MASSES} | tables
    return ct.Machine(gas=gas, cylinder=common | (cylinder or {}), **tables)


LAYOUTS = {
    "offset": {"bank": {"A": {"mechanism": slider(offset="6 mm")}}, "masses": MASSES | ROD},
    "gravity": {"gravity": True, "masses": MASSES | ROD},
    "astern": {"running": "astern", "bank": {"A": {"mechanism": slider(offset="6 mm")}}},
    "two-stroke": {"cylinder": {"cycle": "two-stroke"}},
    "double-acting": {"cylinder": {"chambers": ["head", "crank"], "piston_rod": "25 mm", "compression_ratio": 12}},
    "articulated": {
        "bank": {"A": {"mechanism": slider()}, "B": {"angle": "50 deg", "mechanism": slave("A")}},
        "cylinder": {"firing_order": "1A-1B", "B": {"compression_ratio": 15}},
        "masses": MASSES,
    },
    "oscillating": {
        "bank": {
            "A": {"mechanism": {"kind": "oscillating_cylinder", "crank_radius": "40 mm", "ground_length": "190 mm"}}
        },
    },
    "opposed": {
        "shaft": {"main": {"speed": "900 rpm"}, "upper": {"ratio": -1}},
        "bank": {
            "A": {
                "exhaust": {"mechanism": slider()},
                "scavenge": {"mechanism": slider(rod_length="160 mm"), "shaft": "upper"},
                "lead": "13 deg",
            }
        },
        "cylinder": {"cycle": "two-stroke"},
    },
}


@pytest.mark.parametrize("gas", GASES)
@pytest.mark.parametrize("layout", LAYOUTS)
def test_torque_does_the_work_of_the_gas(gas, layout):
    result = ct.run(machine(GASES[gas], **LAYOUTS[layout]), step_degrees=10)
    (check,) = (check for check in result.checks if check.name == "work")
    assert check.limit == 1e-12
    assert check.passed, check.residual


@pytest.mark.parametrize("ratio", [1.001, 4.0, 17.5])
def test_the_end_of_heating_may_be_anywhere(ratio):
    """Newton's method finds it from just after the dead centre to just before the other one."""
    result = ct.run(machine(DUAL | {"cut_off_ratio": ratio}), step_degrees=10)
    assert next(check for check in result.checks if check.name == "work").passed


def test_closed_form_of_one_cylinder():
    """Grinevetsky's mean pressure of tests/golden/gas_pressure, times what the piston sweeps."""
    bank = {"A": {"mechanism": slider(crank_radius="45 mm", rod_length="150 mm")}}
    gas = DUAL | {"exhaust_pressure": "110 kPa"}
    result = ct.run(machine(gas, {"compression_ratio": 16}, bank=bank), step_degrees=10)
    assert result.gas_work == pytest.approx(1052208.3058499 * np.pi / 4 * 0.08**2 * 0.09, rel=1e-13)


def test_designs():
    """Each with ends of heating of its own, and one with none."""
    designs = [machine(DUAL | {"cut_off_ratio": ratio}) for ratio in (1.0, 1.3, 2.0)]
    result = ct.run(designs, step_degrees=10)
    assert np.all(next(check for check in result.checks if check.name == "work").passed)
    alone = [float(ct.run(design, step_degrees=10).gas_work) for design in designs]
    np.testing.assert_array_equal(result.gas_work, alone)


def test_a_v12():
    result = ct.run(ct.Machine(**V12, masses=MASSES, gas=DUAL), step_degrees=10)
    assert next(check for check in result.checks if check.name == "work").passed


def test_with_friction_there_is_no_check():
    result = ct.run(machine(DUAL, friction={"piston": 0.05}), step_degrees=10)
    assert "work" not in {check.name for check in result.checks}
    assert result.mean_torque * 4 * np.pi < 0.99 * result.gas_work


CASE = {"gamma": 1.33, "m": 2.0, "a": np.log(1000), "start_deg": -15.0, "duration_deg": 50.0, "p_bdc": 1e5, "Q": 1000.0}


def indicator(step: float) -> dict[str, Any]:
    engine = Engine(0.045, 0.15, 0.08, 10.0)
    degrees = np.arange(0.0, 720.0, step)
    text = csv(degrees, wiebe_cycle(engine, CASE, np.radians(degrees)))
    return {"kind": "indicator", "file": "trace.csv", "text": text, "firing_angle": "0 deg"}


@pytest.mark.parametrize("step", [0.5, 1.0, 10.0])
def test_indicator_diagrams(step):
    """By quadrature from node to node: to rounding, whatever the steps of the curves."""
    bank = {"A": {"mechanism": slider(crank_radius="45 mm", rod_length="150 mm")}}
    result = ct.run(machine(indicator(1.0), {"compression_ratio": 10}, bank=bank), step_degrees=step)
    check = next(check for check in result.checks if check.name == "work")
    assert check.limit == 1e-12
    assert check.passed


def test_it_can_fail():
    """Torque of one gas, work of another, 1 % apart in its first pressure: the check sees it."""
    parts, others = (
        parts_of([machine(gas)], step=np.radians(10)) for gas in (DUAL, DUAL | {"start_pressure": "121.2 kPa"})
    )
    known, other = (some | run_stages(every_stage(), some, lacking(every_stage(), some)) for some in (parts, others))
    assert other[WorkBalance].checks[0].passed
    needs = next(stage for stage in every_stage() if stage.gives is WorkBalance).needs
    given = {name: known[need] for name, need in needs.items()}
    (check,) = work_balance(**(given | {"pressures": other[GasPressures]})).checks
    assert not check.passed
    assert check.residual == pytest.approx(0.01, rel=0.2)
