"""What is absurd about wrong formulas of a crank-rocker's drive, as numbers, and how pin friction compares with η."""

import itertools
from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics import Curve, bracketed_roots, extremes
from cranktrain.texts.crank_rocker_drive import directions, efficiency
from cranktrain.texts.drive_curves import Half, carried, curve_facts, dead_positions, drive_curves, integral
from cranktrain.texts.drive_table import CrankRockerDrive
from cranktrain.texts.friction_circles import FrictionRadii, rubbing_links

_TRIED = 3601
"""Angles of a half-period at which the load is asked whether it drives."""


class Absurdities(NamedTuple):
    """What follows from wrong formulas.

    refuted_work: over a turn of Kunitsky's and Popov's torque from a loss-free active load, which must be 0 [J];
    least_moment, below: their GD² at its least, and over how much of the turn it is below (GD²)₀ [kg·m², rad];
    least_square: the least sin²(α₁ − β), which their Q′ put into (1) has for 1; lost, printed_lost: what a turn with an
    active load loses, and by (14) [J]; too_large: how many times the crank-rocker's part of GD² by (20) is too large;
    too_long: the same of the torque by (13).
    """

    refuted_work: float
    least_moment: float
    below: float
    least_square: float
    lost: float
    printed_lost: float
    too_large: float
    too_long: float


def absurdities(drive: CrankRockerDrive) -> Absurdities:
    """Count what is absurd about the refuted and the wrongly printed formulas.

    Notes
    -----
    The product of both sines has κ's sign, so that GD² is below (GD²)₀ while the rocker goes back. A turn with an
    active load loses what the motor gives. docs/theory/crank-rocker-drive, eqs. (27.5), (27.7).
    """
    dead = dead_positions(drive.geometry)
    halves = (dead.advance, dead.back)
    r, r1 = float(drive.geometry.crank_radius), float(drive.geometry.rocker_length)

    def product(angle: Array) -> Array:
        return carried(drive, "product", angle)[0]

    curves = drive_curves(drive)
    refuted = next(one for one in curves if one.verdict == "refuted" and one.number == "(20)")
    right = next(one for one in curves if one.verdict == "right" and one.number == "(14)")
    train, load = drive.train, float(drive.load)
    eta = float(efficiency(train))
    return Absurdities(
        refuted_work=load * r * sum(integral(product, half) for half in halves),
        least_moment=min(curve_facts(drive, refuted)[:2], key=lambda peak: peak.value).value,
        below=dead.back.end - dead.back.start,
        least_square=_least_square(drive),
        lost=curve_facts(drive, right).work,
        printed_lost=0.0,
        too_large=train.ratio / eta,
        too_long=r1 / r,
    )


def swing(drive: CrankRockerDrive) -> float:
    """Angle γ through which the rocker swings, from dead position to dead position. [rad]"""
    advance = dead_positions(drive.geometry).advance
    rocker = directions(np.array([advance.start, advance.end]), drive.geometry).rocker
    return float(np.mod(rocker[1] - rocker[0], 2 * np.pi))


def _least_square(drive: CrankRockerDrive) -> float:
    """Least sin² of the angle between rod and rocker: its extremes stand with the crank along the ground line."""
    at = directions(np.array([0.0, np.pi]), drive.geometry)
    return float(np.min(np.sin(at.rocker - at.rod) ** 2))


class PinFriction(NamedTuple):
    """A turn of a crank-rocker whose pins rub, at the crank, with an active load.

    driving, driven: mean efficiency while the load resists and while it drives [1]; locked: half-periods' parts, next
    to the dead positions, in which the load, which should drive, cannot [rad]; at_dead: torque at the extended and the
    folded dead position [N·m]; largest, smallest: torques [N·m].
    """

    driving: float
    driven: float
    locked: tuple[Half, Half]
    at_dead: tuple[float, float]
    largest: float
    smallest: float


def pin_friction(drive: CrankRockerDrive, radii: FrictionRadii) -> PinFriction | None:
    """Follow a turn with friction circles; None where pins lock the links, or no load drives them.

    Notes
    -----
    The friction of the rocker's pin jumps where the crank lies along the ground line: quadrature stops there.
    """
    load = drive.load * drive.geometry.rocker_length

    def torque(angle: Array) -> Array:
        return rubbing_links(angle, drive.geometry, load, radii).torque

    dead = dead_positions(drive.geometry)
    work = [sum(integral(torque, part, 16) for part in _between_jumps(half)) for half in (dead.advance, dead.back)]
    ideal = float(load) * swing(drive)
    resisting, helping = (0, 1) if ideal > 0 else (1, 0)
    helped = (dead.advance, dead.back)[helping]
    tried = np.linspace(helped.start, helped.end, _TRIED)[1:-1]
    pushed = tried[torque(tried) < 0]
    if ideal == 0 or not pushed.size or not np.all(np.isfinite(work)):
        return None
    edges = [_zero(torque, float(end), way) for end, way in ((pushed[0], -1), (pushed[-1], 1))]
    low, high = extremes(torque)
    at_dead = torque(np.array([dead.extended, dead.folded]))
    return PinFriction(
        driving=abs(ideal) / work[resisting],
        driven=-work[helping] / abs(ideal),
        locked=(Half(helped.start, edges[0]), Half(edges[1], helped.end)),
        at_dead=(float(at_dead[0]), float(at_dead[1])),
        largest=float(high.value[0]),
        smallest=float(low.value[0]),
    )


def _between_jumps(half: Half) -> list[Half]:
    """Parts of a half-period between the angles at which the crank lies along the ground line."""
    inside = [jump for jump in np.arange(0.0, 4 * np.pi, np.pi) if half.start < jump < half.end]
    edges = [half.start, *inside, half.end]
    return [Half(*pair) for pair in itertools.pairwise(edges)]


def _zero(torque: Curve, inside: float, way: int) -> float:
    """Where the torque changes its sign next to an angle at which the load drives. [rad]"""
    step = way * 2e-3
    return float(bracketed_roots(torque, np.array([inside]), np.array([inside + step]))[0])
