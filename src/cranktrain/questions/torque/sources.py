"""Torque of a machine taken apart for integrals: what is smooth only between events, at Gauss's points, and the rest.

Where nothing rubs, the gas of each chamber does its work by itself, alike for all chambers that differ in their phase;
what is left of the torque is smooth. Where something rubs, the whole machine is solved at the points of one quadrature.
"""

from collections.abc import Iterator
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.shafts import Shafts
from cranktrain.linkage.forces import Drive, Reduced, ReducedInertia, torque_by_work
from cranktrain.motion import ZERO, Array, Coefficient
from cranktrain.numerics import (
    Subintervals,
    integral_motion,
    integral_to,
    shows,
    spectral_derivative,
    subintervals,
)
from cranktrain.numerics.gathering import gathered
from cranktrain.numerics.harmonics import TURN, ComplexArray, harmonics, phasor
from cranktrain.numerics.periodic import fourier_integral, quintic_curve
from cranktrain.questions.forces.events import ForceEvents, breaks_at_speed
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.forces.mechanism_torques import MechanismTorques, reduced_batches
from cranktrain.questions.forces.solved_cycle import SolvedCycle, driving_torques
from cranktrain.questions.gas.chambers import GasInChambers
from cranktrain.questions.gas.events import GasEvents
from cranktrain.questions.gas.pressures import GasPressures
from cranktrain.questions.motion.pistons import PistonMotion
from cranktrain.record import record

_WIDEST = np.pi / 9
"""Of a panel, for the highest order too. [rad]"""
_REACH = 1.3
"""How wide they may be for the distance of the volume's zeros in the complex plane, where p ~ V⁻ⁿ has its poles."""


_HALVINGS = 10
"""How often panels are halved at most, of a machine that nearly locks and turns sharply there."""
_NARROWEST = 2e-4
"""No panels are asked to be narrower: a machine that is as near to locking would have millions of them. [rad]"""


class Source(NamedTuple):
    """A torque over angles of its own, which several places of a machine have, each from another crank angle on.

    Attributes
    ----------
    design : int
    panels : Subintervals
    values : Array, shape (part, point)
        At the panels' points; the parts act on different shafts. [N·m]
    starts : Array, shape (place,)
        Crank angle, as shown, of the source's own 0. [rad]
    shafts : array of int, shape (place, part)
        On which shaft each part acts.
    """

    design: int
    subintervals: Subintervals
    values: Array
    starts: Array
    shafts: NDArray[np.intp]

    def without_mean(self, cycle: float) -> Array:
        """All parts together less their mean, shape (point,). [N·m]"""
        values = self.values.sum(axis=0)
        return values - np.sum(values * self.subintervals.weight) / cycle

    def in_steps(self, step: float) -> Iterator[tuple[float, list[int]]]:
        """Starts that are whole steps apart, which see the same points in turn: the part of a step, and whole ones."""
        steps = self.starts / step
        beside: Array = np.round(np.mod(steps + 0.5, 1.0) - 0.5, 9)
        for aside in np.unique(beside).tolist():
            yield aside, np.rint(steps[beside == aside] - aside).astype(np.intp).tolist()


@record
class TorqueSources:
    """The machine's torque on all shafts.

    Attributes
    ----------
    sources : tuple of Source
        Of all designs.
    rest : Array, shape (design, shaft, n)
        What they leave of the torque on the grid; nothing where something rubs. [N·m]
    inertia : Array, shape (design, n)
        What inertia takes of the rest, Jε + ½J′ω², which does no work over a cycle; nothing where something rubs.
        What is left is smooth at any speed. [N·m]
    kept : Array, shape (design, n)
        What inertia takes in the sources from the first point on, ½Jω²; nothing where it is in the rest. [J]
    spent : Array, shape (design,)
        Work that inertia takes over a cycle: none, but for one moment of acceleration ∮Jε dφ. [J]
    surplus : Array, shape (design,)
        What the integral of the sources takes beyond that: where the crank comes to rest, ε goes like a root. [J]
    cycle : float
        [rad]
    """

    sources: tuple[Source, ...]
    rest: Array
    inertia: Array
    kept: Array
    spent: Array
    surplus: Array
    cycle: float

    @cached_property
    def mean(self) -> Array:
        """Mean torque on every shaft, shape (design, shaft). [N·m]"""
        cycle = self.cycle
        # At a speed that varies equal steps see work in the inertia that it does not do.
        wrong = self.inertia.mean(axis=-1) - np.where(np.any(self.inertia, axis=-1), self.spent / cycle, 0.0)
        wrong = wrong + self.surplus / cycle
        found = self.rest.mean(axis=-1) + wrong[:, np.newaxis] / self.rest.shape[1]
        for one in self.sources:
            own = np.broadcast_to(np.sum(one.values * one.subintervals.weight, axis=-1) / cycle, one.shafts.shape)
            np.add.at(found[one.design], one.shafts, own)
        return found

    def orders(self, order: Array) -> ComplexArray:
        """Amplitudes c_k of the torque of all shafts, Re Σ c_k e^{ikφ}, φ as shown, shape (design, order). [N·m]

        Parameters
        ----------
        order : Array, shape (order,)
            The first ones of the cycle, from 0 on in equal steps.
        """
        smooth = harmonics(self.rest.sum(axis=1), self.cycle).vectors[..., : order.size]
        found = np.zeros((len(smooth), order.size), dtype=np.complex128)
        found[:, : smooth.shape[-1]] = smooth
        share = np.where(order > 0, 2.0, 1.0) / self.cycle
        for one in self.sources:
            # Orders are multiples of the first.
            waves = np.empty((order.size, one.subintervals.angle.size), dtype=np.complex128)
            waves[0], waves[1:] = 1.0, phasor(-order[1] * one.subintervals.angle)
            waves = np.multiply.accumulate(waves, axis=0)
            # A sum and no matrix product, for which threads would be woken.
            own = share * np.sum(waves * (one.values.sum(axis=0) * one.subintervals.weight), axis=-1)
            found[one.design] += own * np.sum(phasor(-order * one.starts[:, np.newaxis]), axis=0)
        return found

    def applied_work(self, shown: Array) -> Array:
        """Work of the torque of all shafts without inertia, less its mean, from the grid's first angle to each.

        Parameters
        ----------
        shown : Array, shape (n,)
            The grid. [rad]

        Returns
        -------
        Array, shape (design, n). [J]
        """
        found = fourier_integral(self.rest.sum(axis=1) + self.inertia, self.cycle).samples + self.kept
        step = float(shown[1] - shown[0])
        for one in self.sources:
            values = one.without_mean(self.cycle)
            for aside, late in one.in_steps(step):
                whole = integral_to(one.subintervals, values, shown - aside * step)
                for steps in late:
                    laid = np.roll(whole, steps)
                    found[one.design] += laid - laid[0]
        return found

    def applied_beside(self, shown: Array, breaks: Array) -> tuple[Coefficient, Coefficient]:
        """Work as `applied_work` has it, but for `kept`, with its derivatives on both sides of grid and some breaks.

        Parameters
        ----------
        shown : Array, shape (n,)
            The grid. [rad]
        breaks : Array, shape (design, m)
            As shown. [rad]

        Returns
        -------
        before, after : Coefficient, shape (design, n + m)
        """
        torque, cycle = self.rest.sum(axis=1) + self.inertia, self.cycle
        torque = torque - np.mean(torque, axis=-1, keepdims=True)
        smooth = Coefficient(
            fourier_integral(torque, cycle).samples, torque, spectral_derivative(torque) * (TURN / cycle)
        )
        between = quintic_curve(smooth, cycle).motion(breaks)
        own = np.stack([np.concatenate(parts, axis=-1) for parts in zip(smooth, between, strict=True)])
        # Before and after, with derivatives.
        found = np.stack([own, own])
        step = float(shown[1] - shown[0])
        for one in self.sources:
            starts = list(one.in_steps(step))
            angle: Array = breaks[one.design] - one.starts[:, np.newaxis]
            asked = np.concatenate([*(shown - aside * step for aside, _late in starts), np.ravel(angle)])
            sides = np.stack(integral_motion(one.subintervals, one.without_mean(cycle), asked))
            *grids, between = np.split(sides, shown.size * np.arange(1, len(starts) + 1), axis=-1)
            for grid, (_aside, late) in zip(grids, starts, strict=True):
                for steps in late:
                    found[:, :, one.design, : shown.size] += np.roll(grid, steps, axis=-1)
            found[:, :, one.design, shown.size :] += np.sum(between.reshape(2, 3, *angle.shape), axis=2)
        found[:, 0] -= found[:, 0, :, :1]
        before, after = found
        return Coefficient(*before), Coefficient(*after)


def torque_sources(
    loaded: LoadedMachine,
    solved: SolvedCycle,
    shafts: Shafts,
    crank_angle: CrankAngle,
    events: ForceEvents,
    gas_events: GasEvents | None,
    gas: GasPressures | None,
    motion: PistonMotion | None,
    torques: MechanismTorques,
) -> TorqueSources:
    """Take the torque apart; docs/theory/harmonics-and-orders, eq. (15.17)."""
    by_shaft = gathered(-solved.driving_torque, shafts.shaft, len(shafts.names))
    drive = Drive(*(part[:, 0] for part in loaded.speed.drive(crank_angle.angle)))
    nothing = np.zeros_like(by_shaft[:, 0])
    spent, cycle = np.zeros(len(by_shaft)), crank_angle.cycle
    if loaded.speed.curve is not None and loaded.speed.curve.moment is not None:
        each = torques.reduced_inertia * loaded.speed.curve.moment[:, 0]
        spent = each.mean(axis=-1) * cycle
    if loaded.jumps:
        energy = torques.reduced_inertia * drive.speed**2 / 2
        whole, seen = _of_machines(loaded, shafts, crank_angle, events)
        kept = energy - energy[..., :1]
        return TorqueSources(tuple(whole), np.zeros_like(by_shaft), nothing, kept, spent, seen - spent, cycle)
    equation = Reduced(ReducedInertia(torques.reduced_inertia, torques.reduced_inertia_slope), ZERO)
    inertia = torque_by_work(equation, drive)
    if loaded.gas is None or gas_events is None or gas is None or motion is None:
        return TorqueSources((), by_shaft, inertia, nothing, spent, np.zeros_like(spent), cycle)
    own = shafts.shaft[loaded.carriers.driven]
    rest = by_shaft - gathered(gas.gas_force * motion.piston_displacement.first, own, len(shafts.names))
    sources = _of_chambers(loaded.gas, gas_events, crank_angle, own)
    return TorqueSources(tuple(sources), rest, inertia, nothing, spent, np.zeros_like(spent), cycle)


def _of_machines(
    loaded: LoadedMachine, shafts: Shafts, crank_angle: CrankAngle, events: ForceEvents
) -> tuple[list[Source], Array]:
    """Torque on every shaft of each design, by the reactions, and the work that its integral sees in inertia. [J]"""
    breaks = breaks_at_speed(events, loaded.speed, crank_angle)
    cuts = [subintervals(own, _WIDEST, crank_angle.cycle) for own in breaks]
    longest = max(cut.angle.size for cut in cuts)
    asked = np.stack([np.pad(cut.angle, (0, longest - cut.angle.size), mode="edge") for cut in cuts])
    angle = asked[:, np.newaxis] + crank_angle.zero
    solved = loaded.solved(angle)
    torque = gathered(-driving_torques(loaded, solved), shafts.shaft, len(shafts.names))
    each = np.arange(len(shafts.names))[np.newaxis]
    sources = [
        Source(design, cut, own[:, : cut.angle.size], np.zeros(1), each)
        for design, (cut, own) in enumerate(zip(cuts, torque, strict=True))
    ]
    if loaded.speed.curve is None:
        return sources, np.zeros(len(cuts))
    drive = loaded.speed.drive(angle)
    inertias = [equation.inertia for equation in reduced_batches(loaded, solved)]
    taken: Array = sum((np.sum(torque_by_work(Reduced(one, ZERO), drive), axis=1) for one in inertias), ZERO)
    weights = np.stack([np.pad(cut.weight, (0, longest - cut.weight.size)) for cut in cuts])
    return sources, np.sum(taken * weights, axis=-1)


def _of_chambers(
    gas: GasInChambers, events: GasEvents, crank_angle: CrankAngle, shafts: NDArray[np.intp]
) -> Iterator[Source]:
    """Torque of the gas in each chamber on its pistons' shafts, by virtual work."""
    for design, places in gas.alike:
        first = int(places[0])
        start = float(gas.firing[design, first, 0])
        # Near its least value V = V_c + ½V″φ², which is 0 at an imaginary φ.
        volume, _slope, curvature = (float(part[design, gas.among_distinct[design, first], 0]) for part in events.least)
        away = float(np.sqrt(2 * volume / curvature))
        widest = min(_WIDEST, max(_REACH * away, _NARROWEST)) if away > 0 else _WIDEST
        cut = subintervals(events.angle[design, first] - start, widest, crank_angle.cycle)
        motion = gas.volume_of(design, first, cut.angle + start)
        for _halving in range(_HALVINGS):
            if widest <= _NARROWEST or shows(cut, motion.first):
                break
            widest /= 2
            cut = subintervals(events.angle[design, first] - start, widest, crank_angle.cycle)
            motion = gas.volume_of(design, first, cut.angle + start)
        pressure = gas.pressure_of(design, first, cut.angle, motion)
        by_chamber = [np.flatnonzero(gas.chambers.areas[design, :, place]) for place in places.tolist()]
        if len(by_chamber[0]) == 1:
            slopes = [motion.first]
        else:
            slopes = [
                gas.chambers.areas[design, piston, first]
                * -gas.pistons.alone(design, piston, cut.angle + start).slider.first[0]
                for piston in by_chamber[0].tolist()
            ]
        over = pressure - gas.chambers.ambient[design, first]
        torque = np.stack([over * slope for slope in slopes])
        starts = gas.firing[design, places, 0] - crank_angle.zero[design, 0, 0]
        yield Source(design, cut, torque, starts, shafts[np.stack(by_chamber)])
