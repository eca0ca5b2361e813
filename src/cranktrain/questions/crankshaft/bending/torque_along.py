"""Torque in every journal and crank pin: of all that acts before it, about its own axis."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.questions.crankshaft.bending.shaft_loads import ShaftLoads, torques
from cranktrain.questions.crankshaft.metal.shaft import Crankshaft


class TorqueAlong(NamedTuple):
    """Torque that each piece hands on toward the flywheel, from X toward Y, shape (design, piece, angle). [N·m]

    begin, end: where the piece begins and where it ends, which differ where a torque acts on it, as that of a gear.
    """

    begin: Array
    end: Array


class TorqueOfLoads(NamedTuple):
    """The same by all that acts but the bearings, and what their loads need to add to it.

    Attributes
    ----------
    along : TorqueAlong
    axis : Array, shape (design, piece, 2, angle)
        Axis of each piece, from the shaft's toward X and Y. [m]
    """

    along: TorqueAlong
    axis: Array

    def at(self, angles: NDArray[np.intp]) -> "TorqueOfLoads":
        """The same at some of the crank angles."""
        return TorqueOfLoads(TorqueAlong(*(part[..., angles] for part in self.along)), self.axis[..., angles])


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
    by_loads, bounds = torque_of_loads(shaft, loads), shaft.pieces.bounds
    return TorqueAlong(
        by_loads.along.begin + torque_by_bearings(shaft, by_loads.axis, borne, bounds[:, :-1]),
        by_loads.along.end + torque_by_bearings(shaft, by_loads.axis, borne, bounds[:, 1:]),
    )


def torque_of_loads(shaft: Crankshaft, loads: ShaftLoads) -> TorqueOfLoads:
    """Torque by all that acts on a shaft but its bearings: the same by every method."""
    pieces, turned = shaft.pieces, loads.turned
    about_axis = torques(loads)
    direction = pieces.angle[..., np.newaxis] + turned[:, np.newaxis]
    radius = pieces.radius[..., np.newaxis]
    axis = np.stack([radius * np.cos(direction), radius * np.sin(direction)], axis=2)
    begin, end = (np.empty(direction.shape) for _place in range(2))
    torque, force = np.zeros_like(turned), np.zeros((turned.shape[0], 2, turned.shape[1]))
    for piece in range(pieces.radius.shape[1]):
        for part, on_web in ((begin, False), (end, True)):
            part[:, piece] = torque - _moment(axis[:, piece], force)
            for load in np.flatnonzero((loads.piece == piece) & (loads.on_web == on_web)).tolist():
                torque, force = torque + about_axis[:, load], force + loads.force[:, load]
    return TorqueOfLoads(TorqueAlong(begin, end), axis)


def torque_by_bearings(shaft: Crankshaft, axis: Array, borne: Array, z: Array) -> Array:
    """What the bearings before places on pieces add about the pieces' axes, shape (design, piece, angle). [N·m]

    Parameters
    ----------
    shaft : Crankshaft
    axis : Array, shape (design, piece, 2, angle)
        [m]
    borne : Array, shape (design, bearing, 2, angle)
        [N]
    z : Array, shape (design, piece)
        [m]
    """
    n_before = np.sum(shaft.supports.place[:, np.newaxis] < z[..., np.newaxis], axis=-1)
    summed = np.cumsum(np.concatenate([np.zeros_like(borne[:, :1]), borne], axis=1), axis=1)
    return _moment(axis, np.take_along_axis(summed, n_before[..., np.newaxis, np.newaxis], axis=1))


def _moment(arm: Array, force: Array) -> Array:
    return arm[..., 0, :] * force[..., 1, :] - arm[..., 1, :] * force[..., 0, :]
