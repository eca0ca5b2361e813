"""Straight shafts of one piece, for what has nothing to do with throws."""

import numpy as np

from cranktrain.questions.crankshaft.bending.shaft_loads import ShaftLoads
from cranktrain.questions.crankshaft.metal.shaft import Crankshaft, Pieces, StraightSpans, Supports, Webs


def straight_shaft(place, *, bending=1.0, shear=np.inf, compliance=0.0, settlement=None, clearance=0.0):
    """Bearings at places, one design; the same stiffness all along, and the same bearings."""
    place = np.asarray(place, dtype=float)[np.newaxis]
    n = place.shape[1]
    one, none = np.ones((1, 1)), np.zeros((1, 0))
    settlement = np.zeros((n, 2)) if settlement is None else np.asarray(settlement, dtype=float)
    return Crankshaft(
        Pieces(np.array([[-1e3, 1e3]]), 0 * one, 0 * one, bending * one, bending * one, shear * one, bending * one),
        Webs(none, none, none, none, none, np.zeros((1, 0, 2))),
        Supports(
            place,
            np.where(np.eye(2, dtype=bool), np.full((1, n, 1, 1), compliance), 0.0),
            settlement[np.newaxis],
            np.full((1, n), float(clearance)),
        ),
        StraightSpans(np.full((1, n - 1), float(bending)), np.full((1, n - 1), float(shear))),
    )


def forces_on(z, force, *, couple=None):
    """Forces toward X and Y, shape (load, 2), on the axis of a straight shaft, at a single angle."""
    z, force = np.asarray(z, dtype=float)[np.newaxis], np.asarray(force, dtype=float)[np.newaxis, ..., np.newaxis]
    n = z.shape[1]
    return ShaftLoads(
        np.zeros(n, dtype=np.intp),
        np.zeros(n, dtype=np.bool_),
        z,
        np.zeros((1, n)),
        np.zeros((1, n)),
        np.zeros((1, 1)),
        force,
        None if couple is None else np.asarray(couple, dtype=float)[np.newaxis, ..., np.newaxis],
    )
