"""Mean torque of a ram that comes to rest under load: its work by the area of the load, whatever inertia takes."""

import numpy as np
import pytest

import cranktrain as ct

TURN = 2 * np.pi
FORCE = 400e3
"""Of the example's load, over its last rows. [N]"""
ROUNDING = 1e-10
"""Of the 200 J that inertia takes and gives. [J]"""


def mean_torque(**changes):
    result = ct.run(ct.load("servo_press", set={f"load.forming.{name}": value for name, value in changes.items()}))
    (check,) = (one for one in result.checks if one.name == "load_work")
    assert check.residual[0] < 1e-13
    return -float(np.sum(result.mean_torque))


def test_of_the_example():
    """It rises over 1 mm and stays for 11."""
    assert mean_torque() * TURN == pytest.approx(FORCE * (0.0005 + 0.011), rel=1e-13)


@pytest.mark.parametrize("last", [1e-5, 1e-3, 0.1, 2.0])
def test_of_a_load_that_the_ram_hardly_meets(last):
    """It rises over the last part of the stroke, in mm, so that nearly all torque is that of inertia."""
    travel = ["0 mm", f"{100 - last!r} mm", "100 mm", "101 mm"]
    assert mean_torque(travel=travel) * TURN == pytest.approx(FORCE * last / 2000, rel=1e-13, abs=ROUNDING)


def test_is_that_of_a_rocking_crank():
    rocking = ct.run("servo_press_rocking")
    assert mean_torque() == pytest.approx(-float(np.sum(rocking.mean_torque)), rel=1e-13)
