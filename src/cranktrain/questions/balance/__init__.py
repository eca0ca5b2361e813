"""Balance: what shakes the frame, and the weights and shafts that balance it."""

from collections.abc import Iterator, Sequence

from cranktrain.errors import Problem
from cranktrain.language import N_
from cranktrain.layout.design import Design, Designs
from cranktrain.layout.masses import bodies_given
from cranktrain.layout.question import Dimension, Parts, Question, Stage, Use
from cranktrain.layout.uses import table
from cranktrain.questions.balance.frame_forces import frame_forces
from cranktrain.questions.balance.running_frame import running_frame
from cranktrain.questions.balance.shaking import ShakingForces, rolling_moment, shaking_couples, shaking_forces
from cranktrain.questions.balance.spec import BalanceSpec
from cranktrain.questions.balance.weights import BalanceWeights, balance_problems, balance_weights, declared_balance
from cranktrain.questions.forces.loaded import MechanismTorques


def _problems(design: Design) -> tuple[Problem, ...]:
    spec = design.table(BalanceSpec)
    return () if spec is None else balance_problems(spec, design.main_shaft)


def _parts(designs: Designs, _known: Parts) -> Iterator[object | None]:
    yield declared_balance(designs.tables(BalanceSpec), designs.shafts)


def _gravity(design: Design) -> Sequence[str]:
    return ["gravity"] if design.weighed.gravity is not None else []


QUESTION = Question(
    "balance",
    tables={"balance": BalanceSpec},
    problems=_problems,
    parts=_parts,
    stages=(
        Stage(frame_forces, applies=bodies_given),
        Stage(running_frame),
        Stage(balance_weights),
        Stage(shaking_forces),
        Stage(shaking_couples),
        Stage(rolling_moment),
    ),
    dimensions=(Dimension("balance", N_("balance")), Dimension("weight", N_("weight"))),
    headline=("shaking_force_largest", "shaking_couple_largest"),
    uses=(
        Use(table("balance"), (BalanceWeights,)),
        # Weights are felt in the torque, where anything has one.
        Use(_gravity, (MechanismTorques, ShakingForces)),
    ),
)
