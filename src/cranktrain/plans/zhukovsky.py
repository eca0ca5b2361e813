"""Zhukovsky's lever: forces at the points of the turned plan of velocities balance about its pole.

The plan is turned by 90° clockwise, so that a force's moment about the pole, anticlockwise, is its power.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from cranktrain.analysis import SpeedWanted
from cranktrain.linkage.forces import NO_FRICTION, WEIGHTLESS, Conditions, Gravity, Wrench, added, torque_by_work
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.plans.acting import (
    NO_BODY,
    Member,
    body_alone,
    known_forces,
    link_numbers,
    loads_of,
    made_ready,
    member_of,
    pair_symbol,
    unloaded,
)
from cranktrain.plans.acting import turned_to_machine as turned
from cranktrain.plans.placement import place_called
from cranktrain.plans.positions import closed_angles
from cranktrain.plans.rubbing import Rubbing, friction_on_links, rubbing_force


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
    pin = _velocity(machine, one, i, _work_at_pin)
    centroid = _velocity(machine, one, i, _work_at_centroid)
    yield _at(load.symbol, load.value, _pin_name(one, i), pin, one)
    yield _at(weight.symbol, weight.value, f"s_{number}", centroid, one)
    yield _at(inertia.symbol, inertia.value, f"s_{number}", centroid, one)
    nowhere = (np.nan, np.nan)
    torque = float(loads_of(one)[i].moment[0, 0])
    yield LeverForce("M", "", nowhere, nowhere, torque * _work_at_pin(one, i, 0.0, 0.0, moment=1.0))
    yield LeverForce(f"M_Φ{number}", "", nowhere, nowhere, -_couple(one, i))


def _at(symbol: str, value: Array, point: str, velocity: Array, one: Member) -> LeverForce:
    """Put a force, shape (2, 1), to its point."""
    force = value[:, 0]
    return LeverForce(symbol, point, _pair(force), _pair(velocity), float(force @ velocity) / _speed(one))


def _of_friction(machine: Machine, one: Member, rubbing: Rubbing, numbers: dict[str, int]) -> LeverForce:
    """Friction at its point, `f_14` of 1 on 4."""
    x, y = (_speed(one) * np.array([part]) for part in rubbing.velocity)
    velocity = turned(machine, one.place, x, y)[:, 0]
    symbol = pair_symbol("f", numbers[rubbing.by], numbers[rubbing.on])
    return _at(symbol, rubbing_force(machine, one, rubbing), rubbing.pin, velocity, one)


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


def _velocity(machine: Machine, one: Member, i: int, work: Callable[[Member, int, float, float], float]) -> Array:
    """Velocity of a point of a link, by the work of unit forces along x and y there. [m/s]"""
    x, y = (_speed(one) * np.array([work(one, i, *unit)]) for unit in ((1.0, 0.0), (0.0, 1.0)))
    return turned(machine, one.place, x, y)[:, 0]


def _work_at_pin(one: Member, i: int, x: float, y: float, moment: float = 0.0) -> float:
    """Work by the crank angle of a force at one link's first pin, and of a moment on it."""
    loads = list(unloaded(one))
    loads[i] = Wrench(*(np.array([part]) for part in (x, y, moment)))
    bodies = body_alone(one, i, NO_BODY)
    return float(np.ravel(one.dynamics.reduced(one.motion, one.size, bodies, tuple(loads), WEIGHTLESS).load)[0])


def _work_at_centroid(one: Member, i: int, x: float, y: float) -> float:
    """Work by the crank angle of a force at one link's centroid: the weight of 1 kg in a field of that strength."""
    bodies = body_alone(one, i, one.bodies[i]._replace(mass=np.ones((1, 1))))
    gravity = Gravity(np.array([x]), np.array([y]))
    return float(np.ravel(one.dynamics.reduced(one.motion, one.size, bodies, unloaded(one), gravity).load)[0])


def _couple(one: Member, i: int) -> float:
    """Torque on the crank that a link's inertia about its own centroid takes: ½J′ω² + Jε of a link without mass."""
    bodies = body_alone(one, i, one.bodies[i]._replace(mass=np.zeros((1, 1))))
    equation = one.dynamics.reduced(one.motion, one.size, bodies, unloaded(one), WEIGHTLESS)
    return float(np.ravel(torque_by_work(equation, one.drive))[0])


def _driving_torque(one: Member, rubbing: Sequence[Rubbing]) -> float:
    """Torque to be applied to the crank for the mechanism alone, by its joints' reactions; friction is a load."""
    conditions = Conditions(one.drive, one.gravity, tuple(NO_FRICTION for _slider in one.dynamics.sliding))
    acting = one.dynamics.by_link(loads_of(one))
    for each in rubbing:
        acting[each.on] = added(acting[each.on], each.wrench)
    loads = tuple(acting.values())
    forces = one.dynamics.forces(one.motion, one.size, one.bodies, loads, conditions)
    return float(np.ravel(forces.driving_torque)[0])
