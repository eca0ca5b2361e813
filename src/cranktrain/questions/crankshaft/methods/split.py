"""The shaft split at its bearings: statically determinate, with any number of throws between two of them."""

import numpy as np

from cranktrain.language import N_
from cranktrain.questions.crankshaft.bending.bearing_loads import BearingLoads, bearing_loads, end_moments
from cranktrain.questions.crankshaft.bending.loads_in_spans import LoadsInSpans
from cranktrain.questions.crankshaft.metal.shaft import Supports
from cranktrain.questions.crankshaft.methods.bearing_method import RIGID, BearingMethod


def split(supports: Supports, loads: LoadsInSpans) -> BearingLoads:
    """Bearing loads of a shaft with a hinge at every bearing; docs/theory/crankshaft, eqs. (24.4) to (24.6).

    Stiffness counts for nothing: the displacements of the journals are those of bearings that stand as they were set.
    """
    place, settlement = supports.place, supports.settlement[..., np.newaxis]
    moment = end_moments(place.shape[1], loads.cut)
    return bearing_loads(place, loads.cut, moment, settlement=settlement, compliance=None)


SPLIT = BearingMethod(
    "split",
    N_("split shaft"),
    split,
    "docs/theory/crankshaft",
    N_("a hinge at every bearing: each span carries its own loads, whatever the stiffness"),
    RIGID,
    rank=5,
    is_cut=True,
    beside=N_("{load} in bearing {bearing}; split {other}"),
)
