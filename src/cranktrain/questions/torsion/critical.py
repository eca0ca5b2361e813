"""Critical speeds of torsional vibration: where orders meet natural frequencies, and how far cylinders add up there."""

from dataclasses import field

import numpy as np

from cranktrain.catalogue import quantity
from cranktrain.checks import StageResult
from cranktrain.grouping import grouped
from cranktrain.language import N_, _
from cranktrain.layout.crank_angle import CrankAngle, order_labels, orders
from cranktrain.layout.shafts import Shafts
from cranktrain.layout.speed import Speed
from cranktrain.motion import Array
from cranktrain.numerics.ties import falling
from cranktrain.questions.cylinders.firing import Cycle, Firing
from cranktrain.questions.cylinders.travel import CylinderPistons
from cranktrain.questions.forces.carriers import Carriers
from cranktrain.questions.torque.stars import phase_stars
from cranktrain.questions.torsion.modes import TorsionalModes
from cranktrain.questions.torsion.parts import DeclaredTrain
from cranktrain.record import record
from cranktrain.references import THEORY_OF_TORSION as _THEORY
from cranktrain.wording import Names, number

_ORDER = ("mode", "order")
_NAMED = 3
"""How many of the largest vector sums the answer says, and of the orders that have one."""


@record
class CriticalSpeeds(StageResult):
    """Speeds at which an order of the torque has a natural frequency; speed is the declared one, if any."""

    critical_speed: Array = quantity(
        "Ω", "rad/s", _ORDER, N_("Speed of the crank at which the order has the mode's natural frequency"), _THEORY
    )
    speed: Array | None = field(kw_only=True)

    def answer(self, names: Names, design: int) -> str | None:
        """Say between which critical speeds of the first mode the machine runs."""
        places = self.beside(design)
        if self.speed is None or not places:
            return None
        of_mode = self.critical_speed[design, 0]
        said = [
            _("{speed} (order {order})").format(speed=number(float(of_mode[place]), "rpm"), order=names["order"][place])
            for place in places
        ]
        return _("The critical speeds of mode 1 next to {running}: {speeds}.").format(
            running=number(float(self.speed[design]), "rpm"), speeds=", ".join(said)
        )

    def beside(self, design: int) -> list[int]:
        """Orders whose critical speeds of the first mode are next to the machine's speed, the slower one first."""
        of_mode = self.critical_speed[design, 0]
        if self.speed is None or not np.all(np.isfinite(of_mode)):
            return []
        above = int(np.count_nonzero(of_mode > float(self.speed[design])))
        return [place for place in (above, above - 1) if 0 <= place < of_mode.size]


def critical_speeds(modes: TorsionalModes, crank_angle: CrankAngle, speed: Speed | None) -> CriticalSpeeds:
    """Divide every natural frequency by every order; docs/theory/torsion, eq. (23.9)."""
    return CriticalSpeeds(
        modes.natural_frequency[..., np.newaxis] / orders(crank_angle.cycle),
        speed=None if speed is None else speed.mean[:, 0, 0],
        labels=order_labels(crank_angle.cycle),
    )


@record
class ModeVectorSums(StageResult):
    """How far the cylinders' torques of one order add up in a mode of the shaft."""

    mode_vector_sum: Array = quantity(
        "S_n",
        "1",
        _ORDER,
        N_("Sum of the cylinders' phase vectors of the order, each times its mode's amplitude"),
        _THEORY,
    )

    def answer(self, names: Names, design: int) -> str | None:
        """Name the orders that excite the first mode most."""
        of_mode = self.mode_vector_sum[design, 0]
        if not np.all(np.isfinite(of_mode)):
            return None
        alike = grouped((f"{float(of_mode[place]):.3g}", names["order"][place]) for place in falling(of_mode))
        said = [
            _("{sum} of order {orders}").format(
                sum=size, orders=", ".join([*own[:_NAMED], *["…"] * (len(own) > _NAMED)])
            )
            for size, own in [*alike.items()][:_NAMED]
        ]
        return _("Largest vector sums of mode 1: {sums}.").format(sums="; ".join(said))


def mode_vector_sums(
    declared: DeclaredTrain,
    modes: TorsionalModes,
    firing: Firing,
    cycle: Cycle,
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
    stars = phase_stars(orders(cycle.length), firing.firing_angle[:, np.newaxis], modes.mode_shape[..., on_disc])
    return ModeVectorSums(stars.length, labels=order_labels(cycle.length))
