"""Checks that cannot be fooled: no false alarm where a result is 0, and one for every kernel that is a little wrong."""

import dataclasses
from typing import Any

import numpy as np
import pytest
from tests.machines import banks, slider, throws

import cranktrain as ct
from cranktrain.analysis.parts import parts_of
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.motion import Coefficient
from cranktrain.numerics import derivatives_residual
from cranktrain.questions.forces.forces_times_arms import forces_times_arms
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.forces.mechanism_torques import mechanism_torques
from cranktrain.questions.forces.solved_cycle import SolvedCycle
from cranktrain.questions.motion import rockers
from cranktrain.saying.checks import Check

SPEED = throws(0, speed="3000 rpm")
PISTON = {"piston": {"mass": "200 kg"}}
OSCILLATING = {"kind": "oscillating_cylinder", "crank_radius": "600 mm", "ground_length": "1900 mm"}
TINY_INERTIA = {
    "crank": {"mass": "0.5567 kg", "along": "0 mm", "inertia": "0 kg·m²"},
    "rod": {"mass": "0.1677 kg", "along": "0 mm", "inertia": "1.8e-05 kg·m²"},
}
ECCENTRIC = {
    "kind": "eccentric",
    "eccentricity": "60.0193 mm",
    "rod_length": "1400.54 mm",
    "angle_of_advance": "30 deg",
}
BLOCK = {
    "block": {"mass": "1.046 kg", "along": "0 mm", "inertia": "0 kg·m²"},
    "rocker": {"mass": "0.7526 kg", "along": "0.5866 mm", "inertia": "0 kg·m²"},
}
LEVER = {"kind": "slotted_lever", "crank_radius": "100 mm", "ground_length": "250.062 mm"}
FOUR_BAR = {"kind": "crank_rocker", "rod_length": "360 mm", "rocker_length": "280 mm", "ground_length": "400 mm"}
ROCKER = {"rocker": {"mass": "1 kg", "along": "100 mm", "inertia": "0.01 kg·m²"}}
BALANCED_THROW = {
    "crank": {"mass": "2 kg", "along": "-45 mm", "inertia": "0.01 kg·m²"},
    "rod": {"mass": "2 kg", "along": "0 mm", "inertia": "0 kg·m²"},
}


def failing(result: Any) -> dict[str, float]:
    return {check.name: float(check.residual[0]) for check in result.checks if not check.passed[0]}


@pytest.mark.parametrize(
    ("mechanism", "masses"),
    [
        (OSCILLATING, PISTON),  # its mass goes with the crank pin: no torque at all
        (ECCENTRIC, TINY_INERTIA),
        (LEVER, BLOCK),
        (slider(), BALANCED_THROW),  # the rod's mass stands at the crank pin, and the crank balances it
        (slider(rod_length="1e11 mm"), PISTON),
        (slider(crank_radius="1e-6 mm"), PISTON),
        (FOUR_BAR | {"crank_radius": "10 mm"}, ROCKER),
        (FOUR_BAR | {"crank_radius": "1e-3 mm"}, ROCKER),
        (FOUR_BAR | {"crank_radius": "1e-7 mm"}, ROCKER),
    ],
)
def test_machines_whose_results_are_0_or_hardly_more(mechanism, masses):
    result = ct.run(ct.Machine(mechanism=mechanism, shaft=SPEED, masses=masses))
    assert failing(result) == {}


def test_the_cosine_rule_of_a_short_rod_between_long_links():
    """Squares of 400 mm leave 10⁻¹² of the cosine of a rod of 10 µm."""
    lengths = {
        "crank_radius": "0.001 mm",
        "rod_length": "0.01 mm",
        "rocker_length": "400 mm",
        "ground_length": "400 mm",
    }
    result = ct.run(ct.Machine(mechanism={"kind": "crank_rocker", **lengths}))
    assert "transmission_angle" not in failing(result)


@pytest.mark.parametrize("speed", ["constant", "varying"])
@pytest.mark.parametrize("masses", [PISTON, BALANCED_THROW])
def test_pistons_that_cancel(masses, speed):
    """Two pistons on one throw, opposite: of the throw's balance nothing is left but rounding."""
    machine = ct.Machine(bank=banks(L=-90, R=90), shaft=SPEED, masses=masses, gravity=True)
    wave = 300 * (1 + 0.1 * np.sin(np.arange(360) * np.pi / 180))
    assert failing(ct.run(machine, speed="constant" if speed == "constant" else wave)) == {}


@pytest.mark.parametrize("cycle", ["two-stroke", "four-stroke"])
def test_gas_that_does_no_work(cycle):
    """Compressed and expanded along one line: its work is 0, and what the torque does on the way is not."""
    gas = {"kind": "dual", "start_pressure": "1 bar", "compression_exponent": 1.35, "expansion_exponent": 1.35}
    machine = ct.Machine(
        mechanism=slider(),
        shaft=SPEED,
        cylinder={"bore": "80 mm", "cycle": cycle, "compression_ratio": 8},
        gas={**gas, "pressure_ratio": 1, "cut_off_ratio": 1},
    )
    result = ct.run(machine)
    assert failing(result) == {}
    assert abs(result.gas_work) < 1e-12


def test_what_is_too_sharp_for_a_series_is_not_called_wrong():
    """At 10⁻¹² of locking the piston turns within a millionth of a turn: 368640 points show nothing of it."""
    result = ct.run(ct.Machine(mechanism=slider(rod_length="50.00000000005 mm"), shaft=SPEED, masses=PISTON))
    told = {check.name: str(check.verdict()) for check in result.checks if not check.passed[0]}
    assert told == dict.fromkeys(("piston_derivatives", "momentum"), "is beyond the digits of a Fourier series")


def test_what_a_check_says():
    check = Check("name", "sentence", np.array([np.nan, np.inf, np.inf, 1.0, 0.0]), 0.5, ("", "", "is lazy", "", ""))
    assert [str(check.verdict(i)) for i in range(2, 5)] == ["is lazy", "does not hold", "holds"]
    assert str(check.verdict(0)) == "needs a full turn"
    assert str(dataclasses.replace(check, reasons=()).verdict(1)) == "is beyond the digits of a Fourier series"
    np.testing.assert_array_equal(check.judged, [False, False, False, True, True])


@pytest.mark.parametrize(("mechanism", "masses"), [(OSCILLATING, PISTON), (LEVER, BLOCK), (slider(), BALANCED_THROW)])
@pytest.mark.parametrize("joint", range(2))
def test_reactions_that_are_a_little_wrong_are_found(mechanism, masses, joint):
    """A driving torque by 10⁻⁹ of force times arm off is seen, also where there is no torque."""
    machine = ct.Machine(mechanism=mechanism, shaft=SPEED, masses=masses)
    result, angle = ct.run(machine), parts_of([machine], step=np.radians(1))[CrankAngle]
    loaded = result[LoadedMachine]
    solved = result[SolvedCycle]
    (group,) = solved.batches
    force = np.max(np.hypot(result.joint_force_x, result.joint_force_y))
    arm = 0.05 if joint else 0.6
    wrong = group.forces._replace(driving_torque=group.forces.driving_torque + 1e-9 * force * arm)
    falsified = SolvedCycle(loaded, (group._replace(forces=wrong),))
    (check,) = mechanism_torques(loaded, falsified, forces_times_arms(loaded, falsified), None, angle).checks
    assert str(check.verdict()) == "does not hold"


@pytest.mark.parametrize("size", [1.0, 1e-5, 1e-9])
def test_derivatives_that_are_a_little_wrong_are_found(size):
    """Small beside its own place, a motion is shown to 10⁻¹² of that."""

    def motion(error: float) -> Any:
        def curve(phi: Any) -> Coefficient:
            slope = -size * np.sin(phi) + error * np.cos(2 * phi)
            return Coefficient((1 + size * np.cos(phi))[None], slope[None], (-size * np.cos(phi))[None])

        return curve

    assert derivatives_residual(motion(0.0)) < 1e-8
    assert derivatives_residual(motion(1e-7 * size + 2e-12)) > 1e-8


def test_a_rockers_second_derivative_that_is_a_little_wrong_is_found(monkeypatch):
    true = rockers.rocker_angle

    def wrong(members: Any, angle: Any) -> Coefficient:
        found = true(members, angle)
        return found._replace(second=found.second * (1 + 1e-7))

    monkeypatch.setattr(rockers, "rocker_angle", wrong)
    result = ct.run(ct.Machine(mechanism=FOUR_BAR | {"crank_radius": "100 mm"}))
    assert list(failing(result)) == ["rocker_derivatives"]
