"""Velocities of a crank-rocker by the directions of its links: (7) and (10) of [gandzha]."""

import numpy as np

from cranktrain.motion import Array


def pin_velocity_ratio(crank: Array, rod: Array, rocker: Array) -> Array:
    """Velocity of the rocker's pin by that of the crank's, from the directions of the three links.

    Parameters
    ----------
    crank, rod, rocker : Array, that broadcast
        α of the crank, β of the rod, α₁ of the rocker, from one axis. [rad]

    Returns
    -------
    Array, of the broadcast shape. [1]
        Times crank radius by rocker length it is the ratio of the angular velocities. Infinite where rod and rocker
        are in line; NaN where the crank is, too.

    Notes
    -----
    v_A/v_B = AC/BC = sin(α − β)/sin(α₁ − β), (7) and (10); C, the rod's instant centre, is where the lines of crank and
    rocker meet. The source calls the crank pin B and the rocker's pin A. Exact; docs/theory/plans.

    Examples
    --------
    Crank and rocker of a parallelogram are parallel, and their pins equally fast.

    >>> round(float(pin_velocity_ratio(1.1, 0.2, 1.1)), 12)
    1.0
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.sin(crank - rod) / np.sin(rocker - rod)


def product_of_sines(crank: Array, rod: Array, rocker: Array) -> Array:
    """What [kunitsky-1938] and [popov-1945] have for AC/BC, sin(α₁ − β) sin(α − β), which [gandzha] refutes.

    Parameters
    ----------
    crank, rod, rocker : Array, that broadcast
        α, β and α₁, as of `pin_velocity_ratio`. [rad]

    Returns
    -------
    Array, of the broadcast shape. [1]

    Examples
    --------
    Of a parallelogram, whose pins are equally fast, it is the square of a sine.

    >>> round(float(product_of_sines(1.1, 0.2, 1.1)), 6)
    0.613601
    """
    return np.sin(rocker - rod) * np.sin(crank - rod)
