"""Ideal cycles of `gas_pressure`: closed form, confirmed there by quadrature to 7e-16; air-standard efficiency."""

import itertools
import json
from pathlib import Path

import numpy as np
import pytest
from tests.gas_engines import Engine

import cranktrain.fluids as gas
from cranktrain.fluids.dual.pressure import IdealCycle, corner_pressures, ideal_mean_pressures
from cranktrain.fluids.polytrope import polytropic_work
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank, slider_crank
from cranktrain.motion import Coefficient
from cranktrain.spec import validated

CASE = json.loads((Path(__file__).parents[1] / "golden/gas_pressure/case.json").read_text(encoding="utf-8"))
IDEAL = CASE["ideal"]
R, L, D = IDEAL["geometry"].values()
AREA = np.pi / 4 * D**2
SWEPT = 2 * R * AREA
CLOSED = 1e-14
"""A few operations on doubles; the reference itself was confirmed to 7e-16."""

every_cycle = pytest.mark.parametrize("name", IDEAL["cycles"])


def table(name):
    """The case as a `[gas]` table."""
    _, start, n1, n2, pressure_ratio, cut_off, inlet, exhaust = IDEAL["cycles"][name]["input"]
    ratios = {"pressure_ratio": pressure_ratio, "cut_off_ratio": cut_off}
    if name != "dual":
        ratios.pop({"otto": "cut_off_ratio", "diesel": "pressure_ratio"}[name])
    return {
        "kind": name,
        "start_pressure": f"{start} Pa",
        "compression_exponent": n1,
        "expansion_exponent": n2,
        "inlet_pressure": f"{inlet} Pa",
        "exhaust_pressure": f"{exhaust} Pa",
        **ratios,
    }


def volume(angle, ratio):
    slider = slider_crank(angle, SliderCrank(R, L, 0.0)).slider
    top = R + L
    return Coefficient(SWEPT / (ratio - 1) + AREA * (top - slider.value), -AREA * slider.first, -AREA * slider.second)


def limits(ratio):
    clearance = SWEPT / (ratio - 1)
    return gas.VolumeLimits(clearance, clearance + SWEPT)


def model_of(name):
    ratio = IDEAL["cycles"][name]["input"][0]
    kind, rows = Engine(R, L, D, ratio).filled(validated(gas.KINDS.named(name).spec, table(name)))
    return kind, IdealCycle(*(part[0, 0] for part in rows)), ratio


@every_cycle
def test_closed_form(name):
    _kind, model, ratio = model_of(name)
    expected = IDEAL["cycles"][name]
    found = ideal_mean_pressures(model, ratio)
    assert found.gross == pytest.approx(expected["imep_gross"], rel=CLOSED)
    assert found.pumping == pytest.approx(expected["pmep"], rel=CLOSED)
    assert found.net == pytest.approx(expected["imep_net"], rel=CLOSED)
    corners = corner_pressures(model, ratio)
    assert [float(part[0]) for part in corners] == pytest.approx(
        [expected["p2"], expected["p3"], expected["p4"]], rel=CLOSED
    )


@every_cycle
def test_pressure_over_the_crank_angle_gives_the_same_mean_pressure(name):
    """Gauss's quadrature of p V′ stroke by stroke, broken where heat ends: there the curve has a corner."""
    kind, model, ratio = model_of(name)
    expected = IDEAL["cycles"][name]
    breaks = np.radians([0, expected["phi_cut_deg"], 180, 360, 540, 720])
    nodes, weights = np.polynomial.legendre.leggauss(40)
    total = 0.0
    for start, end in itertools.pairwise(breaks):
        angle = (start + end) / 2 + (end - start) / 2 * nodes
        motion = volume(angle, ratio)
        state = gas.chamber_state(motion, limits(ratio), angle, 4 * np.pi)
        total += np.sum(weights * kind.pressure(state, model) * motion.first) * (end - start) / 2
    assert total / SWEPT == pytest.approx(expected["imep_net"], rel=1e-12)


@every_cycle
def test_pressure_at_dead_centres_is_that_just_after(name):
    kind, model, ratio = model_of(name)
    angle = np.radians([0.0, 180.0, 360.0, 540.0, 720.0])
    state = gas.chamber_state(volume(angle, ratio), limits(ratio), angle, 4 * np.pi)
    expected = IDEAL["cycles"][name]
    _, start, _, _, _, _, inlet, exhaust = expected["input"]
    peak = expected["p3"]
    assert kind.pressure(state, model) == pytest.approx([peak, exhaust, inlet, start, peak], rel=1e-12)


def test_heat_ends_where_the_case_says():
    """The kink of the dual cycle: p₃ up to it, less just after it."""
    kind, model, ratio = model_of("dual")
    expected = IDEAL["cycles"]["dual"]
    angle = np.radians(expected["phi_cut_deg"] + np.array([-1e-6, 1e-6]))
    state = gas.chamber_state(volume(angle, ratio), limits(ratio), angle, 4 * np.pi)
    before, after = kind.pressure(state, model)
    assert before == pytest.approx(expected["p3"], rel=CLOSED)
    assert after < before


def test_air_standard_efficiency():
    """Work over heat with γ for both polytropes; heat c_v(T₃ − T₂) + c_p(T₄ − T₃) in units of p₂V_c/(γ − 1)."""
    case = IDEAL["air_standard_dual"]
    gamma, ratio, psi, rho = case["gamma"], case["eps"], case["psi"], case["rho"]
    cycle = IdealCycle(1e5, 1e5, 1e5, gamma, gamma, psi, rho)
    work = ideal_mean_pressures(cycle, ratio).gross * (ratio - 1)
    heat = corner_pressures(cycle, ratio).compressed * ((psi - 1) + gamma * psi * (rho - 1)) / (gamma - 1)
    assert work / heat == pytest.approx(case["efficiency"], rel=CLOSED)


@pytest.mark.parametrize("exponent", [1.0, 1.0 + 1e-15, 1.0 + 1e-9, 1.0 - 1e-6, 1.3])
def test_polytropic_work_has_all_digits_near_the_isotherm(exponent):
    """Against 50 digits."""
    import mpmath

    with mpmath.workdps(50):
        n, ratio = mpmath.mpf(exponent), mpmath.mpf(0.125)
        exact = -mpmath.log(ratio) if n == 1 else (1 - ratio ** (n - 1)) / (n - 1)
    assert polytropic_work(1.0, 0.125, exponent) == pytest.approx(float(exact), rel=2e-15)
