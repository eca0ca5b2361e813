"""A chain of the machine file whose parts hang together."""

from collections.abc import Iterable

from cranktrain.errors import Problem
from cranktrain.mechanisms.chain.naming import naming_problems
from cranktrain.mechanisms.chain.parts import ChainTable
from cranktrain.mechanisms.chain.table import mode_problems


class ChainSpec(ChainTable, frozen=True):
    """Cranks on one shaft, fixed points, and groups that each hang on what stands above them."""

    def _problems(self) -> Iterable[Problem]:
        """Find names unknown or twice, parts that nothing drives, an output that is none, triads of unclear mode."""
        return tuple(naming_problems(self)) or mode_problems(self)
