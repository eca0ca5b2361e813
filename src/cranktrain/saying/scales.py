"""In which unit a quantity is shown on the screen, in tables, comparisons and curves: the usual one, or a reader's."""

from collections.abc import Mapping
from typing import NamedTuple, TypeVar

from cranktrain.motion import Array
from cranktrain.quantities import asked_unit, chosen_unit, of_result, shown

Size = TypeVar("Size", float, Array)


class Scale(NamedTuple):
    """A unit in which something is shown.

    Attributes
    ----------
    label : str
        Behind the number.
    least : float
        From which size on, in SI, it is taken.
    factor : float or None
        How many of it one in SI is; None for a unit of the list of machine files.
    """

    label: str
    least: float = 0.0
    factor: float | None = None

    def of(self, si: Size) -> Size:
        """Express SI values in it."""
        return shown(si, self.label) if self.factor is None else si * self.factor

    @property
    def one(self) -> float:
        """What one of it is in SI."""
        return 1.0 / self.of(1.0)


def _scale(unit: str, usual: str) -> Scale:
    """Scale of a unit of the list for what is usually shown in one; with a factor where its SI is another."""
    plainly, angular = float(shown(1.0, unit)), float(of_result(1.0, unit, usual))
    return Scale(unit) if plainly == angular else Scale(unit, factor=angular)


_DEGREE = Scale("°")
_PERCENT = Scale("%", factor=100.0)

SCALES: Mapping[str, tuple[Scale, ...]] = {
    "m": (Scale("mm"),),
    "m^2": (Scale("cm²"),),
    "m^3": (Scale("L", 1e-4), Scale("cm³")),
    "m^3/s": (Scale("m³/h"),),
    "kg/s": (Scale("kg/h"),),
    "J/m^3": (Scale("kW/(m³/min)", factor=1 / 6e4),),
    "m/s": (Scale("m/s"),),
    "m/s^2": (Scale("m/s²"),),
    "rad": (_DEGREE,),
    "position": (_DEGREE,),
    "deg": (Scale("°", factor=1.0),),
    "rad/s": (Scale("rad/s"),),
    "rad/s^2": (Scale("rad/s²"),),
    "rpm": (Scale("rpm"),),
    "Hz": (_scale("Hz", "Hz"),),
    "N": (Scale("kN", 1e3), Scale("N")),
    "N*m": (Scale("kN·m", 1e4), Scale("N·m")),
    "N*m/rad": (Scale("MN·m/rad", 1e5), Scale("N·m/rad")),
    "Pa": (Scale("bar"),),
    "W": (Scale("kW", 1e2), Scale("W")),
    "J": (Scale("kJ", 1e5), Scale("J")),
    "kg": (Scale("kg"),),
    "s": (Scale("s"),),
    "kg*m^2": (Scale("kg·m²"),),
    "K": (Scale("K"),),
    "%": (_PERCENT,),
    "error": (_PERCENT,),
    "off": (_PERCENT,),
    "1": (Scale("", factor=1.0),),
    "number": (Scale("", factor=1.0),),
}
"""Units by what is to be shown, the largest first: the catalogue's, and those of `AnswerLine`."""


_FIXED = {"deg", "position"}
"""Crank angles are in degrees, whatever unit is chosen for angles."""

_BY_ANGLE = ("/rad", "/rad^2")
"""Derivatives by an angle are shown in the unit of what they are of."""


def scale_for(unit: str, size: float) -> Scale:
    """Choose the unit for values of which the largest has a size.

    Parameters
    ----------
    unit : str
        As the catalogue has it, or `AnswerLine`; one that is not known stays.
    size : float
        In it.

    Returns
    -------
    Scale
        What a reader chose with `shown_by`, or the machine's file has, whatever the size.

    Examples
    --------
    >>> scale_for("Pa", 5e6).label, scale_for("N", 657.7).label, scale_for("N", 66.6e3).label
    ('bar', 'N', 'kN')
    >>> scale_for("m/rad^2", 0.1)
    Scale(label='mm/rad²', least=0.0, factor=1000.0)
    """
    scales = SCALES.get(unit)
    if scales is not None:
        chosen = None if unit in _FIXED else chosen_unit(scales[-1].label)
        usual = next((scale for scale in scales if size >= scale.least), scales[-1])
        return usual if chosen is None else _scale(chosen, scales[-1].label)
    whole = _differentiated(unit)
    if whole is not None and whole in SCALES:
        of = scale_for(whole, size)
        return Scale(of.label + _typeset(unit[len(whole) :]), factor=of.of(1.0))
    return Scale(_typeset(unit), factor=1.0)


def in_asked_unit(unit: str, values: Array, usual: str | None = None) -> tuple[str, Array]:
    """Give values of the catalogue as data in the unit that was asked for, with its name; else as they are, in SI.

    Parameters
    ----------
    unit : str
        Of the catalogue.
    values : Array
    usual : str or None
        By what `scale_for` finds their unit for people, where that is more than the unit: a natural frequency's "Hz".

    Examples
    --------
    >>> from cranktrain.quantities import shown_by, units_by_dimension
    >>> with shown_by(units_by_dimension(["psi", "in"])):
    ...     in_asked_unit("m", 0.0254), in_asked_unit("m/rad", 0.0254), in_asked_unit("deg", 90.0)
    (('in', 1.0), ('in/rad', 1.0), ('deg', 90.0))
    """
    if unit in _FIXED:
        return unit, values
    if usual is not None and (asked := asked_unit(usual)) is not None:
        return asked, of_result(values, asked, usual)
    if (asked := asked_unit(unit)) is not None:
        return asked, shown(values, asked)
    whole = _differentiated(unit)
    if whole is not None and (asked := asked_unit(whole)) is not None:
        return asked + unit[len(whole) :], shown(values, asked)
    return unit, values


def _differentiated(unit: str) -> str | None:
    """Unit of what a derivative by the crank angle is of; None for others: angles by angles, a stiffness."""
    whole = next((unit.removesuffix(end) for end in _BY_ANGLE if unit.endswith(end)), None)
    return None if whole == "rad" or unit in SCALES else whole


def _typeset(unit: str) -> str:
    """Write a unit with its powers and dots."""
    return unit.replace("^2", "²").replace("^3", "³").replace("*", "·")
