"""A machine's drawing at crank angles, found from its mechanisms: each is evaluated once, for all angles and a turn."""

from collections.abc import Callable, Iterator, Sequence
from itertools import takewhile

import numpy as np
from numpy.typing import ArrayLike

from cranktrain.analysis import Result, SpeedWanted
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.language import _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.machine import Machine, machine_problems
from cranktrain.mechanisms.drawing import Drawing
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import turn_grid
from cranktrain.numerics.extremes import turning_points
from cranktrain.panels.drawing import (
    GuideDrawing,
    LinkDrawing,
    LoadDrawing,
    MachineDrawing,
    MechanismDrawing,
    OutputDrawing,
    ShaftDrawing,
)
from cranktrain.panels.throw_member import CylinderSizes, DrawnMechanism, cylinder_sizes, standing
from cranktrain.plans.found_again import found_again
from cranktrain.plans.placement import PlacedShafts, frame, place_called, placed, shaft_places, throw_of
from cranktrain.plans.shown_loads import ShownLoads, shown_loads
from cranktrain.plans.stroke_lines import unit
from cranktrain.plans.vectors import angle_of
from cranktrain.saying.scales import scale_for

_PATH = np.linspace(0.0, 360.0, 121)
"""Shown crank angles at which paths have their points. [deg]"""


def machine_drawing(
    machine: Machine,
    at: ArrayLike,
    *,
    mechanism: str | None = None,
    speed: SpeedWanted = "constant",
    result: Result | None = None,
) -> MachineDrawing:
    """Give a machine's drawing.

    Parameters
    ----------
    machine : Machine
    at : float or array-like of shape (n,)
        Crank angles as the machine shows them. [deg]
    mechanism : str, optional
        Whose throw alone is drawn, by the mechanism's name or its cylinder's, with all that shares cylinders with it.
    speed : SpeedWanted
        By which some loads go; as `cranktrain.run` takes it.
    result : Result, optional
        Of the machine at this speed, where there is one: what it has is not found again.

    Returns
    -------
    MachineDrawing

    Raises
    ------
    InputError
        If the machine cannot be arranged, for angles that are none, and for a mechanism that there is not, or on a
        shaft whose place is not known.

    Examples
    --------
    >>> pump = Machine(mechanism={"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "130 mm"})
    >>> drawn = machine_drawing(pump, [0.0, 180.0])
    >>> drawn.mechanisms[0].pins["B"].round(9).tolist()
    [[0.0, 0.0], [0.18, 0.08]]
    """
    refuse(machine_problems(machine, partial=True))
    angles = _crank_angles(at)
    shafts = shaft_places(machine)
    asked = machine.places if mechanism is None else throw_of(machine, _standing_place(machine, mechanism, shafts))
    places = [place for place in asked if place.shaft in shafts.centres]
    sizes, travel = cylinder_sizes(machine, places), _travels(machine)
    phi = np.deg2rad(np.concatenate([_PATH, angles])) + machine.zero
    drawn: list[MechanismDrawing] = []
    reached: list[Array] = []
    for place in places:
        centre = shafts.centres[place.shaft]
        moving = standing(placed(machine, place, phi), centre)
        member = sizes.member(place, moving, centre, is_first=not drawn)
        drawn.append(_drawn(member, sizes, travel))
        reached += [pin[:, : _PATH.size] for pin in member.turn_pins.values()]
    length = scale_for("m", 0.0)
    loads = shown_loads(machine, places, speed, np.zeros(2), result) if places else None
    return MachineDrawing(
        name=machine.name,
        crank_angle=angles,
        shafts=tuple(_shafts(machine, places, shafts)),
        mechanisms=tuple(drawn),
        left_out=tuple(place.name for place in asked if place.shaft not in shafts.centres),
        loads=() if loads is None else tuple(_loads(loads, angles)),
        bounds=_bounds(reached),
        unit=length.label,
        one=float(length.one),
    )


def _crank_angles(at: ArrayLike) -> Array:
    """Take crank angles, one or more, as an array; refuse what is none. [deg]"""
    try:
        angles = np.array(at, dtype=np.float64, ndmin=1)
    except (TypeError, ValueError):
        angles = np.empty(0)
    if angles.ndim != 1 or not angles.size or not np.all(np.isfinite(angles)):
        allowed = _("must be a crank angle in degrees, or a list of them")
        raise InputError([Problem("at", str(at), allowed, _("such as: {example}", example="[0, 90]"))])
    return angles


def _standing_place(machine: Machine, name: str, shafts: PlacedShafts) -> PlacedMechanism:
    """Find a place by name; refuse one on a shaft that stands nowhere."""
    place = place_called(machine, name)
    if place.shaft not in shafts.centres:
        allowed = _("is on a shaft whose place is not known; give it")
        raise InputError([Problem("mechanism", name, allowed, f'[shaft.{place.shaft}] place = ["0 mm", "900 mm"]')])
    return place


_Travel = Callable[[PlacedMechanism], Array]


def _travels(machine: Machine) -> _Travel:
    """Give what finds nearest and farthest place of a slider along its line; once of those that are made alike. [m]"""
    found: dict[tuple[int, int], Array] = {}

    def travel(place: PlacedMechanism) -> Array:
        alike = id(place.kind), id(place.geometry)
        if alike not in found:
            found[alike] = found_again(machine, _travel, place)
        return found[alike]

    return travel


def _travel(place: PlacedMechanism) -> Array:
    """Nearest and farthest place of a slider along its line; where links close only in part, of half degrees. [m]"""

    def along(angle: Array) -> Coefficient:
        """Place of the pin along its guide, whose foot is nearest the shaft."""
        drawing: Drawing = place.kind.drawing(np.ravel(angle), place.geometry)
        guide = drawing.guides[0]
        x, y = drawing.pins[guide.pin]
        cos, sin = unit(guide.direction).reshape(2)
        still = np.zeros(np.size(angle))
        return Coefficient(*((still + cos * a + sin * b).reshape(np.shape(angle)) for a, b in zip(x, y, strict=True)))

    with np.errstate(all="ignore"):
        samples = along(turn_grid()).value
        if not np.any(np.isfinite(samples)):
            return np.full(2, np.nan)
        ends = np.array([np.nanmin(samples), np.nanmax(samples)])
        exact = np.concatenate([one.value for one in turning_points(along, samples)])
    return np.where(np.isfinite(exact), exact, ends)


def _drawn(member: DrawnMechanism, sizes: CylinderSizes, travel: _Travel) -> MechanismDrawing:
    """One mechanism, whose pins are those of a turn and, behind these, at the angles that are asked for."""
    place, drawing = member.place, member.turn
    turn = {name: pin[:, : _PATH.size] for name, pin in member.turn_pins.items()}
    pins = {name: pin[:, _PATH.size :] for name, pin in member.turn_pins.items()}
    shaft = drawing.links[0].pins[0]
    n_cranks = sum(1 for _crank in takewhile(lambda link: link.pins[0] == shaft, drawing.links))
    lines = [member.line_of(guide) for guide in drawing.guides]
    return MechanismDrawing(
        name=place.name,
        kind=place.kind.name,
        cylinder=place.cylinder,
        bank=place.bank,
        shaft=place.shaft,
        throw=place.throw + 1,
        is_slave=place.kind.is_slave,
        is_outlined=place.kind.is_outlined,
        crank_zero=angle_of(turn[member.crank_pin][:, 0] - member.centre),
        pins=pins,
        links=tuple(LinkDrawing(one.name, one.pins, i < n_cranks) for i, one in enumerate(drawing.links)),
        guides=tuple(
            GuideDrawing(guide.pin, angle_of(line.along), line.foot)
            for guide, line in zip(drawing.guides, lines, strict=True)
        ),
        blocks=tuple(drawing.blocks),
        fixed=tuple(drawing.fixed),
        ends=tuple(drawing.ends),
        points=tuple(drawing.points),
        paths={name: turn[name] for name in drawing.paths},
        output=None if member.output is None else _output(member, sizes, travel(place)),
    )


def _output(member: DrawnMechanism, sizes: CylinderSizes, travel: Array) -> OutputDrawing:
    """The slider of a mechanism."""
    place, line = member.place, member.stroke_line
    return OutputDrawing(
        pin=member.turn.guides[0].pin,
        foot=line.foot,
        along=line.along,
        travel=travel,
        bore=member.bore,
        is_valve=not place.kind.output.is_loaded,
        is_far=place.is_far,
        port=sizes.ports.get(place.cylinder, {}).get(place.name.rpartition(".")[2]),
        crosshead=member.crosshead_along(travel),
        ram=member.ram_along(travel),
    )


def _shafts(machine: Machine, places: Sequence[PlacedMechanism], shafts: PlacedShafts) -> Iterator[ShaftDrawing]:
    """Those that carry some mechanisms, in the order of the file."""
    first = {place.shaft: place for place in reversed(places)}
    for name in machine.shafts:
        if name in first:
            # What turns from x to y in a mechanism's axes turns clockwise where its crank does.
            sense = -float(frame(machine, first[name]).sense)
            yield ShaftDrawing(name, shafts.centres[name], name in shafts.assumed, sense)


def _loads(loads: ShownLoads, angles: Array) -> Iterator[LoadDrawing]:
    """Loads of the file on some mechanisms."""
    for one in (*loads.at(angles), *loads.on_shafts_at(angles)):
        largest = loads.largest[one.is_torque]
        scale = scale_for("N*m" if one.is_torque else "N", largest)
        yield LoadDrawing(
            name=one.name,
            mechanism=one.mechanism,
            link=one.link,
            is_torque=one.is_torque,
            is_rope=one.is_rope,
            size=one.size,
            largest=largest,
            unit=scale.label,
            one=float(scale.one),
            way=one.way,
            place=one.place,
            pin=one.pin,
        )


def _bounds(reached: Sequence[Array]) -> Array:
    """Lower left and upper right corner of where pins come; what is NaN comes nowhere."""
    points = np.concatenate([np.zeros((2, 0)), *reached], axis=1)
    known = points[:, np.all(np.isfinite(points), axis=0)]
    if not known.size:
        return np.full((2, 2), np.nan)
    return np.stack([np.min(known, axis=1), np.max(known, axis=1)])
