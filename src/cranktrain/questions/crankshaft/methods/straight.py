"""The shaft as a straight beam from bearing to bearing: equations of three moments, and of five."""

import numpy as np

from cranktrain.language import N_
from cranktrain.questions.crankshaft.bearing_loads import BearingLoads, bearing_loads
from cranktrain.questions.crankshaft.bearing_method import BearingMethod
from cranktrain.questions.crankshaft.designs_alike import Alike
from cranktrain.questions.crankshaft.shaft import Crankshaft
from cranktrain.questions.crankshaft.shaft_loads import ShaftLoads, on_axis
from cranktrain.questions.crankshaft.spans import cut_shaft
from cranktrain.questions.crankshaft.straight_spans import straight_spans
from cranktrain.questions.crankshaft.support_moments import Bearings, support_moments


def three_moment(shaft: Crankshaft, loads: ShaftLoads, alike: Alike) -> BearingLoads:
    """Bearing loads of a straight shaft on rigid bearings; docs/theory/crankshaft, eq. (24.8)."""
    return _continuous(shaft, loads, alike, gives=False)


def five_moment(shaft: Crankshaft, loads: ShaftLoads, alike: Alike) -> BearingLoads:
    """Bearing loads of a straight shaft on elastic bearings; docs/theory/crankshaft, eqs. (24.8) to (24.10)."""
    return _continuous(shaft, loads, alike, gives=True)


def _continuous(shaft: Crankshaft, loads: ShaftLoads, alike: Alike, *, gives: bool) -> BearingLoads:
    supports = shaft.supports
    along = on_axis(loads)
    cut = cut_shaft(supports.place, alike.loads, along)
    spans = straight_spans(supports.place, shaft.straight, alike.loads, along)
    settlement = supports.settlement[..., np.newaxis]
    compliance = supports.compliance[..., np.newaxis] if gives else None
    moment = support_moments(Bearings(supports.place, settlement, compliance), spans, cut)
    return bearing_loads(supports.place, cut, moment, settlement=settlement, compliance=compliance)


THREE_MOMENT = BearingMethod(
    "three_moment",
    N_("three moments"),
    three_moment,
    "docs/theory/crankshaft",
    N_("a straight beam in each span, its EI the mean of both planes of the throws, on rigid bearings"),
)

FIVE_MOMENT = BearingMethod(
    "five_moment",
    N_("five moments"),
    five_moment,
    "docs/theory/crankshaft",
    N_("a straight beam in each span, its EI the mean of both planes of the throws, on elastic bearings"),
)
