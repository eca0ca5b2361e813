"""Spans as straight beams of one stiffness each."""

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.questions.crankshaft.bending.shaft_loads import AxisLoads
from cranktrain.questions.crankshaft.bending.support_moments import SpanFlexibility
from cranktrain.questions.crankshaft.metal.shaft import StraightSpans


def straight_spans(place: Array, straight: StraightSpans, spans: NDArray[np.intp], loads: AxisLoads) -> SpanFlexibility:
    """How straight spans bend, by moments at their ends and by loads.

    Parameters
    ----------
    place : Array, shape (design, bearing)
    straight : StraightSpans
    spans : array of int, shape (load,)
        As `spans_of` says.
    loads : AxisLoads

    Returns
    -------
    SpanFlexibility

    Notes
    -----
    Shear changes what moments and couples do; what forces do it does not. docs/theory/crankshaft, eqs. (24.11) to
    (24.13).
    """
    length = np.diff(place, axis=1)
    by_shear = 1 / (straight.shear * length)
    own = length / (3 * straight.bending) + by_shear
    cross = length / (6 * straight.bending) - by_shear
    first, last = (np.zeros((*length.shape, 2, loads.force.shape[-1])) for _end in range(2))
    for load, span in enumerate((spans - 1).tolist()):
        if 0 <= span < length.shape[1]:
            before, after = loads.z[:, load] - place[:, span], place[:, span + 1] - loads.z[:, load]
            whole, shear = length[:, span], by_shear[:, span]
            scale = 1 / (6 * straight.bending[:, span] * whole)
            force = loads.force[:, load]
            first[:, span] -= _across(after * before * (whole + after) * scale) * force
            last[:, span] -= _across(before * after * (whole + before) * scale) * force
            if loads.couple is not None:
                couple = loads.couple[:, load]
                first[:, span] += _across((whole**2 - 3 * after**2) * scale - shear) * couple
                last[:, span] -= _across((whole**2 - 3 * before**2) * scale - shear) * couple
    return SpanFlexibility(_alike(own), _alike(cross), _alike(own), first, last)


def _across(values: Array) -> Array:
    """Of shape (design,), against (design, 2, angle)."""
    return values[:, np.newaxis, np.newaxis]


def _alike(values: Array) -> Array:
    """The same in both directions: (design, span) as (design, span, 2, 2, 1)."""
    return values[..., np.newaxis, np.newaxis, np.newaxis] * np.eye(2)[:, :, np.newaxis]
