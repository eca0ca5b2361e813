"""Flywheel and evenness: tests/golden/theory/flywheel_press.json, without its press.

Computed by quadrature, root search and time integration in another program; its speeds' extremes are a grid's nodes.
"""

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.excess import excess_work

import cranktrain as ct
from cranktrain.analysis.outcomes import run_stages
from cranktrain.analysis.parts import parts_of
from cranktrain.analysis.stages import every_stage, lacking
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.shaft_loads import LoadsOnShafts
from cranktrain.layout.speed import Speed
from cranktrain.numerics.periodic import cycle_grid, fourier_curve, plus
from cranktrain.questions.drive.cycle_equation import speed_over_turn
from cranktrain.questions.evenness.flywheel import FlywheelSize, flywheel_size
from cranktrain.questions.evenness.flywheel_inertia import exact_flywheel, flywheels_by_method, textbook_inertia
from cranktrain.questions.evenness.running_speed import RunningSpeed, running_speed
from cranktrain.questions.evenness.shaft_balance import shaft_balance
from cranktrain.questions.evenness.shaft_torque import applied_torque, load_torque
from cranktrain.questions.evenness.shaft_work import shaft_work
from cranktrain.questions.evenness.spec import Balancing, GivenFlywheel, WantedCoefficient
from cranktrain.questions.evenness.speed_law import Power, TorqueLaw, speed_under_law
from cranktrain.questions.evenness.speed_over_cycle import steady_speed
from cranktrain.questions.forces.events import ForceEvents
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.forces.mechanism_torques import MechanismTorques
from cranktrain.questions.reduction.cycle_pieces import mesh_of
from cranktrain.questions.torque.sources import TorqueSources

EXPECTED = json.loads((Path(__file__).parents[1] / "golden/theory/flywheel_press.json").read_text(encoding="utf-8"))
CASE = EXPECTED["variable_J"]
R, L, MASS, SPEED = 0.05, 0.18, 9.0, 60.0
PHI = cycle_grid(720)
DRIVING = 100 + 160 * np.sin(PHI) + 90 * np.sin(2 * PHI) - 40 * np.cos(PHI)
CARRIED = MASS * (R * np.sin(PHI) * (1 + R * np.cos(PHI) / np.sqrt(L**2 - (R * np.sin(PHI)) ** 2))) ** 2
EXCESS = excess_work(DRIVING - 100)
VARIABLE = fourier_curve(CARRIED)
NODES = 1e-7
"""Extremes read off a grid's nodes are short by this much of the fluctuation."""


def test_excess_work():
    assert EXCESS.difference == pytest.approx(CASE["excess_work"], rel=1e-12)


def test_flywheels():
    found = flywheels_by_method(EXCESS, VARIABLE, SPEED, CASE["delta"])
    names = ("exact", "mertsalov", "simple")
    np.testing.assert_allclose(found.inertia, [CASE[f"J_{name}"] for name in names], rtol=1e-12)
    np.testing.assert_allclose(found.fluctuation, [CASE["delta_realised"][name] for name in names], rtol=1e-12)


@pytest.mark.parametrize("row", EXPECTED["mertsalov_error"], ids=lambda row: f"{row['delta']:g}")
def test_errors_of_mertsalov_and_textbook(row):
    found = flywheels_by_method(EXCESS, VARIABLE, SPEED, row["delta"])
    assert found.inertia[0] == pytest.approx(row["J_exact"], rel=1e-12)
    np.testing.assert_allclose(found.error, [0, row["mertsalov_rel"], row["simple_rel"]], atol=1e-12)


def test_speed_with_the_exact_flywheel():
    size = exact_flywheel(EXCESS, VARIABLE, SPEED, CASE["delta"], "extremes")
    assert size.initial_energy == pytest.approx(CASE["E0"], rel=1e-12)
    found = steady_speed(EXCESS, plus(VARIABLE, size.inertia), SPEED, "extremes")
    assert found.speed[0] == pytest.approx(CASE["omega0"], rel=1e-12)
    assert found.means.time == pytest.approx(CASE["omega_time_mean"], rel=1e-12)
    assert found.means.angle == pytest.approx(CASE["omega_angle_mean"], rel=1e-12)
    assert 2 * np.pi / found.means.time == pytest.approx(CASE["period"], rel=1e-12)


@pytest.mark.parametrize("row", EXPECTED["constant_J_delta_definitions"], ids=lambda row: f"{row['delta_extremes']:g}")
def test_two_definitions_of_the_coefficient(row):
    delta = row["delta_extremes"]
    inertia = fourier_curve(np.full(720, textbook_inertia(EXCESS, SPEED, delta)))
    found = steady_speed(EXCESS, inertia, SPEED, "extremes")
    assert found.fluctuation("extremes") == pytest.approx(delta, rel=1e-12)
    assert found.means.time == pytest.approx(row["time_mean"], rel=1e-12)
    assert found.fluctuation() == pytest.approx(row["delta_time_mean"], rel=5 * NODES)
    # the same from the table's own mean: its spread is δ·60
    assert found.fluctuation() == pytest.approx(delta * SPEED / row["time_mean"], rel=1e-12)


def test_quadratic_load():
    case = EXPECTED["quadratic_load"]
    law = TorqueLaw(DRIVING, (Power(np.array(-case["k"]), np.array(2.0)),))
    found = speed_under_law(law, CARRIED + case["J"])
    assert found.speed.speed[0] == pytest.approx(case["omega0"], rel=1e-12)
    assert found.speed.means.time == pytest.approx(case["omega_time_mean"], rel=1e-12)
    assert found.multiplier == pytest.approx(case["floquet_multiplier"], rel=1e-12)
    assert found.speed.fluctuation() == pytest.approx(case["delta_time_mean"], rel=NODES)
    assert np.sqrt(np.mean(found.speed.speed**2)) == pytest.approx(case["mean_square_speed_root"], rel=1e-13)


def motor(no_load_speed, stiffness):
    """M = c (ω_s − ω)."""
    return TorqueLaw(stiffness * no_load_speed, (Power(-stiffness, np.array(1.0)),))


def test_linear_motor():
    case = EXPECTED["linear_motor"]
    law = motor(np.array(case["omega_s"]), np.array(case["c"]))
    law = law._replace(free=law.free - DRIVING)
    found = speed_under_law(law, CARRIED + case["J"])
    speed = found.speed.speed
    assert speed[0] == pytest.approx(case["omega0"], rel=1e-11)
    assert found.speed.means.time == pytest.approx(case["omega_time_mean"], rel=1e-11)
    assert found.speed.fluctuation() == pytest.approx(case["delta_time_mean"], rel=NODES)
    torque = case["c"] * (case["omega_s"] - speed)
    assert np.mean(torque) == pytest.approx(case["motor_torque_angle_mean"], rel=1e-11)
    rms = np.sqrt(np.mean(torque**2 / speed) / np.mean(1 / speed))
    assert rms == pytest.approx(case["motor_torque_rms_time"], rel=1e-11)


def whole_machine(torque, speed, load: dict[str, Any] | None = None, **evenness: Any) -> dict[type, Any]:
    """Stages of a slider-crank of the file's words, its torque being the case's; J_v and J′ are the mechanism's own."""
    machine = ct.Machine(
        shaft={"main": {"speed": f"{speed!r} rad/s"}},
        mechanism={"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "180 mm"},
        masses={"piston": {"mass": "9 kg"}},
        evenness=evenness,
        load={} if load is None else {"on_shaft": load},
    )
    parts = parts_of([machine], step=np.radians(0.5))
    known: dict[type, Any] = {**parts, **run_stages(every_stage(), parts, lacking(every_stage(), parts))}
    torques = known[MechanismTorques]
    square = known[Speed].value[0] ** 2
    torques = replace(torques, from_mechanisms=torques.reduced_inertia_slope * square / 2 - torque)
    balancing, angle = known[Balancing], known[CrankAngle]
    applied = applied_torque(torques, known[LoadedMachine], angle)
    rest = applied.applied_torque[:, np.newaxis]
    sources = TorqueSources((), rest, *np.zeros((2, *rest[:, 0].shape)), *np.zeros((2, 1)), angle.cycle)
    given = None
    if LoadsOnShafts in known:
        loads = known[LoadsOnShafts]
        balance = shaft_balance(loads, None, sources, torques, known[Speed], angle)
        given = load_torque(loads, applied, balance, known[Speed], angle)
    work = shaft_work(applied, sources, given, known[ForceEvents], torques, known[Speed], angle)
    if WantedCoefficient in known:
        known[FlywheelSize] = flywheel_size(balancing, known[WantedCoefficient], None, None, work, known[Speed])
    if GivenFlywheel in known:
        flywheel = known[GivenFlywheel]
        known[RunningSpeed] = running_speed(
            balancing, flywheel, None, applied, given, work, torques, known[Speed], angle
        )
    return known


def test_flywheel_of_a_whole_machine():
    known = whole_machine(DRIVING, SPEED, coefficient=CASE["delta"], mean="extremes")
    size = known[FlywheelSize]
    np.testing.assert_allclose(
        size.flywheel_inertia[0], [CASE[f"J_{name}"] for name in ("exact", "mertsalov", "simple")], rtol=1e-11
    )
    given = f"{float(size.flywheel_inertia[0, 0])!r} kg·m²"
    found = whole_machine(DRIVING, SPEED, flywheel=given, mean="extremes")[RunningSpeed]
    assert found.crank_speed[0, 0] == pytest.approx(CASE["omega0"], rel=1e-11)
    assert found.coefficient_of_fluctuation[0] == pytest.approx(CASE["delta"], rel=1e-10)
    assert found.mean_speed_over_time[0] == pytest.approx(CASE["omega_time_mean"], rel=1e-11)
    assert found.mean_speed_over_angle[0] == pytest.approx(CASE["omega_angle_mean"], rel=1e-11)
    assert all(np.all(check.residual < 1e-11) for check in found.checks)


RISING = {"on": "main", "scale": "balanced", "exponent": 2}


def test_quadratic_load_of_a_whole_machine():
    case = EXPECTED["quadratic_load"]
    flywheel = f"{case['J']!r} kg·m²"
    found = whole_machine(DRIVING, case["omega_time_mean"], RISING, flywheel=flywheel)[RunningSpeed]
    assert found.crank_speed[0, 0] == pytest.approx(case["omega0"], rel=1e-10)
    assert found.coefficient_of_fluctuation[0] == pytest.approx(case["delta_time_mean"], rel=NODES)


def test_linear_motor_in_gauss_points():
    case = EXPECTED["linear_motor"]
    mesh = mesh_of(2 * np.pi, np.empty(0))
    inertia, load = (fourier_curve(curve) for curve in (CARRIED + case["J"], DRIVING))

    def torque(speed):
        return case["c"] * (case["omega_s"] - speed)

    def acceleration(speed):
        wrench = torque(speed) - load.value(mesh.nodes) - inertia.slope(mesh.nodes) * speed**2 / 2
        return wrench / inertia.value(mesh.nodes)

    found = speed_over_turn(acceleration, mesh, SPEED)
    assert found.at(np.zeros(1))[0] == pytest.approx(case["omega0"], rel=1e-10)
    assert 2 * np.pi / found.period == pytest.approx(case["omega_time_mean"], rel=1e-10)
    assert np.sqrt(found.over_time(torque(found.speed) ** 2)) == pytest.approx(case["motor_torque_rms_time"], rel=1e-10)
