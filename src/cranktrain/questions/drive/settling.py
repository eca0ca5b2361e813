"""Steady running on pieces that end where anything jumps or has a corner, found from the running itself."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.questions.drive.balanced_speed import balance
from cranktrain.questions.drive.cycle_equation import speed_over_turn
from cranktrain.questions.drive.steady_cycle import SpeedOverTurn, passings
from cranktrain.questions.drive.steady_turn import DriveInTurn
from cranktrain.questions.reduction.cycle_pieces import NODES, CyclePieces, mesh_of, to_integrals, to_places
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


class _Levels(NamedTuple):
    """Values of ω²/2 of the crank at which the motor's law has a corner, and those of them at which it jumps."""

    corners: Array
    jumps: Array


def settled(
    turning: DriveInTurn, machines: ReducedMachines, held: float | None = None
) -> tuple[DriveInTurn, SpeedOverTurn | None]:
    """Steady cycle on pieces that end at all corners: of loads, of losses, of the motor's law; with the drive there.

    Parameters
    ----------
    turning : DriveInTurn
    machines : ReducedMachines
    held : float, optional
        Speed of the crank that a servo motor holds. [rad/s]

    Notes
    -----
    docs/theory/reduced-machine, eqs. (31.6) to (31.8). Losses and the motor have their corners where the running has
    certain torques and speeds: found from it, and it anew with them, until they stand. Pieces on which the equation
    of motion is missed between the nodes are cut.
    """
    corners = machines.corners[turning.design]
    mesh = mesh_of(machines.cycle, corners)
    turning = turning.at(mesh.nodes)
    if turning.is_held:
        return turning, None if held is None else _constant(mesh, held)
    first, levels = balance(turning, machines.cycle).speed, _levels(turning)
    found = None if first is None else _cycle(turning, mesh, first) or _from_heavier(turning, mesh, first)
    kinks, passed, cuts, n_with_kinks = np.empty(0), np.empty(0), np.empty(0), 0
    for _again in range(_MOST_MESHES):
        if found is None:
            break
        before, kinks, passed = (kinks, passed), _kinks(turning, found), passings(found, levels.corners)
        are_kinks_known = n_with_kinks >= _MOST_FOR_KINKS or _stand(before[0], kinks, machines.cycle, _SAME_KINK)
        if are_kinks_known and _stand(before[1], passed, machines.cycle, _SAME):
            more = _cuts(turning, found)
            if more.size == 0 or mesh.start.size + more.size > _MOST_PIECES:
                break
            cuts, n_with_kinks = np.concatenate([cuts, more]), 0
        mesh, n_with_kinks = mesh_of(machines.cycle, np.concatenate([corners, kinks, passed, cuts])), n_with_kinks + 1
        mesh = mesh.between(levels.jumps, 0.5 * found.at(mesh.at(np.array([0.5]))) ** 2)
        turning = turning.at(mesh.nodes)
        found = _cycle(turning, mesh, found.at(mesh.nodes))
    return turning, found


def missed_motion(turning: DriveInTurn, found: SpeedOverTurn) -> Array:
    """What is left over of the equation of motion between the nodes of each piece, of the largest torque. [1]

    docs/theory/reduced-machine, eq. (31.6).
    """
    there = turning.at(found.mesh.at(_BETWEEN))
    speed = np.sqrt(2 * (found.base + np.ravel(found.grown(_TO_BETWEEN))))
    acceleration = np.ravel(found.acceleration.reshape(-1, NODES.size) @ _SLOPE_BETWEEN.T)
    left = np.abs(there.left_over(speed, acceleration)).reshape(-1, _BETWEEN.size)
    return np.max(left, axis=1) / turning.torque_size(found.speed)


def _levels(turning: DriveInTurn) -> _Levels:
    """Corners of the motor's law, at the crank."""
    speeds = turning.motor.corner_speeds(0)
    speeds = speeds[speeds > 0]
    at_crank = speeds / overall_ratio(turning.gearing)
    below, above = (turning.motor_torque(at_crank * (1 + side)) for side in (-_ASIDE, _ASIDE))
    is_jump = np.abs(above - below) > _JUMP * np.maximum(np.abs(below), np.abs(above))
    return _Levels(0.5 * at_crank**2, 0.5 * at_crank[is_jump] ** 2)


def _stand(before: Array, now: Array, cycle: float, same: float) -> bool:
    """Whether corners stand where they stood."""
    if before.size != now.size:
        return False
    apart = np.abs(np.sort(np.mod(before, cycle)) - np.sort(np.mod(now, cycle)))
    return bool(np.all(np.minimum(apart, cycle - apart) < same))


def _cuts(turning: DriveInTurn, found: SpeedOverTurn) -> Array:
    """Crank angles at which pieces are cut on which too much is left over. [rad]"""
    is_missed = missed_motion(turning, found) > _CLOSE
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


def _kinks(turning: DriveInTurn, found: SpeedOverTurn) -> Array:
    """Crank angles at which a stage's torque changes its sign: there the losses have a kink. [rad]"""
    outputs, nodes = turning.passed(found.speed).outputs, found.mesh.nodes
    row, place = np.nonzero(np.sign(outputs[:, :-1]) * np.sign(outputs[:, 1:]) < 0)
    low, high = outputs[row, place], outputs[row, place + 1]
    return nodes[place] + (nodes[place + 1] - nodes[place]) * low / (low - high)
