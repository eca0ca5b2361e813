"""What a stage of a drive says that it is, what contradicts it; largest torques of motors."""

import math

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.errors import InputError

WORM = {"lead_angle": "10 deg", "friction_angle": "4 deg"}


def with_stage(**stage):
    return ct.load("tilting_table").with_({"drive": {"stage": [stage]}})


@pytest.mark.parametrize("kind", ["gear", "worm", "belt", "chain", "coupling", "linkage"])
def test_kind_changes_no_number(kind):
    said, unsaid = (with_stage(ratio=1, efficiency=0.9, **key) for key in ({"kind": kind}, {}))
    assert said.drive.stage[0].kind == kind
    assert unsaid.drive.stage[0].kind is None
    np.testing.assert_array_equal(ct.run(said).static_motor_torque, ct.run(unsaid).static_motor_torque)


def test_worm_may_say_so_beside_its_angles_or_its_efficiencies():
    assert with_stage(ratio=20, kind="worm", **WORM).drive.stage[0].kind == "worm"
    assert with_stage(ratio=20, kind="worm", efficiency=0.7).drive.stage[0].kind == "worm"


@pytest.mark.parametrize(
    ("stage", "path", "said"),
    [
        ({"ratio": 20, "kind": "gear", **WORM}, "drive.stage[0].kind", 'must be "worm" or left out'),
        ({"ratio": 2, "kind": "coupling"}, "drive.stage[0].ratio", 'must be 1 beside kind = "coupling"'),
        ({"ratio": 0.5, "kind": "linkage"}, "drive.stage[0].ratio", 'must be 1 beside kind = "linkage"'),
        ({"ratio": 2, "kind": "rope"}, "drive.stage[0].kind", "must be one of: gear, worm, belt"),
    ],
)
def test_contradictions_are_refused(stage, path, said):
    with pytest.raises(InputError) as caught:
        with_stage(**stage)
    (problem,) = caught.value.problems
    assert problem.path == path
    assert str(problem.allowed).startswith(said)


SYNCHRONOUS = 1500 * math.pi / 30
MOTORS = {
    "breakdown torque": (
        {
            "kind": "cage",
            "curve": "kloss",
            "breakdown_torque": "95 N*m",
            "breakdown_slip": 0.2,
            "synchronous_speed": "1500 rpm",
        },
        95.0,
    ),
    "breakdown ratio": (
        {
            "kind": "wound_rotor",
            "power": "5.5 kW",
            "speed": "1440 rpm",
            "synchronous_speed": "1500 rpm",
            "breakdown_ratio": 2.5,
            "voltage_ratio": 0.9,
        },
        0.81 * 2.5 * 5500 / (1440 * math.pi / 30),
    ),
    "circuit": (
        {
            "kind": "circuit",
            "phase_voltage": "230 V",
            "stator_resistance": "0.9 Ω",
            "rotor_resistance": "0.7 Ω",
            "reactance": "2.6 Ω",
            "synchronous_speed": "1500 rpm",
        },
        3 * 230**2 / (2 * SYNCHRONOUS * (0.9 + math.hypot(0.9, 2.6))),
    ),
    "servo": ({"kind": "servo", "peak_torque": "60 N*m"}, 60.0),
    "none": ({"kind": "shunt", "torque": "3.2 N*m", "speed": "970 rpm", "no_load_speed": "1030 rpm"}, None),
}


@pytest.mark.parametrize("case", MOTORS)
def test_largest_torque_of_a_motor(case):
    table, expected = MOTORS[case]
    machine = ct.load("tilting_table").with_({"drive": {"motor": table, "stage": [{"ratio": 40}]}})
    found = machine.drive.motor.largest_torque
    assert found is None if expected is None else float(found) == pytest.approx(expected, rel=1e-12)
