"""The table of a machine file for a wanted motion: pieces with laws, or positions over time."""

import math
from collections.abc import Iterator
from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.quantities import Given, NonNegativeLength, NonNegativeTime, PositiveTime, Ratio, TurnedAngle
from cranktrain.spec import Spec

LawName = Literal[
    "4-5-6-7", "5-6-7-8-9", "3-4-5", "cycloidal", "modified sine", "harmonic", "constant velocity", "constant crank"
]
_FEWEST = 4
"""Points of a table."""
_SHORTEST = 1e-5
"""Of the period: rounding of the times is seen in what is shorter."""
_WHOLE = 1e-9
"""By how much a polynomial may miss the whole way, which is rounding of its coefficients."""


class MotionPieceSpec(Spec, frozen=True):
    """A part of a wanted motion: a way to a position by a law, or without a position a rest."""

    duration: PositiveTime = Field(description=N_("How long it takes."))
    to: NonNegativeLength | None = Field(
        default=None, description=N_("Where a slider is at its end, as `counts_from` says; unless given, it stands.")
    )
    swing: TurnedAngle | None = Field(
        default=None, description=N_("Where a rocker is at its end, from its least angle; unless given, it stands.")
    )
    law: LawName | None = Field(
        default=None, description=N_("How the way is made; 4-5-6-7, from rest to rest, unless given.")
    )

    coefficients: tuple[Ratio, ...] | None = Field(
        default=None,
        min_length=2,
        max_length=16,
        description=N_("Instead of a law those of a polynomial: share of the way by powers of the share of the time."),
    )

    @property
    def target(self) -> Given | None:
        """Where it ends."""
        return self.to if self.to is not None else self.swing

    def _problems(self) -> Iterator[Problem]:
        """Find two ends, and a law of a rest."""
        if self.to is not None and self.swing is not None:
            yield Problem("swing", self.swing.text, _("must not stand beside `to`: a slider moves, a rocker swings"))
        if self.target is None and self.law is not None:
            yield Problem("law", self.law, _("must be left out of a piece that stands; or say where it goes, `to`"))
        if self.coefficients is not None:
            yield from self._coefficient_problems(self.coefficients)

    def _coefficient_problems(self, coefficients: tuple[Given, ...]) -> Iterator[Problem]:
        """Find a polynomial beside a law, of a rest, and one that does not go all the way."""
        if self.law is not None:
            yield Problem("coefficients", None, _("must not stand beside a law, {law}", law=self.law))
        if self.target is None:
            allowed = _("must be left out of a piece that stands; or say where it goes, `to`")
            yield Problem("coefficients", None, allowed)
        first, total = coefficients[0], math.fsum(one.si for one in coefficients)
        if first.si != 0:
            allowed = _("must be 0, as the way begins where the piece before ends; then come those of s, s², …")
            yield Problem("coefficients[0]", first.text, allowed)
        elif abs(total - 1) > _WHOLE:
            allowed = _("must be 1 together, the whole way; they are {total}")
            yield Problem("coefficients", None, allowed.format(total=f"{total:.12g}"))


class MotionRestSpec(Spec, frozen=True):
    """A rest among the positions of a wanted motion: from one of its times to the next it stands still."""

    begin: NonNegativeTime = Field(description=N_("One of the times: from then on it stands."))
    until: NonNegativeTime = Field(
        description=N_("The next one, with the same position; after the last time comes the first one.")
    )


class WantedMotionSpec(Spec, frozen=True):
    """How what the crank drives is to move over a period: in pieces, or by positions over time.

    A turning crank goes through its dead centres: the wanted motion goes out and back once a period, over the whole
    stroke. A rocking one swings between two angles, and what it drives between two positions within the stroke.
    """

    of: str | None = Field(
        default=None, description=N_("What is to move so: the output of the first mechanism, which alone can be said.")
    )
    mode: Literal["turning", "rocking"] = Field(
        default="turning", description=N_("Whether the crank turns all round, or swings between two angles.")
    )
    counts_from: Literal["far", "near"] = Field(
        default="far",
        description=N_("From which dead centre positions count: a slider's farthest from the shaft, or its nearest."),
    )
    piece: Annotated[tuple[MotionPieceSpec, ...], Field(max_length=200)] = Field(
        default=(), description=N_("Its parts, one after another; the last one ends where the first one begins.")
    )
    times: tuple[NonNegativeTime, ...] | None = Field(
        default=None, min_length=_FEWEST, description=N_("Times of the positions, rising, within one period.")
    )
    positions: tuple[NonNegativeLength, ...] | None = Field(
        default=None, min_length=_FEWEST, description=N_("Where a slider is then; between them a smooth curve.")
    )
    swing: tuple[TurnedAngle, ...] | None = Field(
        default=None, min_length=_FEWEST, description=N_("Where a rocker is then, from its least angle.")
    )
    period: PositiveTime | None = Field(
        default=None, description=N_("After which the first position comes again; of pieces it is their time together.")
    )

    rest: Annotated[tuple[MotionRestSpec, ...], Field(max_length=200)] = Field(
        default=(), description=N_("Rests among the positions: between them the curve is smooth, and they stand still.")
    )

    @property
    def rests(self) -> NDArray[np.bool_]:
        """Whether it stands from each time to the next, shape (time,)."""
        begins = {rest.begin.si for rest in self.rest}
        return np.array([time.si in begins for time in self.times or ()], dtype=bool)

    @property
    def listed(self) -> tuple[Given, ...] | None:
        """Positions or angles over time."""
        return self.positions if self.positions is not None else self.swing

    def _problems(self) -> Iterator[Problem]:
        """Find no motion, two of them, and what belongs to the other."""
        if not self.piece and self.times is None:
            yield Problem("piece", None, _("is missing; give pieces, or times and positions"))
        of_tables = ("times", "positions", "swing", "period")
        if self.piece:
            beside = _("must not stand beside pieces, which say all of it")
            yield from (Problem(name, None, beside) for name in of_tables if getattr(self, name) is not None)
            if self.rest:
                yield Problem("rest", None, _("is for positions over time; a piece without `to` stands"))
            if all(piece.target is None for piece in self.piece):
                yield Problem("piece", None, _("must have pieces that go somewhere: give `to`"))
            yield from self._duration_problems()
            if self.piece[0].target is None and self.piece[-1].target is None:
                yield Problem("piece[0]", None, _("stands, and so does the last one: make them one"))
        elif self.times is not None:
            yield from self._list_problems(self.times)

    def _duration_problems(self) -> Iterator[Problem]:
        """Find pieces that are too short to be followed among the others."""
        least = _SHORTEST * sum(piece.duration.si for piece in self.piece)
        allowed = _("must be at least {least}, a part in 100000 of the period, to be followed")
        for place, piece in enumerate(self.piece):
            if piece.duration.si < least:
                said = allowed.format(least=f"{least:.4g} s")
                yield Problem(f"piece[{place}].duration", piece.duration.text, said)

    def _list_problems(self, times: tuple[Given, ...]) -> Iterator[Problem]:
        """Find lists of different lengths, times that do not rise, and a period that is over before them."""
        listed = self.listed
        if listed is None:
            yield Problem("positions", None, _("is missing; or, of a rocker, swing"))
        elif self.positions is not None and self.swing is not None:
            yield Problem("swing", None, _("must not stand beside positions: a slider moves, a rocker swings"))
        elif len(listed) != len(times):
            name = "positions" if self.positions is not None else "swing"
            allowed = _("must be as many as the times, {n}")
            yield Problem(name, str(len(listed)), allowed.format(n=len(times)))
        for place in (np.flatnonzero(np.diff([one.si for one in times]) <= 0) + 1).tolist():
            allowed = _("must be more than the time before, {before}")
            yield Problem(f"times[{place}]", times[place].text, allowed.format(before=times[place - 1].text))
        if self.period is None:
            yield Problem("period", None, _("is missing; after it the first position comes again"))
        elif self.period.si <= times[-1].si - times[0].si:
            allowed = _("must be more than from the first time to the last one, {last}")
            yield Problem("period", self.period.text, allowed.format(last=times[-1].text))
        if listed is not None and len(listed) == len(times):
            yield from self._rest_problems(times, listed)

    def _rest_problems(self, times: tuple[Given, ...], listed: tuple[Given, ...]) -> Iterator[Problem]:
        """Find rests that are not from one time to the next, whose ends are apart, or that are there twice."""
        clock = [time.si for time in times]
        for number, rest in enumerate(self.rest):
            at = f"rest[{number}]"
            if rest.begin.si not in clock:
                yield Problem(f"{at}.begin", rest.begin.text, _("must be one of the times"))
                continue
            place = clock.index(rest.begin.si)
            after = (place + 1) % len(clock)
            if rest.until.si != clock[after]:
                allowed = _("must be the time after its beginning, {after}; a longer rest is several")
                yield Problem(f"{at}.until", rest.until.text, allowed.format(after=times[after].text))
            elif listed[place].si != listed[after].si:
                allowed = _("must stand still, but goes from {begin} to {end}; give one position twice")
                said = allowed.format(begin=listed[place].text, end=listed[after].text)
                yield Problem(at, None, said)
            if any(other.begin.si == rest.begin.si for other in self.rest[:number]):
                yield Problem(f"{at}.begin", rest.begin.text, _("is there twice; a rest is given once"))
