"""Balance: what shakes the frame, and the weights and shafts that balance it."""

from collections.abc import Iterable, Iterator, Sequence

from cranktrain.errors import Problem
from cranktrain.language import N_
from cranktrain.layout.design import Design, Designs
from cranktrain.layout.masses import bodies_given
from cranktrain.layout.question import Parts, Question, ResultDimension, Stage, Use, table
from cranktrain.layout.specs import MAIN
from cranktrain.questions.balance import frame_forces, rows, shaking, spec, unlikely, weights, wheels
from cranktrain.questions.forces.mechanism_torques import MechanismTorques


def _problems(design: Design) -> Iterable[Problem]:
    given = design.table(spec.BalanceSpec)
    return () if given is None else weights.balance_problems(given, design.shafts[MAIN])


def _parts(designs: Designs, _known: Parts) -> Iterator[object | None]:
    yield weights.declared_balance(designs)


def _gravity(design: Design) -> Sequence[str]:
    return ["gravity"] if design.weighed.gravity is not None else []


QUESTION = Question(
    "balance",
    tables={"balance": spec.BalanceSpec},
    problems=_problems,
    parts=_parts,
    stages=(
        Stage(frame_forces.frame_forces, applies=bodies_given),
        Stage(frame_forces.running_frame),
        Stage(weights.balance_weights),
        Stage(shaking.shaking_forces),
        Stage(shaking.shaking_couples),
        Stage(shaking.rolling_moment),
        Stage(wheels.hammer_blow, applies=wheels.have_wheels),
        Stage(unlikely.unlikely_balance),
    ),
    dimensions=(
        ResultDimension("balance", N_("balance"), own=-1),
        ResultDimension("weight", N_("weight"), titles=weights.TITLES),
        ResultDimension("wheel", N_("wheel")),
    ),
    headline=("shaking_force_largest", "shaking_couple_largest"),
    title=N_("Balance"),
    rows=(
        rows.force_rows,
        rows.couple_rows,
        rows.wheel_rows,
    ),
    offers={
        "balance_weight_moment": N_("counterweights"),
        "shaking_couple_largest": N_("couples"),
    },
    uses=(
        Use(table("balance"), (weights.BalanceWeights,)),
        # Weights are felt in the torque, where anything has one.
        Use(_gravity, (MechanismTorques, shaking.ShakingForces)),
    ),
)
