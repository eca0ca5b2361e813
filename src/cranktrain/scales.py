"""In which unit a quantity is shown on the screen, in tables, comparisons and curves: the usual one, or a reader's."""

from collections.abc import Mapping
from typing import NamedTuple, TypeVar

import numpy as np

from cranktrain.motion import Array
from cranktrain.quantities import chosen_unit, shown

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


_DEGREE = Scale("°")
_PERCENT = Scale("%", factor=100.0)

SCALES: Mapping[str, tuple[Scale, ...]] = {
    "m": (Scale("mm"),),
    "m^2": (Scale("cm²"),),
    "m^3": (Scale("L", 1e-4), Scale("cm³")),
    "m^3/s": (Scale("m³/h", factor=3600.0),),
    "m/s": (Scale("m/s"),),
    "m/s^2": (Scale("m/s²"),),
    "m/rad": (Scale("mm/rad", factor=1e3),),
    "m/rad^2": (Scale("mm/rad²", factor=1e3),),
    "rad": (_DEGREE,),
    "position": (_DEGREE,),
    "deg": (Scale("°", factor=1.0),),
    "rad/s": (Scale("rad/s"),),
    "rad/s^2": (Scale("rad/s²"),),
    "rpm": (Scale("rpm"),),
    "Hz": (Scale("Hz", factor=1 / (2 * np.pi)),),
    "N": (Scale("kN", 1e3), Scale("N")),
    "N*m": (Scale("kN·m", 1e4, factor=1e-3), Scale("N·m")),
    "Pa": (Scale("bar"),),
    "W": (Scale("kW", 1e2), Scale("W")),
    "J": (Scale("kJ", 1e5), Scale("J")),
    "kg": (Scale("kg"),),
    "kg*m^2": (Scale("kg·m²"),),
    "%": (_PERCENT,),
    "error": (_PERCENT,),
    "off": (_PERCENT,),
    "1": (Scale("", factor=1.0),),
}
"""Units by what is to be shown, the largest first: the catalogue's, and those of `AnswerLine`."""


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
        What a reader chose with `shown_by`, whatever the size.

    Examples
    --------
    >>> scale_for("Pa", 5e6).label, scale_for("N", 657.7).label, scale_for("N", 66.6e3).label
    ('bar', 'N', 'kN')
    """
    scales = SCALES.get(unit)
    chosen = None if scales is None else chosen_unit(scales[-1].label)
    if chosen is not None:
        return Scale(chosen)
    if scales is None:
        return Scale(unit.replace("^2", "²").replace("^3", "³").replace("*", "·"), factor=1.0)
    return next((scale for scale in scales if size >= scale.least), scales[-1])
