"""A reduced machine: what the equation of motion asks of any machine, as polynomials over the crank angle and laws."""

import math
from typing import Any, NamedTuple

import numpy as np

from cranktrain.motion import Array

TURN = 2 * math.pi
DEGREE = 11
"""Of the polynomials in which smooth coefficients of the crank angle are written; `value_of` is written out for it."""
CURVE_WIDTH = 2 + DEGREE + 1
"""Numbers of a piece of a curve: where it begins, how wide it is, and its polynomial."""
INERTIA, WEIGHT, OUTPUT = range(3)
"""Coefficients of every machine, by their places: J, the torque that weights take at the crank, x′ of what is driven.

Those of loads and chambers come after them.
"""
BY_SPEED, BY_ANGLE, BY_TRAVEL, BY_CURVE = range(4)
"""Laws of loads: straight lines over angles or travel as declared, a curve as what the machine itself gives."""
_LARGEST_POWER = math.log(1e300)
"""Of the logarithm of a load's rise with its speed."""


class ReducedLoad(NamedTuple):
    """One load: numbers of its law, and where its coefficients stand.

    Attributes
    ----------
    law : int
        `BY_SPEED`, `BY_ANGLE`, `BY_TRAVEL` or `BY_CURVE`.
    rate, place : int
        Places of its rate along its way by the crank angle, and of how far it is; −1 of a torque on a shaft.
    is_squared : bool
        Whether the square of the rate stands there: of what goes wherever its point goes, whose rate has kinks.
    resists : bool
    counts : float
        −1 where its travel counts against its way; of a torque on a shaft the sense in which it counts.
    size, at, exponent : float
        Of a law by the speed; one by the angle goes with that power of the speed, too, mostly 0.
    first, n_points : int
        Its points among those of all, or its pieces among those of all curves.
    origin, period : float
        Of a law by the angle: φ where its angle is 0, and after how much it comes again. Of one by travel: where that
        begins. [rad; m or rad]
    """

    law: int
    rate: int
    place: int
    is_squared: bool
    resists: bool
    counts: float
    size: float
    at: float
    exponent: float
    first: int
    n_points: int
    origin: float
    period: float


class ReducedChamber(NamedTuple):
    """One chamber of a compressor, which remembers its gas: where its volume stands; pressures [Pa], exponents [1].

    Under the pistons is the ambient pressure. Largest and smallest volume over the turn. [m³]
    """

    volume: int
    suction_pressure: float
    discharge_pressure: float
    compression_exponent: float
    expansion_exponent: float
    ambient: float
    largest: float
    smallest: float


LAW, RATE, PLACE, IS_SQUARED, RESISTS, COUNTS, SIZE, AT, EXPONENT, FIRST, N_POINTS, ORIGIN, PERIOD = range(13)
"""Where the fields of `ReducedLoad` stand in its row: a compiled kernel then serves machines of any number of loads."""
VOLUME, SUCTION, DISCHARGE, COMPRESSION, EXPANSION, AMBIENT, LARGEST, SMALLEST = range(8)
"""And those of `ReducedChamber`."""


class ReducedMachine(NamedTuple):
    """A machine of one design.

    Attributes
    ----------
    pieces : Array, shape (piece, coefficient · (`DEGREE` + 1))
        Of a turn, pieces of equal width; polynomials of each coefficient by −1…1 within a piece, the constant first.
    loads : Array, shape (load, field of `ReducedLoad`)
    points : Array, shape (point, 3)
        Of all loads: angle or travel, size on the way out, size on the way back.
    curves : Array, shape (piece, `CURVE_WIDTH`)
        Of loads by a curve: where a piece of it begins, how wide it is [rad], and its polynomial as in `pieces`.
    chambers : Array, shape (chamber, field of `ReducedChamber`)
    memory : Array, shape (chamber, 4)
        Of each chamber p·Vⁿ, and n; from which volume on its gas is at the suction's pressure, and up to which at the
        discharge's. [m³]
    """

    pieces: Any
    loads: Any
    points: Any
    curves: Any
    chambers: Any
    memory: Any


_N_PIECES, _WIDTH, _N_LOADS, _N_CHAMBERS, _PIECES, _LOADS, _POINTS, _CURVES, _CHAMBERS, _MEMORY = range(10)
"""What stands first in the numbers of a machine for its kernel: how many there are, and where each begins."""
_HEAD = 10
_OUT, _BACK = 1, 2
"""Columns of points: sizes on the way out, and back."""
N_HELD = 4
"""Numbers that a chamber remembers."""
_CONSTANT, _EXPONENT, _DRAWS, _DELIVERS = range(N_HELD)
_N_FIELDS, _N_POINT, _N_CHAMBER = len(ReducedLoad._fields), 3, len(ReducedChamber._fields)


def in_one_row(machine: ReducedMachine) -> Array:
    """All numbers of a machine one after another, as its kernels take them.

    Arrays within a tuple, and views into them, would cost a compiled kernel ten times what it computes.
    """
    parts = [np.asarray(part, dtype=float) for part in machine]
    starts = _HEAD + np.concatenate([[0], np.cumsum([part.size for part in parts])[:-1]])
    head = [len(parts[0]), parts[0].shape[1], len(parts[1]), len(parts[4]), *starts.tolist()]
    return np.concatenate([np.array(head, dtype=float), *(part.ravel() for part in parts)])


def reduced_machine(angle: float, speed: float, sense: float, numbers: Any) -> Any:
    """J, J′, torque that loads, weights and gas take at the crank, and x′ of what is driven.

    Parameters
    ----------
    angle, speed, sense : float
        Of the crank; the sense is that of a motion which may be about to begin. [rad, rad/s, 1]
    numbers : Array, or list of float
        Of `in_one_row`.

    Notes
    -----
    docs/theory/reduced-machine, eqs. (31.1) to (31.5).
    """
    row, x, by_angle = place_of(angle, numbers)
    inertia, slope = value_and_slope(numbers, row + INERTIA * (DEGREE + 1), x)
    torque = value_of(numbers, row + WEIGHT * (DEGREE + 1), x)
    for at in range(int(numbers[_N_LOADS])):
        load = int(numbers[_LOADS]) + at * _N_FIELDS
        torque -= _load_torque(numbers, load, row, x, angle, speed, sense)
    for at in range(int(numbers[_N_CHAMBERS])):
        chamber, held = int(numbers[_CHAMBERS]) + at * _N_CHAMBER, int(numbers[_MEMORY]) + at * N_HELD
        volume, by_x = value_and_slope(numbers, row + int(numbers[chamber + VOLUME]) * (DEGREE + 1), x)
        pressure = _pressure_in(numbers, chamber, held, volume)
        torque -= (pressure - numbers[chamber + AMBIENT]) * by_x * by_angle
    return inertia, slope * by_angle, torque, value_of(numbers, row + OUTPUT * (DEGREE + 1), x)


def inertia_at(angle: float, numbers: Any) -> float:
    """J, as `reduced_machine` gives it. [kg·m²]"""
    row, x, _ = place_of(angle, numbers)
    return value_of(numbers, row + INERTIA * (DEGREE + 1), x)


def settle(angle: float, numbers: Any) -> None:
    """Let every chamber remember its gas as it is at a crank angle. [rad]"""
    row, x, _ = place_of(angle, numbers)
    for at in range(int(numbers[_N_CHAMBERS])):
        chamber, held = int(numbers[_CHAMBERS]) + at * _N_CHAMBER, int(numbers[_MEMORY]) + at * N_HELD
        volume = value_of(numbers, row + int(numbers[chamber + VOLUME]) * (DEGREE + 1), x)
        if volume >= numbers[held + _DRAWS]:
            _remember(numbers, chamber, held, numbers[chamber + SUCTION], numbers[chamber + COMPRESSION], volume)
        elif volume <= numbers[held + _DELIVERS]:
            _remember(numbers, chamber, held, numbers[chamber + DISCHARGE], numbers[chamber + EXPANSION], volume)


def filled_at(angle: float, numbers: Any, pressure: float = math.nan) -> None:
    """Fill every chamber with gas at a pressure [Pa]; unless given at its suction's, as after running unloaded."""
    row, x, _ = place_of(angle, numbers)
    for at in range(int(numbers[_N_CHAMBERS])):
        chamber, held = int(numbers[_CHAMBERS]) + at * _N_CHAMBER, int(numbers[_MEMORY]) + at * N_HELD
        volume = value_of(numbers, row + int(numbers[chamber + VOLUME]) * (DEGREE + 1), x)
        filled = numbers[chamber + SUCTION] if math.isnan(pressure) else pressure
        _remember(numbers, chamber, held, filled, numbers[chamber + COMPRESSION], volume)


def pressures_at(angle: float, numbers: Any, pressures: Any, column: int) -> None:
    """Write the absolute pressure of every chamber at a crank angle, by what it remembers, into a column. [rad, Pa]"""
    row, x, _ = place_of(angle, numbers)
    for at in range(int(numbers[_N_CHAMBERS])):
        chamber, held = int(numbers[_CHAMBERS]) + at * _N_CHAMBER, int(numbers[_MEMORY]) + at * N_HELD
        volume = value_of(numbers, row + int(numbers[chamber + VOLUME]) * (DEGREE + 1), x)
        pressures[at, column] = _pressure_in(numbers, chamber, held, volume)


def place_of(angle: float, numbers: Any) -> Any:
    """Where the polynomials of an angle begin, its place −1…1 in their piece, and the slope of that by the angle.

    The place is NaN where a step that is tried leads to no angle.
    """
    n_pieces = int(numbers[_N_PIECES])
    turns = angle / TURN
    if not abs(turns) < math.inf:
        return int(numbers[_PIECES]), math.nan, n_pieces / math.pi
    along = (turns - math.floor(turns)) * n_pieces
    piece = min(int(along), n_pieces - 1)
    row = int(numbers[_PIECES]) + piece * int(numbers[_WIDTH])
    return row, 2 * (along - piece) - 1, n_pieces / math.pi


def _pressure_in(numbers: Any, chamber: int, held: int, volume: float) -> float:
    """Pressure in a chamber that remembers its gas, by no power where a valve is open. Eq. (31.5) [Pa]"""
    if volume >= numbers[held + _DRAWS]:
        return numbers[chamber + SUCTION]
    if volume <= numbers[held + _DELIVERS]:
        return numbers[chamber + DISCHARGE]
    return numbers[held + _CONSTANT] * volume ** -numbers[held + _EXPONENT]


def _remember(numbers: Any, chamber: int, held: int, pressure: float, exponent: float, volume: float) -> None:
    """Let a chamber remember gas at a pressure in a volume, with the exponent by which that changes from there."""
    numbers[held + _CONSTANT] = pressure * volume**exponent
    numbers[held + _EXPONENT] = exponent
    numbers[held + _DRAWS] = volume * (pressure / numbers[chamber + SUCTION]) ** (1.0 / exponent)
    numbers[held + _DELIVERS] = volume * (pressure / numbers[chamber + DISCHARGE]) ** (1.0 / exponent)


def value_of(numbers: Any, first: int, x: float) -> float:
    """A coefficient whose polynomial begins at a place, at −1…1 within its piece.

    Even and odd powers apart: two short chains of products are quicker than a long one.
    """
    y = x * x
    even, odd = numbers[first + 10], numbers[first + 11]
    even, odd = even * y + numbers[first + 8], odd * y + numbers[first + 9]
    even, odd = even * y + numbers[first + 6], odd * y + numbers[first + 7]
    even, odd = even * y + numbers[first + 4], odd * y + numbers[first + 5]
    even, odd = even * y + numbers[first + 2], odd * y + numbers[first + 3]
    even, odd = even * y + numbers[first], odd * y + numbers[first + 1]
    return even + x * odd


def value_and_slope(numbers: Any, first: int, x: float) -> Any:
    """A coefficient, and its slope by the place, −1…1 within a piece."""
    y = x * x
    rising, turning = 10 * numbers[first + 10], 11 * numbers[first + 11]
    rising, turning = rising * y + 8 * numbers[first + 8], turning * y + 9 * numbers[first + 9]
    rising, turning = rising * y + 6 * numbers[first + 6], turning * y + 7 * numbers[first + 7]
    rising, turning = rising * y + 4 * numbers[first + 4], turning * y + 5 * numbers[first + 5]
    rising, turning = rising * y + 2 * numbers[first + 2], turning * y + 3 * numbers[first + 3]
    return value_of(numbers, first, x), x * rising + turning * y + numbers[first + 1]


def _load_torque(numbers: Any, load: int, row: int, x: float, angle: float, speed: float, sense: float) -> float:
    """Torque that a load gives to the crank. [N·m]"""
    which, counts = int(numbers[load + RATE]), numbers[load + COUNTS]
    rate = counts if which < 0 else value_of(numbers, row + which * (DEGREE + 1), x)
    if numbers[load + IS_SQUARED] > 0:
        rate = math.sqrt(max(rate, 0.0))
    size = _size_of(numbers, load, row, x, angle, counts * rate * speed, counts * rate * sense)
    if numbers[load + RESISTS] > 0:
        return -abs(rate) * size * sense
    return rate * size


def _size_of(numbers: Any, load: int, row: int, x: float, angle: float, speed: float, sense: float) -> float:
    """Size of a load by its law, with the speed along its way, and the sense of that."""
    law, exponent = numbers[load + LAW], numbers[load + EXPONENT]
    by_speed = 1.0 if exponent == 0 else _power(abs(speed) / numbers[load + AT], exponent)
    if law == BY_SPEED:
        return numbers[load + SIZE] * by_speed
    shown = (angle - numbers[load + ORIGIN]) % numbers[load + PERIOD]
    if law == BY_ANGLE:
        return by_speed * _between(numbers, load, shown, 1 * _OUT)
    if law == BY_CURVE:
        return by_speed * _on_curve(numbers, load, shown)
    place = value_of(numbers, row + int(numbers[load + PLACE]) * (DEGREE + 1), x)
    travel = numbers[load + COUNTS] * place - numbers[load + ORIGIN]
    return _between(numbers, load, travel, _OUT if sense >= 0 else _BACK)


def _power(base: float, exponent: float) -> float:
    """Power of a ratio of speeds, infinite where no number is as large, which interpreted Python refuses."""
    if base > 1.0 and exponent * math.log(base) > _LARGEST_POWER:
        return math.inf
    return base**exponent


def _between(numbers: Any, load: int, at: float, column: int) -> float:
    """Straight lines between a load's points; beyond the ends the last value."""
    first = int(numbers[_POINTS]) + int(numbers[load + FIRST]) * _N_POINT
    high = int(numbers[load + N_POINTS]) - 1
    if at <= numbers[first]:
        return numbers[first + column]
    if at >= numbers[first + high * _N_POINT]:
        return numbers[first + high * _N_POINT + column]
    low = _last_before(numbers, first, 1 * _N_POINT, high, at)
    one, other = first + low * _N_POINT, first + (low + 1) * _N_POINT
    share = (at - numbers[one]) / (numbers[other] - numbers[one])
    return numbers[one + column] + share * (numbers[other + column] - numbers[one + column])


def _on_curve(numbers: Any, load: int, at: float) -> float:
    """A load's curve at an angle of its period."""
    first = int(numbers[_CURVES]) + int(numbers[load + FIRST]) * CURVE_WIDTH
    piece = first + _last_before(numbers, first, 1 * CURVE_WIDTH, int(numbers[load + N_POINTS]), at) * CURVE_WIDTH
    return value_of(numbers, piece + 2, 2 * (at - numbers[piece]) / numbers[piece + 1] - 1)


def _last_before(numbers: Any, first: int, width: int, n_rows: int, at: float) -> int:
    """Which of some rows, each beginning with where it stands, is the last that does not stand beyond a place."""
    low, high = 0, n_rows
    while high - low > 1:
        middle = (low + high) // 2
        if at < numbers[first + middle * width]:
            high = middle
        else:
            low = middle
    return low
