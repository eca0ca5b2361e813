"""Articulated rod: slave rods on one master rod, in V, W and radial engines."""

from pathlib import Path

from cranktrain.language import N_
from cranktrain.mechanisms.articulated_rod.drawing import articulated_rod_drawing
from cranktrain.mechanisms.articulated_rod.facts import ArticulatedRods, articulation
from cranktrain.mechanisms.articulated_rod.forces import DYNAMICS
from cranktrain.mechanisms.articulated_rod.kinematics import (
    ArticulatedRod,
    ArticulatedRodMotion,
    articulated_rod,
    articulated_rod_gap,
)
from cranktrain.mechanisms.articulated_rod.spec import (
    ArticulatedRodSpec,
    articulated_rod_advice,
    articulated_rod_geometry,
)
from cranktrain.mechanisms.by_hand import Handle
from cranktrain.mechanisms.kind import Kind
from cranktrain.mechanisms.output import PISTON

__all__ = ["KIND", "ArticulatedRod", "ArticulatedRodMotion", "ArticulatedRodSpec", "articulated_rod"]

KIND = Kind(
    name="articulated_rod",
    title=N_("articulated rod on a master rod"),
    spec=ArticulatedRodSpec,
    geometry=articulated_rod_geometry,
    motion=articulated_rod,
    gap=articulated_rod_gap,
    lengths=("master.crank_radius", "master.rod_length", "master.offset", "knuckle_radius", "rod_length", "offset"),
    output=PISTON,
    has_rod=True,
    links=("rod",),
    drawing=articulated_rod_drawing,
    closing_advice=articulated_rod_advice,
    members=ArticulatedRods,
    stages=(articulation,),
    dynamics=DYNAMICS,
    is_slave=True,
    is_outlined=True,
    handles=(Handle("C", ("knuckle_radius", "articulation_angle")), Handle("D", ("rod_length", "offset"))),
    speed="1500 rpm",
    tables=Path(__file__).with_name("starting.toml"),
    example="""\
[bank.L]
angle = "-30 deg"

[bank.L.mechanism]
kind = "slider_crank"
crank_radius = "90 mm"
rod_length = "320 mm"

[bank.R]
angle = "30 deg"

[bank.R.mechanism]
kind = "articulated_rod"
master = "L"                      # the bank whose rod, on the same throw, carries the knuckle pin
knuckle_radius = "80 mm"          # crank pin to knuckle pin
rod_length = "240 mm"
articulation_angle = "67 deg"     # from the master rod to the knuckle radius, in the sense of rotation
# offset = "0 mm"
""",
)
