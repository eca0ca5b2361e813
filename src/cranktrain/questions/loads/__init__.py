"""Loads: what a machine works against, or what drives it, besides gas and weight."""

from collections.abc import Iterator, Sequence

from cranktrain.errors import Problem, judged
from cranktrain.language import N_
from cranktrain.layout.design import Design, Designs
from cranktrain.layout.load_designs import tables_together
from cranktrain.layout.load_tables import LoadSpec
from cranktrain.layout.loads import load_problems, loads_of
from cranktrain.layout.question import ANY_NAME, Parts, Question, ResultDimension, Stage, TableFile, Use
from cranktrain.layout.shaft_loads import shaft_load_problems, shaft_loads_of
from cranktrain.questions.loads import load_work, rows, unlikely


def _problems(design: Design) -> Iterator[Problem]:
    yield from judged(load_problems(design))
    yield from judged(shaft_load_problems(design))


def _parts(designs: Designs, _known: Parts) -> Iterator[object | None]:
    together = tables_together(designs)
    yield loads_of(designs, together)
    yield shaft_loads_of(designs, together)


def _tables(design: Design) -> Sequence[str]:
    loads = ((path, name, spec) for path, named in design.loads.items() for name, spec in named.items())
    return [f"[{path}.{name}]" for path, name, spec in loads if not spec.is_balanced]


_HOMES = ((), ("bank", ANY_NAME), ("bank", ANY_NAME, ANY_NAME))
"""Where loads may stand: in the machine's tables, a bank's, or one piston's of two in a bank."""


QUESTION = Question(
    "loads",
    tables={"load": LoadSpec},
    problems=_problems,
    parts=_parts,
    stages=(Stage(load_work.load_work, applies=load_work.are_asked_for), Stage(unlikely.unlikely_strokes)),
    dimensions=(ResultDimension("load", N_("load")),),
    headline=("load_work", "largest_load_power"),
    title=N_("Loads"),
    rows=(rows.load_rows,),
    offers={"load_work": N_("what it works against")},
    files=tuple(TableFile((*home, "load", ANY_NAME), None, N_("the file of a load")) for home in _HOMES),
    uses=(Use(_tables, (load_work.LoadWork,)),),
)
