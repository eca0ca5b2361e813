"""Steady running of several designs: each has its own motor and its own cycle, as it has alone."""

import numpy as np

import cranktrain as ct

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
