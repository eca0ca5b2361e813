"""The shaft as a straight beam from bearing to bearing: equations of three moments, and of five."""

import numpy as np

from cranktrain.language import N_
from cranktrain.questions.crankshaft.bending.bearing_loads import BearingLoads, bearing_loads
from cranktrain.questions.crankshaft.bending.loads_in_spans import LoadsInSpans
from cranktrain.questions.crankshaft.bending.support_moments import Bearings, support_moments
from cranktrain.questions.crankshaft.metal.shaft import Supports
from cranktrain.questions.crankshaft.methods.bearing_method import ELASTIC, RIGID, BearingMethod


def three_moment(supports: Supports, loads: LoadsInSpans) -> BearingLoads:
    """Bearing loads of a straight shaft on rigid bearings; docs/theory/crankshaft, eq. (24.8)."""
    return _continuous(supports, loads, gives=False)


def five_moment(supports: Supports, loads: LoadsInSpans) -> BearingLoads:
    """Bearing loads of a straight shaft on elastic bearings; docs/theory/crankshaft, eqs. (24.8) to (24.10)."""
    return _continuous(supports, loads, gives=True)


def _continuous(supports: Supports, loads: LoadsInSpans, *, gives: bool) -> BearingLoads:
    settlement = supports.settlement[..., np.newaxis]
    compliance = supports.compliance[..., np.newaxis] if gives else None
    moment = support_moments(Bearings(supports.place, settlement, compliance), loads.straight, loads.cut)
    return bearing_loads(supports.place, loads.cut, moment, settlement=settlement, compliance=compliance)


THREE_MOMENT = BearingMethod(
    "three_moment",
    N_("three moments"),
    three_moment,
    "docs/theory/crankshaft",
    N_("a straight beam in each span, its EI the mean of both planes of the throws, on rigid bearings"),
    RIGID,
    rank=4,
)

FIVE_MOMENT = BearingMethod(
    "five_moment",
    N_("five moments"),
    five_moment,
    "docs/theory/crankshaft",
    N_("a straight beam in each span, its EI the mean of both planes of the throws, on elastic bearings"),
    ELASTIC,
    rank=3,
    beside=N_("{load} in bearing {bearing}; a straight shaft {other}"),
)
