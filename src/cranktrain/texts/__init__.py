"""The sources' own formulas, with their ranges, beside the exact ones."""

from cranktrain.language import N_
from cranktrain.layout.question import ResultDimension, Stage
from cranktrain.questions.motion.rods import on_rods
from cranktrain.texts.comparison import textbook_motion

STAGES = (Stage(textbook_motion, applies=on_rods),)
DIMENSIONS = (ResultDimension("motion_method", N_("method"), own=0, is_compared=True),)
