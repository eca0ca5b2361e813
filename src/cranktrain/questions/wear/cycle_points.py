"""The machine between its events: solved at few points of the cycle, by which means over it are exact."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.motion import Array
from cranktrain.numerics import Subintervals, points_together, subintervals
from cranktrain.numerics.sectors import Sectors, size_by_sector
from cranktrain.numerics.size_integral import integral_of_size
from cranktrain.questions.forces.events import ForceEvents
from cranktrain.questions.forces.loaded_machine import LoadedMachine, SolvedBatch
from cranktrain.questions.wear.rays import N_RAYS, RAY_NAMES, oil_hole, wear_of
from cranktrain.record import record

_WIDEST = np.pi / 9
"""Of a piece of the quadrature. [rad]"""
_MORE = 3
"""Points of a piece beside those that its integral needs: where a load crosses a ray is found between them."""


class Wear(NamedTuple):
    """Mean load on every ray, shape (..., ray) [N], and where an oil hole goes, shape (...) [rad]."""

    rays: Array
    hole: Array


@record
class CyclePoints:
    """Gauss's points of a cycle, between events, and the machine there.

    Attributes
    ----------
    cuts : tuple of Subintervals
        Of each design.
    angle : Array, shape (design, 1, point)
        φ. [rad]
    cycle : float
        [rad]
    solved : sequence of SolvedBatch
    """

    cuts: tuple[Subintervals, ...]
    angle: Array
    cycle: float
    solved: Sequence[SolvedBatch]

    @property
    def labels(self) -> dict[str, tuple[str, ...]]:
        """Names of the rays."""
        return {"ray": RAY_NAMES}

    def mean_size(self, first: Array, second: Array) -> Array:
        """Mean over the cycle of the size of vectors by their parts at the points, shape (design, ..., point)."""
        x, y = (part.reshape(len(part), -1, part.shape[-1]) for part in (first, second))
        means = [
            integral_of_size(cut, (x[i, :, : cut.angle.size], y[i, :, : cut.angle.size])) / self.cycle
            for i, cut in enumerate(self.cuts)
        ]
        return np.stack(means).reshape(first.shape[:-1])

    def wear(self, *loads: Sequence[Array]) -> list[Wear]:
        """Wear by loads, by both parts at the points, (design, ..., point); rays count from the first part."""
        first, second = (np.stack(parts, axis=1) for parts in zip(*loads, strict=True))
        x, y = (part.reshape(len(part), -1, part.shape[-1]) for part in (first, second))
        sectors = [
            size_by_sector(cut, x[i, :, : cut.angle.size], y[i, :, : cut.angle.size], N_RAYS)
            for i, cut in enumerate(self.cuts)
        ]
        whole = Sectors(*(np.stack(part) for part in zip(*sectors, strict=True)))
        rays = wear_of(whole, self.cycle).reshape(*first.shape[:-1], N_RAYS)
        return [Wear(of_load, oil_hole(of_load)) for of_load in np.moveaxis(rays, 1, 0)]


def cycle_points(loaded: LoadedMachine, events: ForceEvents, crank_angle: CrankAngle) -> CyclePoints:
    """Solve the machine between its events; docs/theory/harmonics-and-orders, eq. (15.17)."""
    breaks = events.whole - crank_angle.zero[:, 0]
    cuts = tuple(subintervals(of_design, _WIDEST, crank_angle.cycle, _MORE) for of_design in breaks)
    angle, _weight = points_together(breaks, _WIDEST, crank_angle.cycle, _MORE)
    phi = angle + crank_angle.zero
    return CyclePoints(cuts, phi, crank_angle.cycle, loaded.solved(phi))
