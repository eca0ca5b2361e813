"""Dimensions of all results: those that questions share, and those that each brings."""

from collections.abc import Mapping

from cranktrain import textbook
from cranktrain.all_questions import QUESTIONS
from cranktrain.layout import parts
from cranktrain.layout.question import ResultDimension

DIMENSIONS: Mapping[str, ResultDimension] = {
    dimension.name: dimension
    for dimensions in (parts.DIMENSIONS, *(question.dimensions for question in QUESTIONS), textbook.DIMENSIONS)
    for dimension in dimensions
}
