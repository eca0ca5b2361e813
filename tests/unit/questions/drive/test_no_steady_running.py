"""What is said where no cycle repeats itself: why, and that its energy was not judged."""

import numpy as np
import pytest
from tests.machines import ROCKER
from tests.told import texts_of

import cranktrain as ct

DRIVEN = {
    "mechanism": ROCKER,
    "shaft": {"main": {"speed": "60 rpm"}},
    "masses": {"rocker": {"mass": "3 kg", "along": "50 mm", "inertia": "0.1 kg*m^2"}},
    "load": {"work": {"on": "main", "torque": "40 N*m"}},
    "drive": {"motor": {"kind": "shunt", "torque": "200 N*m", "speed": "57 rpm", "no_load_speed": "60 rpm"}},
}
PEAK = {
    "on": "main",
    "crank_angles": ["0 deg", "90 deg", "91 deg", "180 deg", "181 deg", "360 deg"],
    "torque": ["0 N*m", "0 N*m", "9 kN*m", "9 kN*m", "0 N*m", "0 N*m"],
}
"""More than the motor of 4 kN·m at standstill has, for a quarter of a turn; less on the mean."""
GOVERNED = {
    "kind": "prime_mover",
    "torque": "200 N*m",
    "speed": "57 rpm",
    "no_load_speed": "60 rpm",
    "full_load": {"speeds": ["0 rpm", "60 rpm"], "torques": ["250 N*m", "250 N*m"]},
}
"""Which does not brake a load that drives."""
JAMMED = {"ratio": 30, "efficiency": 0.3}
"""As theory says: inertia 4 behind 30 with 0.3, less than 0 backward, next to no rotor: no acceleration, or two."""


@pytest.mark.parametrize(
    ("changes", "why"),
    [
        ({"mechanism.crank_radius": "330 mm"}, "the links do not close all round"),
        ({"load.work.torque": "9 kN*m"}, "the motor cannot carry the machine through the cycle"),
        ({"load.peak": PEAK}, "at a constant"),
        ({"load.work.sense": "active", "drive.motor": GOVERNED}, "nothing holds it"),
        (
            {
                "drive.stage": [JAMMED],
                "drive.part.table": {"on": 1, "inertia": "4 kg*m^2"},
                "load.work.torque": "0 N*m",
            },
            "the gearing jams. It cannot be driven back",
        ),
    ],
    ids=["open", "weak", "peak", "driven", "jammed"],
)
def test_why_there_is_none(changes, why):
    result = ct.run(ct.Machine(**DRIVEN).with_(changes), partial=True, quantities=None)
    (said,) = [flag for flag in texts_of(result.flags) if flag.startswith("No steady running")]
    assert why in said
    (energy,) = [check for check in result.checks if check.name == "drive_energy"]
    assert str(energy.verdict()) == "needs steady running"
    assert not energy.passed[0]
    assert not any("–" in flag for flag in texts_of(result.flags)), "what is not known stands nowhere"
    assert result.summary()


@pytest.mark.parametrize("inertia", ["0 kg*m^2", "0.001 kg*m^2", "1 kg*m^2"])
def test_a_stiff_motor_runs_with_next_to_no_inertia(inertia):
    """In the dead positions there is the rotor alone, or nothing: the speed follows the load there at once.

    The load is constant, so the mean torque over the angle is 40 of 200 N·m, and the mean speed 57 + 0.8 · 3 rpm.
    """
    result = ct.run(ct.Machine(**DRIVEN).with_({"drive.part": {"rotor": {"on": "motor", "inertia": inertia}}}))
    (energy,) = [check for check in result.checks if check.name == "drive_energy"]
    assert str(energy.verdict()) == "holds"
    assert np.mean(result.drive_speed) == pytest.approx(59.4 * np.pi / 30, rel=1e-6)
