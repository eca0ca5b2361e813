"""Bounds of what stands in the joints of each mechanism: largest force, and the largest torque of it."""

from collections.abc import Iterable, Sequence
from functools import reduce

import numpy as np

from cranktrain.motion import Array
from cranktrain.questions.forces.loaded_machine import LoadedMachine, SolvedBatch
from cranktrain.questions.forces.solved_cycle import SolvedCycle
from cranktrain.record import record


def largest_in_joints(loaded: LoadedMachine, solved: Sequence[SolvedBatch]) -> Array:
    """Largest force in any joint of each mechanism, shape (design, mechanism). [N]"""
    return loaded.in_order(_largest_force(one) for one in solved)


@record
class ForcesTimesArms:
    """What the joints of each mechanism could do to the shaft at most, shape (design, mechanism).

    value: [N·m]; force: largest in any of them [N]; reach: how far its links' farthest pin is from the origin [m].
    """

    value: Array
    force: Array
    reach: Array


def forces_times_arms(loaded: LoadedMachine, solved: SolvedCycle) -> ForcesTimesArms:
    """The largest force by the longest way of pins for a turn of 1 rad, and the largest moment by the fastest turn."""
    found: list[Array] = []
    reaches: list[Array] = []
    forces = [_largest_force(one) for one in solved.batches]
    for batch, one, force in zip(loaded.mechanisms.batches, solved.batches, forces, strict=True):
        links = batch.kind.dynamics.links(one.motion, batch.members.geometry)
        way = np.sqrt(_largest(link.origin.x.first**2 + link.origin.y.first**2 for link in links))
        turn = _largest(np.abs(link.angle.first) for link in links)
        moment = _largest(np.abs(joint.moment) for joint in one.forces.joints)
        found.append(force * way + moment * turn)
        reaches.append(np.sqrt(_largest(link.origin.x.value**2 + link.origin.y.value**2 for link in links)))
    return ForcesTimesArms(*map(loaded.in_order, (found, forces, reaches)))


def _largest_force(one: SolvedBatch) -> Array:
    """Largest force in any joint of each mechanism of one kind, shape (design, member)."""
    return np.sqrt(_largest(joint.x * joint.x + joint.y * joint.y for joint in one.forces.joints))


def _largest(curves: Iterable[Array]) -> Array:
    """Largest value of several curves of shape (..., n), each of which may stand for all."""
    return np.atleast_1d(reduce(np.maximum, curves)).max(axis=-1)
