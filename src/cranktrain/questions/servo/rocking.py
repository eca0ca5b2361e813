"""Results of a wanted motion whose crank swings between two angles: facts, and its course over time."""

import numpy as np

from cranktrain.language import N_
from cranktrain.layout.drive.declared import DeclaredDrive
from cranktrain.layout.wish.declared import RockingMotions
from cranktrain.layout.wish.following import CrankMotion, Rocking, rocking_crank
from cranktrain.motion import Array
from cranktrain.questions.reduction.machines import ReducedMachines
from cranktrain.questions.servo.demand import ServoDemand, rocking_demand
from cranktrain.questions.servo.stages import THEORY
from cranktrain.record import record
from cranktrain.references import THEORY_OF_TRANSIENTS as _TRANSIENTS
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import StageResult

_N_TIMES = 720


@record
class RockingCrank(StageResult):
    """How a rocking crank moves; courses, of each design, at 721 times of a period from its beginning to its end."""

    courses: tuple[CrankMotion, ...]
    rocking_period: Array = quantity("T_r", "s", (), N_("Period of the rocking motion"), THEORY, "definition")
    least_rocking_angle: Array = quantity(
        "φ_r,min", "deg", (), N_("Least angle of the rocking crank, φ"), THEORY, "29.10", is_place=True
    )
    greatest_rocking_angle: Array = quantity(
        "φ_r,max", "deg", (), N_("Greatest angle of the rocking crank, φ"), THEORY, "29.10", is_place=True
    )
    largest_rocking_speed: Array = quantity(
        "ω_r", "rad/s", (), N_("Largest speed of the rocking crank"), THEORY, "29.3", shown="rpm"
    )
    largest_rocking_acceleration: Array = quantity(
        "ε_r", "rad/s^2", (), N_("Largest angular acceleration of the rocking crank"), THEORY, "29.3"
    )


def rocking_course(rocking: RockingMotions) -> RockingCrank:
    """Angle, speed and acceleration of rocking cranks over their period.

    Notes
    -----
    docs/theory/servo, eq. (29.3).
    """
    courses = tuple(_course(made) for made in rocking.each)
    return RockingCrank(
        courses,
        rocking_period=np.array([made.wanted.period for made in rocking.each]),
        least_rocking_angle=np.array([np.min(one.angle) for one in courses]),
        greatest_rocking_angle=np.array([np.max(one.angle) for one in courses]),
        largest_rocking_speed=np.array([np.max(np.abs(one.speed)) for one in courses]),
        largest_rocking_acceleration=np.array([np.max(np.abs(one.acceleration)) for one in courses]),
    )


def _course(made: Rocking) -> CrankMotion:
    """How the crank moves over a period, both its ends."""
    period = made.wanted.period
    # At the period's end the motion is as at its beginning.
    return rocking_crank(made, np.linspace(0.0, period, _N_TIMES + 1))


@record
class RockingDrive(StageResult):
    """What the motor of a rocking crank must do; demands, of each design, over time."""

    demands: tuple[ServoDemand, ...]
    rocking_rms_torque: Array = quantity(
        "M_r,rms",
        "N*m",
        (),
        N_("Root mean square over time of the motor's torque for the rocking motion"),
        THEORY,
        "29.8",
    )
    rocking_peak_torque: Array = quantity(
        "M_r,max", "N*m", (), N_("Largest size of the motor's torque for the rocking motion"), THEORY, "29.8"
    )
    rocking_peak_power: Array = quantity(
        "P_r,max",
        "W",
        (),
        N_("Largest power of the motor for the rocking motion, driving or braking"),
        _TRANSIENTS,
        "26.10",
    )


def rocking_drive(rocking: RockingMotions, drive: DeclaredDrive, machines: ReducedMachines) -> RockingDrive:
    """Torque, power and heat of a motor that makes a crank rock.

    Notes
    -----
    docs/theory/servo, eq. (29.8).
    """
    rows = zip(rocking.each, machines.each, drive.gearings, strict=True)
    demands = tuple(rocking_demand(*row, machines.corners[n]) for n, row in enumerate(rows))
    return RockingDrive(
        demands,
        rocking_rms_torque=np.array([one.rms for one in demands]),
        rocking_peak_torque=np.array([one.peak_torque for one in demands]),
        rocking_peak_power=np.array([one.peak_power for one in demands]),
    )


def is_rocking(rocking: RockingMotions | None) -> bool:
    """Whether a crank is to rock: nobody else misses what it would give."""
    return rocking is not None
