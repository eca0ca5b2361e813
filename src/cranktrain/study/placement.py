"""The mechanisms of a machine where they stand: pins and their derivatives in machine axes."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from cranktrain.engine.frames import Frame, frame_of, in_machine_axes
from cranktrain.engine.places import Place
from cranktrain.engine.specs import MAIN
from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.linkage import fixed, turned
from cranktrain.machine import Machine
from cranktrain.mechanisms.articulated_rod.kinematics import ArticulatedRod, articulated_rod
from cranktrain.mechanisms.crank_rocker.kinematics import CrankRocker, crank_rocker
from cranktrain.mechanisms.kind import Drawing, Guide
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank, slider_crank
from cranktrain.motion import Array, Coefficient, Point

Joints = Mapping[str, Point]
"""Pins by the names that a kind's drawing gives them."""


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
        Pins as (X, Y), shape (n,) [m]; directions of guides from X, anticlockwise [rad].
    """
    with np.errstate(all="ignore"):  # what cannot close is NaN
        own = place.kind.drawing(angle + place.phase, place.geometry)
    axes = frame(machine, place)
    guides = [
        Guide(guide.pin, np.arctan2(*in_machine_axes(np.cos(guide.direction), np.sin(guide.direction), axes)[::-1]))
        for guide in own.guides
    ]
    pins = {
        name: tuple(np.broadcast_to(part, np.shape(angle)) for part in in_machine_axes(x, y, axes))
        for name, (x, y) in own.pins.items()
    }
    return replace(own, pins=pins, guides=guides)


def joints(machine: Machine, place: Place, angle: Array) -> Joints:
    """Give a place's pins in machine axes with their derivatives by the crank angle.

    Parameters
    ----------
    machine : Machine
    place : Place
    angle : Array, shape (n,)
        φ of the machine. [rad]

    Returns
    -------
    mapping of name to Point, shape (n,). [m, m/rad, m/rad²]

    Raises
    ------
    InputError
        If the kind of mechanism has no plans.
    """
    if place.kind.name not in _JOINTS:
        allowed = _("has no plans of velocities; these have: {kinds}").format(kinds=", ".join(_JOINTS))
        raise InputError([Problem(f"{place.path}.kind", place.kind.name, allowed)])
    axes = frame(machine, place)
    with np.errstate(all="ignore"):
        own = _JOINTS[place.kind.name](angle + place.phase, place.geometry)
    return {name: _in_machine_axes(moving, axes, np.zeros(np.shape(angle))) for name, moving in own.items()}


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


def _origin(angle: Array) -> Point:
    return fixed(0.0 * angle, 0.0 * angle)


def _on_guide(slider: Coefficient, offset: Array) -> Point:
    """Pin that slides along x at a height."""
    still = 0.0 * slider.value
    return Point(slider, Coefficient(offset + still, still, still))


def _slider_crank_joints(angle: Array, geometry: SliderCrank) -> Joints:
    motion = slider_crank(angle, geometry)
    return {"O": _origin(angle), "A": motion.pin, "B": _on_guide(motion.slider, geometry.offset)}


def _articulated_rod_joints(angle: Array, geometry: ArticulatedRod) -> Joints:
    motion = articulated_rod(angle, geometry)
    master = slider_crank(angle, geometry.master)
    return {
        "O": _origin(angle),
        "A": turned(motion.pin, geometry.bank_angle),
        "B": turned(_on_guide(master.slider, geometry.master.offset), geometry.bank_angle),
        "C": motion.knuckle,
        "D": _on_guide(motion.slider, geometry.offset),
    }


def _crank_rocker_joints(angle: Array, geometry: CrankRocker) -> Joints:
    motion = crank_rocker(angle, geometry)
    pivot = fixed(geometry.ground_length + 0.0 * angle, 0.0 * angle)
    return {"O": _origin(angle), "A": motion.pin, "B": motion.joint, "C": pivot}


_JOINTS: Mapping[str, Callable[[Array, Any], Joints]] = {
    "slider_crank": _slider_crank_joints,
    "articulated_rod": _articulated_rod_joints,
    "crank_rocker": _crank_rocker_joints,
}
"""Pins with derivatives by kind; the same pins, in the same axes, as the kind's drawing."""
