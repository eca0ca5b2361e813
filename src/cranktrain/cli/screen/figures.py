"""Numbers of results for tables: in the units of the drawing office, with four figures."""

from typing import NamedTuple

import numpy as np

from cranktrain.cli.screen.amounts import written
from cranktrain.motion import Array


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
