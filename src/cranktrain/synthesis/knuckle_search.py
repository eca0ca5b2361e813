"""Search for the knuckle geometry that meets requirements: every solution over a dimension's range, to rounding."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.mechanisms.articulated_rod import ArticulatedRod
from cranktrain.mechanisms.articulated_rod.kinematics import articulated_rod_gap
from cranktrain.motion import Array, single
from cranktrain.numerics import bracketed_roots, smallest, turn_grid
from cranktrain.numerics.nested import each_changed, mapped
from cranktrain.numerics.ties import largest_first
from cranktrain.synthesis.knuckle_equations import (
    HALF_THE_DIGITS,
    NEWTON_STEPS,
    Free,
    distance_slope,
    slave_dead_centres,
    unshifted_angle,
)
from cranktrain.synthesis.knuckle_slave import Goal, KnuckleRequirements, goals_of

_SAMPLES = 480
_WIDEST_OFFSET_ANGLE = 75 * np.pi / 180
_LONGEST = 1.2
"""Longest knuckle radius or slave rod that is looked at, in parts of the master's crank radius and rod together."""


def _with_value(rod: ArticulatedRod, free: Free, value: Array) -> ArticulatedRod:
    """Give the rod with one of its dimensions replaced."""
    return mapped(lambda name, own: value if name == free else own, rod)


def _solved(rod: ArticulatedRod, goal: Goal, free: Free) -> ArticulatedRod:
    """Meet one goal by one dimension, by Newton's method with the slopes in closed form; NaN where it finds none."""
    with np.errstate(all="ignore"):
        for _step in range(NEWTON_STEPS):
            at = slave_dead_centres(rod)
            slope = goal.of(distance_slope(at.top_angle, rod, free), distance_slope(at.bottom_angle, rod, free))
            step = (goal.of(at.top, at.bottom) - goal.target) / slope
            rod = _with_value(rod, free, getattr(rod, free) - step)
            if not np.any(np.abs(step) > HALF_THE_DIGITS * np.abs(getattr(rod, free))):
                break
    return rod


class Search(NamedTuple):
    """What a search found: rods that meet the requirements, and the range of what the first goal is of. [m]

    The range is NaN where there is nothing to search.
    """

    rods: tuple[ArticulatedRod, ...]
    least: float
    most: float


def searched(rod: ArticulatedRod, requirements: KnuckleRequirements, free: Sequence[Free]) -> Search:
    """Meet requirements: an unshifted dead centre in closed form, one goal by one dimension, or two by two.

    Parameters
    ----------
    rod : ArticulatedRod
        With its given dimensions; the free ones are where the search for the second begins.
    requirements : KnuckleRequirements
        With two goals at most.
    free : sequence of str
        As many dimensions as goals. The first goal is met by the first over its whole range, the second, if any, by the
        second at every step.

    Returns
    -------
    Search
        Rods that close all round the turn, the one nearest to the start first.
    """
    if requirements.unshifted is not None:
        rod = rod._replace(articulation_angle=unshifted_angle(rod, requirements.unshifted))
    goals = list(goals_of(requirements, rod.master))
    if not goals:
        return Search((rod,) if is_usable(rod) else (), np.nan, np.nan)

    def at(value: Array) -> ArticulatedRod:
        tried = _with_value(rod, free[0], value)
        if len(goals) == 1:
            return tried
        start = _with_value(tried, free[1], getattr(tried, free[1]) + 0.0 * value)
        return _solved(start, goals[1], free[1])

    def curve(value: Array) -> Array:
        reached = slave_dead_centres(at(value))
        return goals[0].of(reached.top, reached.bottom) - goals[0].target

    grid = _range(rod, free[0])
    with np.errstate(invalid="ignore"):
        samples = curve(grid)
    changes = np.flatnonzero(np.sign(samples[:-1]) * np.sign(samples[1:]) <= 0)
    solved = at(bracketed_roots(curve, grid[changes], grid[changes + 1]))
    usable = [rod for rod in _one_by_one(solved, len(changes)) if is_usable(rod)]
    rods = largest_first(usable, lambda found: -_distance(found, rod))
    reached = samples[~np.isnan(samples)] + goals[0].target
    least, most = (float(np.min(reached)), float(np.max(reached))) if reached.size else (np.nan, np.nan)
    return Search(tuple(rods), least, most)


def _distance(one: ArticulatedRod, other: ArticulatedRod) -> float:
    """How far apart two knuckle geometries are: angles in radians, lengths in parts of the master rod."""
    lengths = abs(one.knuckle_radius - other.knuckle_radius) + abs(one.rod_length - other.rod_length)
    return float(abs(one.articulation_angle - other.articulation_angle) + lengths / other.master.rod_length)


def _range(rod: ArticulatedRod, free: Free) -> Array:
    """Values of a dimension to look at."""
    if free == "articulation_angle":
        middle = float(rod.bank_angle)
        return middle + _WIDEST_OFFSET_ANGLE * np.linspace(-1.0, 1.0, _SAMPLES, dtype=np.float64)
    longest = _LONGEST * float(rod.master.crank_radius + rod.master.rod_length)
    return longest * np.linspace(0.0, 1.0, _SAMPLES + 1, dtype=np.float64)[1:]


def _one_by_one(rods: ArticulatedRod, n_rods: int) -> list[ArticulatedRod]:
    """Take stacked rods apart into rods of single numbers."""
    return [
        each_changed(lambda value, i=i: single(float(np.broadcast_to(value, n_rods)[i])), rods) for i in range(n_rods)
    ]


def is_usable(rod: ArticulatedRod) -> bool:
    """Whether the rod has positive lengths and closes all round the turn."""
    if not (rod.knuckle_radius > 0 and rod.rod_length > 0 and np.isfinite(rod.articulation_angle)):
        return False
    with np.errstate(invalid="ignore"):
        least = smallest(lambda angle: articulated_rod_gap(angle, rod), grid=turn_grid(180)).value
    return bool(least[0] > 0)
