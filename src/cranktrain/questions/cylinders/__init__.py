"""Cylinders: how their pistons make room, what that holds, their ports, and when they fire."""

from cranktrain.language import N_
from cranktrain.layout.question import Dimension, Question, Stage, Use
from cranktrain.layout.uses import keys
from cranktrain.questions.cylinders.firing import Firing, firing
from cranktrain.questions.cylinders.opposed import (
    are_opposed,
    combined_motion,
    combined_speeds,
    volumetric_dead_centres,
)
from cranktrain.questions.cylinders.parts import parts, problems
from cranktrain.questions.cylinders.ports import PortTiming, effective_compression, have_ports, port_timing
from cranktrain.questions.cylinders.spec import CylindersSpec
from cranktrain.questions.cylinders.travel import cylinder_travel
from cranktrain.questions.cylinders.volumes import ChamberVolumes, SweptVolumes, chamber_volumes, swept_volumes

QUESTION = Question(
    "cylinders",
    tables={"cylinder": CylindersSpec},
    problems=problems,
    parts=parts,
    stages=(
        Stage(cylinder_travel),
        Stage(volumetric_dead_centres, applies=are_opposed),
        Stage(swept_volumes),
        Stage(chamber_volumes),
        Stage(port_timing, applies=have_ports),
        Stage(effective_compression),
        Stage(firing),
        Stage(combined_motion, applies=are_opposed),
        Stage(combined_speeds),
    ),
    dimensions=(
        Dimension("cylinder", N_("cylinder"), family="mechanism"),
        Dimension("chamber", N_("chamber"), family="mechanism"),
        Dimension("bank", N_("bank")),
    ),
    headline=("displacement", "compression_ratio", "combined_stroke", "firing_interval"),
    uses=(
        Use(keys("cylinder", "compression_ratio"), (ChamberVolumes,)),
        Use(keys("cylinder", "chambers", "piston_rod"), (SweptVolumes,)),
        Use(keys("cylinder", "exhaust_port", "scavenge_port"), (PortTiming,)),
        Use(keys("cylinder", "firing_order", "numbers"), (Firing,)),
    ),
)
