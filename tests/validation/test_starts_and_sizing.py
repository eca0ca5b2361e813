"""What `run` says of a motor's start does not contradict what `start` does, over all examples with a motor."""

import numpy as np
import pytest
from tests.told import texts_of

import cranktrain as ct
from cranktrain.motors import motor_of
from cranktrain.questions.sizing.motor_checks import START

WITH_LOAD = "A start with its load at the worst angle asks"
TOO_SMALL = (WITH_LOAD, "The motor is too small")
DRIVEN = [
    name
    for name in ct.example_names()
    for drive in [ct.load(name).drive]
    if drive is not None and drive.motor is not None and drive.stroke is None
]
ANGLES = ("0 deg", "60 deg", "120 deg", "180 deg", "240 deg", "300 deg")


def runs_up(name, **settings):
    """Whether a start comes to its steady speed."""
    return "run up" in str(ct.start(name, set=settings).run.reason)


def test_there_are_such_examples():
    assert len(DRIVEN) >= 5


@pytest.mark.parametrize("name", DRIVEN)
def test_a_motor_that_starts_is_not_called_too_small_for_it(name):
    """Only of a start that the file does not ask for, and then as such."""
    found = ct.run(name, quantities=("sizing_share",))
    share = float(found.sizing_share[0, START])
    said = [flag for flag in texts_of(found.flags) if "start" in flag and flag.startswith(TOO_SMALL)]
    assert all(flag.startswith(WITH_LOAD) for flag in said)
    assert (share > 1) == bool(said)
    if share <= 1 and ct.load(name).drive.duty is None:  # at the worst angle, so at any
        assert all(runs_up(name, **{"drive.start.angle": angle}) for angle in ANGLES)
    if not runs_up(name):
        assert said


@pytest.mark.parametrize("name", ["jaw_crusher", "compressor_start", "tilting_table"])
def test_what_is_said_to_help_does(name):
    """They start as their file has it, and the flag says what would ask less; each of it takes the flag away."""
    assert runs_up(name)
    (said,) = [
        flag for flag in texts_of(ct.run(name, quantities=("sizing_share",)).flags) if flag.startswith(WITH_LOAD)
    ]
    assert '[drive.duty] start = "unloaded"' in said
    assert "another [drive.start] angle, from which a flywheel carries it" in said
    assert ("unloaded_until" in said) == (name == "compressor_start")
    eased = {"drive.duty.start": "unloaded"}, {"drive.start.unloaded_until": "1.5 s"}
    for settings in eased if name == "compressor_start" else eased[:1]:
        found = ct.run(name, set=settings, quantities=("sizing_share",))
        assert float(found.sizing_share[0, START]) < 0.2
        assert not any(flag.startswith(TOO_SMALL) for flag in texts_of(found.flags))


PUMP = {
    "shaft": {"main": {"speed": "500 rpm"}},
    "mechanism": {"kind": "slider_crank", "stroke": "200 mm", "rod_length": "500 mm"},
    "cylinder": {"bore": "300 mm", "clearance": "10 %"},
    "gas": {
        "kind": "compressor",
        "suction_pressure": "1.01325 bar",
        "discharge_pressure": "4 bar",
        "compression_exponent": 1.3,
    },
    "masses": {"piston": {"mass": "20 kg"}},
    "load": {"fan": {"on": "main", "torque": "30 N*m"}},
    "drive": {"motor": {"kind": "cage", "size": "30 kW"}, "stage": [{"kind": "belt", "ratio": 3}]},
}


def test_valves_that_are_held_open_leave_the_other_loads():
    """With the suction pressure all over what is left is the fan's torque, through the belt; unloaded not even that."""
    found = {
        label: ct.run(ct.Machine(**PUMP).with_(settings), quantities=("sizing_share",))
        for label, settings in (
            ("loaded", {}),
            ("open", {"drive.start.unloaded_until": "3 s"}),
            ("unloaded", {"drive.duty": {"start": "unloaded"}}),
        )
    }
    shares = {label: float(one.sizing_share[0, START]) for label, one in found.items()}
    motor = motor_of(ct.Machine(**PUMP).drive.motor)
    least = float(np.min(motor.torque(np.linspace(0.0, 0.8 * motor.rating.speed[0], 20001))[0]))
    assert shares["open"] == pytest.approx(10.0 / (0.81 * least), rel=1e-6)
    assert shares["unloaded"] == pytest.approx(0.0, abs=1e-9)
    assert shares["loaded"] > 5 * shares["open"]
    assert "start_with_valves_open" in found["open"].labels["sizing_check"]
