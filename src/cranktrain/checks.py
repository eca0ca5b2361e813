"""Checks: identities that can fail, computed with every result, so that a user sees that it is right."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array


@dataclass(frozen=True)
class Check:
    """An identity and how well it holds.

    Attributes
    ----------
    name : str
    sentence : str
        What is compared with what, in the user's language.
    residual : Array, shape (design,)
        Largest difference over the cycle, relative to the scale that the sentence names.
    limit : float
        What rounding explains.
    """

    name: str
    sentence: str
    residual: Array
    limit: float

    @property
    def passed(self) -> NDArray[np.bool_]:
        """Whether it holds, for each design; NaN, as where the links do not close all round, does not."""
        return np.asarray(self.residual <= self.limit)


def relative(difference: Array, scale: Array) -> Array:
    """Largest |difference| over the last axis, which is kept, in parts of the scale's peak there."""
    return np.max(np.abs(difference), axis=-1, keepdims=True) / np.max(np.abs(scale), axis=-1, keepdims=True)
