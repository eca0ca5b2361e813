"""A reduced machine: what the equation of motion asks of any machine, as polynomials over the crank angle and laws."""

import math
from typing import Any, NamedTuple

TURN = 2 * math.pi
DEGREE = 11
"""Of the polynomials in which smooth coefficients of the crank angle are written."""
INERTIA, WEIGHT, OUTPUT = range(3)
"""Coefficients of every machine, by their places: J, the torque that weights take at the crank, x′ of what is driven.

Those of loads and chambers come after them.
"""
BY_SPEED, BY_ANGLE, BY_TRAVEL = range(3)
"""Laws of loads."""


class ReducedLoad(NamedTuple):
    """One load: numbers of its law, and where its coefficients stand.

    Attributes
    ----------
    law : int
        `BY_SPEED`, `BY_ANGLE` or `BY_TRAVEL`.
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
        Its points among those of all.
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

    Under the pistons is the ambient pressure.
    """

    volume: int
    suction_pressure: float
    discharge_pressure: float
    compression_exponent: float
    expansion_exponent: float
    ambient: float


LAW, RATE, PLACE, IS_SQUARED, RESISTS, COUNTS, SIZE, AT, EXPONENT, FIRST, N_POINTS, ORIGIN, PERIOD = range(13)
"""Where the fields of `ReducedLoad` stand in its row: a compiled kernel then serves machines of any number of loads."""
VOLUME, SUCTION, DISCHARGE, COMPRESSION, EXPANSION, AMBIENT = range(6)
"""And those of `ReducedChamber`."""


class ReducedMachine(NamedTuple):
    """A machine of one design: arrays, or lists of the same for a run that is not compiled.

    Attributes
    ----------
    pieces : Array, shape (piece, coefficient · (`DEGREE` + 1))
        Of a turn, pieces of equal width; polynomials of each coefficient by −1…1 within a piece, the constant first.
    loads : Array, shape (load, field of `ReducedLoad`)
    points : Array, shape (point, 3)
        Of all loads: angle or travel, size on the way out, size on the way back.
    chambers : Array, shape (chamber, field of `ReducedChamber`)
    memory : Array, shape (chamber, 2)
        Of each chamber p·Vⁿ, and n.
    """

    pieces: Any
    loads: Any
    points: Any
    chambers: Any
    memory: Any


def reduced_machine(angle: float, speed: float, sense: float, machine: ReducedMachine) -> Any:
    """J, J′, torque that loads, weights and gas take at the crank, and x′ of what is driven.

    Parameters
    ----------
    angle, speed, sense : float
        Of the crank; the sense is that of a motion which may be about to begin. [rad, rad/s, 1]
    machine : ReducedMachine

    Notes
    -----
    docs/theory/reduced-machine, eqs. (31.1) to (31.5).
    """
    piece, x, by_angle = place_of(angle, len(machine.pieces))
    row = machine.pieces[piece]
    inertia, slope = value_and_slope(row, INERTIA, x)
    torque = value_of(row, WEIGHT, x)
    for at in range(len(machine.loads)):
        torque -= _load_torque(machine.loads[at], row, x, angle, speed, sense, machine.points)
    for at in range(len(machine.chambers)):
        chamber, held = machine.chambers[at], machine.memory[at]
        volume, by_x = value_and_slope(row, int(chamber[VOLUME]), x)
        pressure, _, _ = gas_in(chamber, held[0], held[1], volume)
        torque -= (pressure - chamber[AMBIENT]) * by_x * by_angle
    return inertia, slope * by_angle, torque, value_of(row, OUTPUT, x)


def settle(angle: float, machine: ReducedMachine) -> None:
    """Let every chamber remember its gas as it is at a crank angle. [rad]"""
    piece, x, _ = place_of(angle, len(machine.pieces))
    for at in range(len(machine.chambers)):
        chamber, held = machine.chambers[at], machine.memory[at]
        volume = value_of(machine.pieces[piece], int(chamber[VOLUME]), x)
        _, constant, exponent = gas_in(chamber, held[0], held[1], volume)
        held[0] = constant
        held[1] = exponent


def place_of(angle: float, n_pieces: int) -> Any:
    """In which piece of the turn an angle lies, its place −1…1 within, and the slope of that by the angle."""
    turns = angle / TURN
    along = (turns - math.floor(turns)) * n_pieces
    piece = min(int(along), n_pieces - 1)
    return piece, 2 * (along - piece) - 1, n_pieces / math.pi


def gas_in(chamber: Any, constant: float, exponent: float, volume: float) -> Any:
    """Pressure [Pa] in a chamber that remembers p·Vⁿ and n, and what it then remembers. Eq. (31.5)"""
    pressure = constant * volume**-exponent
    if pressure < chamber[SUCTION]:
        pressure, exponent = chamber[SUCTION], chamber[COMPRESSION]
    elif pressure > chamber[DISCHARGE]:
        pressure, exponent = chamber[DISCHARGE], chamber[EXPANSION]
    else:
        return pressure, constant, exponent
    return pressure, pressure * volume**exponent, exponent


def value_of(row: Any, which: int, x: float) -> float:
    """A coefficient at the place −1…1 within a piece."""
    first = which * (DEGREE + 1)
    value = row[first + DEGREE]
    for power in range(DEGREE - 1, -1, -1):
        value = value * x + row[first + power]
    return value


def value_and_slope(row: Any, which: int, x: float) -> Any:
    """A coefficient, and its slope by the place, −1…1 within a piece."""
    first = which * (DEGREE + 1)
    value, slope = row[first + DEGREE], 0.0
    for power in range(DEGREE - 1, -1, -1):
        slope = slope * x + value
        value = value * x + row[first + power]
    return value, slope


def _load_torque(load: Any, row: Any, x: float, angle: float, speed: float, sense: float, points: Any) -> float:
    """Torque that a load gives to the crank. [N·m]"""
    rate = load[COUNTS] if load[RATE] < 0 else value_of(row, int(load[RATE]), x)
    if load[IS_SQUARED] > 0:
        rate = math.sqrt(max(rate, 0.0))
    way = load[COUNTS] * rate
    size = _size_of(load, row, x, angle, way * speed, way * sense, points)
    if load[RESISTS] > 0:
        return -abs(rate) * size * sense
    return rate * size


def _size_of(load: Any, row: Any, x: float, angle: float, speed: float, sense: float, points: Any) -> float:
    """Size of a load by its law, with the speed along its way, and the sense of that."""
    first, n_points = int(load[FIRST]), int(load[N_POINTS])
    if load[LAW] == BY_SPEED:
        return load[SIZE] * (abs(speed) / load[AT]) ** load[EXPONENT]
    if load[LAW] == BY_ANGLE:
        along = _between(points, first, n_points, (angle - load[ORIGIN]) % load[PERIOD], 1)
        return along * (abs(speed) / load[AT]) ** load[EXPONENT]
    travel = load[COUNTS] * value_of(row, int(load[PLACE]), x) - load[ORIGIN]
    return _between(points, first, n_points, travel, 1 if sense >= 0 else 2)


def _between(points: Any, first: int, n_points: int, at: float, column: int) -> float:
    """Straight lines from point to point; beyond the ends the last value."""
    low, high = first, first + n_points - 1
    if at <= points[low][0]:
        return points[low][column]
    if at >= points[high][0]:
        return points[high][column]
    while high - low > 1:
        middle = (low + high) // 2
        if at < points[middle][0]:
            high = middle
        else:
            low = middle
    share = (at - points[low][0]) / (points[high][0] - points[low][0])
    return points[low][column] + share * (points[high][column] - points[low][column])
