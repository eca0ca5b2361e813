"""Motion of the rods that drive rockers: angles and their derivatives; with the speed, velocities."""

import numpy as np

from cranktrain.language import N_
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.mechanisms import Rockers
from cranktrain.layout.speed import Speed, rates
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import unwrapped
from cranktrain.questions.motion.dead_centres import rod_angle
from cranktrain.questions.motion.grid_motion import GridMotion
from cranktrain.record import record
from cranktrain.references import THEORY_OF_CRANK_ROCKERS as _THEORY
from cranktrain.references import THEORY_OF_GROUPS as _GROUPS
from cranktrain.saying.catalogue import coefficients, quantity

_CURVE = ("rocker", "crank_angle")


@record
class CouplerMotion:
    """Motion of every rocker's rod by the crank angle alone; NaN for a rocker that hangs on none."""

    coupler_angle: Coefficient = coefficients(
        "θ_r",
        "rad",
        _CURVE,
        N_("Direction of the rod, from crank pin to joint, from the mechanism's x"),
        N_("Rod's angular velocity for each rad/s of the crank"),
        N_("Rod's angular acceleration for each (rad/s)² of the crank"),
        _THEORY,
        "3.1 to 3.3",
    )


def on_rods(rockers: Rockers) -> bool:
    """Whether any rocker hangs on a rod."""
    return bool(np.any(rockers.has_rod))


def coupler_motion(rockers: Rockers, motion: GridMotion) -> CouplerMotion:
    """Angles of the rods, without jumps, and their derivatives."""
    rod = motion.of(rockers, lambda own: rod_angle(own, own.rocker.angle))
    return CouplerMotion(rod._replace(value=unwrapped(rod.value)))


@record
class CouplerSpeeds:
    """Angular velocities and accelerations of the rods."""

    coupler_angular_velocity: Array = quantity(
        "ω_2", "rad/s", _CURVE, N_("Angular velocity of the rod"), _GROUPS, "1.17"
    )
    coupler_angular_acceleration: Array = quantity(
        "ε_2", "rad/s^2", _CURVE, N_("Angular acceleration of the rod"), _GROUPS, "1.17"
    )


def coupler_speeds(motion: CouplerMotion, speed: Speed, crank_angle: CrankAngle) -> CouplerSpeeds:
    """Velocities θ′ω and accelerations θ″ω² + θ′ε."""
    return CouplerSpeeds(*rates(motion.coupler_angle, speed.drive(crank_angle.angle)))
