"""Cylinders: how their pistons make room, what that holds, their ports, and when they fire."""

from cranktrain.language import N_
from cranktrain.layout.question import Question, ResultDimension, Stage, Use
from cranktrain.layout.uses import keys
from cranktrain.questions.cylinders import firing, opposed, ports, spec, travel, volumes
from cranktrain.questions.cylinders.parts import parts, problems

QUESTION = Question(
    "cylinders",
    tables={"cylinder": spec.CylindersSpec},
    problems=problems,
    parts=parts,
    stages=(
        Stage(travel.cylinder_travel),
        Stage(opposed.volumetric_dead_centres, applies=opposed.are_opposed),
        Stage(volumes.swept_volumes),
        Stage(volumes.chamber_volumes),
        Stage(ports.port_timing, applies=ports.have_ports),
        Stage(ports.effective_compression),
        Stage(firing.firing, applies=firing.has_firing),
        Stage(opposed.combined_motion, applies=opposed.are_opposed),
        Stage(opposed.combined_speeds),
    ),
    dimensions=(
        ResultDimension("cylinder", N_("cylinder"), family="mechanism"),
        ResultDimension("chamber", N_("chamber"), family="mechanism"),
        ResultDimension("bank", N_("bank")),
    ),
    headline=("displacement", "compression_ratio", "combined_stroke", "firing_interval"),
    uses=(
        Use(keys("cylinder", "compression_ratio", "clearance"), (volumes.ChamberVolumes,)),
        Use(keys("cylinder", "chambers", "piston_rod"), (volumes.SweptVolumes,)),
        Use(keys("cylinder", "exhaust_port", "scavenge_port"), (ports.PortTiming,)),
        Use(keys("cylinder", "firing_order", "numbers"), (firing.Firing,)),
    ),
)
