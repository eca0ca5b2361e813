"""What compressors take in and deliver: between which pressures, how much of the swept volume, how much in a second."""

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from cranktrain.fluids import VolumeLimits
from cranktrain.language import N_, Words, _
from cranktrain.layout.speed import Speed
from cranktrain.motion import Array
from cranktrain.numerics.harmonics import TURN
from cranktrain.questions.gas.chambers import Filling, GasInChambers
from cranktrain.questions.gas.declared import DeclaredGas
from cranktrain.record import record
from cranktrain.references import THEORY_OF_GAS as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import Flagged
from cranktrain.saying.wording import ranged

if TYPE_CHECKING:
    from cranktrain.fluids.compressor import Compressor

_CHAMBER = ("chamber",)


@record
class CompressorCapacity(Flagged):
    """What each chamber of a compressor takes in; NaN of chambers with another gas."""

    suction_line_pressure: Array = quantity(
        "p_s",
        "Pa",
        _CHAMBER,
        N_("Absolute pressure of the line that a compressor's chamber takes from"),
        _THEORY,
        "14.21",
    )
    discharge_line_pressure: Array = quantity(
        "p_d", "Pa", _CHAMBER, N_("Absolute pressure of the line that it delivers into"), _THEORY, "14.21"
    )
    volumetric_efficiency: Array = quantity(
        "λ_v",
        "1",
        _CHAMBER,
        N_("Part of the swept volume that it takes in, as the gas is in the chamber"),
        _THEORY,
        "14.18",
    )
    suction_end_temperature: Array = quantity(
        "T_1", "K", _CHAMBER, N_("Temperature at the end of suction, with which the masses close"), _THEORY, "14.20"
    )


def has_compressors(gas: DeclaredGas) -> bool:
    """Say whether any chamber is a compressor's."""
    return any(table.fluid.name == "compressor" for table in gas.tables)


def compressor_capacity(gas: GasInChambers) -> CompressorCapacity:
    """Capacity by the exponent of re-expansion; docs/theory/gas, eqs. (14.18) and (14.20)."""
    from cranktrain.fluids.compressor import capacity, suction_heating  # for machines that have one

    compressors = gas.filled_with("compressor")

    def by_chamber(value: "Callable[[Compressor, VolumeLimits], Array]") -> Array:
        return gas.by_chamber((one, value(one.ready, one.rooms.limits)[..., 0]) for one in compressors)

    part = by_chamber(capacity)
    return CompressorCapacity(
        suction_line_pressure=by_chamber(lambda compressor, limits: compressor.line_pressure),
        discharge_line_pressure=by_chamber(lambda compressor, limits: compressor.discharge_line),
        volumetric_efficiency=part,
        suction_end_temperature=by_chamber(
            lambda compressor, limits: compressor.temperature * suction_heating(compressor, limits)
        ),
        flags=tuple(flag for one in compressors for flag in _flags(gas, one, part[:, one.places])),
    )


def _flags(gas: GasInChambers, one: Filling, part: Array) -> list[Words]:
    """Flag chambers that deliver nothing, and exponents with which no cycle is steady."""
    from cranktrain.fluids.compressor.chamber import steady_exponents

    idle = one.places[np.any(part == 0.0, axis=0)].tolist()
    unsteady = one.places[np.any(~steady_exponents(one.ready, one.rooms.limits)[..., 0], axis=0)].tolist()
    said = {
        _("The discharge valve of {chambers} stays shut: the clearance takes up all that is compressed."): idle,
        _("No cycle of {chambers} is steady with two exponents: expansion_exponent is taken as the other."): unsteady,
    }
    return [text.format(chambers=ranged(gas.chambers.names, places)) for text, places in said.items() if places]


@record
class CompressorFlow:
    """What the compressors of a machine move at the mean speed."""

    inlet_flow: Array = quantity(
        "Q_s", "m^3/s", _CHAMBER, N_("Volume taken in, as the gas is in the line it comes from"), _THEORY, "14.27"
    )


def compressor_flow(gas: GasInChambers, capacities: CompressorCapacity, speed: Speed) -> CompressorFlow:
    """Volume as it is in the line: with a loss δ, λ_v (1 − δ) of the swept volume a turn."""

    def of_stage(one: Filling) -> Array:
        thinner = one.ready.suction_pressure / one.ready.line_pressure
        taken = capacities.volumetric_efficiency[:, one.places, np.newaxis] * one.rooms.swept_volume * thinner
        return (taken * speed.mean / TURN)[..., 0]

    return CompressorFlow(gas.by_chamber((one, of_stage(one)) for one in gas.filled_with("compressor")))
