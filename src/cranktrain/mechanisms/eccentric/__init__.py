"""Eccentric: a valve, a pump or a shear driven by a slider-crank of small crank, set ahead of the main one."""

from pathlib import Path
from typing import cast

from cranktrain.language import N_
from cranktrain.mechanisms.by_hand import Handle
from cranktrain.mechanisms.dynamics import Dynamics
from cranktrain.mechanisms.eccentric.drawing import eccentric_drawing
from cranktrain.mechanisms.eccentric.kinematics import Eccentric, eccentric, eccentric_gap, eccentric_least_gap
from cranktrain.mechanisms.eccentric.spec import EccentricSpec, eccentric_advice, eccentric_geometry
from cranktrain.mechanisms.kind import Kind, Members
from cranktrain.mechanisms.output import VALVE
from cranktrain.mechanisms.slider_crank.forces import DYNAMICS
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrankMotion

__all__ = ["KIND", "Eccentric", "EccentricSpec", "eccentric"]

KIND = Kind(
    name="eccentric",
    title=N_("eccentric that drives a valve"),
    spec=EccentricSpec,
    geometry=eccentric_geometry,
    motion=eccentric,
    gap=eccentric_gap,
    least_gap=eccentric_least_gap,
    lengths=("crank_radius", "rod_length", "offset"),
    length_paths=("eccentricity", "rod_length", "offset"),
    output=VALVE,
    has_rod=True,
    links=("rod",),
    drawing=eccentric_drawing,
    # The forces read of a geometry what a slider-crank has.
    dynamics=cast("Dynamics[SliderCrankMotion, Eccentric]", DYNAMICS),
    closing_advice=eccentric_advice,
    members=Members,
    stages=(),
    has_own_pin=True,
    handles=(
        Handle("A", ("eccentricity", "angle_of_advance", "angle_ahead")),
        Handle("B", ("rod_length", "offset")),
    ),
    speed="90 rpm",
    tables=Path(__file__).with_name("starting.toml"),
    example="""\
[mechanism]
kind = "eccentric"
eccentricity = "60 mm"            # half of the valve's travel, nearly
rod_length = "1400 mm"
angle_of_advance = "30 deg"       # beyond the right angle from the crank; or angle_ahead = "120 deg", from the crank
admission = "outside"             # or "inside": then the eccentric stands half a turn away
# offset = "0 mm"
""",
)
