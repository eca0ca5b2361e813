"""Start: how the machine runs up from rest, stalls, is switched and stops; stages over time, which `start` asks for."""

from collections.abc import Iterator, Mapping
from typing import cast

from cranktrain.errors import Problem
from cranktrain.fluids.compressor import CompressorSpec
from cranktrain.language import N_, _
from cranktrain.layout.design import Design, Designs
from cranktrain.layout.drive.table import DriveSpec
from cranktrain.layout.question import Parts, Question, ResultDimension, Stage
from cranktrain.questions.start.flags import start_flags
from cranktrain.questions.start.parts import declared_start


def _problems(design: Design) -> Iterator[Problem]:
    """Find valves held open where there are none."""
    spec = design.table(DriveSpec)
    open_until = None if spec is None else spec.start.unloaded_until
    if open_until is not None and not _is_compressor(design):
        allowed = _('holds the suction valves of [gas] kind = "compressor" open, which is not there')
        repair = _('for a start that is checked without loads write [drive.duty] start = "unloaded"')
        yield Problem("drive.start.unloaded_until", open_until.text, allowed, repair)


def _is_compressor(design: Design) -> bool:
    """Whether any chamber is a compressor's."""
    gas: object = design.tables.get("gas")
    each = tuple(cast("Mapping[str, object]", gas).values()) if isinstance(gas, Mapping) else (gas,)
    return any(isinstance(one, CompressorSpec) for one in each)


def _parts(designs: Designs, _known: Parts) -> Iterator[object]:
    spec = designs.together.table(DriveSpec)
    if spec is not None:
        yield declared_start(spec.start, designs)


def _over_time() -> tuple[Stage, ...]:
    from cranktrain.questions.start.over_time import STAGES

    return STAGES


QUESTION = Question(
    "start",
    problems=_problems,
    parts=_parts,
    stages=(Stage(start_flags),),
    over_time=_over_time,
    dimensions=(ResultDimension("time", N_("time"), is_number=True), ResultDimension("event", N_("event"))),
    title=N_("Drive"),
)
