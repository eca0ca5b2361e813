"""Otto cycle: heat at constant volume."""

from cranktrain.fluids.dual.ideal import ideal_fluid
from cranktrain.fluids.otto.spec import OttoSpec
from cranktrain.language import N_

__all__ = ["KIND", "OttoSpec"]

KIND = ideal_fluid(
    name="otto",
    title=N_("Otto cycle, heat at constant volume"),
    spec=OttoSpec,
    example="""\
[gas]
kind = "otto"
start_pressure = "0.95 bar"       # absolute, as all pressures here; barg, ati and psig are gauge
compression_exponent = 1.34
expansion_exponent = 1.27
pressure_ratio = 3.6              # p3/p2
# inlet_pressure = "0.95 bar"     # on the inlet stroke
# exhaust_pressure = "1.08 bar"   # on the exhaust stroke
""",
)
