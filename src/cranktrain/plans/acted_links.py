"""Links of a mechanism with all that acts on them at one crank angle, and what they are called.

All axes are the machine's, X right and Y up, seen from the free end.
"""

from collections.abc import Iterator, Mapping

from cranktrain.mechanisms.dynamics import FRAME, AnyDynamics, Reaction
from cranktrain.motion import Array
from cranktrain.plans.acting import MASTER_ROD, LoadedMechanism, known_forces, link_numbers, member_of, pair_symbol
from cranktrain.plans.force_sides import PolygonForce
from cranktrain.plans.vectors import pair
from cranktrain.record import record

_CRANK, _ROD, MASTER = "crank", "rod", "master_"
"""What a master calls its crank and rod; before what its slaves call its rod and slider."""


@record
class Seen:
    """A mechanism as a sheet numbers it.

    Attributes
    ----------
    one : LoadedMechanism
    numbers, names : mapping by the mechanism's own names of its bodies
        1 is the frame, 2 the crank; `master_rod` of a mechanism that is seen as another's master.
    hung : mapping of slave to number
        Of the rods that hang on its rod, where they have one; the others go by their mechanism's name.
    """

    one: LoadedMechanism
    numbers: Mapping[str, int]
    names: Mapping[str, str]
    hung: Mapping[str, int]


def seen_by_itself(one: LoadedMechanism, after: int = 1) -> Seen:
    """Give a mechanism with numbers of its own, the crank's next after a number."""
    numbers = link_numbers(one.place, after)
    return Seen(one, numbers, {name: name for name in numbers}, {})


def seen_by_slave(master: LoadedMechanism, slave: Seen) -> Seen:
    """Give a master with the numbers that its slave has for its links."""
    own = link_numbers(master.place)
    names = {name: name if name in (FRAME, _CRANK) else f"{MASTER}{name}" for name in own}
    numbers = {name: slave.numbers[names[name]] for name in own}
    return Seen(master, numbers, names, {slave.one.place.name: slave.numbers[_ROD]})


def master_of(slave: LoadedMechanism) -> LoadedMechanism | None:
    """Find the mechanism on whose rod another hangs; None of one that hangs on a crank."""
    places = slave.machine.places
    index = int(slave.loaded.carriers.master[places.index(slave.place)])
    return None if index < 0 else member_of(slave.machine, slave.loaded, places[index], slave.angle)


def acted_links(seen: Seen) -> dict[str, tuple[PolygonForce, ...]]:
    """Give all that acts on the links of a mechanism: what is known first, then reactions.

    Parameters
    ----------
    seen : Seen

    Returns
    -------
    dict of str to tuple of PolygonForce
        By the links' names; further cranks of a shaft are one body with the first. Reactions are the exact ones of the
        whole machine: a master's hold what its slaves do to it, the forces of whose rods on the master's are named for
        them, `F_1R`, unless the slave's rod has a number.
    """
    numbers = seen.numbers
    bodies = _on_shaft(seen.one.dynamics)
    found: dict[str, list[PolygonForce]] = {body: [] for body in bodies.values()}
    for i, (name, body) in enumerate(bodies.items()):
        found[body] += known_forces(seen.one, i, numbers[name])
        if name == _ROD:
            found[body] += _hanging(seen)
    for reaction, value in _reactions(seen.one):
        for on, by, force in ((reaction.on, reaction.by, value), (reaction.by, reaction.on, -value)):
            if on in bodies:
                symbol = pair_symbol("F", numbers[by], numbers[on])
                found[bodies[on]].append(PolygonForce(symbol, "reaction", reaction.name, on, pair(force)))
    return {body: tuple(force._replace(link=seen.names[body]) for force in forces) for body, forces in found.items()}


def _on_shaft(dynamics: AnyDynamics) -> dict[str, str]:
    """Links that are one body with another: further cranks of a shaft, on which no joint acts but through the first."""
    held = {reaction.on for reaction in dynamics.reactions}
    first = dynamics.reactions[0].on
    return {name: name if name in held else first for name in dynamics.moving}


def _reactions(one: LoadedMechanism) -> Iterator[tuple[Reaction, Array]]:
    """Reactions of a mechanism's own joints, shape (2,); a slave's share of its master's are none."""
    for reaction, wrench in zip(one.dynamics.reactions, one.solved.forces.joints, strict=True):
        if reaction.on in one.dynamics.moving:
            yield reaction, one.in_machine_axes(wrench.x, wrench.y)


def _hanging(seen: Seen) -> Iterator[PolygonForce]:
    """Forces of the rods that hang on a mechanism's rod."""
    one = seen.one
    places = one.machine.places
    for place, master in zip(places, one.loaded.carriers.master.tolist(), strict=True):
        if master == places.index(one.place):
            number = seen.hung.get(place.name)
            symbol = f"F_{place.name}" if number is None else pair_symbol("F", number, seen.numbers[_ROD])
            for reaction, value in _reactions(member_of(one.machine, one.loaded, place, one.angle)):
                if reaction.by == MASTER_ROD:
                    yield PolygonForce(symbol, "reaction", f"{place.name}.{reaction.name}", _ROD, pair(-value))
