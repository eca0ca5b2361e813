"""Torque that turns the crank at its declared speed, constant over the turn, at every shaft of its drive."""

import numpy as np

from cranktrain.language import N_
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.drive.declared import DeclaredDrive
from cranktrain.layout.speed import Speed
from cranktrain.motion import ONE, Array
from cranktrain.numerics import Extreme
from cranktrain.questions.reduction.at_angles import reduced_at
from cranktrain.questions.reduction.gear_train import torque_through
from cranktrain.questions.reduction.machines import ReducedMachines
from cranktrain.questions.reduction.static_torques import THEORY, together, torque_facts
from cranktrain.record import record
from cranktrain.saying.catalogue import extreme, quantity
from cranktrain.saying.checks import StageResult
from cranktrain.transient.gearing import overall_ratio

_SHAFT = ("drive_shaft",)


@record
class ConstantSpeedDrive(StageResult):
    """What the drive must give so that the crank turns at its declared speed all over the turn."""

    constant_speed_torque: Array = quantity(
        "M_ω",
        "N*m",
        ("drive_shaft", "crank_angle"),
        N_("Torque at each shaft of the drive that turns the crank at its declared speed, constant over the turn"),
        THEORY,
        "31.13",
    )
    largest_constant_speed_torque: Extreme = extreme(
        "M_ω,max",
        "N*m",
        _SHAFT,
        N_("Largest torque at constant speed"),
        N_("Crank angle of the largest torque at constant speed"),
        THEORY,
        "31.13",
        worst="largest",
        of="constant_speed_torque",
    )
    smallest_constant_speed_torque: Extreme = extreme(
        "M_ω,min",
        "N*m",
        _SHAFT,
        N_("Smallest torque at constant speed, or largest that drives"),
        N_("Crank angle of the smallest torque at constant speed"),
        THEORY,
        "31.13",
        worst="smallest",
        of="constant_speed_torque",
    )
    mean_constant_speed_torque: Array = quantity(
        "M_ω,mean", "N*m", _SHAFT, N_("Mean torque at constant speed"), THEORY, "31.13"
    )
    rms_constant_speed_torque: Array = quantity(
        "M_ω,rms", "N*m", _SHAFT, N_("Root mean square of the torque at constant speed"), THEORY, "31.13"
    )
    constant_motor_speed: Array = quantity(
        "ω_m0", "rad/s", (), N_("Speed of the motor at constant speed, by the ratio"), THEORY, "31.13", shown="rpm"
    )
    constant_speed_power: Array = quantity(
        "P_ω", "W", (), N_("Mean power of the motor at constant speed"), THEORY, "31.14"
    )


def constant_speed_drive(
    drive: DeclaredDrive, machines: ReducedMachines, crank_angle: CrankAngle, speed: Speed
) -> ConstantSpeedDrive:
    """Reduce loads and the inertia of the mechanism to every shaft of the drive, at the declared speed.

    Notes
    -----
    docs/theory/reduced-machine, eqs. (31.13) and (31.14). What turns at a constant speed takes no torque.
    """
    n_designs = len(drive.gearings)
    grid = np.broadcast_to(crank_angle.angle[:, 0], (n_designs, crank_angle.shown.size))
    speeds, zeros = speed.value[:, 0, 0], crank_angle.zero[:, 0, 0]
    corners = np.broadcast_to(machines.corners, (n_designs, machines.corners.shape[-1]))
    turned: list[float] = [float(one) for one in speeds]
    rows = list(zip(machines.each, drive.gearings, turned, strict=True))
    curves = [
        torque_through(reduced_at(machine, grid[n]).taken(0.0 * grid[n] + turning), ONE, gearing)
        for n, (machine, gearing, turning) in enumerate(rows)
    ]
    facts = [
        torque_facts(machine, own, machines.cycle, gearing, zero=float(zero), grid=crank_angle.shown, speed=turning)
        for (machine, gearing, turning), own, zero in zip(rows, corners, zeros, strict=True)
    ]
    at_motor = speeds * np.array([overall_ratio(gearing) for gearing in drive.gearings])
    mean = np.stack([own.mean for own in facts])
    return ConstantSpeedDrive(
        labels={"drive_shaft": drive.shafts},
        constant_speed_torque=np.stack(curves),
        largest_constant_speed_torque=together([own.largest for own in facts]),
        smallest_constant_speed_torque=together([own.smallest for own in facts]),
        mean_constant_speed_torque=mean,
        rms_constant_speed_torque=np.stack([own.rms for own in facts]),
        constant_motor_speed=at_motor,
        constant_speed_power=at_motor * mean[:, 0],
    )


def turns_evenly(drive: DeclaredDrive | None, speed: Speed | None) -> bool:
    """Whether a driven crank has a declared speed that is to be constant: no wanted motion, no second run."""
    return drive is not None and speed is not None and speed.curve is None
