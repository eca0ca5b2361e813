"""One design of a result, by the names of its quantities."""

from typing import NamedTuple

import numpy as np

from cranktrain.analysis import Result
from cranktrain.motion import Array
from cranktrain.saying.amounts import Amount

_ROUNDING = 1e-9
"""Of what stands beside it: less is nothing."""


class OneDesign(NamedTuple):
    """A result, which of its designs, and whose throw alone is meant, if any."""

    result: Result
    design: int
    mechanism: str | None = None

    def __call__(self, name: str) -> Array:
        """Give a quantity of the design."""
        values: Array = getattr(self.result, name)
        return values[self.design] if self.result.has_designs else values

    def has(self, name: str) -> bool:
        """Whether there is such a quantity."""
        return name in self.result.catalogue

    def member(self, dimension: str, name: str) -> int:
        """Place of a name along a dimension."""
        return self.result.labels[dimension].index(name)

    def amount(self, name: str, *member: int, beside: float = 0.0) -> Amount:
        """Give the amount of a quantity, of a member by its place along each dimension.

        beside: what is rounding beside this is nothing.
        """
        entry = self.result.catalogue[name]
        value = float(self(name)[member])
        if abs(value) <= _ROUNDING * abs(beside):
            value = 0.0
        labels = self.result.labels_of(entry)
        whose = tuple(names[place] for names, place in zip(labels.values(), member, strict=True))
        return Amount(value, entry.shown, name, whose)

    @property
    def cycle(self) -> Array:
        """Crank angles of the cycle, its end included, shape (n + 1,). [deg]"""
        angle = self.result.crank_angle
        return np.append(angle, len(angle) * (angle[1] - angle[0]))


def closed(values: Array) -> Array:
    """Repeat the first value at the end of the cycle."""
    return np.append(values, values[0])
