"""Motion of the rods that pistons hang on: angles, their derivatives, pressure angles; with the speed, velocities."""

import numpy as np

from cranktrain.catalogue import quantity
from cranktrain.language import N_
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.mechanisms import Mechanisms, Pistons
from cranktrain.layout.speed import Speed, accelerations
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import turning_points
from cranktrain.questions.motion.dead_centres import PistonGrid, PistonTurn, rod_angle
from cranktrain.record import record

_PISTON = ("piston",)
_CURVE = ("piston", "crank_angle")
_THEORY = "docs/theory/slider-crank"
_GROUPS = "docs/theory/groups"


@record
class RodMotion:
    """Motion of every piston's rod by the crank angle alone; NaN for a piston that hangs on none."""

    rod_angle: Array = quantity(
        "θ",
        "rad",
        _CURVE,
        N_("Direction of the rod, from its crank-side pin to the piston pin, from the cylinder's axis"),
        _GROUPS,
    )
    rod_velocity_coefficient: Array = quantity(
        "θ′", "rad/rad", _CURVE, N_("Rod's angular velocity for each rad/s of the crank"), _GROUPS
    )
    rod_acceleration_coefficient: Array = quantity(
        "θ″", "rad/rad^2", _CURVE, N_("Rod's angular acceleration for each (rad/s)² of the crank"), _GROUPS
    )
    largest_pressure_angle: Array = quantity(
        "β_max",
        "rad",
        _PISTON,
        N_("Largest angle between rod and cylinder axis; positive where the crank-side pin stands toward +y"),
        _THEORY,
    )
    largest_pressure_angle_at: Array = quantity(
        "φ(β_max)", "deg", _PISTON, N_("Crank angle of the largest pressure angle"), _THEORY
    )
    opposite_pressure_angle: Array = quantity(
        "β_opp", "rad", _PISTON, N_("Largest angle between rod and cylinder axis to the other side"), _THEORY
    )
    opposite_pressure_angle_at: Array = quantity(
        "φ(β_opp)", "deg", _PISTON, N_("Crank angle of the largest pressure angle to the other side"), _THEORY
    )


def _rod(pistons: Mechanisms, angle: Array) -> Coefficient:
    """Evaluate every piston's rod at φ."""
    return pistons.evaluated(lambda motion: rod_angle(motion, motion.slider), angle)


def on_rods(pistons: Pistons) -> bool:
    """Whether any piston hangs on a rod."""
    return bool(np.any(pistons.has_rod))


def rod_motion(grid: PistonGrid, crank_angle: CrankAngle, turn: PistonTurn) -> RodMotion:
    """Rod angles, their derivatives and extremes."""
    motion = grid.value
    different = turn.distinct
    opposite, usual = turning_points(
        lambda alpha: Coefficient(*(-part for part in _rod(different.mechanisms, alpha))), -turn.samples.rod
    )
    # Without an offset both are alike but for rounding, which must not choose.
    is_usual = different.spread(usual.value) >= -different.spread(opposite.value) * (1 - 1e-12)
    angles = [different.spread(one.value)[..., 0] for one in (usual, opposite)]
    places = [crank_angle.counted(different.angle(one.angle))[..., 0] for one in (usual, opposite)]
    return RodMotion(
        rod_angle=motion.rod,
        rod_velocity_coefficient=motion.rod_first,
        rod_acceleration_coefficient=motion.rod_second,
        largest_pressure_angle=np.where(is_usual[..., 0], *angles),
        largest_pressure_angle_at=np.where(is_usual[..., 0], *places),
        opposite_pressure_angle=np.where(is_usual[..., 0], *reversed(angles)),
        opposite_pressure_angle_at=np.where(is_usual[..., 0], *reversed(places)),
    )


@record
class RodSpeeds:
    """Angular velocities and accelerations of the rods."""

    rod_angular_velocity: Array = quantity("ω_r", "rad/s", _CURVE, N_("Angular velocity of the rod"), _GROUPS)
    rod_angular_acceleration: Array = quantity("ε_r", "rad/s^2", _CURVE, N_("Angular acceleration of the rod"), _GROUPS)


def rod_speeds(motion: RodMotion, speed: Speed, crank_angle: CrankAngle) -> RodSpeeds:
    """Velocities θ′ω and accelerations θ″ω² + θ′ε."""
    drive = speed.drive(crank_angle.angle)
    return RodSpeeds(
        rod_angular_velocity=motion.rod_velocity_coefficient * drive.speed,
        rod_angular_acceleration=accelerations(
            motion.rod_velocity_coefficient, motion.rod_acceleration_coefficient, drive
        ),
    )
