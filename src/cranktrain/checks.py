"""Checks: identities that can fail, computed with every result, so that a user sees that it is right."""

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import _
from cranktrain.motion import Array
from cranktrain.record import record


@record
class Check:
    """An identity and how well it holds.

    Attributes
    ----------
    name : str
    sentence : str
        What is compared with what, in the user's language.
    residual : Array, shape (design,)
        Largest difference over the cycle, relative to the scale that the sentence names; NaN where the identity needs a
        full turn and the links do not close all round.
    limit : float
        What rounding explains.
    """

    name: str
    sentence: str
    residual: Array
    limit: float

    @property
    def judged(self) -> NDArray[np.bool_]:
        """Whether it could be judged, for each design: an identity over a full turn needs one."""
        return ~np.isnan(self.residual)

    @property
    def passed(self) -> NDArray[np.bool_]:
        """Whether it holds, for each design; what could not be judged has not passed."""
        return np.asarray(self.residual <= self.limit)

    def verdict(self, design: int = 0) -> str:
        """Say for one design whether it holds, or what it needs."""
        if not self.judged[design]:
            return _("needs a full turn, or a finer grid")
        return _("holds") if self.passed[design] else _("does not hold")
