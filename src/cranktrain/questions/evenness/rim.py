"""Rim of a flywheel: its section from the moment of inertia, and how fast it runs."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array


class RimDemand(NamedTuple):
    """What a rim of rectangular section is made to.

    Attributes
    ----------
    mean_diameter : Array
        Of the middle of the section. [m]
    width_ratio : Array
        Width along the shaft to height of the section. [1]
    other_share : Array
        Allowance: the share of the flywheel's inertia that arms, disc and hub bring. [1]
    density : Array
        [kg/m³]
    """

    mean_diameter: Array
    width_ratio: Array
    other_share: Array
    density: Array


class Rim(NamedTuple):
    """Rim: height and width of its section, outer diameter [m] and mass [kg], and the mass by GD² = mD² [kg]."""

    height: Array
    width: Array
    outer_diameter: Array
    mass: Array
    textbook_mass: Array


def rim(inertia: Array, demand: RimDemand) -> Rim:
    """Section and mass of a rim.

    Parameters
    ----------
    inertia : Array
        Of the whole flywheel. [kg·m²]
    demand : RimDemand, fields that broadcast

    Returns
    -------
    Rim
        NaN where the section would reach the shaft's axis: the mean diameter is too small.

    Notes
    -----
    J = ¼ m (D² + h²) with m = π D ρ (b/h) h², solved for h². Texts put J = ¼ m D², GD² = m D², which asks for a little
    more mass. docs/theory/evenness, eqs. (17.14) and (17.15).

    Examples
    --------
    >>> found = rim(100.0, RimDemand(1.2, 1.5, 0.1, 7200.0))
    >>> round(float(0.25 * found.mass * (1.2**2 + found.height**2)), 9)
    90.0
    """
    square = demand.mean_diameter * demand.mean_diameter
    wanted = inertia * (1 - demand.other_share)
    term = 4 * wanted / (np.pi * demand.density * demand.mean_diameter * demand.width_ratio)
    height = np.sqrt(2 * term / (square + np.sqrt(square * square + 4 * term)))
    fits = height < demand.mean_diameter
    height = np.where(fits, height, np.nan)
    width = demand.width_ratio * height
    mass = np.pi * demand.density * demand.mean_diameter * width * height
    return Rim(height, width, demand.mean_diameter + height, mass, 4 * wanted / square)


def rim_speed(outer_diameter: Array, speed: Array) -> Array:
    """Speed of the rim's outside at a speed of the shaft, ωD/2: [m], [rad/s] to [m/s].

    Solid rims of cast iron bear 100 ft/s, some 30 m/s [machinerys-handbook].
    """
    return speed * outer_diameter / 2
