"""Curves of a crank-rocker's drive over a turn, with what follows from each: peaks, means, work."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Literal, NamedTuple

import numpy as np

from cranktrain.language import N_
from cranktrain.mechanisms.crank_rocker.kinematics import CrankRocker, crank_rocker
from cranktrain.motion import Array
from cranktrain.numerics import bracketed_roots
from cranktrain.numerics.ties import first_largest
from cranktrain.record import record
from cranktrain.texts.crank_rocker_drive import (
    Drivetrain,
    always_dividing,
    at_crank,
    by_same_efficiency,
    by_transmitted_torque,
    efficiency,
    motor_flywheel_moment,
    passed_on,
    printed_flywheel_moment,
    reduced_inertia,
    weight_at_rocker_pin,
)
from cranktrain.texts.drive_table import CrankRockerDrive

Verdict = Literal["right", "source", "refuted"]
Carrier = Literal["ratio", "product", "inertia"]
Thing = Literal[
    "ratio",
    "no losses",
    "at the crank",
    "active",
    "friction",
    "weight",
    "GD² at the crank",
    "GD²",
    "GD² of all",
    "idle",
    "idle friction",
]

AT_MOTOR = ("(14)", "(20)", "(21)")
"""Formulas of what is reduced to the motor's shaft."""
_PIECES, _NODES = 8, 24
_SYMBOLS: Mapping[Thing, str] = {
    "ratio": "AC/BC",
    "no losses": "T r",
    "at the crank": "M_O",
    "active": "M_st",
    "friction": "M_st",
    "weight": "G_B",
    "GD² at the crank": "GD²",
    "GD²": "GD²",
    "GD² of all": "GD²",
    "idle": "M_xx",
    "idle friction": "M_xx",
}
_TRIED = 361
"""Angles of a half-period between which its peaks are looked for."""


class Half(NamedTuple):
    """A half-period between two dead positions, in which the rocker advances or goes back. [rad]"""

    start: float
    end: float


class RockerDeadPositions(NamedTuple):
    """Crank angles at which rod and crank are in line, as far apart as they get and folded [rad].

    advance, back: half-periods in which the rocker's angle grows and falls.
    """

    extended: float
    folded: float
    advance: Half
    back: Half


@record
class DriveCurve:
    """A curve over the crank angle.

    Attributes
    ----------
    number : str
        The source's.
    thing : Thing
        What it is of; one that is printed or refuted stands beside the first right one of the same thing.
    name : str
        Translated where it is shown.
    unit : str
    verdict : "right", "source" or "refuted"
    carrier : "ratio", "product" or "inertia"
        What of the linkage it follows: κ, the product of both sines, the whole reduced inertia.
    of : callable
        From values of its carrier; between kinks it grows or falls with them over either half-period.
    turns : callable, optional
        From values of its carrier what has kinks of the curve where it changes its sign, shape (signal, n).
    """

    number: str
    thing: Thing
    name: str
    unit: str
    verdict: Verdict
    carrier: Carrier
    of: Callable[[Array], Array]
    turns: Callable[[Array], Array] | None = None

    @property
    def symbol(self) -> str:
        """The source's letters."""
        return _SYMBOLS[self.thing]

    @property
    def is_at_motor(self) -> bool:
        """Whether it is reduced to the motor's shaft."""
        return self.number in AT_MOTOR


class CurvePeak(NamedTuple):
    """Crank angle of a half-period's peak and the value there. [rad, in SI]"""

    angle: float
    value: float


class CurveFacts(NamedTuple):
    """What follows from a curve: peaks of both half-periods, mean and root mean square over the turn.

    work: what a torque does over a turn of the crank [J]; 0 of a flywheel moment.
    """

    advancing: CurvePeak
    returning: CurvePeak
    mean: float
    rms: float
    work: float


def dead_positions(geometry: CrankRocker) -> RockerDeadPositions:
    """Dead positions of a crank-rocker, in closed form.

    Examples
    --------
    >>> links = (np.array(size) for size in (0.25, 0.7, 0.5, 0.8, 1.0))
    >>> found = dead_positions(CrankRocker(*links))
    >>> round(float(np.degrees(found.extended)), 9), round(float(np.degrees(found.folded)), 9)
    (31.752534449, 214.62216184)
    """
    r, l, r1, d, side = (float(np.ravel(one)[0]) for one in geometry)

    def opening(e: float) -> float:
        return side * float(np.arccos((d * d + e * e - r1 * r1) / (2 * d * e)))

    turn = 2 * np.pi
    extended, folded = opening(l + r) % turn, (opening(l - r) + np.pi) % turn
    after = Half(extended, folded if folded > extended else folded + turn)
    then = Half(folded, extended if extended > folded else extended + turn)
    middle = np.array([sum(after) / 2])
    advances = float(crank_rocker(middle, geometry).rocker.angle.first[0]) > 0
    return RockerDeadPositions(extended, folded, *((after, then) if advances else (then, after)))


def carried(drive: CrankRockerDrive, carrier: Carrier, angle: Array) -> tuple[Array, Array]:
    """Value and slope of what curves follow: κ, sin(α₁ − β) sin(α − β), or the reduced inertia [kg·m²]."""
    geometry = drive.geometry
    if carrier == "inertia":
        rocker = drive.driven_moment / 4
        return reduced_inertia(angle, geometry, drive.crank_inertia, drive.rod, rocker)
    motion = crank_rocker(angle, geometry)
    beta, alpha1 = motion.rod.angle, motion.rocker.angle
    if carrier == "ratio":
        share = geometry.rocker_length / geometry.crank_radius
        return share * alpha1.first, share * alpha1.second
    mu, nu = alpha1.value - beta.value, angle - beta.value
    slope = np.cos(mu) * np.sin(nu) * (alpha1.first - beta.first) + np.sin(mu) * np.cos(nu) * (1 - beta.first)
    return np.sin(mu) * np.sin(nu), slope


def drive_curves(drive: CrankRockerDrive) -> tuple[DriveCurve, ...]:
    """Curves of the drive: torque on the crank and at the motor, flywheel moment, idle torque; right, printed, refuted.

    Parameters
    ----------
    drive : CrankRockerDrive

    Returns
    -------
    tuple of DriveCurve
        In the source's order.
    """
    return (*_torques(drive), *_moments(drive), *_idle(drive))


def _torques(drive: CrankRockerDrive) -> Iterator[DriveCurve]:
    r, r1, train = drive.geometry.crank_radius, drive.geometry.rocker_length, drive.train
    on_crank, loss = drive.load * r, train.linkage_efficiency
    refuted = on_crank / (efficiency(train) * train.ratio)
    yield DriveCurve("(10)", "ratio", N_("AC/BC"), "1", "right", "ratio", _itself)
    yield DriveCurve("(10)", "ratio", N_("AC/BC by Kunitsky and Popov"), "1", "refuted", "product", _itself)
    yield _torque("(4)", "no losses", N_("T r, without losses"), "right", lambda k: on_crank * k)
    yield _torque(
        "(12)",
        "at the crank",
        N_("at the crank, by which way power goes"),
        "right",
        lambda k: at_crank(on_crank * k, train),
    )
    yield _torque("(12)", "at the crank", N_("at the crank, η_ш dividing"), "source", lambda k: on_crank * k / loss)
    yield _torque(
        "(13)", "at the crank", N_("at the crank, with r₁ for r"), "source", lambda k: drive.load * r1 * k / loss
    )
    by_law = (
        N_("at the motor, active load, by the stages of [drive]")
        if train.is_of_machine
        else N_("at the motor, active load, friction torque the same both ways")
    )
    yield _at_motor("(14)", "active", by_law, on_crank, train)
    same = N_("at the motor, active load, efficiency back the same as forward")
    yield _torque("(14)", "active", same, "right", lambda k: by_same_efficiency(on_crank * k, train))
    yield _of_friction("(14)", "friction", N_("at the motor, dry friction"), on_crank, train)
    yield _torque("(14)", "active", N_("at the motor, η always dividing"), "source", lambda k: refuted * k)
    kunitsky = N_("at the motor, by Kunitsky and Popov")
    yield DriveCurve("(14)", "active", kunitsky, "N*m", "refuted", "product", lambda one: refuted * one)


def _itself(carried: Array) -> Array:
    return carried


def _torque(number: str, thing: Thing, name: str, verdict: Verdict, of: Callable[[Array], Array]) -> DriveCurve:
    """Torque that follows κ."""
    return DriveCurve(number, thing, name, "N*m", verdict, "ratio", of)


def _at_motor(number: str, thing: Thing, name: str, on_crank: Array, train: Drivetrain) -> DriveCurve:
    """Torque at the motor of a load that keeps its direction, by what the stages pass on."""

    def turns(ratio: Array) -> Array:
        return passed_on(on_crank * ratio, train)

    torque = _torque(number, thing, name, "right", lambda k: by_transmitted_torque(on_crank * k, train))
    return replace(torque, turns=turns)


def _of_friction(number: str, thing: Thing, name: str, on_crank: Array, train: Drivetrain) -> DriveCurve:
    """Torque at the motor of a load that turns with the rocker's motion, so that every stage drives."""
    return _torque(number, thing, name, "right", lambda k: by_transmitted_torque(np.abs(on_crank * k), train))


def _moments(drive: CrankRockerDrive) -> Iterator[DriveCurve]:
    weight = weight_at_rocker_pin(drive.driven_moment, drive.geometry.rocker_length)
    own, on_crank, train = drive.gear_moment, 4 * drive.geometry.crank_radius**2 * weight, drive.train
    loss = train.linkage_efficiency
    yield DriveCurve("(17)", "weight", N_("G_B of G_A"), "kg", "right", "ratio", lambda k: weight * k**2)
    at_crank: Thing = "GD² at the crank"
    yield _moment("(18)", at_crank, N_("at the crank"), "right", "ratio", lambda k: on_crank * k**2)
    yield _moment("(19)", at_crank, N_("at the crank, over η_ш"), "source", "ratio", lambda k: on_crank * k**2 / loss)

    def reduced(carried: Array) -> Array:
        return motor_flywheel_moment(own, on_crank * carried, train)

    right, whole = N_("at the motor, with i² and no η"), N_("at the motor, rod and crank with their masses")
    yield _moment("(20)", "GD²", right, "right", "ratio", lambda k: reduced(k**2))
    if drive.has_masses:
        yield _moment(
            "(20)",
            "GD² of all",
            whole,
            "right",
            "inertia",
            lambda own_of: motor_flywheel_moment(own, 4 * own_of, train),
        )
    printed, kunitsky = N_("at the motor, with η and i"), N_("at the motor, by Kunitsky and Popov")
    yield _moment(
        "(20)", "GD²", printed, "source", "ratio", lambda k: printed_flywheel_moment(own, on_crank * k**2, train)
    )
    yield _moment("(20)", "GD²", kunitsky, "refuted", "product", reduced)


def _moment(
    number: str, thing: Thing, name: str, verdict: Verdict, carrier: Carrier, of: Callable[[Array], Array]
) -> DriveCurve:
    """Flywheel moment."""
    return DriveCurve(number, thing, name, "kg*m^2", verdict, carrier, of)


def _idle(drive: CrankRockerDrive) -> Iterator[DriveCurve]:
    train = drive.train
    on_crank = drive.idle_torque * drive.geometry.crank_radius / drive.geometry.rocker_length
    flat = always_dividing(on_crank, train)
    yield _of_friction("(21)", "idle friction", N_("idle, dry friction: never less than 0"), on_crank, train)
    yield _at_motor("(21)", "idle", N_("idle, a constant active Q"), on_crank, train)
    yield _torque("(21)", "idle", N_("idle, η always dividing"), "source", lambda k: flat * k)
    yield _torque("(21)", "idle", N_("idle, the flat line of Kunitsky and Popov"), "refuted", lambda k: flat + 0.0 * k)


def values_at(drive: CrankRockerDrive, curve: DriveCurve, angle: Array) -> Array:
    """Values of a curve at crank angles."""
    return curve.of(carried(drive, curve.carrier, angle)[0])


def curve_facts(drive: CrankRockerDrive, curve: DriveCurve) -> CurveFacts:
    """Peaks of both half-periods, means and work of a curve.

    Notes
    -----
    A curve follows its carrier, so its peaks are where that has no slope, or at kinks; quadrature goes from dead
    position to dead position and stops at kinks, between which every curve is smooth.
    """
    dead = dead_positions(drive.geometry)
    halves = (dead.advance, dead.back)
    kinks = [_kinks(drive, curve, half) for half in halves]
    peaks = [_peak(drive, curve, half, own) for half, own in zip(halves, kinks, strict=True)]
    parts = [
        Half(*edges)
        for half, own in zip(halves, kinks, strict=True)
        for edges in pairwise([half.start, *own, half.end])
    ]
    mean, square = (
        sum(integral(lambda angle, n=n: values_at(drive, curve, angle) ** n, part) for part in parts) / (2 * np.pi)
        for n in (1, 2)
    )
    turned = drive.train.ratio if curve.is_at_motor else 1.0
    work = 2 * np.pi * turned * mean if curve.unit == "N*m" else 0.0
    return CurveFacts(peaks[0], peaks[1], mean, float(np.sqrt(square)), work)


def _kinks(drive: CrankRockerDrive, curve: DriveCurve, half: Half) -> list[float]:
    """Angles within a half-period at which the curve has kinks, rising. [rad]"""
    turns = curve.turns
    if turns is None:
        return []
    tried = np.linspace(half.start, half.end, _TRIED)
    found: list[float] = []
    for place, values in enumerate(turns(carried(drive, curve.carrier, tried)[0])):

        def signal(angle: Array, place: int = place) -> Array:
            return turns(carried(drive, curve.carrier, angle)[0])[place]

        before = np.flatnonzero(values[:-1] * values[1:] < 0)
        found += bracketed_roots(signal, tried[before], tried[before + 1]).tolist()
    return sorted(set(found))


def integral(curve: Callable[[Array], Array], span: Half, pieces: int = _PIECES) -> float:
    """Integral over crank angles of a curve that is smooth there, by Gauss's rule on equal pieces."""
    nodes, weights = np.polynomial.legendre.leggauss(_NODES)
    edges = np.linspace(span.start, span.end, pieces + 1)
    half = (edges[1:] - edges[:-1])[:, np.newaxis] / 2
    return float(np.sum(curve(edges[:-1, np.newaxis] + half * (1 + nodes)) * half * weights))


def _peak(drive: CrankRockerDrive, curve: DriveCurve, half: Half, kinks: Sequence[float]) -> CurvePeak:
    """Peak of a half-period: the value farthest from that at the dead positions, where the carrier has no slope."""
    tried = np.linspace(half.start, half.end, _TRIED)[1:-1]

    def slope(angle: Array) -> Array:
        return carried(drive, curve.carrier, angle)[1]

    roots = bracketed_roots(slope, tried[:-1], tried[1:])
    angles = np.concatenate([roots[~np.isnan(roots)], kinks])
    values = values_at(drive, curve, angles)
    at_dead = values_at(drive, curve, np.array([half.start]))[0]
    best = first_largest(np.abs(values - at_dead))
    return CurvePeak(float(angles[best] % (2 * np.pi)), float(values[best]))
