"""Kernels: the driver and the groups that hang on it, exact and elementwise, with first and second derivatives.

A kernel takes its driver (an angle, a point, a link) and its geometry, a NamedTuple of numbers or arrays, and gives a
NamedTuple of coefficients. It has no state, no checks, no units; what cannot close is NaN. `triad_walk`, `pose_at` and
`triad_modes` are no kernels: they supply the triad's kernel with its starts.
"""

from cranktrain.linkage.blocks import in_blocks
from cranktrain.linkage.compile import compiled
from cranktrain.linkage.crank import Crank, crank
from cranktrain.linkage.legs import OnLine, block_along, fixed_guide, rod_between, rod_end
from cranktrain.linkage.modes import triad_modes
from cranktrain.linkage.pin import (
    CentreLine,
    CrankAndGround,
    Pin,
    PinMotion,
    line_between,
    line_from_crank,
    pin,
    pin_from_crank,
    pin_gap,
)
from cranktrain.linkage.point import Ends, LinkPoint, fixed, point, turned
from cranktrain.linkage.slide import AHEAD, Slide, SlideMotion, slide, slide_gap
from cranktrain.linkage.swivel import (
    CrankAndPivot,
    Swivel,
    SwivelMotion,
    crank_swivel_gap,
    swivel,
    swivel_gap,
)
from cranktrain.linkage.trammel import Trammel, TrammelMotion, trammel, turned_link
from cranktrain.linkage.triad import GUIDE, ROD, Leg, Pose, Triad, TriadDriver, TriadEnds, TriadMotion, triad
from cranktrain.linkage.walk import Walk, pose_at, triad_walk
from cranktrain.linkage.yoke import Yoke, YokeMotion, yoke

__all__ = [
    "AHEAD",
    "GUIDE",
    "ROD",
    "CentreLine",
    "Crank",
    "CrankAndGround",
    "CrankAndPivot",
    "Ends",
    "Leg",
    "LinkPoint",
    "OnLine",
    "Pin",
    "PinMotion",
    "Pose",
    "Slide",
    "SlideMotion",
    "Swivel",
    "SwivelMotion",
    "Trammel",
    "TrammelMotion",
    "Triad",
    "TriadDriver",
    "TriadEnds",
    "TriadMotion",
    "Walk",
    "Yoke",
    "YokeMotion",
    "block_along",
    "compiled",
    "crank",
    "crank_swivel_gap",
    "fixed",
    "fixed_guide",
    "in_blocks",
    "line_between",
    "line_from_crank",
    "pin",
    "pin_from_crank",
    "pin_gap",
    "point",
    "pose_at",
    "rod_between",
    "rod_end",
    "slide",
    "slide_gap",
    "swivel",
    "swivel_gap",
    "trammel",
    "triad",
    "triad_modes",
    "triad_walk",
    "turned",
    "turned_link",
    "yoke",
]
