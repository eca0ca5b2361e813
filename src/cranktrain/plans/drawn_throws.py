"""Which throws of a machine a sheet shows: the first, and every later one that is not like those before."""

from collections.abc import Sequence

from cranktrain.layout.places import PlacedMechanism
from cranktrain.machine import Machine
from cranktrain.numerics.nested import leaves
from cranktrain.plans.found_once import found_once
from cranktrain.plans.placement import first_throw, place_called, shaft_places, throw_of
from cranktrain.questions.cylinders.declared import cylinders_of

_DIGITS = 12

Throw = tuple[PlacedMechanism, ...]


@found_once
def drawn_throws(machine: Machine, mechanism: str | None = None) -> tuple[Throw, ...]:
    """Give the places of each throw that is drawn, with all that shares cylinders with it.

    Parameters
    ----------
    machine : Machine
    mechanism : str, optional
        Whose throw alone is drawn, by the mechanism's name or its cylinder's; unless given, one of each sort: throws
        are alike where their mechanisms have the same kinds, lengths, directions, bores and piston rods. What is on a
        shaft whose place is not known is left out.

    Returns
    -------
    tuple of tuple of PlacedMechanism

    Examples
    --------
    >>> crank = {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "200 mm"}
    >>> stages = {"bore": "150 mm", "2": {"bore": "90 mm"}}
    >>> throws = {"main": {"throws": ["0 deg", "180 deg", "0 deg"]}}
    >>> pump = Machine(shaft=throws, bank={"A": {"mechanism": crank}}, cylinder=stages)
    >>> [[place.name for place in throw] for throw in drawn_throws(pump)]
    [['1'], ['2']]
    """
    if mechanism is not None:
        return (throw_of(machine, place_called(machine, mechanism)),)
    first = first_throw(machine)
    found = [first]
    seen, sorts = {place.name for place in first}, {_sort(machine, first)}
    centres = shaft_places(machine).centres
    for place in machine.places:
        if place.name in seen or place.shaft not in centres:
            continue
        throw = throw_of(machine, place)
        seen |= {one.name for one in throw}
        sort = _sort(machine, throw)
        if sort not in sorts and throw:
            sorts.add(sort)
            found.append(throw)
    return tuple(found)


def drawn_places(machine: Machine, mechanism: str | None = None) -> Throw:
    """Give the places of all throws that are drawn."""
    return tuple(place for throw in drawn_throws(machine, mechanism) for place in throw)


def _sort(machine: Machine, throw: Sequence[PlacedMechanism]) -> tuple[object, ...]:
    """Say what tells a throw from others on paper."""
    pistons = [place for place in throw if place.kind.output.is_slider]
    cylinders = cylinders_of(machine.cylinder, pistons)
    return tuple(map(_of_place, throw)), tuple(
        str(size) for one in cylinders for size in (one.bore, one.piston_rod, one.chambers)
    )


def _of_place(place: PlacedMechanism) -> tuple[object, ...]:
    """What of a place tells it from others: of a chain, whose lengths are many, where it stands in the file."""
    if place.kind.structure is not None:
        return (place.kind.name, place.path)
    lengths = [round(float(number), _DIGITS) for number in leaves(place.geometry)]
    return (place.kind.name, place.is_far, round(float(place.axis), _DIGITS), *lengths)
