"""A chain of the machine file whose parts hang together."""

from typing import Self

from pydantic import model_validator

from cranktrain.errors import InputError
from cranktrain.mechanisms.chain.naming import naming_problems
from cranktrain.mechanisms.chain.parts import ChainTable
from cranktrain.mechanisms.chain.table import mode_problems


class ChainSpec(ChainTable, frozen=True):
    """Cranks on one shaft, fixed points, and groups that each hang on what stands above them."""

    @model_validator(mode="after")
    def _hangs_together(self) -> Self:
        """Refuse names unknown or twice, parts that nothing drives, an output that is none, triads of unclear mode."""
        found = naming_problems(self) or mode_problems(self)
        if found:
            raise InputError(found)
        return self
