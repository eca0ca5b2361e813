"""Crosshead, piston rod and cylinder of a piston that works at its crank end, by places along the line of stroke."""

import numpy as np

from cranktrain.motion import Array
from cranktrain.record import record

_USUAL_ROD = 0.16
"""Diameter of a piston rod that the file does not give, in parts of the bore."""

_THICKNESS, _GAP, _GLAND = 0.30, 0.05, 0.20
"""Thickness of the piston, what is left between it and either cover, length of the gland; in parts of the bore."""

_SHOE, _HEIGHT, _OVER, _ROOM = 0.50, 0.60, 0.05, 0.10
"""Length and height of the crosshead, bars beyond it at either end, room between bars and gland; of the stroke."""

_ABOUT_ROD = 1.3
"""Least height of the crosshead in diameters of the piston rod."""


@record
class CrossheadDrawing:
    """What stands between a connecting rod and a piston that works at its crank end, too.

    Bore and piston rod are as the file has them; all lengths along the line are such as are usual: the piston rod is
    so long that the crosshead on its bars never meets the gland.

    Attributes
    ----------
    rod_length : float
        From the crosshead's pin to the middle of the piston. [m]
    rod_diameter : float
        Of the piston rod. [m]
    piston : float
        Thickness of the piston. [m]
    shoe : Array, shape (2,)
        Length of the crosshead along the line, and its height between the bars; the pin is in its middle. [m]
    bars : Array, shape (2,)
        Where the slide bars begin and end, from the foot of the line. [m]
    gland : float
        Where the gland of the piston rod ends, toward the shaft. [m]
    covers : Array, shape (2,)
        Inner faces of the cover at the crank end, through which the piston rod goes, and of that at the head. [m]
    """

    rod_length: float
    rod_diameter: float
    piston: float
    shoe: Array
    bars: Array
    gland: float
    covers: Array


def crosshead_of(travel: Array, bore: float, piston_rod: float | None) -> CrossheadDrawing:
    """Give crosshead and cylinder of a piston that works at its crank end.

    Parameters
    ----------
    travel : Array, shape (2,)
        Nearest and farthest place of the crosshead's pin from the foot of its line. [m]
    bore : float
        [m]
    piston_rod : float or None
        Diameter; a usual one where the file has none. [m]

    Returns
    -------
    CrossheadDrawing
        In the unit of what is given.

    Examples
    --------
    >>> found = crosshead_of(np.array([1.0, 1.5]), 0.4, None)
    >>> bool(found.bars[1] < found.gland < found.covers[0])
    True
    """
    stroke = float(travel[1] - travel[0])
    rod = _USUAL_ROD * bore if piston_rod is None else piston_rod
    over = (0.5 * _SHOE + _OVER) * stroke
    bars = travel + np.array([-over, over])
    gland = float(bars[1]) + _ROOM * stroke
    cover = gland + _GLAND * bore
    beside = (0.5 * _THICKNESS + _GAP) * bore
    length = cover + beside - float(travel[0])
    return CrossheadDrawing(
        rod_length=length,
        rod_diameter=rod,
        piston=_THICKNESS * bore,
        shoe=np.array([_SHOE * stroke, max(_HEIGHT * stroke, _ABOUT_ROD * rod)]),
        bars=bars,
        gland=gland,
        covers=np.array([cover, float(travel[1]) + length + beside]),
    )
