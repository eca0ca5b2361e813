"""Currents of induction motors: how the line's falls from the start on, and the rotor's by its torque."""

import numpy as np

from cranktrain.motion import Array


def line_current(slip: Array, breakdown_slip: Array, starting_current: Array) -> Array:
    """Line current at a slip, from that at standstill. [A, or in parts of the rated one, as the starting current is]

    Notes
    -----
    docs/theory/drive, eq. (25.11): of a circuit without stator resistance and magnetising current. Near no load the
    magnetising current is what is left, and this is too little.

    Examples
    --------
    >>> round(float(line_current(1.0, 0.2, 7.2)), 6), round(float(line_current(0.2, 0.2, 7.2)), 4)
    (7.2, 5.192)
    """
    return starting_current * np.abs(slip) * np.sqrt((1 + breakdown_slip**2) / (slip * slip + breakdown_slip**2))


def rotor_current(torque: Array, slip: Array, synchronous_speed: Array, rotor_resistance: Array) -> Array:
    """Current of a rotor's phase, referred to the stator, by what turns to heat in it. [A]

    Notes
    -----
    docs/theory/drive, eq. (25.10); exact for any motor, R being that of the rotor at this slip.
    """
    return np.sqrt(torque * slip * synchronous_speed / (3 * rotor_resistance))


def rotor_heat(torque: Array, speed: Array, synchronous_speed: Array) -> Array:
    """Power that turns to heat in the rotor and what is connected to it: M s ω_s. [W]

    docs/theory/drive, eq. (25.9).
    """
    return torque * (synchronous_speed - speed)
