"""What there is to draw of a machine: the mechanisms of its first throw in machine axes, with their cylinders. [mm]"""

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cache, cached_property
from itertools import combinations

import numpy as np

from cranktrain.analysis import SpeedWanted
from cranktrain.errors import InputError, Problem
from cranktrain.grouping import grouped
from cranktrain.language import _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.layout.specs import MAIN
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.panels.throw_member import DrawnMechanism, cylinder_sizes, standing
from cranktrain.plans.placement import first_throw, placed, shaft_places
from cranktrain.plans.shown_loads import ShownLoads, shown_loads
from cranktrain.plans.vectors import angle_of
from cranktrain.quantities import shown
from cranktrain.record import record

_TURN = np.linspace(0.0, 2 * np.pi, 361)
BIG_EYE, SMALL_EYE = 0.40, 0.22
"""Radii of a rod's eyes in parts of the crank radius."""

_PAIR, _PINS_OF_A_ROD = 2, 3
_BREAK, _BROKEN = 8.0, 0.8
"""A rod that reaches so many times as far as all else is broken, so that it ends at this part of their reach."""

_ABOVE, _CLEARANCE = 0.45, 0.02
"""Crown above the piston pin, and least room between two crowns, in parts of the bore."""

_SHARED = 1e-9
"""Pins that are never farther apart, in parts of all that is drawn, are one."""

FEW_MEMBERS = 2
"""Up to so many mechanisms, the links are drawn in the dead positions too."""

_STAR = 3
"""So many slaves on one master make its big end a disc."""


@record
class Scene:
    """The throw that is drawn.

    Attributes
    ----------
    machine : Machine
    members : tuple of DrawnMechanism
    ports : mapping of cylinder to mapping of "exhaust" and "scavenge" to float
        Heights of ports. [mm]
    assumed : tuple of str
        Shafts whose place the file does not give.
    is_alone : bool
        Whether no other throw is drawn beside it.
    loads : ShownLoads or None
        Of the machine file on its mechanisms.
    """

    machine: Machine
    members: tuple[DrawnMechanism, ...]
    ports: Mapping[str, Mapping[str, float]]
    assumed: tuple[str, ...]
    is_alone: bool = True
    loads: ShownLoads | None = None

    @cached_property
    def leading(self) -> DrawnMechanism:
        """The member on the throw from which the crank angle counts."""
        on_main = [member for member in self.members if member.place.shaft == MAIN] or self.members
        return min(on_main, key=lambda member: member.place.throw)

    @cached_property
    def crank_radius(self) -> float:
        """Of the leading throw. [mm]"""
        crank = self.leading
        return float(np.hypot(*(crank.turn_pins[crank.crank_pin][:, 0] - crank.centre)))

    @cached_property
    def cranks(self) -> tuple[DrawnMechanism, ...]:
        """One member for each throw that is drawn, the leading one first."""
        ordered = reversed((self.leading, *self.members))
        throws = {(member.place.shaft, member.place.throw): member for member in ordered}
        return tuple(sorted(throws.values(), key=lambda member: member is not self.leading))

    @cached_property
    def pairs(self) -> tuple[tuple[DrawnMechanism, DrawnMechanism], ...]:
        """Pistons that share a cylinder, two by two; a piston with side rods second."""
        cylinders = grouped((member.place.cylinder, member) for member in self.sliders)
        return tuple(
            (one, other) if other.place.is_far or not one.place.is_far else (other, one)
            for one, other in (found for found in cylinders.values() if len(found) == _PAIR)
        )

    @cached_property
    def shared_pins(self) -> Mapping[str, frozenset[str]]:
        """Pins of members drawn link by link that are an engine's, too, which draws them: by the member's name."""
        engines = [pin for one in self.members if not one.is_plain for pin in one.turn_pins.values()]
        within = _SHARED * self.size
        return {
            member.place.name: frozenset(
                name
                for name, pin in member.turn_pins.items()
                if member.is_plain and any(np.nanmax(np.abs(pin - one), initial=0.0) < within for one in engines)
            )
            for member in self.members
        }

    @property
    def singles(self) -> tuple[DrawnMechanism, ...]:
        """Sliders that have their cylinder for themselves."""
        return tuple(member for member in self.sliders if not any(member in pair for pair in self.pairs))

    @cached_property
    def pins(self) -> Callable[[DrawnMechanism, float], dict[str, Array]]:
        """Gives a member's pins at a shown crank angle [deg]: name to (X, Y) [mm]; each is asked for many times."""

        @cache
        def pins_at(member: DrawnMechanism, angle: float) -> dict[str, Array]:
            turned = self.turned(member, np.array([angle]))
            return {name: pin[:, 0] for name, pin in turned.items()}

        return pins_at

    def reach(self, member: DrawnMechanism, angle: float) -> float:
        """Where a slider's output pin is on its line, at a shown crank angle [deg]. [mm]"""
        return float(member.stroke_line.place(self.pins(member, angle)[member.turn.guides[0].pin]))

    def turned(self, member: DrawnMechanism, angles: Array) -> dict[str, Array]:
        """Give a member's pins at shown crank angles, shape (n,) [deg]: name to (2, n). [mm]"""
        phi = np.deg2rad(angles) + self.machine.zero
        drawing = placed(self.machine, member.place, phi).scaled(shown(1.0, "mm"))
        return standing(drawing, member.centre, member.cut).positions

    def closing_angle(self, angle: float) -> float:
        """Give the first crank angle from this one, by whole degrees, at which all links close. [deg]"""
        tried = angle + np.arange(360.0)
        pins = [pin for member in self.members for pin in self.turned(member, tried).values()]
        closed = np.flatnonzero(np.all(np.isfinite(np.concatenate(pins)), axis=0))
        if not closed.size:
            raise InputError([Problem("", None, _("the links can close at no crank angle: there is nothing to draw"))])
        return float(tried[closed[0]])

    def crank_direction(self, angle: float, member: DrawnMechanism) -> float:
        """Direction of a member's throw from X at a shown crank angle [deg]. [rad]"""
        return angle_of(self.pins(member, angle)[member.crank_pin] - member.centre)

    def above(self, member: DrawnMechanism) -> float:
        """Height of a slider's crown over its pin: schematic, but two in one cylinder do not meet. [mm]"""
        if member.crosshead is not None:
            return member.crosshead.rod_length + 0.5 * member.crosshead.piston
        if member.ram is not None:
            return member.ram.face
        usual = _ABOVE * member.width
        for one, other in self.pairs:
            if member in (one, other):
                pins = [pair.turn_pins[pair.turn.guides[0].pin] for pair in (one, other)]
                apart = float(np.nanmin((pins[1] - pins[0]).T @ one.stroke_line.along))
                return min(usual, 0.5 * apart - 0.5 * _CLEARANCE * member.width)
        return usual

    @property
    def sliders(self) -> tuple[DrawnMechanism, ...]:
        """Members that drive a piston or crosshead."""
        return tuple(member for member in self.members if member.output is not None)

    @cached_property
    def slaves(self) -> tuple[DrawnMechanism, ...]:
        """Members whose rods hang on another's."""
        return tuple(member for member in self.members if member.place.kind.is_slave)

    @property
    def is_star(self) -> bool:
        """Whether so many slaves hang on the master that its big end is a disc."""
        return len(self.slaves) >= _STAR

    @property
    def is_of_few(self) -> bool:
        """Whether its mechanisms are so few that their links are drawn in the dead positions too."""
        return len(self.members) <= FEW_MEMBERS

    @cached_property
    def size(self) -> float:
        """The larger of width and height of all that its pins reach. [mm]"""
        pins = np.concatenate([pin for member in self.members for pin in member.turn_pins.values()], axis=1)
        return float(np.max(np.nanmax(pins, axis=1) - np.nanmin(pins, axis=1)))

    @cached_property
    def clearance(self) -> float:
        """How far from the shaft the cylinders of neighbours would meet. [mm]"""
        found = [0.0]
        for one, other in combinations(self.sliders, 2):
            between = float(np.arccos(np.clip(np.dot(one.stroke_line.along, other.stroke_line.along), -1.0, 1.0)))
            if one.place.shaft == other.place.shaft and 1e-3 < between < np.pi - 1e-3:
                found.append(0.5 * max(one.width, other.width) / np.tan(between / 2))
        return max(found)


def scene_of(
    machine: Machine,
    throw: tuple[PlacedMechanism, ...] | None = None,
    *,
    is_alone: bool = True,
    speed: SpeedWanted = "constant",
) -> Scene:
    """Collect what there is to draw of a throw, the first unless given, and of all that shares its cylinders.

    By the speed go some loads.
    """
    places = first_throw(machine) if throw is None else throw
    sizes = cylinder_sizes(machine, places)
    shafts = shaft_places(machine)
    members: list[DrawnMechanism] = []
    for number, place in enumerate(places):
        centre = shown(shafts.centres.get(place.shaft, np.zeros(2)), "mm")
        turn = standing(placed(machine, place, _TURN).scaled(shown(1.0, "mm")), centre)
        members.append(sizes.member(place, turn, centre, is_first=number == 0, per_metre=shown(1.0, "mm")))
    ports = {name: {end: shown(height, "mm") for end, height in ends.items()} for name, ends in sizes.ports.items()}
    loads = shown_loads(machine, places, speed, np.zeros(2))
    return Scene(machine, _broken(tuple(members)), ports, shafts.assumed, is_alone, loads)


def _broken(members: tuple[DrawnMechanism, ...]) -> tuple[DrawnMechanism, ...]:
    """Break rods that reach much farther than all else, such as one that stands for no rod at all."""
    reaches = {member.place.name: member.travel[1] for member in members if member.output is not None}
    if len(reaches) < _PAIR:
        return members
    least = min(reaches.values())
    found: list[DrawnMechanism] = []
    for member in members:
        is_long = reaches.get(member.place.name, 0.0) > _BREAK * least and len(member.metal) == _PINS_OF_A_ROD
        cut = member.travel[0] - _BROKEN * least if is_long else 0.0
        found.append(replace(member, cut=cut, turn=standing(member.turn, np.zeros(2), cut)))
    return tuple(found)
