"""Steady running on pieces that end where anything jumps or has a corner, found from the running itself."""

from collections.abc import Hashable, Iterator, Sequence
from operator import itemgetter

import numpy as np
from numpy.typing import NDArray

from cranktrain.grouping import grouped
from cranktrain.motion import Array
from cranktrain.questions.drive.balanced_speed import balances
from cranktrain.questions.drive.cycle_equation import speed_over_turn, speeds_over_turn
from cranktrain.questions.drive.steady_cycle import SpeedOverTurn, cycles_together, passings
from cranktrain.questions.drive.steady_turn import DriveInTurn, together
from cranktrain.questions.reduction.at_angles import reduced_of_each, structure_of
from cranktrain.questions.reduction.cycle_pieces import (
    NODES,
    CyclePieces,
    mesh_of,
    pieces_together,
    to_integrals,
    to_places,
)
from cranktrain.questions.reduction.machines import ReducedMachines
from cranktrain.transient.gearing import overall_ratio, turning_inertia

_MOST_MESHES = 24
_MOST_FOR_KINKS = 3
_SAME = 1e-9
"""Places where the motor's law has a corner, which moved by less, stand where they are. [rad]"""
_SAME_KINK = 1e-6
"""The same of kinks of the losses, of which the square counts. [rad]"""
_CLOSE = 1e-10
"""In parts of the largest torque: pieces on which more is left over between the nodes are cut."""
_BETWEEN = 0.5 * (NODES[[0, 3, 7, 10]] + NODES[[1, 4, 8, 11]])
"""Places in a piece, away from its nodes, at which the equation of motion is asked."""
_TO_BETWEEN, _SLOPE_BETWEEN = to_integrals(_BETWEEN), to_places(_BETWEEN)
_PARTS = 4
"""Into which a piece is cut on which too much is left over."""
_MOST_PIECES = 600
_HEAVIER = (30.0, 10.0, 4.0, 1.5, 0.6, 0.3, 0.1, 0.03, 0.0)
"""How many times its own inertia a machine has more, on the way to a cycle that is not found at once."""
_ASIDE = 1e-9
"""In parts of a speed: how far aside a law that jumps there is asked."""
_JUMP = 1e-6
"""Of the torque: less across a corner is no jump."""
_NOWHERE = np.empty(0)
_AT_ONCE = 64
"""Designs that are computed together: the curves of more are too long to be kept near."""
_STEPS_TOGETHER = 8
"""Of Newton's method: what takes more of them is sought alone."""


def settled(
    turning: DriveInTurn, machines: ReducedMachines, held: float | None = None
) -> tuple[DriveInTurn, SpeedOverTurn | None]:
    """Steady cycle of one design: as `all_settled`."""
    (found,) = all_settled([turning], machines, [held])
    return found


def all_settled(
    each: Sequence[DriveInTurn], machines: ReducedMachines, held: Sequence[float | None]
) -> list[tuple[DriveInTurn, SpeedOverTurn | None]]:
    """Steady cycles on pieces that end at all corners: of loads, of losses, of the motor's law; with the drives there.

    Parameters
    ----------
    each : sequence of DriveInTurn
        Designs with motors of one law.
    machines : ReducedMachines
    held : sequence of float or None
        Speeds of the crank that servo motors hold. [rad/s]

    Returns
    -------
    list of (DriveInTurn, SpeedOverTurn or None)
        Of each design, to the last bit as alone.

    Notes
    -----
    docs/theory/reduced-machine, eqs. (31.6) to (31.8). Losses and the motor have their corners where the running has
    certain torques and speeds: found from it, and it anew with them, until they stand. Pieces on which the equation
    of motion is missed between the nodes are cut.
    """
    ways = list(_ways(each, machines))
    for way, speed in zip(ways, held, strict=True):
        if way.turning.is_held:
            way.turning = way.turning.at(way.mesh.nodes)
            way.found = None if speed is None else _constant(way.mesh, speed)
    going = [way for way in ways if not way.turning.is_held]
    for alike in _alike(going):
        _begin(alike, machines)
    for _again in range(_MOST_MESHES):
        going = [way for way in going if way.found is not None]
        going = [way for alike in _alike(going) for way in _with_other_meshes(alike, machines)]
        for alike in _alike(going):
            _turn(alike)
            first = [way.found.at(way.mesh.nodes) for way in alike if way.found is not None]
            _find(alike, first)
    return [(way.turning, way.found) for way in ways]


class _Way:
    """A design on the way to its steady cycle: its motor's corners [rad/s]; those of its running, and cuts. [rad]"""

    def __init__(self, turning: DriveInTurn, mesh: CyclePieces, structure: Hashable, corner_speeds: Array) -> None:
        self.turning, self.mesh, self.structure = turning, mesh, structure
        self.found: SpeedOverTurn | None = None
        self.corner_speeds = corner_speeds
        self.kinks, self.passed, self.cuts = _NOWHERE, _NOWHERE, _NOWHERE
        self.n_with_kinks = 0


def _ways(each: Sequence[DriveInTurn], machines: ReducedMachines) -> Iterator[_Way]:
    """Designs on meshes that end at the corners of loads; what many have in common is found once."""
    meshes, structures, corners = dict[bytes, CyclePieces](), dict[int, Hashable](), dict[int, Array]()
    for one in each:
        of_loads = machines.corners[one.design]
        key, machine, motor = of_loads.tobytes(), id(one.machine), id(one.motor)
        if key not in meshes:
            meshes[key] = mesh_of(machines.cycle, of_loads)
        if machine not in structures:
            structures[machine] = structure_of(one.machine)
        if motor not in corners:
            corners[motor] = one.motor.corner_speeds(0)
        at_motor = corners[motor]
        at_crank = at_motor[at_motor > 0] / overall_ratio(one.gearing)
        yield _Way(one, meshes[key], (structures[machine], *one.structure), at_crank)


def _alike(ways: Sequence[_Way]) -> Iterator[list[_Way]]:
    """Designs that can stand together, on as many pieces each: some at a time, as many as a processor holds near."""
    for own in grouped(((way.mesh.start.size, way.structure), way) for way in ways).values():
        yield from (own[first : first + _AT_ONCE] for first in range(0, len(own), _AT_ONCE))


def _turn(alike: Sequence[_Way]) -> None:
    """Put machines to the nodes of their meshes."""
    angle = np.stack([way.mesh.nodes for way in alike])
    here = reduced_of_each([way.turning.machine for way in alike], angle)
    for design, way in enumerate(alike):
        way.turning = way.turning._replace(here=here.changed(itemgetter(design)))


def _begin(alike: Sequence[_Way], machines: ReducedMachines) -> None:
    """Find cycles on the meshes of the loads alone, from constant speeds on."""
    _turn(alike)
    speeds = [one.speed for one in balances([way.turning for way in alike], machines.cycle)]
    begun = [(way, speed) for way, speed in zip(alike, speeds, strict=True) if speed is not None]
    if begun:
        ways = [way for way, _speed in begun]
        _find(ways, [np.full(way.mesh.nodes.shape, speed) for way, speed in begun])
    for way, speed in begun:
        way.found = way.found or _from_heavier(way.turning, way.mesh, speed)


def _find(alike: Sequence[_Way], first: Sequence[Array]) -> None:
    """Find cycles near given speeds at the nodes; those that take many steps by themselves."""
    turning, mesh = together([way.turning for way in alike]), pieces_together([way.mesh for way in alike])
    most_steps = {} if len(alike) == 1 else {"most_steps": _STEPS_TOGETHER}
    sought = speeds_over_turn(lambda speed: turning.passed(speed).acceleration, mesh, np.stack(first), **most_steps)
    for way, own, speed in zip(alike, sought, first, strict=True):
        way.found = own.cycle if own.is_over else _cycle(way.turning, way.mesh, speed)


def _with_other_meshes(alike: Sequence[_Way], machines: ReducedMachines) -> list[_Way]:
    """Those whose corners do not stand yet, or whose pieces are cut, each on its next mesh."""
    found = [way.found for way in alike if way.found is not None]
    turning = together([way.turning for way in alike])
    outputs = turning.passed(cycles_together(found).speed).outputs
    unsettled, standing = list[_Way](), list[_Way]()
    passed = passings(found, [0.5 * way.corner_speeds**2 for way in alike])
    for way, kinks, own in zip(alike, _kinks(np.moveaxis(outputs, 1, 0), found), passed, strict=True):
        before = way.kinks, way.passed
        way.kinks, way.passed = kinks, own
        are_kinks_known = way.n_with_kinks >= _MOST_FOR_KINKS or _stand(
            before[0], way.kinks, machines.cycle, _SAME_KINK
        )
        stands = are_kinks_known and _stand(before[1], way.passed, machines.cycle, _SAME)
        (standing if stands else unsettled).append(way)
    unsettled += _cut(standing)
    for way in unsettled:
        if way.found is None:
            continue
        corners = machines.corners[way.turning.design]
        way.mesh = mesh_of(machines.cycle, np.concatenate([corners, way.kinks, way.passed, way.cuts]))
        way.n_with_kinks += 1
        middle = way.found.at(way.mesh.at(np.array([0.5])))
        way.mesh = way.mesh.between(0.5 * _jumps(way.turning, way.corner_speeds) ** 2, 0.5 * middle**2)
    return unsettled


def _cut(standing: Sequence[_Way]) -> list[_Way]:
    """Those of which pieces are cut, as the equation of motion is missed there."""
    if not standing:
        return []
    found = [way.found for way in standing if way.found is not None]
    missed = missed_motion([way.turning for way in standing], found)
    more = [_cuts(own, is_missed) for own, is_missed in zip(found, missed > _CLOSE, strict=True)]
    cut = [
        (way, own)
        for way, own in zip(standing, more, strict=True)
        if 0 < own.size <= _MOST_PIECES - way.mesh.start.size
    ]
    for way, own in cut:
        way.cuts, way.n_with_kinks = np.concatenate([way.cuts, own]), 0
    return [way for way, _own in cut]


def missed_motion(turning: Sequence[DriveInTurn], found: Sequence[SpeedOverTurn]) -> Array:
    """What is left over of the equation of motion between the nodes of each piece, of the largest torque. [1]

    Of designs of one structure with as many pieces each, shape (design, piece).
    docs/theory/reduced-machine, eq. (31.6).
    """
    at_nodes, cycles = together(turning), cycles_together(found)
    there = together(turning, cycles.mesh.at(_BETWEEN))
    speed = np.sqrt(2 * (cycles.base + cycles.grown(_TO_BETWEEN).reshape(len(found), -1)))
    slopes = (cycles.acceleration.reshape(len(found), -1, NODES.size) @ _SLOPE_BETWEEN.T).reshape(speed.shape)
    left = np.abs(there.left_over(speed, slopes)).reshape(len(found), -1, _BETWEEN.size)
    largest = at_nodes.torque_size(cycles.speed)
    return np.max(left, axis=-1) / largest[:, np.newaxis]


def _jumps(turning: DriveInTurn, speeds: Array) -> Array:
    """Those of the speeds of corners at which the motor's law jumps. [rad/s]"""
    below, above = (turning.motor_torque(speeds * (1 + side)) for side in (-_ASIDE, _ASIDE))
    return speeds[np.abs(above - below) > _JUMP * np.maximum(np.abs(below), np.abs(above))]


def _stand(before: Array, now: Array, cycle: float, same: float) -> bool:
    """Whether corners stand where they stood."""
    if before.size != now.size:
        return False
    if now.size == 0:
        return True
    apart = np.abs(np.sort(np.mod(before, cycle)) - np.sort(np.mod(now, cycle)))
    return bool(np.all(np.minimum(apart, cycle - apart) < same))


def _cuts(found: SpeedOverTurn, is_missed: NDArray[np.bool_]) -> Array:
    """Crank angles at which pieces are cut on which too much is left over. [rad]"""
    start, width = found.mesh.start[is_missed], found.mesh.width[is_missed]
    return np.ravel(start[:, np.newaxis] + width[:, np.newaxis] * np.arange(1, _PARTS) / _PARTS)


def _constant(mesh: CyclePieces, speed: float) -> SpeedOverTurn:
    """A cycle at one speed."""
    nothing = np.zeros(mesh.nodes.shape)
    return SpeedOverTurn(mesh, 0.5 * speed * speed, nothing, np.zeros(mesh.start.shape), nothing, 0.0)


def _cycle(turning: DriveInTurn, mesh: CyclePieces, first: float | Array) -> SpeedOverTurn | None:
    """Steady cycle near a constant speed, or speeds at the nodes."""
    return speed_over_turn(lambda speed: turning.passed(speed).acceleration, mesh, first)


def _from_heavier(turning: DriveInTurn, mesh: CyclePieces, first: float) -> SpeedOverTurn | None:
    """Steady cycle by way of those with more inertia, which run more evenly, each near the one before."""
    there = turning.here
    whole, guess = np.mean(there.inertia) + turning_inertia(turning.gearing), first
    found: SpeedOverTurn | None = None
    for more in _HEAVIER:
        heavier = turning._replace(here=there._replace(inertia=there.inertia + more * whole))
        found = _cycle(heavier, mesh, guess)
        if found is None:
            return None
        guess = found.speed
    return found


def _kinks(outputs: Array, found: Sequence[SpeedOverTurn]) -> Iterator[Array]:
    """Crank angles at which a stage's torque changes its sign, (design, stage, n): there the losses have a kink. [rad]

    Of each design.
    """
    changes = np.sign(outputs[..., :-1]) * np.sign(outputs[..., 1:]) < 0
    has_some = np.any(changes, axis=(1, 2)).tolist()
    for of_stages, own, has_kinks, one in zip(outputs, changes, has_some, found, strict=True):
        if not has_kinks:
            yield _NOWHERE
            continue
        nodes, (row, place) = one.mesh.nodes, np.nonzero(own)
        low, high = of_stages[row, place], of_stages[row, place + 1]
        yield nodes[place] + (nodes[place + 1] - nodes[place]) * low / (low - high)
