"""The ideal cycles in their chambers: whether they suit them, where heat ends, work over the cycle."""

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.fluids.dual.pressure import IdealCycle, ideal_mean_pressures
from cranktrain.fluids.fluid import Kink, Rooms
from cranktrain.fluids.state import VolumeLimits
from cranktrain.language import _
from cranktrain.motion import Array, chosen


def ideal_kinks(cycle: IdealCycle, limits: VolumeLimits) -> tuple[Kink, ...]:
    """Where heat at constant pressure ends; nowhere without such heat."""
    if not np.any(cycle.cut_off_ratio > 1):
        return ()
    return (Kink(chosen(cycle.cut_off_ratio > 1, cycle.cut_off_ratio * limits.smallest, np.nan), 1.0, 1.0),)


def suitable(cycle: IdealCycle, rooms: Rooms) -> IdealCycle:
    """Give the cycle as it is; refuse heat that would still come in at the bottom dead centre."""
    if np.any(cycle.cut_off_ratio > rooms.compression_ratio):
        allowed = _("must be at most the compression ratio, {ratio}, or heat comes in beyond the bottom dead centre")
        least = float(np.min(rooms.compression_ratio))
        given = f"{float(np.max(cycle.cut_off_ratio)):g}"
        raise InputError([Problem(f"{rooms.path}.cut_off_ratio", given, allowed.format(ratio=f"{least:.4g}"))])
    return cycle


def ideal_work(cycle: IdealCycle, rooms: Rooms) -> Array:
    """Work of the cycle in every chamber, in closed form, shape (design, chamber). [J]"""
    mean = ideal_mean_pressures(cycle, rooms.compression_ratio)
    return ((mean.net if rooms.n_turns > 1 else mean.gross) * rooms.swept_volume)[..., 0]
