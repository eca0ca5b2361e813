"""Trains of discs joined by shafts: natural frequencies, modes and Holzer's table. Arrays only."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics.ties import first_largest_along

_STILL = 1e-9
"""A disc that moves less, in parts of the largest amplitude, is a node: nothing is measured by it."""


class Train(NamedTuple):
    """Discs, each but the last with a shaft that leads toward the last; all referred to the crank's speed.

    Attributes
    ----------
    inertia : Array, shape (..., disc)
        More than 0; i² of its own for a disc that turns i times as fast. [kg·m²]
    stiffness : Array, shape (..., disc − 1)
        More than 0, i² of its own likewise. [N·m/rad]
    following : array of int, shape (disc − 1,)
        To which disc each shaft leads: always to a later one, so that the last comes after all.
    """

    inertia: Array
    stiffness: Array
    following: NDArray[np.intp]


class Modes(NamedTuple):
    """Natural modes by rising frequency, without that of all discs turning as one.

    speed: ω_n, shape (..., mode) [rad/s]; shape: amplitudes, shape (..., mode, disc), aᵀJa = 1.
    """

    speed: Array
    shape: Array


def natural_modes(train: Train) -> Modes:
    """Free undamped vibration of a train.

    Parameters
    ----------
    train : Train

    Returns
    -------
    Modes
        NaN where an inertia or a stiffness is not more than 0 and finite.

    Notes
    -----
    ω are the singular values of G = √k B/√J, where B takes the difference of the two amplitudes of each shaft:
    J^-½KJ^-½ = GᵀG. Nothing is squared on the way, so that the lowest frequency keeps its digits beside the highest;
    and the turning of all discs as one, whose 0 rounding could make another number, is not among them.
    docs/theory/torsion, eqs. (23.2) to (23.4).

    Examples
    --------
    >>> two = Train(np.array([1.0, 3.0]), np.array([12.0]), np.array([1]))
    >>> natural_modes(two).speed
    array([4.])
    """
    known = _is_positive(train.inertia) & _is_positive(train.stiffness)
    root = np.sqrt(np.where(known[..., np.newaxis], train.inertia, 1.0))
    across = np.sqrt(np.where(known[..., np.newaxis], train.stiffness, 1.0))
    shafts = np.arange(train.following.size)
    strain = np.zeros((*np.broadcast_shapes(root.shape[:-1], across.shape[:-1]), shafts.size, root.shape[-1]))
    strain[..., shafts, shafts] = across / root[..., :-1]
    strain[..., shafts, train.following] = -across / root[..., train.following]
    _torques, speed, shape = np.linalg.svd(strain, full_matrices=False)
    wanted = known[..., np.newaxis]
    return Modes(
        np.where(wanted, speed[..., ::-1], np.nan),
        np.where(wanted[..., np.newaxis], (shape / root[..., np.newaxis, :])[..., ::-1, :], np.nan),
    )


def _is_positive(values: Array) -> NDArray[np.bool_]:
    return np.all(np.isfinite(values) & (values > 0), axis=-1)


def scaled(shape: Array, free_end: int) -> tuple[Array, NDArray[np.intp]]:
    """Modes with amplitude 1 at the free end, or where that is a node, at the disc that moves most.

    Parameters
    ----------
    shape : Array, shape (..., mode, disc)
        Of any size.
    free_end : int
        Which disc.

    Returns
    -------
    shape : Array, shape (..., mode, disc)
    unit : array of int, shape (..., mode)
        Which disc's amplitude is 1.
    """
    size = np.abs(shape)
    moves = size[..., free_end] > _STILL * np.max(size, axis=-1)
    unit = np.where(moves, free_end, first_largest_along(size))
    return shape / np.take_along_axis(shape, unit[..., np.newaxis], axis=-1), unit


class HolzerTable(NamedTuple):
    """Holzer's table of every mode, shape (..., mode, disc): for 1 rad where the amplitude is 1.

    Attributes
    ----------
    torque : Array
        Jω²a of each disc. [N·m/rad]
    total : Array
        Torque in the disc's shaft: the sum of Jω²a over all that the shaft carries; of the last disc what is left over,
        which is nothing at a natural frequency. [N·m/rad]
    twist : Array
        By how much the amplitude falls along the disc's shaft, total/k; NaN for the last disc.
    """

    torque: Array
    total: Array
    twist: Array


def holzer_table(train: Train, speed: Array, shape: Array) -> HolzerTable:
    """Sum up the torques from the far ends to the last disc.

    Parameters
    ----------
    train : Train
    speed : Array, shape (..., mode)
        [rad/s]
    shape : Array, shape (..., mode, disc)

    Returns
    -------
    HolzerTable

    Notes
    -----
    docs/theory/torsion, eqs. (23.6) and (23.7).
    """
    torque = train.inertia[..., np.newaxis, :] * speed[..., np.newaxis] ** 2 * shape
    total = torque.copy()
    for disc, following in enumerate(train.following.tolist()):
        total[..., following] += total[..., disc]
    twist = np.full_like(total, np.nan)
    twist[..., :-1] = total[..., :-1] / train.stiffness[..., np.newaxis, :]
    return HolzerTable(torque, total, twist)


def holzer_amplitudes(train: Train, speed: Array) -> Array:
    """Amplitudes that Holzer's table gives at frequencies of any size, of some size.

    Parameters
    ----------
    train : Train
    speed : Array, shape (..., trial)
        [rad/s]

    Returns
    -------
    Array, shape (..., trial, disc)

    Notes
    -----
    From the far ends on, each disc after all that lead to it; where branches meet, each is taken times the amplitudes
    at which the others come there, so that nothing is divided by one that may be 0. docs/theory/torsion, eqs. (23.6),
    (23.7) and (23.22).

    Examples
    --------
    >>> two = Train(np.array([1.0, 3.0]), np.array([12.0]), np.array([1]))
    >>> holzer_amplitudes(two, np.array([0.0, 2.0, 4.0]))
    array([[ 1.        ,  1.        ],
           [ 1.        ,  0.66666667],
           [ 1.        , -0.33333333]])
    """
    square = speed**2
    n_discs = train.inertia.shape[-1]
    amplitude = np.ones((*np.broadcast_shapes(train.inertia.shape[:-1], speed.shape[:-1]), speed.shape[-1], n_discs))
    carried = np.zeros_like(amplitude)
    behind: list[list[int]] = [[disc] for disc in range(n_discs)]
    has_begun = [False] * n_discs
    for disc, following in enumerate(train.following.tolist()):
        own = train.inertia[..., disc, np.newaxis] * square * amplitude[..., disc]
        total = carried[..., disc] + own
        arriving = amplitude[..., disc] - total / train.stiffness[..., disc, np.newaxis]
        if has_begun[following]:
            there = amplitude[..., following].copy()
            amplitude[..., behind[disc]] *= there[..., np.newaxis]
            amplitude[..., behind[following]] *= arriving[..., np.newaxis]
            carried[..., following] = carried[..., following] * arriving + total * there
        else:
            amplitude[..., following], carried[..., following] = arriving, total
        has_begun[following] = True
        behind[following] += behind[disc]
    return amplitude


def shafts_apart(train: Train, table: HolzerTable, shape: Array) -> Array:
    """By how much k·Δa of shafts is off the sums that they carry, relative to all, shape (..., mode, disc − 1)."""
    gross = np.sum(np.abs(table.torque), axis=-1, keepdims=True)
    one, other = (np.abs(part) * train.stiffness[..., np.newaxis, :] for part in _ends(train, shape))
    elastic = train.stiffness[..., np.newaxis, :] * np.subtract(*_ends(train, shape))
    return np.abs(elastic - table.total[..., :-1]) / (gross + one + other)


def holzer_remainder(train: Train, table: HolzerTable, shape: Array) -> Array:
    """How well Holzer's tables close, shape (...,): the larger of two residuals, of the worst mode.

    What the last disc leaves over, relative to the sum of |Jω²a|; and k·Δa of every shaft against the sum that it
    carries, relative to both.
    """
    gross = np.sum(np.abs(table.torque), axis=-1, keepdims=True)
    left = np.abs(table.total[..., -1:]) / gross
    return np.max(np.concatenate([left, shafts_apart(train, table, shape)], axis=-1), axis=(-2, -1))


def cross_inertia(train: Train, shape: Array) -> Array:
    """How far any two modes share kinetic energy, shape (...,): largest |aᵀJb|/√(aᵀJa·bᵀJb), a ≠ b.

    The turning of all discs as one is among them.
    """
    every = np.concatenate([np.ones_like(shape[..., :1, :]), shape], axis=-2)
    weighed = every * np.sqrt(train.inertia)[..., np.newaxis, :]
    unit = weighed / np.sqrt(np.sum(weighed**2, axis=-1, keepdims=True))
    products = np.abs(unit @ np.swapaxes(unit, -1, -2))
    return np.max(products - np.eye(products.shape[-1]), axis=(-2, -1))


def nodes(train: Train, shape: Array) -> Array:
    """Where along each disc's shaft the node lies, shape (..., mode, disc).

    Share of the shaft from its disc on, in (0, 1]; 1 for a node at the disc to which it leads; NaN where there is none.
    """
    one, other = _ends(train, shape)
    found = np.full_like(shape, np.nan)
    found[..., :-1] = np.where((one != 0) & (one * other <= 0), one / np.where(one == other, 1.0, one - other), np.nan)
    return found


def _ends(train: Train, shape: Array) -> tuple[Array, Array]:
    """Amplitudes at both ends of every shaft, shape (..., mode, disc − 1)."""
    return shape[..., :-1], shape[..., train.following]
