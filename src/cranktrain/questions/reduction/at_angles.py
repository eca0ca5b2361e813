"""A reduced machine at many crank angles at once, as it turns forward through its cycle."""

from collections.abc import Callable, Hashable, Iterator, Sequence
from functools import lru_cache
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

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
"""A coefficient by its place, at the angles that are asked for, of their shape."""


_ORDERS = np.arange(1.0, DEGREE + 1)
_PLACES = np.linspace(-1.0, 1.0, 33)
"""In a piece, at which its extremes are looked for."""
_LOOKED = np.vander(_PLACES, DEGREE + 1, increasing=True)


class ReducedAt(NamedTuple):
    """What the equation of motion asks of a machine at some crank angles, each of shape (n,), of designs (design, n).

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

    def changed(self, change: Callable[[Array], Array]) -> "ReducedAt":
        """The same with every array changed."""
        powers = tuple(Power(change(one.coefficient), one.exponent) for one in self.powers)
        return ReducedAt(change(self.inertia), change(self.slope), change(self.load), powers, change(self.output))


def reduced_together(each: Sequence[ReducedAt]) -> ReducedAt:
    """Of designs of machines that are alike, at as many angles each: arrays of shape (design, n)."""
    powers = zip(*(one.powers for one in each), strict=True)
    coefficients = [Power(np.stack([one.coefficient for one in own]), own[0].exponent) for own in powers]
    inertia, slope, load, output = (
        np.stack([getattr(one, name) for one in each]) for name in ("inertia", "slope", "load", "output")
    )
    return ReducedAt(inertia, slope, load, tuple(coefficients), output)


def machines_together(each: Sequence[ReducedMachine]) -> ReducedMachine:
    """Machines of designs that are alike as one, whose arrays have the design as their first axis."""
    return ReducedMachine(*(np.stack(parts) for parts in zip(*each, strict=True)))


def reduced_of_each(each: Sequence[ReducedMachine], angle: Array) -> ReducedAt:
    """Machines that are alike, each at its crank angles, shape (design, n): as `reduced_at`, once for all that are one.

    Designs that differ in their drives alone have one machine, and mostly the same angles.
    """
    places = dict[tuple[int, bytes], int]()
    which = [
        places.setdefault((id(machine), own.tobytes()), len(places)) for machine, own in zip(each, angle, strict=True)
    ]
    first = [which.index(place) for place in range(len(places))]
    if len(first) == 1 < len(each):
        key = tuple((part.shape, part.tobytes()) for part in map(np.asarray, each[0]))
        found = _of_one(key, angle[0].tobytes())
        return found.changed(lambda curve: np.broadcast_to(curve, angle.shape))
    found = reduced_at(machines_together([each[place] for place in first]), angle[first])
    return found if len(first) == len(each) else found.changed(lambda curve: curve[which])


@lru_cache(maxsize=8)
def _of_one(machine: tuple[tuple[tuple[int, ...], bytes], ...], angle: bytes) -> ReducedAt:
    """A machine by its numbers at crank angles: of many designs, some after others, they are the same. (1, n)"""
    own = ReducedMachine(*(np.frombuffer(numbers).reshape(shape) for shape, numbers in machine))
    return reduced_at(machines_together([own]), np.frombuffer(angle)[np.newaxis])


def structure_of(machine: ReducedMachine) -> Hashable:
    """What machines have in common that can stand together: all but sizes of loads and pressures of chambers."""
    loads, chambers = np.asarray(machine.loads), np.asarray(machine.chambers)
    shapes = [np.shape(part) for part in machine]
    return *shapes, loads[:, _ALIKE_IN_LOADS].tobytes(), chambers[:, _ALIKE_IN_CHAMBERS].tobytes()


def reduced_at(machine: ReducedMachine, angle: Array) -> ReducedAt:
    """A machine that turns forward, at crank angles in its steady state; or machines of designs that stand together.

    Parameters
    ----------
    machine : ReducedMachine
        Or as `machines_together` gives it.
    angle : Array, shape (n,), or of designs (design, n)
        [rad]

    Notes
    -----
    docs/theory/reduced-machine, eqs. (31.1) to (31.5).
    """
    turns, (n_pieces, width) = angle / TURN, np.shape(machine.pieces)[-2:]
    along = (turns - np.floor(turns)) * n_pieces
    piece = np.minimum(along.astype(np.intp), n_pieces - 1)
    powers_of_place = np.vander(np.ravel(2 * (along - piece) - 1), DEGREE + 1, increasing=True)
    by_angle = n_pieces / np.pi
    of_all = np.asarray(machine.pieces).reshape(-1, width // (DEGREE + 1), DEGREE + 1)
    own = np.ravel(piece if angle.ndim == 1 else piece + n_pieces * np.arange(len(angle))[:, np.newaxis])

    def value(which: float) -> Array:
        return np.einsum("nk,nk->n", of_all[own, int(which)], powers_of_place).reshape(angle.shape)

    def slope(which: float) -> Array:
        of_place = powers_of_place[:, :-1]
        found = np.einsum("nk,nk,k->n", of_all[own, int(which), 1:], of_place, _ORDERS) * by_angle
        return found.reshape(angle.shape)

    load, powers = value(WEIGHT), list[Power]()
    for alike, row in _rows(machine.loads):
        rate = np.full(angle.shape, row[COUNTS]) if alike[RATE] < 0 else value(alike[RATE])
        rate = np.sqrt(np.maximum(rate, 0.0)) if alike[IS_SQUARED] > 0 else rate
        taken = np.abs(rate) if alike[RESISTS] > 0 else -rate
        size = _size(machine, alike, row, rate, value, angle)
        if alike[EXPONENT] != 0:
            powers.append(Power(taken * size * (np.abs(rate) / row[AT]) ** alike[EXPONENT], alike[EXPONENT]))
        else:
            load = load + taken * size
    for alike, chamber in _rows(machine.chambers):
        pressure = _steady_pressure(alike, chamber, value, slope)
        load = load - (pressure - chamber[AMBIENT]) * slope(alike[VOLUME])
    return ReducedAt(value(INERTIA), slope(INERTIA), load, tuple(powers), value(OUTPUT))


_ALIKE_IN_LOADS = [LAW, RATE, PLACE, IS_SQUARED, RESISTS, EXPONENT, FIRST, N_POINTS]
_ALIKE_IN_CHAMBERS = [VOLUME, COMPRESSION, EXPANSION]
"""Numbers that say which formula is meant, or are its exponents."""


def _rows(table: Any) -> Iterator[tuple[list[Any], list[Any]]]:
    """Rows of a table: numbers that all designs have in common, and the own ones of each, shape (design, 1)."""
    for row in np.moveaxis(np.asarray(table), -2, 0):
        alike: list[Any] = row.reshape(-1, row.shape[-1])[0].tolist()
        yield alike, alike if row.ndim == 1 else list(row.T[..., np.newaxis])


def has_inertia(machine: ReducedMachine, turning: float) -> bool:
    """Whether anything resists acceleration: what turns with the crank, or what the crank moves. [kg·m²]"""
    return turning > 0 or bool(np.any(_apart(machine)[:, int(INERTIA)] != 0))


def _apart(machine: ReducedMachine) -> Array:
    """Polynomials by pieces and coefficients, shape (piece, coefficient, `DEGREE` + 1)."""
    return np.asarray(machine.pieces).reshape(len(machine.pieces), -1, DEGREE + 1)


def _size(
    machine: ReducedMachine, alike: list[float], row: list[Any], rate: Array, value: _Coefficient, angle: Array
) -> Array:
    """Size of a load; of one that goes with a power of the speed where that is its own."""
    law = alike[LAW]
    if law == BY_SPEED:
        return np.full(angle.shape, row[SIZE])
    own = slice(int(alike[FIRST]), int(alike[FIRST] + alike[N_POINTS]))
    points = np.asarray(machine.curves if law == BY_CURVE else machine.points, dtype=np.float64)[..., own, :]
    if law in {BY_ANGLE, BY_CURVE}:
        at = np.mod(angle - row[ORIGIN], row[PERIOD])
    else:
        at = row[COUNTS] * value(alike[PLACE]) - row[ORIGIN]
    is_forth = row[COUNTS] * rate >= 0
    if angle.ndim == 1:
        return _along(law, points, at, is_forth)
    return np.stack([_along(law, *one) for one in zip(points, at, is_forth, strict=True)])


def _along(law: float, points: Array, at: Array, is_forth: NDArray[np.bool_]) -> Array:
    """Size of a load of one design by its points, or the pieces of its curve, at angles or places on its way."""
    if law == BY_CURVE:
        return _on_curve(points, at)
    forth = np.interp(at, points[:, 0], points[:, 1])
    return forth if law == BY_ANGLE else np.where(is_forth, forth, np.interp(at, points[:, 0], points[:, 2]))


def _on_curve(curve: Array, angle: Array) -> Array:
    """A load's curve, shape (piece, `CURVE_WIDTH`), at angles of its period."""
    own: Array = curve[np.searchsorted(curve[:, 0], angle, side="right") - 1]
    x: Array = 2 * (angle - own[:, 0]) / own[:, 1] - 1
    return np.einsum("nk,nk->n", own[:, 2:], np.vander(x, DEGREE + 1, increasing=True))


def _steady_pressure(alike: list[float], chamber: list[Any], value: _Coefficient, slope: _Coefficient) -> Array:
    """Pressure in a chamber in the steady state, as it turns forward, shape of the asked angles. [Pa]

    Compression from the largest volume on, re-expansion from the smallest; what reaches no discharge goes back along
    the same line.
    """
    suction, discharge, largest, smallest = (chamber[which] for which in (SUCTION, DISCHARGE, LARGEST, SMALLEST))
    compression, expansion = alike[COMPRESSION], alike[EXPANSION]
    volume, shrinks = value(alike[VOLUME]), slope(alike[VOLUME]) < 0
    pressed: Array = suction * (largest / volume) ** compression
    delivers = suction * np.atleast_1d(largest / smallest) ** compression > discharge
    spread = np.where(delivers, discharge * (smallest / volume) ** expansion, pressed)
    return np.where(shrinks, np.minimum(pressed, discharge), np.maximum(spread, suction))


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
