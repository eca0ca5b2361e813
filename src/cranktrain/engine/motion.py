"""Motion of pistons: displacement and its derivatives by the crank angle; with the speed, velocities."""

from dataclasses import dataclass

import numpy as np

from cranktrain.catalogue import quantity
from cranktrain.checks import Check
from cranktrain.engine.dead_centres import DeadCentres, PistonTurn, slider_and_rod, slider_motion
from cranktrain.engine.distinct import Distinct
from cranktrain.engine.layout import CrankAngle, Pistons, Speed
from cranktrain.language import N_, _
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import DERIVATIVES_LIMIT, Extreme, derivatives_residual, extremes, turning_points
from cranktrain.wording import Names, shared

_PISTON = ("piston",)
_CURVE = ("piston", "crank_angle")
_THEORY = "docs/theory/slider-crank"
_GROUPS = "docs/theory/groups"


@dataclass(frozen=True)
class PistonMotion:
    """Motion of every piston and rod by the crank angle alone; speed enters with `PistonSpeeds`."""

    piston_displacement: Array = quantity(
        "x", "m", _CURVE, N_("Travel of the piston from its true top toward the shaft"), _THEORY
    )
    piston_velocity_coefficient: Array = quantity(
        "x′", "m/rad", _CURVE, N_("Piston velocity for each rad/s of the crank"), _THEORY
    )
    piston_acceleration_coefficient: Array = quantity(
        "x″", "m/rad^2", _CURVE, N_("Piston acceleration for each (rad/s)² of the crank"), _THEORY
    )
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
    checks: tuple[Check, ...] = ()


def piston_motion(
    pistons: Pistons, crank_angle: CrankAngle, turn: PistonTurn, dead_centres: DeadCentres
) -> PistonMotion:
    """Displacement from the true top toward the shaft, rod angle, and their derivatives."""
    motion = slider_and_rod(pistons, crank_angle.angle)
    different = turn.distinct
    opposite, usual = turning_points(
        lambda alpha: Coefficient(*(-part for part in slider_and_rod(different.mechanisms, alpha)[3:])),
        -turn.samples.rod,
    )
    # Without an offset both are alike but for rounding, which must not choose.
    is_usual = different.spread(usual.value) >= -different.spread(opposite.value) * (1 - 1e-12)
    angles = [different.spread(one.value)[..., 0] for one in (usual, opposite)]
    places = [crank_angle.counted(different.angle(one.angle))[..., 0] for one in (usual, opposite)]
    return PistonMotion(
        piston_displacement=dead_centres.top_position[..., np.newaxis] - motion.position,
        piston_velocity_coefficient=-motion.position_first,
        piston_acceleration_coefficient=-motion.position_second,
        rod_angle=motion.rod,
        rod_velocity_coefficient=motion.rod_first,
        rod_acceleration_coefficient=motion.rod_second,
        largest_pressure_angle=np.where(is_usual[..., 0], *angles),
        largest_pressure_angle_at=np.where(is_usual[..., 0], *places),
        opposite_pressure_angle=np.where(is_usual[..., 0], *reversed(angles)),
        opposite_pressure_angle_at=np.where(is_usual[..., 0], *reversed(places)),
        checks=(_derivatives_check(different),),
    )


def _derivatives_check(pistons: Distinct) -> Check:
    """Compare x′ and x″ with the derivatives of the Fourier series of x and x′, which know no mechanism formula."""
    residual = derivatives_residual(lambda alpha: slider_motion(pistons.mechanisms, alpha))
    return Check(
        "piston_derivatives",
        _("x′ and x″ against the derivatives of the Fourier series of x and x′, relative to their peaks"),
        np.max(pistons.spread(residual), axis=(1, 2)),
        DERIVATIVES_LIMIT,
    )


@dataclass(frozen=True)
class PistonSpeeds:
    """Velocities and accelerations of pistons and rods at the declared, constant speed."""

    piston_velocity: Array = quantity("v", "m/s", _CURVE, N_("Piston velocity toward the shaft"), _THEORY)
    piston_acceleration: Array = quantity("j", "m/s^2", _CURVE, N_("Piston acceleration toward the shaft"), _THEORY)
    rod_angular_velocity: Array = quantity("ω_r", "rad/s", _CURVE, N_("Angular velocity of the rod"), _GROUPS)
    rod_angular_acceleration: Array = quantity("ε_r", "rad/s^2", _CURVE, N_("Angular acceleration of the rod"), _GROUPS)
    mean_piston_speed: Array = quantity("c_m", "m/s", _PISTON, N_("Mean piston speed, 2 S n"), _THEORY)
    largest_piston_speed: Array = quantity(
        "v_max", "m/s", _PISTON, N_("Largest piston velocity toward the shaft"), _THEORY
    )
    largest_piston_speed_at: Array = quantity(
        "φ(v_max)",
        "deg",
        _PISTON,
        N_("Crank angle of the largest velocity toward the shaft"),
        _THEORY,
    )
    smallest_piston_velocity: Array = quantity(
        "v_min", "m/s", _PISTON, N_("Largest piston velocity away from the shaft, negative"), _THEORY
    )
    smallest_piston_velocity_at: Array = quantity(
        "φ(v_min)",
        "deg",
        _PISTON,
        N_("Crank angle of the largest velocity away from the shaft"),
        _THEORY,
    )
    largest_piston_acceleration: Array = quantity(
        "j_max", "m/s^2", _PISTON, N_("Largest piston acceleration toward the shaft"), _THEORY
    )
    largest_piston_acceleration_at: Array = quantity(
        "φ(j_max)",
        "deg",
        _PISTON,
        N_("Crank angle of the largest acceleration toward the shaft"),
        _THEORY,
    )
    smallest_piston_acceleration: Array = quantity(
        "j_min",
        "m/s^2",
        _PISTON,
        N_("Largest piston acceleration away from the shaft, negative"),
        _THEORY,
    )
    smallest_piston_acceleration_at: Array = quantity(
        "φ(j_min)",
        "deg",
        _PISTON,
        N_("Crank angle of the largest acceleration away from the shaft"),
        _THEORY,
    )

    def answer(self, names: Names, design: int) -> str:
        """Say mean and largest piston speeds."""
        pistons = names["piston"]
        return _("Mean piston speed {mean}, largest {largest}; largest acceleration {acceleration}.").format(
            mean=shared(pistons, self.mean_piston_speed[design], "m/s"),
            largest=shared(pistons, self.largest_piston_speed[design], "m/s"),
            acceleration=shared(pistons, self.largest_piston_acceleration[design], "m/s^2"),
        )


def piston_speeds(
    crank_angle: CrankAngle, turn: PistonTurn, motion: PistonMotion, dead_centres: DeadCentres, speed: Speed
) -> PistonSpeeds:
    """Velocities q′ω and accelerations q″ω² at constant speed, and their extremes."""
    omega = speed.value
    different = turn.distinct

    def velocity(alpha: Array) -> Array:
        return -slider_motion(different.mechanisms, alpha).first

    def acceleration(alpha: Array) -> Array:
        return -slider_motion(different.mechanisms, alpha).second

    slowest, fastest = extremes(velocity, acceleration, samples=-turn.samples.position_first)
    least, most = extremes(acceleration, samples=-turn.samples.position_second)

    def at(extreme: Extreme) -> Array:
        return crank_angle.counted(different.angle(extreme.angle))[..., 0]

    def scaled(extreme: Extreme, factor: Array) -> Array:
        return (different.spread(extreme.value) * factor)[..., 0]

    return PistonSpeeds(
        piston_velocity=motion.piston_velocity_coefficient * omega,
        piston_acceleration=motion.piston_acceleration_coefficient * omega**2,
        rod_angular_velocity=motion.rod_velocity_coefficient * omega,
        rod_angular_acceleration=motion.rod_acceleration_coefficient * omega**2,
        mean_piston_speed=dead_centres.stroke * (omega / np.pi)[..., 0],
        largest_piston_speed=scaled(fastest, omega),
        largest_piston_speed_at=at(fastest),
        smallest_piston_velocity=scaled(slowest, omega),
        smallest_piston_velocity_at=at(slowest),
        largest_piston_acceleration=scaled(most, omega**2),
        largest_piston_acceleration_at=at(most),
        smallest_piston_acceleration=scaled(least, omega**2),
        smallest_piston_acceleration_at=at(least),
    )
