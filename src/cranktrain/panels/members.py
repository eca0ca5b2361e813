"""What moves in a drawing: where its pins are and how fast they go, how its links stand and turn; each of them once."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from cranktrain.analysis import Result
from cranktrain.layout.places import PlacedMechanism
from cranktrain.layout.speed import SpeedCurve, rates
from cranktrain.linkage.forces import Drive
from cranktrain.mechanisms.drawing import Drawing
from cranktrain.motion import Array, Coefficient, Point
from cranktrain.panels.shapes import peak
from cranktrain.panels.throw_member import standing
from cranktrain.plans.placement import placed, shaft_places
from cranktrain.plans.turning import turning
from cranktrain.record import record

_ALIKE = 1e-9
"""Pins that are never farther apart are one. [m]"""


@record
class MovingPin:
    """A pin over crank angles, X to the right and Y up from the centre of the main shaft.

    Attributes
    ----------
    mechanism : str
    names : tuple of str
        All that its mechanism has for it, the first first.
    is_fixed : bool
        Whether it stands still.
    place, velocity, acceleration : Array, shape (2, n)
        X and Y; NaN where the links cannot close. [m, m/s, m/s²]
    """

    mechanism: str
    names: tuple[str, ...]
    is_fixed: bool
    place: Array
    velocity: Array
    acceleration: Array


@record
class MovingLink:
    """A link over crank angles.

    Attributes
    ----------
    mechanism, name : str
    pins : tuple of str
        From which to which it is looked at.
    direction, speed, acceleration : Array, shape (n,)
        From X, anticlockwise, counted on without a leap; NaN where the links cannot close. [rad, rad/s, rad/s²]
    """

    mechanism: str
    name: str
    pins: tuple[str, str]
    direction: Array
    speed: Array
    acceleration: Array


@record
class MovingMembers:
    """Pins and links of some mechanisms; no pins that only show how far a link reaches."""

    pins: tuple[MovingPin, ...]
    links: tuple[MovingLink, ...]


def has_speed(result: Result) -> bool:
    """Whether it is known how fast the crank turns."""
    return result.machines[0].main_shaft.speed is not None or result.get(SpeedCurve) is not None


def members(result: Result, places: Sequence[PlacedMechanism], angles: Array) -> MovingMembers:
    """Give pins and links of what is drawn; what mechanisms share once, with the first that has it.

    Parameters
    ----------
    result : Result
        Of one machine; without a speed its crank turns by 1 rad/s.
    places : sequence of PlacedMechanism
        What is on a shaft whose place is not known is left out.
    angles : Array, shape (n,)
        Crank angles as the machine shows them. [deg]

    Notes
    -----
    v = r′ω, a = r″ω² + r′ε; of a link along d: θ′ = d × d′ / d², θ″ = (d × d″ − 2 θ′ d · d′) / d². docs/theory/plans.
    """
    pins: list[MovingPin] = []
    links: dict[tuple[object, ...], MovingLink] = {}
    drive = _drive(result, angles)
    for place, drawing in _standing(result, places, angles):
        numbers = _numbers(drawing, place.name, pins, drive)
        for link in drawing.links:
            start, end = link.pins[:2]
            one = tuple(numbers.get(pin, (place.name, pin)) for pin in (start, end))
            if one not in links:
                direction = _direction(drawing.pins[start], drawing.pins[end])
                turned = direction.value, *rates(direction, drive)
                links[one] = MovingLink(place.name, link.name, (start, end), *turned)
    return MovingMembers(tuple(pins), tuple(links.values()))


def moving_pins(result: Result, places: Sequence[PlacedMechanism], angles: Array) -> tuple[MovingPin, ...]:
    """Give the pins alone; as `members`."""
    pins: list[MovingPin] = []
    drive = _drive(result, angles)
    for place, drawing in _standing(result, places, angles):
        _numbers(drawing, place.name, pins, drive)
    return tuple(pins)


def _turned(result: Result, angles: Array) -> Array:
    """φ of the machine at crank angles as it shows them. [rad]"""
    return np.ravel(np.deg2rad(angles) + result.machines[0].zero)


def _drive(result: Result, angles: Array) -> Drive:
    """Give how its crank turns there."""
    return turning(result.machines[0], result.get(SpeedCurve), _turned(result, angles))


def _standing(
    result: Result, places: Sequence[PlacedMechanism], angles: Array
) -> Iterator[tuple[PlacedMechanism, Drawing]]:
    """Give those of the mechanisms on shafts whose places are known, as they stand."""
    machine, phi = result.machines[0], _turned(result, angles)
    centres = shaft_places(machine).centres
    for place in places:
        if place.shaft in centres:
            yield place, standing(placed(machine, place, phi), centres[place.shaft])


def _numbers(drawing: Drawing, mechanism: str, known: list[MovingPin], drive: Drive) -> dict[str, int]:
    """Numbers of pins of a mechanism among those known, by name; none of what only shows how far it reaches."""
    positions = drawing.positions
    joints = [name for name in drawing.pins if name not in drawing.ends]
    return {name: _number(drawing, mechanism, name, positions[name], known, drive) for name in joints}


def _number(drawing: Drawing, mechanism: str, name: str, at: Array, known: list[MovingPin], drive: Drive) -> int:
    """Number of a pin among those that are known, to which it comes where it is another than they."""
    for number, one in enumerate(known):
        if np.array_equal(np.isnan(at), np.isnan(one.place)) and are_one(at, one.place):
            if one.mechanism == mechanism:
                known[number] = replace(one, names=(*one.names, name))
            return number
    velocity, acceleration = (
        np.stack(each) for each in zip(*(rates(one, drive) for one in drawing.pins[name]), strict=True)
    )
    known.append(MovingPin(mechanism, (name,), name in drawing.fixed, at, velocity, acceleration))
    return len(known) - 1


def are_one(one: Array, other: Array) -> bool:
    """Whether two pins never come apart where both are known; X and Y over crank angles. [m]"""
    return peak(one - other) < _ALIKE


def _direction(start: Point, end: Point) -> Coefficient:
    """Direction from one pin to another, counted on over the angles. [rad]"""
    (x, x1, x2), (y, y1, y2) = ([b - a for a, b in zip(*each, strict=True)] for each in zip(start, end, strict=True))
    with np.errstate(all="ignore"):  # of pins that meet there is none
        square = x**2 + y**2
        first = (x * y1 - y * x1) / square
        second = (x * y2 - y * x2 - 2 * first * (x * x1 + y * y1)) / square
    return Coefficient(_counted_on(np.arctan2(y, x)), first, second)


def _counted_on(angle: Array) -> Array:
    """Take leaps of whole turns out of an angle, over gaps, too. [rad]"""
    leaps = np.nan_to_num(np.round(np.diff(angle) / (2 * np.pi)))
    return angle - 2 * np.pi * np.concatenate([[0.0], np.cumsum(leaps)])
