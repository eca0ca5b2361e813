"""Harmonics that a rod of finite length gives the piston's acceleration and the torque of its inertia, exact."""

import numpy as np

from cranktrain.language import N_
from cranktrain.layout.crank_angle import CrankAngle, order_labels
from cranktrain.layout.mechanisms import Pistons
from cranktrain.motion import Array
from cranktrain.questions.torque.rod_harmonics import both_harmonics
from cranktrain.record import record
from cranktrain.references import THEORY_OF_HARMONICS as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import StageResult

_FACT = ("order", "piston")


@record
class RodOrders(StageResult):
    """Harmonics of pistons by the angle of their own cranks from the top; NaN but for central slider-cranks."""

    acceleration_harmonic: Array = quantity(
        "A_k", "1", _FACT, N_("Harmonic of a central piston's acceleration, x″ = R Σ A_k cos kα"), _THEORY, "15.2, 15.4"
    )
    inertia_torque_harmonic: Array = quantity(
        "D_k", "1", _FACT, N_("Harmonic of its inertia's torque, T = m R² ω² Σ D_k sin kα"), _THEORY, "15.7"
    )


def rod_orders(pistons: Pistons, crank_angle: CrankAngle) -> RodOrders:
    """Harmonics of every piston in closed form; docs/theory/harmonics-and-orders, eqs. (15.4) and (15.7)."""
    labels = order_labels(crank_angle.cycle)
    turns = round(crank_angle.cycle / (2 * np.pi))
    highest = len(labels["order"]) // turns
    ratio = np.full((len(crank_angle.zero), len(pistons.names)), np.nan)
    for batch in pistons.batches:
        if batch.kind.direct_ratio is not None:
            ratio[:, batch.index] = batch.kind.direct_ratio(batch.members.geometry)[..., 0]
    # Rods are mostly all of one ratio.
    known, place = np.unique(ratio, return_inverse=True)
    by_order = np.stack(both_harmonics(known, highest))[:, place.reshape(ratio.shape), 1:]
    # Orders between whole ones are those of a cycle of two turns: no piston's inertia knows them.
    every = np.where(np.isnan(by_order[..., :1]), np.nan, np.zeros(len(labels["order"])))
    every[..., turns - 1 :: turns] = by_order
    return RodOrders(*np.moveaxis(every, -1, 2), labels=labels)
