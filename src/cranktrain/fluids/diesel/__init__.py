"""Diesel cycle: heat at constant pressure."""

from cranktrain.fluids.diesel.spec import DieselSpec
from cranktrain.fluids.dual.ideal import ideal_fluid
from cranktrain.language import N_

__all__ = ["KIND", "DieselSpec"]

KIND = ideal_fluid(
    name="diesel",
    title=N_("Diesel cycle, heat at constant pressure"),
    spec=DieselSpec,
    example="""\
[gas]
kind = "diesel"
start_pressure = "1.10 bar"       # absolute, as all pressures here; barg, ati and psig are gauge
compression_exponent = 1.36
expansion_exponent = 1.26
cut_off_ratio = 2.1               # V3/V2
# inlet_pressure = "1.10 bar"     # on the inlet stroke
# exhaust_pressure = "1.15 bar"   # on the exhaust stroke
""",
)
