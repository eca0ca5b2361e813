"""An output that goes out and back once a turn: its two dead centres."""

from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import numpy as np

from cranktrain.layout.mechanisms import Mechanisms
from cranktrain.layout.wish.turning import TurnOfWish, about_dead_centre
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import bracketed_roots, turn_grid
from cranktrain.numerics.harmonics import TURN

_FLAT = 1e-12
"""Of the largest x′: below it there is a turning point, whichever way rounding points."""


class DeadCentre(NamedTuple):
    """Where an output turns back: crank angle [rad], position [m or rad], and its distance from there."""

    angle: float
    position: float
    turning: TurnOfWish


class Output(NamedTuple):
    """What the crank drives.

    Attributes
    ----------
    motion : callable
        From φ, shape (n,), to position and its derivatives by φ.
    high, low : DeadCentre
        Where the position is largest and smallest.
    """

    motion: Callable[[Array], Coefficient]
    high: DeadCentre
    low: DeadCentre

    @property
    def stroke(self) -> float:
        """From one dead centre to the other. [m or rad]"""
        return self.high.position - self.low.position


def output_of(mechanisms: Mechanisms, design: int, mechanism: int) -> Output | None:
    """Output of one mechanism of one design; None where it does not go out and back just once a turn."""
    raw = partial(_coordinate, mechanisms, design, mechanism)
    first = mechanisms.alone(design, mechanism, np.zeros(1))
    if hasattr(first, "slider"):
        return output(raw)
    samples = np.unwrap(raw(turn_grid()).value)
    middle = 0.5 * (np.min(samples) + np.max(samples))
    return output(partial(_counted, raw, middle))


def _coordinate(mechanisms: Mechanisms, design: int, mechanism: int, angle: Array) -> Coefficient:
    """Coordinate of the output of one mechanism of one design."""
    motion = mechanisms.alone(design, mechanism, np.ravel(angle))
    coordinate = motion.slider if hasattr(motion, "slider") else motion.rocker.angle
    return Coefficient(*(np.broadcast_to(part, (1, angle.size)).reshape(angle.shape) for part in coordinate))


def _counted(raw: Callable[[Array], Coefficient], middle: float, angle: Array) -> Coefficient:
    """Angles about their middle, without a jump of a turn."""
    value, slope, bend = raw(angle)
    return Coefficient(middle + np.mod(value - middle + np.pi, TURN) - np.pi, slope, bend)


def output(motion: Callable[[Array], Coefficient]) -> Output | None:
    """Find the dead centres of an output."""
    grid = turn_grid()
    first = motion(grid).first
    if not np.all(np.isfinite(first)):
        return None
    shown = np.where(np.abs(first) <= _FLAT * np.max(np.abs(first)), 0.0, first)
    signs = np.sign(shown)
    signs = np.where(signs == 0, np.roll(signs, 1), signs)
    turns = np.flatnonzero(signs != np.roll(signs, 1))
    if turns.size != 2:
        return None
    step = TURN / grid.size
    highs = [n for n in turns.tolist() if signs[n] < 0]
    lows = [n for n in turns.tolist() if signs[n] > 0]
    found = np.array([grid[highs[0]], grid[lows[0]]])
    angles = bracketed_roots(lambda angle: motion(angle).first, found - 1.5 * step, found + 0.5 * step)
    if not np.all(np.isfinite(angles)):
        return None
    values = motion(angles).value
    high, low = (
        DeadCentre(float(angle), float(value), about_dead_centre(motion, float(angle)))
        for angle, value in zip(angles, values, strict=True)
    )
    return Output(motion, high, low)
