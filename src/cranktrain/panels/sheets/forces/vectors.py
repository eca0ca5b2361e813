"""Forces on pistons, guides, crank pins and in joints as vectors."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.analysis import Result
from cranktrain.grouping import grouped
from cranktrain.language import _
from cranktrain.layout.frames import in_machine_axes
from cranktrain.layout.places import PlacedMechanism
from cranktrain.mechanisms.drawing import Drawing
from cranktrain.mechanisms.dynamics import FRAME, Reaction
from cranktrain.motion import Array
from cranktrain.panels.design import OneDesign, closed
from cranktrain.panels.vectors import PinVector, VectorsToScale, to_one_scale
from cranktrain.plans.placement import frame, placed
from cranktrain.plans.stroke_lines import unit
from cranktrain.plans.vectors import turned_left
from cranktrain.questions.forces.joint_forces import joint_label

_BETWEEN_LINKS = ("pin", "pivot", "knuckle_pin")
"""Roles of joints whose whole reaction is drawn; guides and crank pins have their own letters."""


def forces(result: Result, places: Sequence[PlacedMechanism], angles: Array) -> Iterator[VectorsToScale]:
    """Give the forces on what is drawn, all to one scale; none where the file says of nothing that acts.

    Parameters
    ----------
    result : Result
        Of one machine.
    places : sequence of PlacedMechanism
        What is drawn.
    angles : Array, shape (n,)
        Crank angles as the machine shows them. [deg]

    Yields
    ------
    VectorsToScale
        Of the gas on pistons; of guides on what slides in them, N where nothing rubs; of all rods together on each
        crank pin: toward the shaft K, in the sense of rotation T, and both; in other joints that of one link on the
        next. [N]
    """
    shown = OneDesign(result, 0)
    if not shown.has("joint_force_x"):
        return
    drawn = [_Drawn(shown, place, _drawing(result, place, angles), angles) for place in places]
    pins = grouped(((one.place.shaft, one.place.throw), one) for one in drawn if _is_on_throw(one))
    yield from to_one_scale(
        "N",
        [
            (_("Gas force"), [vector for one in drawn for vector in _gas(one)]),
            (_("Side force"), [vector for one in drawn for vector in _guides(one)]),
            (_("Crank pin"), [vector for on_pin in pins.values() for vector in _on_pin(on_pin)]),
            (_("Joints"), [vector for one in drawn for vector in _joints(one)]),
        ],
    )


class _Drawn(NamedTuple):
    """A mechanism that is drawn: its pins at n crank angles. [deg]"""

    shown: OneDesign
    place: PlacedMechanism
    drawing: Drawing
    angles: Array

    def at(self, values: Array) -> Array:
        """Give a curve at the angles."""
        return np.interp(self.angles, self.shown.cycle, closed(values))

    def whole(self, x: Array, y: Array) -> Array:
        """Give a vector of the mechanism's axes in the machine's, shape (2, n)."""
        return np.stack(in_machine_axes(x, y, frame(self.shown.result.machines[0], self.place)))

    def of(self, quantity: str, dimension: str) -> Array | None:
        """Give a quantity of this mechanism; None where it has none."""
        names = self.shown.result.labels.get(dimension, ()) if self.shown.has(quantity) else ()
        if self.place.name not in names:
            return None
        values = self.shown(quantity)[names.index(self.place.name)]
        return None if np.all(np.isnan(values)) else self.at(values)


def _drawing(result: Result, place: PlacedMechanism, angles: Array) -> Drawing:
    """Pins of a mechanism in the machine's axes."""
    machine = result.machines[0]
    return placed(machine, place, np.ravel(np.deg2rad(angles) + machine.zero))


def _gas(one: _Drawn) -> Iterator[PinVector]:
    """Force of the gas on a piston, along its guide toward the shaft."""
    force = one.of("gas_force", "piston")
    if force is not None and one.drawing.guides:
        guide = one.drawing.guides[0]
        yield PinVector(one.place.name, guide.pin, "p", "P_g", -force * _all_along(unit(guide.direction), force))


def _all_along(direction: Array, values: Array) -> Array:
    """Give a direction for each of some values, shape (2, n), where it is one for all."""
    return np.broadcast_to(direction.reshape(2, -1), (2, values.size))


def _guides(one: _Drawn) -> Iterator[PinVector]:
    """Force of each guide that stands still on what slides in it."""
    contacts = {contact.joint: contact.pin for contact in one.place.kind.dynamics.contacts}
    for reaction in _own(one):
        if reaction.role == "guide" and reaction.name in contacts:
            yield PinVector(one.place.name, contacts[reaction.name], "N", "N", _force(one, reaction))


def _own(one: _Drawn) -> Iterator[Reaction]:
    """Joints of a mechanism; a slave's share of its master's are none."""
    dynamics = one.place.kind.dynamics
    return (reaction for reaction in dynamics.reactions if reaction.on in dynamics.moving)


def _force(one: _Drawn, reaction: Reaction) -> Array:
    """Force in a joint of one link on the next, shape (2, n). [N]"""
    place = one.shown.member("joint", joint_label(one.place.name, reaction))
    return one.whole(*(one.at(one.shown(f"joint_force_{x}")[place]) for x in "xy"))


def _is_on_throw(one: _Drawn) -> bool:
    """Whether it has a load on the pin of its throw, and not on an eccentric of its own."""
    return not one.place.kind.has_own_pin and one.of("crankpin_load_radial", "mechanism") is not None


def _on_pin(drawn: Sequence[_Drawn]) -> Iterator[PinVector]:
    """Force of all rods on a crank pin."""
    first = drawn[0]
    centre, pin = first.drawing.links[0].pins[:2]
    arm = first.drawing.positions[pin] - first.drawing.positions[centre]
    outward = arm / np.hypot(*arm)
    # What turns from x to y in a mechanism's axes turns clockwise where its crank does.
    sense = -float(frame(first.shown.result.machines[0], first.place).sense)
    radial, tangential = (
        sum((found for one in drawn if (found := one.of(f"crankpin_load_{way}", "mechanism")) is not None), np.zeros(1))
        for way in ("radial", "tangential")
    )
    toward, around = -radial * outward, tangential * sense * turned_left(outward)
    for letter, value in (("K", toward), ("T", around), ("F", toward + around)):
        yield PinVector(first.place.name, pin, letter, "R" if letter == "F" else letter, value)


def _joints(one: _Drawn) -> Iterator[PinVector]:
    """Forces in the other joints."""
    for reaction in _own(one):
        pin = _pin_of(one.drawing, reaction)
        if reaction.role in _BETWEEN_LINKS and pin is not None:
            yield PinVector(one.place.name, pin, "F", "R", _force(one, reaction))


def _pin_of(drawing: Drawing, reaction: Reaction) -> str | None:
    """Pin of a joint: of a chain it names its joint; else it is where both links meet, or where one stands still."""
    name = reaction.name.partition("/")[0]
    if name in drawing.pins:
        return name
    pins = {link.name: link.pins for link in drawing.links} | {FRAME: tuple(drawing.fixed)}
    return next((pin for pin in pins.get(reaction.on, ()) if pin in pins.get(reaction.by, ())), None)
