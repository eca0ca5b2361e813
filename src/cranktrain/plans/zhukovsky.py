"""Zhukovsky's lever: forces at the points of the turned plan of velocities balance about its pole.

The plan is turned by 90° clockwise, so that a force's moment about the pole, anticlockwise, is its power.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from cranktrain.analysis import SpeedWanted
from cranktrain.linkage.forces import NO_FRICTION, Body, Conditions, Gravity, Wrench, added, torque_by_work
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.numerics.nested import remade
from cranktrain.plans.acting import (
    Force,
    Member,
    known_forces,
    link_numbers,
    loads_of,
    made_ready,
    member_of,
    pair_symbol,
)
from cranktrain.plans.acting import turned_to_machine as turned
from cranktrain.plans.placement import place_called
from cranktrain.plans.positions import closed_angles
from cranktrain.plans.rubbing import Rubbing, friction_on_links


class LeverForce(NamedTuple):
    """A force on the lever: symbol, where it acts, its X and Y [N], its point's velocity [m/s], its moment [N·m].

    The moment is the one about the pole in parts of the crank's speed: what the force does to the crank. A couple has
    neither force nor point, NaN.
    """

    symbol: str
    point: str
    value: tuple[float, float]
    velocity: tuple[float, float]
    moment: float


@dataclass(frozen=True)
class Lever:
    """Zhukovsky's lever of a mechanism at one crank angle.

    Attributes
    ----------
    mechanism : str
    angle : float
        Crank angle as the machine shows it. [deg]
    speed : float
        Of the crank. [rad/s]
    forces : tuple of LeverForce
        Loads, weights, forces and couples of inertia, and friction of the mechanism's own links.
    driving_torque : float
        What must be applied to the crank for them, by the joints' reactions. [N·m]
    """

    mechanism: str
    angle: float
    speed: float
    forces: tuple[LeverForce, ...]
    driving_torque: float

    @property
    def residual(self) -> float:
        """Sum of all moments with the driving torque, in parts of the largest."""
        moments = [self.driving_torque, *(force.moment for force in self.forces)]
        return abs(sum(moments)) / (max(map(abs, moments)) or 1.0)


def zhukovsky_lever(
    machine: Machine, angle: float, *, mechanism: str | None = None, speed: SpeedWanted = "constant"
) -> Lever:
    """Balance a mechanism's forces on the turned plan of velocities.

    Parameters
    ----------
    machine : Machine
        With masses or gas, and a speed.
    angle : float
        Crank angle as the machine shows it. [deg]
    mechanism : str, optional
        Its name; the first slave of throw 1, or the first mechanism, unless given. What others do to its links, as
        slaves to their master's rod, is on their own levers.
    speed : SpeedWanted
        As `cranktrain.run` takes it.

    Returns
    -------
    Lever

    Notes
    -----
    M ω + Σ F·v + Σ M_i ω_i = 0, docs/theory/forces, eqs. (13.6) and (13.7). The driving torque comes from the joints'
    reactions, of which the lever knows friction alone: what a master's guide bears of its slaves rubs on the master's.
    """
    place = place_called(machine, mechanism)
    shown = closed_angles(machine, [place], [angle])
    loaded = made_ready(machine, speed)
    one = member_of(machine, loaded, place, np.deg2rad(shown) + machine.zero)
    numbers = link_numbers(place)
    forces = [
        force
        for i, name in enumerate(one.dynamics.moving)
        for force in _of_link(machine, one, i, numbers[name])
        if force.moment != 0.0 or (force.point and np.any(force.value))
    ]
    rubbing = list(friction_on_links(one))
    forces += (_of_friction(machine, one, each, numbers) for each in rubbing)
    torque = _driving_torque(one, rubbing)
    return Lever(place.name, float(shown[0]), _speed(one), tuple(forces), torque)


def _of_link(machine: Machine, one: Member, i: int, number: int) -> Iterator[LeverForce]:
    """Load at a link's pin, weight and inertia at its centroid, couples of both."""
    load, weight, inertia = known_forces(machine, one, i, number)
    pin = _velocity(machine, one, i, is_centroid=False)
    centroid = _velocity(machine, one, i, is_centroid=True)
    yield _at(load, _pin_name(one, i), pin, one)
    yield _at(weight, f"s_{number}", centroid, one)
    yield _at(inertia, f"s_{number}", centroid, one)
    nowhere = (np.nan, np.nan)
    torque = float(loads_of(one)[i].moment[0, 0])
    turning = _work(one, i, Wrench(*map(np.asarray, ((0.0,), (0.0,), (1.0,)))))
    yield LeverForce("M", "", nowhere, nowhere, torque * turning)
    yield LeverForce(f"M_Φ{number}", "", nowhere, nowhere, -_couple(one, i))


def _at(force: Force, point: str, velocity: Array, one: Member) -> LeverForce:
    """Put a force to its point."""
    value = force.value[:, 0]
    speed = _speed(one)
    moment = float(value @ velocity) / speed
    return LeverForce(force.symbol, point, _pair(value), _pair(velocity), moment)


def _of_friction(machine: Machine, one: Member, rubbing: Rubbing, numbers: dict[str, int]) -> LeverForce:
    """Friction at its point, `f_14` of 1 on 4."""
    speed = _speed(one)
    wrench = rubbing.wrench
    value = turned(machine, one.place, wrench.x[0], wrench.y[0])[:, 0]
    x, y = (speed * np.array([part]) for part in rubbing.velocity)
    velocity = turned(machine, one.place, x, y)[:, 0]
    symbol = pair_symbol("f", numbers[rubbing.by], numbers[rubbing.on])
    return LeverForce(symbol, rubbing.pin, _pair(value), _pair(velocity), float(value @ velocity) / speed)


def _speed(one: Member) -> float:
    """Speed of the crank. [rad/s]"""
    return float(one.drive.speed[0, 0])


def _pair(vector: Array) -> tuple[float, float]:
    return float(vector[0]), float(vector[1])


def _pin_name(one: Member, i: int) -> str:
    """Name of the pin about which a link's load counts: the output slider's."""
    name = one.dynamics.moving[i]
    guides = one.place.kind.drawing(np.zeros(1), one.place.geometry).guides
    return guides[0].pin if guides and name == "slider" else name


def _velocity(machine: Machine, one: Member, i: int, *, is_centroid: bool) -> Array:
    """Velocity of a link's first pin or centroid, by the work of unit forces there. [m/s]"""
    speed = _speed(one)
    units = ((1.0, 0.0), (0.0, 1.0))
    if is_centroid:
        parts = [_work_of_weight(one, i, Gravity(*map(np.asarray, ((x,), (y,))))) for x, y in units]
    else:
        parts = [_work(one, i, Wrench(*map(np.asarray, ((x,), (y,), (0.0,))))) for x, y in units]
    x, y = (speed * np.array([part]) for part in parts)
    return turned(machine, one.place, x, y)[:, 0]


def _nothing(one: Member) -> Any:
    """Loads of nothing on all links."""
    return one.dynamics.load(one.motion, one.size, np.zeros((1, 1)))


def _loads(one: Member, wrenches: Sequence[Wrench]) -> Any:
    """Loads of all links as the kind's kernels take them."""
    return remade(_nothing(one), wrenches)


def _bodies(one: Member, i: int, body: Body) -> Any:
    """Bodies of all links, of which only one has mass."""
    nothing = Body(*(np.zeros((1, 1)) for _part in Body._fields))
    return one.dynamics.bodies(*(body if j == i else nothing for j in range(len(one.bodies))))


_NO_BODY = Body(*(np.zeros((1, 1)) for _part in Body._fields))
_NO_GRAVITY = Gravity(np.zeros((1, 1)), np.zeros((1, 1)))


def _work(one: Member, i: int, wrench: Wrench) -> float:
    """Work by the crank angle of a wrench on one link, about its first pin."""
    loads = list(_nothing(one))
    loads[i] = wrench
    acting = _loads(one, loads)
    return float(
        np.ravel(one.dynamics.reduced(one.motion, one.size, _bodies(one, i, _NO_BODY), acting, _NO_GRAVITY).load)[0]
    )


def _work_of_weight(one: Member, i: int, gravity: Gravity) -> float:
    """Work by the crank angle of 1 N at a link's centroid."""
    body = one.bodies[i]._replace(mass=np.ones((1, 1)))
    return float(
        np.ravel(one.dynamics.reduced(one.motion, one.size, _bodies(one, i, body), _nothing(one), gravity).load)[0]
    )


def _couple(one: Member, i: int) -> float:
    """Torque on the crank that a link's inertia about its own centroid takes: ½J′ω² + Jε of a link without mass."""
    body = one.bodies[i]._replace(mass=np.zeros((1, 1)))
    equation = one.dynamics.reduced(one.motion, one.size, _bodies(one, i, body), _nothing(one), _NO_GRAVITY)
    return float(np.ravel(torque_by_work(equation, one.drive))[0])


def _driving_torque(one: Member, rubbing: Sequence[Rubbing]) -> float:
    """Torque to be applied to the crank for the mechanism alone, by its joints' reactions; friction is a load."""
    conditions = Conditions(one.drive, one.gravity, tuple(NO_FRICTION for _slider in one.dynamics.sliding))
    acting = dict(zip(one.dynamics.moving, loads_of(one), strict=True))
    for each in rubbing:
        acting[each.on] = added(acting[each.on], each.wrench)
    loads = _loads(one, list(acting.values()))
    forces = one.dynamics.forces(one.motion, one.size, one.dynamics.bodies(*one.bodies), loads, conditions)
    return float(np.ravel(forces.driving_torque)[0])
