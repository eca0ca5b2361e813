"""Loads of the machine file as they act on a mechanism: where, in which direction, how large, over crank angles.

All axes are the machine's, X right and Y up, seen from the free end.
"""

from collections import Counter
from collections.abc import Mapping, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np

from cranktrain.layout.frames import Frame, in_machine_axes
from cranktrain.layout.loads import LinkLoad
from cranktrain.layout.places import PlacedMechanism
from cranktrain.layout.shaft_loads import TorqueOnShaft, torques_on_shafts
from cranktrain.linkage.vectors import Vector, direction, swept
from cranktrain.machine import Machine
from cranktrain.motion import Array, Link
from cranktrain.numerics.designs import by_design
from cranktrain.plans.placement import frame, placed
from cranktrain.questions.forces.loaded_machine import LoadedMachine

_FORCE, _TORQUE = "Q", "M"
"""Letters of loads: P is the gas's."""


class ActingLoad(NamedTuple):
    """A load on a link of one mechanism, over crank angles.

    Attributes
    ----------
    name : str
        As the machine file calls it.
    mechanism, link : str
        On what it acts, by the mechanism's own name of its link; of a torque on a shaft none, and the shaft's.
    is_torque : bool
    is_rope : bool
        Whether its direction stays, off an arc about the link's first pin.
    size : Array, shape (n,)
        Along its way, less than 0 against that; of a torque anticlockwise. [N or N·m]
    way : Array, shape (2, n)
        Unit vector in which a force acts; 0 of a torque, and of a force that goes with a point which stands.
    place : Array, shape (2, n)
        Where it acts, from the shaft's centre; of a torque the link's first pin. [m]
    pin : Array, shape (2, n)
        The link's first pin. [m]
    velocity : Array, shape (2, n)
        Of the link's point there, by the crank angle. [m/rad]
    along : Array, shape (2, n)
        Unit vector along the link, from its first pin.
    turning : Array, shape (n,)
        Of the link by the crank angle, anticlockwise.
    sense : float
        +1 where the crank turns anticlockwise, −1 where it turns clockwise.
    """

    name: str
    mechanism: str
    link: str
    is_torque: bool
    is_rope: bool
    size: Array
    way: Array
    place: Array
    pin: Array
    velocity: Array
    along: Array
    turning: Array
    sense: float

    @property
    def counted(self) -> Array:
        """Size as forces and torques count: of a torque in the sense in which the crank turns. [N or N·m]"""
        return self.sense * self.size if self.is_torque else self.size

    def moved(self, away: Array, factor: float = 1.0) -> "ActingLoad":
        """Give it elsewhere, then in another unit of length."""
        return self._replace(place=factor * (self.place + away), pin=factor * (self.pin + away))

    @property
    def force(self) -> Array:
        """X and Y of a force, shape (2, n). [N]"""
        return self.size * self.way

    @property
    def on_crank(self) -> Array:
        """What it does to the crank, in the sense in which that turns, shape (n,). [N·m]"""
        return self.size * self.turning if self.is_torque else np.sum(self.force * self.velocity, axis=0)


def acting_loads(
    machine: Machine, loaded: LoadedMachine, place: PlacedMechanism, angle: Array
) -> tuple[ActingLoad, ...]:
    """Loads of the file on one mechanism.

    Parameters
    ----------
    machine : Machine
    loaded : LoadedMachine
        The same, made ready.
    place : PlacedMechanism
    angle : Array, shape (n,)
        φ. [rad]

    Returns
    -------
    tuple of ActingLoad
        In the order of the file.
    """
    if loaded.loads is None:
        return ()
    loads = loaded.loads.of(loaded.mechanisms.names.index(place.name))
    links = loaded.loaded_links(loads, angle[np.newaxis, np.newaxis])
    axes = frame(machine, place)
    return tuple(_acting(loaded, place, load, link, axes, angle) for load, link in zip(loads, links, strict=True))


def _acting(
    loaded: LoadedMachine, place: PlacedMechanism, load: LinkLoad, link: Link, axes: Frame, angle: Array
) -> ActingLoad:
    """One load on one link of a mechanism."""
    own = angle[np.newaxis, np.newaxis]

    def turned(x: Array, y: Array) -> Array:
        still = np.zeros(angle.shape)
        return np.stack(in_machine_axes(np.ravel(x) + still, np.ravel(y) + still, axes))

    way, arm = load.way(link), load.arm_of(link)
    size = np.ravel(loaded.load_value(load, way, own, loaded.speed.drive(own).speed)) + np.zeros(angle.shape)
    velocity, _second = swept(link.origin, arm, link.angle)
    point = Vector(link.origin.x.value + arm.x, link.origin.y.value + arm.y)
    # What turns from x to y in a mechanism's axes turns clockwise where its crank does.
    turn = -axes.sense
    return ActingLoad(
        load.name.removeprefix(f"{place.name}."),
        place.name,
        place.kind.dynamics.moving[load.link],
        load.is_torque,
        load.radius is not None and load.direction is not None,
        turn * size if load.is_torque else size,
        turned(way.unit.x, way.unit.y),
        turned(point.x, point.y),
        turned(link.origin.x.value, link.origin.y.value),
        turned(velocity.x, velocity.y),
        turned(*direction(link)),
        turn * (np.ravel(link.angle.first) + np.zeros(angle.shape)),
        turn,
    )


def loads_on_shafts(
    machine: Machine, loaded: LoadedMachine, places: Sequence[PlacedMechanism], angle: Array
) -> tuple[ActingLoad, ...]:
    """Torques of the file on the shafts of some mechanisms.

    Parameters
    ----------
    machine : Machine
    loaded : LoadedMachine
        The same, made ready.
    places : sequence of PlacedMechanism
    angle : Array, shape (n,)
        φ. [rad]

    Returns
    -------
    tuple of ActingLoad
        Of no mechanism, by the names of their shafts; about each shaft's centre, along the crank of the first of the
        mechanisms on it. The size of one that balances the machine is NaN: it resists.
    """
    found = torques_on_shafts(
        machine.loads, machine.shafts, partial(by_design, n_designs=1), is_astern=machine.orientation.is_astern
    )
    first = {place.shaft: place for place in reversed(places)}
    return tuple(_on_shaft(machine, loaded, load, first[load.shaft], angle) for load in found if load.shaft in first)


def _on_shaft(
    machine: Machine, loaded: LoadedMachine, load: TorqueOnShaft, place: PlacedMechanism, angle: Array
) -> ActingLoad:
    """One torque on the shaft of a mechanism."""
    own, turn = angle[np.newaxis, np.newaxis], -float(frame(machine, place).sense)
    size = np.full(angle.shape, np.nan)
    if not load.is_balanced:
        size = turn * (load.value(own - machine.zero, loaded.speed.drive(own).speed).reshape(-1) + 0.0 * angle)
    drawing, still = placed(machine, place, angle), np.zeros((2, angle.size))
    shaft, pin = (drawing.positions[name] for name in drawing.links[0].pins[:2])
    return ActingLoad(
        name=load.name,
        mechanism="",
        link=load.shaft,
        is_torque=True,
        is_rope=False,
        size=size,
        way=still,
        place=still,
        pin=still,
        velocity=still,
        along=(pin - shaft) / np.hypot(*(pin - shaft)),
        turning=np.full(angle.shape, turn),
        sense=turn,
    )


def load_symbols(loads: Sequence[ActingLoad], numbers: Mapping[str, int]) -> tuple[str, ...]:
    """Symbols of the loads on one mechanism by its links' numbers: Q_4 of a force, M_4 of a torque, then Q_4,2.

    Examples
    --------
    >>> from cranktrain.plans.acting import made_ready
    >>> ram = {"on": "piston", "force": "2 kN"}
    >>> press = Machine(
    ...     mechanism={"kind": "slider_crank", "stroke": "80 mm", "rod_length": "136 mm"},
    ...     shaft={"main": {"speed": "60 rpm"}},
    ...     load={"cut": ram, "spring": ram | {"sense": "active"}},
    ... )
    >>> found = acting_loads(press, made_ready(press, "constant"), press.places[0], np.array([1.0]))
    >>> load_symbols(found, {"slider": 4}), [one.size.tolist() for one in found]
    (('Q_4', 'Q_4,2'), [[2000.0], [2000.0]])
    """
    seen: Counter[str] = Counter()
    symbols: list[str] = []
    for load in loads:
        symbol = f"{_TORQUE if load.is_torque else _FORCE}_{numbers[load.link]}"
        seen[symbol] += 1
        symbols.append(symbol if seen[symbol] == 1 else f"{symbol},{seen[symbol]}")
    return tuple(symbols)
