"""All that acts on a crankshaft but its bearings, over the crank angle."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.questions.crankshaft.bending.blocks import turned_by


class ActingPlaces(NamedTuple):
    """Where loads act on a crankshaft.

    Attributes
    ----------
    piece : array of int, shape (load,)
        Which journal or pin each acts on.
    on_web : array of bool, shape (load,)
        Whether it acts on the web that leads on from that piece, at the point of the web nearest to where it acts.
    z : Array, shape (design, load)
        Where along the shaft. [m]
    radius, angle : Array, shape (design, load)
        Where it acts in axes that turn with the shaft: distance from its axis and its direction, as in `Pieces`.
        A force on a pin has the pin's own. [m, rad]
    """

    piece: NDArray[np.intp]
    on_web: NDArray[np.bool_]
    z: Array
    radius: Array
    angle: Array


class ShaftLoads(NamedTuple):
    """Concentrated loads on a crankshaft, in the machine's axes: X to the right, Y up, z along the shaft.

    Attributes
    ----------
    piece, on_web, z, radius, angle
        Where they act, as `ActingPlaces` has it.
    turned : Array, shape (design, angle)
        Direction of the turning axes' first one, from X toward Y: falling where the shaft turns clockwise. [rad]
    force : Array, shape (design, load, 2, angle)
        On the shaft, toward X and Y. [N]
    couple : Array or None, shape (design, load, 2, angle)
        First moment of a couple, the sum of z times force; None where there is none. [N·m]
    torque : Array or None, shape (design, load, angle)
        About the shaft's axis, from X toward Y, beside that of `force` at its radius. [N·m]
    thrust : Array or None, shape (design, load, angle)
        Force along z. [N]
    """

    piece: NDArray[np.intp]
    on_web: NDArray[np.bool_]
    z: Array
    radius: Array
    angle: Array
    turned: Array
    force: Array
    couple: Array | None = None
    torque: Array | None = None
    thrust: Array | None = None

    @property
    def places(self) -> ActingPlaces:
        """Where they act."""
        return ActingPlaces(self.piece, self.on_web, self.z, self.radius, self.angle)


class AxisLoads(NamedTuple):
    """The same loads, carried over to the shaft's axis.

    Attributes
    ----------
    z : Array, shape (design, load)
    force : Array, shape (design, load, 2, angle)
    couple : Array or None, shape (design, load, 2, angle)
        With that of axial forces that act beside the axis.
    """

    z: Array
    force: Array
    couple: Array | None


def on_axis(loads: ShaftLoads) -> AxisLoads:
    """Carry loads over to the axis; what bends a straight shaft, or one that is cut at its bearings.

    Notes
    -----
    docs/theory/crankshaft, eq. (24.2).
    """
    if loads.thrust is None:
        return AxisLoads(loads.z, loads.force, loads.couple)
    arm = turned_by(np.broadcast_to(arms(loads.radius, loads.angle), loads.force.shape), -loads.turned)
    aside = -loads.thrust[:, :, np.newaxis, :] * arm
    return AxisLoads(loads.z, loads.force, aside if loads.couple is None else loads.couple + aside)


def arms(radius: Array, angle: Array) -> Array:
    """What stands at radii and angles, shape (design, place), from the axis: (design, place, 2, 1). [m]"""
    return np.stack([radius * np.cos(angle), radius * np.sin(angle)], axis=2)[..., np.newaxis]


def torque_sizes(loads: ShaftLoads) -> Array:
    """Force of each load by its arm about the shaft's axis, with its torque, shape (design, load, angle). [N·m]"""
    most = loads.radius[:, :, np.newaxis] * np.hypot(loads.force[:, :, 0], loads.force[:, :, 1])
    return most if loads.torque is None else most + np.abs(loads.torque)


def torques(loads: ShaftLoads, force: Array) -> Array:
    """Torque of each load about the shaft's axis, from X toward Y, shape (design, load, angle). [N·m]

    Parameters
    ----------
    loads : ShaftLoads
    force : Array, shape (design, load, 2, angle)
        Theirs in axes that turn with the shaft. [N]

    Notes
    -----
    docs/theory/crankshaft, eq. (24.3).
    """
    arm = arms(loads.radius, loads.angle)
    own = arm[:, :, 0] * force[:, :, 1] - arm[:, :, 1] * force[:, :, 0]
    return own if loads.torque is None else own + loads.torque
