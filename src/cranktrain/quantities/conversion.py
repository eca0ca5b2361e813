"""Output in the units of the list."""

from fractions import Fraction
from functools import cache
from typing import TYPE_CHECKING, TypeVar

from cranktrain.language import _
from cranktrain.quantities.dimensions import TURN, Dimension, Unit, plain, spellings
from cranktrain.quantities.refusal import QuantityError

if TYPE_CHECKING:
    from cranktrain.motion import Array


Size = TypeVar("Size", float, "Array")


def shown(si: Size, unit: str) -> Size:
    """Express an SI value in a unit of the list, for output.

    Parameters
    ----------
    si : float or array of any shape
        In SI and radians; a pressure absolute, a flywheel moment as GD² in kg·m².
    unit : str
        Any unit of any dimension, in any of its spellings.

    Returns
    -------
    float or array of the same shape

    Raises
    ------
    QuantityError
        If the unit is not of the list.

    Examples
    --------
    >>> shown(0.0635, "in"), shown(101325.0, "ati")
    (2.5, 0.0)
    """
    scale, is_factor, offset = _conversion(unit)
    return (si - offset) * scale if is_factor else (si - offset) / scale


def of_result(si: Size, unit: str, usual: str) -> Size:
    """Express a value of a result in a unit of the list, as `shown` does, by the unit in which it is usually shown.

    What is usually in Hz is the angular frequency of a vibration, in rad/s; the list's Hz are turns in a second.

    Examples
    --------
    >>> of_result(6.283185307179586, "Hz", "Hz"), of_result(6.283185307179586, "1/h", "Hz"), of_result(0.5, "mm", "mm")
    (1.0, 3600.0, 500.0)
    """
    return shown(si / float(TURN) if usual == "Hz" else si, unit)


def in_other_unit(number: Fraction, unit: str, other: str) -> Fraction | None:
    """Express a number of one unit of the list in another, exactly; None where nothing is measured in both.

    Examples
    --------
    >>> in_other_unit(Fraction(14, 100), "m", "mm"), in_other_unit(Fraction(1), "m", "kg")
    (Fraction(140, 1), None)
    """
    own, wanted = plain(unit), plain(other)
    for dimension in Dimension:
        known = spellings(dimension)
        if own in known and wanted in known:
            (one, _form), (two, _other_form) = known[own], known[wanted]
            return (number * one.scale + one.offset - two.offset) / two.scale
    return None


@cache
def _conversion(name: str) -> tuple[float, bool, float]:
    """What to multiply with, or else to divide by, whichever is exact in binary; and what to take off before.

    So 0.07 m are 70 mm and not 70.00000000000001.
    """
    unit = _unit_called(name)
    per_unit = float(1 / unit.scale)
    if Fraction(per_unit) == 1 / unit.scale:
        return per_unit, True, float(unit.offset)
    return float(unit.scale), False, float(unit.offset)


def _unit_called(name: str) -> Unit:
    """Find a unit in the whole list."""
    key = plain(name)
    for dimension in Dimension:
        if key in spellings(dimension):
            return spellings(dimension)[key][0]
    every = dict.fromkeys(unit.name for dimension in Dimension for unit in dimension.units)
    raise QuantityError(name, _("must be one of the units {units}", units=", ".join(every)))
