"""Rows of the answer as data: a name, and SI values of some members or words with SI values in them."""

from collections.abc import Mapping, Sequence
from dataclasses import field
from typing import TypeAlias

import numpy as np

from cranktrain.motion import Array
from cranktrain.record import record

_SAME = 1e-6
"""Values are one where they differ by less than this part of the largest."""


@record
class Amount:
    """One value in words.

    Attributes
    ----------
    value : float
        In SI; a speed of rotation, a frequency and an angle in radians.
    unit : str
        As in `AnswerLine`.
    """

    value: float
    unit: str


@record
class Extent:
    """A range in words: from `least` to `most`, both as in `Amount`, with as many digits as tell them apart.

    positions: the angles where each stands, if that is to be said. [rad]
    """

    least: float
    most: float
    unit: str
    positions: tuple[float, float] | None = None


Piece: TypeAlias = "Amount | Extent | str"


@record
class AnswerLine:
    """One line of the answer.

    Attributes
    ----------
    name : str
        What it is, in the user's language.
    values : Array, shape (member,)
        In SI; none where words say all. NaN is no value.
    unit : str
        What the values are: a unit of SI as the catalogue has it, or of those that say more, "rpm", "Hz" (both in
        rad/s), "position" (an angle where something stands, in rad), "%" (of 1), "error" and "off" (of 1, the latter
        with its sign).
    members : tuple of str
        Whose each value is; none of one value.
    words : str
        Behind the values, or instead of them; `{name}` stands for one of `pieces`.
    pieces : mapping of str to Amount, Extent or str
    """

    name: str
    values: Array = field(default_factory=lambda: np.empty(0))
    unit: str = ""
    members: tuple[str, ...] = ()
    words: str = ""
    pieces: Mapping[str, Piece] = field(default_factory=dict[str, Piece])

    @property
    def says(self) -> bool:
        """Whether there is anything to say."""
        amounts = [one for one in self.pieces.values() if not isinstance(one, str)]
        known = [np.isfinite(one.value if isinstance(one, Amount) else one.most) for one in amounts]
        return bool(np.any(np.isfinite(self.values)) if self.values.size else self.words and all(known))


def valued(
    name: str, values: Array | float, unit: str, members: Sequence[str] = (), words: str = "", /, **pieces: Piece
) -> AnswerLine:
    """Give a row of values, with words behind them."""
    return AnswerLine(name, np.atleast_1d(np.asarray(values, dtype=float)), unit, tuple(members), words, pieces)


def worded(name: str, words: str, /, **pieces: Piece) -> AnswerLine:
    """Give a row of words alone."""
    return AnswerLine(name, words=words, pieces=pieces)


def alike(values: Array, unit: str) -> Amount | None:
    """Give what all values are; None where they differ by more than rounding."""
    known = values[np.isfinite(values)]
    if known.size == 0 or np.ptp(known) > _SAME * max(float(np.max(np.abs(known))), _SAME):
        return None
    return Amount(float(known[0]), unit)
