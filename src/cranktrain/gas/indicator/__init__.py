"""Indicator diagram: a measured or computed trace of pressure over crank angle, volume or displacement."""

from cranktrain.gas.indicator.diagram import Diagram, diagram_work, pressure_at
from cranktrain.gas.indicator.model import indicator_diagram, indicator_pressure
from cranktrain.gas.indicator.spec import IndicatorSpec
from cranktrain.gas.kind import GasKind
from cranktrain.language import N_

__all__ = ["KIND", "Diagram", "IndicatorSpec", "diagram_work", "indicator_diagram", "pressure_at"]

KIND = GasKind(
    name="indicator",
    title=N_("indicator diagram from a file"),
    spec=IndicatorSpec,
    model=indicator_diagram,
    pressure=indicator_pressure,
    work=diagram_work,
    breaks=lambda diagram: diagram.curve.places,
    flags=lambda spec, diagram: (*diagram.flags, *diagram.findings),
    example="""\
[gas]
kind = "indicator"
file = "trace.csv"                # beside this file; two columns, crank angle (or volume) and pressure
# pressure_unit = "bar"           # where the file's header does not say it
# pressure = "gauge"              # unless given, as the header says, or else absolute
# firing_angle = "360 deg"        # of the file; unless given, found by the peak
# sense = "found"                 # turns a file round that counts against the rotation

# [gas.peg]                       # the level, which a sensor does not know
# exponent = 1.35                 # of the compression between -100 and -65 deg
""",
)
