"""Slider-crank: piston engines, compressors, pumps, presses, eccentrics; central or offset."""

from pathlib import Path

from cranktrain.language import N_
from cranktrain.mechanisms.by_hand import Handle
from cranktrain.mechanisms.kind import Kind, Members
from cranktrain.mechanisms.output import PISTON
from cranktrain.mechanisms.slider_crank.drawing import slider_crank_drawing
from cranktrain.mechanisms.slider_crank.forces import DYNAMICS
from cranktrain.mechanisms.slider_crank.kinematics import (
    SliderCrank,
    SliderCrankMotion,
    slider_crank,
    slider_crank_gap,
    slider_crank_least_gap,
)
from cranktrain.mechanisms.slider_crank.spec import (
    RODS,
    SliderCrankSpec,
    slider_crank_advice,
    slider_crank_geometry,
    slider_crank_ratio,
    slider_crank_rod_field,
)

__all__ = ["KIND", "SliderCrank", "SliderCrankMotion", "SliderCrankSpec", "slider_crank"]

KIND = Kind(
    name="slider_crank",
    title=N_("slider-crank, central or offset"),
    spec=SliderCrankSpec,
    geometry=slider_crank_geometry,
    motion=slider_crank,
    gap=slider_crank_gap,
    least_gap=slider_crank_least_gap,
    lengths=("crank_radius", "rod_length", "offset"),
    output=PISTON,
    has_rod=True,
    links=("rod",),
    drawing=slider_crank_drawing,
    closing_advice=slider_crank_advice,
    closing_field=slider_crank_rod_field,
    members=Members,
    stages=(),
    dynamics=DYNAMICS,
    direct_ratio=slider_crank_ratio,
    is_outlined=True,
    handles=(Handle("A", ("crank_radius", "stroke")), Handle("B", (*RODS, "offset"))),
    speed="1500 rpm",
    tables=Path(__file__).with_name("starting.toml"),
    example="""\
[mechanism]
kind = "slider_crank"
crank_radius = "40 mm"            # or stroke = "80 mm"
rod_length = "136 mm"             # or crank_to_rod_ratio = 0.294, or rod_to_crank_ratio = 3.4
# offset = "0 mm"                 # > 0: the line of stroke lies toward +y
# permissible_pressure_angle = "20 deg"  # of the rod; only said where it is more

# [mechanism.points.balance]      # a point on the rod to follow
# link = "rod"
# along = "36 mm"
# across = "0 mm"
""",
)
