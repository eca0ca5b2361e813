"""Work that the torque of a machine stores within a cycle: on the grid, and by pieces between events."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.speed import Speed
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import spectral_derivative
from cranktrain.numerics.harmonics import TURN
from cranktrain.numerics.periodic import PeriodicCurve, fourier_curve, piecewise_curve, quintic_curve
from cranktrain.numerics.piecewise import PiecePlaces, pieces_from, quintics
from cranktrain.questions.evenness.excess_work import ExcessWork, excess_against, excess_of
from cranktrain.questions.evenness.shaft_torque import AppliedTorque, LoadTorque
from cranktrain.questions.forces.events import ForceEvents
from cranktrain.questions.forces.mechanism_torques import MechanismTorques
from cranktrain.questions.torque.sources import TorqueSources
from cranktrain.record import record
from cranktrain.references import THEORY_OF_EVENNESS as _THEORY
from cranktrain.saying.catalogue import quantity

_ASIDE = 1e-9
"""How far beside an angle the speed is asked for, where its own curve has a corner. [rad]"""


@record
class ShaftWork:
    """Work of the torque without inertia, less that of the loads on the shaft.

    Attributes
    ----------
    excess : ExcessWork
        Its curve from the first point of the grid. [rad, J]
    inertia : PeriodicCurve
        J of the moving parts. [kg·m²]
    """

    excess: ExcessWork
    inertia: PeriodicCurve
    excess_work: Array = quantity(
        "A",
        "J",
        ("crank_angle",),
        N_("Work of that torque, less that of loads on the shaft, less its mean"),
        _THEORY,
        "17.2, 17.17",
    )
    largest_excess_work: Array = quantity(
        "ΔA",
        "J",
        (),
        N_("Largest excess work: from the least to the most that is stored within a cycle"),
        _THEORY,
        "17.2",
    )


def shaft_work(
    applied: AppliedTorque,
    sources: TorqueSources,
    given: LoadTorque | None,
    events: ForceEvents,
    torques: MechanismTorques,
    speed: Speed,
    crank_angle: CrankAngle,
) -> ShaftWork:
    """Work of what drives the shaft less what its loads take, over the cycle.

    Notes
    -----
    By quadrature between events, with a node at each; by Fourier series where there is none.
    docs/theory/evenness, eqs. (17.2) and (17.17).
    """
    mean, taken = np.sum(sources.mean, axis=-1), None if given is None else given.work
    if applied.is_smooth and taken is None:
        work = fourier_curve(sources.applied_work(crank_angle.shown), crank_angle.cycle)
        inertia = fourier_curve(torques.reduced_inertia, crank_angle.cycle)
    else:
        corners = () if given is None else given.corners
        nodes = _nodes_at(np.concatenate([events.whole - crank_angle.zero[:, 0], *corners], axis=-1), crank_angle)
        work, inertia = applied_work(nodes, sources, torques, speed, crank_angle)
        taken = None if taken is None else _work_of_loads(nodes, taken)
    excess = excess_of(work, mean)
    if given is not None:
        excess = excess_against(excess, taken, given.mean)
    return ShaftWork(
        excess=excess,
        inertia=inertia,
        excess_work=excess.work.samples,
        largest_excess_work=excess.difference,
    )


class Nodes(NamedTuple):
    """Angles from the first point of the grid at which pieces of curves begin: the grid's and those of events.

    Attributes
    ----------
    breaks : Array, shape (design, m)
        Of events, as shown; of none it is 0. [rad]
    pieces : PiecePlaces, shape (design, n + m)
        From each of all to the next.
    order : array of int, shape (design, n + m)
        Which one of grid and breaks stands where.
    """

    breaks: Array
    pieces: PiecePlaces
    order: NDArray[np.intp]

    def curve(self, before: Coefficient, after: Coefficient, samples: Array, cycle: float) -> PeriodicCurve:
        """Curve by its values and derivatives on both sides of grid and breaks, shape (design, n + m)."""
        sides = (
            Coefficient(*(np.take_along_axis(part, self.order, axis=-1) for part in side)) for side in (before, after)
        )
        ends, begins = sides
        ends = Coefficient(*(np.roll(part, -1, axis=-1) for part in ends))
        powers = quintics(ends, begins, self.pieces.width)
        return piecewise_curve(powers, self.pieces, samples, cycle)


def _nodes_at(events: Array, crank_angle: CrankAngle) -> Nodes:
    """Nodes at the grid and at events, shape (design, event), as shown; NaN for none."""
    breaks = np.mod(np.where(np.isnan(events), 0.0, events), crank_angle.cycle)
    grid = np.broadcast_to(crank_angle.shown, (len(breaks), crank_angle.shown.size))
    every = np.concatenate([grid, breaks], axis=-1)
    order = np.argsort(every, axis=-1, kind="stable")
    return Nodes(breaks, pieces_from(np.take_along_axis(every, order, axis=-1), crank_angle.cycle), order)


def applied_work(
    nodes: Nodes, sources: TorqueSources, torques: MechanismTorques, speed: Speed, crank_angle: CrankAngle
) -> tuple[PeriodicCurve, PeriodicCurve]:
    """Work of the torque without inertia, less its mean, from the grid's first angle on; and the moving parts' inertia.

    Notes
    -----
    At the nodes by quadrature between events, with the torque and its slope on both sides of each; quintics between
    them. docs/theory/evenness, eq. (17.2).
    """
    cycle = crank_angle.cycle
    slope = torques.reduced_inertia_slope
    known = Coefficient(torques.reduced_inertia, slope, spectral_derivative(slope) * (TURN / cycle))
    between = quintic_curve(known, cycle).motion(nodes.breaks)
    carried = Coefficient(*(np.concatenate(parts, axis=-1) for parts in zip(known, between, strict=True)))
    every = np.concatenate([np.broadcast_to(crank_angle.shown, known.value.shape), nodes.breaks], axis=-1)
    before, after = sources.applied_beside(crank_angle.shown, nodes.breaks)
    if np.any(sources.kept):
        before, after = (
            _added(done, _kept(carried, _square(speed, every, side, crank_angle)))
            for done, side in ((before, -_ASIDE), (after, _ASIDE))
        )
    work = nodes.curve(before, after, after.value[:, : crank_angle.shown.size], cycle)
    return work, nodes.curve(carried, carried, torques.reduced_inertia, cycle)


def _work_of_loads(nodes: Nodes, work: PeriodicCurve) -> PeriodicCurve:
    """Work that is a parabola from corner to corner, at nodes among which all corners are, shape (design, n)."""
    begins, ends = nodes.pieces.start, nodes.pieces.start + nodes.pieces.width
    start, middle, end = (work.value(angle) for angle in (begins, (begins + ends) / 2, ends))
    bend = 2 * (start + end - 2 * middle)
    samples = np.broadcast_to(work.samples, (len(begins), work.samples.shape[-1]))
    return piecewise_curve(np.stack([start, end - start - bend, bend]), nodes.pieces, samples, work.cycle)


def _square(speed: Speed, shown: Array, aside: float, crank_angle: CrankAngle) -> Coefficient:
    """Square of the speed over the crank angle, with its derivatives a little aside, broadcastable to (design, k)."""
    if speed.curve is None:
        none = np.zeros_like(speed.value[:, 0])
        return Coefficient(speed.value[:, 0] ** 2, none, none)
    angle = shown + crank_angle.zero[:, 0] - speed.curve.zero[:, 0]
    beside = speed.curve.square.motion(angle + aside)
    return beside._replace(value=speed.curve.square.value(angle))


def _kept(carried: Coefficient, square: Coefficient) -> Coefficient:
    """Energy ½Jω² from the first angle on, with its derivatives."""
    value = carried.value * square.value / 2
    return Coefficient(
        value - value[:, :1],
        (carried.first * square.value + carried.value * square.first) / 2,
        (carried.second * square.value + 2 * carried.first * square.first + carried.value * square.second) / 2,
    )


def _added(one: Coefficient, other: Coefficient) -> Coefficient:
    """Sum of two motions."""
    return Coefficient(*(part + more for part, more in zip(one, other, strict=True)))
