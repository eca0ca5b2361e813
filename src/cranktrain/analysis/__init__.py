"""Analysis: which results a machine allows, in which order they are computed, and what is missing for the others."""

from cranktrain.analysis.result import Result
from cranktrain.analysis.run import run, speed_over_cycle
from cranktrain.analysis.stages import Missing, every_stage, ordered, stages_for
from cranktrain.analysis.unused import Unused, sentences
from cranktrain.layout.question import Stage
from cranktrain.layout.speed import SpeedWanted

__all__ = [
    "Missing",
    "Result",
    "SpeedWanted",
    "Stage",
    "Unused",
    "every_stage",
    "ordered",
    "run",
    "sentences",
    "speed_over_cycle",
    "stages_for",
]
