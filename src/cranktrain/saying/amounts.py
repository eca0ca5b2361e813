"""Values: with how many digits each is written, in its unit; of results in tables, four figures."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from math import floor, log10
from typing import Literal, NamedTuple, TypeAlias

import numpy as np

from cranktrain.language import Said, Words
from cranktrain.language import said as _
from cranktrain.motion import Array
from cranktrain.quantities import chosen_unit
from cranktrain.saying.scales import scale_for
from cranktrain.saying.wording import ABSENT, decimals_for, seen, signless

KEPT = "\N{NO-BREAK SPACE}"
"""Stands where a line is not to be folded, as between a value and its unit."""

_FIGURES = 4
_MOST_DECIMALS = 8
"""Of values that are to be told apart."""
_ROUNDING = 1e-9
"""Of the largest value, and of a unit; what is less is nothing beside it."""

_DECIMALS = {"rad": 2, "deg": 2, "position": 1, "off": 0, "number": 0}
"""Of these, whatever their size, unless another unit is chosen."""

_PLACES = {"deg", "position"}
"""Where something stands: 0 is a place among others, and nearly there is there."""

_FEW_FIGURES = {"error": 2}
"""Of errors, that say how far off something is."""


def in_cycle(angles: Array, cycle: float, unit: Literal["deg", "position"]) -> Array:
    """Crank angles as they are said: one that would be said to be the end of the cycle is its beginning.

    Parameters
    ----------
    angles : Array, any shape
        [deg]
    cycle : float
        Where it begins again, infinity where it does not. [deg]
    unit : "deg" or "position"
        With whose digits they are said.

    Returns
    -------
    Array, the same shape
        [deg]

    Examples
    --------
    >>> in_cycle(np.array([359.97, 359.94, 12.0]), 360.0, "position").tolist()
    [0.0, 359.94, 12.0]
    """
    return np.where(np.round(angles, _DECIMALS[unit]) == cycle, 0.0, angles)


class Written(NamedTuple):
    """Values as text, and the label of their unit."""

    texts: tuple[str, ...]
    label: str

    def whole(self, text: str) -> str:
        """One of the texts with its unit."""
        return f"{text}{'' if self.label in ('', '°') else KEPT}{self.label}"


def written(
    values: Array, unit: str, *, apart: bool = False, beside: float = 0.0, measured: Array | None = None
) -> Written:
    """Write values of one quantity with four figures each; what is rounding beside the largest of them is 0.

    Parameters
    ----------
    values : Array, shape (n,)
        In SI. What is not finite is absent.
    unit : str
        As `AnswerLine` has it.
    apart : bool
        Whether there are to be digits enough to tell them apart.
    beside : float
        Size of the largest value beside which these stand, and whose unit they have.
    measured : Array, shape (n,), optional
        Size beside which each is measured; that of the largest of all unless given.
    """
    sizes = np.abs(values[np.isfinite(values)])
    most = float(np.max(sizes, initial=0.0))
    scale = scale_for(unit, max(most, beside))
    sized = [float(scale.of(float(value))) for value in values]
    each = np.full(len(sized), most) if measured is None else measured
    nothing = [max(1.0, abs(float(scale.of(float(one))))) * _ROUNDING for one in each]
    decimals = _decimals_of(sized, nothing, abs(float(scale.of(most))), unit, apart=apart)
    sign = "+" if unit == "off" else ""
    return Written(tuple(_text(*one, sign) for one in zip(sized, decimals, strict=True)), scale.label)


def _decimals_of(sized: Sequence[float], nothing: Sequence[float], most: float, unit: str, *, apart: bool) -> list[int]:
    """How many decimals each of some values has, the largest of which is `most`; what is nothing has those of it."""
    figures = _FEW_FIGURES.get(unit, _FIGURES)
    fixed = None if unit == "rad" and chosen_unit("°") else _DECIMALS.get(unit)
    usual = fixed if fixed is not None else decimals_for(most, figures) if most > _ROUNDING else 0
    differs = float(np.ptp(sized)) if apart else 0.0
    needed = min(max(usual, 1 - floor(log10(differs))), _MOST_DECIMALS) if differs > _ROUNDING else usual
    if fixed is not None:
        own = [needed if unit in _PLACES else seen(abs(one), needed) for one in sized]
    else:
        own = [max(needed, decimals_for(abs(one), figures)) for one in sized]
    return [many if abs(one) > least else needed for one, many, least in zip(sized, own, nothing, strict=True)]


@dataclass(frozen=True, slots=True, repr=False)
class Amount(Said):
    """One value in words.

    Attributes
    ----------
    value : float
        In SI; a speed of rotation, a frequency and an angle in radians.
    unit : str
        As in `AnswerLine`.
    quantity : str
        Its name in the catalogue; none of what only a sentence has.
    member : tuple of Words
        Whose it is, by the quantity's dimensions.
    """

    value: float
    unit: str
    quantity: str = ""
    member: tuple[Words, ...] = ()

    @property
    def size(self) -> float:
        """How large it is; what is not known has none."""
        return float(np.abs(np.nan_to_num(self.value)))

    def said(self, say: Callable[[object], object]) -> str:
        """Say it with its unit."""
        return self.beside(self.size)

    def beside(self, size: float) -> str:
        """Say it in the unit of one of a size that it stands beside."""
        found = written(np.array([self.value]), self.unit, beside=size)
        return found.whole(found.texts[0])


@dataclass(frozen=True, slots=True, repr=False)
class BareAmount(Said):
    """One value in words without its unit, which stands elsewhere: that of one of a size beside which it stands."""

    value: float
    unit: str
    beside: float = 0.0

    def said(self, say: Callable[[object], object]) -> str:
        """Say it."""
        return written(np.array([self.value]), self.unit, beside=self.beside).texts[0]


@dataclass(frozen=True, slots=True, repr=False)
class ApartAmount(Said):
    """The value at a place among several, without its unit, with as many digits as tell all of them apart."""

    values: tuple[float, ...]
    unit: str
    place: int

    def said(self, say: Callable[[object], object]) -> str:
        """Say it."""
        return written(np.array(self.values), self.unit, apart=True).texts[self.place]


@dataclass(frozen=True, slots=True, repr=False)
class LoneFigure(Said):
    """A value of the catalogue as tables write it that stands alone, or the unit that it has there."""

    value: float
    unit: str
    is_unit: bool = False

    def said(self, say: Callable[[object], object]) -> str:
        """Say it."""
        found = figures(np.array([self.value]), self.unit)
        return found.unit if self.is_unit else found.texts[0]


@dataclass(frozen=True, slots=True, repr=False)
class UnitLabel(Said):
    """The unit in which a value of a size is said."""

    unit: str
    size: float

    def said(self, say: Callable[[object], object]) -> str:
        """Say it."""
        return scale_for(self.unit, self.size).label


@dataclass(frozen=True, slots=True, repr=False)
class Extent(Said):
    """A range in words: from `least` to `most`, both as in `Amount`, with as many digits as tell them apart.

    positions: the angles where each stands, if that is to be said. [rad]
    quantity: names in the catalogue of both ends, `least most`; of one name, the curve or the fact of which they are.
    """

    least: float
    most: float
    unit: str
    positions: tuple[float, float] | None = None
    quantity: str = ""

    @property
    def size(self) -> float:
        """How large its larger end is."""
        return float(np.max(np.abs(np.nan_to_num((self.least, self.most)))))

    def said(self, say: Callable[[object], object]) -> str:
        """Say it with its unit."""
        return self.beside(self.size)

    def beside(self, size: float) -> str:
        """Say it in the unit of one of a size that it stands beside."""
        ends = np.array([self.least, self.most])
        found = written(ends, self.unit, apart=self.positions is None, beside=size)
        first, last = found.texts[0], found.whole(found.texts[-1])
        if self.positions is not None:
            at = written(np.array(self.positions), "position")
            placed = zip((first, last), at.texts, self.positions, strict=True)
            first, last = (_placed(end, at.whole(text), angle) for end, text, angle in placed)
        elif found.texts[0] == found.texts[-1]:
            return last
        return _("{least} to {most}", least=first, most=last)


def _placed(value: str, at: str, angle: float) -> str:
    """Say a value and where it stands, if that is known."""
    return _("{value} at {angle}", value=value, angle=at) if np.isfinite(angle) else value


@dataclass(frozen=True, slots=True, repr=False)
class _Values(Said):
    """The values of a row, which stand before all else where they have columns of their own."""

    def said(self, say: Callable[[object], object]) -> str:
        """Say nothing: the row says them."""
        return ""


VALUES = _Values()
"""Stands in a row's words where its values are."""

Measured: TypeAlias = "Amount | Extent"


def measured_in(words: object) -> Iterator[Measured]:
    """Give the amounts and ranges in some words."""
    if isinstance(words, Amount | Extent):
        yield words
    elif isinstance(words, Said):
        for piece in words.each():
            yield from measured_in(piece)


def filled(words: Words, values: str = "") -> str:
    """Say words in which the values of one quantity have one unit, with those of a row in their place."""
    beside: dict[str, float] = {}
    for one in measured_in(words):
        beside[one.unit] = max(beside.get(one.unit, 0.0), one.size)

    def tell(piece: object) -> object:
        if isinstance(piece, Amount | Extent):
            return piece.beside(beside[piece.unit])
        if piece is VALUES:
            return values
        return piece.said(tell) if isinstance(piece, Said) else piece

    return str(tell(words))


def _text(value: float, decimals: int, sign: str) -> str:
    """Write a number, with a minus sign that is one."""
    if not np.isfinite(value):
        return ABSENT
    return signless(f"{round(value, decimals):{sign}.{max(decimals, 0)}f}").replace("-", "−")


class Figures(NamedTuple):
    """Numbers of one quantity as text, one for each of its members, and their unit."""

    texts: tuple[str, ...]
    unit: str


def figures(values: Array, unit: str, beside: Array | None = None) -> Figures:
    """Write the values of one quantity.

    Parameters
    ----------
    values : Array, shape (n,)
        In the unit of its catalogue entry.
    unit : str
        That unit.
    beside : Array, shape (n,), optional
        Size beside which each is measured, if that is not the largest of all.

    Returns
    -------
    Figures
        A part of less than one is given in percent.
    """
    known = values[np.isfinite(values)]
    if unit == "1" and np.all(known == np.rint(known)):
        found = written(values, "number", measured=beside)
    else:
        found = written(values, "%" if unit == "1" and np.all(np.abs(known) < 1) else unit, measured=beside)
    return Figures(found.texts, found.label)
