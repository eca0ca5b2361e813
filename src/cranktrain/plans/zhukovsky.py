"""Zhukovsky's lever: forces at the points of the turned plan of velocities balance about its pole.

The plan is turned by 90° clockwise, so that a force's moment about the pole, anticlockwise, is its power.
"""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.analysis import SpeedWanted
from cranktrain.linkage.forces import NO_FRICTION, WEIGHTLESS, added, applied, momentum
from cranktrain.machine import Machine
from cranktrain.motion import ONE, ZERO, Array
from cranktrain.plans.acting import (
    LoadedMechanism,
    forces_of_file,
    link_numbers,
    made_ready,
    member_of,
    own_wrenches,
    pair_symbol,
    torques_of_file,
)
from cranktrain.plans.placement import place_called
from cranktrain.plans.positions import closed_angles
from cranktrain.plans.rubbing import Rubbing, friction_on_links
from cranktrain.plans.vectors import pair
from cranktrain.record import record


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


@record
class ZhukovskyLever:
    """Zhukovsky's lever of a mechanism at one crank angle.

    Attributes
    ----------
    mechanism : str
    angle : float
        Crank angle as the machine shows it. [deg]
    speed : float
        Of the crank. [rad/s]
    forces : tuple of LeverForce
        Gas, loads, weights, forces and couples of inertia, and friction of the mechanism's own links.
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
) -> ZhukovskyLever:
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
    ZhukovskyLever

    Notes
    -----
    M ω + Σ F·v + Σ M_i ω_i = 0, docs/theory/forces, eqs. (13.6) and (13.7). The driving torque comes from the joints'
    reactions, of which the lever knows friction alone: what a master's guide bears of its slaves rubs on the master's.
    """
    place = place_called(machine, mechanism)
    shown = closed_angles(machine, [place], [angle])
    one = member_of(machine, made_ready(machine, speed), place, np.deg2rad(shown) + machine.zero)
    numbers = link_numbers(place)
    forces = [
        force
        for i, name in enumerate(one.dynamics.moving)
        for force in _of_link(one, i, numbers[name])
        if force.moment != 0.0 or (force.point and np.any(force.value))
    ]
    rubbing = list(friction_on_links(one))
    forces += (_of_friction(one, each, numbers) for each in rubbing)
    return ZhukovskyLever(place.name, float(shown[0]), _speed(one), tuple(forces), _driving_torque(one, rubbing))


def _of_link(one: LoadedMechanism, i: int, number: int) -> Iterator[LeverForce]:
    """Gas at a link's pin, loads of the file where they act, weight and inertia at its centroid; their couples."""
    link, body, name = one.links[i], one.bodies[i], one.dynamics.moving[i]
    pressed, pin = one.solved.pressed[i], link.origin
    pin_name, pin_velocity = _pin_name(one, i), (pin.x.first, pin.y.first)
    yield _at(one, f"P_{number}", pair(one.in_machine_axes(pressed.x, pressed.y)), pin_name, pin_velocity)
    for force, load in forces_of_file(one, name, number):
        is_at_pin = np.all(load.velocity[:, 0] == one.in_machine_axes(*pin_velocity))
        point = pin_name if is_at_pin else force.symbol.lower()
        yield _moving(one, force.symbol, force.value, point, _speed(one) * load.velocity[:, 0])
    centroid = momentum(link, body._replace(mass=ONE))
    for letter, _cause, wrench in own_wrenches(one, i):
        value = pair(one.in_machine_axes(wrench.x, wrench.y))
        yield _at(one, f"{letter}_{number}", value, f"s_{number}", (centroid.x, centroid.y))
    turning = applied(link, body._replace(mass=ZERO), one.solved.conditions.drive, WEIGHTLESS)
    for symbol, couple in (("M", pressed), (f"M_Φ{number}", turning)):
        yield _couple(symbol, float(np.squeeze(couple.moment * link.angle.first)))
    for symbol, load in torques_of_file(one, name, number):
        yield _couple(symbol, float(load.on_crank[0]))


def _couple(symbol: str, moment: float) -> LeverForce:
    """A couple, by what it does to the crank. [N·m]"""
    return LeverForce(symbol, "", (np.nan, np.nan), (np.nan, np.nan), moment)


def _at(
    one: LoadedMechanism, symbol: str, value: tuple[float, float], point: str, velocity: tuple[Array, Array] | Array
) -> LeverForce:
    """Put a force to its point, of which the velocity is by the crank angle, in the mechanism's axes. [m/rad]"""
    x, y = velocity
    return _moving(one, symbol, value, point, one.in_machine_axes(_speed(one) * x, _speed(one) * y))


def _moving(one: LoadedMechanism, symbol: str, value: tuple[float, float], point: str, velocity: Array) -> LeverForce:
    """Put a force to its point, of which the velocity is in the machine's axes. [m/s]"""
    return LeverForce(symbol, point, value, pair(velocity), float(np.dot(value, velocity)) / _speed(one))


def _of_friction(one: LoadedMechanism, rubbing: Rubbing, numbers: Mapping[str, int]) -> LeverForce:
    """Friction at its point, `f_14` of 1 on 4."""
    symbol = pair_symbol("f", numbers[rubbing.by], numbers[rubbing.on])
    value = pair(one.in_machine_axes(rubbing.wrench.x, rubbing.wrench.y))
    return _at(one, symbol, value, rubbing.pin, rubbing.velocity)


def _speed(one: LoadedMechanism) -> float:
    """Speed of the crank. [rad/s]"""
    return float(one.solved.conditions.drive.speed[0])


def _pin_name(one: LoadedMechanism, i: int) -> str:
    """Name of the pin about which a link's load counts: the output slider's."""
    name = one.dynamics.moving[i]
    guides = one.place.kind.drawing(np.zeros(1), one.place.geometry).guides
    return guides[0].pin if guides and name == "slider" else name


def _driving_torque(one: LoadedMechanism, rubbing: Sequence[Rubbing]) -> float:
    """Torque to be applied to the crank for the mechanism alone, by its joints' reactions; friction is a load."""
    solved = one.solved
    conditions = solved.conditions._replace(friction=tuple(NO_FRICTION for _slider in one.dynamics.sliding))
    acting = one.dynamics.by_link(solved.loads)
    for each in rubbing:
        acting[each.on] = added(acting[each.on], each.wrench)
    loads = tuple(acting.values())
    forces = one.dynamics.forces(solved.motion, one.size, one.bodies, loads, conditions)
    return float(np.ravel(forces.driving_torque)[0])
