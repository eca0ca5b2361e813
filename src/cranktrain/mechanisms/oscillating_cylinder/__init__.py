"""Oscillating cylinder: model and paddle-steamer engines, hydraulic motors, cylinders that drive a crank."""

from cranktrain.language import N_
from cranktrain.mechanisms.kind import Kind, Members
from cranktrain.mechanisms.oscillating_cylinder.drawing import oscillating_cylinder_drawing
from cranktrain.mechanisms.oscillating_cylinder.forces import DYNAMICS
from cranktrain.mechanisms.oscillating_cylinder.kinematics import (
    OscillatingCylinder,
    OscillatingCylinderMotion,
    oscillating_cylinder,
    oscillating_cylinder_gap,
)
from cranktrain.mechanisms.oscillating_cylinder.spec import (
    OscillatingCylinderSpec,
    oscillating_cylinder_advice,
    oscillating_cylinder_geometry,
)

__all__ = [
    "KIND",
    "OscillatingCylinder",
    "OscillatingCylinderMotion",
    "OscillatingCylinderSpec",
    "oscillating_cylinder",
]

KIND = Kind(
    name="oscillating_cylinder",
    title=N_("oscillating cylinder on a trunnion"),
    spec=OscillatingCylinderSpec,
    geometry=oscillating_cylinder_geometry,
    motion=oscillating_cylinder,
    gap=oscillating_cylinder_gap,
    lengths=("crank_radius", "ground_length", "offset"),
    output="slider",
    has_rod=False,
    links=("cylinder",),
    drawing=oscillating_cylinder_drawing,
    closing_advice=oscillating_cylinder_advice,
    members=Members,
    stages=(),
    dynamics=DYNAMICS,
    example="""\
[mechanism]
kind = "oscillating_cylinder"
crank_radius = "20 mm"
ground_length = "90 mm"           # shaft centre to trunnion
# offset = "0 mm"                 # of the axis of the cylinder from the trunnion, to the left of its direction
""",
)
