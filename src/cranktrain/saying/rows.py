"""Rows of the answer as data: a name, and SI values of some members or words with SI values in them."""

from collections.abc import Mapping, Sequence
from dataclasses import field
from functools import cache
from math import inf
from string import Formatter

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import Message, Words, _
from cranktrain.motion import Array
from cranktrain.record import record
from cranktrain.saying.amounts import VALUES, Amount, Extent, in_cycle, measured_in
from cranktrain.saying.catalogue import Entry, entries, values
from cranktrain.saying.wording import Names

_SAME = 1e-6
"""Values are one where they differ by less than this part of the largest."""
_ROUNDING = 1e-9
"""Of a size; what is less is nothing beside it."""


@record
class AnswerLine:
    """One line of the answer.

    Attributes
    ----------
    name : Words
        What it is.
    values : Array, shape (member,)
        In SI; none where words say all. NaN is no value.
    unit : str
        What the values are: a unit of SI as the catalogue has it, or of those that say more, "rpm", "Hz" (both in
        rad/s), "position" (an angle where something stands, in rad), "%" (of 1), "error" and "off" (of 1, the latter
        with its sign).
    members : tuple of Words
        Whose each value is; none of one value.
    words : Words
        Instead of values, or with `{values}` where they stand; nothing where these say all.
    quantity : str
        Name in the catalogue of what the values, or numbers in words that are no amounts, are.
    """

    name: Words
    values: Array = field(default_factory=lambda: np.empty(0))
    unit: str = ""
    members: tuple[Words, ...] = ()
    words: Words = ""
    quantity: str = ""

    @property
    def whose(self) -> tuple[str, ...]:
        """The members as people call them here and now."""
        return tuple(map(str, self.members))

    @property
    def quantities(self) -> tuple[str, ...]:
        """Names in the catalogue of all that it tells, the values' first."""
        told = (self.quantity, *(name for one in measured_in(self.words) for name in one.quantity.split()))
        return tuple(dict.fromkeys(filter(None, told)))

    @property
    def says(self) -> bool:
        """Whether there is anything to say."""
        if self.values.size:
            return bool(np.any(np.isfinite(self.values)))
        return bool(self.words) and all(
            np.isfinite(one.value if isinstance(one, Amount) else one.most) for one in measured_in(self.words)
        )


def valued(
    name: Words,
    values: Array | float,
    unit: str,
    members: Sequence[Words] = (),
    words: Message | None = None,
    *,
    quantity: str = "",
) -> AnswerLine:
    """Give a row of values, and what is said with them: a message with `{values}` where they stand."""
    said = "" if words is None else words.format(values=VALUES)
    return AnswerLine(name, np.atleast_1d(np.asarray(values, dtype=float)), unit, tuple(members), said, quantity)


def worded(name: Words, words: Words, *, quantity: str = "") -> AnswerLine:
    """Give a row of words alone; of which quantity they tell, where no amount in them says it."""
    return AnswerLine(name, words=words, quantity=quantity)


@record
class Telling:
    """Makes rows and amounts of what results hold of one design: they know of which quantity, and whose, they are.

    Attributes
    ----------
    labels : mapping of str to sequence of str
        Names of the members along each dimension.
    titles : mapping of str to sequence of Words
        What people call them.
    design : int
    cycle : float
        Crank angle at which all begins again. [deg]
    """

    labels: Names
    titles: Mapping[str, Sequence[Words]]
    design: int
    cycle: float = inf

    def values(self, found: object, quantity: str) -> Array:
        """Give what a result holds of a quantity, in SI, along its dimensions; crank angles as they are said."""
        entry = entry_called(type(found), quantity)
        every = np.asarray(values(found, entry)[self.design], dtype=float)
        is_start = entry.is_place and in_cycle(np.degrees(every), self.cycle, "position") == 0.0
        return np.where(is_start, 0.0, every)

    def row(
        self,
        name: Words,
        found: object,
        quantity: str,
        words: Message | None = None,
        *,
        at: tuple[int, ...] = (),
        own: Sequence[int] | NDArray[np.intp] | None = None,
        unit: str = "",
        sense: float = 1.0,
    ) -> AnswerLine:
        """Give a row of a quantity, and what is said with its values.

        Parameters
        ----------
        name : Words
        found : object
            The result that holds it.
        quantity : str
        words : Message, optional
            With `{values}` where these stand.
        at : tuple of int
            Which member along each dimension but the last.
        own : sequence of int, optional
            Which members of the last; all unless given.
        unit : str
            As in `AnswerLine`, where that is not the catalogue's.
        sense : float
            1, or −1 where its opposite is told.
        """
        entry = entry_called(type(found), quantity)
        every = self.values(found, quantity)[at]
        members = self.titles[entry.dimensions[-1]] if every.ndim else ()
        if own is not None:
            every, members = every[np.asarray(own)], [members[int(i)] for i in own]
        return valued(name, sense * every, unit or _shown(entry), members, words, quantity=quantity)

    def amount(
        self, found: object, quantity: str, *member: int, unit: str = "", sense: float = 1.0, beside: float = 0.0
    ) -> Amount:
        """Give the amount of a quantity, of a member by its place along each dimension; other parameters as of `row`.

        beside: what is rounding beside this is nothing.
        """
        entry = entry_called(type(found), quantity)
        value = float(self.values(found, quantity)[member])
        if abs(value) <= _ROUNDING * beside:
            value = 0.0
        whose = tuple(self.titles[name][place] for name, place in zip(entry.dimensions, member, strict=True))
        return Amount(sense * value, unit or _shown(entry), quantity, whose)

    def extent(
        self,
        found: object,
        least: str,
        most: str,
        *member: int,
        unit: str = "",
        sense: float = 1.0,
        placed: bool = False,
    ) -> Extent:
        """Give the range between two quantities of one unit, with the angles of both if these are to be said."""
        low, high = (self.amount(found, one, *member, unit=unit, sense=sense) for one in (least, most))
        places = [entry_called(type(found), one).at for one in (least, most)] if placed else []
        angles = tuple(self.amount(found, one, *member).value for one in places)
        return Extent(low.value, high.value, low.unit, (angles[0], angles[1]) if angles else None, f"{least} {most}")

    def alike(self, found: object, quantity: str, *, unit: str = "") -> Amount | None:
        """Give the amount that a quantity is of all its members; None where they differ by more than rounding."""
        every = self.values(found, quantity)
        known = every[np.isfinite(every)]
        if known.size == 0 or np.ptp(known) > _SAME * max(float(np.max(np.abs(known))), _SAME):
            return None
        return Amount(float(known[0]), unit or _shown(entry_called(type(found), quantity)), quantity)

    def line(self, name: Words, message: str, found: object, **pieces: Words) -> AnswerLine:
        """Give a row of words in which `{name}` stands for the amount of a quantity of a result, or for a piece.

        The message is marked for translators where it is written: `line(_("rim"), N_("{rim_mass}, {rim_speed}"), rim)`.
        """
        named = [piece for _text, piece, _form, _sign in Formatter().parse(message) if piece]
        each = {one: pieces[one] if one in pieces else self.amount(found, one) for one in named}
        return worded(name, _(message, **each))


@cache
def _by_name(kind: type) -> Mapping[str, Entry]:
    """Quantities of a result's class."""
    return {entry.name: entry for entry in entries(kind)}


def entry_called(kind: type, quantity: str) -> Entry:
    """Find a quantity of a result's class by its name."""
    return _by_name(kind)[quantity]


def _shown(entry: Entry) -> str:
    """What values of a quantity are in rows, where all angles are in radians."""
    return "position" if entry.is_place else "rad" if entry.shown == "deg" else entry.shown
