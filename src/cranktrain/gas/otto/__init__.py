"""Otto cycle: heat at constant volume."""

from cranktrain.gas.dual.pressure import ideal_mean_pressures, ideal_pressure
from cranktrain.gas.dual.spec import cycle_flags, ideal_cycle
from cranktrain.gas.kind import GasKind
from cranktrain.gas.otto.spec import OttoSpec
from cranktrain.language import N_

__all__ = ["KIND", "OttoSpec"]

KIND = GasKind(
    name="otto",
    title=N_("Otto cycle, heat at constant volume"),
    spec=OttoSpec,
    model=ideal_cycle,
    pressure=ideal_pressure,
    flags=cycle_flags,
    mean_pressures=ideal_mean_pressures,
    example="""\
[gas]
kind = "otto"
start_pressure = "95 kPa"         # absolute, as all pressures here; barg, ati and psig are gauge
compression_exponent = 1.34
expansion_exponent = 1.27
pressure_ratio = 3.6              # p3/p2
# inlet_pressure = "95 kPa"       # on the inlet stroke
# exhaust_pressure = "108 kPa"    # on the exhaust stroke
""",
)
