"""Torsion: the crankshaft's natural frequencies and modes, and the speeds that are critical for them."""

from collections.abc import Iterator, Sequence

from cranktrain.errors import Problem
from cranktrain.language import N_
from cranktrain.layout.design import Design, Designs
from cranktrain.layout.question import Parts, Question, ResultDimension, Stage, Use, table
from cranktrain.layout.specs import MAIN
from cranktrain.questions.torsion import rows
from cranktrain.questions.torsion.critical import critical_speeds, mode_vector_sums
from cranktrain.questions.torsion.modes import TorsionalModes, of_known_stiffness, torsional_modes, torsional_train
from cranktrain.questions.torsion.parts import declared_train, torsion_problems
from cranktrain.questions.torsion.spec import TorsionSpec
from cranktrain.questions.torsion.throw_stiffness import ThrowStiffness, of_sized_crankshaft, throw_stiffness
from cranktrain.questions.torsion.trials import are_tried, holzer_trials


def _problems(design: Design) -> Iterator[Problem]:
    spec = design.table(TorsionSpec)
    if spec is not None:
        yield from torsion_problems(spec, design)


def _parts(designs: Designs, _known: Parts) -> Iterator[object]:
    table = designs.together.table(TorsionSpec)
    if table is not None:
        yield declared_train(table, len(designs.together.shafts[MAIN].throws), designs.n_designs)


def _sizes(design: Design) -> Sequence[str]:
    """Sizes of the crankshaft are used for torsion, too, where that is asked for."""
    return table("crankshaft")(design) if design.table(TorsionSpec) is not None else []


QUESTION = Question(
    "torsion",
    tables={"torsion": TorsionSpec},
    problems=_problems,
    parts=_parts,
    stages=(
        Stage(throw_stiffness, applies=of_sized_crankshaft),
        Stage(torsional_train, applies=of_known_stiffness),
        Stage(torsional_modes),
        Stage(critical_speeds),
        Stage(mode_vector_sums),
        Stage(holzer_trials, applies=are_tried),
    ),
    dimensions=(
        ResultDimension("disc", N_("disc")),
        ResultDimension("mode", N_("mode"), is_number=True, is_apart=True),
        ResultDimension("trial", N_("frequency"), is_number=True, is_apart=True, is_asked=True),
        ResultDimension("throw_method", N_("method"), own=0),
        ResultDimension("throw_gap", N_("between throws")),
    ),
    headline=("natural_frequency",),
    title=N_("Torsion"),
    rows=(
        rows.frequency_rows,
        rows.critical_rows,
        rows.trial_rows,
        rows.stiffness_rows,
    ),
    offers={
        "natural_frequency": N_("natural frequencies"),
    },
    uses=(Use(table("torsion"), (TorsionalModes,)), Use(_sizes, (ThrowStiffness,))),
)
