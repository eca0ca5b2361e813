"""Cylinders: how their pistons make room, what that holds, their ports, and when they fire."""

from collections.abc import Iterator

from cranktrain.language import N_
from cranktrain.layout.design import Designs
from cranktrain.layout.question import Parts, Question, ResultDimension, Stage, Use
from cranktrain.layout.uses import keys
from cranktrain.questions.cylinders import firing, opposed, ports, rows, spec, travel, volumes
from cranktrain.questions.cylinders.parts import parts, problems
from cranktrain.questions.motion.sorts import InCylinders


def _parts(designs: Designs, known: Parts) -> Iterator[object | None]:
    yield from parts(designs, known)
    declared = designs.each[0].table(spec.CylindersSpec)  # together they say every field
    yield InCylinders() if declared is not None and declared.model_fields_set else None


QUESTION = Question(
    "cylinders",
    tables={"cylinder": spec.CylindersSpec},
    problems=problems,
    parts=_parts,
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
    title=N_("Cylinders"),
    rows=(
        rows.volume_rows,
        rows.opposed_rows,
        rows.port_rows,
        rows.firing_rows,
    ),
    offers={
        "compression_ratio": N_("volumes"),
    },
    uses=(
        Use(keys("cylinder", "compression_ratio", "clearance"), (volumes.ChamberVolumes,)),
        Use(keys("cylinder", "chambers", "piston_rod"), (volumes.SweptVolumes,)),
        Use(keys("cylinder", "exhaust_port", "scavenge_port"), (ports.PortTiming,)),
        Use(keys("cylinder", "firing_order", "numbers"), (firing.Firing,)),
    ),
)
