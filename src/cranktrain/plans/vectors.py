"""Vectors of a plan: velocity and acceleration of every pin, whole, about another pin, and along a slot."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Literal, NamedTuple

import numpy as np

from cranktrain.layout.speed import rates
from cranktrain.linkage.forces import Drive
from cranktrain.mechanisms.drawing import Drawing
from cranktrain.motion import Array, Coefficient, Point
from cranktrain.record import record

Quantity = Literal["velocity", "acceleration"]
Part = Literal["absolute", "relative", "normal", "tangential", "coriolis"]
"""What a vector of a polygon is."""

POLE = "p"

_EVEN = 1e-12
"""A link about a fixed pin turns evenly where its tangential acceleration is less than this part of the normal one."""


class PolygonVector(NamedTuple):
    """A vector of a polygon: symbol such as `a_BA^n`, part, from which point to which, exact X and Y, whose it is.

    pins are the pin that moves and, unless it is absolute, the one that it moves about. `A'` is the point of a slotted
    link that lies under the pin A.
    """

    symbol: str
    part: Part
    start: str
    end: str
    value: tuple[float, float]
    pins: tuple[str, ...]

    @property
    def size(self) -> float:
        """Length of the vector, in the polygon's unit."""
        return float(np.hypot(*self.value))


class PinVectors(NamedTuple):
    """Where a pin is, its velocity and its acceleration: X and Y. [m, m/s, m/s²]"""

    place: Array
    velocity: Array
    acceleration: Array


class _Leg(NamedTuple):
    """A step of a polygon: a pin about another one, of the same link or, in a slot, of one that turns so. [rad/s]"""

    pin: str
    about: str
    slot_turning: float | None = None


@record
class _Plan:
    """What a polygon is drawn from: motions by pin, letters of their ends by pin, fixed pins, the quantity."""

    motions: Mapping[str, PinVectors]
    letters: Mapping[str, str]
    fixed: Sequence[str]
    quantity: Quantity

    def whole(self, pin: str) -> Array:
        """Velocity or acceleration of a pin."""
        motion = self.motions[pin]
        return motion.velocity if self.quantity == "velocity" else motion.acceleration

    def vector(
        self, pins: tuple[str, ...], part: Part, ends: tuple[str, str], value: Array, mark: str = ""
    ) -> PolygonVector:
        """Name a vector for its pins."""
        symbol = f"{self.quantity[0]}_{_index(pins)}" + (f"^{mark}" if mark else "")
        return PolygonVector(symbol, part, *ends, pair(value), pins)


def plan_vectors(drawing: Drawing, at: int, drive: Drive, quantity: Quantity) -> tuple[PolygonVector, ...]:
    """Give the vectors of a plan, each after those at whose ends it starts.

    Parameters
    ----------
    drawing : Drawing
        Pins of shape (n,), in the axes of the plan.
    at : int
        Which of the n positions.
    drive : Drive
        Speed and acceleration of the crank there. [rad/s, rad/s²]
    quantity : "velocity" or "acceleration"

    Returns
    -------
    tuple of Vector. [m/s or m/s²]
        Of each pin from the pole; about the first pin of its link, where that moves. Accelerations about a pin are
        split into normal and tangential parts, but for those of a crank that turns evenly. Of a pin in a slot: about
        the link's point under it, along the slot; of accelerations Coriolis' part 2ω × v_r first.

    Notes
    -----
    docs/theory/plans.
    """
    motions, legs = _motions(drawing, at, drive)
    plan = _Plan(motions, _letters(motions), drawing.fixed, quantity)
    return tuple(_vectors(plan, legs))


def _motions(drawing: Drawing, at: int, drive: Drive) -> tuple[dict[str, PinVectors], list[_Leg]]:
    """Motions of all pins, and of the points under those in slots; the steps in which a polygon reaches them."""
    places = {name: in_plane(pin, at) for name, pin in drawing.pins.items()}
    every = {name: PinVectors(place.value, *rates(place, drive)) for name, place in places.items()}
    motions = {name: motion for name, motion in every.items() if name not in drawing.ends}
    legs: list[_Leg] = []
    for link in drawing.links:
        named = [pin for pin in link.pins if pin not in drawing.ends]
        legs += [_Leg(pin, named[0]) for pin in named[1:]]
    for block in drawing.blocks:
        pin, link = block
        if len(link) == 1:
            legs.append(_Leg(pin, link[0], 0.0))
        else:
            under = _unused(f"{pin}'", motions)
            motions[under], turning = _point_under(motions[pin], every[link[0]], every[link[-1]])
            base = next(name for name in drawing.slotted(block) if name in motions)
            legs += [_Leg(under, base), _Leg(pin, under, turning)]
    return motions, legs


def in_plane(pin: Point, at: int = 0) -> Coefficient:
    """Place of a pin in one of its positions, with its derivatives: X and Y each. [m, m/rad, m/rad²]"""
    return Coefficient(*(np.array([np.ravel(x)[at], np.ravel(y)[at]]) for x, y in zip(*pin, strict=True)))


def pair(vector: Array) -> tuple[float, float]:
    """X and Y of a vector as numbers."""
    return float(vector[0]), float(vector[1])


def _point_under(pin: PinVectors, base: PinVectors, other: PinVectors) -> tuple[PinVectors, float]:
    """Point of a link that lies under a pin, by two pins of the link; how fast the link turns. [rad/s]"""
    arm = other.place - base.place
    square = np.dot(arm, arm)
    turning = cross(arm, other.velocity - base.velocity) / square
    rate = cross(arm, other.acceleration - base.acceleration) / square
    reach = pin.place - base.place
    across = turned_left(reach)
    return PinVectors(
        pin.place,
        base.velocity + turning * across,
        base.acceleration + rate * across - turning**2 * reach,
    ), turning


def angle_of(vector: Array) -> float:
    """Direction of a vector from X. [rad]"""
    return float(np.arctan2(vector[1], vector[0]))


def turned_left(vector: Array) -> Array:
    """A vector turned by 90° anticlockwise."""
    return np.array([-vector[1], vector[0]])


def cross(one: Array, other: Array) -> float:
    """Vector product of two vectors, across the plane, positive where the other one lies anticlockwise."""
    return float(one[0] * other[1] - one[1] * other[0])


def _vectors(plan: _Plan, legs: Sequence[_Leg]) -> Iterator[PolygonVector]:
    """Vectors from the pole when first needed, then those between pins."""
    reached = set(plan.fixed)
    for leg in [*legs, *(_Leg(pin, pin) for pin in plan.motions)]:
        for pin in (leg.about, leg.pin):
            if pin not in reached:
                yield plan.vector((pin,), "absolute", (POLE, plan.letters[pin]), plan.whole(pin))
                reached.add(pin)
        if leg.pin != leg.about:
            yield from _between(plan, leg)


def _between(plan: _Plan, leg: _Leg) -> Iterator[PolygonVector]:
    """Vectors of a pin about another one of the same link; in a slot, about the slotted link's point under it."""
    names = (leg.pin, leg.about)
    is_fixed = leg.about in plan.fixed
    ends = (POLE if is_fixed else plan.letters[leg.about], plan.letters[leg.pin])
    whole = plan.whole(leg.pin) - plan.whole(leg.about)
    pin, about = (plan.motions[name] for name in names)
    speed = pin.velocity - about.velocity
    if plan.quantity == "acceleration" and leg.slot_turning is None:
        arm = pin.place - about.place
        normal = -np.dot(speed, speed) / np.dot(arm, arm) * arm
        tangential = whole - normal
        if is_fixed and np.hypot(*tangential) <= _EVEN * np.hypot(*normal):
            return
        corner = f"n_{_index(names)}"
        yield plan.vector(names, "normal", (ends[0], corner), normal, "n")
        yield plan.vector(names, "tangential", (corner, ends[1]), tangential, "t")
    if plan.quantity == "acceleration" and leg.slot_turning is not None and leg.about.endswith("'"):
        coriolis = 2.0 * leg.slot_turning * turned_left(speed)
        corner = f"k_{_index(names)}"
        yield plan.vector(names, "coriolis", (ends[0], corner), coriolis, "c")
        yield plan.vector(names, "relative", (corner, ends[1]), whole - coriolis, "r")
    elif not is_fixed:
        yield plan.vector(names, "relative", ends, whole)


def spoken_name(pin: str) -> str:
    """Name of a pin as plans have it: the pin of a crank or slider goes by the crank's or slider's name."""
    return pin.replace(".pin", "")


def _letters(pins: Mapping[str, PinVectors]) -> dict[str, str]:
    """Give the letters at which the vectors of pins end: small ones, each once, none the pole's."""
    letters: dict[str, str] = {}
    for pin in pins:
        letters[pin] = _unused(spoken_name(pin).lower(), {POLE, *letters.values()})
    return letters


def _unused(name: str, taken: "Mapping[str, object] | set[str]") -> str:
    """Prime a name until it is free."""
    while name in taken:
        name += "'"
    return name


def _index(pins: tuple[str, ...]) -> str:
    """Names of pins as an index: BA, or with a comma where one has more letters."""
    said = [spoken_name(pin) for pin in pins]
    return ("," if any(len(name.rstrip("'")) > 1 for name in said) else "").join(said)
