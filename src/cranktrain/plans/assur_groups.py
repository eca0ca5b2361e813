"""Forces on the Assur groups of a mechanism, in the order in which a polygon of each is drawn.

Link by link, so that a reaction in an inner joint is a chord: it closes the part of the link on one side of it.
"""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.machine import Machine
from cranktrain.mechanisms.dynamics import Group, Reaction
from cranktrain.motion import Array
from cranktrain.plans.acted_links import (
    Seen,
    acted_links,
    cranks_of,
    master_of,
    seen_by_itself,
    seen_by_slave,
)
from cranktrain.plans.acting import Force, Member, pair_symbol, turned_to_machine
from cranktrain.plans.force_sides import INITIAL, GroupForces, PolygonForce, Span
from cranktrain.plans.rubbing import friction_on_links, rubbing_force

_NOTHING = 1e-9
"""A force less than this part of the mechanism's largest is none."""


class _Arc(NamedTuple):
    """The sides of one link: what moments give, what is known, what is found last."""

    first: tuple[PolygonForce, ...]
    known: tuple[PolygonForce, ...]
    last: tuple[PolygonForce, ...]


def group_forces(machine: Machine, one: Member, after: int = 1) -> Iterator[GroupForces]:
    """Forces on a mechanism's groups at one crank angle.

    Parameters
    ----------
    machine : Machine
    one : Member
        At one angle.
    after : int
        The crank has the next number.

    Yields
    ------
    GroupForces
        In the order in which they are solved: the last group first, of a slave its master's after its own, the crank
        at the end.
    """
    seen = seen_by_itself(one, after)
    yield from _of_mechanism(machine, seen)
    master = master_of(machine, one)
    if master is not None:
        yield from _of_mechanism(machine, seen_by_slave(master, seen))


def _of_mechanism(machine: Machine, seen: Seen) -> Iterator[GroupForces]:
    """Forces on one mechanism's groups and crank."""
    one = seen.one
    links = acted_links(machine, seen)
    largest = max(float(np.max(np.hypot(*force.value))) for forces in links.values() for force in forces)
    laying = _Laying(machine, seen, links, _friction(machine, seen), _NOTHING * largest)
    cranks = cranks_of(one.dynamics)
    groups = [*reversed(one.dynamics.groups), *([Group(INITIAL, cranks)] if cranks else [])]
    for group in groups:
        yield laying.of_group(group)


def _friction(machine: Machine, seen: Seen) -> dict[tuple[str, str], Array]:
    """Forces of friction, shape (2,), by the links on and by which they act."""
    return {
        (rubbing.on, rubbing.by): rubbing_force(machine, seen.one, rubbing)[:, 0]
        for rubbing in friction_on_links(seen.one)
    }


class _Laying(NamedTuple):
    """How the forces on a mechanism's links are laid end to end; a force of less than `least` is none."""

    machine: Machine
    seen: Seen
    links: Mapping[str, tuple[Force, ...]]
    friction: Mapping[tuple[str, str], Array]
    least: float

    def of_group(self, group: Group) -> GroupForces:
        """Lay the sides of a group, and find where its chords are."""
        own = [name for name in group.links if name in self.links]
        arcs = [self._arc(name, group) for name in own]
        later = [side for arc in arcs[1:] for side in (*arc.known, *arc.first, *arc.last)]
        sides = (*arcs[0].first, *arcs[0].known, *later, *arcs[0].last)
        starts = np.cumsum([-len(arcs[0].last), *(sum(map(len, arc)) for arc in arcs)]).tolist()
        ends = {name: (starts[i] % max(len(sides), 1), starts[i + 1]) for i, name in enumerate(own)}
        return GroupForces(
            group.sort,
            tuple(self.seen.names[name] for name in group.links),
            tuple(self.seen.numbers[name] for name in group.links),
            sides,
            tuple(self._wholes(own, sides)),
            tuple(self._chords(group, ends)),
            self._moment() if group.sort == INITIAL else float("nan"),
        )

    def _arc(self, name: str, group: Group) -> _Arc:
        """Sort the forces on a link of a group; of reactions in inner joints there is none."""
        first: list[PolygonForce] = []
        known: list[PolygonForce] = []
        last: list[PolygonForce] = []
        for force in self.links[name]:
            reaction = self._reaction(force.joint)
            if reaction is not None and {reaction.on, reaction.by} <= {*group.links}:
                continue
            if reaction is None or reaction.on != name:
                known.append(self._side(name, force))
                continue
            for part in self._parts(name, force, reaction, group):
                (first if part.about else last).append(part)
        return _Arc(*(tuple(side for side in sides if side.size > self.least) for sides in (first, known, last)))

    def _reaction(self, joint: str) -> Reaction | None:
        """Find one of the mechanism's own joints."""
        return next((one for one in self.seen.one.dynamics.reactions if one.name == joint), None)

    def _side(
        self, name: str, force: Force, mark: str = "", value: Array | None = None, about: str = ""
    ) -> PolygonForce:
        """Give a force, or a part of it."""
        x, y = map(float, force.value[:, 0] if value is None else value)
        return PolygonForce(f"{force.symbol}{mark}", force.cause, force.joint, self.seen.names[name], (x, y), about)

    def _parts(self, name: str, force: Force, reaction: Reaction, group: Group) -> list[PolygonForce]:
        """Give an outer reaction in parts: across the link and along it, or pressing a guide and rubbing on it."""
        whole = force.value[:, 0]
        drag = self.friction.get((name, reaction.by))
        across = next((one for one in group.across if one.joint == force.joint), None)
        if drag is not None:
            numbers = self.seen.numbers[reaction.by], self.seen.numbers[name]
            parts = [
                self._side(name, force._replace(symbol=pair_symbol(letter, *numbers)), value=value)
                for letter, value in (("N", whole - drag), ("f", drag))
            ]
        elif across is not None:
            along = (axis := self._direction(across.link)) * float(axis @ whole)
            parts = [
                self._side(name, force, "^t", whole - along, across.about),
                self._side(name, force, "^n", along),
            ]
        else:
            return [self._side(name, force)]
        return parts if min(part.size for part in parts) > self.least else [self._side(name, force)]

    def _direction(self, link: str) -> Array:
        """Direction of a link in the machine's axes, shape (2,)."""
        one = self.seen.one
        found = one.dynamics.links(one.motion, one.size)[one.dynamics.moving.index(link)]
        shape = (1, len(one.angle))
        x, y = (np.broadcast_to(part, shape)[0] for part in (found.cos, found.sin))
        return turned_to_machine(self.machine, one.place, x, y)[:, 0]

    def _wholes(self, own: Sequence[str], sides: Sequence[PolygonForce]) -> Iterator[Span]:
        """Give the reactions whose parts are sides."""
        for name in own:
            for force in self.links[name]:
                reaction = self._reaction(force.joint)
                at = [i for i, side in enumerate(sides) if side.cause == "reaction" and side.joint == force.joint]
                if reaction is not None and len(at) == 2 and sides[at[0]].link == self.seen.names[name]:
                    start = at[0] if at[1] == at[0] + 1 else at[1]
                    yield Span(self._side(name, force), self.seen.names[reaction.by], start, (start + 2) % len(sides))

    def _chords(self, group: Group, ends: Mapping[str, tuple[int, int]]) -> Iterator[Span]:
        """Give the reactions in inner joints, each on a link that has no other one."""
        inner = [one for one in self.seen.one.dynamics.reactions if {one.on, one.by} <= {*group.links}]
        joined = [name for one in inner for name in (one.on, one.by)]
        for one in inner:
            name, by = (one.on, one.by) if joined.count(one.on) == 1 else (one.by, one.on)
            force = next(force for force in self.links[name] if force.joint == one.name)
            side = self._side(name, force)
            if side.size > self.least:
                start, end = ends[name]
                yield Span(side, self.seen.names[by], end, start)

    def _moment(self) -> float:
        """Balancing moment on the crank, in the sense in which its shaft turns. [N·m]"""
        one = self.seen.one
        return float(one.own(one.loaded.solved(one.angle)[one.batch].forces.driving_torque)[0])
