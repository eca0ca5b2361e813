"""Heat by Wiebe's law: one zone with constant γ, with or without loss to the walls."""

from cranktrain.fluids.fluid import Fluid
from cranktrain.fluids.wiebe.chamber import burning_chambers, chamber_pressure, chamber_slope, chamber_work
from cranktrain.fluids.wiebe.spec import WiebeSpec, wiebe_numbers
from cranktrain.language import N_

__all__ = ["KIND", "WiebeSpec", "burning_chambers", "chamber_pressure", "chamber_work"]

KIND = Fluid(
    name="wiebe",
    title=N_("heat by Wiebe's law, one zone"),
    spec=WiebeSpec,
    numbers=wiebe_numbers,
    prepared=burning_chambers,
    pressure=chamber_pressure,
    slope=chamber_slope,
    work=chamber_work,
    goes_by_time=True,
    breaks=lambda chambers: chambers.burns,
    example="""\
[gas]
kind = "wiebe"
start_pressure = "1.00 bar"       # absolute, as all pressures here; barg, ati and psig are gauge
heat = "1000 J"                   # that one cylinder gets in a cycle
heat_start = "-15 deg"            # from the firing dead centre
heat_duration = "50 deg"
form_factor = 2.0                 # m
# efficiency_factor = 5.0         # a; 6.908 burns 99.9 % of the heat
heat_capacity_ratio = 1.33
# inlet_pressure = "0.95 bar"     # on the inlet stroke
# exhaust_pressure = "1.08 bar"   # on the exhaust stroke
""",
)
