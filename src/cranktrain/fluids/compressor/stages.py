"""Stages that share one flow: the pressures between them."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.fluids.compressor.chamber import CompressorNumbers, in_chamber
from cranktrain.fluids.compressor.pressure import Compressor, corners
from cranktrain.fluids.fluid import Rooms, table_path
from cranktrain.language import _
from cranktrain.motion import Array
from cranktrain.numerics import bracketed_roots
from cranktrain.quantities import shown


def chain_to(end: str, before: Mapping[str, str]) -> list[str]:
    """Tables of the stages as far as one, the first in front; `before`: which one each takes from."""
    chain = [end]
    while (earlier := before.get(chain[0])) is not None and earlier not in chain:
        chain.insert(0, earlier)
    return chain


class CompressorStage(NamedTuple):
    """One stage: its numbers and the chambers that work in it."""

    numbers: CompressorNumbers
    rooms: Rooms

    def between(self, suction: Array, discharge: Array) -> Compressor:
        """It, between two lines of other pressures, shape (design, 1). [Pa]"""
        lines = {"suction_pressure": suction[..., np.newaxis], "discharge_pressure": discharge[..., np.newaxis]}
        return in_chamber(self.numbers._replace(**lines), self.rooms)

    def flow(self, suction: Array, discharge: Array) -> Array:
        """Σ pV/T that it takes in over a turn, shape (design, 1). [J/K]"""
        compressor, limits = self.between(suction, discharge), self.rooms.limits
        taken = limits.largest - corners(compressor, limits).suction_opens
        return np.sum(compressor.suction_pressure * taken / compressor.temperature, axis=1)

    @property
    def steepest(self) -> Array:
        """Ratio of pressures from which on none of its chambers delivers anything, shape (design, 1)."""
        most = self.rooms.compression_ratio**self.numbers.compression_exponent
        return np.max(most, axis=1) * ((1 - self.numbers.suction_loss) / (1 + self.numbers.discharge_loss))[:, 0]


def interstage_pressures(stages: Sequence[CompressorStage], suction: Array, discharge: Array) -> tuple[Array, ...]:
    """Pressures between stages at which each takes in what the one before delivers.

    Parameters
    ----------
    stages : sequence of CompressorStage
        In the order in which the gas goes through them.
    suction, discharge : Array, shape (design, 1)
        Absolute pressures before the first and behind the last. [Pa]

    Returns
    -------
    tuple of Array, shape (design, 1)
        One for each stage but the last; NaN where they have no flow in common. [Pa]

    Notes
    -----
    λ_v V_h p/T is the same in all stages; docs/theory/gas, eq. (14.21). The more the first delivers against, the less
    flows, and the more the last one takes in: one root.
    """
    *_earlier, last = stages

    def behind(first: Array) -> tuple[Array, ...]:
        """Pressures behind each stage but the last, from that behind the first."""
        flow, found = stages[0].flow(suction, first), [first]
        for stage in stages[1:-1]:
            found.append(_against(stage, found[-1], flow))
        return tuple(found)

    def too_much(log_first: Array) -> Array:
        """By how much more the first delivers than the last takes in; all too much where one between cannot take it."""
        pressures = behind(np.exp(log_first))
        surplus = stages[0].flow(suction, pressures[0]) - last.flow(pressures[-1], discharge)
        return np.where(np.isnan(surplus), 1.0, surplus)

    root = bracketed_roots(too_much, np.log(suction), np.log(discharge))
    return behind(np.exp(root))


def _against(stage: CompressorStage, suction: Array, flow: Array) -> Array:
    """Pressure against which a stage delivers a given flow; NaN where it cannot take it in. [Pa]"""
    low = np.log(suction)
    return np.exp(
        bracketed_roots(lambda log: stage.flow(suction, np.exp(log)) - flow, low, low + np.log(stage.steepest))
    )


def staged(numbers: Sequence[CompressorNumbers], rooms: Sequence[Rooms]) -> tuple[CompressorNumbers, ...]:
    """Find the pressures between the stages of all compressors of a machine.

    Parameters
    ----------
    numbers : sequence of CompressorNumbers
        Of each table; fields of shape (design, 1, 1).
    rooms : sequence of Rooms

    Returns
    -------
    tuple of CompressorNumbers
        The same, with no pressure left to find.

    Raises
    ------
    InputError
        Where stages have no flow in common.
    """
    stages = {room.path: CompressorStage(one, room) for one, room in zip(numbers, rooms, strict=True)}
    names: dict[str, str | None] = {path: one.numbers.takes_from[0, 0, 0] for path, one in stages.items()}
    before = {path: table_path(name) for path, name in names.items() if name is not None}
    found = dict(zip(stages, numbers, strict=True))
    for end in (path for path in stages if path not in before.values()):
        chain = chain_to(end, before)
        if len(chain) == 1:
            continue
        suction, discharge = found[chain[0]].suction_pressure[..., 0], found[end].discharge_pressure[..., 0]
        between = interstage_pressures([stages[path] for path in chain], suction, discharge)
        if np.any(np.isnan(between)):
            allowed = _("has no flow in common with the stage before, at any pressure from {low} to {high} bar")
            low, high = (f"{shown(float(part[0, 0]), 'bar'):.4g}" for part in (suction, discharge))
            repair = _("make its cylinders smaller, or those of the stage before larger")
            raise InputError(
                [Problem(f"{chain[1]}.takes_from", names[chain[1]], allowed.format(low=low, high=high), repair)]
            )
        for path, behind, pressure in zip(chain, chain[1:], between, strict=False):
            found[path] = found[path]._replace(discharge_pressure=pressure[..., np.newaxis])
            found[behind] = found[behind]._replace(suction_pressure=pressure[..., np.newaxis])
    return tuple(found.values())
