"""A machine's crank-rocker by the symbols of a drive's table: gear, masses and loads of the file."""

import pytest

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.plans.machine_drive import drive_data

STAGES = [{"ratio": 4, "efficiency": 0.94}, {"ratio": 10, "efficiency": 0.9}]


def si(data):
    return {key: float(str(value).split()[0]) for key, value in data.items() if key != "branch"}


def test_gear_of_two_stages():
    """GD² at the motor: 4 (0.02 + 0.58) and that of a wheel of 1.6 kg·m² behind the first stage, over 4²."""
    drive = {
        "stage": STAGES,
        "motor": {
            "kind": "cage",
            "curve": "kloss",
            "breakdown_torque": "95 N*m",
            "breakdown_slip": 0.2,
            "synchronous_speed": "1500 rpm",
            "inertia": "0.02 kg*m^2",
        },
        "part": {
            "coupling": {"inertia": "0.58 kg*m^2"},
            "wheel": {"on": 1, "flywheel_moment": "6.4 kgf*m^2"},
        },
    }
    found = si(drive_data(ct.load("tilting_table").with_({"drive": drive})))
    assert (found["i"], found["eta_p"], found["GD2_0"]) == pytest.approx((40, 0.846, 2.4 + 0.4), rel=1e-14)
    assert (found["Q"], found["GD2_O1"], found["J"]) == (4000.0, 200.0, 2.0)


def test_masses_off_their_pivots():
    """GD² about O₁: 4 (50 + 800 · 0.1²)."""
    rocker = {"mass": "800 kg", "along": "100 mm", "inertia": "50 kg*m^2"}
    machine = ct.load("tilting_table").with_({"masses": {"rocker": rocker}})
    assert si(drive_data(machine))["GD2_O1"] == pytest.approx(4 * (50 + 8), rel=1e-14)


@pytest.mark.parametrize(
    ("load", "force"),
    [
        ({"on": "rocker", "sense": "active", "torque": "-300 N*m"}, 600.0),
        ({"on": "rocker", "sense": "active", "torque": "300 N*m"}, -600.0),
        ({"on": "rocker", "sense": "resisting", "torque": "300 N*m"}, 600.0),
        ({"on": "rocker", "sense": "resisting", "force": "100 N", "radius": "-1 m"}, 200.0),
        ({"on": "rocker", "sense": "resisting", "torque": "300 N*m", "at_turning": "3 rpm"}, None),
        ({"on": "rod", "sense": "active", "torque": "300 N*m"}, None),
    ],
)
def test_loads(load, force):
    links = {"crank_radius": "250 mm", "rod_length": "700 mm", "rocker_length": "500 mm", "ground_length": "800 mm"}
    machine = ct.Machine(mechanism={"kind": "crank_rocker", **links}, load={"one": load})
    assert si(drive_data(machine)).get("Q") == force


def test_branch_and_what_is_no_crank_rocker():
    assert drive_data(ct.load("pumping_unit_c57"))["branch"] == "crossed"
    with pytest.raises(InputError, match="must have a crank-rocker"):
        drive_data(ct.load("vaz_21213"))
