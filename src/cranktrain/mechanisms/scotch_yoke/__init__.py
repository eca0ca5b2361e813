"""Scotch yoke: pumps, actuators, testing machines; the slider moves as the cosine of the crank angle."""

from pathlib import Path

from cranktrain.language import N_
from cranktrain.mechanisms.by_hand import Handle
from cranktrain.mechanisms.kind import Kind, Members
from cranktrain.mechanisms.output import PISTON
from cranktrain.mechanisms.scotch_yoke.drawing import scotch_yoke_drawing
from cranktrain.mechanisms.scotch_yoke.forces import DYNAMICS
from cranktrain.mechanisms.scotch_yoke.kinematics import ScotchYoke, ScotchYokeMotion, scotch_yoke, scotch_yoke_gap
from cranktrain.mechanisms.scotch_yoke.spec import ScotchYokeSpec, scotch_yoke_advice, scotch_yoke_geometry

__all__ = ["KIND", "ScotchYoke", "ScotchYokeMotion", "ScotchYokeSpec", "scotch_yoke"]

KIND = Kind(
    name="scotch_yoke",
    title=N_("scotch yoke, a slider with a slot across it"),
    spec=ScotchYokeSpec,
    geometry=scotch_yoke_geometry,
    motion=scotch_yoke,
    gap=scotch_yoke_gap,
    lengths=("crank_radius", "offset"),
    output=PISTON,
    has_rod=False,
    links=(),
    drawing=scotch_yoke_drawing,
    closing_advice=scotch_yoke_advice,
    closing_field="slot_angle",
    members=Members,
    stages=(),
    dynamics=DYNAMICS,
    handles=(Handle("A", ("crank_radius",)), Handle("B", ("offset",))),
    speed="600 rpm",
    tables=Path(__file__).with_name("starting.toml"),
    example="""\
[mechanism]
kind = "scotch_yoke"
crank_radius = "40 mm"
# slot_angle = "90 deg"           # from the line of stroke to the slot, in the sense of rotation
# offset = "0 mm"                 # of the line of stroke, toward +y
""",
    sliders=("block",),
)
