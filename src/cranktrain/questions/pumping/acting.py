"""What loads do to the crank of a pumping unit at any angle, quasi-static, and how the polished rod moves."""

from functools import partial
from typing import NamedTuple

import numpy as np

from cranktrain.layout.load_laws import ByTravel
from cranktrain.layout.loads import LinkLoad
from cranktrain.motion import Array
from cranktrain.numerics import bracketed_roots, extremes
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
    """A pumping unit whose loads can be asked for; `bottom` and `top`, shape (design,), φ of its rod's ends. [rad]"""

    loaded: LoadedMachine
    well: LinkLoad
    weights: LinkLoad | None
    beside: tuple[LinkLoad, ...]
    bottom: Array
    top: Array

    def at(self, angle: Array) -> ActingOnUnit:
        """What acts at φ, shape (design, n). [rad]"""
        own = angle[:, np.newaxis]
        speed = self.loaded.speed.drive(own).speed
        way = self.loaded.load_way(self.well, own)
        pull = self.loaded.load_value(self.well, way, own, speed)
        rod = -pull * way.rate
        for load in self.beside:
            rod = rod + self._torque(load, own, speed)
        weights = 0.0 * rod if self.weights is None else self._torque(self.weights, own, speed)
        parts = np.broadcast_arrays(-way.place, -way.rate, pull, rod, weights)
        return ActingOnUnit(*(part[:, 0] for part in parts))

    def _torque(self, load: LinkLoad, angle: Array, speed: Array) -> Array:
        """Torque that the crank must be given for a load. [N·m]"""
        way = self.loaded.load_way(load, angle)
        return -self.loaded.load_value(load, way, angle, speed) * way.rate

    def angles_at(self, share: Array, *, is_up: bool) -> Array:
        """φ at which the rod is at shares of its stroke, shape (design, position), on the up- or downstroke. [rad]"""
        start, end = (self.bottom, self.top) if is_up else (self.top, self.bottom)
        end = start + np.mod(end - start, TURN)
        lowest = self.at(self.bottom[:, np.newaxis]).height
        highest = self.at(self.top[:, np.newaxis]).height
        wanted = lowest + share * (highest - lowest)
        low, high = (np.broadcast_to(one[:, np.newaxis], wanted.shape) for one in (start, end))
        found = bracketed_roots(lambda angle: self.at(angle).height - wanted, low, high)
        at_ends = np.where((share <= 0.0) == is_up, low, high)
        return np.where((share <= 0.0) | (share >= 1.0), at_ends, found)

    def card_area(self) -> Array:
        """Area within a card that goes by travel, from its corners alone, shape (design,); NaN of any other. [J]"""
        law = self.well.law
        if not isinstance(law, ByTravel):
            return np.full(self.bottom.shape, np.nan)
        ends = (self.at(angle[:, np.newaxis]).height[:, 0] for angle in (self.top, self.bottom))
        strokes = np.subtract(*ends)
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
    weights = by_name.get(declared.counterbalance)
    found = extremes(partial(_place, loaded, well), partial(_rate, loaded, well))
    n_designs = len(declared.moment)
    bottom, top = (
        np.array(np.broadcast_to(one.angle[:, 0, 0], (n_designs,))) for one in (found.largest, found.smallest)
    )
    beside = tuple(load for load in loaded.loads.each if load is not well and load is not weights)
    return PumpingUnit(loaded, well, weights, beside, bottom, top)


def _place(loaded: LoadedMachine, load: LinkLoad, angle: Array) -> Array:
    """How far along its pull a load is. [m]"""
    return loaded.load_way(load, angle).place


def _rate(loaded: LoadedMachine, load: LinkLoad, angle: Array) -> Array:
    """Derivative of that by the crank angle. [m]"""
    return loaded.load_way(load, angle).rate
