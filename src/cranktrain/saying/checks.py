"""Checks: identities that can fail, computed with every result; and limits beyond which numbers are flagged."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.grouping import grouped
from cranktrain.language import Message, Words, _
from cranktrain.motion import Array
from cranktrain.numerics.ties import first_largest
from cranktrain.quantities import shown
from cranktrain.record import record


@record
class Check:
    """An identity and how well it holds.

    Attributes
    ----------
    name : str
    sentence : Words
        What is compared with what.
    residual : Array, shape (design,)
        Largest difference over the cycle, relative to the scale that the sentence names: forces times arms, never a
        result that may be 0. NaN where the links do not close all round, infinite where it cannot be judged otherwise.
    limit : float
        What rounding explains.
    reasons : tuple of Words
        Of each design, why it cannot be judged otherwise; no series has the digits unless given.
    """

    name: str
    sentence: Words
    residual: Array
    limit: float
    reasons: tuple[Words, ...] = ()

    @property
    def judged(self) -> NDArray[np.bool_]:
        """Whether it could be judged, for each design."""
        return np.isfinite(self.residual)

    @property
    def passed(self) -> NDArray[np.bool_]:
        """Whether it holds, for each design; what could not be judged has not passed."""
        return np.asarray(self.residual <= self.limit)

    def verdict(self, design: int = 0) -> Words:
        """Say for one design whether it holds, or what it needs."""
        if np.isnan(self.residual[design]):
            return _("needs a full turn")
        if not self.judged[design]:
            return self.reasons[design] if self.reasons else _("is beyond the digits of a Fourier series")
        return _("holds") if self.passed[design] else _("does not hold")


@record
class StageResult:
    """What the result of any stage may have beside its quantities.

    One that is neither `Checked` nor `Flagged` checks nothing and warns of nothing: nobody need compute it for that.

    Attributes
    ----------
    labels : mapping of str to tuple of str
        Names along the dimensions that it brings.
    """

    labels: Mapping[str, tuple[str, ...]] = field(default_factory=dict[str, tuple[str, ...]], kw_only=True)


@record
class Checked(StageResult):
    """A result that checks identities.

    Attributes
    ----------
    checks : tuple of Check
    """

    checks: tuple[Check, ...] = field(default=(), kw_only=True)


@record
class Flagged(StageResult):
    """A result that may warn.

    Attributes
    ----------
    flags : tuple of Words
        Sentences that warn of its numbers.
    unlikely : tuple of Words
        Flags that ask whether a number of the file is right; `check` tells them, too.
    """

    flags: tuple[Words, ...] = field(default=(), kw_only=True)
    unlikely: tuple[Words, ...] = field(default=(), kw_only=True)


@dataclass(frozen=True, slots=True, repr=False, eq=False)
class Flag(Message):
    """A flag of several designs, which says the worst of them.

    Attributes
    ----------
    own : mapping of int to Message
        What is said of each design that is flagged, by its place.
    """

    own: Mapping[int, Message] = field(default_factory=dict[int, Message])


def flags_of_designs(each: Iterable[Iterable[Words]]) -> tuple[Words, ...]:
    """Put flags of designs, one after the other, together: each once, with the designs of which it is said."""
    said = grouped((flag, design) for design, flags in enumerate(each) for flag in flags)
    return tuple(
        Flag(flag.text, flag.pieces, dict.fromkeys(designs, flag)) if isinstance(flag, Message) else flag
        for flag, designs in said.items()
    )


class Limit(NamedTuple):
    """The most that was ever built, or that digits allow, in SI; the unit of what is told; and the sentence.

    What is beyond it is computed with all the same, and flagged. Where `least` is given, so is what is less than that.
    """

    most: float
    unit: str
    sentence: str
    least: float = -np.inf


def flagged(limit: Limit, values: Array, named: Array | None = None, whose: Sequence[Words] = ("",)) -> Iterator[Flag]:
    """Flag the value that is farthest beyond a limit, NaN never, the first of those within 1e-9.

    Parameters
    ----------
    limit : Limit
    values : Array, shape (design, …)
    named : Array, optional
        Told in place of the values, of their shape.
    whose : sequence of Words
        What the values along the last axis are of, for {whose} in the sentence.
    """
    beyond = np.fmax(np.fmax(values - limit.most, limit.least - values), 0.0)

    def said(place: int) -> Message:
        value = float(np.ravel(values if named is None else named)[place])
        written = f"{shown(value, limit.unit):.4g} {limit.unit}" if limit.unit else f"{value:.4g}"
        return _(limit.sentence, value=written, whose=whose[place % len(whose)])

    if (beyond > 0).any():
        of_designs = beyond.reshape(len(beyond), -1)
        size = of_designs.shape[1]
        own = {
            design: said(design * size + first_largest(of_designs[design]))
            for design in np.flatnonzero(np.any(of_designs > 0, axis=1)).tolist()
        }
        worst = said(first_largest(beyond))
        yield Flag(worst.text, worst.pieces, own)
