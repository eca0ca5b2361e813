"""Torque in every journal and crank pin: of all that acts before it, about its own axis."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.questions.crankshaft.bending.blocks import turned_by
from cranktrain.questions.crankshaft.bending.shaft_loads import ShaftLoads, arms, torques
from cranktrain.questions.crankshaft.metal.shaft import Crankshaft


class TorqueAlong(NamedTuple):
    """Torque that each piece hands on toward the flywheel, from X toward Y, shape (design, piece, angle). [N·m]

    begin, end: where the piece begins and where it ends, which differ where a torque acts on it, as that of a gear.
    """

    begin: Array
    end: Array


class TorqueOfLoads(NamedTuple):
    """Torque by all that acts but the bearings, and what their loads need to add to it.

    Attributes
    ----------
    torque : Array, shape (design, piece, angle)
        [N·m]
    axis : Array, shape (design, piece, 2, 1)
        Axis of each piece, from the shaft's, in axes that turn with it. [m]
    """

    torque: Array
    axis: Array

    def at(self, angles: NDArray[np.intp]) -> "TorqueOfLoads":
        """The same at some of the crank angles."""
        return self._replace(torque=self.torque[..., angles])


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
    force, turning = turned_by(loads.force, loads.turned), turned_by(borne, loads.turned)
    bounds = shaft.pieces.bounds

    def at(z: Array, *, behind: bool) -> Array:
        by_loads = torque_of_loads(shaft, loads, force, behind=behind)
        return by_loads.torque + torque_by_bearings(shaft, by_loads.axis, turning, z)

    return TorqueAlong(at(bounds[:, :-1], behind=False), at(bounds[:, 1:], behind=True))


def torque_of_loads(shaft: Crankshaft, loads: ShaftLoads, force: Array, *, behind: bool = False) -> TorqueOfLoads:
    """Torque by all that acts on a shaft but its bearings, where pieces begin: the same by every method.

    Parameters
    ----------
    shaft : Crankshaft
    loads : ShaftLoads
    force : Array, shape (design, load, 2, angle)
        Of the loads in axes that turn with the shaft. [N]
    behind : bool
        Where pieces end instead, behind all that acts on them.
    """
    pieces = shaft.pieces
    # Before what acts on a piece, that on it, and that on the web behind it.
    place = 2 * loads.piece + loads.on_web
    order = np.argsort(place, kind="stable")
    ends: NDArray[np.intp] = 2 * np.arange(pieces.radius.shape[1], dtype=np.intp) + behind
    n_before = np.searchsorted(place[order], ends)
    torque, summed = (_summed(part[:, order])[:, n_before] for part in (torques(loads, force), force))
    axis = arms(pieces.radius, pieces.angle)
    return TorqueOfLoads(torque - _moment(axis, summed), axis)


def torque_by_bearings(shaft: Crankshaft, axis: Array, borne: Array, z: Array) -> Array:
    """What the bearings before places on pieces add about the pieces' axes, shape (design, piece, angle). [N·m]

    Parameters
    ----------
    shaft : Crankshaft
    axis : Array, shape (design, piece, 2, 1)
        [m]
    borne : Array, shape (design, bearing, 2, angle)
        In axes that turn with the shaft, as the axis of a piece. [N]
    z : Array, shape (design, piece)
        [m]
    """
    n_before = np.sum(shaft.supports.place[:, np.newaxis] < z[..., np.newaxis], axis=-1)
    return _moment(axis, np.take_along_axis(_summed(borne), n_before[..., np.newaxis, np.newaxis], axis=1))


def _summed(values: Array) -> Array:
    """Sums of the first none, one, two, … along the second axis."""
    return np.cumsum(np.concatenate([np.zeros_like(values[:, :1]), values], axis=1), axis=1)


def _moment(arm: Array, force: Array) -> Array:
    return arm[..., 0, :] * force[..., 1, :] - arm[..., 1, :] * force[..., 0, :]
