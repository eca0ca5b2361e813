"""Forces on the Assur groups of a mechanism, in the order in which a polygon of each is drawn.

Link by link, so that a reaction in an inner joint is a chord: it closes the part of the link on one side of it.
"""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.mechanisms.dynamics import Group, Reaction
from cranktrain.motion import Array
from cranktrain.plans.acted_links import (
    Seen,
    acted_links,
    master_of,
    seen_by_itself,
    seen_by_slave,
)
from cranktrain.plans.acting import LoadedMechanism, pair_symbol, torques_of_file
from cranktrain.plans.force_sides import INITIAL, GroupForces, PolygonForce, Span, TorqueOnLink
from cranktrain.plans.rubbing import friction_on_links
from cranktrain.plans.vectors import pair

_NOTHING = 1e-9
"""A force less than this part of the mechanism's largest is none."""


class _Arc(NamedTuple):
    """The sides of one link: what moments give, what is known, what is found last."""

    first: tuple[PolygonForce, ...]
    known: tuple[PolygonForce, ...]
    last: tuple[PolygonForce, ...]


def group_forces(one: LoadedMechanism, after: int = 1) -> Iterator[GroupForces]:
    """Forces on a mechanism's groups at one crank angle.

    Parameters
    ----------
    one : LoadedMechanism
    after : int
        The crank has the next number.

    Yields
    ------
    GroupForces
        In the order in which they are solved: the last group first, of a slave its master's after its own, the crank
        at the end.
    """
    seen = seen_by_itself(one, after)
    yield from _of_mechanism(seen)
    master = master_of(one)
    if master is not None:
        yield from _of_mechanism(seen_by_slave(master, seen))


def _of_mechanism(seen: Seen) -> Iterator[GroupForces]:
    """Forces on one mechanism's groups and crank."""
    one = seen.one
    links = acted_links(seen)
    largest = max(force.size for forces in links.values() for force in forces)
    friction = {
        (rubbing.on, rubbing.by): one.in_machine_axes(rubbing.wrench.x, rubbing.wrench.y)
        for rubbing in friction_on_links(one)
    }
    laying = _Laying(seen, links, friction, _NOTHING * largest)
    in_groups = {name for group in one.dynamics.groups for name in group.links}
    cranks = tuple(name for name in one.dynamics.moving if name not in in_groups)  # a slave has none of its own
    groups = [*reversed(one.dynamics.groups), *([Group(INITIAL, cranks)] if cranks else [])]
    for group in groups:
        yield laying.of_group(group)


class _Laying(NamedTuple):
    """How the forces on a mechanism's links are laid end to end; a force of less than `least` is none.

    friction, shape (2,), is by the links on and by which it acts.
    """

    seen: Seen
    links: Mapping[str, tuple[PolygonForce, ...]]
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
            float(self.seen.one.solved.forces.driving_torque[0]) if group.sort == INITIAL else float("nan"),
            tuple(torque for name in group.links for torque in self._torques(name)),
        )

    def _torques(self, name: str) -> Iterator[TorqueOnLink]:
        """Torques of the file on a link, in the sense in which the crank turns."""
        for symbol, load in torques_of_file(self.seen.one, name, self.seen.numbers[name]):
            yield TorqueOnLink(symbol, load.name, self.seen.names[name], float(load.counted[0]))

    def _arc(self, name: str, group: Group) -> _Arc:
        """Sort the forces on a link of a group; of reactions in inner joints there is none."""
        reactions = self.seen.one.dynamics.reactions
        inner = {one.name for one in reactions if {one.on, one.by} <= {*group.links}}
        own = {one.name: one for one in reactions if one.on == name and one.name not in inner}
        known = [force for force in self.links[name] if force.joint not in {*inner, *own}]
        wholes = [force for force in self.links[name] if force.joint in own]
        found = [part for force in wholes for part in self._parts(name, force, own[force.joint], group)]
        first = [part for part in found if part.about]
        last = [part for part in found if not part.about]
        return _Arc(*(tuple(side for side in sides if side.size > self.least) for sides in (first, known, last)))

    def _parts(self, name: str, force: PolygonForce, reaction: Reaction, group: Group) -> list[PolygonForce]:
        """Give an outer reaction in parts: across the link and along it, or pressing a guide and rubbing on it."""
        whole = np.array(force.value)
        drag = self.friction.get((name, reaction.by))
        across = next((one for one in group.across if one.joint == force.joint), None)
        if drag is not None:
            numbers = self.seen.numbers[reaction.by], self.seen.numbers[name]
            split = ((pair_symbol("N", *numbers), whole - drag, ""), (pair_symbol("f", *numbers), drag, ""))
        elif across is not None:
            one = self.seen.one
            link = one.links[one.dynamics.moving.index(across.link)]
            axis = one.in_machine_axes(link.cos, link.sin)
            along = axis * float(axis @ whole)
            split = ((f"{force.symbol}^t", whole - along, across.about), (f"{force.symbol}^n", along, ""))
        else:
            return [force]
        parts = [force._replace(symbol=symbol, value=pair(value), about=about) for symbol, value, about in split]
        return parts if min(part.size for part in parts) > self.least else [force]

    def _wholes(self, own: Sequence[str], sides: Sequence[PolygonForce]) -> Iterator[Span]:
        """Give the reactions whose parts are sides."""
        for name in own:
            for force in self.links[name]:
                reaction = next((one for one in self.seen.one.dynamics.reactions if one.name == force.joint), None)
                at = [i for i, side in enumerate(sides) if side.cause == "reaction" and side.joint == force.joint]
                if reaction is not None and len(at) == 2 and sides[at[0]].link == self.seen.names[name]:
                    start = at[0] if at[1] == at[0] + 1 else at[1]
                    yield Span(force, self.seen.names[reaction.by], start, (start + 2) % len(sides))

    def _chords(self, group: Group, ends: Mapping[str, tuple[int, int]]) -> Iterator[Span]:
        """Give the reactions in inner joints, each on a link that has no other one."""
        inner = [one for one in self.seen.one.dynamics.reactions if {one.on, one.by} <= {*group.links}]
        joined = [name for one in inner for name in (one.on, one.by)]
        for one in inner:
            name, by = (one.on, one.by) if joined.count(one.on) == 1 else (one.by, one.on)
            force = next(force for force in self.links[name] if force.joint == one.name)
            if force.size > self.least:
                start, end = ends[name]
                yield Span(force, self.seen.names[by], end, start)
