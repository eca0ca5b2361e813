"""A crankshaft as arrays: round pieces joined by webs, and the bearings that it rests on."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array


class Pieces(NamedTuple):
    """Journals and crank pins, from the free end to the flywheel; each ends in the web that joins it to the next.

    Attributes
    ----------
    bounds : Array, shape (design, piece + 1)
        z of the free end, of the middle of every web, and of the other end. [m]
    radius : Array, shape (design, piece)
        Distance from the shaft's axis: 0 of a journal. [m]
    angle : Array, shape (design, piece)
        Direction of that distance in axes that turn with the shaft, in the sense from X toward Y. [rad]
    bending : Array, shape (design, piece)
        EI. [N·m²]
    torsion : Array, shape (design, piece)
        GJ. [N·m²]
    shear : Array, shape (design, piece)
        κGA; infinite where shear is not to count. [N]
    axial : Array, shape (design, piece)
        EA. [N]
    """

    bounds: Array
    radius: Array
    angle: Array
    bending: Array
    torsion: Array
    shear: Array
    axial: Array


class Webs(NamedTuple):
    """What joins each piece to the next, straight from one axis to the other, shape (design, piece − 1).

    A web between two pieces of one axis is a shoulder, and gives nothing.

    Attributes
    ----------
    bending : Array
        EI in the plane of the web's line and the shaft's axis: E b h³/12, h along the shaft. [N·m²]
    bending_across : Array
        EI at right angles to the axis: E h b³/12. [N·m²]
    torsion : Array
        GJ about the web's own line. [N·m²]
    shear : Array
        κGA. [N]
    axial : Array
        EA. [N]
    rigid : Array, shape (design, piece − 1, 2)
        Length at its first and its second end that does not give, as it is within a journal or a pin. [m]
    """

    bending: Array
    bending_across: Array
    torsion: Array
    shear: Array
    axial: Array
    rigid: Array


class Supports(NamedTuple):
    """Main bearings, from the free end to the flywheel, each on a journal, in the machine's axes X, Y.

    Attributes
    ----------
    place : Array, shape (design, bearing)
        z of their middles, rising. [m]
    compliance : Array, shape (design, bearing, 2, 2)
        Displacement for a unit load, symmetric, by `bearing_compliance`; 0 is rigid. [m/N]
    settlement : Array, shape (design, bearing, 2)
        How far each stands from the line of the bearings. [m]
    clearance : Array, shape (design, bearing)
        Radial: half the difference of diameters. [m]
    thrust : int
        Which bearing takes axial forces.
    """

    place: Array
    compliance: Array
    settlement: Array
    clearance: Array
    thrust: int = -1


def bearing_compliance(stiffness: Array) -> Array:
    """Compliance of bearings of a stiffness, both of shape (..., 2, 2). [m/N, N/m]

    Parameters
    ----------
    stiffness : Array, shape (..., 2, 2)
        Symmetric; an infinite one toward X or Y is rigid that way.

    Returns
    -------
    Array, shape (..., 2, 2)

    Examples
    --------
    >>> bearing_compliance(np.array([[np.inf, 0.0], [0.0, 4e8]])).tolist()
    [[0.0, 0.0], [0.0, 2.5e-09]]
    """
    x, y, both = stiffness[..., 0, 0], stiffness[..., 1, 1], stiffness[..., 0, 1]
    rest = 1 - (both / x) * (both / y)
    found = np.zeros_like(stiffness)
    found[..., 0, 0], found[..., 1, 1] = 1 / x / rest, 1 / y / rest
    found[..., 0, 1] = found[..., 1, 0] = 0.0 - both / x / y / rest
    return found


def turned_compliance(first: Array, second: Array, angle: Array) -> Array:
    """Compliance in two directions at right angles, as a matrix in X and Y.

    Parameters
    ----------
    first, second : Array, shape (...)
        [m/N]
    angle : Array, shape (...)
        From X to the first direction, in the sense from X toward Y. [rad]

    Returns
    -------
    Array, shape (..., 2, 2)

    Notes
    -----
    docs/theory/crankshaft, section Equations of three and five moments: one of the matrices D there.

    Examples
    --------
    >>> turned_compliance(np.array(3.0), np.array(1.0), np.array(np.pi / 2)).round(12).tolist()
    [[1.0, 0.0], [0.0, 3.0]]
    """
    cos, sin = np.cos(angle), np.sin(angle)
    found = np.empty((*np.broadcast_shapes(first.shape, second.shape, angle.shape), 2, 2))
    found[..., 0, 0] = first * cos**2 + second * sin**2
    found[..., 1, 1] = first * sin**2 + second * cos**2
    found[..., 0, 1] = found[..., 1, 0] = (first - second) * sin * cos
    return found


class StraightSpans(NamedTuple):
    """The shaft between neighbouring bearings as straight beams, shape (design, bearing − 1).

    bending: EI [N·m²]; shear: κGA, infinite where shear is not to count [N].
    """

    bending: Array
    shear: Array


class Crankshaft(NamedTuple):
    """A crankshaft on its bearings; z runs along it from the free end to the flywheel."""

    pieces: Pieces
    webs: Webs
    supports: Supports
    straight: StraightSpans
