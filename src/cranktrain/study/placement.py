"""The mechanisms of a machine where they stand: pins and their derivatives in machine axes."""

from dataclasses import replace

import numpy as np

from cranktrain.engine.frames import Frame, frame_of, in_machine_axes
from cranktrain.engine.places import Place
from cranktrain.engine.specs import MAIN
from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.machine import Machine
from cranktrain.mechanisms.kind import Drawing, Guide
from cranktrain.motion import Array, Coefficient, Point


def first_throw(machine: Machine) -> tuple[Place, ...]:
    """Give the places on the main shaft's first throw that carries any; none where the machine cannot be arranged.

    Where other shafts lie no file says, so they are not drawn.
    """
    places = [place for place in machine.places if place.shaft == MAIN] or machine.places
    first = min((place.throw for place in places), default=0)
    return tuple(place for place in places if place.throw == first)


def place_called(machine: Machine, name: str | None) -> Place:
    """Find a place by name; unless named, the first slave of the first throw, which shows its master too.

    Raises
    ------
    InputError
        If no place has that name.
    """
    on_throw = first_throw(machine)
    if name is None:
        return next((place for place in on_throw if place.kind.name == "articulated_rod"), on_throw[0])
    for place in machine.places:
        if place.name == name:
            return place
    allowed = _("must be one of this machine's mechanisms: {names}")
    names = ", ".join(place.name for place in machine.places)
    raise InputError([Problem("", name, allowed.format(names=names))])


def slider_crank_called(machine: Machine, name: str | None) -> Place:
    """Find a slider-crank by name; the first one unless given.

    Raises
    ------
    InputError
        If no place has that name, or it is another mechanism.
    """
    cranks = [place.name for place in machine.places if place.kind.name == "slider_crank"]
    place = place_called(machine, name or (cranks[0] if cranks else None))
    if place.kind.name != "slider_crank":
        allowed = _("is no slider-crank; this construction is made for no other mechanism")
        raise InputError([Problem("", place.name, allowed)])
    return place


def frame(machine: Machine, place: Place) -> Frame:
    """Where a place's axes lie in the machine's."""
    clockwise = machine.rotation == "clockwise"
    return frame_of(place, first_angle=machine.first_axis, clockwise=clockwise)


def placed(machine: Machine, place: Place, angle: Array) -> Drawing:
    """Give a place's drawing in machine axes.

    Parameters
    ----------
    machine : Machine
    place : Place
    angle : Array, shape (n,)
        φ of the machine. [rad]

    Returns
    -------
    Drawing
        Pins with their derivatives, shape (n,) [m, m/rad, m/rad²]; directions of guides from X, anticlockwise [rad].
    """
    axes = frame(machine, place)
    with np.errstate(all="ignore"):  # what cannot close is NaN, and where it just closes velocities have no bound
        own = place.kind.drawing(angle + place.phase, place.geometry)
        pins = {name: _in_machine_axes(pin, axes, np.zeros(np.shape(angle))) for name, pin in own.pins.items()}
    guides = [
        Guide(guide.pin, np.arctan2(*in_machine_axes(np.cos(guide.direction), np.sin(guide.direction), axes)[::-1]))
        for guide in own.guides
    ]
    return replace(own, pins=pins, guides=guides)


def output_motion(machine: Machine, place: Place, angle: Array) -> Coefficient:
    """Give a place's output: distance of the slider from the shaft along its own x, or direction of the rocker.

    Parameters
    ----------
    machine : Machine
    place : Place
    angle : Array, shape (n,)
        Crank angle as the machine shows it. [rad]

    Returns
    -------
    Coefficient, shape (n,)
        [m, m/rad, m/rad²], or [rad, rad/rad, rad/rad²].
    """
    with np.errstate(all="ignore"):
        motion = place.kind.motion(angle + machine.zero + place.phase, place.geometry)
    return motion.slider if place.kind.output == "slider" else motion.rocker.angle


def _in_machine_axes(moving: Point, axes: Frame, still: Array) -> Point:
    """Turn a point with its derivatives."""
    parts = [
        in_machine_axes(still + along, still + across, axes) for along, across in zip(moving.x, moving.y, strict=True)
    ]
    return Point(Coefficient(*(part[0] for part in parts)), Coefficient(*(part[1] for part in parts)))
