"""Orders of the machine's torque, and the stars of the cylinders' phases by which they add up."""

from dataclasses import field

import numpy as np

from cranktrain.language import N_
from cranktrain.layout.crank_angle import CrankAngle, order_labels, orders
from cranktrain.motion import Array
from cranktrain.numerics.harmonics import from_vectors
from cranktrain.numerics.ties import falling
from cranktrain.questions.cylinders.firing import Cycle, Firing
from cranktrain.questions.torque.sources import TorqueSources
from cranktrain.questions.torque.stars import PhaseStars, stars_of_cycle
from cranktrain.questions.torque.torques import ShaftTorques
from cranktrain.record import record
from cranktrain.references import THEORY_OF_HARMONICS as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import StageResult

_ORDER = ("order",)
_NAMED = 3
"""How many of the largest orders the answer names."""
_NOTHING = 1e-12
"""Of the largest torque, and of what all forces could do; an order of less is rounding."""
_ROUNDING, _GONE = 1e-6, 1e-9
"""Of the largest order, and of what all forces could do: what is less is not named."""


@record
class TorqueOrders(StageResult):
    """Harmonics of the machine's torque: amplitude · cos(kφ − ψ), φ as shown; gross as of `ShaftTorques`."""

    torque_order_amplitude: Array = quantity(
        "T_k", "N*m", _ORDER, N_("Amplitude of the order in the machine's torque"), _THEORY, "15.17, 15.18"
    )
    torque_order_phase: Array = quantity(
        "ψ_k",
        "deg",
        _ORDER,
        N_("Phase of the order in the torque, T_k cos(kφ − ψ_k), φ as the tables count it"),
        _THEORY,
        "15.17, 15.18",
    )
    gross: Array = field(kw_only=True)

    def largest(self, design: int) -> list[int]:
        """Places of the largest orders, the largest first; none of what is rounding."""
        amplitude = np.nan_to_num(self.torque_order_amplitude[design])
        least = max(_ROUNDING * float(np.max(amplitude)), _GONE * float(self.gross[design]))
        return [place for place in falling(amplitude)[:_NAMED] if amplitude[place] > least]


def torque_orders(sources: TorqueSources, torques: ShaftTorques, crank_angle: CrankAngle) -> TorqueOrders:
    """Harmonics of the torque of all mechanisms together, by quadrature between events; rounding has no phase."""
    order = orders(crank_angle.cycle)
    vectors = sources.orders(np.concatenate([[0.0], order]))[:, 1:]
    found = from_vectors(order, vectors)
    largest = np.max(np.abs(torques.machine_torque), axis=-1, keepdims=True)
    is_rounding = found.amplitude <= _NOTHING * np.maximum(largest, torques.gross[:, np.newaxis])
    amplitude, phase = np.where(is_rounding, 0.0, found.amplitude), np.where(is_rounding, np.nan, found.phase)
    return TorqueOrders(amplitude, phase, gross=torques.gross, labels=order_labels(crank_angle.cycle))


@record
class PhaseStarSums(StageResult):
    """How far the cylinders' torques of one order add up by their firing: as many as cylinders where all do."""

    phase_star_sum: Array = quantity(
        "S_k", "1", _ORDER, N_("Sum of the cylinders' phase vectors of the order, by nominal firing"), _THEORY, "15.14"
    )
    stars: PhaseStars = field(kw_only=True)


def phase_star_sums(firing: Firing, cycle: Cycle, crank_angle: CrankAngle) -> PhaseStarSums:
    """Stars of the phase vectors of all cylinders; docs/theory/harmonics-and-orders, eq. (15.14)."""
    stars = stars_of_cycle(firing.firing_angle, cycle.length, crank_angle.cycle)
    return PhaseStarSums(stars.length, stars=stars, labels=order_labels(crank_angle.cycle))
