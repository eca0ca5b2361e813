"""The crank frame in bearings with clearance: a journal is borne where it touches, and only there."""

import numpy as np

from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.questions.crankshaft.bending.bearing_loads import BearingLoads, bearing_loads
from cranktrain.questions.crankshaft.bending.blocks import turned_by
from cranktrain.questions.crankshaft.bending.cut_shaft import CutShaft
from cranktrain.questions.crankshaft.bending.loads_in_spans import LoadsInSpans
from cranktrain.questions.crankshaft.bending.support_moments import Bearings, SpanFlexibility, support_moments
from cranktrain.questions.crankshaft.metal.shaft import Supports
from cranktrain.questions.crankshaft.methods.bearing_method import LOOSE, BearingMethod
from cranktrain.questions.crankshaft.methods.contact import TouchingShaft, displacements_in_clearance
from cranktrain.questions.crankshaft.methods.crank_frame import (
    in_turning_axes,
    settlements_in_turning_axes,
)


def clearance(supports: Supports, loads: LoadsInSpans) -> BearingLoads:
    """Bearing loads of a crank frame in bearings with clearance; docs/theory/crankshaft, eqs. (24.39) to (24.43)."""
    turned, is_isotropic = loads.loads.turned, loads.of.alike.is_isotropic
    even = _least(supports.compliance)
    rest = (supports.compliance - even[..., np.newaxis, np.newaxis] * np.eye(2))[..., np.newaxis]
    turning = Bearings(
        supports.place,
        settlements_in_turning_axes(supports.settlement[..., np.newaxis], turned),
        None if is_isotropic else in_turning_axes(rest, turned, is_isotropic=False),
    )
    shifts = displacements(turning, loads.frame, loads.turning_cut, 1 / even, supports.clearance)
    moment = support_moments(turning._replace(settlement=shifts), loads.frame, loads.turning_cut)
    return bearing_loads(
        supports.place,
        loads.cut,
        turned_by(moment, -turned),
        settlement=turned_by(shifts, -turned),
        compliance=None if is_isotropic else rest,
    )


def _least(compliance: Array) -> Array:
    """Least compliance of bearings in any direction, shape (design, bearing): what all directions have in common."""
    mean = 0.5 * (compliance[..., 0, 0] + compliance[..., 1, 1])
    least = mean - np.hypot(0.5 * (compliance[..., 0, 0] - compliance[..., 1, 1]), compliance[..., 0, 1])
    return np.where(least <= _NOTHING * mean, 0.0, least)


_NOTHING = 1e-9
"""Of a bearing that gives in one direction only, what rounding leaves in the other."""


def displacements(bearings: Bearings, spans: SpanFlexibility, cut: CutShaft, stiffness: Array, gap: Array) -> Array:
    """Where journals come to rest in their bearings.

    Parameters
    ----------
    bearings : Bearings
        With what of their compliance is not alike in all directions.
    spans : SpanFlexibility
        Of any model of the shaft.
    cut : CutShaft
    stiffness : Array, shape (design, bearing)
        What is alike in all directions, infinite of rigid bearings. [N/m]
    gap : Array, shape (design, bearing)
        Radial clearance. [m]

    Returns
    -------
    Array, shape (design, bearing, 2, angle)
    """
    n_designs, n, _two, n_angles = cut.reaction.shape
    unmoved = bearings._replace(settlement=np.zeros_like(bearings.settlement))
    force = _reactions(unmoved, spans, cut)
    contact = TouchingShaft(
        _resistance(unmoved, spans, n_angles),
        _by_point(force).reshape(-1, 2 * n),
        _by_point(bearings.settlement),
        np.repeat(gap, n_angles, axis=0),
        np.repeat(stiffness, n_angles, axis=0),
    )
    found = displacements_in_clearance(contact, contact.centre - _by_point(force) / contact.bearing[..., np.newaxis])
    return np.moveaxis(found.reshape(n_designs, n_angles, n, 2), 1, -1)


def _by_point(values: Array) -> Array:
    """Of shape (design, bearing, 2, angle), as (design and angle, bearing, 2)."""
    return np.moveaxis(values, -1, 1).reshape(-1, *values.shape[1:3])


def _reactions(bearings: Bearings, spans: SpanFlexibility, cut: CutShaft) -> Array:
    """Reactions on the shaft, shape (design, bearing, 2, angle)."""
    moment = support_moments(bearings, spans, cut)
    return -bearing_loads(bearings.place, cut, moment, settlement=bearings.settlement, compliance=None).load


def _resistance(bearings: Bearings, spans: SpanFlexibility, n_angles: int) -> Array:
    """Reactions to unit displacements of the bearings, shape (design and angle, 2·bearing, 2·bearing). [N/m]

    Displacements stand beside each other in the place of angles.
    """
    n_designs, n = bearings.place.shape
    n_alike = 1 if bearings.compliance is None else n_angles
    units = np.repeat(np.eye(2 * n), n_alike, axis=1).reshape(n, 2, -1)
    settlement = np.broadcast_to(units, (n_designs, *units.shape))
    nothing = np.zeros((n_designs, n - 1, 2, units.shape[-1]))
    unloaded = CutShaft(np.zeros_like(settlement), nothing[:, 0], nothing[:, 0])
    given = None if bearings.compliance is None else np.tile(bearings.compliance, 2 * n)
    unit_bearings = Bearings(bearings.place, settlement, given)
    found = _reactions(unit_bearings, spans._replace(first_slope=nothing, last_slope=nothing), unloaded)
    columns = found.reshape(n_designs, 2 * n, 2 * n, n_alike)
    every = np.broadcast_to(np.moveaxis(columns, -1, 1), (n_designs, n_angles, 2 * n, 2 * n))
    return every.reshape(-1, 2 * n, 2 * n)


CLEARANCE = BearingMethod(
    "clearance",
    N_("frame, with clearance"),
    clearance,
    "docs/theory/crankshaft",
    N_("journals, webs and pins that bend and twist, in bearings with clearance"),
    LOOSE,
    rank=6,
)
