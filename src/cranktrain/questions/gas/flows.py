"""What compressors take in and deliver: between which pressures, how much, how warm, and the power that it takes."""

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from cranktrain.fluids import VolumeLimits
from cranktrain.fluids.work import indicated_power
from cranktrain.language import N_, Words, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.speed import Speed
from cranktrain.motion import Array
from cranktrain.numerics.harmonics import TURN
from cranktrain.paths import quantity_path
from cranktrain.questions.cylinders.firing import Cycle
from cranktrain.questions.gas.chambers import Filling, GasInChambers
from cranktrain.questions.gas.declared import DeclaredGas
from cranktrain.questions.gas.events import GasEvents
from cranktrain.questions.gas.pressures import GasPressures
from cranktrain.record import record
from cranktrain.references import THEORY_OF_GAS as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import Flagged, StageResult
from cranktrain.saying.wording import ranged

if TYPE_CHECKING:
    from cranktrain.fluids.compressor import Compressor

_CHAMBER = ("chamber",)
_STAGE = ("gas_stage",)
GAS_CONSTANT = 8.31446261815324
"""Exact by the definitions of 2019. [J/(mol·K)]"""


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
    discharge_temperature: Array = quantity(
        "T_2", "K", _CHAMBER, N_("Temperature of the gas that is delivered"), _THEORY, "14.28"
    )
    suction_opening_angle: Array = quantity(
        "φ_s", "deg", _CHAMBER, N_("Crank angle at which the suction valve opens"), _THEORY, "14.17", is_place=True
    )
    discharge_opening_angle: Array = quantity(
        "φ_d", "deg", _CHAMBER, N_("Crank angle at which the discharge valve opens"), _THEORY, "14.17", is_place=True
    )


def has_compressors(gas: DeclaredGas) -> bool:
    """Say whether any chamber is a compressor's."""
    return any(table.fluid.name == "compressor" for table in gas.tables)


def compressor_capacity(gas: GasInChambers, events: GasEvents, crank_angle: CrankAngle) -> CompressorCapacity:
    """Capacity by the exponent of re-expansion, temperatures, and where valves open.

    Notes
    -----
    docs/theory/gas, eqs. (14.17), (14.18), (14.20) and (14.28).
    """
    from cranktrain.fluids.compressor import (  # for machines that have one
        DISCHARGE_OPENS,
        SUCTION_OPENS,
        capacity,
        discharge_temperature,
        suction_heating,
    )

    compressors = gas.filled_with("compressor")

    def by_chamber(value: "Callable[[Compressor, VolumeLimits], Array]") -> Array:
        return gas.by_chamber((one, value(one.ready, one.rooms.limits)[..., 0]) for one in compressors)

    def opens(called: str) -> Array:
        return crank_angle.counted(events.named[called][..., np.newaxis])[..., 0]

    part = by_chamber(capacity)
    return CompressorCapacity(
        suction_line_pressure=by_chamber(lambda compressor, limits: compressor.line_pressure),
        discharge_line_pressure=by_chamber(lambda compressor, limits: compressor.discharge_line),
        volumetric_efficiency=part,
        suction_end_temperature=by_chamber(
            lambda compressor, limits: compressor.temperature * suction_heating(compressor, limits)
        ),
        discharge_temperature=by_chamber(discharge_temperature),
        suction_opening_angle=opens(SUCTION_OPENS),
        discharge_opening_angle=opens(DISCHARGE_OPENS),
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
    """What each chamber of a compressor moves at the mean speed; NaN of chambers with another gas."""

    inlet_flow: Array = quantity(
        "Q_s", "m^3/s", _CHAMBER, N_("Volume taken in, as the gas is in the line it comes from"), _THEORY, "14.27"
    )
    mass_flow: Array = quantity("ṁ", "kg/s", _CHAMBER, N_("Mass that it moves"), _THEORY, "14.29")
    standard_flow: Array = quantity(
        "Q_n",
        "m^3/s",
        _CHAMBER,
        N_("Volume of what it moves, at standard_pressure and standard_temperature"),
        _THEORY,
        "14.29",
    )


def compressor_flow(
    gas: GasInChambers, declared: DeclaredGas, capacities: CompressorCapacity, speed: Speed
) -> CompressorFlow:
    """Volume as it is in the line, λ_v (1 − δ) of the swept volume a turn, and its mass; docs/theory/gas, eq. (14.29).

    The gas is an ideal one.
    """

    def of_stage(one: Filling) -> tuple[Array, Array, Array]:
        compressor, numbers = one.ready, declared.numbers(one.rooms.path)
        part = capacities.volumetric_efficiency[:, one.places, np.newaxis]
        thinner = compressor.suction_pressure / compressor.line_pressure
        volume = part * one.rooms.swept_volume * thinner * (speed.mean / TURN)
        specific = GAS_CONSTANT / numbers.molar_mass
        mass = compressor.line_pressure * volume / (specific * compressor.temperature)
        return volume, mass, mass * specific * numbers.standard_temperature / numbers.standard_pressure

    each = [(one, of_stage(one)) for one in gas.filled_with("compressor")]
    return CompressorFlow(*(gas.by_chamber((one, found[part][..., 0]) for one, found in each) for part in range(3)))


@record
class CompressorStages(StageResult):
    """What stages of compressors move and take, each that of the chambers of one table, and what they do in all."""

    stage_inlet_flow: Array = quantity(
        "Q_j", "m^3/s", _STAGE, N_("Volume that the stage takes in, as the gas is in its line"), _THEORY, "14.30"
    )
    stage_mass_flow: Array = quantity("ṁ_j", "kg/s", _STAGE, N_("Mass that the stage moves"), _THEORY, "14.30")
    stage_standard_flow: Array = quantity(
        "Q_nj",
        "m^3/s",
        _STAGE,
        N_("Volume of what the stage moves, at standard_pressure and standard_temperature"),
        _THEORY,
        "14.30",
    )
    stage_power: Array = quantity("P_j", "W", _STAGE, N_("Power that the gas of the stage takes"), _THEORY, "14.30")
    total_inlet_flow: Array = quantity(
        "Q", "m^3/s", (), N_("Volume taken in by all first stages, as the gas is in their lines"), _THEORY, "14.30"
    )
    total_mass_flow: Array = quantity("ṁ_Σ", "kg/s", (), N_("Mass taken in by all first stages"), _THEORY, "14.30")
    total_standard_flow: Array = quantity(
        "Q_nΣ",
        "m^3/s",
        (),
        N_("Volume of what all first stages take in, at standard_pressure and standard_temperature"),
        _THEORY,
        "14.30",
    )
    specific_power: Array = quantity(
        "P/Q", "J/m^3", (), N_("Power that the gas of all stages takes, over what the first take in"), _THEORY, "14.30"
    )


def compressor_stages(
    gas: GasInChambers, declared: DeclaredGas, flow: CompressorFlow, pressures: GasPressures, cycle: Cycle, speed: Speed
) -> CompressorStages:
    """Sums over the chambers of each table, and over the tables that take from no other; docs/theory/gas, (14.30)."""
    stages = gas.filled_with("compressor")
    powers = -indicated_power(pressures.indicated_work, np.array(cycle.length), speed.mean[..., 0])
    each = (flow.inlet_flow, flow.mass_flow, flow.standard_flow, powers)
    by_stage = [np.stack([np.sum(part[:, one.places], axis=-1) for one in stages], axis=-1) for part in each]
    is_first = [declared.numbers(one.rooms.path).takes_from.flat[0] is None for one in stages]
    *taken_in, power = by_stage
    total = [np.sum(part[:, is_first], axis=-1) for part in taken_in]
    names = tuple(str(quantity_path(one.rooms.path)[-1]) for one in stages)
    return CompressorStages(
        *by_stage,
        *total,
        specific_power=np.sum(power, axis=-1) / np.where(total[0] > 0, total[0], np.nan),
        labels={"gas_stage": names},
    )
