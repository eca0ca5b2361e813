"""Cylinders: how their pistons make room, what that holds, their ports, and when they fire."""

from collections.abc import Iterator, Sequence

from cranktrain.language import N_
from cranktrain.layout.design import Design, Designs
from cranktrain.layout.question import Parts, Question, ResultDimension, Stage, Use, keys
from cranktrain.questions.cylinders import firing, opposed, ports, rows, spec, travel, unlikely, volumes
from cranktrain.questions.cylinders.parts import parts, problems
from cranktrain.questions.motion.outputs import InCylinders


def _parts(designs: Designs, known: Parts) -> Iterator[object | None]:
    yield from parts(designs, known)
    declared = designs.each[0].table(spec.CylindersSpec)  # together they say every field
    yield InCylinders() if declared is not None and declared.model_fields_set else None


def _is_for(needs: Sequence[str], design: Design) -> bool:
    """A machine without cylinders may get its first by a bore, but one that works against loads is none with any."""
    declared = design.table(spec.CylindersSpec)
    if declared is not None and declared.model_fields_set:
        return True
    own = [need for need in needs if need.startswith("[cylinder]")]
    return not own or (list(needs) == [volumes.Chambers.needs] and not any(design.loads.values()))


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
        Stage(firing.firing, applies=firing.has_firing, refuses=True),
        Stage(opposed.combined_motion, applies=opposed.are_opposed),
        Stage(opposed.combined_speeds),
        Stage(unlikely.unlikely_cylinders),
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
    is_for=_is_for,
    uses=(
        Use(keys("cylinder", "compression_ratio", "clearance"), (volumes.ChamberVolumes,)),
        Use(keys("cylinder", "chambers", "piston_rod"), (volumes.SweptVolumes,)),
        Use(keys("cylinder", "exhaust_port", "scavenge_port"), (ports.PortTiming,)),
        Use(keys("cylinder", "firing_order", "numbers"), (firing.Firing,)),
    ),
)
