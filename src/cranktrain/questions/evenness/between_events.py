"""Work and inertia between events: curves with a node wherever the torque may jump or have a corner."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.speed import Speed
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import spectral_derivative
from cranktrain.numerics.harmonics import TURN
from cranktrain.numerics.periodic import PeriodicCurve, piecewise_curve, quintic_curve
from cranktrain.numerics.piecewise import PiecePlaces, pieces_from, quintics
from cranktrain.questions.forces.mechanism_torques import MechanismTorques
from cranktrain.questions.torque.sources import TorqueSources

_ASIDE = 1e-9
"""How far beside an angle the speed is asked for, where its own curve has a corner. [rad]"""


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


def nodes_at(events: Array, crank_angle: CrankAngle) -> Nodes:
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
    before, after = sources.applied_beside(crank_angle.shown, nodes.breaks, cycle)
    if np.any(sources.kept):
        before, after = (
            _added(done, _kept(carried, _square(speed, every, side, crank_angle)))
            for done, side in ((before, -_ASIDE), (after, _ASIDE))
        )
    work = nodes.curve(before, after, after.value[:, : crank_angle.shown.size], cycle)
    return work, nodes.curve(carried, carried, torques.reduced_inertia, cycle)


def work_of_loads(nodes: Nodes, work: PeriodicCurve) -> PeriodicCurve:
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
