"""What there is to draw of a machine: the mechanisms of its first throw in machine axes, with their cylinders. [mm]"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from cranktrain.engine.cylinders import cylinders_of
from cranktrain.engine.places import Place
from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.machine import Machine
from cranktrain.mechanisms.kind import Drawing
from cranktrain.motion import Array
from cranktrain.quantities import shown
from cranktrain.study.placement import first_throw, placed
from cranktrain.viz.shapes import Along

_TURN = np.linspace(0.0, 2 * np.pi, 361)
_OUTLINED = ("slider_crank", "crank_rocker", "articulated_rod")
"""Kinds that are drawn in outline, with eyes, pistons and cylinders."""
_STAR = 3
"""So many slaves on one master make its big end a disc."""


@dataclass(frozen=True)
class Member:
    """One mechanism of the throw.

    Attributes
    ----------
    place : Place
    is_first : bool
        Drawn filled; all others hollow.
    turn : Drawing
        Its pins over a turn, shape (361,). [mm, mm/rad, mm/rad²]
    bore : float or None
        None where the file has none. [mm]
    """

    place: Place
    is_first: bool
    turn: Drawing
    bore: float | None

    @cached_property
    def turn_pins(self) -> dict[str, Array]:
        """Where its pins are over a turn, by name, shape (2, 361). [mm]"""
        return self.turn.positions

    @property
    def output(self) -> str | None:
        """Name of the pin that slides in this mechanism's own guide; None for a rocker."""
        is_slider = self.place.kind.output == "slider"
        return self.turn.guides[0].pin if is_slider and self.turn.guides else None

    @property
    def crank_pin(self) -> str:
        """Name of the crank's pin: the second of the link that is drawn first."""
        return self.turn.links[0].pins[1]

    @property
    def is_plain(self) -> bool:
        """Whether it is drawn link by link: a mechanism that is not one of the engine's."""
        return self.place.kind.name not in _OUTLINED

    @cached_property
    def stroke_line(self) -> Along:
        """Line on which the output pin travels."""
        guide = self.turn.guides[0]
        along = np.array([np.cos(guide.direction), np.sin(guide.direction)]).reshape(2)
        pin = self.turn_pins[guide.pin][:, 0]
        return Along(pin - np.dot(pin, along) * along, along)

    @cached_property
    def travel(self) -> tuple[float, float]:
        """Nearest and farthest place of the output pin on its line. [mm]"""
        assert self.output is not None  # asked of sliders only
        places = self.stroke_line.place(self.turn_pins[self.output])
        return float(np.nanmin(places)), float(np.nanmax(places))

    @property
    def width(self) -> float:
        """Bore; where the file has none, 0.6 of the stroke for the crosshead that is drawn instead. [mm]"""
        return self.bore if self.bore is not None else 0.6 * (self.travel[1] - self.travel[0])


@dataclass(frozen=True)
class Scene:
    """The throw that is drawn.

    Attributes
    ----------
    machine : Machine
    members : tuple of Member
    crank_radius : float
        [mm]
    """

    machine: Machine
    members: tuple[Member, ...]
    crank_radius: float

    def pins(self, member: Member, angle: float) -> dict[str, Array]:
        """Give a member's pins at a shown crank angle [deg]: name to (X, Y). [mm]"""
        key = (member.place.name, angle)
        if key not in self._pins_at:
            turned = self.turned(member, np.array([angle]))
            self._pins_at[key] = {name: pin[:, 0] for name, pin in turned.items()}
        return self._pins_at[key]

    @cached_property
    def _pins_at(self) -> dict[tuple[str, float], dict[str, Array]]:
        """Pins that were asked for, by member and angle: a frame of a moving picture asks for them many times."""
        return {}

    def turned(self, member: Member, angles: Array) -> dict[str, Array]:
        """Give a member's pins at shown crank angles, shape (n,) [deg]: name to (2, n). [mm]"""
        phi = np.deg2rad(angles) + self.machine.zero
        return {name: shown(pin, "mm") for name, pin in placed(self.machine, member.place, phi).positions.items()}

    def closing_angle(self, angle: float) -> float:
        """Give the first crank angle from this one, by whole degrees, at which all links close. [deg]"""
        tried = angle + np.arange(360.0)
        pins = [pin for member in self.members for pin in self.turned(member, tried).values()]
        closed = np.flatnonzero(np.all(np.isfinite(np.concatenate(pins)), axis=0))
        if not closed.size:
            raise InputError([Problem("", None, _("the links can close at no crank angle: there is nothing to draw"))])
        return float(tried[closed[0]])

    def crank_direction(self, angle: float) -> float:
        """Direction of the throw from X at a shown crank angle [deg]. [rad]"""
        pin = self.pins(self.members[0], angle)[self.members[0].crank_pin]
        return float(np.arctan2(pin[1], pin[0]))

    @property
    def sliders(self) -> tuple[Member, ...]:
        """Members that drive a piston or crosshead."""
        return tuple(member for member in self.members if member.output is not None)

    @property
    def is_star(self) -> bool:
        """Whether so many slaves hang on the master that its big end is a disc."""
        return sum(member.place.kind.name == "articulated_rod" for member in self.members) >= _STAR

    @cached_property
    def clearance(self) -> float:
        """How far from the shaft the cylinders of neighbours would meet. [mm]"""
        found = [0.0]
        for i, one in enumerate(self.sliders):
            for other in self.sliders[i + 1 :]:
                between = float(np.arccos(np.clip(np.dot(one.stroke_line.along, other.stroke_line.along), -1.0, 1.0)))
                if 1e-3 < between < np.pi - 1e-3:
                    found.append(0.5 * max(one.width, other.width) / np.tan(between / 2))
        return max(found)


def scene_of(machine: Machine) -> Scene:
    """Collect what there is to draw of a machine's first throw."""
    places = first_throw(machine)
    pistons = [place for place in places if place.kind.output == "slider"]
    bores = {
        pistons[i].name: cylinder.spec.bore
        for cylinder in cylinders_of(machine.cylinder, pistons)
        for i in cylinder.pistons
    }
    members: list[Member] = []
    for number, place in enumerate(places):
        turn = placed(machine, place, _TURN).scaled(shown(1.0, "mm"))
        bore = bores.get(place.name)
        members.append(Member(place, number == 0, turn, None if bore is None else shown(bore.si, "mm")))
    return Scene(machine, tuple(members), float(np.hypot(*members[0].turn_pins[members[0].crank_pin][:, 0])))
