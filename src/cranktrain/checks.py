"""Checks: identities that can fail, computed with every result, so that a user sees that it is right."""

from dataclasses import dataclass

import numpy as np

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
    def passed(self) -> Array:
        """Whether it holds, for each design; NaN, as where the links do not close all round, does not."""
        return np.asarray(self.residual <= self.limit)


def worst(difference: Array, scale: Array) -> Array:
    """Largest relative difference of each design: |difference| over every other axis, in parts of the scale's peak."""
    others = tuple(range(1, difference.ndim))
    return np.max(np.abs(difference), axis=others) / np.max(np.abs(scale), axis=tuple(range(1, scale.ndim)))
