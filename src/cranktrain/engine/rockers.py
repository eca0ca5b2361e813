"""Motion of rockers: swing, dead positions, time ratio; with a load radius, the load's travel."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from cranktrain.catalogue import quantity
from cranktrain.checks import Check
from cranktrain.engine.layout import CrankAngle, Rockers, Speed
from cranktrain.engine.places import Place
from cranktrain.language import N_, _
from cranktrain.mechanisms.crank_rocker import CrankRockerSpec
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import DERIVATIVES_LIMIT, derivatives_residual, extremes, turn_grid, turning_points, unwrapped
from cranktrain.wording import Names, around_turn, shared

_ROCKER = ("rocker",)
_CURVE = ("rocker", "crank_angle")
_THEORY = "docs/theory/crank-rocker"


def _rocker(rockers: Rockers, angle: Array) -> Coefficient:
    """Evaluate every rocker's angle at φ, shape (design, rocker, n)."""
    return rockers.evaluated(lambda motion: motion.rocker.angle, angle)


_DIRECTIONS = {"with": 1.0, "against": -1.0}


@dataclass(frozen=True)
class LoadRadius:
    """Radius about each rocker's pivot at which its load is carried, shape (design, rocker, 1). [m]

    Negative where the load's travel counts against the rocker's angle.
    """

    needs: ClassVar[str] = N_("[mechanism] load_radius")

    value: Array


def load_radius_of(designs: Sequence[Sequence[Place]], *, sense: float) -> LoadRadius | None:
    """Collect the load radius of every rocker, NaN for one that carries no load; None where there is none at all."""
    radii = [
        [
            sense * place.spec.load_radius.si * _DIRECTIONS[place.spec.load_direction]
            if isinstance(place.spec, CrankRockerSpec) and place.spec.load_radius is not None
            else np.nan
            for place in design
        ]
        for design in designs
    ]
    value = np.array(radii)[..., np.newaxis]
    return None if np.all(np.isnan(value)) else LoadRadius(value)


@dataclass(frozen=True)
class RockerTurn:
    """One turn of the rockers, whatever the machine's own grid: where extremes are looked for first.

    Attributes
    ----------
    samples : Coefficient, shape (design, rocker, 720)
        On `turn_grid()`.
    middle : Array, shape (design, rocker, 1)
        Middle of the swing, within [−π, π], about which angles are counted; NaN for a rocker that turns. [rad]
    """

    samples: Coefficient
    middle: Array


def rocker_turn(rockers: Rockers) -> RockerTurn:
    """Sample the rockers' turn, and find which of them swing and which turn."""
    samples = _rocker(rockers, turn_grid())
    whole = unwrapped(samples.value)
    middle = 0.5 * (np.fmax.reduce(whole, axis=-1, keepdims=True) + np.fmin.reduce(whole, axis=-1, keepdims=True))
    turns = np.abs(whole[..., -1:] - whole[..., :1]) > np.pi
    return RockerTurn(samples, np.where(turns, np.nan, middle - 2 * np.pi * np.rint(middle / (2 * np.pi))))


def _counted(angle: Array, middle: Array) -> Array:
    """Count an angle without jumps: about the middle of its swing, or on from where it starts if it turns."""
    about = middle + np.mod(angle - middle + np.pi, 2 * np.pi) - np.pi
    return np.where(np.isnan(middle), unwrapped(angle), about)


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

    def answer(self, names: Names, design: int) -> str | None:
        """Say swing, dead positions and time ratio of the rockers that swing."""
        if np.all(np.isnan(self.swing[design])):
            return None
        rockers = names["rocker"]
        return _("The rocker swings {swing}, dead at crank angles {first} and {second}; time ratio {ratio}.").format(
            swing=shared(rockers, self.swing[design], "deg"),
            first=shared(rockers, around_turn(self.smallest_rocker_angle_at[design]), "deg"),
            second=shared(rockers, around_turn(self.largest_rocker_angle_at[design]), "deg"),
            ratio=shared(rockers, self.time_ratio[design], "1"),
        )


def dead_positions(rockers: Rockers, turn: RockerTurn, crank_angle: CrankAngle) -> DeadPositions:
    """Extremes of every rocker's angle: roots of θ′."""

    def rocker(phi: Array) -> Coefficient:
        motion = _rocker(rockers, phi)
        return Coefficient(_counted(motion.value, turn.middle), motion.first, motion.second)

    least, most = turning_points(rocker, _counted(turn.samples.value, turn.middle))
    travel = np.mod(most.angle - least.angle, 2 * np.pi)
    slower = np.maximum(travel, 2 * np.pi - travel)

    def swinging(values: Array) -> Array:
        return np.where(np.isnan(turn.middle), np.nan, values)[..., 0]

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
    """Motion of every rocker by the crank angle alone."""

    rocker_angle: Array = quantity(
        "θ", "rad", _CURVE, N_("Direction of the rocker, from its pivot to its joint, from the mechanism's x"), _THEORY
    )
    rocker_velocity_coefficient: Array = quantity(
        "θ′", "rad/rad", _CURVE, N_("Rocker's angular velocity for each rad/s of the crank"), _THEORY
    )
    rocker_acceleration_coefficient: Array = quantity(
        "θ″", "rad/rad^2", _CURVE, N_("Rocker's angular acceleration for each (rad/s)² of the crank"), _THEORY
    )
    checks: tuple[Check, ...] = ()


def rocker_motion(rockers: Rockers, turn: RockerTurn, crank_angle: CrankAngle) -> RockerMotion:
    """Angles of every rocker, without jumps, and their derivatives."""
    motion = _rocker(rockers, crank_angle.angle)
    return RockerMotion(
        rocker_angle=_counted(motion.value, turn.middle),
        rocker_velocity_coefficient=motion.first,
        rocker_acceleration_coefficient=motion.second,
        checks=(_derivatives_check(rockers),),
    )


def _derivatives_check(rockers: Rockers) -> Check:
    """Compare the derivatives of cos θ and sin θ, by θ′ and θ″, with those of their Fourier series."""

    def direction(phi: Array) -> Coefficient:
        motion = _rocker(rockers, phi)
        cos, sin = np.cos(motion.value), np.sin(motion.value)
        first, second = motion.first, motion.second
        return Coefficient(
            np.concatenate([cos, sin], axis=1),
            np.concatenate([-sin * first, cos * first], axis=1),
            np.concatenate([-sin * second - cos * first**2, cos * second - sin * first**2], axis=1),
        )

    return Check(
        "rocker_derivatives",
        _("derivatives of cos θ and sin θ by θ′ and θ″ against those of their Fourier series, relative to their peaks"),
        np.max(derivatives_residual(direction), axis=(1, 2)),
        DERIVATIVES_LIMIT,
    )


@dataclass(frozen=True)
class RockerSpeeds:
    """Velocities and accelerations of rockers at the declared, constant speed."""

    rocker_angular_velocity: Array = quantity("ω_3", "rad/s", _CURVE, N_("Angular velocity of the rocker"), _THEORY)
    rocker_angular_acceleration: Array = quantity(
        "ε_3", "rad/s^2", _CURVE, N_("Angular acceleration of the rocker"), _THEORY
    )


def rocker_speeds(motion: RockerMotion, speed: Speed) -> RockerSpeeds:
    """Velocities q′ω and accelerations q″ω² at constant speed."""
    omega = speed.value
    return RockerSpeeds(
        rocker_angular_velocity=motion.rocker_velocity_coefficient * omega,
        rocker_angular_acceleration=motion.rocker_acceleration_coefficient * omega**2,
    )


@dataclass(frozen=True)
class LoadMotion:
    """Travel of a load that hangs at the load radius of each rocker."""

    load_displacement: Array = quantity(
        "x_Q", "m", _CURVE, N_("Travel of the load from the dead position at which it is least"), _THEORY
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


def load_motion(
    rockers: Rockers, turn: RockerTurn, motion: RockerMotion, dead: DeadPositions, load_radius: LoadRadius
) -> LoadMotion:
    """Arc that the load travels at its radius, and the torque factor's extremes."""
    radius = load_radius.value
    start = np.where(
        radius > 0, dead.smallest_rocker_angle[..., np.newaxis], dead.largest_rocker_angle[..., np.newaxis]
    )
    least, most = extremes(
        lambda phi: _rocker(rockers, phi).first,
        lambda phi: _rocker(rockers, phi).second,
        samples=turn.samples.first,
    )
    return LoadMotion(
        load_displacement=radius * (motion.rocker_angle - start),
        load_velocity_coefficient=radius * motion.rocker_velocity_coefficient,
        load_acceleration_coefficient=radius * motion.rocker_acceleration_coefficient,
        load_stroke=np.abs(radius[..., 0]) * dead.swing,
        largest_torque_factor=np.maximum(radius * most.value, radius * least.value)[..., 0],
        smallest_torque_factor=np.minimum(radius * most.value, radius * least.value)[..., 0],
    )
