"""Motion of rockers: swing, dead positions, time ratio; with a load radius, the load's travel."""

from dataclasses import dataclass
from typing import ClassVar, NamedTuple

import numpy as np

from cranktrain.catalogue import quantity
from cranktrain.checks import Check, relative
from cranktrain.engine.layout import CrankAngle, Rockers, Speed
from cranktrain.language import N_, _
from cranktrain.motion import Array
from cranktrain.numerics import largest, smallest, spectral_derivative, turn_grid
from cranktrain.wording import Names, shared

_ROCKER = ("rocker",)
_CURVE = ("rocker", "crank_angle")
_THEORY = "docs/theory/crank-rocker"


class _RockerAndRod(NamedTuple):
    """Rocker and rod angles with their derivatives, flat, shape (design, rocker, n)."""

    rocker: Array
    rocker_first: Array
    rocker_second: Array
    rod: Array
    rod_first: Array
    rod_second: Array


def _rocker_and_rod(rockers: Rockers, angle: Array) -> _RockerAndRod:
    """Evaluate every rocker and its rod at φ."""
    return rockers.evaluated(lambda motion: _RockerAndRod(*motion.rocker.angle, *motion.rod.angle), angle)


@dataclass(frozen=True)
class LoadRadius:
    """Radius about each rocker's pivot at which its load is carried, shape (design, rocker, 1). [m]"""

    needs: ClassVar[str] = N_("[mechanism] load_radius")

    value: Array


@dataclass(frozen=True)
class DeadPositions:
    """Between which positions each rocker swings; NaN for a rocker that turns with the crank."""

    swing: Array = quantity("ψ", "rad", _ROCKER, N_("Angle through which the rocker swings"), _THEORY)
    time_ratio: Array = quantity(
        "k", "1", _ROCKER, N_("Crank travel of the slower swing over that of the faster one"), _THEORY
    )
    largest_rocker_angle: Array = quantity(
        "θ_max", "rad", _ROCKER, N_("Rocker angle at its dead position farthest in the sense of rotation"), _THEORY
    )
    largest_rocker_angle_at: Array = quantity(
        "φ(θ_max)", "deg", _ROCKER, N_("Crank angle of the dead position farthest in the sense of rotation"), _THEORY
    )
    smallest_rocker_angle: Array = quantity(
        "θ_min", "rad", _ROCKER, N_("Rocker angle at its other dead position"), _THEORY
    )
    smallest_rocker_angle_at: Array = quantity(
        "φ(θ_min)", "deg", _ROCKER, N_("Crank angle of the other dead position"), _THEORY
    )

    def answer(self, names: Names, design: int) -> str:
        """Say swing, dead positions and time ratio."""
        rockers = names["rocker"]
        return _("The rocker swings {swing}, dead at crank angles {first} and {second}; time ratio {ratio}.").format(
            swing=shared(rockers, self.swing[design], "deg"),
            first=shared(rockers, self.smallest_rocker_angle_at[design], "deg"),
            second=shared(rockers, self.largest_rocker_angle_at[design], "deg"),
            ratio=shared(rockers, self.time_ratio[design], "1"),
        )


def dead_positions(rockers: Rockers, crank_angle: CrankAngle) -> DeadPositions:
    """Extremes of every rocker's angle: roots of θ′."""
    whole = np.unwrap(_rocker_and_rod(rockers, turn_grid()).rocker, axis=-1)
    middle = 0.5 * (np.max(whole, axis=-1, keepdims=True) + np.min(whole, axis=-1, keepdims=True))
    swings = np.ptp(whole, axis=-1, keepdims=True) < np.pi

    def curve(phi: Array) -> Array:
        return middle + np.mod(_rocker_and_rod(rockers, phi).rocker - middle + np.pi, 2 * np.pi) - np.pi

    def slope(phi: Array) -> Array:
        return _rocker_and_rod(rockers, phi).rocker_first

    most = largest(curve, slope, samples=whole)
    least = smallest(curve, slope, samples=whole)
    travel = np.mod(most.angle - least.angle, 2 * np.pi)
    slower = np.maximum(travel, 2 * np.pi - travel)

    def swinging(values: Array) -> Array:
        return np.where(swings, values, np.nan)[..., 0]

    return DeadPositions(
        swing=swinging(most.value - least.value),
        time_ratio=swinging(slower / (2 * np.pi - slower)),
        largest_rocker_angle=swinging(most.value),
        largest_rocker_angle_at=swinging(crank_angle.counted(most.angle)),
        smallest_rocker_angle=swinging(least.value),
        smallest_rocker_angle_at=swinging(crank_angle.counted(least.angle)),
    )


@dataclass(frozen=True)
class RockerMotion:
    """Motion of every rocker and its rod by the crank angle alone."""

    rocker_angle: Array = quantity(
        "θ", "rad", _CURVE, N_("Direction of the rocker, from its pivot to its joint, from the mechanism's x"), _THEORY
    )
    rocker_velocity_coefficient: Array = quantity(
        "θ′", "rad/rad", _CURVE, N_("Rocker's angular velocity for each rad/s of the crank"), _THEORY
    )
    rocker_acceleration_coefficient: Array = quantity(
        "θ″", "rad/rad^2", _CURVE, N_("Rocker's angular acceleration for each (rad/s)² of the crank"), _THEORY
    )
    coupler_angle: Array = quantity(
        "θ_r", "rad", _CURVE, N_("Direction of the rod, from crank pin to joint, from the mechanism's x"), _THEORY
    )
    coupler_velocity_coefficient: Array = quantity(
        "θ_r′", "rad/rad", _CURVE, N_("Rod's angular velocity for each rad/s of the crank"), _THEORY
    )
    coupler_acceleration_coefficient: Array = quantity(
        "θ_r″", "rad/rad^2", _CURVE, N_("Rod's angular acceleration for each (rad/s)² of the crank"), _THEORY
    )
    checks: tuple[Check, ...] = ()


def rocker_motion(rockers: Rockers, crank_angle: CrankAngle) -> RockerMotion:
    """Angles of every rocker and rod, without jumps, and their derivatives."""
    motion = _rocker_and_rod(rockers, crank_angle.angle)
    return RockerMotion(
        rocker_angle=np.unwrap(motion.rocker, axis=-1),
        rocker_velocity_coefficient=motion.rocker_first,
        rocker_acceleration_coefficient=motion.rocker_second,
        coupler_angle=np.unwrap(motion.rod, axis=-1),
        coupler_velocity_coefficient=motion.rod_first,
        coupler_acceleration_coefficient=motion.rod_second,
        checks=(_derivatives_check(rockers),),
    )


def _derivatives_check(rockers: Rockers) -> Check:
    """Compare θ″ with the derivative of the Fourier series of θ′, and θ′ with that of the direction's cosine."""
    motion = _rocker_and_rod(rockers, turn_grid())
    cos, sin = np.cos(motion.rocker), np.sin(motion.rocker)
    turn = cos * spectral_derivative(sin) - sin * spectral_derivative(cos)
    residual = np.maximum(
        relative(turn - motion.rocker_first, motion.rocker_first),
        relative(spectral_derivative(motion.rocker_first) - motion.rocker_second, motion.rocker_second),
    )
    return Check(
        "rocker_derivatives",
        _("θ′ and θ″ against the derivatives of the Fourier series of the rocker's direction and of θ′"),
        np.max(residual, axis=(1, 2)),
        1e-11,
    )


@dataclass(frozen=True)
class RockerSpeeds:
    """Velocities and accelerations of rockers and rods at the declared, constant speed."""

    rocker_angular_velocity: Array = quantity("ω_3", "rad/s", _CURVE, N_("Angular velocity of the rocker"), _THEORY)
    rocker_angular_acceleration: Array = quantity(
        "ε_3", "rad/s^2", _CURVE, N_("Angular acceleration of the rocker"), _THEORY
    )
    coupler_angular_velocity: Array = quantity("ω_2", "rad/s", _CURVE, N_("Angular velocity of the rod"), _THEORY)
    coupler_angular_acceleration: Array = quantity(
        "ε_2", "rad/s^2", _CURVE, N_("Angular acceleration of the rod"), _THEORY
    )


def rocker_speeds(motion: RockerMotion, speed: Speed) -> RockerSpeeds:
    """Velocities q′ω and accelerations q″ω² at constant speed."""
    omega = speed.value
    return RockerSpeeds(
        rocker_angular_velocity=motion.rocker_velocity_coefficient * omega,
        rocker_angular_acceleration=motion.rocker_acceleration_coefficient * omega**2,
        coupler_angular_velocity=motion.coupler_velocity_coefficient * omega,
        coupler_angular_acceleration=motion.coupler_acceleration_coefficient * omega**2,
    )


@dataclass(frozen=True)
class LoadMotion:
    """Travel of a load that hangs at the load radius of each rocker."""

    load_displacement: Array = quantity(
        "x_Q", "m", _CURVE, N_("Travel of the load from the dead position of the smallest rocker angle"), _THEORY
    )
    load_velocity_coefficient: Array = quantity(
        "x_Q′",
        "m/rad",
        _CURVE,
        N_("Load velocity for each rad/s of the crank: the torque factor of a pumping unit"),
        _THEORY,
    )
    load_acceleration_coefficient: Array = quantity(
        "x_Q″", "m/rad^2", _CURVE, N_("Load acceleration for each (rad/s)² of the crank"), _THEORY
    )
    load_stroke: Array = quantity("S_Q", "m", _ROCKER, N_("Stroke of the load"), _THEORY)
    largest_torque_factor: Array = quantity(
        "TF_max", "m", _ROCKER, N_("Largest torque factor, crank torque for each newton of load"), _THEORY
    )
    smallest_torque_factor: Array = quantity(
        "TF_min", "m", _ROCKER, N_("Smallest (largest negative) torque factor"), _THEORY
    )

    def answer(self, names: Names, design: int) -> str:
        """Say the load's stroke and the torque factor's range."""
        rockers = names["rocker"]
        return _("Stroke of the load {stroke}; torque factor from {least} to {most}.").format(
            stroke=shared(rockers, self.load_stroke[design], "mm"),
            least=shared(rockers, self.smallest_torque_factor[design], "mm"),
            most=shared(rockers, self.largest_torque_factor[design], "mm"),
        )


def load_motion(rockers: Rockers, motion: RockerMotion, dead: DeadPositions, load_radius: LoadRadius) -> LoadMotion:
    """Arc that the load travels at its radius, and the torque factor's extremes."""
    radius = load_radius.value

    def turn(phi: Array) -> Array:
        return _rocker_and_rod(rockers, phi).rocker_first

    start = dead.smallest_rocker_angle[..., np.newaxis]
    from_start = np.mod(motion.rocker_angle - start + 0.5 * np.pi, 2 * np.pi) - 0.5 * np.pi
    return LoadMotion(
        load_displacement=radius * from_start,
        load_velocity_coefficient=radius * motion.rocker_velocity_coefficient,
        load_acceleration_coefficient=radius * motion.rocker_acceleration_coefficient,
        load_stroke=radius[..., 0] * dead.swing,
        largest_torque_factor=(radius * largest(turn).value)[..., 0],
        smallest_torque_factor=(radius * smallest(turn).value)[..., 0],
    )
