"""Dual cycle (Sabathé, Trinkler): heat first at constant volume, then at constant pressure."""

from cranktrain.fluids.dual.ideal import ideal_fluid
from cranktrain.fluids.dual.pressure import IdealCycle, ideal_mean_pressures, ideal_pressure
from cranktrain.fluids.dual.spec import DualSpec
from cranktrain.language import N_

__all__ = ["KIND", "DualSpec", "IdealCycle", "ideal_mean_pressures", "ideal_pressure"]

KIND = ideal_fluid(
    name="dual",
    title=N_("dual cycle, heat at constant volume and at constant pressure"),
    spec=DualSpec,
    example="""\
[gas]
kind = "dual"
start_pressure = "1.20 bar"       # absolute, as all pressures here; barg, ati and psig are gauge
compression_exponent = 1.36
expansion_exponent = 1.25
pressure_ratio = 1.55             # p3/p2, heat at constant volume
cut_off_ratio = 1.45              # V3/V2, heat at constant pressure
# inlet_pressure = "1.20 bar"     # on the inlet stroke
# exhaust_pressure = "1.10 bar"   # on the exhaust stroke
""",
)
