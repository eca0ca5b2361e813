"""The mechanisms of a machine where they stand: pins and their derivatives in machine axes."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.grouping import grouped
from cranktrain.language import Words, _
from cranktrain.layout.frames import Frame, Orientation, frame_of, in_machine_axes
from cranktrain.layout.places import PlacedMechanism
from cranktrain.layout.specs import MAIN
from cranktrain.layout.standing import shaft_centres
from cranktrain.machine import Machine
from cranktrain.mechanisms.drawing import Drawing, Guide
from cranktrain.mechanisms.output import OutputPart
from cranktrain.motion import Array, Coefficient, Point, single
from cranktrain.numerics import turn_grid
from cranktrain.plans.found_again import found_again
from cranktrain.plans.found_once import found_once
from cranktrain.plans.link_points import with_points
from cranktrain.questions.cylinders.declared import cylinders_of
from cranktrain.texts.plain_cranks import PLAIN


@found_once
def first_throw(machine: Machine) -> tuple[PlacedMechanism, ...]:
    """Give the places on the main shaft's first throw that carries any, and all that share cylinders with these.

    Opposed pistons lead from shaft to shaft: the other piston of each cylinder is drawn, with all that is on its throw.
    What is on a shaft whose place is not known is left out. None where the machine cannot be arranged.
    """
    places = [place for place in machine.places if place.shaft == MAIN] or machine.places
    first = min((place.throw for place in places), default=0)
    return _with_shared(machine, {place.name for place in places if place.throw == first})


def throw_of(machine: Machine, place: PlacedMechanism) -> tuple[PlacedMechanism, ...]:
    """Give the places on a place's throw, and all that share cylinders with these, as `first_throw` does."""
    return _with_shared(
        machine, {one.name for one in machine.places if (one.shaft, one.throw) == (place.shaft, place.throw)}
    )


def _with_shared(machine: Machine, found: set[str]) -> tuple[PlacedMechanism, ...]:
    """Add to places, by their names, all that share throws and cylinders with them."""
    centres = shaft_places(machine).centres
    n_found = 0
    while n_found < len(found):
        n_found = len(found)
        drawn = [place for place in machine.places if place.name in found]
        throws, cylinders = {(one.shaft, one.throw) for one in drawn}, {one.cylinder for one in drawn}
        found |= {
            one.name
            for one in machine.places
            if one.shaft in centres and ((one.shaft, one.throw) in throws or one.cylinder in cylinders)
        }
    return tuple(place for place in machine.places if place.name in found)


class PlacedShafts(NamedTuple):
    """Centres of shafts by name, X right and Y up from the main one [m]; those of `assumed` the file does not give."""

    centres: Mapping[str, Array]
    assumed: tuple[str, ...]


@found_once
def shaft_places(machine: Machine) -> PlacedShafts:
    """Say where shafts stand for a drawing.

    Of two shafts that face each other along one line the second's place may be assumed: as far away as both pistons
    reach, and a piston's diameter more for what is above the pins.

    Examples
    --------
    >>> crank = {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "200 mm"}
    >>> pistons = {"exhaust": {"mechanism": crank}, "scavenge": {"mechanism": crank, "shaft": "upper"}}
    >>> found = shaft_places(Machine(shaft={"upper": {}}, bank={"A": {**pistons, "lead": "0 deg"}}))
    >>> found.assumed, round(float(found.centres["upper"][1]), 9)
    (('upper',), 0.56)
    """
    known = shaft_centres(machine.shafts)
    missing = [name for name in machine.shafts if name not in known]
    pair = _facing(machine) if len(machine.shafts) == 2 and missing else None
    if pair is None:
        return PlacedShafts(known, ())
    phi = turn_grid()
    with np.errstate(all="ignore"):
        motions = [place.kind.motion(phi + place.phase, place.geometry).slider.value for place in pair]
    if not np.any(np.isfinite(motions[0] + motions[1])):
        return PlacedShafts(known, ())
    distance = float(np.nanmax(motions[0] + motions[1])) + _bore(machine, pair[0], motions[0])
    on_main, other = pair if pair[0].shaft == MAIN else pair[::-1]
    lines = [
        np.array(in_machine_axes(single(across[0]), single(across[1]), frame(machine, place)))
        for place, across in (
            (on_main, (distance, getattr(on_main.geometry, "offset", 0.0))),
            (other, (0.0, getattr(other.geometry, "offset", 0.0))),
        )
    ]
    return PlacedShafts({**known, missing[0]: np.ravel(lines[0] - lines[1])}, tuple(missing))


def _facing(machine: Machine) -> tuple[PlacedMechanism, PlacedMechanism] | None:
    """Find the first two pistons on both shafts that share a cylinder, if all others face each other as they do."""
    cylinders = grouped((place.cylinder, place) for place in machine.places)
    pairs = [pair for pair in cylinders.values() if len({place.shaft for place in pair}) == 2]
    lines = {round(float(frame(machine, place).direction) % np.pi, 9) for pair in pairs for place in pair}
    return (pairs[0][0], pairs[0][1]) if len(lines) == 1 else None


def _bore(machine: Machine, place: PlacedMechanism, motion: Array) -> float:
    """Bore of a piston's cylinder; where the file has none, 0.6 of the stroke. [m]"""
    bore = cylinders_of(machine.cylinder, [place])[0].bore
    return 0.6 * float(np.ptp(motion[np.isfinite(motion)])) if bore is None else bore.si


def output_of(machine: Machine, place: PlacedMechanism) -> OutputPart:
    """Say what the last part of a mechanism is: where the file has no cylinders, what could work in one is a ram."""
    output = place.kind.output
    return output if machine.cylinder.model_fields_set or output.bare is None else output.bare


def name_of_output(machine: Machine, place: PlacedMechanism) -> Words:
    """Name the last part of a mechanism as what it is: piston 1L, ram 1, valve 2."""
    return _(output_of(machine, place).called, name=place.name)


def place_called(machine: Machine, name: str | None) -> PlacedMechanism:
    """Find a place by its name, or the first one by its cylinder's.

    Unless named, the first slave of the first throw, which shows its master too.

    Raises
    ------
    InputError
        If no place has that name.
    """
    on_throw = first_throw(machine)
    if name is None:
        return next((place for place in on_throw if place.kind.is_slave), on_throw[0])
    named = [place for place in machine.places if name in (place.name, place.cylinder)]
    if named:
        return next((place for place in named if place.name == name), named[0])
    allowed = _("must be one of this machine's mechanisms: {names}")
    names = ", ".join(place.name for place in machine.places)
    raise InputError([Problem("", name, allowed.format(names=names))])


def slider_crank_called(machine: Machine, name: str | None) -> PlacedMechanism:
    """Find a slider-crank by name; the first one unless given.

    Raises
    ------
    InputError
        If no place has that name, or it is another mechanism.
    """
    allowed = _("is no slider-crank; this construction is made for no other mechanism")
    return _of_kinds(machine, name, ("slider_crank",), allowed)


def plain_crank_called(machine: Machine, name: str | None) -> PlacedMechanism:
    """Find a slider-crank or an eccentric by name; the first slider-crank unless given, or else the first eccentric.

    Raises
    ------
    InputError
        If no place has that name, or it is another mechanism.
    """
    allowed = _("is no slider-crank or eccentric; this construction is made for no other mechanism")
    return _of_kinds(machine, name, PLAIN, allowed)


def _of_kinds(machine: Machine, name: str | None, kinds: Sequence[str], allowed: Words) -> PlacedMechanism:
    """Find a place by name, or the first of the kinds, as they stand; refuse one of another kind."""
    first = next((place.name for kind in kinds for place in machine.places if place.kind.name == kind), None)
    if first is None:
        raise InputError([Problem("mechanism", None, allowed)])
    place = place_called(machine, name or first)
    if place.kind.name not in kinds:
        raise InputError([Problem("--mechanism", place.name, allowed, _("such as: {example}", example=first))])
    return place


def frame(machine: Machine, place: PlacedMechanism) -> Frame:
    """Where a place's axes lie in the machine's."""
    return frame_of(place, machine.orientation)


def placed(machine: Machine, place: PlacedMechanism, angle: Array) -> Drawing:
    """Give a place's drawing in machine axes.

    Parameters
    ----------
    machine : Machine
    place : PlacedMechanism
    angle : Array, shape (n,)
        φ of the machine. [rad]

    Returns
    -------
    Drawing
        Pins with their derivatives, shape (n,) [m, m/rad, m/rad²]; directions of guides from X, anticlockwise [rad].
    """
    return found_again(machine, _placed, place, machine.orientation, angle)


def _placed(place: PlacedMechanism, orientation: Orientation, angle: Array) -> Drawing:
    """Find it."""
    axes = frame_of(place, orientation)
    with np.errstate(all="ignore"):  # what cannot close is NaN, and where it just closes velocities have no bound
        turned = angle + place.phase
        own = with_points(place.kind.drawing(turned, place.geometry), place, turned)
        pins = {name: _in_machine_axes(pin, axes, np.zeros(np.shape(angle))) for name, pin in own.pins.items()}
    guides = [
        Guide(guide.pin, np.arctan2(*in_machine_axes(np.cos(guide.direction), np.sin(guide.direction), axes)[::-1]))
        for guide in own.guides
    ]
    return replace(own, pins=pins, guides=guides)


def output_motion(machine: Machine, place: PlacedMechanism, angle: Array) -> Coefficient:
    """Give a place's output: distance of the slider from the shaft along its own x, or direction of the rocker.

    Parameters
    ----------
    machine : Machine
    place : PlacedMechanism
    angle : Array, shape (n,)
        Crank angle as the machine shows it. [rad]

    Returns
    -------
    Coefficient, shape (n,)
        [m, m/rad, m/rad²], or [rad, rad/rad, rad/rad²].
    """
    return motion_of_output(place, machine.zero, angle)


def motion_of_output(place: PlacedMechanism, zero: Array, angle: Array) -> Coefficient:
    """Give a place's output, as `output_motion`, from φ where the shown crank angle is 0. [rad]"""
    with np.errstate(all="ignore"):
        motion = place.kind.motion(angle + zero + place.phase, place.geometry)
    return motion.slider if place.kind.output.is_slider else motion.rocker.angle


def _in_machine_axes(moving: Point, axes: Frame, still: Array) -> Point:
    """Turn a point with its derivatives."""
    parts = [
        in_machine_axes(still + along, still + across, axes) for along, across in zip(moving.x, moving.y, strict=True)
    ]
    return Point(Coefficient(*(part[0] for part in parts)), Coefficient(*(part[1] for part in parts)))
