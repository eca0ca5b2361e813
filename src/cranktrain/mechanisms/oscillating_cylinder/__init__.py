"""Oscillating cylinder: model and paddle-steamer engines, hydraulic motors, cylinders that drive a crank."""

from pathlib import Path

from cranktrain.language import N_
from cranktrain.linkage import crank_swivel_gap
from cranktrain.mechanisms.by_hand import Handle
from cranktrain.mechanisms.kind import Kind, Members
from cranktrain.mechanisms.oscillating_cylinder.drawing import oscillating_cylinder_drawing
from cranktrain.mechanisms.oscillating_cylinder.forces import DYNAMICS
from cranktrain.mechanisms.oscillating_cylinder.kinematics import OscillatingCylinderMotion, oscillating_cylinder
from cranktrain.mechanisms.oscillating_cylinder.spec import OscillatingCylinderSpec, oscillating_cylinder_advice
from cranktrain.mechanisms.output import PISTON
from cranktrain.mechanisms.rocking_guide import rocking_guide_geometry

__all__ = [
    "KIND",
    "OscillatingCylinderMotion",
    "OscillatingCylinderSpec",
    "oscillating_cylinder",
]

KIND = Kind(
    name="oscillating_cylinder",
    title=N_("oscillating cylinder on a trunnion"),
    spec=OscillatingCylinderSpec,
    geometry=rocking_guide_geometry,
    motion=oscillating_cylinder,
    gap=crank_swivel_gap,
    lengths=("crank_radius", "ground_length", "offset"),
    output=PISTON,
    has_rod=False,
    links=("cylinder",),
    drawing=oscillating_cylinder_drawing,
    closing_advice=oscillating_cylinder_advice,
    closing_field="ground_length",
    members=Members,
    stages=(),
    dynamics=DYNAMICS,
    handles=(Handle("A", ("crank_radius",)), Handle("C", ("ground_length",)), Handle("D", ("offset",))),
    speed="300 rpm",
    tables=Path(__file__).with_name("starting.toml"),
    example="""\
[mechanism]
kind = "oscillating_cylinder"
crank_radius = "20 mm"
ground_length = "90 mm"           # shaft centre to trunnion
# offset = "0 mm"                 # of the axis of the cylinder from the trunnion, to the left of its direction
""",
)
