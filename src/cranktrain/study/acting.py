"""What acts on every link of a mechanism: load, weight, inertia and the joints' reactions, and how the link moves.

All axes are the machine's, X right and Y up, seen from the free end.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, Literal, NamedTuple

import numpy as np

from cranktrain.analysis import SpeedWanted, run, speed_over_cycle
from cranktrain.engine.forces import LoadedMachine
from cranktrain.engine.frames import in_machine_axes
from cranktrain.engine.places import Place
from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.linkage.forces import NO_FRICTION, Body, Conditions, Drive, Gravity, Wrench
from cranktrain.machine import Machine
from cranktrain.mechanisms.kind import FRAME, Dynamics, Reaction, rows
from cranktrain.motion import Array
from cranktrain.study.placement import frame

Cause = Literal["load", "weight", "inertia", "reaction"]

_STEP = 10.0
"""Of the grid on which a machine is made ready; the forces themselves are asked for at any angle. [deg]"""

_ROD, _MASTER_ROD = "rod", "master_rod"
"""What a master calls its own rod, and its slaves call it."""


class Force(NamedTuple):
    """A force on a link: symbol such as `F_34` (of 3 on 4), cause, joint of a reaction, X and Y of shape (n,). [N]"""

    symbol: str
    cause: Cause
    joint: str
    value: Array


@dataclass(frozen=True)
class ActedLink:
    """A link with all that acts on it, at n crank angles.

    Attributes
    ----------
    name : str
    number : int
        1 is the frame, 2 the crank.
    forces : tuple of Force
        Those that are known first, then reactions; each of shape (2, n).
    """

    name: str
    number: int
    forces: tuple[Force, ...]


@dataclass(frozen=True)
class Member:
    """One mechanism of a loaded machine: its place, group, member of it; motion of shape (1, n), size and masses."""

    loaded: LoadedMachine
    place: Place
    group: int
    member: int
    angle: Array
    motion: Any
    size: Any
    bodies: tuple[Body, ...]
    gravity: Gravity

    @property
    def dynamics(self) -> Dynamics:
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
    result = run(machine, speed=curve or "constant", step_degrees=_STEP, quantities=("driving_torque",))
    return next(gift for gift in result.gifts if isinstance(gift, LoadedMachine))


def refuse_idle(machine: Machine) -> None:
    """Refuse a machine on whose links nothing acts, or of which no speed is known."""
    problems: list[Problem] = []
    if machine.main_shaft.speed is None:
        problems.append(Problem("shaft.main.speed", None, _("is missing: forces of inertia need it")))
    if machine.gas is None and not machine.masses and not machine.weighed.bodies:
        problems.append(Problem("masses", None, _("is missing, and [gas] too: nothing acts on the links")))
    if problems:
        raise InputError(problems)


def member_of(machine: Machine, loaded: LoadedMachine, place: Place, angle: Array) -> Member:
    """Find a mechanism in a loaded machine, at φ of shape (n,). [rad]"""
    index = loaded.mechanisms.names.index(place.name)
    at = next(i for i, group in enumerate(loaded.mechanisms.groups) if index in group.index)
    group = loaded.mechanisms.groups[at]
    member = group.index.tolist().index(index)
    own = np.array([member])
    size = rows(group.members.geometry, own)
    made = rows(loaded.masses.groups[at], own)
    motion = group.kind.motion(angle + rows((group.members.phase,), own)[0], size)
    return Member(loaded, place, at, member, angle, motion, size, tuple(made.bodies), made.gravity)


def acted_links(machine: Machine, loaded: LoadedMachine, place: Place, angle: Array) -> tuple[ActedLink, ...]:
    """Give the links of a mechanism with all that acts on them.

    Parameters
    ----------
    machine : Machine
    loaded : LoadedMachine
        What `made_ready` gave.
    place : Place
        Which mechanism.
    angle : Array, shape (n,)
        φ. [rad]

    Returns
    -------
    tuple of ActedLink
        Reactions are the exact ones of the whole machine: a master's hold what its slaves do to it, the forces of
        whose rods on the master's are named for them, `F_1R`.
    """
    one = member_of(machine, loaded, place, angle)
    numbers = link_numbers(place)
    solved = loaded.solved(angle)
    reactions = list(_reactions(machine, one, solved[one.group].forces.joints))
    hanging = list(_hanging(machine, one, solved))
    bodies = _on_shaft(one.dynamics)
    found: dict[str, list[Force]] = {body: [] for body in bodies.values()}
    for i, (name, body) in enumerate(bodies.items()):
        found[body] += known_forces(machine, one, i, numbers[name])
        if name == _ROD:
            found[body] += (Force(f"F_{whose}", "reaction", joint, -value) for whose, joint, value in hanging)
    for name, body in bodies.items():
        found[body] += _reactions_on(name, reactions, numbers)
    return tuple(ActedLink(body, numbers[body], tuple(forces)) for body, forces in found.items())


def link_numbers(place: Place) -> dict[str, int]:
    """Number the bodies of a mechanism: 1 the frame, 2 the crank, then a slave's master rod, and what else moves."""
    dynamics = place.kind.dynamics
    joined = [body for reaction in dynamics.reactions for body in (reaction.on, reaction.by)]
    first = (name for name in ("crank", _MASTER_ROD) if name in joined)
    return {name: i + 1 for i, name in enumerate(dict.fromkeys((FRAME, *first, *dynamics.moving, *joined)))}


def _on_shaft(dynamics: Dynamics) -> dict[str, str]:
    """Links that are one body with another: further cranks of a shaft, on which no joint acts but through the first."""
    held = {reaction.on for reaction in dynamics.reactions}
    first = dynamics.reactions[0].on
    return {name: name if name in held else first for name in dynamics.moving}


def _reactions(machine: Machine, one: Member, joints: Sequence[Wrench]) -> Iterator[tuple[Reaction, Array]]:
    """Reactions of a mechanism's own joints, X and Y of shape (2, n); a slave's share of its master's are none."""
    for reaction, wrench in zip(one.dynamics.reactions, joints, strict=True):
        if reaction.on in one.dynamics.moving:
            shape = (1, len(one.loaded.mechanisms.groups[one.group].index), len(one.angle))
            x, y = (np.broadcast_to(part, shape)[0, one.member] for part in (wrench.x, wrench.y))
            yield reaction, turned_to_machine(machine, one.place, x, y)


def _reactions_on(name: str, reactions: Sequence[tuple[Reaction, Array]], numbers: dict[str, int]) -> Iterator[Force]:
    """Reactions on one link."""
    for reaction, value in reactions:
        if name == reaction.on:
            yield Force(pair_symbol("F", numbers[reaction.by], numbers[name]), "reaction", reaction.name, value)
        elif name == reaction.by:
            yield Force(pair_symbol("F", numbers[reaction.on], numbers[name]), "reaction", reaction.name, -value)


def pair_symbol(letter: str, by: int, on: int) -> str:
    """Symbol of a force of one body on another."""
    return f"{letter}_{by}{on}" if max(by, on) < 10 else f"{letter}_{by},{on}"


def _hanging(machine: Machine, one: Member, solved: Sequence[Any]) -> Iterator[tuple[str, str, Array]]:
    """Slaves of a mechanism: name, joint, and the force of its rod on theirs."""
    loaded = one.loaded
    own = loaded.mechanisms.names.index(one.place.name)
    for place in machine.places:
        if loaded.carriers.master[loaded.mechanisms.names.index(place.name)] == own:
            slave = member_of(machine, loaded, place, one.angle)
            for reaction, value in _reactions(machine, slave, solved[slave.group].forces.joints):
                if reaction.by == _MASTER_ROD:
                    yield place.name, f"{place.name}.{reaction.name}", value


def turned_to_machine(machine: Machine, place: Place, x: Array, y: Array) -> Array:
    """Give a vector of a mechanism's axes in the machine's, shape (2, n)."""
    return np.stack(in_machine_axes(x, y, frame(machine, place)))


def known_forces(machine: Machine, one: Member, i: int, number: int) -> Iterator[Force]:
    """Load, weight and inertia of one link."""
    load = loads_of(one)[i]
    mass = np.ravel(one.bodies[i].mass)
    still = np.zeros(len(one.angle))
    weights = (mass * np.ravel(part) + still for part in one.gravity)
    yield Force("P", "load", "", turned_to_machine(machine, one.place, load.x[0] + still, load.y[0] + still))
    yield Force(f"G_{number}", "weight", "", turned_to_machine(machine, one.place, *weights))
    yield Force(f"Φ_{number}", "inertia", "", turned_to_machine(machine, one.place, *_inertia(one, i)))


def loads_of(one: Member) -> Sequence[Wrench]:
    """Loads of all links, shape (1, n)."""
    value = np.zeros((1, len(one.angle)))
    gas, piston = one.loaded.gas, one.loaded.carriers.piston[one.loaded.mechanisms.names.index(one.place.name)]
    if gas is not None and piston >= 0:
        value = -gas.force(gas.pressure(one.angle, gas.volume(one.angle)))[:, piston]
    return one.dynamics.load(one.motion, one.size, value)


def _inertia(one: Member, i: int) -> tuple[Array, Array]:
    """Inertia force of one link, in the mechanism's axes: what the frame bears where nothing else has mass. [N]"""
    nothing = Body(*(np.zeros((1, 1)) for _part in Body._fields))
    bodies = one.dynamics.bodies(*(body if j == i else nothing for j, body in enumerate(one.bodies)))
    unloaded = one.dynamics.load(one.motion, one.size, np.zeros((1, 1)))
    conditions = Conditions(
        one.drive,
        Gravity(np.zeros((1, 1)), np.zeros((1, 1))),
        tuple(NO_FRICTION for _slider in one.dynamics.sliding),
    )
    joints = one.dynamics.forces(one.motion, one.size, bodies, unloaded, conditions).joints
    on_frame = [w for reaction, w in zip(one.dynamics.reactions, joints, strict=True) if reaction.by == FRAME]
    x, y = (
        -np.sum([np.broadcast_to(part, (1, len(one.angle)))[0] for part in parts], axis=0)
        for parts in ([w.x for w in on_frame], [w.y for w in on_frame])
    )
    return x, y
