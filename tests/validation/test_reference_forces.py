"""Joint forces and torques of eight machines by a 40-digit multibody solver, checked by MuJoCo and Exudyn.

The solver knows bodies and joints only; loads are constant along the turn but for the gas tables, which hold at the
rows' own angles.
"""

import csv

import numpy as np
import pytest
from tests.reference_case import GOLDEN, ReferenceCase
from tests.virtual_work import torque_of_work

from cranktrain.linkage.forces import NO_FRICTION, Body, Conditions, Drive, Gravity, Wrench, added, turned_wrench
from cranktrain.mechanisms import KINDS
from cranktrain.mechanisms.articulated_rod.forces import DYNAMICS as ARTICULATED_ROD
from cranktrain.mechanisms.articulated_rod.forces import articulated_rod_forces, articulated_rod_load, on_master_rod
from cranktrain.mechanisms.articulated_rod.kinematics import ArticulatedRod, articulated_rod
from cranktrain.mechanisms.crank_rocker.forces import DYNAMICS as CRANK_ROCKER
from cranktrain.mechanisms.crank_rocker.forces import crank_rocker_forces
from cranktrain.mechanisms.crank_rocker.kinematics import CrankRocker, crank_rocker
from cranktrain.mechanisms.on_crank import force_on_slider, torque_on_rocker
from cranktrain.mechanisms.slider_crank.forces import DYNAMICS as SLIDER_CRANK
from cranktrain.mechanisms.slider_crank.forces import slider_crank_forces
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank, slider_crank

CLOSE = 1e-12
"""Of each column's peak."""
NOTHING = Body(0.0, 0.0, 0.0, 0.0)


def steady(machine, gravity=(0.0, 0.0)) -> Conditions:
    drive = Drive(machine["crank_speed_rad_s"], machine["crank_acceleration_rad_s2"])
    return Conditions(drive, Gravity(*machine.get("gravity_m_s2", gravity)), (NO_FRICTION,))


def gas_force(case: ReferenceCase) -> np.ndarray:
    """Gas force at the rows' angles, away from the shaft: 0 where the case has none. [N]"""
    if "gas_table" not in case.machine:
        return np.zeros(len(case.rows))
    with (GOLDEN / case.name / case.machine["gas_table"]).open(encoding="utf-8", newline="") as file:
        table = {float(row["crank_angle_deg"]): float(row["p_gauge_Pa"]) for row in csv.DictReader(file)}
    area = np.pi * case.machine["bore_m"] ** 2 / 4
    return np.array([-area * table[angle] for angle in case.column("crank_angle_deg")])


def both(name: str, wrench: Wrench, sign: float = 1.0) -> dict[str, np.ndarray]:
    return {f"{name}_x_N": sign * wrench.x, f"{name}_y_N": sign * wrench.y}


@pytest.mark.parametrize("name", ["slider_crank_inertia", "slider_crank_offset", "slider_crank_gas"])
def test_slider_crank(name):
    case = ReferenceCase.load(name)
    machine = case.machine
    geometry = SliderCrank(machine["crank_radius_m"], machine["rod_length_m"], machine["offset_m"])
    bodies = (
        Body(machine["crank_mass_kg"], machine["crank_com_x_m"], 0.0, machine["crank_inertia_about_com_kgm2"]),
        Body(machine["rod_mass_kg"], machine["rod_com_from_crankpin_m"], 0.0, machine["rod_inertia_about_com_kgm2"]),
        Body(machine["piston_mass_kg"], 0.0, 0.0, machine["piston_inertia_about_com_kgm2"]),
    )
    motion = slider_crank(case.crank_angle, geometry)
    load = force_on_slider(motion, geometry, gas_force(case))
    forces = slider_crank_forces(motion, geometry, bodies, load, steady(machine))
    joints = SLIDER_CRANK.by_joint(forces.joints)
    by_work = torque_of_work(
        KINDS.named("slider_crank").dynamics, motion, geometry, bodies, load, steady(machine), forces
    )
    for torque in (forces.driving_torque, by_work):
        case.compare(
            {
                **both("F_wrist_on_piston", joints["wrist_pin"]),
                **both("F_crankpin_on_crank", joints["crank_pin"], -1.0),
                **both("F_main_on_crank", joints["main_bearing"]),
                "N_wall_on_piston_y_N": joints["guide"].y,
                "T_drive_Nm": torque,
            },
            rel_to_peak=CLOSE,
        )


@pytest.mark.parametrize("name", ["crank_rocker_inertia", "crank_rocker_loaded"])
def test_crank_rocker(name):
    case = ReferenceCase.load(name)
    machine = case.machine
    geometry = CrankRocker(
        machine["crank_length_m"],
        machine["coupler_length_m"],
        machine["rocker_length_m"],
        machine["ground_length_m"],
        1.0,
    )
    bodies = tuple(
        Body(machine[f"{link}_mass_kg"], *machine[f"{link}_com_m"], machine[f"{link}_inertia_about_com_kgm2"])
        for link in ("crank", "coupler", "rocker")
    )
    motion = crank_rocker(case.crank_angle, geometry)
    conditions = steady(machine)
    viscous = machine["rocker_viscous_Nms_per_rad"] * motion.rocker.angle.first * conditions.drive.speed
    load = torque_on_rocker(motion, geometry, machine["rocker_load_torque_Nm"] - viscous)
    forces = crank_rocker_forces(motion, geometry, bodies, load, conditions)
    joints = CRANK_ROCKER.by_joint(forces.joints)
    inertia = CRANK_ROCKER.reduced(motion, geometry, bodies, load, conditions.gravity).inertia
    by_work = torque_of_work(KINDS.named("crank_rocker").dynamics, motion, geometry, bodies, load, conditions, forces)
    for torque in (forces.driving_torque, by_work):
        case.compare(
            {
                **both("F_O2_on_crank", joints["main_bearing"]),
                **both("F_A_on_coupler", joints["crank_pin"]),
                **both("F_B_on_rocker", joints["joint"]),
                **both("F_O4_on_rocker", joints["pivot"]),
                "T_drive_Nm": torque,
                "J_red_kgm2": inertia.value,
                "dJ_red_dphi_kgm2_per_rad": inertia.first,
            },
            rel_to_peak=CLOSE,
        )


def test_articulated_pair():
    """The slave's shares added to the master's own, and the master solved under the slave's load, are both right."""
    case = ReferenceCase.load("articulated_v_inertia")
    machine = case.machine
    gamma = np.deg2rad(machine["vee_angle_deg"])
    master = SliderCrank(machine["crank_radius_m"], machine["master_rod_length_m"], 0.0)
    geometry = ArticulatedRod(
        master,
        machine["knuckle_radius_m"],
        np.deg2rad(machine["knuckle_angle_deg"]),
        gamma,
        machine["link_rod_length_m"],
        0.0,
    )
    piston = Body(machine["piston_mass_kg"], 0.0, 0.0, machine["piston_inertia_about_com_kgm2"])
    link = Body(
        machine["link_rod_mass_kg"],
        machine["link_rod_com_from_knuckle_m"],
        0.0,
        machine["link_rod_inertia_about_com_kgm2"],
    )
    bodies = (
        Body(machine["crank_mass_kg"], machine["crank_com_x_m"], 0.0, machine["crank_inertia_about_com_kgm2"]),
        Body(machine["master_rod_mass_kg"], *machine["master_rod_com_m"], machine["master_rod_inertia_about_com_kgm2"]),
        piston,
    )
    conditions = steady(machine)
    motion = articulated_rod(case.crank_angle, geometry)
    own = slider_crank(case.crank_angle, master)
    slave_bodies, slave_load = (link, piston), articulated_rod_load(motion, geometry, 0.0)
    slave = articulated_rod_forces(motion, geometry, slave_bodies, slave_load, conditions)
    slave_joints = ARTICULATED_ROD.by_joint(slave.joints)
    unloaded = force_on_slider(own, master, 0.0)
    loaded = (unloaded[0], on_master_rod(motion, geometry, slave_joints["knuckle"]), unloaded[2])
    alone = slider_crank_forces(own, master, bodies, unloaded, conditions)
    alone_joints = SLIDER_CRANK.by_joint(alone.joints)
    whole = slider_crank_forces(own, master, bodies, loaded, conditions)
    shares = {
        "main_bearing": (alone_joints["main_bearing"], slave_joints["main_bearing"]),
        "crank_pin": (alone_joints["crank_pin"], slave_joints["crank_pin"]),
        "wrist_pin": (alone_joints["wrist_pin"], slave_joints["master_wrist_pin"]),
        "guide": (alone_joints["guide"], slave_joints["master_guide"]),
    }
    summed = {name: added(one, turned_wrench(share, -gamma)) for name, (one, share) in shares.items()}
    for joints in (SLIDER_CRANK.by_joint(whole.joints), summed):
        case.compare(
            {
                **both("F_wrist1_on_piston1", joints["wrist_pin"]),
                **both("F_wrist2_on_piston2", turned_wrench(slave_joints["wrist_pin"], -gamma)),
                **both("F_knuckle_on_link", turned_wrench(slave_joints["knuckle"], -gamma)),
                **both("F_main_on_crank", joints["main_bearing"]),
                **both("F_crankpin_on_crank", joints["crank_pin"], -1.0),
                "N1_N": joints["guide"].y,
                "N2_N": slave_joints["guide"].y,
            },
            rel_to_peak=CLOSE,
        )
    of_slave, of_master = (KINDS.named(name).dynamics for name in ("articulated_rod", "slider_crank"))
    slave_by_work = torque_of_work(of_slave, motion, geometry, slave_bodies, slave_load, conditions, slave)
    for torque in (
        whole.driving_torque,
        alone.driving_torque + slave.driving_torque,
        torque_of_work(of_master, own, master, bodies, unloaded, conditions, alone) + slave_by_work,
        torque_of_work(of_master, own, master, bodies, loaded, conditions, whole),
    ):
        case.compare({"T_drive_Nm": torque}, rel_to_peak=CLOSE)


def test_opposed_pistons_on_one_shaft():
    case = ReferenceCase.load("opposed_one_shaft")
    machine = case.machine
    shaft = Body(machine["crank_mass_kg"], *machine["crank_com_m"], machine["crank_inertia_about_com_kgm2"])
    found = {}
    for name, ahead, crank in (("lower", 0.0, shaft), ("upper", np.deg2rad(machine["throw_angle_deg"]), NOTHING)):
        geometry = SliderCrank(machine[f"{name}_crank_radius_m"], machine[f"{name}_rod_length_m"], 0.0)
        rod = Body(
            machine[f"{name}_rod_mass_kg"],
            machine[f"{name}_rod_com_from_crankpin_m"],
            0.0,
            machine[f"{name}_rod_inertia_about_com_kgm2"],
        )
        bodies = (crank, rod, Body(machine[f"{name}_piston_mass_kg"], 0.0, 0.0, 0.0))
        motion = slider_crank(case.crank_angle + ahead, geometry)
        load = force_on_slider(motion, geometry, 0.0)
        found[name] = slider_crank_forces(motion, geometry, bodies, load, steady(machine))
    one, other = found["lower"], found["upper"]
    one_joints, other_joints = (SLIDER_CRANK.by_joint(each.joints) for each in (one, other))
    case.compare(
        {
            **both("F_wrist1_on_piston1", one_joints["wrist_pin"]),
            **both("F_wrist2_on_piston2", other_joints["wrist_pin"]),
            **both("F_main_on_crank", added(one_joints["main_bearing"], other_joints["main_bearing"])),
            **both("F_pin1_on_crank", one_joints["crank_pin"], -1.0),
            **both("F_pin2_on_crank", other_joints["crank_pin"], -1.0),
            "N1_N": one_joints["guide"].y,
            "N2_N": other_joints["guide"].y,
            "T_drive_Nm": one.driving_torque + other.driving_torque,
        },
        rel_to_peak=CLOSE,
    )


def test_opposed_pistons_on_two_shafts():
    """The second shaft's own axes are turned by half a turn; its crank is `lead` ahead."""
    case = ReferenceCase.load("opposed_two_shafts")
    machine = case.machine
    assert machine["same_direction"]
    geometry = SliderCrank(machine["crank_radius_m"], machine["rod_length_m"], 0.0)
    bodies = (
        Body(machine["crank_mass_kg"], *machine["crank_com_m"], machine["crank_inertia_about_com_kgm2"]),
        Body(machine["rod_mass_kg"], machine["rod_com_from_crankpin_m"], 0.0, machine["rod_inertia_about_com_kgm2"]),
        Body(machine["piston_mass_kg"], 0.0, 0.0, machine["piston_inertia_about_com_kgm2"]),
    )
    force = gas_force(case)

    def forces(ahead):
        motion = slider_crank(case.crank_angle + ahead, geometry)
        load = force_on_slider(motion, geometry, force)
        return slider_crank_forces(motion, geometry, bodies, load, steady(machine))

    one, other = forces(0.0), forces(np.deg2rad(machine["lead_deg"]))
    one_joints, other_joints = (SLIDER_CRANK.by_joint(each.joints) for each in (one, other))
    case.compare(
        {
            **both("F_wrist1_on_piston1", one_joints["wrist_pin"]),
            **both("F_wrist2_on_piston2", other_joints["wrist_pin"], -1.0),
            **both("F_main1_on_crank", one_joints["main_bearing"]),
            **both("F_main2_on_crank2", other_joints["main_bearing"], -1.0),
            "T_gear_on_crank2_Nm": other.driving_torque,
            "T_drive_total_on_crank1_Nm": one.driving_torque + other.driving_torque,
        },
        rel_to_peak=CLOSE,
    )
