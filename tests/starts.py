"""Two machines that start: the reference crank-rocker, and a heavier one behind a gear of 40:1, by cage motors."""

import math

import numpy as np
from tests.mechanism_in_time import Mechanism, OutputLoad, machine_of

from cranktrain.linkage.forces import Body, Gravity
from cranktrain.mechanisms import KINDS
from cranktrain.mechanisms.crank_rocker.kinematics import CrankRocker
from cranktrain.transient.equation import DriveTrain, Kernels, no_brake, untimed
from cranktrain.transient.gearing import stages

SYNCHRONOUS = 50 * math.pi


def kloss(speed, motor):
    """Simplified: breakdown torque, breakdown slip, synchronous speed."""
    s = 1 - speed / motor[2]
    return np.sign(motor[2]) * 2 * motor[0] * s * motor[1] / (s * s + motor[1] * motor[1])


def rotor_heat(speed, _time, motor):
    return kloss(speed, motor) * (motor[2] - speed)


def kernels(is_compiled=True):
    return Kernels(machine_of(KINDS.named("crank_rocker"), is_compiled), untimed(kloss), rotor_heat, no_brake)


def reference_drive(machine):
    """Of the case `startup_crank_rocker`."""
    bodies = tuple(
        Body(machine[f"{part}_mass_kg"], *machine[f"{part}_com_m"], machine[f"{part}_inertia_about_com_kgm2"])
        for part in ("crank", "coupler", "rocker")
    )
    lengths = (machine[f"{part}_length_m"] for part in ("crank", "coupler", "rocker", "ground"))
    load = OutputLoad(machine["rocker_load_torque_Nm"], 0.0, machine["rocker_viscous_Nms_per_rad"])
    motor = tuple(machine[f"{part}"] for part in ("breakdown_torque_Nm", "breakdown_slip", "synchronous_speed_rad_s"))
    gearing = stages(machine["motor_rotor_inertia_kgm2"], (machine["gear_ratio"], 1.0, 1.0, 0.0, 0.0))
    mechanism = Mechanism(CrankRocker(*lengths, 1.0), bodies, load, Gravity(*machine["gravity_m_s2"]))
    return DriveTrain(mechanism, motor, 0.0, gearing)


def heavy_drive(breakdown, efficiency=1.0, slip=0.2, load=-2000.0, backward=None, dry=0.0, viscous=0.0):
    """A rocker of 50 kg·m² with an active load of 2000 N·m against its increasing angle."""
    bodies = (Body(0.0, 0.0, 0.0, 2.0), Body(60.0, 0.33, 0.02, 3.2), Body(0.0, 0.0, 0.0, 50.0))
    geometry = CrankRocker(0.25, 0.70, 0.50, 0.80, 1.0)
    mechanism = Mechanism(geometry, bodies, OutputLoad(load, dry, viscous), Gravity(0.0, 0.0))
    back = efficiency if backward is None else backward
    return DriveTrain(mechanism, (breakdown, slip, SYNCHRONOUS), 0.0, stages(0.02, (40.0, efficiency, back, 0.0, 0.0)))


def wheel(_angle, _speed, sense, numbers):
    """A machine of constant inertia, with an active and a dry load: J, load, dry."""
    return numbers[0], 0.0, numbers[1] + numbers[2] * sense, 1.0


def start_angle():
    return np.pi / 3
