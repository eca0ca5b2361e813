"""The shaft as it is built, of journals, webs and pins that bend and twist: on rigid bearings, and on elastic ones."""

import numpy as np

from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.questions.crankshaft.bending.bearing_loads import BearingLoads, bearing_loads
from cranktrain.questions.crankshaft.bending.blocks import product, transposed, turned_by
from cranktrain.questions.crankshaft.bending.loads_in_spans import LoadsInSpans
from cranktrain.questions.crankshaft.bending.support_moments import Bearings, support_moments
from cranktrain.questions.crankshaft.metal.shaft import Supports
from cranktrain.questions.crankshaft.methods.bearing_method import ELASTIC, RIGID, BearingMethod


def rigid_frame(supports: Supports, loads: LoadsInSpans) -> BearingLoads:
    """Bearing loads of a crank frame on rigid bearings; docs/theory/crankshaft, eqs. (24.8) and (24.14) to (24.19)."""
    return _frame(supports, loads, gives=False)


def elastic_frame(supports: Supports, loads: LoadsInSpans) -> BearingLoads:
    """Bearing loads of a crank frame on elastic bearings; docs/theory/crankshaft, eqs. (24.8) to (24.20).

    Where bearings do not give alike in all directions, the shaft turns against them: a band system for every angle.
    """
    return _frame(supports, loads, gives=True)


def _frame(supports: Supports, loads: LoadsInSpans, *, gives: bool) -> BearingLoads:
    turned, is_isotropic = loads.loads.turned, loads.of.alike.is_isotropic
    settlement = supports.settlement[..., np.newaxis]
    compliance = supports.compliance[..., np.newaxis] if gives else None
    turning = Bearings(
        supports.place,
        settlements_in_turning_axes(settlement, turned),
        None if compliance is None else in_turning_axes(compliance, turned, is_isotropic=is_isotropic),
    )
    moment = turned_by(support_moments(turning, loads.frame, loads.turning_cut), -turned)
    return bearing_loads(supports.place, loads.cut, moment, settlement=settlement, compliance=compliance)


def settlements_in_turning_axes(settlement: Array, turned: Array) -> Array:
    """Settlements of shape (design, bearing, 2, 1) in axes that turn with the shaft, for every angle."""
    return turned_by(np.broadcast_to(settlement, (*settlement.shape[:-1], turned.shape[-1])), turned)


def in_turning_axes(compliance: Array, turned: Array, *, is_isotropic: bool) -> Array:
    """Compliance of bearings, (design, bearing, 2, 2, 1), in axes that turn with the shaft: for every angle, or alike.

    Notes
    -----
    docs/theory/crankshaft, eq. (24.20).
    """
    if is_isotropic:
        return compliance
    cos, sin = np.cos(turned), np.sin(turned)
    turning = np.stack([np.stack([cos, sin], axis=1), np.stack([-sin, cos], axis=1)], axis=1)[:, np.newaxis]
    return product(product(turning, compliance), transposed(turning))


RIGID_FRAME = BearingMethod(
    "frame_rigid",
    N_("frame, rigid"),
    rigid_frame,
    "docs/theory/crankshaft",
    N_("journals, webs and pins that bend and twist, on rigid bearings"),
    RIGID,
    rank=2,
    trust=N_("between both; bearing {bearing}: {range}"),
)

ELASTIC_FRAME = BearingMethod(
    "frame_elastic",
    N_("frame, elastic"),
    elastic_frame,
    "docs/theory/crankshaft",
    N_("journals, webs and pins that bend and twist, on elastic bearings"),
    ELASTIC,
    rank=1,
    trust=N_("elastic frame; bearing {bearing} by all: {range}"),
)
