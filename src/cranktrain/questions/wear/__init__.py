"""Wear: where over the cycle crank pins and the rods' bearings on them are loaded, and where oil holes go."""

from cranktrain.language import N_
from cranktrain.layout.question import Question, ResultDimension, Stage
from cranktrain.questions.forces.crank_pins import have_crank_pins
from cranktrain.questions.wear.cycle_points import cycle_points
from cranktrain.questions.wear.pin_wear import crank_pin_wear
from cranktrain.questions.wear.side_changes import side_changes

QUESTION = Question(
    "wear",
    stages=(Stage(cycle_points, applies=have_crank_pins), Stage(crank_pin_wear), Stage(side_changes)),
    dimensions=(
        ResultDimension("ray", N_("ray"), is_number=True),
        ResultDimension("side_change", N_("change of sides"), is_number=True),
    ),
    title=N_("Wear of crank pins"),
)
