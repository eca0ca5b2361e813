"""Motion of pistons: true dead centres, stroke, displacement and its derivatives; with the speed, velocities."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from cranktrain.catalogue import quantity
from cranktrain.checks import Check, relative
from cranktrain.engine.layout import CrankAngle, Distinct, Mechanisms, Pistons, Speed, distinct
from cranktrain.language import N_, _
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import Extreme, largest, smallest, spectral_derivative, turn_grid
from cranktrain.wording import Names, shared

_PISTON = ("piston",)
_CURVE = ("piston", "crank_angle")


class _SliderAndRod(NamedTuple):
    """Slider position and rod angle with their derivatives, flat, shape (design, piston, n)."""

    position: Array
    position_first: Array
    position_second: Array
    rod: Array
    rod_first: Array
    rod_second: Array


def _slider_and_rod(pistons: Mechanisms, angle: Array) -> _SliderAndRod:
    """Evaluate every piston's slider and rod at φ."""
    return pistons.evaluated(lambda motion: _SliderAndRod(*motion.slider, *motion.rod.angle), angle)


def slider_motion(pistons: Mechanisms, angle: Array) -> Coefficient:
    """Distance of every piston pin from its shaft along its own axis, with derivatives by the crank angle.

    Parameters
    ----------
    pistons : Mechanisms
        All of which drive sliders.
    angle : Array, shape (n,), (design, 1, n) or (design, piston, n). [rad]

    Returns
    -------
    Coefficient, shape (design, piston, n). [m, m/rad, m/rad²]
    """
    return pistons.evaluated(lambda motion: motion.slider, angle)


@dataclass(frozen=True)
class DeadCentres:
    """Where each piston truly turns back, and how far it travels: roots of s′, not points of a grid."""

    stroke: Array = quantity("S", "m", _PISTON, N_("Stroke, between the true dead centres"), "docs/theory/slider-crank")
    top_dead_centre: Array = quantity(
        "φ_T", "deg", _PISTON, N_("Crank angle of the true top dead centre"), "docs/theory/slider-crank"
    )
    bottom_dead_centre: Array = quantity(
        "φ_B", "deg", _PISTON, N_("Crank angle of the true bottom dead centre"), "docs/theory/slider-crank"
    )
    top_shift: Array = quantity(
        "ε_T",
        "deg",
        _PISTON,
        N_("Top dead centre after the crank points along the cylinder"),
        "docs/theory/slider-crank",
    )
    bottom_shift: Array = quantity(
        "ε_B",
        "deg",
        _PISTON,
        N_("Bottom dead centre after the crank points away from the cylinder"),
        "docs/theory/slider-crank",
    )
    top_position: Array = quantity(
        "H", "m", _PISTON, N_("Distance from shaft centre to piston pin at top dead centre"), "docs/theory/slider-crank"
    )
    bottom_position: Array = quantity(
        "h",
        "m",
        _PISTON,
        N_("Distance from shaft centre to piston pin at bottom dead centre"),
        "docs/theory/slider-crank",
    )

    def answer(self, names: Names, design: int) -> str:
        """Say strokes and true dead centres."""
        pistons = names["piston"]
        return _("Strokes: {strokes}. True top dead centres: {tops} after the crank points along the cylinder.").format(
            strokes=shared(pistons, self.stroke[design], "mm"), tops=shared(pistons, self.top_shift[design], "deg")
        )


def dead_centres(pistons: Pistons, crank_angle: CrankAngle) -> DeadCentres:
    """True dead centres of every piston."""
    different = distinct(pistons)
    samples = slider_motion(different.mechanisms, turn_grid()).value

    def position(alpha: Array) -> Array:
        return slider_motion(different.mechanisms, alpha).value

    def slope(alpha: Array) -> Array:
        return slider_motion(different.mechanisms, alpha).first

    top, bottom = largest(position, slope, samples=samples), smallest(position, slope, samples=samples)
    return DeadCentres(
        stroke=different.spread(top.value - bottom.value)[..., 0],
        top_dead_centre=crank_angle.counted(different.angle(top.angle))[..., 0],
        bottom_dead_centre=crank_angle.counted(different.angle(bottom.angle))[..., 0],
        top_shift=different.spread(_around_zero(top.angle))[..., 0],
        bottom_shift=different.spread(_around_zero(bottom.angle - np.pi))[..., 0],
        top_position=different.spread(top.value)[..., 0],
        bottom_position=different.spread(bottom.value)[..., 0],
    )


def _around_zero(angle: Array) -> Array:
    """Bring angles into [−π, π)."""
    return np.mod(angle + np.pi, 2 * np.pi) - np.pi


@dataclass(frozen=True)
class PistonMotion:
    """Motion of every piston and rod by the crank angle alone; speed enters with `PistonSpeeds`."""

    piston_displacement: Array = quantity(
        "x", "m", _CURVE, N_("Travel of the piston from its true top toward the shaft"), "docs/theory/slider-crank"
    )
    piston_velocity_coefficient: Array = quantity(
        "x′", "m/rad", _CURVE, N_("Piston velocity for each rad/s of the crank"), "docs/theory/slider-crank"
    )
    piston_acceleration_coefficient: Array = quantity(
        "x″", "m/rad^2", _CURVE, N_("Piston acceleration for each (rad/s)² of the crank"), "docs/theory/slider-crank"
    )
    rod_angle: Array = quantity(
        "θ",
        "rad",
        _CURVE,
        N_("Direction of the rod, from its crank-side pin to the piston pin, from the cylinder's axis"),
        "docs/theory/groups",
    )
    rod_velocity_coefficient: Array = quantity(
        "θ′", "rad/rad", _CURVE, N_("Rod's angular velocity for each rad/s of the crank"), "docs/theory/groups"
    )
    rod_acceleration_coefficient: Array = quantity(
        "θ″", "rad/rad^2", _CURVE, N_("Rod's angular acceleration for each (rad/s)² of the crank"), "docs/theory/groups"
    )
    largest_pressure_angle: Array = quantity(
        "β_max", "rad", _PISTON, N_("Largest angle between rod and cylinder axis"), "docs/theory/slider-crank"
    )
    largest_pressure_angle_at: Array = quantity(
        "φ(β_max)", "deg", _PISTON, N_("Crank angle of the largest pressure angle"), "docs/theory/slider-crank"
    )
    opposite_pressure_angle: Array = quantity(
        "β_opp",
        "rad",
        _PISTON,
        N_("Largest angle between rod and cylinder axis to the other side"),
        "docs/theory/slider-crank",
    )
    opposite_pressure_angle_at: Array = quantity(
        "φ(β_opp)",
        "deg",
        _PISTON,
        N_("Crank angle of the largest pressure angle to the other side"),
        "docs/theory/slider-crank",
    )
    checks: tuple[Check, ...] = ()


def piston_motion(pistons: Pistons, crank_angle: CrankAngle, dead_centres: DeadCentres) -> PistonMotion:
    """Displacement from the true top toward the shaft, rod angle, and their derivatives."""
    motion = _slider_and_rod(pistons, crank_angle.angle)
    different = distinct(pistons)
    samples = _slider_and_rod(different.mechanisms, turn_grid()).rod

    def rod(alpha: Array) -> Array:
        return _slider_and_rod(different.mechanisms, alpha).rod

    def rod_turn(alpha: Array) -> Array:
        return _slider_and_rod(different.mechanisms, alpha).rod_first

    forth, back = largest(rod, rod_turn, samples=samples), smallest(rod, rod_turn, samples=samples)
    most, least = different.spread(forth.value), different.spread(back.value)
    is_forth = np.abs(most) >= np.abs(least)
    at_forth = crank_angle.counted(different.angle(forth.angle))
    at_back = crank_angle.counted(different.angle(back.angle))
    return PistonMotion(
        piston_displacement=dead_centres.top_position[..., np.newaxis] - motion.position,
        piston_velocity_coefficient=-motion.position_first,
        piston_acceleration_coefficient=-motion.position_second,
        rod_angle=motion.rod,
        rod_velocity_coefficient=motion.rod_first,
        rod_acceleration_coefficient=motion.rod_second,
        largest_pressure_angle=np.where(is_forth, most, least)[..., 0],
        largest_pressure_angle_at=np.where(is_forth, at_forth, at_back)[..., 0],
        opposite_pressure_angle=np.where(is_forth, least, most)[..., 0],
        opposite_pressure_angle_at=np.where(is_forth, at_back, at_forth)[..., 0],
        checks=(_derivatives_check(different),),
    )


def _derivatives_check(pistons: Distinct) -> Check:
    """Compare x′ and x″ with the derivatives of the Fourier series of x and x′, which know no mechanism formula."""
    motion = slider_motion(pistons.mechanisms, turn_grid())
    residual = np.maximum(
        relative(spectral_derivative(motion.value) - motion.first, motion.first),
        relative(spectral_derivative(motion.first) - motion.second, motion.second),
    )
    return Check(
        "piston_derivatives",
        _("x′ and x″ against the derivatives of the Fourier series of x and x′, relative to their peaks"),
        np.max(pistons.spread(residual), axis=(1, 2)),
        1e-11,
    )


@dataclass(frozen=True)
class PistonSpeeds:
    """Velocities and accelerations of pistons and rods at the declared, constant speed."""

    piston_velocity: Array = quantity(
        "v", "m/s", _CURVE, N_("Piston velocity toward the shaft"), "docs/theory/slider-crank"
    )
    piston_acceleration: Array = quantity(
        "j", "m/s^2", _CURVE, N_("Piston acceleration toward the shaft"), "docs/theory/slider-crank"
    )
    rod_angular_velocity: Array = quantity(
        "ω_r", "rad/s", _CURVE, N_("Angular velocity of the rod"), "docs/theory/groups"
    )
    rod_angular_acceleration: Array = quantity(
        "ε_r", "rad/s^2", _CURVE, N_("Angular acceleration of the rod"), "docs/theory/groups"
    )
    mean_piston_speed: Array = quantity(
        "c_m", "m/s", _PISTON, N_("Mean piston speed, 2 S n"), "docs/theory/slider-crank"
    )
    largest_piston_speed: Array = quantity(
        "v_max", "m/s", _PISTON, N_("Largest piston velocity toward the shaft"), "docs/theory/slider-crank"
    )
    largest_piston_speed_at: Array = quantity(
        "φ(v_max)",
        "deg",
        _PISTON,
        N_("Crank angle of the largest velocity toward the shaft"),
        "docs/theory/slider-crank",
    )
    smallest_piston_velocity: Array = quantity(
        "v_min", "m/s", _PISTON, N_("Largest piston velocity away from the shaft, negative"), "docs/theory/slider-crank"
    )
    smallest_piston_velocity_at: Array = quantity(
        "φ(v_min)",
        "deg",
        _PISTON,
        N_("Crank angle of the largest velocity away from the shaft"),
        "docs/theory/slider-crank",
    )
    largest_piston_acceleration: Array = quantity(
        "j_max", "m/s^2", _PISTON, N_("Largest piston acceleration toward the shaft"), "docs/theory/slider-crank"
    )
    largest_piston_acceleration_at: Array = quantity(
        "φ(j_max)",
        "deg",
        _PISTON,
        N_("Crank angle of the largest acceleration toward the shaft"),
        "docs/theory/slider-crank",
    )
    smallest_piston_acceleration: Array = quantity(
        "j_min",
        "m/s^2",
        _PISTON,
        N_("Largest piston acceleration away from the shaft, negative"),
        "docs/theory/slider-crank",
    )
    smallest_piston_acceleration_at: Array = quantity(
        "φ(j_min)",
        "deg",
        _PISTON,
        N_("Crank angle of the largest acceleration away from the shaft"),
        "docs/theory/slider-crank",
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
    pistons: Pistons, crank_angle: CrankAngle, motion: PistonMotion, dead_centres: DeadCentres, speed: Speed
) -> PistonSpeeds:
    """Velocities q′ω and accelerations q″ω² at constant speed, and their extremes."""
    omega = speed.value
    different = distinct(pistons)
    sampled = slider_motion(different.mechanisms, turn_grid())

    def velocity(alpha: Array) -> Array:
        return -slider_motion(different.mechanisms, alpha).first

    def acceleration(alpha: Array) -> Array:
        return -slider_motion(different.mechanisms, alpha).second

    fastest = largest(velocity, acceleration, samples=-sampled.first)
    slowest = smallest(velocity, acceleration, samples=-sampled.first)
    most, least = largest(acceleration, samples=-sampled.second), smallest(acceleration, samples=-sampled.second)

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
