"""Instant centres of a mechanism's bodies, two by two, from the velocities of its pins."""

from collections.abc import Mapping, Sequence
from itertools import combinations
from typing import Literal, NamedTuple

import numpy as np

from cranktrain.machine import Machine
from cranktrain.mechanisms.drawing import Block, Drawing
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics.ties import largest_of
from cranktrain.plans.lettering import lettered
from cranktrain.plans.placement import place_called, placed
from cranktrain.plans.positions import closed_angles
from cranktrain.plans.vectors import angle_of, cross, in_plane, spoken_name, turned_left
from cranktrain.record import record

_Sort = Literal["frame", "link", "slider", "block"]

_PARALLEL = 1e-9
"""Bodies whose angular velocities differ by less than this part of the crank's move along each other."""


class TurningBody(NamedTuple):
    """A rigid body: what it is, its name, the pins on it, how fast it turns, and its point at the shaft centre moves.

    turning is its angular velocity by that of the crank, in the crank's sense [1]; drift is X and Y of the velocity by
    the crank's angular velocity, anticlockwise [m].
    """

    sort: _Sort
    name: str
    pins: tuple[str, ...]
    turning: float
    drift: Array


class Centre(NamedTuple):
    """The instant centre of two bodies: the numbers that they go by, from 1, and where it is.

    place is (X, Y) [m], NaN where it is infinitely far: then in `direction` from X, or the other way [rad]. Both are
    NaN where two bodies that no joint connects are at rest on each other. is_joint: a pin or a guide connects them.
    """

    first: int
    second: int
    place: Array
    direction: float
    is_joint: bool

    @property
    def name(self) -> str:
        """Such as `P_13`."""
        return f"P_{self.first}{self.second}" if self.second < 10 else f"P_{self.first},{self.second}"


@record
class InstantCentres:
    """All instant centres at one crank angle.

    Attributes
    ----------
    mechanism : str
    angle : float
        Crank angle as the machine shows it. [deg]
    bodies : tuple of TurningBody
        The frame is 1, the crank 2.
    centres : tuple of Centre
        n(n − 1)/2 of n bodies.
    drawing : Drawing
        Pins of shape (1,), in machine axes. [m]
    """

    mechanism: str
    angle: float
    bodies: tuple[TurningBody, ...]
    centres: tuple[Centre, ...]
    drawing: Drawing

    def centre(self, first: int, second: int) -> Centre:
        """Give the centre of two bodies by their numbers."""
        pair = sorted((first, second))
        return next(centre for centre in self.centres if [centre.first, centre.second] == pair)


def instant_centres(
    machine: Machine, angle: float, *, mechanism: str | None = None, is_lettered: bool = False
) -> InstantCentres:
    """Give the instant centres of every two bodies of a mechanism.

    Parameters
    ----------
    machine : Machine
    angle : float
        Crank angle as the machine shows it. [deg]
    mechanism : str, optional
        Its name, such as `1R`; unless given, the first slave of throw 1, or the first mechanism.
    is_lettered : bool
        Call pins with long names by letters.

    Returns
    -------
    InstantCentres

    Notes
    -----
    Where bodies i and j have one velocity: P = k × (v_i − v_j)/(ω_i − ω_j), v of the points at the shaft centre.
    With the frame as 1 and the crank as 2, ω_j/ω_2 = P_12 P_2j : P_1j P_2j. docs/theory/plans.

    Examples
    --------
    The piston stands 184.222 mm along, and the centre above it on the crank's line, tan 60° times as far across. With
    the crank across the line of stroke the rod only moves along: it has none.

    >>> pump = Machine(mechanism={"kind": "slider_crank", "stroke": "160 mm", "rod_length": "160 mm"})
    >>> found = instant_centres(pump, 60.0)
    >>> [body.name for body in found.bodies]
    ['', 'crank', 'rod', 'B']
    >>> [round(float(part), 6) for part in found.centre(1, 3).place]
    [0.319082, 0.184222]
    >>> instant_centres(pump, 90.0).centre(1, 3).place
    array([nan, nan])
    """
    place = place_called(machine, mechanism)
    closed_angles(machine, [place], [angle])
    drawing = placed(machine, place, np.array([np.deg2rad(angle) + machine.zero]))
    if is_lettered:
        drawing = lettered(drawing)
    pins = {name: in_plane(pin) for name, pin in drawing.pins.items()}
    with np.errstate(all="ignore"):  # where links only just close velocities have no bound, and centres are nowhere
        bodies, across = _bodies(drawing, pins)
        centres = tuple(_centre(bodies, pair, pins, across) for pair in combinations(range(len(bodies)), 2))
    return InstantCentres(place.name, angle, bodies, centres, drawing)


_Pins = Mapping[str, Coefficient]


def _turning(pins: _Pins, link: Sequence[str]) -> float:
    """Turn of a link for each radian of the crank, anticlockwise, by its first pin and the one farthest from it."""
    first = pins[link[0]]
    last = largest_of((pins[name] for name in link[1:]), lambda pin: float(np.hypot(*(pin.value - first.value))))
    arm = last.value - first.value
    return cross(arm, last.first - first.first) / float(np.dot(arm, arm))


def _bodies(drawing: Drawing, pins: _Pins) -> tuple[tuple[TurningBody, ...], dict[tuple[int, int], float]]:
    """Frame, links, sliders and blocks; for those that only slide on each other, the direction across. [rad]"""
    sense = _turning(pins, drawing.links[0].pins)

    def body(sort: _Sort, name: str, its_pins: tuple[str, ...], turning: float) -> TurningBody:
        pin = pins[its_pins[0]]
        return TurningBody(sort, name, its_pins, turning, pin.first / sense - turning * turned_left(pin.value))

    found = [TurningBody("frame", "", tuple(drawing.fixed), 0.0, np.zeros(2))]
    found += [body("link", link.name, link.pins, _turning(pins, link.pins) / sense) for link in drawing.links]
    across: dict[tuple[int, int], float] = {}
    links = {tuple(pin for pin in link.pins if pin not in drawing.ends): i for i, link in enumerate(drawing.links, 1)}
    sliders: dict[tuple[str, ...], int] = {}
    for guide in drawing.guides:
        pin = (guide.pin,)
        if pin not in links:
            found.append(body("slider", spoken_name(guide.pin), pin, 0.0))
        sliders[pin] = links.get(pin, len(found) - 1)
        across[0, sliders[pin]] = float(np.squeeze(guide.direction)) + np.pi / 2
    for block in drawing.blocks:
        slotted = next((i for i, link in enumerate(drawing.links, 1) if {*block.link} <= {*link.pins}), 0)
        if len(block.link) == 1:
            slotted = sliders[block.link]
        if (block.pin,) not in links:
            found.append(body("block", spoken_name(block.pin), (block.pin,), found[slotted].turning))
        number = links.get((block.pin,), len(found) - 1)
        across[min(slotted, number), max(slotted, number)] = _slot_direction(block, pins) + np.pi / 2
    return tuple(found), across


def _slot_direction(block: Block, pins: _Pins) -> float:
    """Direction of a slot: of its link, or if that does not turn the one in which the pin slides. [rad]"""
    pin, base, end = (pins[name] for name in (block.pin, block.link[0], block.link[-1]))
    if len(block.link) > 1:
        return angle_of(end.value - base.value)
    slides = pin.first - base.first
    is_at_its_end = np.hypot(*slides) < _PARALLEL * np.hypot(*pin.first)
    return angle_of(pin.second - base.second if is_at_its_end else slides)


def _centre(
    bodies: Sequence[TurningBody], pair: tuple[int, int], pins: _Pins, across: Mapping[tuple[int, int], float]
) -> Centre:
    """Instant centre of two bodies: a pin of both, across where they slide, or where their velocities agree."""
    one, other = (bodies[number] for number in pair)
    common = [pin for pin in one.pins if pin in other.pins]
    drift = turned_left(one.drift - other.drift)
    turning = one.turning - other.turning
    place: Array = np.full(2, np.nan)
    direction = np.nan
    if common:
        place = pins[common[0]].value
    elif pair in across:
        direction = across[pair]
    elif abs(turning) > _PARALLEL:
        place = drift / turning
    elif np.hypot(*drift) >= _PARALLEL * np.hypot(*pins[bodies[1].pins[-1]].value):
        direction = angle_of(drift)
    return Centre(pair[0] + 1, pair[1] + 1, place, direction, is_joint=bool(common) or pair in across)
