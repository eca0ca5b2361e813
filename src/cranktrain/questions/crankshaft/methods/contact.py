"""Journals with clearance in their bearings: the least of a convex energy, found by Newton's method.

All is done at every point, a design at a crank angle, by itself: shapes begin with the point.
"""

from typing import NamedTuple, cast

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array

_MOST_STEPS, _MOST_HALVINGS = 100, 60
_TOUCH = 1e-6
"""Part of a stiffness that a step counts with where a journal does not touch: only the way depends on it."""

_RESIDUAL = 1e-13
"""Part of the forces that balance that may be left over."""

_ROUNDING = 1e-15
"""Of a place: where a stiff bearing's journal stands is not known better, nor its force by that place."""

_STIFFEST, _TIMES = 1e3, 8
"""Most stiffness that is counted with, in parts of the shaft's; and how often what it gives is made up for."""

_ANY = 1e9
"""A stiffness like that of a housing, where the shaft has none: on two bearings alone any number does. [N/m]"""


class TouchingShaft(NamedTuple):
    """A shaft that is borne where its journals touch.

    Attributes
    ----------
    stiffness : Array, shape (point, 2·bearing, 2·bearing)
        What the shaft resists displacements of its bearings with. [N/m]
    force : Array, shape (point, 2·bearing)
        Reactions on the shaft where no bearing is displaced. [N]
    centre : Array, shape (point, bearing, 2)
        Where the bearings' middles stand. [m]
    clearance : Array, shape (point, bearing)
        [m]
    bearing : Array, shape (point, bearing)
        Stiffness of each bearing beyond its clearance; infinite of a rigid one. [N/m]
    """

    stiffness: Array
    force: Array
    centre: Array
    clearance: Array
    bearing: Array


def displacements_in_clearance(contact: TouchingShaft, start: Array) -> Array:
    """Where the journals come to rest, in bearings that may be rigid.

    Parameters
    ----------
    contact : TouchingShaft
    start : Array, shape (point, bearing, 2)
        Where the search begins; the outcome does not depend on it. [m]

    Returns
    -------
    Array, shape (point, bearing, 2)
        NaN where they have not come to rest. [m]

    Notes
    -----
    A rigid or very stiff bearing is given less stiffness, and its middle is moved by what that gives under the load,
    again and again: each time what is left falls by the ratio of the shaft's stiffness to it. docs/theory/crankshaft,
    eq. (24.43).
    """
    shaft = _own_stiffness(contact)
    most = np.where(shaft > 0, _STIFFEST * shaft, _ANY)
    softer = contact._replace(bearing=np.minimum(contact.bearing, most))
    gives = (1 / softer.bearing - 1 / contact.bearing)[..., np.newaxis]
    found = contact_displacements(softer, start)
    for _time in range(_TIMES if np.any(gives > 0) else 0):
        moved = contact.centre + gives * np.reshape(_shaft_forces(contact, found), found.shape)
        found = contact_displacements(softer._replace(centre=moved), found)
    return found


def contact_displacements(contact: TouchingShaft, start: Array) -> Array:
    """Where the journals come to rest in bearings that give; docs/theory/crankshaft, eqs. (24.39) to (24.42)."""
    shifts = start.copy()
    numbers = (start, *contact)
    moves = np.all([np.all(np.isfinite(values.reshape(len(start), -1)), axis=1) for values in numbers], axis=0)
    shifts[~moves] = np.nan
    left: NDArray[np.intp] = np.flatnonzero(moves)
    for _step in range(_MOST_STEPS):
        if not left.size:
            break
        of_left, at = TouchingShaft(*(values[left] for values in contact)), shifts[left]
        gradient, rest = _gradient(of_left, at)
        goes_on = np.max(np.abs(gradient), axis=1) > rest
        left, of_left, at = left[goes_on], TouchingShaft(*(values[goes_on] for values in of_left)), at[goes_on]
        shifts[left] = at + _step_of(of_left, at, gradient[goes_on])
    shifts[left] = np.nan
    return shifts


def _step_of(contact: TouchingShaft, at: Array, gradient: Array) -> Array:
    """Newton's step, cut where the energy would no longer fall along it."""
    direction = -cast(Array, np.linalg.solve(_hessian(contact, at), gradient[..., np.newaxis]))[..., 0]
    slope = -np.sum(direction * gradient, axis=1)
    share = np.ones(len(at))
    for _halving in range(_MOST_HALVINGS):
        ahead, _rest = _gradient(contact, at + (share[:, np.newaxis] * direction).reshape(at.shape))
        too_far = np.sum(direction * ahead, axis=1) > 0.9 * slope
        if not np.any(too_far):
            break
        share = np.where(too_far, share / 2, share)
    return np.reshape(share[:, np.newaxis] * direction, at.shape)


def _gradient(contact: TouchingShaft, at: Array) -> tuple[Array, Array]:
    """Forces that are left over, shape (point, 2·bearing), and how much of them may be: what rounding leaves."""
    shaft = _shaft_forces(contact, at)
    distance, away = _away(contact, at)
    pressed = np.maximum(distance - contact.clearance, 0.0) * contact.bearing
    borne = (pressed[..., np.newaxis] * away).reshape(shaft.shape)
    sizes = np.max(np.abs(contact.force), axis=1), np.max(np.abs(borne), axis=1)
    places = np.max(contact.bearing * (np.abs(at[..., 0]) + np.abs(at[..., 1]) + contact.clearance), axis=1)
    return shaft + borne, _RESIDUAL * np.maximum(*sizes) + _ROUNDING * places


def _shaft_forces(contact: TouchingShaft, at: Array) -> Array:
    """Reactions that the shaft asks for, shape (point, 2·bearing)."""
    shaft = contact.force
    for column, shift in enumerate(at.reshape(shaft.shape).T):
        shaft = shaft + contact.stiffness[:, :, column] * shift[:, np.newaxis]
    return shaft


def _own_stiffness(contact: TouchingShaft) -> Array:
    """What the shaft resists displacements of one bearing alone with, at most, shape (point, bearing)."""
    diagonal = np.einsum("pii->pi", contact.stiffness)
    return np.maximum(diagonal[:, ::2], diagonal[:, 1::2])


def _away(contact: TouchingShaft, at: Array) -> tuple[Array, Array]:
    """Distance of the journals from the bearings' middles, and its direction."""
    apart = at - contact.centre
    distance = np.hypot(apart[..., 0], apart[..., 1])
    return distance, apart / np.where(distance > 0, distance, 1.0)[..., np.newaxis]


def _hessian(contact: TouchingShaft, at: Array) -> Array:
    """Stiffness of shaft and bearings for small displacements, shape (point, 2·bearing, 2·bearing)."""
    distance, away = _away(contact, at)
    touches: NDArray[np.bool_] = distance > contact.clearance
    share = np.where(touches, contact.clearance / np.where(distance > 0, distance, 1.0), 0.0)
    matrix = contact.stiffness.copy()
    free = _TOUCH * np.minimum(contact.bearing, _own_stiffness(contact)) + _TOUCH**2 * contact.bearing
    radial = np.where(touches, contact.bearing, free)
    for one in range(2):
        for other in range(2):
            own = radial * ((1.0 - share) * (one == other) + share * away[..., one] * away[..., other])
            for bearing in range(own.shape[1]):
                matrix[:, 2 * bearing + one, 2 * bearing + other] += own[:, bearing]
    return matrix
