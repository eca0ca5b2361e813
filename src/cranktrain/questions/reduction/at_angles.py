"""A reduced machine at many crank angles at once, as it turns forward through its cycle."""

from collections.abc import Callable
from typing import NamedTuple, TypeAlias

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics.products import product
from cranktrain.questions.evenness.speed_law import Power
from cranktrain.transient.reduced import (
    AMBIENT,
    AT,
    BY_ANGLE,
    BY_CURVE,
    BY_SPEED,
    COMPRESSION,
    COUNTS,
    DEGREE,
    DISCHARGE,
    EXPANSION,
    EXPONENT,
    FIRST,
    INERTIA,
    IS_SQUARED,
    LARGEST,
    LAW,
    N_POINTS,
    ORIGIN,
    OUTPUT,
    PERIOD,
    PLACE,
    RATE,
    RESISTS,
    SIZE,
    SMALLEST,
    SUCTION,
    TURN,
    VOLUME,
    WEIGHT,
    ReducedMachine,
)

_Coefficient: TypeAlias = Callable[[float], Array]
"""A coefficient by its place, at the angles that are asked for, shape (n,)."""


_ORDERS = np.arange(1.0, DEGREE + 1)
_PLACES = np.linspace(-1.0, 1.0, 33)
"""In a piece, at which its extremes are looked for."""
_LOOKED = np.vander(_PLACES, DEGREE + 1, increasing=True)


class ReducedAt(NamedTuple):
    """What the equation of motion asks of a machine at some crank angles, each of shape (n,).

    Attributes
    ----------
    inertia, slope : Array
        J and J′. [kg·m², kg·m²/rad]
    load : Array
        Torque that it takes at the crank, without what depends on the speed. [N·m]
    powers : tuple of Power
        The rest of it, by the speed of the crank.
    output : Array
        x′ of what is driven. [m/rad or 1]
    """

    inertia: Array
    slope: Array
    load: Array
    powers: tuple[Power, ...]
    output: Array

    def taken(self, speed: Array) -> Array:
        """Torque that load and ½J′ω² take at the crank, at speeds of the crank, shape (n,). [N·m]"""
        return self.by_load(speed) + 0.5 * self.slope * speed * speed

    def by_load(self, speed: Array) -> Array:
        """Torque that the load takes at the crank, at speeds of the crank, shape (n,). [N·m]"""
        return sum((one.torque(speed) for one in self.powers), self.load + 0.0 * speed)


def reduced_at(machine: ReducedMachine, angle: Array) -> ReducedAt:
    """A machine that turns forward, at crank angles, shape (n,) [rad], in its steady state.

    docs/theory/reduced-machine, eqs. (31.1) to (31.5).
    """
    turns = angle / TURN
    along = (turns - np.floor(turns)) * len(machine.pieces)
    piece = np.minimum(along.astype(np.intp), len(machine.pieces) - 1)
    pieces, powers_of_place = _apart(machine), np.vander(2 * (along - piece) - 1, DEGREE + 1, increasing=True)
    by_angle = len(machine.pieces) / np.pi

    def value(which: float) -> Array:
        return np.einsum("nk,nk->n", pieces[piece, int(which)], powers_of_place)

    def slope(which: float) -> Array:
        own = pieces[piece, int(which), 1:]
        return np.einsum("nk,nk,k->n", own, powers_of_place[:, :-1], _ORDERS) * by_angle

    load, powers = value(WEIGHT), list[Power]()
    for row in np.asarray(machine.loads).tolist():
        rate = np.full(angle.shape, row[COUNTS]) if row[RATE] < 0 else value(row[RATE])
        rate = np.sqrt(np.maximum(rate, 0.0)) if row[IS_SQUARED] > 0 else rate
        taken = np.abs(rate) if row[RESISTS] > 0 else -rate
        size = _size(machine, row, rate, value, angle)
        if row[EXPONENT] != 0:
            powers.append(Power(taken * size * (np.abs(rate) / row[AT]) ** row[EXPONENT], row[EXPONENT]))
        else:
            load = load + taken * size
    for chamber, pressure in zip(machine.chambers, _steady_pressures(machine, value, slope), strict=True):
        load = load - (pressure - chamber[AMBIENT]) * slope(chamber[VOLUME])
    return ReducedAt(value(INERTIA), slope(INERTIA), load, tuple(powers), value(OUTPUT))


def has_inertia(machine: ReducedMachine, turning: float) -> bool:
    """Whether anything resists acceleration: what turns with the crank, or what the crank moves. [kg·m²]"""
    return turning > 0 or bool(np.any(_apart(machine)[:, int(INERTIA)] != 0))


def _apart(machine: ReducedMachine) -> Array:
    """Polynomials by pieces and coefficients, shape (piece, coefficient, `DEGREE` + 1)."""
    return np.asarray(machine.pieces).reshape(len(machine.pieces), -1, DEGREE + 1)


def _size(
    machine: ReducedMachine, row: list[float], rate: Array, value: Callable[[float], Array], angle: Array
) -> Array:
    """Size of a load; of one that goes with a power of the speed where that is its own."""
    if row[LAW] == BY_SPEED:
        return np.full(angle.shape, row[SIZE])
    rows = slice(int(row[FIRST]), int(row[FIRST] + row[N_POINTS]))
    shown = np.mod(angle - row[ORIGIN], row[PERIOD])
    if row[LAW] == BY_CURVE:
        return _on_curve(np.asarray(machine.curves, dtype=np.float64)[rows], shown)
    points: Array = np.asarray(machine.points, dtype=np.float64)[rows]
    at, out, back = points[:, 0], points[:, 1], points[:, 2]
    if row[LAW] == BY_ANGLE:
        return np.interp(shown, at, out)
    travel = row[COUNTS] * value(row[PLACE]) - row[ORIGIN]
    return np.where(row[COUNTS] * rate >= 0, np.interp(travel, at, out), np.interp(travel, at, back))


def _on_curve(curve: Array, angle: Array) -> Array:
    """A load's curve, shape (piece, `CURVE_WIDTH`), at angles of its period."""
    own: Array = curve[np.searchsorted(curve[:, 0], angle, side="right") - 1]
    x: Array = 2 * (angle - own[:, 0]) / own[:, 1] - 1
    return np.einsum("nk,nk->n", own[:, 2:], np.vander(x, DEGREE + 1, increasing=True))


def _steady_pressures(machine: ReducedMachine, value: _Coefficient, slope: _Coefficient) -> list[Array]:
    """Pressure in each chamber in the steady state, as it turns forward, shape of the asked angles. [Pa]

    Compression from the largest volume on, re-expansion from the smallest; what reaches no discharge goes back along
    the same line.
    """
    found: list[Array] = []
    for chamber in np.asarray(machine.chambers).tolist():
        largest, smallest = chamber[LARGEST], chamber[SMALLEST]
        volume, shrinks = value(chamber[VOLUME]), slope(chamber[VOLUME]) < 0
        pressed: Array = chamber[SUCTION] * (largest / volume) ** chamber[COMPRESSION]
        delivers = chamber[SUCTION] * (largest / smallest) ** chamber[COMPRESSION] > chamber[DISCHARGE]
        spread: Array = chamber[DISCHARGE] * (smallest / volume) ** chamber[EXPANSION] if delivers else pressed
        pressures: tuple[Array, Array] = (np.minimum(pressed, chamber[DISCHARGE]), np.maximum(spread, chamber[SUCTION]))
        found.append(np.where(shrinks, *pressures))
    return found


def extremes_over_turn(pieces: Array) -> tuple[float, float]:
    """Largest and smallest value over the turn of a coefficient, by its polynomials, shape (piece, `DEGREE` + 1)."""
    samples = product(pieces, _LOOKED.T)
    return _extreme(pieces, samples, 1.0), _extreme(pieces, samples, -1.0)


def _extreme(pieces: Array, samples: Array, sign: float) -> float:
    """Largest value (1) or smallest (−1), by Newton's method from the most extreme of the samples."""
    at = int(np.argmax(sign * samples))
    piece, place = divmod(at, samples.shape[1])
    curve: list[float] = pieces[piece].tolist()
    slope = [order * one for order, one in enumerate(curve)][1:]
    bend = [order * one for order, one in enumerate(slope)][1:]
    x = float(_PLACES[place])
    for _ in range(6):
        turn = _value(bend, x)
        x = min(max(x - _value(slope, x) / turn, -1.0), 1.0) if turn else x
    return sign * max(sign * _value(curve, x), sign * float(samples[piece, place]))


def _value(polynomial: list[float], x: float) -> float:
    """Value of a polynomial, the constant first."""
    found = 0.0
    for one in reversed(polynomial):
        found = found * x + one
    return found
