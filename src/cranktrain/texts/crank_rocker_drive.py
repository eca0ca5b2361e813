"""Torque and flywheel moment of a crank-rocker's drive by [gandzha], (1) to (21): printed, corrected and refuted."""

from typing import NamedTuple

import numpy as np

from cranktrain.mechanisms.crank_rocker.kinematics import CrankRocker, crank_rocker
from cranktrain.motion import ONE, Array
from cranktrain.questions.reduction.gear_train import torque_through
from cranktrain.texts.crank_rocker import pin_velocity_ratio, product_of_sines
from cranktrain.transient.gearing import Gearing, equal_friction, overall_ratio, stages


class Directions(NamedTuple):
    """Directions of the links from one axis: α of the crank, β of the rod, α₁ of the rocker. [rad]"""

    crank: Array
    rod: Array
    rocker: Array


class Drivetrain(NamedTuple):
    """Between motor and crank.

    Attributes
    ----------
    gearing : Gearing
        All stages, the linkage's losses as one of them.
    gear_efficiency, linkage_efficiency : Array
        η_p of all gears and η_ш of the linkage, while the motor drives. [1]
    linkage_back : Array
        Of the linkage, while the load drives. [1]
    is_of_machine : bool
        Whether its stages are those of a machine, and not of the source's symbols alone.
    """

    gearing: Gearing
    gear_efficiency: Array
    linkage_efficiency: Array
    linkage_back: Array
    is_of_machine: bool = False

    @property
    def ratio(self) -> float:
        """Turns of the motor for one of the crank, i. [1]"""
        return overall_ratio(self.gearing)


def drivetrain(ratio: Array, gear_efficiency: Array, linkage_efficiency: Array) -> Drivetrain:
    """A gear and a linkage by the source's symbols, each with as much friction torque both ways."""
    of_gear, of_linkage = (
        (turned, own, float(equal_friction(np.array(own))), 0.0, 0.0)
        for turned, own in ((float(ratio), float(gear_efficiency)), (1.0, float(linkage_efficiency)))
    )
    gearing = stages(0.0, of_gear, of_linkage)
    return Drivetrain(gearing, gear_efficiency, linkage_efficiency, equal_friction(linkage_efficiency))


def directions(angle: Array, geometry: CrankRocker) -> Directions:
    """Directions of a crank-rocker's links over the crank angle.

    Parameters
    ----------
    angle : Array, shape (..., n)
        α, from the line of the fixed pivots. [rad]
    geometry : CrankRocker

    Returns
    -------
    Directions
        NaN where the links cannot close.
    """
    motion = crank_rocker(angle, geometry)
    return Directions(angle, motion.rod.angle.value, motion.rocker.angle.value)


def rod_force(load: Array, at: Directions) -> Array:
    """Force along the rod, Q′ = Q/sin(α₁ − β): (2), from (1). [N]

    Examples
    --------
    Across the rocker the rod pulls with the load itself.

    >>> float(rod_force(np.array(40.0), Directions(np.array(0.0), np.array(0.0), np.array(np.pi / 2))))
    40.0
    """
    return load / np.sin(at.rocker - at.rod)


def refuted_rod_force(load: Array, at: Directions) -> Array:
    """Q′ = Q sin(α₁ − β) of [kunitsky-1938] and [popov-1945], which put into (1) gives sin²(α₁ − β) = 1. [N]"""
    return load * np.sin(at.rocker - at.rod)


def crank_pin_force(load: Array, at: Directions) -> Array:
    """Force across the crank at its pin, T = Q′ sin(α − β): (3), and with (2) (4). [N]"""
    return load * pin_velocity_ratio(at.crank, at.rod, at.rocker)


def centre_distances(rod_length: Array, at: Directions) -> tuple[Array, Array]:
    """Distances AC and BC of the rod's instant centre from both pins, by the sine rule in ABC. [m]

    Parameters
    ----------
    rod_length : Array
        AB. [m]
    at : Directions

    Returns
    -------
    tuple of two Arrays
        From the pins away from the pivots, less than 0 toward them; infinite where crank and rocker are parallel. The
        angle at C is α₁ − α, at A π − (α₁ − β), at B α − β.

    Notes
    -----
    (10), (11) of [gandzha]; docs/theory/crank-rocker-drive, eq. (27.3).
    """
    with np.errstate(divide="ignore"):
        of_sine = rod_length / np.sin(at.rocker - at.crank)
    return of_sine * np.sin(at.crank - at.rod), of_sine * np.sin(at.rocker - at.rod)


def crank_torque(load: Array, radius: Array, train: Drivetrain, at: Directions) -> Array:
    """Static torque on the crank's shaft by (12), T r/η_ш; with the rocker's length for r (13) as printed. [N·m]"""
    return crank_pin_force(load, at) * radius / train.linkage_efficiency


def at_crank(torque: Array, train: Drivetrain) -> Array:
    """Torque ahead of the linkage for one behind it: its losses divide where it drives, and help where it is driven."""
    return np.where(torque > 0, torque / train.linkage_efficiency, torque * train.linkage_back)


def efficiency(train: Drivetrain) -> Array:
    """Efficiency of gear and linkage together, η = η_ш η_p. [1]"""
    return train.gear_efficiency * train.linkage_efficiency


def always_dividing(torque: Array, train: Drivetrain) -> Array:
    """Torque at the motor for one on the crank by (14): η in the denominator always. [N·m]"""
    return torque / (efficiency(train) * train.ratio)


def by_transmitted_torque(torque: Array, train: Drivetrain) -> Array:
    """Torque at the motor for one on the crank that turns forward, losses of every stage by what it passes on.

    Parameters
    ----------
    torque : Array
        That the stages pass on, less than 0 where the load drives. [N·m]
    train : Drivetrain

    Returns
    -------
    Array
        [N·m]

    Notes
    -----
    Lost is power, so it helps whoever holds a load that drives: x/(i η) of x > 0, x η′/i of x < 0, η′ = 2 − 1/η where
    a stage's friction torque is the same both ways. Of x the inertia's part counts, too.
    docs/theory/crank-rocker-drive, eq. (27.6).

    Examples
    --------
    >>> train = drivetrain(np.array(10.0), np.array(0.8), np.array(1.0))
    >>> by_transmitted_torque(np.array([100.0, -100.0]), train).tolist()
    [12.5, -7.5]
    """
    return torque_through(torque, ONE, train.gearing)[0]


def by_same_efficiency(torque: Array, train: Drivetrain) -> Array:
    """The same where a stage's efficiency back is that forward, x η/i of x < 0, as the source's η suggests. [N·m]"""
    both_ways = train.gearing._replace(backward=train.gearing.forward)
    return torque_through(torque, ONE, both_ways)[0]


def passed_on(torque: Array, train: Drivetrain) -> Array:
    """Torque at each stage's output by `by_transmitted_torque`, shape (stage, ...): kinks where one is 0. [N·m]"""
    return torque_through(torque, ONE, train.gearing)[1:]


def weight_at_rocker_pin(flywheel_moment: Array, rocker_length: Array) -> Array:
    """G_A, what the driven parts weigh at A: GD²/(2 r₁)², (15). [kg]"""
    return flywheel_moment / (2 * rocker_length) ** 2


def weight_at_crank_pin(weight: Array, at: Directions) -> Array:
    """G_B of as much kinetic energy at B as G_A at A: (17), from (16). [kg]"""
    return weight * pin_velocity_ratio(at.crank, at.rod, at.rocker) ** 2


def crank_flywheel_moment(weight: Array, radius: Array, at: Directions) -> Array:
    """Flywheel moment on the crank's shaft, G_B (2 r)²: (18). [kg·m²]"""
    return weight_at_crank_pin(weight, at) * (2 * radius) ** 2


def motor_flywheel_moment(own: Array, driven: Array, train: Drivetrain) -> Array:
    """Flywheel moment at the motor, (GD²)₀ + GD²/i²: (20) corrected. [kg·m²]

    own is (GD²)₀ of gear, coupling, brake and armature, driven that on the crank's shaft.
    """
    return own + driven / train.ratio**2


def printed_flywheel_moment(own: Array, driven: Array, train: Drivetrain) -> Array:
    """Flywheel moment at the motor by (20) as printed, with η and with i for i². [kg·m²]"""
    return own + driven / (efficiency(train) * train.ratio)


def refuted_flywheel_moment(own: Array, weight: Array, radius: Array, train: Drivetrain, at: Directions) -> Array:
    """Flywheel moment at the motor by [kunitsky-1938] and [popov-1945], a product for the square of a ratio. [kg·m²]"""
    return own + 4 * radius**2 * weight / train.ratio**2 * product_of_sines(*at)


class RigidRod(NamedTuple):
    """A rod: mass [kg]; its centre, p along it from the crank pin, q to its left [m]; inertia about that [kg·m²]."""

    mass: Array
    along: Array
    across: Array
    inertia: Array


class CrankInertia(NamedTuple):
    """Inertia reduced to the crank and its derivative by the crank angle. [kg·m², kg·m²/rad]"""

    value: Array
    slope: Array


def reduced_inertia(angle: Array, geometry: CrankRocker, crank: Array, rod: RigidRod, rocker: Array) -> CrankInertia:
    """Inertia of a whole crank-rocker reduced to its crank, the rod's mass with it, which (20) leaves out.

    Parameters
    ----------
    angle : Array, shape (..., n)
        [rad]
    geometry : CrankRocker
    crank, rocker : Array
        Moments of inertia about their pivots. [kg·m²]
    rod : RigidRod

    Returns
    -------
    CrankInertia, shape (..., n)

    Notes
    -----
    docs/theory/crank-rocker-drive, eqs. (27.9) and (27.10).
    """
    motion = crank_rocker(angle, geometry)
    beta, alpha1 = motion.rod.angle, motion.rocker.angle
    r, l, r1 = geometry.crank_radius, geometry.rod_length, geometry.rocker_length
    m, p, q, own = rod
    x, sine, cosine = p / l, np.sin(angle - beta.value), np.cos(angle - beta.value)
    between = x * (1 - x) * l**2
    value = m * (
        (1 - x) * r**2 + x * (r1 * alpha1.first) ** 2 - (between - q**2) * beta.first**2 + 2 * q * r * beta.first * sine
    )
    slope = m * (
        x * r1**2 * alpha1.first * alpha1.second
        - (between - q**2) * beta.first * beta.second
        + q * r * (beta.second * sine + beta.first * (1 - beta.first) * cosine)
    )
    return CrankInertia(
        crank + value + own * beta.first**2 + rocker * alpha1.first**2,
        2 * (slope + own * beta.first * beta.second + rocker * alpha1.first * alpha1.second),
    )
