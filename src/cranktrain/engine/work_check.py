"""Work of the torque over a cycle, by Gauss's quadrature, against the work of the gas, in closed form.

Between dead centres and other kinks everything is smooth, so that few points are exact; where the gas goes through
samples, the run's own sum over its grid is compared with the exact integral of what was laid through them.
"""

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from typing import NamedTuple

import numpy as np

from cranktrain.catalogue import quantity
from cranktrain.checks import Check
from cranktrain.engine.forces import LoadedMachine, driving_torques, forces_times_arms
from cranktrain.engine.gas import GasInChambers
from cranktrain.engine.gas_events import GasEvents
from cranktrain.engine.layout import CrankAngle, Speed
from cranktrain.engine.torque import ShaftTorques
from cranktrain.engine.volumes import SweptVolumes
from cranktrain.gas import GasKind, kind_of
from cranktrain.language import N_, _
from cranktrain.motion import Array, Coefficient
from cranktrain.record import record

_THEORY = "docs/theory/forces"
_EXACT_LIMIT = 1e-12
_SHARE = 0.1
"""Of forces times arms, for 1 rad: work that is less is judged by these; an engine's gas does more."""
_WIDEST = np.pi / 6
"""Intervals of the quadrature are at most as wide. [rad]"""
_REACH = 1.3
"""How wide they may be for the distance of the volume's zeros in the complex plane, where p ~ V⁻ⁿ has its poles."""
_NODES = ((0.0, 0.04, 3), (0.04, 0.2, 5), (0.2, 0.6, 8), (0.6, 1.01, 12))
"""Intervals from a part of the widest to another, and how many points are enough there for 13 digits."""
_NARROWEST = 1e-13


@record
class WorkBalance:
    """Work of the gas over a cycle, without any step of the grid, and whether the torque does it."""

    gas_work: Array = quantity(
        "W", "J", (), N_("Work of the gas in all chambers over a cycle, in closed form or by exact quadrature"), _THEORY
    )
    checks: tuple[Check, ...] = ()


def work_balance(
    loaded: LoadedMachine,
    gas: GasInChambers,
    events: GasEvents,
    swept: SweptVolumes,
    torques: ShaftTorques,
    crank_angle: CrankAngle,
) -> WorkBalance:
    """Work of gas and torque; with friction in the guides, which takes some, there is no check.

    Notes
    -----
    docs/theory/forces, eq. (13.40).
    """
    kinds = [kind_of(spec) for spec in gas.specs]
    works = np.stack([_gas_works(gas, kind, design, swept) for design, kind in enumerate(kinds)])
    total = np.sum(works, axis=-1)
    if loaded.masses.has_friction:
        return WorkBalance(total)
    scale = np.sum(np.abs(works), axis=-1)
    if all(kind.mean_pressures is not None for kind in kinds):
        # Gas may do no work at all, and what works on the shaft may cancel: that leaves rounding of forces times arms.
        by_torque, on_the_way = _work_of_torque(loaded, gas, events)
        residual = np.abs(by_torque - total) / np.maximum(scale, _SHARE * on_the_way)
        sentence = _("Work of the torque by the reactions, by quadrature, against that of the gas in closed form")
        return WorkBalance(total, (Check("work", sentence, residual, _EXACT_LIMIT),))
    residual = np.abs(np.mean(torques.machine_torque, axis=-1) * gas.cycle - total) / scale
    sentence = _("Work of the torque, summed over the grid, against the exact integral of the indicator diagrams")
    return WorkBalance(total, (Check("work", sentence, residual, _sum_limit(crank_angle)),))


def _sum_limit(crank_angle: CrankAngle) -> float:
    """What equal steps leave of a measured trace's work: 5·10⁻⁴ at 1°, 10⁻⁴ at half a degree and less."""
    step = np.degrees(crank_angle.cycle / crank_angle.shown.size)
    return 1e-4 if step <= 0.5 else 5e-4 * float(max(step, 1.0)) ** 2


def _gas_works(gas: GasInChambers, kind: GasKind, design: int, swept: SweptVolumes) -> Array:
    """Work of the gas in each chamber of a design over a cycle, shape (chamber,). [J]"""
    works = np.full(len(gas.chambers.names), np.nan)
    for model, places in gas.alike(design):
        if kind.mean_pressures is not None:
            ratio = (gas.limits.largest / gas.limits.smallest)[design, places, 0]
            found = kind.mean_pressures(model, ratio)
            mean = found.net if gas.cycle > 3 * np.pi else found.gross
            works[places] = mean * swept.swept_volume[design, places]
        elif kind.work is not None:
            works[places] = kind.work(model, _slope_of(gas, design, places[0]))
    return works


def _slope_of(gas: GasInChambers, design: int, place: int) -> Callable[[Array], Array]:
    """dV/dφ of one chamber by angles since its nominal firing, of any shape."""
    start = float(gas.firing[design, place, 0])

    def slope(angle: Array) -> Array:
        return gas.volume(angle.ravel() + start).first[design, place].reshape(angle.shape)

    return slope


def _work_of_torque(loaded: LoadedMachine, gas: GasInChambers, events: GasEvents) -> tuple[Array, Array]:
    """Work of the torque by the reactions over a cycle, and forces times arms for 1 rad, shape (design,). [J]"""
    quadrature = _quadrature(events.angle, _widest(events.least), gas.cycle)
    # Inertia gives no work over a cycle at any speed; at a constant one nothing is interpolated.
    even = replace(loaded, speed=Speed(loaded.speed.value))
    solved = even.solved(quadrature.angle[:, np.newaxis])
    torque = np.sum(driving_torques(even, solved), axis=1)
    return -np.sum(quadrature.weight * torque, axis=-1), np.sum(forces_times_arms(even, solved), axis=1)


def _widest(least: Coefficient) -> Array:
    """How wide intervals may be, by the chamber with the least room for its stroke, shape (design,). [rad]"""
    # Near its least value V = V_c + ½V″φ², which is 0 at an imaginary φ.
    away = np.sqrt(2 * least.value / least.second)
    return np.fmin(_WIDEST, _REACH * np.fmin.reduce(away, axis=(1, 2)))


class _Quadrature(NamedTuple):
    """Angles and weights, shape (design, n); designs with fewer intervals have weights of 0. [rad]"""

    angle: Array
    weight: Array


def _quadrature(events: Array, widest: Array, cycle: float) -> _Quadrature:
    """Gauss's points between events over one cycle."""
    designs = [_gauss(own, wide, cycle) for own, wide in zip(events, widest.tolist(), strict=True)]
    longest = max(angle.size for angle, _weight in designs)
    return _Quadrature(
        np.stack([np.pad(angle, (0, longest - angle.size), mode="edge") for angle, _weight in designs]),
        np.stack([np.pad(weight, (0, longest - weight.size)) for _angle, weight in designs]),
    )


@cache
def _leggauss(n_nodes: int) -> tuple[Array, Array]:
    """Gauss's points in (−1, 1) and their weights."""
    return np.polynomial.legendre.leggauss(n_nodes)


def _gauss(events: Array, widest: float, cycle: float) -> tuple[Array, Array]:
    """Gauss's points and weights of one design; without events, where links do not close, over equal parts."""
    known = np.mod(events[~np.isnan(events)], cycle)
    n_parts = int(np.ceil(cycle / widest - _NARROWEST))
    marks = np.arange(n_parts) * (cycle / n_parts) + (known[0] if known.size else 0.0)
    edges = np.sort(np.concatenate([known, np.mod(marks, cycle)]))
    edges = np.append(edges, edges[0] + cycle)
    widths = np.diff(edges)
    angles: list[Array] = []
    weights: list[Array] = []
    for narrow, wide, n_nodes in _NODES:
        chosen = (np.maximum(narrow * widest, _NARROWEST) < widths) & (widths <= wide * widest)
        node, weight = _leggauss(n_nodes)
        half = widths[chosen, np.newaxis] / 2
        angles.append((edges[:-1][chosen, np.newaxis] + half * (1 + node)).ravel())
        weights.append((half * weight).ravel())
    return np.concatenate(angles), np.concatenate(weights)
