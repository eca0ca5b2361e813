"""Analysis: which results a machine allows, in which order they are computed, and what is missing for the others."""

from cranktrain.analysis.result import Result
from cranktrain.analysis.run import run
from cranktrain.analysis.stages import STAGES, Missing, Stage, ordered, stage

__all__ = ["STAGES", "Missing", "Result", "Stage", "ordered", "run", "stage"]
