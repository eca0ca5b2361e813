"""Slotted lever: shapers and slotters; a longer crank than ground is the quick return that Whitworth built."""

from pathlib import Path

from cranktrain.language import N_
from cranktrain.linkage import crank_swivel_gap
from cranktrain.mechanisms.by_hand import Handle
from cranktrain.mechanisms.kind import Kind, Members
from cranktrain.mechanisms.output import ROCKER
from cranktrain.mechanisms.rocking_guide import rocking_guide_geometry
from cranktrain.mechanisms.slotted_lever.drawing import slotted_lever_drawing
from cranktrain.mechanisms.slotted_lever.forces import DYNAMICS
from cranktrain.mechanisms.slotted_lever.kinematics import SlottedLeverMotion, slotted_lever
from cranktrain.mechanisms.slotted_lever.spec import SlottedLeverSpec, slotted_lever_advice

__all__ = ["KIND", "SlottedLeverMotion", "SlottedLeverSpec", "slotted_lever"]

KIND = Kind(
    name="slotted_lever",
    title=N_("slotted lever, rocking or turning (Whitworth)"),
    spec=SlottedLeverSpec,
    geometry=rocking_guide_geometry,
    motion=slotted_lever,
    gap=crank_swivel_gap,
    lengths=("crank_radius", "ground_length", "offset"),
    output=ROCKER,
    has_rod=False,
    links=("rocker",),
    drawing=slotted_lever_drawing,
    closing_advice=slotted_lever_advice,
    closing_field="ground_length",
    members=Members,
    stages=(),
    dynamics=DYNAMICS,
    handles=(Handle("A", ("crank_radius",)), Handle("C", ("ground_length",)), Handle("B", ("offset",))),
    speed="30 rpm",
    tables=Path(__file__).with_name("starting.toml"),
    example="""\
[mechanism]
kind = "slotted_lever"
crank_radius = "100 mm"
ground_length = "250 mm"          # shaft centre to pivot; shorter than the crank, the lever turns all round
# offset = "0 mm"                 # of the line of the slot from the pivot, to the left of its direction
""",
    sliders=("block",),
)
