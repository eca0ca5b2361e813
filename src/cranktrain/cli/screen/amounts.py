"""Values on the screen: with how many digits each is written, in its unit; of results in tables, four figures."""

from collections.abc import Mapping, Sequence
from math import floor, log10
from typing import NamedTuple

import numpy as np

from cranktrain.cli.screen.typesetting import KEPT
from cranktrain.language import _
from cranktrain.motion import Array
from cranktrain.quantities import chosen_unit
from cranktrain.saying.rows import Amount, Extent, Piece
from cranktrain.saying.scales import scale_for
from cranktrain.saying.wording import ABSENT, decimals_for, seen, signless

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


def filled(words: str, pieces: Mapping[str, Piece]) -> str:
    """Put values into words; those of one quantity have one unit."""
    beside: dict[str, float] = {}
    for one in pieces.values():
        if not isinstance(one, str):
            beside[one.unit] = max(beside.get(one.unit, 0.0), *np.abs(np.nan_to_num(_values(one))).tolist())
    return words.format(**{name: _piece(one, beside) for name, one in pieces.items()})


def _values(piece: Amount | Extent) -> Array:
    return np.array([piece.value] if isinstance(piece, Amount) else [piece.least, piece.most])


def _piece(piece: Piece, beside: Mapping[str, float]) -> str:
    """Write what stands in words."""
    if isinstance(piece, str):
        return piece
    is_span = isinstance(piece, Extent)
    found = written(_values(piece), piece.unit, apart=is_span and piece.positions is None, beside=beside[piece.unit])
    last = found.whole(found.texts[-1])
    if not is_span or (found.texts[0] == found.texts[-1] and piece.positions is None):
        return last
    if piece.positions is None:
        return _("{least} to {most}", least=found.texts[0], most=last)
    at = written(np.array(piece.positions), "position")
    ends = (found.texts[0], last)
    placed = [
        _("{value} at {angle}", value=end, angle=at.whole(text)) if np.isfinite(angle) else end
        for end, text, angle in zip(ends, at.texts, piece.positions, strict=True)
    ]
    return _("{least} to {most}", least=placed[0], most=placed[1])


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
