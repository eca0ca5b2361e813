"""Indicator diagram: a measured or computed trace of pressure over crank angle, volume or displacement."""

from cranktrain.fluids.fluid import Fluid
from cranktrain.fluids.indicator.cards import card_breaks, card_notes, card_pressure, card_slope, card_work, diagrams_of
from cranktrain.fluids.indicator.diagram import Diagram, diagram_work, pressure_at
from cranktrain.fluids.indicator.model import indicator_diagram
from cranktrain.fluids.indicator.spec import IndicatorSpec, card_of
from cranktrain.language import N_

__all__ = ["KIND", "Diagram", "IndicatorSpec", "card_of", "diagram_work", "indicator_diagram", "pressure_at"]

KIND = Fluid(
    name="indicator",
    title=N_("indicator diagram from a file"),
    spec=IndicatorSpec,
    numbers=card_of,
    prepared=diagrams_of,
    pressure=card_pressure,
    slope=card_slope,
    work=card_work,
    notes=card_notes,
    breaks=card_breaks,
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
