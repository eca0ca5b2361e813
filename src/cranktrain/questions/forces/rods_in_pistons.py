"""Rods that end in pistons, solved: their pins, what acts on them, and P, N and S by the reactions."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.layout.mechanisms import Batch
from cranktrain.linkage.forces import Body, Drive, Gravity, Wrench, turned_wrench
from cranktrain.mechanisms.dynamics import Role
from cranktrain.mechanisms.kind import AnyMotion
from cranktrain.motion import Array
from cranktrain.questions.forces.loaded_machine import LoadedMachine, SolvedBatch
from cranktrain.questions.forces.piston_formulas import inertia_force, rod_forces
from cranktrain.questions.forces.rod_masses import TwoMasses, weighed_ends
from cranktrain.questions.forces.solved_cycle import SolvedCycle, force_size
from cranktrain.record import record


class ForcesOfRods(NamedTuple):
    """Of pistons and rods of one kind, shape (design, member, n). [N]

    inertia: P_j, of the piston with the rod's reciprocating share; piston: P; side: N; at_piston, at_crank: along the
    rod at its piston pin and at its other pin.
    """

    inertia: Array
    piston: Array
    side: Array
    at_piston: Array
    at_crank: Array


class RodsInPistons(NamedTuple):
    """Rods of one kind of mechanism: their batch, which pistons they drive; motion and joints; bodies and conditions.

    on_piston: gas and loads on the piston, of_gas: the gas alone; borne: what loads do to the rod; piston_mass, and
    shares: the rod's at its ends [kg].
    """

    batch: Batch
    piston: NDArray[np.intp]
    motion: AnyMotion
    joints: Sequence[Wrench]
    rod: Body
    shares: TwoMasses
    piston_mass: Array
    on_piston: Wrench
    of_gas: Wrench
    borne: Wrench
    drive: Drive
    gravity: Gravity

    @property
    def reciprocating(self) -> Array:
        """Mass that goes to and fro: the piston's, and the rod's share. [kg]"""
        return self.piston_mass + self.shares.second

    @property
    def pressed(self) -> Array:
        """Force of gas, loads and the weight of what goes to and fro, toward the shaft. [N]"""
        return -self.on_piston.x - self.reciprocating * self.gravity.x

    @property
    def pins(self) -> tuple[Wrench, Wrench]:
        """Reactions in the rod's pins: on it at the crank or a master's rod, by it on the piston."""
        return self._joint("crank_pin", "knuckle_pin"), self._joint("piston_pin")

    @property
    def forces(self) -> ForcesOfRods:
        """Forces by the reactions; docs/theory/forces, eqs. (13.30) and (13.50)."""
        inertia = inertia_force(self.motion.slider, self.reciprocating, self.drive)
        along = rod_forces(self.motion.rod, self.motion.slider, self.pins, self.shares, self.drive, self.gravity)
        return ForcesOfRods(inertia, self.pressed + inertia, self.guide.y, *along)

    @property
    def guide(self) -> Wrench:
        """Of the guide on the piston: friction along it, and N."""
        return self._joint("guide")

    @property
    def is_on_pin(self) -> bool:
        """Whether they sit on a crank pin, which those of slaves do not."""
        place = self.batch.kind.dynamics.joint("crank_pin")
        return place is not None and self.batch.kind.dynamics.reactions[place].on == "rod"

    def _joint(self, *roles: Role) -> Wrench:
        """Reaction in the mechanism's own joint with the first of some roles that any has."""
        places = (self.batch.kind.dynamics.joint(role) for role in roles)
        return self.joints[next(place for place in places if place is not None)]


def rods_in_pistons(loaded: LoadedMachine, solved: Sequence[SolvedBatch]) -> Iterator[RodsInPistons]:
    """Find the rods of pistons in what `LoadedMachine.solved` gave."""
    for batch, one, made in zip(loaded.mechanisms.batches, solved, loaded.masses.batches, strict=True):
        if batch.kind.has_rod and batch.kind.output.is_slider:
            bodies = batch.kind.dynamics.by_link(made.bodies)
            shares = weighed_ends(bodies["rod"], batch.members.geometry.rod_length)
            loads = batch.kind.dynamics.by_link(one.loads)
            yield RodsInPistons(
                batch,
                loaded.carriers.piston[batch.index],
                one.motion,
                one.forces.joints,
                bodies["rod"],
                shares,
                bodies["slider"].mass,
                loads["slider"],
                batch.kind.dynamics.by_link(one.pressed)["slider"],
                loads["rod"],
                one.conditions.drive,
                made.gravity,
            )


@record
class RodsOnGrid:
    """Rods of pistons on the grid of crank angles, kind by kind, and their forces by the reactions."""

    each: tuple[tuple[RodsInPistons, ForcesOfRods], ...]


def rods_on_grid(loaded: LoadedMachine, solved: SolvedCycle) -> RodsOnGrid:
    """Find the rods of pistons in the cycle, and their forces."""
    return RodsOnGrid(tuple((one, one.forces) for one in rods_in_pistons(loaded, solved.batches)))


def end_residual(loaded: LoadedMachine, rods: Sequence[tuple[RodsInPistons, ForcesOfRods]]) -> Array:
    """Largest difference of the forces along a rod at its ends, but for what acts between, over what its pins bear.

    Between act loads, what of its inertia no masses at its ends have, and its slaves: of these by their own knuckle
    pins. Shape (design,); docs/theory/forces, eq. (13.51).
    """
    handed = _handed_over(loaded, [one for one, _forces in rods])
    worst = [np.zeros(len(loaded.speed.value))]
    for one, forces in rods:
        link, body, index = one.motion.rod, one.rod, one.batch.index
        turning = link.angle.second * (one.drive.speed * one.drive.speed) + link.angle.first * one.drive.acceleration
        between = (one.borne.x + handed.x[:, index]) * link.cos + (one.borne.y + handed.y[:, index]) * link.sin
        off = forces.at_crank - forces.at_piston + between + body.mass * body.across * turning
        worst.append(_share(off, np.maximum(*(force_size(pin.x, pin.y) for pin in one.pins))))
    return np.max(worst, axis=0)


def pin_residual(loaded: LoadedMachine, rods: Sequence[tuple[RodsInPistons, ForcesOfRods]]) -> Array:
    """Largest difference of the force in a piston pin from P and N, over what acts on the piston.

    Of P what the rod's share has in it is left out, and friction is in; with N is what else acts across the cylinder.
    Shape (design,); docs/theory/forces, eq. (13.53).
    """
    worst = [np.zeros(len(loaded.speed.value))]
    for one, forces in rods:
        share, gravity, pin = one.shares.second, one.gravity, one.pins[1]
        along = forces.piston - inertia_force(one.motion.slider, share, one.drive) + share * gravity.x - one.guide.x
        across = forces.side + one.on_piston.y + one.piston_mass * gravity.y
        off = force_size(pin.x - along, pin.y + across)
        acting = force_size(one.on_piston.x, one.on_piston.y) + np.abs(forces.inertia) + force_size(*one.guide[:2])
        worst.append(_share(off, acting + one.reciprocating * force_size(gravity.x, gravity.y)))
    return np.max(worst, axis=0)


def _share(off: Array, acting: Array) -> Array:
    """Largest difference over the largest of what acts there, of pistons of shape (design, member, n); by design."""
    peak = acting.max(axis=-1)
    share = np.abs(off).max(axis=-1) / np.where(peak > 0, peak, 1.0)
    return np.where(np.isnan(share), 0.0, share).max(axis=-1)


def _handed_over(loaded: LoadedMachine, rods: Sequence[RodsInPistons]) -> Wrench:
    """What slaves together do to their masters' rods, in the masters' axes, shape (design, mechanism, n)."""
    top, master = loaded.mechanisms.nominal_top, loaded.carriers.master
    x, y = np.zeros((2, len(top), len(master), rods[0].motion.slider.value.shape[-1]))
    for one in rods:
        place = one.batch.kind.dynamics.joint("knuckle_pin")
        if place is not None:
            on = master[one.batch.index]
            turned = turned_wrench(one.joints[place], top[:, on] - top[:, one.batch.index])
            for member, mechanism in enumerate(on.tolist()):
                x[:, mechanism] -= turned.x[:, member]
                y[:, mechanism] -= turned.y[:, member]
    return Wrench(x, y, np.zeros_like(x))
