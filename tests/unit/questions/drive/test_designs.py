"""Steady running of several designs: each has its own motor and its own cycle, as it has alone."""

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.questions.drive.steady_drive import SteadyCycles
from cranktrain.study.start import over_time_of_designs

WHEEL = "drive.part.flywheel.inertia"
FACTS = ["cycle_time", "drive_fluctuation", "rms_motor_torque", "largest_motor_torque", "motor_heat", "drive_speed"]


def test_each_design_runs_as_it_does_alone():
    compressor = ct.load("compressor_start")
    values = ({}, {"drive.motor.size": "2.2 kW"}, {"drive.part.flywheel.inertia": "0.2 kg·m²"})
    machines = [compressor.with_(one) for one in values]
    found = ct.run(machines, quantities=FACTS)
    for design, machine in enumerate(machines):
        alone = ct.run(machine, quantities=FACTS)
        for fact in FACTS:
            np.testing.assert_array_equal(getattr(found, fact)[design], getattr(alone, fact), err_msg=fact)
    assert len(set(found.cycle_time.tolist())) == 3


@pytest.mark.parametrize(
    ("name", "values"),
    [
        # on as many pieces as their kinks, one by way of heavier ones, and at last more than a block of them
        ("compressor_start", [{WHEEL: f"{size!r} kg*m^2"} for size in np.geomspace(2e-4, 0.3, 20).tolist()]),
        ("compressor_start", [{"gas.discharge_pressure": f"{high} bar"} for high in (1.5, 6, 11)]),
        ("compressor_start", [{"gas.compression_exponent": f"{exponent}"} for exponent in (1.13, 1.2, 2)]),
        ("compressor_start", [{"drive.motor.size": size} for size in ("0.37 kW", "1.5 kW", "3 kW")]),
        ("compressor_start", [{"drive.stage[0].efficiency": f"{part}"} for part in (0.4, 0.96)]),
        ("tilting_table", [{"drive.stage[0].ratio": ratio} for ratio in (40, 30, 10)]),
        ("jaw_crusher", [{"drive.part.flywheel.inertia": f"{size} kg*m^2"} for size in (1, 9)]),
    ],
)
def test_steady_cycles_are_found_together_as_each_alone(name, values):
    """To the last bit, whatever stands beside a design: one without a cycle, too."""
    machine = ct.load(name)
    machines = [machine.with_(one) for one in values]
    together = over_time_of_designs(machines, [SteadyCycles])[SteadyCycles]
    for design, one in enumerate(machines):
        (alone,) = over_time_of_designs([one], [SteadyCycles])[SteadyCycles].found
        found = together.found[design]
        if found is None or alone is None:
            assert found is alone
            continue
        for part in ("base", "departure", "at_start", "acceleration", "multiplier", "period"):
            np.testing.assert_array_equal(getattr(found, part), getattr(alone, part), err_msg=part)
        np.testing.assert_array_equal(found.mesh.start, alone.mesh.start)
