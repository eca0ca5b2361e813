"""The shaft cut at its bearings: simple beams between them, what hangs over, and their reactions."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.questions.crankshaft.bending.shaft_loads import AxisLoads


class CutShaft(NamedTuple):
    """A shaft with a hinge at every bearing.

    Attributes
    ----------
    reaction : Array, shape (design, bearing, 2, angle)
        On the shaft: of simple beams between bearings, and of what hangs over as a force at the nearest bearing. [N]
    first_moment, last_moment : Array, shape (design, 2, angle)
        Bending moments of what hangs over at the first and the last bearing. [N·m]
    """

    reaction: Array
    first_moment: Array
    last_moment: Array


def spans_of(place: Array, z: Array) -> NDArray[np.intp]:
    """Between which bearings each place lies, shape (design, load): 0 before the first; after the last, how many.

    A place at a bearing lies before it.
    """
    return np.sum(z[:, :, np.newaxis] > place[:, np.newaxis, :], axis=-1)


def cut_shaft(place: Array, spans: NDArray[np.intp], loads: AxisLoads) -> CutShaft:
    """Cut the shaft at its bearings.

    Parameters
    ----------
    place : Array, shape (design, bearing)
    spans : array of int, shape (load,)
        As `spans_of` says, of all designs alike.
    loads : AxisLoads

    Returns
    -------
    CutShaft

    Notes
    -----
    docs/theory/crankshaft, eqs. (24.4) and (24.5).
    """
    n_designs, n = place.shape
    shape = (n_designs, 2, loads.force.shape[-1])
    reaction = np.zeros((n_designs, n, *shape[1:]))
    first_moment, last_moment = np.zeros(shape), np.zeros(shape)
    for load, span in enumerate(spans.tolist()):
        force = loads.force[:, load]
        couple = 0.0 if loads.couple is None else loads.couple[:, load]
        z = loads.z[:, load, np.newaxis, np.newaxis]
        if span == 0:
            reaction[:, 0] -= force
            first_moment += (place[:, 0, np.newaxis, np.newaxis] - z) * force - couple
        elif span == n:
            reaction[:, -1] -= force
            last_moment += (z - place[:, -1, np.newaxis, np.newaxis]) * force + couple
        else:
            left, right = (place[:, bearing, np.newaxis, np.newaxis] for bearing in (span - 1, span))
            length = right - left
            reaction[:, span - 1] -= ((right - z) * force - couple) / length
            reaction[:, span] -= ((z - left) * force + couple) / length
    return CutShaft(reaction, first_moment, last_moment)
