"""What the head of a column says as people write it: what stands there, in which unit, absolute or gauge."""

import re
import unicodedata
from collections.abc import Iterator
from typing import Literal, TypeAlias

from cranktrain.language import Words, _
from cranktrain.one_line import short
from cranktrain.quantities.dimensions import Dimension, is_unit

Axis: TypeAlias = Literal["angle", "displacement", "volume"]

AXES: dict[Axis, Dimension] = {
    "angle": Dimension.ANGLE,
    "displacement": Dimension.LENGTH,
    "volume": Dimension.VOLUME,
}
"""What pressures may be given over."""
_ANGLE_UNITS = (
    r"(?:°|deg|grad|град|гр)?\.?\s*(?:ca|cad|kw|atdc|п\.?\s?к\.?\s?в\.?|пкв)|degrees?|deg\.|градус\w*|(?:град|гр)\.?"
)
"""Degrees of crank angle as programs and people write them."""
_PRESSURE_UNITS = {r"(?:кг|kg|kp)/(?:см|cm)2|ата|ata": "at", r"at[üu]": "ati", r"bara": "bar", r"barü": "barg"}
"""Units of pressure that only heads have, with those of the list that they mean: old books' kg/cm² is kgf/cm²."""
_FORCE_UNITS = {r"(?:lb|lbs|pounds?)\.?": "lbf"}
"""Units of force that only heads have: what an instrument calls pounds is pounds-force."""
_TORQUE_UNITS = {
    r"(?:ft|foot)[\s·*.-]?(?:lb|lbs|pounds?)|(?:lb|lbs|pounds?)[\s·*.-]?(?:ft|feet)": "lbf·ft",
    r"(?:in|inch)[\s·*.-]?(?:lb|lbs|pounds?)|(?:lb|lbs|pounds?)[\s·*.-]?(?:in|inch)": "lbf·in",
}
_OF_HEADS = {
    Dimension.PRESSURE: _PRESSURE_UNITS,
    Dimension.FORCE: _FORCE_UNITS,
    Dimension.TORQUE: _TORQUE_UNITS,
}
# Both alphabets have the letter: р is Cyrillic, p Latin; х and x likewise.
_WORDS = {
    "angle": r"angle|\bcad?\b|crank|winkel|угол|угла|\bphi\b|φ|\bалфа\b|пкв",
    "volume": r"vol|\bv\b|объ[её]м",
    "displacement": r"displacement|stroke|travel|\bs\b|\b[xх]\b|hub|ход|перемещ",
    "pressure": r"press|\b[pр](?:[izцг]|cyl)?\b|druck|давлен",
}
_TIME = r"time|zeit|врем|^\s*t\s+(?:s|ms|sec)\b"
_GAUGE = (
    r"gauge|\bgage\b|\brel\b|relative|избыт|изб|überdr|(?:\b|r|t)ü\b|(?:\bbar|\bpsi)\s*g\b|кгс?\s*см[2²]\s*и\b|\bати\b"
)
_ABSOLUTE = r"\babs|абс|\bата\b|\bata\b|(?:\bbar|\bpsi)\s*a\b"


def axis_of(head: str) -> Axis | None:
    """Tell what a column's head says that it is; None for pressures and what is not known."""
    if is_pressure(head) or is_time(head):
        return None
    words = _spaced(head)
    for axis in ("angle", "volume", "displacement"):
        if re.search(_WORDS[axis], words, re.IGNORECASE):
            return axis
    for axis, dimension in AXES.items():
        if unit_in(head, dimension):
            return axis
    return None


def is_time(head: str) -> bool:
    """Whether a column's head means a time: by its word, or by a unit of time in brackets.

    Examples
    --------
    >>> is_time("time [s]"), is_time("Zeit, ms"), is_time("CA [deg]"), is_time("s [mm]"), is_time("s")
    (True, True, False, False, False)
    """
    if any(unit_in(head, dimension) for dimension in (*AXES.values(), Dimension.PRESSURE)):
        return False  # t, ms beside travel_time_deg
    return re.search(_TIME, _spaced(head), re.IGNORECASE) is not None or _in_units_of_time(head)


def _in_units_of_time(head: str) -> bool:
    """Whether brackets of a head, or what follows its comma, hold a unit of time."""
    pieces = (*re.findall(r"[\[(]([^\])]*)[\])]", head), *re.split(r",\s*", head)[1:])
    return any(is_unit(piece.strip(), Dimension.TIME) for piece in pieces)


def time_advice() -> Words:
    """What to do with a file over time."""
    return _(
        "write crank angles instead, of an encoder; at a constant speed they are 360° × speed × time, 12° for"
        " 1 ms at 2000 rpm"
    )


def is_pressure(head: str) -> bool:
    """Whether a column's head means a pressure."""
    return bool(unit_in(head, Dimension.PRESSURE) or re.search(_WORDS["pressure"], _spaced(head), re.IGNORECASE))


def is_gauge(head: str) -> bool | None:
    """Whether a column's head says that its pressures are gauge, or absolute; None where it does not say."""
    words = _spaced(head)
    if re.search(_GAUGE, words, re.IGNORECASE):
        return True
    return False if re.search(_ABSOLUTE, words, re.IGNORECASE) else None


def unit_in(head: str, dimension: Dimension) -> str | None:
    """Find a unit in a column's head: in brackets, after a comma or an underscore, or a word of it; None if none.

    Examples
    --------
    >>> unit_in("р, кгс/см2 изб.", Dimension.PRESSURE), unit_in("Druck (bar)", Dimension.PRESSURE)
    ('кгс/см2', 'bar')
    """
    return next((unit for piece in _pieces(head) if (unit := _unit(piece, dimension)) is not None), None)


def _pieces(head: str) -> Iterator[str]:
    """Give what may be the unit in a head, the likeliest first."""
    yield from map(str.strip, re.findall(r"[\[(]([^\])]*)[\])]", head))
    yield from map(str.strip, re.split(r",\s*", head)[1:])
    yield head.strip()
    yield from reversed(re.split(r"[\s,;:()\[\]]+", head))
    yield from reversed(_spaced(head).split())


def _unit(piece: str, dimension: Dimension) -> str | None:
    """Take a piece of a head for a unit; None where it is none."""
    if dimension is Dimension.ANGLE and re.fullmatch(_ANGLE_UNITS, piece, re.IGNORECASE):
        return "deg"
    if is_unit(piece, dimension):
        return piece
    plain = unicodedata.normalize("NFKC", piece).replace("^", "")
    others = _OF_HEADS.get(dimension, {})
    return next((unit for form, unit in others.items() if re.fullmatch(form, plain, re.IGNORECASE)), None)


def _spaced(head: str) -> str:
    """A head's words with blanks between them: `p_abs_Pa` as `p abs Pa`."""
    return re.sub(r"[_,;:/()\[\]]+", " ", head)


def in_head(said: Words, head: str) -> Words:
    """Say what a head lacks with the head, where there is one."""
    return _("{said}, in the head “{head}”", said=said, head=short(head)) if head else said
