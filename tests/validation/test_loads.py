"""Loads on links, from the machine file to joint forces and torque, against a 40-digit multibody solver."""

import numpy as np
import pytest
from tests.reference_case import ReferenceCase
from tests.told import texts_of

import cranktrain as ct

CASE = ReferenceCase.load("crank_rocker_loaded")
LINKS = {"crank": "crank", "rod": "coupler", "rocker": "rocker"}


def body(link):
    along, across = CASE.machine[f"{link}_com_m"]
    return {
        "mass": f"{CASE.machine[f'{link}_mass_kg']} kg",
        "along": f"{along} m",
        "across": f"{across} m",
        "inertia": f"{CASE.machine[f'{link}_inertia_about_com_kgm2']} kg*m^2",
    }


def machine(**tables):
    lengths = {
        name: f"{CASE.machine[f'{link}_length_m']} m"
        for name, link in {
            "crank_radius": "crank",
            "rod_length": "coupler",
            "rocker_length": "rocker",
            "ground_length": "ground",
        }.items()
    }
    return ct.Machine(
        rotation="anticlockwise",
        angle="-90 deg",
        shaft={"main": {"speed": f"{CASE.machine['crank_speed_rad_s']} rad/s"}},
        mechanism={"kind": "crank_rocker", **lengths},
        masses={name: body(link) for name, link in LINKS.items()},
        gravity={"acceleration": f"{-CASE.machine['gravity_m_s2'][1]} m/s^2"},
        load={
            "work": {"on": "rocker", "torque": f"{CASE.machine['rocker_load_torque_Nm']} N*m", "sense": "active"},
            "damper": {
                "on": "rocker",
                "torque": f"{CASE.machine['rocker_viscous_Nms_per_rad']} N*m",
                "at_turning": "1 rad/s",
            },
        },
        **tables,
    )


def test_joint_forces_and_torque_of_a_loaded_crank_rocker():
    result = ct.run(machine())
    joints = {name: i for i, name in enumerate(result.labels["joint"])}
    x, y = result.joint_force_x, result.joint_force_y
    every = slice(None, None, 1)
    found = {"T_drive_Nm": result.driving_torque[every], "J_red_kgm2": result.reduced_inertia[every]}
    for joint, column, sign in (
        ("main_bearing", "F_O2_on_crank", 1.0),
        ("crank_pin", "F_A_on_coupler", 1.0),
        ("joint", "F_B_on_rocker", 1.0),
        ("pivot", "F_O4_on_rocker", 1.0),
    ):
        place = next(i for name, i in joints.items() if name.endswith(joint))
        found[f"{column}_x_N"], found[f"{column}_y_N"] = sign * x[place], sign * y[place]
    CASE.compare({name: np.append(values, values[..., :1]) for name, values in found.items()}, rel_to_peak=1e-9)
    assert all(np.all(check.passed) for check in result.checks)


def test_static_torque_of_load_and_weights():
    """So slowly that inertia is nothing: what holds load and weights at the crank, and the inertia reduced to it."""
    case = ReferenceCase.load("reduction_gd2")
    slow = machine().with_({"shaft.main.speed": "1e-6 rad/s", "load": {"work": machine().declared["load"]["work"]}})
    result = ct.run(slow)
    found = {
        "T_static_crank_Nm": result.driving_torque,
        "J_crank_kgm2": result.reduced_inertia,
        "dJ_crank_dphi_kgm2_per_rad": result.reduced_inertia_slope,
    }
    case.compare({name: np.append(values, values[..., :1]) for name, values in found.items()}, rel_to_peak=1e-9)


def test_a_brake_takes_its_torque_times_the_swing_there_and_back():
    """A constant torque against the motion: −2 M γ a turn; with the viscous one −c ω ∮ α₁′² dφ."""
    result = ct.run(machine().with_({"load.brake": {"on": "rocker", "torque": "50 N*m"}}))
    names = result.labels["load"]
    works = dict(zip(names, result.load_work.tolist(), strict=True))
    assert works["brake"] == pytest.approx(-2 * 50 * float(result.swing[0]), rel=1e-12)
    assert works["work"] == pytest.approx(0.0, abs=1e-10)
    rate = result.rocker_velocity_coefficient[0]
    taken = 6.0 * CASE.machine["crank_speed_rad_s"] * np.mean(rate**2) * 2 * np.pi
    assert works["damper"] == pytest.approx(-taken, rel=1e-12)


def test_a_press_does_the_work_under_its_curve():
    """Force over the last 12 mm before the outer dead centre: the trapezium's area, and nothing on the way back."""
    press = ct.Machine(
        mechanism={"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "300 mm"},
        shaft={"main": {"speed": "60 rpm"}},
        load={
            "blank": {
                "on": "piston",
                "force": ["0 kN", "0 kN", "200 kN", "300 kN"],
                "force_back": ["0 kN", "0 kN", "0 kN", "0 kN"],
                "travel": ["0 mm", "88 mm", "90 mm", "100 mm"],
            }
        },
    )
    result = ct.run(press)
    assert result.load_work[0] == pytest.approx(-(0.002 * 100e3 + 0.010 * 250e3), rel=1e-12)
    assert float(result.mean_torque) * 2 * np.pi == pytest.approx(result.load_work[0], rel=1e-12)


WHOLE = ["0 mm", "100 mm"]


def test_a_press_bears_most_just_before_its_dead_centre():
    """Straight up to it, and nothing behind it: there the force is a limit from one side, whose slope is 0."""
    press = ct.Machine(
        mechanism={"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "300 mm"},
        shaft={"main": {"speed": "60 rpm"}},
        load={"blank": {"on": "piston", "force": ["0 kN", "300 kN"], "force_back": ["0 N", "0 N"], "travel": WHOLE}},
    )
    for travel, most in (("100 mm", 300e3), ("120 mm", 250e3)):
        result = ct.run(press.with_({"load.blank.travel": ["0 mm", travel]}))
        assert result.largest_rod_force[0] == pytest.approx(most, rel=1e-12)
        for named in ("largest S 1", "largest force in 1.crank_pin", "largest size blank"):
            assert any(f"{named} just before 360.00 deg" in said for said in texts_of(result.flags)), named


INCH, POUND_FORCE = 0.0254, 4.4482216152605
STROKE = 49.52420986543403
"""Of the unit C-57D-109-48. [in]"""


def pumping_unit(**more):
    """The unit with the invented card of its test case: 5000 lbf down and 8500 lbf up, each reached in 0.15 stroke."""
    card = {
        "on": "rocker",
        "sense": "active",
        "radius": "64 in",
        "direction": "140.52754015165617 deg",  # straight down, from the mechanism's x, 39.47° clockwise from up
        "counts": "against",
        "travel": ["0 in", f"{0.15 * STROKE!r} in", f"{0.85 * STROKE!r} in", f"{STROKE!r} in"],
        "force": ["5000 lbf", "8500 lbf", "8500 lbf", "8500 lbf"],
        "force_back": ["5000 lbf", "5000 lbf", "5000 lbf", "8500 lbf"],
    }
    return ct.load("pumping_unit_c57").with_({"load": {"card": card, **more}, "pumping": {"card": "card"}})


def test_torque_of_a_pumping_unit_under_its_card():
    unbalance = {
        "on": "rocker",
        "sense": "active",
        "radius": "64 in",
        "direction": "140.52754015165617 deg",
        "force": "-320 lbf",
    }
    result = ct.run(pumping_unit(unbalance=unbalance))
    inch_pound = INCH * POUND_FORCE
    # area of the card, by trapezia, and its mean torque
    assert result.load_work[0] / inch_pound == pytest.approx(-147334.52434966623, rel=1e-12)
    assert -float(result.mean_torque) / inch_pound == pytest.approx(23449.0178383426, rel=1e-11)
    # largest and smallest torque without counterbalance, read off a fine grid there
    assert -float(result.smallest_torque) / inch_pound == pytest.approx(207823.24684163224, rel=2e-7)
    assert -float(result.largest_torque) / inch_pound == pytest.approx(-118526.30174259713, rel=2e-7)


def test_the_saddle_of_a_pumping_unit_carries_what_hangs_on_the_rope():
    """Of a massless unit all forces on the beam add up: pitman, rope, saddle bearing."""
    result = ct.run(pumping_unit())
    joints = result.labels["joint"]
    pivot, joint = (next(i for i, name in enumerate(joints) if name.endswith(end)) for end in ("pivot", "joint"))
    sums = [getattr(result, f"joint_force_{axis}")[[pivot, joint]].sum(axis=0) for axis in "xy"]
    pull = np.hypot(*sums) / POUND_FORCE
    assert pull.min() == pytest.approx(5000, rel=1e-9)
    assert pull.max() == pytest.approx(8500, rel=1e-9)
    # along one line, straight up
    assert np.ptp(np.arctan2(sums[1], sums[0])) < 1e-12
