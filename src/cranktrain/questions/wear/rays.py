"""Wear diagrams by the rule of ±60°, and where on them an oil hole goes."""

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics.products import product
from cranktrain.numerics.sectors import Sectors
from cranktrain.numerics.ties import first_largest_along

N_RAYS = 36
"""Rays of a diagram: one every 10°."""
RAYS: Array = np.arange(N_RAYS, dtype=np.float64) * (2 * np.pi / N_RAYS)
"""Their directions. [rad]"""
RAY_NAMES = tuple(f"{ray * 360 // N_RAYS}" for ray in range(N_RAYS))
"""Their directions in degrees."""

_REACH = np.pi / 3
"""How far to either side of its line a load acts. [rad]"""
_ON_EDGE = 1e-9
"""So near to the end of a load's reach a ray is still within. [rad]"""
_ALIKE = 1e-7
"""Sums that differ by less, in parts of the largest, are one: they are exact to some 1e-8 of it."""


def wear_sums(direction: Array, size: Array, rays: Array = RAYS) -> Array:
    """Sum of loads on every ray: each load with its full size on all rays within 60° of its line.

    Parameters
    ----------
    direction : Array, shape (load,)
        Where each acts. [rad]
    size : Array, shape (..., load)
    rays : Array, shape (ray,)
        [rad]

    Returns
    -------
    Array, shape (..., ray)

    Notes
    -----
    docs/theory/crankshaft, eq. (24.46).

    Examples
    --------
    >>> wear_sums(np.radians([0.0, 90.0]), np.array([3.0, 4.0]), np.radians([0.0, 60.0, 75.0, 180.0])).tolist()
    [3.0, 7.0, 4.0, 0.0]
    """
    return product(size, _reach(direction, rays))


def wear_of(sectors: Sectors, cycle: float) -> Array:
    """Mean over the cycle of the load on every ray of `RAYS`, shape (..., ray).

    Parameters
    ----------
    sectors : Sectors, shape (..., ray)
        Of the load over the cycle, apart by the sectors between these rays. [N·rad]
    cycle : float
        [rad]

    Notes
    -----
    A load that points between two rays is on the same rays wherever between them: 60° is a multiple of their distance.
    """
    return product(np.concatenate([sectors.within, sectors.along], axis=-1), _OF_SECTORS) / cycle


def oil_hole(wear: Array) -> Array:
    """Direction in which least load acts: the middle of the widest sector of rays that bear least, shape (...). [rad]

    Parameters
    ----------
    wear : Array, shape (..., ray)
        On rays that are evenly spaced from 0.

    Returns
    -------
    Array, shape (...)
        In [0, 2π). Of several sectors that are as wide the one that begins first, from ray 0 on; NaN where all rays
        bear the same, or nothing is known.

    Examples
    --------
    >>> loads = np.array([[0.0, 0.0, 5.0, 7.0, 0.0, 9.0], [2.0, 2.0, 2.0, 2.0, 2.0, 2.0]])
    >>> np.round(np.degrees(oil_hole(loads)), 9).tolist()
    [30.0, nan]
    """
    n_rays = wear.shape[-1]
    largest = np.max(wear, axis=-1, keepdims=True)
    is_least = wear <= np.min(wear, axis=-1, keepdims=True) + _ALIKE * largest
    width = _widths(is_least)
    start = first_largest_along(width)
    widest = np.max(width, axis=-1)
    middle = (start + (widest - 1) / 2) * (2 * np.pi / n_rays)
    return np.where((widest > 0) & (widest < n_rays), np.mod(middle, 2 * np.pi), np.nan)


def _widths(is_least: NDArray[np.bool_]) -> NDArray[np.intp]:
    """How many rays follow each other from each that begins a sector, shape (..., ray); 0 for others."""
    n_rays = is_least.shape[-1]
    begins = is_least & ~np.roll(is_least, 1, axis=-1)
    ray = np.arange(n_rays, dtype=np.intp)
    place: NDArray[np.intp] = (ray[:, np.newaxis] + ray) % n_rays
    is_least_ahead = is_least[..., place]
    return np.where(begins, np.argmin(is_least_ahead, axis=-1), 0)


def _reach(direction: Array, rays: Array) -> Array:
    """1 for each ray on which a load of each direction is, else 0, shape (load, ray)."""
    return (np.cos(direction[:, np.newaxis] - rays) >= np.cos(_REACH + _ON_EDGE)).astype(np.float64)


_OF_SECTORS = _reach(np.concatenate([RAYS + np.pi / N_RAYS, RAYS]), RAYS)
"""On which of `RAYS` a load is that points between two of them, and along one."""
