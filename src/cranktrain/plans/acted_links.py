"""Links of a mechanism with all that acts on them at one crank angle, and what they are called.

All axes are the machine's, X right and Y up, seen from the free end.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from cranktrain.linkage.forces import Wrench
from cranktrain.machine import Machine
from cranktrain.mechanisms.dynamics import FRAME, AnyDynamics, Reaction
from cranktrain.motion import Array
from cranktrain.plans.acting import (
    MASTER_ROD,
    Force,
    Member,
    known_forces,
    link_numbers,
    member_of,
    pair_symbol,
    turned_to_machine,
)
from cranktrain.questions.forces.loaded_machine import SolvedBatch

_CRANK, _ROD, _MASTER = "crank", "rod", "master_"
"""What a master calls its crank and rod; before what its slaves call its rod and slider."""


@dataclass(frozen=True)
class Seen:
    """A mechanism as a sheet numbers it.

    Attributes
    ----------
    one : Member
        At one angle.
    numbers, names : mapping by the mechanism's own names of its bodies
        1 is the frame, 2 the crank; `master_rod` of a mechanism that is seen as another's master.
    hung : mapping of slave to number
        Of the rods that hang on its rod, where they have one; the others go by their mechanism's name.
    """

    one: Member
    numbers: Mapping[str, int]
    names: Mapping[str, str]
    hung: Mapping[str, int]


def seen_by_itself(one: Member, after: int = 1) -> Seen:
    """Give a mechanism with numbers of its own, the crank's next after a number."""
    numbers = link_numbers(one.place, after)
    return Seen(one, numbers, {name: name for name in numbers}, {})


def seen_by_slave(master: Member, slave: Seen) -> Seen:
    """Give a master with the numbers that its slave has for its links."""
    own = link_numbers(master.place)
    names = {name: name if name in (FRAME, _CRANK) else f"{_MASTER}{name}" for name in own}
    numbers = {name: slave.numbers[names[name]] for name in own}
    return Seen(master, numbers, names, {slave.one.place.name: slave.numbers[_ROD]})


def master_of(machine: Machine, slave: Member) -> Member | None:
    """Find the mechanism on whose rod another hangs; None of one that hangs on a crank."""
    loaded = slave.loaded
    index = int(loaded.carriers.master[loaded.mechanisms.names.index(slave.place.name)])
    if index < 0:
        return None
    name = loaded.mechanisms.names[index]
    place = next(place for place in machine.places if place.name == name)
    return member_of(machine, loaded, place, slave.angle)


def acted_links(machine: Machine, seen: Seen) -> dict[str, tuple[Force, ...]]:
    """Give all that acts on the links of a mechanism: what is known first, then reactions.

    Parameters
    ----------
    machine : Machine
    seen : Seen

    Returns
    -------
    dict of str to tuple of Force
        By the links' names; further cranks of a shaft are one body with the first. Reactions are the exact ones of the
        whole machine: a master's hold what its slaves do to it, the forces of whose rods on the master's are named for
        them, `F_1R`, unless the slave's rod has a number.
    """
    one, numbers = seen.one, seen.numbers
    solved = one.loaded.solved(one.angle)
    reactions = list(_reactions(machine, one, solved[one.batch].forces.joints))
    bodies = _on_shaft(one.dynamics)
    found: dict[str, list[Force]] = {body: [] for body in bodies.values()}
    for i, (name, body) in enumerate(bodies.items()):
        found[body] += known_forces(machine, one, i, numbers[name])
        if name == _ROD:
            found[body] += _hanging(machine, seen, solved)
    for name, body in bodies.items():
        found[body] += _reactions_on(name, reactions, numbers)
    return {body: tuple(forces) for body, forces in found.items()}


def _on_shaft(dynamics: AnyDynamics) -> dict[str, str]:
    """Links that are one body with another: further cranks of a shaft, on which no joint acts but through the first."""
    held = {reaction.on for reaction in dynamics.reactions}
    first = dynamics.reactions[0].on
    return {name: name if name in held else first for name in dynamics.moving}


def cranks_of(dynamics: AnyDynamics) -> tuple[str, ...]:
    """Links of a mechanism that turn with the shaft; a slave has none of its own."""
    in_groups = {name for group in dynamics.groups for name in group.links}
    return tuple(name for name in dynamics.moving if name not in in_groups)


def _reactions(machine: Machine, one: Member, joints: Sequence[Wrench]) -> Iterator[tuple[Reaction, Array]]:
    """Reactions of a mechanism's own joints, X and Y of shape (2, n); a slave's share of its master's are none."""
    for reaction, wrench in zip(one.dynamics.reactions, joints, strict=True):
        if reaction.on in one.dynamics.moving:
            yield reaction, turned_to_machine(machine, one.place, one.own(wrench.x), one.own(wrench.y))


def _reactions_on(
    name: str, reactions: Sequence[tuple[Reaction, Array]], numbers: Mapping[str, int]
) -> Iterator[Force]:
    """Reactions on one link."""
    for reaction, value in reactions:
        if name == reaction.on:
            yield Force(pair_symbol("F", numbers[reaction.by], numbers[name]), "reaction", reaction.name, value)
        elif name == reaction.by:
            yield Force(pair_symbol("F", numbers[reaction.on], numbers[name]), "reaction", reaction.name, -value)


def _hanging(machine: Machine, seen: Seen, solved: Sequence[SolvedBatch]) -> Iterator[Force]:
    """Forces of the rods that hang on a mechanism's rod."""
    one = seen.one
    loaded = one.loaded
    own = loaded.mechanisms.names.index(one.place.name)
    for place in machine.places:
        if loaded.carriers.master[loaded.mechanisms.names.index(place.name)] == own:
            slave = member_of(machine, loaded, place, one.angle)
            number = seen.hung.get(place.name)
            symbol = f"F_{place.name}" if number is None else pair_symbol("F", number, seen.numbers[_ROD])
            for reaction, value in _reactions(machine, slave, solved[slave.batch].forces.joints):
                if reaction.by == MASTER_ROD:
                    yield Force(symbol, "reaction", f"{place.name}.{reaction.name}", -value)
