"""What acts on every link of a mechanism but its joints: load, weight, inertia; and how the link moves.

All axes are the machine's, X right and Y up, seen from the free end.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np

from cranktrain.analysis import SpeedWanted, run, speed_over_cycle
from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.layout.frames import in_machine_axes
from cranktrain.layout.places import PlacedMechanism
from cranktrain.linkage.forces import NO_FRICTION, WEIGHTLESS, Body, Conditions, Drive, Gravity, Wrench
from cranktrain.machine import Machine
from cranktrain.mechanisms.dynamics import FRAME, AnyDynamics
from cranktrain.mechanisms.geometry import rows
from cranktrain.mechanisms.kind import AnyGeometry, AnyMotion
from cranktrain.motion import ZERO, Array
from cranktrain.plans.placement import frame
from cranktrain.questions.forces.loaded_machine import LoadedMachine

Cause = Literal["load", "weight", "inertia", "reaction"]

_STEP = 10.0
"""Of the grid on which a machine is made ready; the forces themselves are asked for at any angle. [deg]"""

NO_BODY = Body(ZERO, ZERO, ZERO, ZERO)
"""A link without mass."""

MASTER_ROD = "master_rod"
"""What a slave calls its master's rod."""


class Force(NamedTuple):
    """A force on a link: symbol such as `F_34` (of 3 on 4), cause, joint of a reaction, X and Y of shape (n,). [N]"""

    symbol: str
    cause: Cause
    joint: str
    value: Array


@dataclass(frozen=True)
class Member:
    """One mechanism of a loaded machine: its place, batch, member of it; motion of shape (1, n), size and masses."""

    loaded: LoadedMachine
    place: PlacedMechanism
    batch: int
    member: int
    angle: Array
    motion: AnyMotion
    size: AnyGeometry
    bodies: tuple[Body, ...]
    gravity: Gravity

    def own(self, values: Array) -> Array:
        """Give its own, shape (n,), of values of its batch's members, broadcastable to (1, member, n)."""
        members = self.loaded.mechanisms.batches[self.batch].index
        return np.broadcast_to(values, (1, members.size, self.angle.size))[0, self.member]

    @property
    def dynamics(self) -> AnyDynamics:
        """What forces its kind gives."""
        return self.place.kind.dynamics

    @property
    def drive(self) -> Drive:
        """How the crank turns there, arrays of shape (1, 1) or (1, n)."""
        return Drive(*(part[0] for part in self.loaded.speed.drive(self.angle)))


def made_ready(machine: Machine, speed: SpeedWanted) -> LoadedMachine:
    """Put masses and gas to a machine's mechanisms, at a speed as `run` takes it.

    Raises
    ------
    InputError
        If its file says of nothing that acts, or no speed.
    """
    refuse_idle(machine)
    curve = speed_over_cycle(machine, speed)  # not on the coarse grid
    return run(machine, speed=curve or "constant", step_degrees=_STEP, quantities=("driving_torque",))[LoadedMachine]


def refuse_idle(machine: Machine) -> None:
    """Refuse a machine on whose links nothing acts, or of which no speed is known."""
    problems: list[Problem] = []
    if machine.main_shaft.speed is None and machine.main_shaft.speed_curve is None:
        problems.append(Problem("shaft.main.speed", None, _("is missing: forces of inertia need it")))
    if machine.gas is None and not machine.masses and not machine.weighed.bodies:
        problems.append(Problem("masses", None, _("is missing, and [gas] too: nothing acts on the links")))
    if problems:
        raise InputError(problems)


def member_of(machine: Machine, loaded: LoadedMachine, place: PlacedMechanism, angle: Array) -> Member:
    """Find a mechanism in a loaded machine, at φ of shape (n,). [rad]"""
    index = loaded.mechanisms.names.index(place.name)
    at = next(i for i, batch in enumerate(loaded.mechanisms.batches) if index in batch.index)
    batch = loaded.mechanisms.batches[at]
    member = batch.index.tolist().index(index)
    own = np.array([member])
    size = rows(batch.members.geometry, own)
    made = rows(loaded.masses.batches[at], own)
    motion = batch.kind.motion(angle + rows((batch.members.phase,), own)[0], size)
    return Member(loaded, place, at, member, angle, motion, size, made.bodies, made.gravity)


def link_numbers(place: PlacedMechanism, after: int = 1) -> dict[str, int]:
    """Number bodies: 1 the frame; after a number crank, a slave's master rod, what else moves."""
    dynamics = place.kind.dynamics
    joined = [body for reaction in dynamics.reactions for body in (reaction.on, reaction.by)]
    first = (name for name in ("crank", MASTER_ROD) if name in joined)
    moving = [name for name in dict.fromkeys((*first, *dynamics.moving, *joined)) if name != FRAME]
    return {FRAME: 1} | {name: after + 1 + i for i, name in enumerate(moving)}


def pair_symbol(letter: str, by: int, on: int) -> str:
    """Symbol of a force of one body on another."""
    return f"{letter}_{by}{on}" if max(by, on) < 10 else f"{letter}_{by},{on}"


def turned_to_machine(machine: Machine, place: PlacedMechanism, x: Array, y: Array) -> Array:
    """Give a vector of a mechanism's axes in the machine's, shape (2, n)."""
    return np.stack(in_machine_axes(x, y, frame(machine, place)))


def known_forces(machine: Machine, one: Member, i: int, number: int) -> Iterator[Force]:
    """Load, weight and inertia of one link."""
    load = loads_of(one)[i]
    mass = np.ravel(one.bodies[i].mass)
    still = np.zeros(len(one.angle))
    weights = (mass * np.ravel(part) + still for part in one.gravity)
    yield Force(f"P_{number}", "load", "", turned_to_machine(machine, one.place, load.x[0] + still, load.y[0] + still))
    yield Force(f"G_{number}", "weight", "", turned_to_machine(machine, one.place, *weights))
    yield Force(f"Φ_{number}", "inertia", "", turned_to_machine(machine, one.place, *_inertia(one, i)))


def loads_of(one: Member) -> Sequence[Wrench]:
    """Loads of all links, shape (1, n)."""
    value = np.zeros((1, len(one.angle)))
    gas, piston = one.loaded.gas, one.loaded.carriers.piston[one.loaded.mechanisms.names.index(one.place.name)]
    if gas is not None and piston >= 0:
        value = -gas.force(gas.pressure(one.angle, gas.volume(one.angle)))[:, piston]
    loads = one.dynamics.load(one.motion, one.size, value)
    return [Wrench(*(np.broadcast_to(part, value.shape) for part in load)) for load in loads]


def unloaded(one: Member) -> tuple[Wrench, ...]:
    """Loads of nothing on all links."""
    return one.dynamics.load(one.motion, one.size, np.zeros((1, 1)))


def body_alone(one: Member, i: int, body: Body) -> tuple[Body, ...]:
    """Bodies of all links, of which only one has mass."""
    return tuple(body if j == i else NO_BODY for j in range(len(one.bodies)))


def _inertia(one: Member, i: int) -> tuple[Array, Array]:
    """Inertia force of one link, in the mechanism's axes: what the frame bears where nothing else has mass. [N]"""
    bodies = body_alone(one, i, one.bodies[i])
    conditions = Conditions(one.drive, WEIGHTLESS, tuple(NO_FRICTION for _slider in one.dynamics.sliding))
    joints = one.dynamics.forces(one.motion, one.size, bodies, unloaded(one), conditions).joints
    on_frame = [w for reaction, w in zip(one.dynamics.reactions, joints, strict=True) if reaction.by == FRAME]
    x, y = (
        -np.sum([np.broadcast_to(part, (1, len(one.angle)))[0] for part in parts], axis=0)
        for parts in ([w.x for w in on_frame], [w.y for w in on_frame])
    )
    return x, y
