"""The ideal cycles as fluids: three tables of one; whether they suit their chambers, where heat ends, work."""

from typing import TypeVar

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.fluids.dual.pressure import IdealCycle, ideal_mean_pressures, ideal_pressure, ideal_slope
from cranktrain.fluids.dual.spec import IdealCycleSpec, cycle_flags, ideal_cycle
from cranktrain.fluids.fluid import Fluid, Kink, Rooms
from cranktrain.fluids.state import VolumeLimits
from cranktrain.language import _
from cranktrain.motion import Array, chosen

_Table = TypeVar("_Table", bound=IdealCycleSpec)


def _ideal_kinks(cycle: IdealCycle, limits: VolumeLimits) -> tuple[Kink, ...]:
    """Where heat at constant pressure ends; nowhere without such heat."""
    if not np.any(cycle.cut_off_ratio > 1):
        return ()
    return (Kink(chosen(cycle.cut_off_ratio > 1, cycle.cut_off_ratio * limits.smallest, np.nan), 1.0, 1.0),)


def _suitable(cycle: IdealCycle, rooms: Rooms) -> IdealCycle:
    """Give the cycle as it is; refuse heat that would still come in at the bottom dead centre."""
    if np.any(cycle.cut_off_ratio > rooms.compression_ratio):
        allowed = _("must be at most the compression ratio, {ratio}, or heat comes in beyond the bottom dead centre")
        least = float(np.min(rooms.compression_ratio))
        given = f"{float(np.max(cycle.cut_off_ratio)):g}"
        raise InputError([Problem(f"{rooms.path}.cut_off_ratio", given, allowed.format(ratio=f"{least:.4g}"))])
    return cycle


def _ideal_work(cycle: IdealCycle, rooms: Rooms) -> Array:
    """Work of the cycle in every chamber, in closed form, shape (design, chamber). [J]"""
    mean = ideal_mean_pressures(cycle, rooms.compression_ratio)
    return ((mean.net if rooms.n_turns > 1 else mean.gross) * rooms.swept_volume)[..., 0]


def ideal_fluid(name: str, title: str, spec: type[_Table], example: str) -> Fluid[_Table, IdealCycle, IdealCycle]:
    """An ideal cycle by the table that it has of its own; all else they have in common."""
    return Fluid(
        name=name,
        title=title,
        spec=spec,
        example=example,
        numbers=ideal_cycle,
        prepared=_suitable,
        pressure=ideal_pressure,
        slope=ideal_slope,
        work=_ideal_work,
        flags=cycle_flags,
        kinks=_ideal_kinks,
    )
