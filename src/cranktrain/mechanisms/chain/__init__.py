"""Chain: any linkage of groups on one shaft, as its file composes it."""

from pathlib import Path

from cranktrain.language import N_
from cranktrain.mechanisms.chain.adding import ADDITIONS
from cranktrain.mechanisms.chain.composed import fields_of, kind_of_structure
from cranktrain.mechanisms.chain.drawing import chain_drawing
from cranktrain.mechanisms.chain.gaps import chain_gap
from cranktrain.mechanisms.chain.kinematics import ChainMotion, chain_motion
from cranktrain.mechanisms.chain.spec import ChainSpec
from cranktrain.mechanisms.chain.steps import ChainSize, SlideStep, Structure
from cranktrain.mechanisms.chain.table import chain_geometry, structure_of
from cranktrain.mechanisms.kind import Kind, Members

__all__ = ["KIND", "ChainMotion", "ChainSize", "ChainSpec", "chain_drawing", "chain_gap", "chain_motion"]


_SIMPLEST = Structure(("main",), (), (SlideStep("main.pin", "rod", "slider", "O"),), "slider")
"""A slider-crank; in its place stands the chain that the file has."""

KIND = Kind(
    name="chain",
    title=N_("chain, any linkage of groups on a crank"),
    spec=ChainSpec,
    geometry=chain_geometry,
    has_rod=False,
    members=Members,
    stages=(),
    structure_of=structure_of,
    of_structure=lambda structure: kind_of_structure(KIND, fields_of, structure),
    additions=ADDITIONS,
    **fields_of(_SIMPLEST),
    speed="40 rpm",
    tables=Path(__file__).with_name("starting.toml"),
    example="""\
[mechanism]
kind = "chain"                    # angles count from x toward y; the crank turns that way
output = "ram"                    # the slider or link that the load acts on

[mechanism.fixed]
C = ["300 mm", "400 mm"]

[mechanism.crank.main]            # gives the point main.pin; another crank is an eccentric, angle = ahead of main
radius = "50 mm"

[[mechanism.part]]                # a part uses only names that stand above it
type = "pin"                      # pin, slide, swivel, yoke, trammel, triad, point
rod = { name = "pitman", from = "main.pin", length = "400 mm" }
rocker = { name = "lever", from = "C", length = "250 mm" }
joint = "B"
side = "right"                    # of the line from the rod's first pin to the rocker's

[[mechanism.part]]
type = "slide"
rod = { name = "link", from = "B", length = "250 mm" }
slider = "ram"                    # gives the point ram.pin
guide = { through = "C", direction = "-90 deg", offset = "0 mm" }
side = "ahead"                    # the slider lies after the foot of B along the direction

# [mechanism.points.G]            # a point on a link to follow
# link = "pitman"
# along = "200 mm"
# across = "0 mm"
""",
)
