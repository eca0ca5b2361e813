"""Numbers for people: results in the units of the drawing office, with decimals that suit them."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.quantities import chosen_unit
from cranktrain.wording import ABSENT, figure

_SHOWN = {"m": "mm", "rad": "deg", "deg": "deg", "m/s": "m/s", "m/s^2": "m/s^2", "1": "1"}
"""Units in which sentences give a quantity of that unit, too."""

_ROUNDING = 1e-12
"""Of the largest value of a quantity; what is less is shown as 0."""

_SMALL_VOLUME = 1e-4
"""Volumes that are all smaller than this are given in cm³. [m³]"""


class Figures(NamedTuple):
    """Numbers of one quantity as text, one for each of its members, and their unit."""

    texts: tuple[str, ...]
    unit: str


def figures(values: Array, unit: str) -> Figures:
    """Write the values of one quantity.

    Parameters
    ----------
    values : Array, shape (n,)
        In the unit of its catalogue entry.
    unit : str
        That unit.

    Returns
    -------
    Figures
        A part of less than one is given in percent.
    """
    whole = values[np.isfinite(values)]
    if whole.size:
        values = np.where(np.abs(values) < _ROUNDING * np.max(np.abs(whole)), 0.0, values)
    shown = _SHOWN.get(unit)
    if unit == "m^3":
        shown = "cm^3" if whole.size and np.max(np.abs(whole)) < _SMALL_VOLUME else "L"
    si = np.deg2rad(values) if unit == "deg" else values
    chosen = chosen_unit(shown or unit)
    if chosen is not None:
        texts = [figure(float(value), chosen) for value in si]
        shown = chosen
    elif unit == "1" and np.all(whole == np.rint(whole)):
        texts = [f"{value:.0f}" for value in values]
    elif unit == "1" and np.all(np.abs(whole) < 1):
        shown = "%"
        texts = [figure(float(value), shown) for value in values]
    elif shown is None:
        texts = [f"{value:#.4g}".removesuffix(".") for value in values]
    else:
        texts = [figure(float(value), shown) for value in si]
    absent = (~np.isfinite(values)).tolist()
    kept = tuple(ABSENT if is_absent else text for text, is_absent in zip(texts, absent, strict=True))
    return Figures(kept, (shown or unit).removeprefix("1"))
