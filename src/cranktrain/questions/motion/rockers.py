"""Motion of rockers: swing, dead positions, time ratio; with the speed, velocities."""

import numpy as np

from cranktrain.language import N_, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.mechanisms import Rockers
from cranktrain.layout.speed import Speed, rates
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import (
    DERIVATIVES_LIMIT,
    Extreme,
    derivatives_residual,
    slower_over_faster,
    turn_grid,
    turning_points,
    unwrapped,
)
from cranktrain.questions.motion.grid_motion import GridMotion
from cranktrain.record import record
from cranktrain.references import THEORY_OF_CRANK_ROCKERS as _THEORY
from cranktrain.references import THEORY_OF_GROUPS as _GROUPS
from cranktrain.saying.catalogue import coefficients, extreme, quantity
from cranktrain.saying.checks import Check, Checked, Flagged, Limit, flagged

_ROCKER = ("rocker",)
_CURVE = ("rocker", "crank_angle")


def rocker_angle(rockers: Rockers, angle: Array) -> Coefficient:
    """Evaluate every rocker at φ.

    Parameters
    ----------
    rockers : Rockers
    angle : Array, shape (n,), (design, 1, n) or (design, rocker, n)
        φ. [rad]

    Returns
    -------
    Coefficient, shape (design, rocker, n). [rad, rad/rad, rad/rad²]
    """
    return rockers.evaluated(lambda motion: motion.rocker.angle, angle)


@record
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
    samples = rocker_angle(rockers, turn_grid())
    whole = unwrapped(samples.value)
    middle = 0.5 * (np.fmax.reduce(whole, axis=-1, keepdims=True) + np.fmin.reduce(whole, axis=-1, keepdims=True))
    turns = np.abs(whole[..., -1:] - whole[..., :1]) > np.pi
    return RockerTurn(samples, np.where(turns, np.nan, middle - 2 * np.pi * np.rint(middle / (2 * np.pi))))


def _counted(angle: Array, middle: Array) -> Array:
    """Count an angle without jumps: about the middle of its swing, or on from where it starts if it turns."""
    about = middle + np.mod(angle - middle + np.pi, 2 * np.pi) - np.pi
    return np.where(np.isnan(middle), unwrapped(angle), about)


def _without_jumps(motion: Coefficient, turn: RockerTurn) -> Coefficient:
    """Angles of the rockers, counted as their swings or turns ask for."""
    return motion._replace(value=_counted(motion.value, turn.middle))


_SWING = Limit(
    1e5, "deg", N_("A rocker swings {value}: what there is of its motion is in the last digits of its position.")
)


@record
class DeadPositions(Flagged):
    """Between which positions each rocker swings; NaN for a rocker that turns with the crank."""

    swing: Array = quantity(
        "ψ",
        "rad",
        _ROCKER,
        N_("Angle through which the rocker swings"),
        _THEORY,
        "3.6",
        line="{largest_rocker_angle} − {smallest_rocker_angle}",
    )
    time_ratio: Array = quantity(
        "k", "1", _ROCKER, N_("Crank travel of the slower swing over that of the faster one"), _THEORY, "3.7"
    )
    largest_rocker_angle: Extreme = extreme(
        "θ_max",
        "rad",
        _ROCKER,
        N_("Rocker angle at its dead position farthest in the sense of rotation"),
        N_("Crank angle of the dead position farthest in the sense of rotation"),
        _THEORY,
        "3.5, 3.6",
        worst="largest",
        of="rocker_angle",
    )
    smallest_rocker_angle: Extreme = extreme(
        "θ_min",
        "rad",
        _ROCKER,
        N_("Rocker angle at its other dead position"),
        N_("Crank angle of the other dead position"),
        _THEORY,
        "3.5, 3.6",
        worst="smallest",
        of="rocker_angle",
    )


def dead_positions(rockers: Rockers, turn: RockerTurn, crank_angle: CrankAngle) -> DeadPositions:
    """Extremes of every rocker's angle, roots of θ′; docs/theory/crank-rocker, eqs. (3.5) and (3.6)."""
    least, most = turning_points(
        lambda phi: _without_jumps(rocker_angle(rockers, phi), turn), _counted(turn.samples.value, turn.middle)
    )

    def swinging(values: Array) -> Array:
        return np.where(np.isnan(turn.middle), np.nan, values)[..., 0]

    swing = swinging(most.value - least.value)
    return DeadPositions(
        swing=swing,
        time_ratio=swinging(slower_over_faster(most.angle - least.angle)),
        largest_rocker_angle=Extreme(swinging(crank_angle.counted(most.angle)), swinging(most.value)),
        smallest_rocker_angle=Extreme(swinging(crank_angle.counted(least.angle)), swinging(least.value)),
        unlikely=tuple(flagged(_SWING, 1 / swing, swing)),
    )


@record
class RockerMotion(Checked):
    """Motion of every rocker by the crank angle alone."""

    rocker_angle: Coefficient = coefficients(
        "θ",
        "rad",
        _CURVE,
        N_("Direction of the rocker, from its pivot to its joint, from the mechanism's x"),
        N_("Rocker's angular velocity for each rad/s of the crank"),
        N_("Rocker's angular acceleration for each (rad/s)² of the crank"),
        _THEORY,
        "3.1 to 3.3",
    )


def rocker_motion(rockers: Rockers, turn: RockerTurn, motion: GridMotion) -> RockerMotion:
    """Angles of every rocker, without jumps, and their derivatives."""
    angle = motion.of(rockers, lambda own: own.rocker.angle)
    return RockerMotion(_without_jumps(angle, turn), checks=(_derivatives_check(rockers),))


def _derivatives_check(rockers: Rockers) -> Check:
    """Compare the derivatives of cos θ and sin θ, by θ′ and θ″, with those of their Fourier series."""

    def direction(phi: Array) -> Coefficient:
        motion = rocker_angle(rockers, phi)
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


@record
class RockerSpeeds:
    """Velocities and accelerations of rockers."""

    rocker_angular_velocity: Array = quantity(
        "ω_3", "rad/s", _CURVE, N_("Angular velocity of the rocker"), _GROUPS, "1.17"
    )
    rocker_angular_acceleration: Array = quantity(
        "ε_3", "rad/s^2", _CURVE, N_("Angular acceleration of the rocker"), _GROUPS, "1.17"
    )


def rocker_speeds(motion: RockerMotion, speed: Speed, crank_angle: CrankAngle) -> RockerSpeeds:
    """Velocities q′ω and accelerations q″ω² + q′ε."""
    return RockerSpeeds(*rates(motion.rocker_angle, speed.drive(crank_angle.angle)))
