"""Work of the torque over a cycle, by Gauss's quadrature, against the work of the gas.

Between dead centres and other kinks everything is smooth, so that few points are exact.
"""

from dataclasses import replace

import numpy as np

from cranktrain.catalogue import quantity
from cranktrain.checks import Check
from cranktrain.engine.forces import LoadedMachine, driving_torques
from cranktrain.engine.gas import GasInChambers
from cranktrain.engine.gas_events import GasEvents
from cranktrain.engine.gas_pressures import GasPressures
from cranktrain.engine.layout import Speed
from cranktrain.language import N_, _
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import panels
from cranktrain.record import record

_THEORY = "docs/theory/forces"
_EXACT_LIMIT = 1e-12
_WIDEST = np.pi / 6
"""Intervals of the quadrature are at most as wide. [rad]"""
_REACH = 1.3
"""How wide they may be for the distance of the volume's zeros in the complex plane, where p ~ V⁻ⁿ has its poles."""


@record
class WorkBalance:
    """Work of the gas over a cycle, without any step of the grid, and whether the torque does it."""

    gas_work: Array = quantity(
        "W", "J", (), N_("Work of the gas in all chambers over a cycle, in closed form or by exact quadrature"), _THEORY
    )
    checks: tuple[Check, ...] = ()


def work_balance(loaded: LoadedMachine, gas: GasInChambers, events: GasEvents, pressures: GasPressures) -> WorkBalance:
    """Work of gas and torque; with friction in the guides, which takes some, there is no check.

    Notes
    -----
    docs/theory/forces, eq. (13.40).
    """
    works = pressures.indicated_work
    total = np.sum(works, axis=-1)
    if loaded.masses.has_friction:
        return WorkBalance(total)
    residual = np.abs(_work_of_torque(loaded, gas, events) - total) / np.sum(np.abs(works), axis=-1)
    sentence = _("Work of the torque by the reactions, by quadrature, against that of the gas")
    return WorkBalance(total, (Check("work", sentence, residual, _EXACT_LIMIT),))


def _work_of_torque(loaded: LoadedMachine, gas: GasInChambers, events: GasEvents) -> Array:
    """Work that the machine's torque by the reactions does over a cycle, shape (design,). [J]"""
    each = events.angle.reshape(len(events.angle), -1)
    cut = [panels(own, wide, gas.cycle) for own, wide in zip(each, _widest(events.least).tolist(), strict=True)]
    longest = max(one.angle.size for one in cut)
    angle = np.stack([np.pad(one.angle, (0, longest - one.angle.size), mode="edge") for one in cut])
    weight = np.stack([np.pad(one.weight, (0, longest - one.weight.size)) for one in cut])
    # Inertia gives no work over a cycle at any speed; at a constant one nothing is interpolated.
    even = replace(loaded, speed=Speed(loaded.speed.value))
    torque = np.sum(driving_torques(even, even.solved(angle[:, np.newaxis])), axis=1)
    return -np.sum(weight * torque, axis=-1)


def _widest(least: Coefficient) -> Array:
    """How wide intervals may be, by the chamber with the least room for its stroke, shape (design,). [rad]"""
    # Near its least value V = V_c + ½V″φ², which is 0 at an imaginary φ.
    away = np.sqrt(2 * least.value / least.second)
    return np.fmin(_WIDEST, _REACH * np.fmin.reduce(away, axis=(1, 2)))
