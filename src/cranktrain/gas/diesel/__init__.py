"""Diesel cycle: heat at constant pressure."""

from cranktrain.gas.diesel.spec import DieselSpec
from cranktrain.gas.dual.pressure import ideal_kinks, ideal_mean_pressures, ideal_pressure
from cranktrain.gas.dual.spec import cycle_flags, ideal_cycle
from cranktrain.gas.kind import GasKind
from cranktrain.language import N_

__all__ = ["KIND", "DieselSpec"]

KIND = GasKind(
    name="diesel",
    title=N_("Diesel cycle, heat at constant pressure"),
    spec=DieselSpec,
    model=ideal_cycle,
    pressure=ideal_pressure,
    flags=cycle_flags,
    mean_pressures=ideal_mean_pressures,
    kinks=ideal_kinks,
    example="""\
[gas]
kind = "diesel"
start_pressure = "110 kPa"        # absolute, as all pressures here; barg, ati and psig are gauge
compression_exponent = 1.36
expansion_exponent = 1.26
cut_off_ratio = 2.1               # V3/V2
# inlet_pressure = "110 kPa"      # on the inlet stroke
# exhaust_pressure = "115 kPa"    # on the exhaust stroke
""",
)
