"""From a declared machine to the reduced machines of all its designs, which the equation of motion turns."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from cranktrain.fluids.compressor.pressure import Compressor
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.load_laws import ByAngle, BySpeed, ByTravel, Law
from cranktrain.layout.loads import LinkLoad
from cranktrain.layout.shaft_loads import LoadsOnShafts, TorqueOnShaft
from cranktrain.layout.speed import Speed
from cranktrain.motion import Array
from cranktrain.numerics.polyline import Polyline
from cranktrain.questions.evenness.spec import GivenFlywheel
from cranktrain.questions.forces.events import ForceEvents, friction_kinks, with_kinks, with_rows
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.gas.chambers import Filling, GasInChambers
from cranktrain.questions.reduction.at_angles import extremes_over_turn
from cranktrain.questions.reduction.curve_pieces import curve_pieces
from cranktrain.questions.reduction.smooth import smooth_pieces
from cranktrain.record import record
from cranktrain.transient.reduced import (
    BY_ANGLE,
    BY_CURVE,
    BY_SPEED,
    BY_TRAVEL,
    CURVE_WIDTH,
    DEGREE,
    N_HELD,
    ReducedChamber,
    ReducedLoad,
    ReducedMachine,
)

_OF_ALL = 3
"""Coefficients that every machine has: J, weights, x′ of what is driven."""


@record
class ReducedMachines:
    """The reduced machine of every design, and where its loads have jumps or corners.

    Attributes
    ----------
    each : tuple of ReducedMachine
        One and the same of designs whose numbers are.
    corners : Array, shape (design, corner)
        φ; NaN fills up. [rad]
    misses : Array, of that shape
        As those of `ForceEvents`.
    cycle : float
        After which all comes again. [rad]
    """

    each: tuple[ReducedMachine, ...]
    corners: Array
    misses: Array
    cycle: float


class _Way(NamedTuple):
    """A load on a link, and the places of its coefficients: rate, or its square, and place."""

    load: LinkLoad
    is_squared: bool
    rate: int
    place: int

    @property
    def n_coefficients(self) -> int:
        """How many it takes."""
        return 1 if self.place < 0 else 2


class _Curve(NamedTuple):
    """A torque on the crank by φ, of each design; it may go with a power of the speed of the crank over another."""

    pieces: Sequence[Array]
    resists: bool
    at: Array
    exponent: float


def reduced_machines(
    loaded: LoadedMachine,
    on_shafts: LoadsOnShafts | None,
    flywheel: GivenFlywheel | None,
    events: ForceEvents,
    crank_angle: CrankAngle,
) -> ReducedMachines:
    """Reduce a machine, as its file declares it, to the crank.

    Notes
    -----
    docs/theory/reduced-machine, eqs. (31.1) to (31.5), (31.15). Gas other than a compressor's comes back with the crank
    angle, over its cycle. Friction in guides goes between that at rest and that at the declared speed with ω²,
    eq. (31.11).
    """
    ways = _ways(() if loaded.loads is None else loaded.loads.each)
    remembering = [] if loaded.gas is None else loaded.gas.filled_with("compressor")
    pieces = smooth_pieces(_coefficients(loaded, ways, remembering))
    if flywheel is not None:
        pieces[:, :, 0, 0] += flywheel.inertia[:, np.newaxis]
    first_volume = _OF_ALL + sum(way.n_coefficients for way in ways)
    on_shaft = () if on_shafts is None else on_shafts.given
    of_all = with_rows(
        _with_friction_at_rest(loaded, events, crank_angle), [load.law for load in on_shaft], crank_angle
    )
    cycle = crank_angle.cycle
    curves = [*_gas_over_cycle(loaded, remembering, of_all.whole, cycle), *_friction(loaded, of_all.whole, cycle)]

    @cache
    def extremes(polynomials: bytes) -> tuple[float, float]:
        return extremes_over_turn(np.frombuffer(polynomials).reshape(-1, DEGREE + 1))

    each = (
        ReducedMachine(
            own.reshape(len(own), -1),
            *_loads(loaded, ways, on_shaft, curves, design, crank_angle),
            *_chambers(loaded.gas, own, first_volume, design, extremes),
        )
        for design, own in enumerate(pieces)
    )
    return ReducedMachines(_each_once(each), of_all.whole, of_all.misses, cycle)


def _each_once(machines: Iterable[ReducedMachine]) -> tuple[ReducedMachine, ...]:
    """Machines in their order, those whose numbers are the same as one and the same machine."""
    known = dict[tuple[bytes, ...], ReducedMachine]()
    return tuple(known.setdefault(tuple(part.tobytes() for part in one), one) for one in machines)


def _ways(loads: Sequence[LinkLoad]) -> list[_Way]:
    """Places of the coefficients of loads, after those that every machine has."""
    found: list[_Way] = []
    at = _OF_ALL
    for load in loads:
        goes_anywhere = load.resists and not (load.is_torque or load.is_slider)
        is_squared = goes_anywhere and load.radius is None and load.direction is None
        has_place = isinstance(load.law, ByTravel)
        found.append(_Way(load, is_squared, at, at + 1 if has_place else -1))
        at += found[-1].n_coefficients
    return found


def _coefficients(
    loaded: LoadedMachine, ways: Sequence[_Way], remembering: Sequence[Filling]
) -> Callable[[Array], Array]:
    """Smooth coefficients of a machine at φ, shape (n,), in their order, shape (design, coefficient, n)."""

    def at(angle: Array) -> Array:
        motions = loaded.motions(angle)
        inertia, weight = _reduced(loaded, motions)
        output = next(m for m, b in zip(motions, loaded.mechanisms.batches, strict=True) if 0 in b.index)
        driven = output.slider if hasattr(output, "slider") else output.rocker.angle
        rows = [inertia, weight, driven.first[:, 0]]
        for way in ways:
            along = loaded.load_way(way.load, angle)
            rows.append(_by_angle(along.rate * along.rate if way.is_squared else along.rate))
            rows += [_by_angle(along.place)] if way.place >= 0 else []
        if loaded.gas is not None and remembering:
            volume = loaded.gas.volume(angle).value
            rows += [volume[:, place] for filling in remembering for place in filling.places]
        shape = (max(map(len, rows)), angle.size)
        return np.stack([np.broadcast_to(row, shape) for row in rows], axis=1)

    return at


def _by_angle(values: Array | float) -> Array:
    """What is of one link, shape (design, n) or (1, 1): the crank's own rate is 1 everywhere."""
    return np.broadcast_to(values, np.broadcast_shapes(np.shape(values), (1, 1, 1)))[:, 0]


def _reduced(loaded: LoadedMachine, motions: Sequence[Any]) -> tuple[Array, Array]:
    """J, and the torque that weights take at the crank, shape (design, n). [kg·m², N·m]"""
    inertia, weight = np.zeros((2, 1, 1))
    for batch, motion, made in zip(loaded.mechanisms.batches, motions, loaded.masses.batches, strict=True):
        dynamics, size = batch.kind.dynamics, batch.members.geometry
        unloaded = dynamics.load(motion, size, np.zeros((1, 1, 1)))
        found = dynamics.reduced(motion, size, made.bodies, unloaded, made.gravity)
        inertia = inertia + np.sum(found.inertia.value, axis=1)
        weight = weight - np.sum(found.load + 0 * found.inertia.value, axis=1)
    return inertia, weight


def _loads(
    loaded: LoadedMachine,
    ways: Sequence[_Way],
    on_shaft: Sequence[TorqueOnShaft],
    curves: Sequence[_Curve],
    design: int,
    crank_angle: CrankAngle,
) -> tuple[Array, Array, Array]:
    """Rows of all loads of a design, their points, and the pieces of curves."""
    rows: list[ReducedLoad] = []
    points: list[tuple[float, float, float]] = []
    zero = float(crank_angle.zero[design, 0, 0])
    for way in ways:
        load = way.load
        row = _NOTHING._replace(
            rate=way.rate, place=way.place, is_squared=way.is_squared, resists=load.resists, counts=load.counts
        )
        rows.append(_with_law(row, load.law, design, zero, points))
        if isinstance(load.law, ByTravel):
            rows[-1] = rows[-1]._replace(origin=float(_of(loaded.travel_starts[load.name], design)))
    for torque in on_shaft:
        row = _NOTHING._replace(counts=1.0 if torque.resists else torque.sense, resists=torque.resists)
        rows.append(_with_law(row, torque.law, design, zero, points))
    pieces, n_pieces = [curve.pieces[design] for curve in curves], 0
    for curve, own in zip(curves, pieces, strict=True):
        row = _NOTHING._replace(law=BY_CURVE, first=n_pieces, n_points=len(own), period=crank_angle.cycle)
        rows.append(row._replace(resists=curve.resists, at=float(_of(curve.at, design)), exponent=curve.exponent))
        n_pieces += len(own)
    no_pieces = np.empty((0, CURVE_WIDTH))
    return _table(rows, len(_NOTHING)), _table(points, 3), np.concatenate([no_pieces, *pieces])


_NOTHING = ReducedLoad(BY_SPEED, -1, -1, False, False, 1.0, 0.0, 1.0, 0.0, 0, 0, 0.0, 1.0)
"""A torque of 0 on the shaft."""


def _with_law(
    row: ReducedLoad, law: Law, design: int, zero: float, points: list[tuple[float, float, float]]
) -> ReducedLoad:
    """A load with its law, whose points are put to those of others."""
    if isinstance(law, BySpeed):
        size, at, exponent = (float(_of(part, design)) for part in law)
        return row._replace(law=BY_SPEED, size=size, at=at, exponent=exponent)
    if isinstance(law, ByAngle):
        lines = law.polylines
        return _round(row, lines[min(design, len(lines) - 1)], zero, points)
    own = zip(*(part[min(design, len(part) - 1)] for part in law), strict=True)
    first = len(points)
    points += [(float(place), float(out), float(back)) for place, out, back in own]
    return row._replace(law=BY_TRAVEL, first=first, n_points=len(points) - first)


def _round(row: ReducedLoad, lines: Polyline, origin: float, points: list[tuple[float, float, float]]) -> ReducedLoad:
    """A load by straight lines over crank angles: with the last point before the first, and the first after it."""
    angles = [float(lines.angles[-1]) - lines.period, *lines.angles.tolist(), float(lines.angles[0]) + lines.period]
    values = [float(lines.values[-1]), *lines.values.tolist(), float(lines.values[0])]
    first = len(points)
    points += [(angle, value, value) for angle, value in zip(angles, values, strict=True)]
    return row._replace(law=BY_ANGLE, first=first, n_points=len(angles), origin=origin, period=lines.period)


def _of(part: Array, design: int) -> Any:
    """The number of one design, or that of all."""
    return part[min(design, len(part) - 1)].item()


def _table(rows: Sequence[tuple[Any, ...]], width: int) -> Array:
    """Rows of numbers as an array, of the right width where there is none."""
    return np.array(rows, dtype=float).reshape(-1, width)


def _chambers(
    gas: GasInChambers | None,
    pieces: Array,
    first_volume: int,
    design: int,
    extremes: Callable[[bytes], tuple[float, float]],
) -> tuple[Array, Array]:
    """Chambers of compressors of one design, and room for what they remember."""
    rows: list[ReducedChamber] = []
    fillings = [] if gas is None else [(gas.chambers, filling) for filling in gas.filled_with("compressor")]
    for chambers, filling in fillings:
        for place in filling.places.tolist():
            own: Compressor = filling.of_chamber(design, place)
            largest, smallest = extremes(pieces[:, first_volume + len(rows)].tobytes())
            rows.append(
                ReducedChamber(
                    volume=first_volume + len(rows),
                    suction_pressure=_only(own.suction_pressure),
                    discharge_pressure=_only(own.discharge_pressure),
                    compression_exponent=_only(own.compression_exponent),
                    expansion_exponent=_only(own.expansion_exponent),
                    ambient=_only(chambers.ambient[design, place]),
                    largest=largest,
                    smallest=smallest,
                )
            )
    return _table(rows, len(ReducedChamber._fields)), np.zeros((len(rows), N_HELD))


def _only(number: Array) -> float:
    """A number that stands alone in its array."""
    return float(np.ravel(number)[0])


def _gas_over_cycle(
    loaded: LoadedMachine, remembering: Sequence[Filling], corners: Array, cycle: float
) -> Iterator[_Curve]:
    """Torque that all other gas gives to the crank over its cycle; nothing without such gas."""
    gas = loaded.gas
    if gas is None or len(remembering) == len(gas.fillings):
        return
    own = np.ones(gas.chambers.areas.shape[-1], dtype=np.bool_)
    for filling in remembering:
        own[filling.places] = False

    def torque(angle: Array) -> Array:
        volume = gas.volume(angle)
        over = gas.pressure(angle, volume) - gas.chambers.ambient[..., np.newaxis]
        return np.sum((over * volume.first)[:, own], axis=1)

    yield _Curve(curve_pieces(torque, corners, cycle), False, np.ones(1), 0.0)


def _friction(loaded: LoadedMachine, corners: Array, cycle: float) -> Iterator[_Curve]:
    """Torque that friction takes at the crank: at rest, and what is more of it at the declared speed."""
    if not loaded.masses.has_friction:
        return
    at_rest = _at_rest(loaded)

    def rubbed(machine: LoadedMachine, angle: Array) -> Array:
        each = [np.sum(one.forces.friction_torque, axis=1) for one in machine.solved(angle)]
        return -sum(each, np.zeros((len(angle), angle.shape[-1])))

    still = curve_pieces(lambda angle: rubbed(at_rest, angle), corners, cycle)
    more = curve_pieces(lambda angle: rubbed(loaded, angle) - rubbed(at_rest, angle), corners, cycle)
    yield _Curve(still, True, np.ones(1), 0.0)
    yield _Curve(more, True, loaded.speed.value[:, 0, 0], 2.0)


def _at_rest(loaded: LoadedMachine) -> LoadedMachine:
    """A machine whose crank hardly moves."""
    return replace(loaded, speed=Speed(np.zeros_like(loaded.speed.value)))


def _with_friction_at_rest(loaded: LoadedMachine, events: ForceEvents, crank_angle: CrankAngle) -> ForceEvents:
    """Events of a machine, and where its friction has kinks while it hardly moves."""
    if not loaded.masses.has_friction:
        return events
    return with_kinks(events, friction_kinks(_at_rest(loaded), crank_angle))
