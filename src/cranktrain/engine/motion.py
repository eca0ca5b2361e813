"""Motion of pistons: displacement and its derivatives by the crank angle; with the speed, velocities."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from cranktrain.catalogue import quantity
from cranktrain.checks import Check
from cranktrain.engine.dead_centres import DeadCentres, PistonTurn, slider_motion
from cranktrain.engine.distinct import Distinct
from cranktrain.engine.layout import CrankAngle, Pistons, Speed
from cranktrain.language import N_, _
from cranktrain.motion import Array
from cranktrain.numerics import DERIVATIVES_LIMIT, Extreme, derivatives_residual, extremes
from cranktrain.wording import Names, number, shared

_PISTON = ("piston",)
_CURVE = ("piston", "crank_angle")
_THEORY = "docs/theory/slider-crank"
_FASTEST = 40.0
"""Mean piston speed that none has; racing engines come to 27. [m/s]"""


@dataclass(frozen=True, eq=False)
class PistonMotion:
    """Motion of every piston by the crank angle alone; speed enters with `PistonSpeeds`."""

    piston_displacement: Array = quantity(
        "x", "m", _CURVE, N_("Travel of the piston from its true top toward the shaft"), _THEORY
    )
    piston_velocity_coefficient: Array = quantity(
        "x′", "m/rad", _CURVE, N_("Piston velocity for each rad/s of the crank"), _THEORY
    )
    piston_acceleration_coefficient: Array = quantity(
        "x″", "m/rad^2", _CURVE, N_("Piston acceleration for each (rad/s)² of the crank"), _THEORY
    )
    checks: tuple[Check, ...] = ()


def piston_motion(
    pistons: Pistons, crank_angle: CrankAngle, turn: PistonTurn, dead_centres: DeadCentres
) -> PistonMotion:
    """Displacement from the true top toward the shaft and its derivatives."""
    motion = slider_motion(pistons, crank_angle.angle)
    return PistonMotion(
        piston_displacement=dead_centres.top_position[..., np.newaxis] - motion.value,
        piston_velocity_coefficient=-motion.first,
        piston_acceleration_coefficient=-motion.second,
        checks=(_derivatives_check(turn.distinct),),
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


@dataclass(frozen=True, eq=False)
class PistonSpeeds:
    """Velocities and accelerations of pistons at the declared, constant speed."""

    piston_velocity: Array = quantity("v", "m/s", _CURVE, N_("Piston velocity toward the shaft"), _THEORY)
    piston_acceleration: Array = quantity("j", "m/s^2", _CURVE, N_("Piston acceleration toward the shaft"), _THEORY)
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
    flags: tuple[str, ...] = ()

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

    mean_speed = dead_centres.stroke * (omega / np.pi)[..., 0]
    return PistonSpeeds(
        piston_velocity=motion.piston_velocity_coefficient * omega,
        piston_acceleration=motion.piston_acceleration_coefficient * omega**2,
        mean_piston_speed=mean_speed,
        largest_piston_speed=scaled(fastest, omega),
        largest_piston_speed_at=at(fastest),
        smallest_piston_velocity=scaled(slowest, omega),
        smallest_piston_velocity_at=at(slowest),
        largest_piston_acceleration=scaled(most, omega**2),
        largest_piston_acceleration_at=at(most),
        smallest_piston_acceleration=scaled(least, omega**2),
        smallest_piston_acceleration_at=at(least),
        flags=tuple(_speed_flags(mean_speed)),
    )


def _speed_flags(mean_speed: Array) -> Iterator[str]:
    """Doubt a stroke or a speed with which no piston runs."""
    if np.any(mean_speed > _FASTEST):
        yield _("A mean piston speed of {speed} is more than any piston bears: are speed and stroke right?").format(
            speed=number(float(np.max(mean_speed)), "m/s")
        )
