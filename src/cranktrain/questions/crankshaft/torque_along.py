"""Torque in every journal and crank pin: of all that acts before it, about its own axis."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.questions.crankshaft.shaft import Crankshaft
from cranktrain.questions.crankshaft.shaft_loads import ShaftLoads, torques


class TorqueAlong(NamedTuple):
    """Torque that each piece hands on toward the flywheel, from X toward Y, shape (design, piece, angle). [N·m]

    begin, end: where the piece begins and where it ends, which differ where a torque acts on it, as that of a gear.
    """

    begin: Array
    end: Array


def torque_along(shaft: Crankshaft, loads: ShaftLoads, borne: Array) -> TorqueAlong:
    """Torque in journals and pins, right for any number of throws between two bearings.

    Parameters
    ----------
    shaft : Crankshaft
    loads : ShaftLoads
    borne : Array, shape (design, bearing, 2, angle)
        Load of the bearings by any method: in pins the torque depends on it. With none it is right in journals alone.
        [N]

    Returns
    -------
    TorqueAlong

    Notes
    -----
    docs/theory/crankshaft, eqs. (24.37) and (24.38).
    """
    pieces, turned = shaft.pieces, loads.turned
    about_axis = torques(loads)
    n_pieces = pieces.radius.shape[1]
    begin, end = (np.empty((turned.shape[0], n_pieces, turned.shape[1])) for _place in range(2))
    torque, force = np.zeros_like(turned), np.zeros((turned.shape[0], 2, turned.shape[1]))
    for piece in range(n_pieces):
        axis = _axis(pieces.radius[:, piece], pieces.angle[:, piece], turned)
        begin[:, piece] = torque - _moment(axis, force - _before(shaft, borne, pieces.bounds[:, piece]))
        for load in np.flatnonzero((loads.piece == piece) & ~loads.on_web).tolist():
            torque, force = torque + about_axis[:, load], force + loads.force[:, load]
        end[:, piece] = torque - _moment(axis, force - _before(shaft, borne, pieces.bounds[:, piece + 1]))
        for load in np.flatnonzero((loads.piece == piece) & loads.on_web).tolist():
            torque, force = torque + about_axis[:, load], force + loads.force[:, load]
    return TorqueAlong(begin, end)


def _axis(radius: Array, angle: Array, turned: Array) -> Array:
    direction = angle[:, np.newaxis] + turned
    return np.stack([radius[:, np.newaxis] * np.cos(direction), radius[:, np.newaxis] * np.sin(direction)], axis=1)


def _moment(arm: Array, force: Array) -> Array:
    return arm[:, 0] * force[:, 1] - arm[:, 1] * force[:, 0]


def _before(shaft: Crankshaft, borne: Array, z: Array) -> Array:
    """What the bearings before a place bear, shape (design, 2, angle)."""
    total = np.zeros((len(borne), *borne.shape[2:]))
    for bearing in range(borne.shape[1]):
        before = (shaft.supports.place[:, bearing] < z)[:, np.newaxis, np.newaxis]
        total = total + np.where(before, borne[:, bearing], 0.0)
    return total
