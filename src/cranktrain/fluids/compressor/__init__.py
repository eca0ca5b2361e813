"""Compressor with clearance: suction, compression, discharge, re-expansion; one stage or several that share a flow."""

from cranktrain.fluids.compressor.chamber import DISCHARGE_OPENS, SUCTION_OPENS, in_chamber, turn_work, valve_kinks
from cranktrain.fluids.compressor.pressure import (
    Compressor,
    capacity,
    compressor_pressure,
    compressor_slope,
    compressor_work,
    discharge_temperature,
    suction_heating,
)
from cranktrain.fluids.compressor.spec import CompressorSpec, compressor_numbers, stage_problems
from cranktrain.fluids.compressor.stages import staged
from cranktrain.fluids.fluid import Fluid
from cranktrain.language import N_

__all__ = [
    "DISCHARGE_OPENS",
    "KIND",
    "SUCTION_OPENS",
    "Compressor",
    "CompressorSpec",
    "capacity",
    "compressor_work",
    "discharge_temperature",
    "suction_heating",
]

KIND = Fluid(
    name="compressor",
    title=N_("compressor with clearance"),
    spec=CompressorSpec,
    numbers=compressor_numbers,
    problems=stage_problems,
    together=staged,
    prepared=in_chamber,
    pressure=compressor_pressure,
    slope=compressor_slope,
    work=turn_work,
    kinks=valve_kinks,
    fires=False,
    example="""\
[gas]
kind = "compressor"
suction_pressure = "1 bar"        # absolute, as all pressures here; barg, ati and psig are gauge
discharge_pressure = "4.5 bar"
compression_exponent = 1.35
# expansion_exponent = 1.28       # of what is left in the clearance
# suction_loss = 0.03             # by which part of the line's the pressure is less in the chamber
# discharge_loss = 0.03
# suction_temperature = "20 °C"
# molar_mass = "28.9647 g/mol"    # dry air
# standard_temperature = "0 °C"   # of the state at which flow counts as well, with standard_pressure
""",
)
