"""Torque that turns a crank at its declared speed, against closed forms of a Scotch yoke and of a steady motor."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

import cranktrain as ct

_SPEED = 4 * np.pi  # 120 rpm
_SWING = 50.0 * 0.1**2 * _SPEED**2 / 2  # m R² ω² / 2, N·m
_FORWARD, _BACK, _RATIO = 0.9, 0.8, 10.0


def _yoke(**tables: object) -> dict[str, object]:
    """A yoke of 50 kg and 0.1 m at 120 rpm behind a gear."""
    return {
        "shaft": {"main": {"speed": "120 rpm"}},
        "mechanism": {"kind": "scotch_yoke", "crank_radius": "100 mm"},
        "masses": {"piston": {"mass": "50 kg"}},
        "drive": {
            "stage": [{"kind": "gear", "ratio": _RATIO, "efficiency": _FORWARD, "efficiency_back": _BACK}],
            "part": {"rotor": {"on": "motor", "inertia": "3 kg*m^2"}, "wheel": {"on": 1, "inertia": "30 kg*m^2"}},
        },
        **tables,
    }


def test_inertia_of_a_yoke_passes_by_the_direction_of_power() -> None:
    """x = R cos φ: the crank takes ½ m R² ω² sin 2φ; gears and rotors that turn evenly, nothing."""
    found = ct.run(ct.Machine(**_yoke()))
    crank = _SWING * np.sin(2 * np.radians(found.crank_angle))
    motor = crank / _RATIO * np.where(crank > 0, 1 / _FORWARD, _BACK)
    assert_allclose(found.constant_speed_torque, [motor, crank], rtol=0, atol=1e-12 * _SWING)
    assert_allclose(found.largest_constant_speed_torque, [_SWING / _RATIO / _FORWARD, _SWING], rtol=1e-12)
    assert_allclose(found.smallest_constant_speed_torque, [-_SWING * _BACK / _RATIO, -_SWING], rtol=1e-12)
    mean = _SWING / np.pi * (1 / _FORWARD - _BACK) / _RATIO
    assert_allclose(found.mean_constant_speed_torque[0], mean, rtol=1e-12)
    rms = _SWING / _RATIO * np.sqrt((1 / _FORWARD**2 + _BACK**2) / 4)
    assert_allclose(found.rms_constant_speed_torque, [rms, _SWING / np.sqrt(2)], rtol=1e-12)
    assert_allclose(found.constant_motor_speed, _RATIO * _SPEED, rtol=1e-14)
    assert_allclose(found.constant_speed_power, mean * _RATIO * _SPEED, rtol=1e-12)


@pytest.mark.parametrize("step", [1.0, 7.5])
def test_facts_do_not_hang_on_the_step(step: float) -> None:
    """Peaks between corners and means by quadrature are the same at any step."""
    found = ct.run("high_slip_press", step_degrees=step)
    fine = ct.run("high_slip_press", step_degrees=0.5)
    for name in ("largest", "smallest", "mean", "rms"):
        own, other = (getattr(one, f"{name}_constant_speed_torque") for one in (found, fine))
        assert_allclose(own, other, rtol=1e-9)


def test_a_heavy_wheel_brings_a_motor_that_holds_the_speed_there() -> None:
    """A servo that is asked for no torque holds the declared speed: its steady running is the same torque."""
    motor = {
        "kind": "servo",
        "torque": "20 N*m",
        "speed": "1500 rpm",
        "peak_torque": "60 N*m",
        "top_speed": "3000 rpm",
    }
    tables = _yoke()
    tables["drive"] = {**tables["drive"], "motor": motor}  # pyright: ignore[reportGeneralTypeIssues]
    found = ct.run(ct.Machine(**tables))
    assert_allclose(found.motor_torque, found.constant_speed_torque[0], rtol=0, atol=1e-9 * _SWING)
    assert_allclose(found.constant_speed_rms_share, found.rms_constant_speed_torque[0] / 20.0, rtol=1e-12)
    assert_allclose(found.constant_speed_peak_share, _SWING / _RATIO / _FORWARD / 60.0, rtol=1e-12)


def test_designs_side_by_side_are_as_alone() -> None:
    """Of many masses each has its own torque, in proportion."""
    many = ct.run([ct.Machine(**_yoke(masses={"piston": {"mass": mass}})) for mass in ("50 kg", "100 kg")])
    assert_allclose(many.rms_constant_speed_torque[1], 2 * many.rms_constant_speed_torque[0], rtol=1e-12)


def test_a_wanted_motion_has_none() -> None:
    """How the crank turns is then said otherwise."""
    assert not hasattr(ct.run("servo_press"), "constant_speed_torque")
