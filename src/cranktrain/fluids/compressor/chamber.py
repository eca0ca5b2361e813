"""A compressor's table in its chambers: pressures as they are inside, where valves open, work over the cycle."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.fluids.compressor.pressure import Compressor, compressor_work, corners
from cranktrain.fluids.fluid import Kink, Rooms
from cranktrain.fluids.state import VolumeLimits
from cranktrain.motion import Array

SUCTION_OPENS, DISCHARGE_OPENS = "suction opens", "discharge opens"
"""What happens at kinks of its pressure."""


class CompressorNumbers(NamedTuple):
    """What a machine file's table says: pressures of the lines, NaN to be found [Pa]; exponents, losses [1]; [K].

    takes_from: the stage before, if any. molar_mass [kg/mol]; standard_pressure, standard_temperature: at which the
    standard flow counts [Pa, K].
    """

    suction_pressure: Any
    discharge_pressure: Any
    compression_exponent: Any
    expansion_exponent: Any
    suction_loss: Any
    discharge_loss: Any
    suction_temperature: Any
    takes_from: Any
    molar_mass: Any
    standard_pressure: Any
    standard_temperature: Any


def in_chamber(numbers: CompressorNumbers, rooms: Rooms) -> Compressor:
    """Pressures as they are in the chamber while a valve is open."""
    del rooms
    return Compressor(
        suction_pressure=numbers.suction_pressure * (1 - numbers.suction_loss),
        discharge_pressure=numbers.discharge_pressure * (1 + numbers.discharge_loss),
        compression_exponent=numbers.compression_exponent,
        expansion_exponent=numbers.expansion_exponent,
        line_pressure=numbers.suction_pressure,
        temperature=numbers.suction_temperature,
        discharge_line=numbers.discharge_pressure,
    )


def valve_kinks(compressor: Compressor, limits: VolumeLimits) -> tuple[Kink, ...]:
    """Where suction and discharge valves open, in every turn; nowhere if nothing is delivered."""
    found = corners(compressor, limits)
    delivers = found.discharge_opens > limits.smallest
    opens = ((found.suction_opens, 1.0, SUCTION_OPENS), (found.discharge_opens, -1.0, DISCHARGE_OPENS))
    return tuple(
        Kink(np.where(delivers, volume, np.nan), sense, turn, called)
        for volume, sense, called in opens
        for turn in (1.0, -1.0)
    )


def steady_exponents(compressor: Compressor, limits: VolumeLimits) -> NDArray[np.bool_]:
    """Whether there is a cycle with both exponents, or none with any: above neither of r^n_c and r^n_e, or both."""
    ratio, rise = limits.largest / limits.smallest, compressor.discharge_pressure / compressor.suction_pressure
    return (ratio**compressor.compression_exponent > rise) == (ratio**compressor.expansion_exponent > rise)


def turn_work(compressor: Compressor, rooms: Rooms) -> Array:
    """Work over the cycle of the machine, shape (design, chamber). [J]"""
    return compressor_work(compressor, rooms.limits)[..., 0] * rooms.n_turns
