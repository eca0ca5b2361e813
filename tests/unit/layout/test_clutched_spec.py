"""The tables of clutch, brake and stroke: what is read, and what is refused."""

import numpy as np
import pytest

from cranktrain.errors import InputError
from cranktrain.layout.drive.declared import declared_grips
from cranktrain.layout.drive.grip_tables import BrakeSpec, ClutchSpec, StrokeSpec, press_problems
from cranktrain.spec import validated
from cranktrain.transient.clutched.courses import Grip


def in_columns(*numbers):
    return np.stack(np.broadcast_arrays(*map(np.atleast_1d, numbers)), axis=-1)


def test_numbers():
    table = {"torque": "4.8 kgf·m", "delay": "30 ms", "rise_time": "0.1 s", "on": 2}
    clutch = validated(ClutchSpec, table)
    brake = validated(
        BrakeSpec, {"torque": "2 N·m", "static_torque": "3 N·m", "release_delay": "1 s", "fall_time": "2 s"}
    )
    of_clutch, of_brake = declared_grips(clutch, brake, None, in_columns)
    assert of_clutch.of(0) == pytest.approx(Grip(47.07192, 47.07192, 0.03, 0.1, 0.0, 0.0))
    assert of_clutch.n_before == 2
    assert of_brake.of(0) == Grip(2.0, 3.0, 0.0, 0.0, 1.0, 2.0)
    assert of_brake.on == "motor"


@pytest.mark.parametrize(
    ("spec", "table", "path"),
    [
        (ClutchSpec, {"torque": "900 N·m", "static_torque": "899 N·m", "on": 1}, "static_torque"),
        (ClutchSpec, {"torque": "0 N·m", "on": 1}, "torque"),
        (ClutchSpec, {"torque": "900 N·m", "delay": "-1 ms", "on": "motor"}, "delay"),
        (ClutchSpec, {"torque": "900 N·m"}, "on"),
        (ClutchSpec, {"torque": "900 N·m", "on": 0}, "on"),
        (BrakeSpec, {}, "torque"),
        (BrakeSpec, {"torque": "900 N·m", "on": "ram"}, "on"),
        (StrokeSpec, {"command_angle": "20 deg", "start_angle": "20 deg"}, "command_angle"),
        (StrokeSpec, {"command_angle": "541 deg", "start_angle": "180 deg"}, "command_angle"),
        (StrokeSpec, {"command_angle": "300 deg"}, "start_angle"),
        (StrokeSpec, {"start_angle": "0 deg", "strokes_per_minute": 0}, "strokes_per_minute"),
    ],
)
def test_refused(spec, table, path):
    with pytest.raises(InputError) as refused:
        validated(spec, table)
    assert [problem.path for problem in refused.value.problems] == [path]


@pytest.mark.parametrize("on", ["motor", "clutch", "crank"])
def test_a_brake_stands_behind_the_clutch(on):
    clutch = validated(ClutchSpec, {"torque": "900 N·m", "on": 1})
    brake = validated(BrakeSpec, {"torque": "900 N·m", "on": on})
    found = [problem.path for problem in press_problems(clutch, brake, StrokeSpec(start_angle="0 deg"), 2)]
    assert found == (["brake.on"] if on == "motor" else [])
    without = [problem.path for problem in press_problems(None, brake, None, 2)]
    assert without == (["brake.on"] if on == "clutch" else [])


@pytest.mark.parametrize(("on", "n_stages"), [("motor", 0), (1, 0), (2, 2), (3, 2)])
def test_a_clutch_divides_a_shaft_that_is_there(on, n_stages):
    clutch = validated(ClutchSpec, {"torque": "900 N·m", "on": on})
    found = [problem.path for problem in press_problems(clutch, None, None, n_stages)]
    assert found == (["clutch.on"] if on != "motor" and on > n_stages else [])


def test_a_stroke_needs_both():
    found = [str(problem.allowed) for problem in press_problems(None, None, StrokeSpec(start_angle="0 deg"), 1)]
    assert len(found) == 2
    assert "[drive.clutch]" in found[0]
    assert "[drive.brake]" in found[1]
