"""Panels as data: curves over the crank angle, or over anything else, that any face can draw."""

from dataclasses import replace
from typing import Literal, NamedTuple, TypeAlias

import numpy as np

from cranktrain.analysis import Result
from cranktrain.motion import Array
from cranktrain.record import record
from cranktrain.saying.scales import scale_for

# fmt: off
Role: TypeAlias = Literal[
    "first", "second", "other", "textbook", "error", "main", "side", "radial", "resultant", "formula", "chamber",
    "whole", "mean", "each", "carried", "card", "later_card",
]
# fmt: on
"""What a curve is among those of its panel, by which a face chooses its line."""


@record
class Curve:
    """A curve of a panel.

    Attributes
    ----------
    values : Array, shape (n,)
        In SI until the panel is as it is shown, then in its unit; NaN where links cannot close.
    role : Role
    letter : str
        Of the quantity whose colour it has.
    symbol : str
        By which a legend names it, as mathematics sets it; of a curve without a name there nothing.
    name : str
        Whose it is.
    """

    values: Array
    role: Role
    letter: str
    symbol: str = ""
    name: str = ""


@record
class Panel:
    """Curves of one quantity.

    Attributes
    ----------
    title : str
    unit : str
        Of the catalogue; once it is as it is shown, what is written.
    across : Array, shape (n,), or (n_curves, n) where each curve has its own
        Crank angles from 0 to the end of the turn or the cycle, both included [deg], unless the title says of what.
    curves : tuple of Curve
    symbol : str
        Of the quantity, as mathematics sets it, where all curves have one.
    """

    title: str
    unit: str
    across: Array
    curves: tuple[Curve, ...]
    symbol: str = ""

    @property
    def values(self) -> Array:
        """Values of all curves, shape (n_curves, n)."""
        return np.stack([curve.values for curve in self.curves])


def as_shown(panel: Panel) -> Panel:
    """Give a panel with its values in the unit in which they are shown, and the label of that."""
    scale = scale_for(panel.unit, float(np.nanmax(np.abs(panel.values), initial=0.0)))
    curves = tuple(replace(curve, values=scale.of(curve.values)) for curve in panel.curves)
    return replace(panel, unit=scale.label, curves=curves)


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

    @property
    def cycle(self) -> Array:
        """Crank angles of the cycle, its end included, shape (n + 1,). [deg]"""
        angle = self.result.crank_angle
        return np.append(angle, len(angle) * (angle[1] - angle[0]))


def closed(values: Array) -> Array:
    """Repeat the first value at the end of the cycle."""
    return np.append(values, values[0])
