"""What bearings carry, from the bending moments of the shaft over them; and whether it balances the loads."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.questions.crankshaft.bending.blocks import applied
from cranktrain.questions.crankshaft.bending.cut_shaft import CutShaft
from cranktrain.questions.crankshaft.bending.shaft_loads import AxisLoads
from cranktrain.questions.crankshaft.metal.shaft import Supports


class BearingLoads(NamedTuple):
    """What a method finds, in the machine's axes X, Y, shape (design, bearing, 2, angle).

    Attributes
    ----------
    load : Array
        Of the journal on the bearing; the bearing's reaction on the shaft is its opposite. [N]
    moment : Array
        Bending moment of the shaft over the bearing, by the direction of the loads that cause it; positive where the
        shaft's ends bend toward +X, +Y. [N·m]
    displacement : Array
        Of the journal, from the line of the bearings. [m]
    """

    load: Array
    moment: Array
    displacement: Array


class Resultant(NamedTuple):
    """What loads come to together, and the largest of them.

    Attributes
    ----------
    force : Array, shape (design, 2, angle)
        Sum of all forces across the shaft. [N]
    moment : Array, shape (design, 2, angle)
        Sum of their moments about the middle between the outer bearings. [N·m]
    largest_force : Array, shape (design, 1)
        Largest load. [N]
    largest_moment : Array, shape (design, 1)
        That force over the distance of the outer bearings. [N·m]
    """

    force: Array
    moment: Array
    largest_force: Array
    largest_moment: Array


def bearing_loads(
    place: Array, cut: CutShaft, moment: Array, *, settlement: Array, compliance: Array | None
) -> BearingLoads:
    """Bearing loads of a shaft whose bending moments are known.

    Parameters
    ----------
    place : Array, shape (design, bearing)
    cut : CutShaft
    moment : Array, shape (design, bearing, 2, angle)
        With those of what hangs over at both ends. [N·m]
    settlement : Array, shape (design, bearing, 2, angle or 1)
        Where the bearings stand while they bear nothing. [m]
    compliance : Array, shape (design, bearing, 2, 2, angle or 1), or None
        Of the bearings, where they give. [m/N]

    Returns
    -------
    BearingLoads

    Notes
    -----
    docs/theory/crankshaft, eqs. (24.6) and (24.7).
    """
    lengths = np.diff(place, axis=1)[:, :, np.newaxis, np.newaxis]
    slope = np.diff(moment, axis=1) / lengths
    reaction = cut.reaction.copy()
    reaction[:, :-1] += slope
    reaction[:, 1:] -= slope
    given = 0.0 if compliance is None else applied(compliance, reaction)
    return BearingLoads(-reaction, moment, np.broadcast_to(settlement, reaction.shape) - given)


def end_moments(n_bearings: int, cut: CutShaft) -> Array:
    """Moments of the shaft cut at its bearings: those of what hangs over; shape (design, bearing, 2, angle). [N·m]"""
    first = cut.first_moment
    moment = np.zeros((first.shape[0], n_bearings, *first.shape[1:]))
    moment[:, 0] = first
    moment[:, -1] = cut.last_moment
    return moment


def resultant(supports: Supports, loads: AxisLoads) -> Resultant:
    """What loads come to together."""
    moment = np.sum(_from_middle(supports, loads.z) * loads.force, axis=1)
    if loads.couple is not None:
        moment = moment + np.sum(loads.couple, axis=1)
    largest = np.max(np.abs(loads.force), axis=(1, 2, 3), initial=0.0)[:, np.newaxis]
    length = supports.place[:, -1:] - supports.place[:, :1]
    return Resultant(np.sum(loads.force, axis=1), moment, largest, largest * length)


def unbalanced(supports: Supports, of_loads: Resultant, borne: Array) -> tuple[Array, Array]:
    """What bearings leave over of loads, an identity that can fail: force and moment, shape (design, angle). [N, N·m]

    Parameters
    ----------
    supports : Supports
    of_loads : Resultant
    borne : Array, shape (design, bearing, 2, angle)
        What the bearings carry. [N]
    """
    force = of_loads.force - np.sum(borne, axis=1)
    moment = of_loads.moment - np.sum(_from_middle(supports, supports.place) * borne, axis=1)
    return np.hypot(force[:, 0], force[:, 1]), np.hypot(moment[:, 0], moment[:, 1])


def _from_middle(supports: Supports, z: Array) -> Array:
    """How far places lie from the middle between the outer bearings, shape (design, place, 1, 1). [m]"""
    middle = 0.5 * (supports.place[:, :1] + supports.place[:, -1:])
    return (z - middle)[:, :, np.newaxis, np.newaxis]
