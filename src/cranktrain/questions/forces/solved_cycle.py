"""Forces of every mechanism on the grid of crank angles, and how joints, guides and their edges are taken of them."""

from collections.abc import Callable, Sequence
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.grouping import grouped
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.mechanisms import Batch
from cranktrain.linkage.forces import EdgeForces, edge_forces
from cranktrain.motion import Array
from cranktrain.numerics.gathering import in_even_steps
from cranktrain.questions.forces.loaded_machine import LoadedMachine, SolvedBatch
from cranktrain.questions.gas.pressures import GasPressures
from cranktrain.questions.motion.grid_motion import GridMotion
from cranktrain.record import record


@record
class SolvedCycle:
    """Forces of every mechanism of a machine on the grid of crank angles; nothing that people read as it is."""

    loaded: LoadedMachine
    batches: tuple[SolvedBatch, ...]

    @cached_property
    def driving_torque(self) -> Array:
        """Torque that must be applied at each mechanism's crank, shape (design, mechanism, n). [N·m]"""
        return driving_torques(self.loaded, self.batches)


def solved_cycle(
    loaded: LoadedMachine, crank_angle: CrankAngle, motion: GridMotion, gas: GasPressures | None
) -> SolvedCycle:
    """Solve the machine on its grid; docs/theory/forces, eqs. (13.1) to (13.3)."""
    gas_force = None if gas is None else gas.gas_force
    return SolvedCycle(loaded, loaded.solved(crank_angle.angle, gas_force=gas_force, motions=motion.batches))


def driving_torques(loaded: LoadedMachine, solved: Sequence[SolvedBatch]) -> Array:
    """Torque that must be applied at each mechanism's crank, by the reactions.

    Parameters
    ----------
    loaded : LoadedMachine
    solved : sequence of SolvedBatch
        What `LoadedMachine.solved` gave.

    Returns
    -------
    Array, shape (design, mechanism, n)
        A slave's comes through its master's crank pin: 0 for itself. [N·m]
    """
    shape = solved[0].forces.driving_torque.shape
    torque = np.zeros((shape[0], len(loaded.mechanisms.names), shape[-1]))
    for batch, one in zip(loaded.mechanisms.batches, solved, strict=True):
        is_own = loaded.carriers.master[batch.index] < 0
        torque[:, batch.index[is_own]] = one.forces.driving_torque[:, is_own]
    return torque


def force_size(x: Array, y: Array) -> Array:
    """Size of a force: it is far from the largest and smallest numbers, for which `np.hypot` takes its time."""
    return np.sqrt(x * x + y * y)


class Member(NamedTuple):
    """One joint or guide of one mechanism: its name; the mechanism; its batch, member and place in the kind."""

    name: str
    mechanism: int
    batch: int
    member: int
    place: int


def mechanisms_of(members: Sequence[Member]) -> NDArray[np.intp]:
    """Whose each is, shape (one,)."""
    return np.array([one.mechanism for one in members], dtype=np.intp)


def parts_of(
    members: Sequence[Member], solved: Sequence[SolvedBatch], values: Callable[[int, int], Sequence[Array]]
) -> Array:
    """Parts of what each bears, shape (part, design, one, n), from those that a batch has at a place of its kind."""
    n_designs, _n_members, n_angles = solved[0].forces.driving_torque.shape
    alike = grouped(((one.batch, one.place), place) for place, one in enumerate(members))
    parts = {where: values(*where) for where in alike}
    found = np.empty((len(next(iter(parts.values()))), n_designs, len(members), n_angles))
    for where, places in alike.items():
        own = in_even_steps([members[place].member for place in places])
        there = in_even_steps(places)
        shape = solved[where[0]].forces.driving_torque.shape
        for whole, part in zip(found, parts[where], strict=True):
            whole[:, there] = (part if np.shape(part) == shape else np.broadcast_to(part, shape))[:, own]
    return found


def edges_of(batch: Batch, one: SolvedBatch, place: int) -> EdgeForces:
    """What both edges press of the guides in which one part of a kind slides, broadcastable to (design, member, n)."""
    dynamics = batch.kind.dynamics
    links = dynamics.by_link(dynamics.links(one.motion, batch.members.geometry))
    contact = dynamics.contacts[place]
    link, wrench = links[dynamics.sliding[place]], dynamics.by_joint(one.forces.joints)[contact.joint]
    friction = one.conditions.friction[place]
    normal = contact.way * (link.cos * wrench.y - link.sin * wrench.x)
    return edge_forces(normal, wrench.moment, friction.per_length, friction.middle)
