"""Pressure where heat comes in by Wiebe's law: one zone, constant γ, with or without loss to the walls."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array, Coefficient
from cranktrain.numerics.subintervals import interpolation, leggauss, partial_integrals

_N_NODES = 12
_WIDEST = np.pi / 12
_GRADING = 0.15
"""Width of a panel over that of the next one, away from the start of burning: there t^m may have no derivatives."""
_N_GRADED, _N_BURNING = 12, 6


class Wiebe(NamedTuple):
    """Heat by Wiebe's law, and what the walls take; fields of shape (design, chamber, 1).

    Attributes
    ----------
    start_pressure : Array
        At the largest volume, where compression begins. [Pa]
    heat : Array
        Q that comes in over a cycle if all burns; 1 − e^(−a) of it does. [J]
    start, duration : Array
        Of burning; from the chamber's nominal firing. [rad]
    shape, completeness : Array
        m and a of x_b = 1 − exp(−a t^(m+1)). [1]
    heat_ratio : Array
        γ, of the specific heats. [1]
    transfer : Array
        h to the walls over the angular velocity; 0 without loss. [W·s/(m²·K)]
    start_temperature, wall_temperature : Array
        Of the gas at the largest volume; of the walls. [K]
    """

    start_pressure: Array
    heat: Array
    start: Array
    duration: Array
    shape: Array
    completeness: Array
    heat_ratio: Array
    transfer: Array
    start_temperature: Array
    wall_temperature: Array


class Room(NamedTuple):
    """A chamber over its working turn.

    Attributes
    ----------
    begins, ends : Array, shape (design, chamber, 1)
        Where its volume is largest, before its firing and after; from its nominal firing. [rad]
    volume : callable
        From such angles, shape (design, chamber, k), to the volume and its derivatives of that shape.
    wall : callable
        From volumes of shape (design, chamber, panel, node) to the area of the walls about them. [m³ → m²]
    """

    begins: Array
    ends: Array
    volume: Callable[[Array], Coefficient]
    wall: Callable[[Array], Array]


class BurningCurve(NamedTuple):
    """pV^γ over a chamber's working turn, by its values at Gauss's points of panels.

    Attributes
    ----------
    edges : Array, shape (design, chamber, panel + 1)
        Angles from nominal firing. [rad]
    values : Array, shape (design, chamber, panel, node)
        pV^γ.
    law : Wiebe
    mass : Array, shape (design, chamber, 1)
        mR of the gas. [J/K]
    work, loss : Array, shape (design, chamber)
        ∫ p dV over the turn; heat that the walls take. [J]
    """

    edges: Array
    values: Array
    law: Wiebe
    mass: Array
    work: Array
    loss: Array


def burnt(wiebe: Wiebe, angle: Array) -> Array:
    """Part x_b of the heat that has come in by some angles from nominal firing, shape (design, chamber, k)."""
    time = np.clip((angle - wiebe.start) / wiebe.duration, 0.0, 1.0)
    return -np.expm1(-wiebe.completeness * time ** (wiebe.shape + 1))


def burning_curve(wiebe: Wiebe, room: Room) -> BurningCurve:
    """Integrate the energy balance over the working turn.

    Parameters
    ----------
    wiebe : Wiebe
    room : Room

    Returns
    -------
    BurningCurve

    Notes
    -----
    (pV^γ)′ + K pV^γ = (γ − 1) V^(γ−1) (Q x_b′ + h A_w T_w/ω), K = (γ − 1) h A_w/(m R ω), mR = p₁V₁/T₁: linear, so that
    an integrating factor solves it, panel by panel. docs/theory/gas, eqs. (14.22) and (14.23).
    """
    edges = _edges(wiebe, room)
    node, weight = leggauss(_N_NODES)
    half = np.diff(edges)[..., np.newaxis] / 2
    angle = edges[..., :-1, np.newaxis] + half * (1 + node)
    shape = angle.shape
    volume = Coefficient(*(part.reshape(shape) for part in room.volume(angle.reshape(*shape[:2], -1))))
    at = Wiebe(*(np.asarray(part)[..., np.newaxis] for part in wiebe))
    power = volume.value ** (at.heat_ratio - 1)
    largest = room.volume(room.begins).value[..., np.newaxis]
    mass = at.start_pressure * largest / at.start_temperature
    given = at.transfer * room.wall(volume.value)
    source, decay = _growth(at, mass, angle, volume.value, given)
    to_nodes = partial_integrals(node, _N_NODES).T
    grown, grown_to_end = np.exp(half * (decay @ to_nodes)), np.exp(half[..., 0] * (decay @ weight))
    added, added_to_end = half * ((grown * source) @ to_nodes), half[..., 0] * ((grown * source) @ weight)
    starts = np.empty(shape[:-1])
    reached = (at.start_pressure * largest**at.heat_ratio)[..., 0, 0]
    for panel in range(shape[2]):
        starts[..., panel] = reached
        reached = (reached + added_to_end[..., panel]) / grown_to_end[..., panel]
    values = (starts[..., np.newaxis] + added) / grown
    pressure = values / (power * volume.value)
    lost = given * (pressure * volume.value / mass - at.wall_temperature)
    work, loss = (np.sum(half * part * weight, axis=(-2, -1)) for part in (pressure * volume.first, lost))
    return BurningCurve(edges, values, wiebe, mass[..., 0], work, loss)


def burning_pressure(curve: BurningCurve, angle: Array, volume: Array) -> Array:
    """Pressure at some angles of the working turn, where the volume is known, shape (design, chamber, k). [Pa]"""
    panel = np.sum(angle[..., np.newaxis] >= curve.edges[..., np.newaxis, 1:-1], axis=-1)
    start, end = (np.take_along_axis(part, panel, axis=-1) for part in (curve.edges[..., :-1], curve.edges[..., 1:]))
    own = np.take_along_axis(curve.values, panel[..., np.newaxis], axis=-2)
    way = 2 * (angle - start) / (end - start) - 1
    return np.sum(own * interpolation(way, _N_NODES), axis=-1) / volume**curve.law.heat_ratio


def burning_slope(curve: BurningCurve, angle: Array, volume: Coefficient, pressure: Array, wall: Array) -> Array:
    """Derivative of the pressure at some angles of the working turn, from the energy balance itself.

    Parameters
    ----------
    curve : BurningCurve
    angle, pressure, wall : Array, shape (design, chamber, k)
        From nominal firing [rad]; there [Pa]; area of the walls. [m²]
    volume : Coefficient, fields of that shape
        Its second derivative is not asked for.

    Returns
    -------
    Array, shape (design, chamber, k). [Pa/rad]

    Notes
    -----
    p′ = (pV^γ)′/V^γ − γpV′/V. docs/theory/gas, eqs. (14.22) and (14.24).
    """
    ratio = curve.law.heat_ratio
    power = volume.value**ratio
    source, decay = _growth(curve.law, curve.mass, angle, volume.value, curve.law.transfer * wall)
    return source / power - decay * pressure - ratio * pressure * volume.first / volume.value


def _growth(law: Wiebe, mass: Array, angle: Array, volume: Array, given: Array) -> tuple[Array, Array]:
    """What brings pV^γ up, and the part of it that goes, by the crank angle; `given` to the walls. [1/rad; W·s/K]"""
    surplus = law.heat_ratio - 1
    heat = law.heat * _burning_rate(law, angle) + given * law.wall_temperature
    return surplus * volume**surplus * heat, surplus * given / mass


def _burning_rate(wiebe: Wiebe, angle: Array) -> Array:
    """x_b′, and 0 before and after. [1/rad]"""
    time = (angle - wiebe.start) / wiebe.duration
    burns = (time > 0) & (time < 1)
    time = np.where(burns, time, 0.5)
    exponent, a = wiebe.shape + 1, wiebe.completeness
    rate = a * exponent / wiebe.duration * time**wiebe.shape * np.exp(-a * time**exponent)
    return np.where(burns, rate, 0.0)


def burning_edges(wiebe: Wiebe) -> Array:
    """Angles from where it begins to burn to where that ends, between which all is smooth, shape (…, k). [rad]"""
    graded: Array = _GRADING ** np.arange(_N_GRADED, 0.0, -1.0)
    share: Array = np.concatenate([np.zeros(1), graded[:-1], np.linspace(float(graded[-1]), 1.0, _N_BURNING + 1)])
    return wiebe.start + share * wiebe.duration


def _edges(wiebe: Wiebe, room: Room) -> Array:
    """Panels before, while and after it burns, the first ones of burning ever narrower."""
    end = wiebe.start + wiebe.duration
    n_parts = int(np.ceil(np.max(np.maximum(wiebe.start - room.begins, room.ends - end)) / _WIDEST))
    even = np.linspace(0.0, 1.0, n_parts + 1)
    return np.concatenate(
        [
            (room.begins + even * (wiebe.start - room.begins))[..., :-1],
            burning_edges(wiebe),
            (end + even * (room.ends - end))[..., 1:],
        ],
        axis=-1,
    )
