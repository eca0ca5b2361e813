"""Numbers for people: results in the units of the drawing office, with decimals that suit them."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.wording import number

_SHOWN = {"m": "mm", "rad": "deg", "deg": "deg", "m/s": "m/s", "m/s^2": "m/s^2", "1": "1"}
"""Units in which sentences give a quantity of that unit, too."""

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
        `–` stands for what there is not.
    """
    whole = values[~np.isnan(values)]
    shown = _SHOWN.get(unit)
    if unit == "m^3":
        shown = "cm^3" if whole.size and np.max(np.abs(whole)) < _SMALL_VOLUME else "L"
    if unit == "1" and np.all(whole == np.rint(whole)):
        texts = [f"{value:.0f}" for value in values]
    elif shown is None:
        texts = [f"{value:#.4g}" for value in values]
    else:
        si = np.deg2rad(values) if unit == "deg" else values
        texts = [number(float(value), shown).removesuffix(f" {shown}") for value in si]
    absent = np.isnan(values).tolist()
    kept = tuple("–" if is_absent else text for text, is_absent in zip(texts, absent, strict=True))
    return Figures(kept, "" if unit == "1" else shown or unit)
