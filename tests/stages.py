"""Stages of all questions, those over time among them."""

from cranktrain.all_questions import QUESTIONS
from cranktrain.analysis import every_stage
from cranktrain.layout.question import Question, Stage


def stages_of(question: Question) -> tuple[Stage, ...]:
    """Those of a cycle, and those over time."""
    return (*question.stages, *question.over_time())


EVERY_STAGE = (*every_stage(), *(stage for question in QUESTIONS for stage in question.over_time()))
