"""What loads do to the crank of a pumping unit at any angle, quasi-static, and how the polished rod moves."""

from functools import partial
from typing import NamedTuple

import numpy as np

from cranktrain.layout.crank_bodies import CRANK
from cranktrain.layout.load_laws import BySpeed, ByTravel
from cranktrain.layout.loads import LinkLoad
from cranktrain.linkage.vectors import Vector
from cranktrain.motion import ZERO, Array
from cranktrain.numerics import bracketed_roots, extremes
from cranktrain.numerics.designs import by_design
from cranktrain.numerics.harmonics import TURN
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.pumping.declared import DeclaredPumping
from cranktrain.record import record


class ActingOnUnit(NamedTuple):
    """Arrays of shape (design, n) at some crank angles.

    Attributes
    ----------
    height : Array
        Of the polished rod, up, from anywhere. [m]
    factor : Array
        Its derivative by the crank angle. [m]
    load : Array
        Pull of the well. [N]
    rod, weights : Array
        Torques that the crank must be given, for all but the counterbalance and for that. [N·m]
    """

    height: Array
    factor: Array
    load: Array
    rod: Array
    weights: Array


@record
class PumpingUnit:
    """A pumping unit whose loads can be asked for.

    Attributes
    ----------
    loaded : LoadedMachine
    well : LinkLoad
    weights : tuple of LinkLoad
        The counterbalance: the load that is it, and the weight of the crank's body.
    beside : tuple of LinkLoad
        All other loads.
    bottom, top : Array, shape (design,)
        φ of its rod's ends. [rad]
    moment, phase : Array, shape (design,)
        As of `DeclaredPumping`, of all weights together. [N·m, rad]
    """

    loaded: LoadedMachine
    well: LinkLoad
    weights: tuple[LinkLoad, ...]
    beside: tuple[LinkLoad, ...]
    bottom: Array
    top: Array
    moment: Array
    phase: Array

    def at(self, angle: Array) -> ActingOnUnit:
        """What acts at φ, shape (design, n). [rad]"""
        own = angle[:, np.newaxis]
        speed = self.loaded.speed.drive(own).speed
        loads = (self.well, *self.beside, *self.weights)
        ways = self.loaded.load_ways(loads, own)
        sizes = [self.loaded.load_value(load, way, own, speed) for load, way in zip(loads, ways, strict=True)]
        torques = [-size * way.rate for size, way in zip(sizes, ways, strict=True)]
        n_of_rod = 1 + len(self.beside)
        rod: Array = sum(torques[:n_of_rod], ZERO)
        weights: Array = sum(torques[n_of_rod:], ZERO)
        parts = np.broadcast_arrays(-ways[0].place, -ways[0].rate, sizes[0], rod, weights)
        return ActingOnUnit(*(part[:, 0] for part in parts))

    def height(self, angle: Array) -> Array:
        """Height of the polished rod at φ, shape (design, n), from anywhere. [rad, m]"""
        place = -self.loaded.load_way(self.well, angle[:, np.newaxis]).place
        return np.broadcast_to(place[:, 0], angle.shape)

    def angles_at(self, share: Array) -> tuple[Array, Array]:
        """φ at which the rod is at shares of its stroke from 0 to 1, on the upstroke and on the downstroke.

        Shape (design, position) each. [rad]
        """
        top = self.bottom + np.mod(self.top - self.bottom, TURN)
        ends = np.stack([self.bottom, top, self.bottom + TURN], axis=-1)
        lowest, highest, _lowest = np.moveaxis(self.height(ends)[..., np.newaxis], 1, 0)
        wanted = lowest + share[1:-1] * (highest - lowest)
        low, high = (np.repeat(one, share.size - 2, axis=-1) for one in (ends[:, :2], ends[:, 1:]))
        both = np.tile(wanted, 2)
        found = bracketed_roots(lambda angle: self.height(angle) - both, low, high)
        up, down = np.split(found, 2, axis=-1)
        return (
            np.concatenate([ends[:, :1], up, ends[:, 1:2]], axis=-1),
            np.concatenate([ends[:, 2:], down, ends[:, 1:2]], axis=-1),
        )

    def card_area(self) -> Array:
        """Area within a card that goes by travel, from its corners alone, shape (design,); NaN of any other. [J]"""
        law = self.well.law
        if not isinstance(law, ByTravel):
            return np.full(self.bottom.shape, np.nan)
        strokes = np.subtract(*(self.height(angle[:, np.newaxis])[:, 0] for angle in (self.top, self.bottom)))
        rows = zip(law.places, law.out, law.back, np.broadcast_to(strokes, (len(law.places),)), strict=True)
        areas = [_area(places, out - back, float(stroke)) for places, out, back, stroke in rows]
        return -self.well.counts * np.array(areas)


def _area(places: Array, sizes: Array, end: float) -> float:
    """Area under straight lines from 0 to an end."""
    inner = places[(places > 0.0) & (places < end)]
    at = np.concatenate([[0.0], inner, [end]])
    return float(np.trapezoid(np.interp(at, places, sizes), at))


def pumping_unit(declared: DeclaredPumping, loaded: LoadedMachine) -> PumpingUnit:
    """Find the loads by their names, and the ends of the stroke."""
    assert loaded.loads is not None  # the card is one
    by_name = {load.name: load for load in loaded.loads.each}
    well = by_name[declared.card]
    load, body = by_name.get(declared.counterbalance), _body_of_crank(loaded, well.mechanism)
    weights = tuple(one for one in (load, body) if one is not None)
    moment, phase = (declared.moment, declared.phase) if body is None else _together(weights, declared)
    found = extremes(partial(_place, loaded, well), partial(_rate, loaded, well))
    ends = [one.angle[:, 0, 0] for one in (found.largest, found.smallest)]
    bottom, top = by_design(ends, len(declared.moment)).T
    beside = tuple(one for one in loaded.loads.each if one is not well and one is not load)
    return PumpingUnit(loaded, well, weights, beside, bottom, top, moment, phase)


def is_crank_weightless(loaded: LoadedMachine) -> bool:
    """Whether the crank has a body out of balance, and the file no gravity by which that weighs something."""
    kind, made = loaded.mechanisms.batches[0].kind, loaded.masses.batches[0]
    if CRANK not in kind.dynamics.moving:
        return False
    body, gravity = made.bodies[kind.dynamics.moving.index(CRANK)], made.gravity
    unbalance = body.mass * np.hypot(body.along, body.across)
    return bool(np.any((unbalance > 0.0) & (np.hypot(gravity.x, gravity.y) == 0.0)))


def _body_of_crank(loaded: LoadedMachine, mechanism: int) -> LinkLoad | None:
    """Weight of the body of the crank as a load at its centroid; None where it has none, or stands in balance."""
    kind, made = loaded.mechanisms.batches[0].kind, loaded.masses.batches[0]
    if CRANK not in kind.dynamics.moving:
        return None
    link = kind.dynamics.moving.index(CRANK)
    body, gravity = made.bodies[link], made.gravity
    size = body.mass * np.hypot(gravity.x, gravity.y)
    if np.all(size * np.hypot(body.along, body.across) == 0.0):
        return None
    return LinkLoad(
        name=CRANK,
        mechanism=mechanism,
        link=link,
        is_slider=False,
        is_torque=False,
        resists=False,
        law=BySpeed(size, np.ones_like(size), np.zeros_like(size)),
        stretch=None,
        arm=Vector(body.along, body.across),
        counts=1.0,
        radius=None,
        direction=np.arctan2(gravity.y, gravity.x),
    )


def _together(weights: tuple[LinkLoad, ...], declared: DeclaredPumping) -> tuple[Array, Array]:
    """Largest moment of weights that pull in directions of their own, and their phase by that of the first one.

    docs/theory/pumping-unit, eq. (28.11).
    """
    first, *_others = (_direction(load) for load in weights)
    turned = sum(
        (
            _constant(load) * (load.arm.x + 1j * load.arm.y) * np.exp(1j * (first - _direction(load)))
            for load in weights
        ),
        np.zeros((1, 1, 1), dtype=complex),
    )
    of_all = np.broadcast_to(turned[:, 0, 0], declared.moment.shape)
    return np.abs(of_all), declared.sense * np.angle(of_all)


def _direction(load: LinkLoad) -> Array:
    """In which a weight pulls, in the mechanism's axes. [rad]"""
    assert load.direction is not None  # a rope or a weight has one
    return load.direction


def _constant(load: LinkLoad) -> Array:
    """Size of a load that has but one. [N]"""
    assert isinstance(load.law, BySpeed)  # what else is refused as a counterbalance
    return load.law.size


def _place(loaded: LoadedMachine, load: LinkLoad, angle: Array) -> Array:
    """How far along its pull a load is. [m]"""
    return loaded.load_way(load, angle).place


def _rate(loaded: LoadedMachine, load: LinkLoad, angle: Array) -> Array:
    """Derivative of that by the crank angle. [m]"""
    return loaded.load_way(load, angle).rate
