"""All dimensions of results: those that questions share, and those that each brings."""

from cranktrain import texts
from cranktrain.all_questions import QUESTIONS
from cranktrain.layout import parts

DECLARED = (
    *parts.DIMENSIONS,
    *(one for question in QUESTIONS for one in question.dimensions),
    *texts.DIMENSIONS,
)
DIMENSIONS = {dimension.name: dimension for dimension in DECLARED}
