"""Rod load: what gas and inertia put on piston rod, crosshead pin and connecting rod, and whether it reverses."""

from collections.abc import Iterator

from cranktrain.language import N_
from cranktrain.layout.design import Designs
from cranktrain.layout.question import Parts, Question, ResultDimension, Stage, Use, table
from cranktrain.questions.gas.declared import DeclaredGas
from cranktrain.questions.rod_load import limits, loads, reversal, rows
from cranktrain.questions.rod_load.declared import declared_rod_loads, rod_load_problems
from cranktrain.questions.rod_load.spec import RodSpec


def _parts(designs: Designs, known: Parts) -> Iterator[object | None]:
    yield declared_rod_loads(designs, has_gas=DeclaredGas in known)


QUESTION = Question(
    "rod_load",
    tables={"rod_load": RodSpec},
    problems=rod_load_problems,
    parts=_parts,
    stages=(
        Stage(loads.rod_load_curves, applies=loads.have_rod_loads),
        Stage(loads.rod_loads),
        Stage(reversal.reversals),
        Stage(limits.rod_load_use, applies=limits.have_limits),
    ),
    dimensions=(
        ResultDimension("rod_load_place", N_("place"), titles=loads.PLACE_TITLES),
        ResultDimension("frame_limit", N_("limit"), titles=limits.LIMIT_TITLES),
    ),
    title=N_("Largest forces"),
    rows=(rows.rod_load_rows,),
    uses=(Use(table("rod_load"), (loads.RodLoads,)),),
)
