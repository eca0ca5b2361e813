"""Critical speeds of torsional vibration: where orders meet natural frequencies, and how far cylinders add up there."""

from dataclasses import field

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_
from cranktrain.layout.crank_angle import CrankAngle, order_labels, orders
from cranktrain.layout.shafts import Shafts
from cranktrain.layout.speed import Speed
from cranktrain.motion import Array
from cranktrain.numerics.ties import ALIKE
from cranktrain.questions.cylinders.firing import Cycle, Firing
from cranktrain.questions.cylinders.travel import CylinderPistons
from cranktrain.questions.forces.carriers import Carriers
from cranktrain.questions.torque.stars import stars_of_cycle
from cranktrain.questions.torsion.modes import TorsionalModes
from cranktrain.questions.torsion.parts import DeclaredTrain
from cranktrain.record import record
from cranktrain.references import THEORY_OF_TORSION as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import StageResult

_ORDER = ("mode", "order")
_MAJOR = 0.5
"""From which part of the largest vector sum of a mode on an order is a major one."""


@record
class ModeVectorSums(StageResult):
    """How far the cylinders' torques of one order add up in a mode of the shaft."""

    mode_vector_sum: Array = quantity(
        "S_n",
        "1",
        _ORDER,
        N_("Sum of the cylinders' phase vectors of the order, each times its mode's amplitude"),
        _THEORY,
        "23.10",
    )


@record
class CriticalSpeeds(StageResult):
    """Speeds at which an order of the torque has a natural frequency.

    speed is the declared one, if any; sums are the vector sums of the orders, where cylinders fire, (design, mode,
    order).
    """

    critical_speed: Array = quantity(
        "Ω",
        "rad/s",
        _ORDER,
        N_("Speed of the crank at which the order has the mode's natural frequency"),
        _THEORY,
        "23.9",
        shown="rpm",
    )
    speed: Array | None = field(kw_only=True)
    sums: Array | None = field(kw_only=True)

    def beside(self, design: int) -> list[int]:
        """Major orders whose critical speeds of the first mode are next to the machine's speed, the slower one first.

        Major are those whose cylinders' torques add up to half of the largest sum of the mode; all where nothing fires.
        """
        above = self._n_above(design)
        if above is None:
            return []
        major = self._major(design)
        below = np.flatnonzero(major[above:])[:1] + above
        return [*below.tolist(), *np.flatnonzero(major[:above])[-1:].tolist()]

    def _n_above(self, design: int) -> int | None:
        """How many critical speeds of the first mode are above the machine's; they fall with the order."""
        of_mode = self.critical_speed[design, 0]
        if self.speed is None or not np.all(np.isfinite(of_mode)):
            return None
        return int(np.count_nonzero(of_mode > float(self.speed[design])))

    def _major(self, design: int) -> NDArray[np.bool_]:
        """Which orders excite the first mode most, shape (order,)."""
        if self.sums is None or not np.all(np.isfinite(self.sums[design, 0])):
            return np.isfinite(self.critical_speed[design, 0])
        sums: Array = self.sums[design, 0]
        return np.greater_equal(sums, (_MAJOR - ALIKE) * np.max(sums))


def critical_speeds(
    modes: TorsionalModes, crank_angle: CrankAngle, speed: Speed | None, sums: ModeVectorSums | None
) -> CriticalSpeeds:
    """Divide every natural frequency by every order; docs/theory/torsion, eq. (23.9)."""
    return CriticalSpeeds(
        modes.natural_frequency[..., np.newaxis] / orders(crank_angle.cycle),
        speed=None if speed is None else speed.mean[:, 0, 0],
        sums=None if sums is None else sums.mode_vector_sum,
        labels=order_labels(crank_angle.cycle),
    )


def mode_vector_sums(
    declared: DeclaredTrain,
    modes: TorsionalModes,
    firing: Firing,
    cycle: Cycle,
    crank_angle: CrankAngle,
    cylinders: CylinderPistons,
    carriers: Carriers,
    shafts: Shafts,
) -> ModeVectorSums:
    """Stars of the cylinders' phase vectors, weighed with the amplitudes of their throws.

    Notes
    -----
    docs/theory/torsion, eq. (23.10).
    """
    on_disc = declared.throws[shafts.throw[carriers.driven[cylinders.leading]]]
    angle, length = firing.firing_angle[:, np.newaxis], cycle.length
    stars = stars_of_cycle(angle, length, crank_angle.cycle, modes.mode_shape[..., on_disc])
    return ModeVectorSums(stars.length, labels=order_labels(crank_angle.cycle))
