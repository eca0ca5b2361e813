"""Travel in a cylinder: how its piston, or both of its opposed pistons together, make its room smaller and larger."""

from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from cranktrain.layout.mechanisms import Pistons
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import turn_grid, turning_points
from cranktrain.questions.motion.dead_centres import DeadCentres, slider_motion
from cranktrain.record import record


@record
class CylinderPistons:
    """Which pistons work in which cylinder.

    Attributes
    ----------
    names : tuple of str
        Of the cylinders: `1L`; those of single pistons are called as these.
    index : array of int, shape (cylinder, 2)
        Its piston twice, or its exhaust and its scavenge piston.
    signs : Array, shape (cylinder, 2)
        +1 where room grows as the piston moves toward its shaft, −1 of one with side rods; (1, 0) of a single piston.
    """

    reads: ClassVar[tuple[str, ...]] = ("[cylinder]", "[bank.NAME]")

    names: tuple[str, ...]
    index: NDArray[np.intp]
    signs: Array

    @property
    def labels(self) -> dict[str, tuple[str, ...]]:
        """Names of the cylinders."""
        return {"cylinder": self.names}

    @property
    def leading(self) -> NDArray[np.intp]:
        """The piston from which each cylinder counts: the exhaust's of two, shape (cylinder,)."""
        return self.index[:, 0]

    @property
    def is_opposed(self) -> NDArray[np.bool_]:
        """Whether two pistons share the cylinder, shape (cylinder,)."""
        return self.signs[:, 1] != 0.0

    def summed(self, values: Array) -> Array:
        """Add the pistons' values, shape (design, piston, …), with their signs: shape (design, cylinder, …)."""
        signs = self.signs.reshape(self.signs.shape + (1,) * (values.ndim - 2))
        # A single piston stands there twice, the second time with a sign of 0: NaN stays in its own cylinder.
        return signs[:, 0] * values[:, self.index[:, 0]] + signs[:, 1] * values[:, self.index[:, 1]]


def reach(cylinders: CylinderPistons, pistons: Pistons, angle: Array) -> Coefficient:
    """How far the pistons of each cylinder reach into it: the sum of their distances from their shafts.

    Parameters
    ----------
    cylinders : CylinderPistons
    pistons : Pistons
    angle : Array, shape (n,), (design, 1, n) or (design, cylinder, n)
        φ. [rad]

    Returns
    -------
    Coefficient, shape (design, cylinder, n). [m, m/rad, m/rad²]
        What it gains the room between the pistons loses.
    """
    own = angle
    if angle.ndim == 3 and angle.shape[1] > 1:
        own = np.zeros((angle.shape[0], len(pistons.names), angle.shape[-1]))
        own[:, cylinders.index] = angle[:, :, np.newaxis]
    motion = slider_motion(pistons, own)
    return Coefficient(*(cylinders.summed(part) for part in motion))


@record
class CylinderTravel:
    """Where each cylinder has its least and its greatest room.

    Attributes
    ----------
    stroke : Array, shape (design, cylinder)
        By how much the pistons together part; a single piston's stroke. [m]
    reach : Array, shape (design, cylinder)
        Greatest sum of the pistons' distances from their shafts. [m]
    least : Array, shape (design, cylinder)
        Smallest sum of the pistons' displacements from their own tops, with their signs; 0 of a single piston. [m]
    inner, outer : Array, shape (design, cylinder)
        φ of least and greatest room. [rad]
    """

    stroke: Array
    reach: Array
    least: Array
    inner: Array
    outer: Array


def cylinder_travel(cylinders: CylinderPistons, pistons: Pistons, dead_centres: DeadCentres) -> CylinderTravel:
    """Dead centres of every cylinder: a single piston's own, of opposed pistons the volumetric ones."""
    leading = cylinders.leading
    nominal = pistons.nominal_top[:, leading, 0]
    single = CylinderTravel(
        stroke=dead_centres.stroke[:, leading],
        reach=dead_centres.top_position[:, leading],
        least=np.zeros_like(nominal),
        inner=nominal + dead_centres.top_shift[:, leading],
        outer=nominal + np.pi + dead_centres.bottom_shift[:, leading],
    )
    opposed = cylinders.is_opposed
    if not np.any(opposed):
        return single
    parted, closest = turning_points(
        lambda phi: reach(cylinders, pistons, phi), reach(cylinders, pistons, turn_grid()).value
    )
    tops = cylinders.summed(dead_centres.top_position)

    def chosen(both: Array, one: Array) -> Array:
        return np.where(opposed, both, one)

    return CylinderTravel(
        stroke=chosen((closest.value - parted.value)[..., 0], single.stroke),
        reach=chosen(closest.value[..., 0], single.reach),
        least=chosen(tops - closest.value[..., 0], single.least),
        inner=chosen(closest.angle[..., 0], single.inner),
        outer=chosen(parted.angle[..., 0], single.outer),
    )
