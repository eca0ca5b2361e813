"""Many designs of one machine: any values of its file over a range, a map or a list, and the facts of each."""

from cranktrain.study.sweep.computed import swept
from cranktrain.study.sweep.sweep import Sweep

__all__ = ["Sweep", "swept"]
