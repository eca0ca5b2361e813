"""Slip, and Kloss's formula of the torque by it."""

from cranktrain.motion import Array


def slip_of(speed: Array, synchronous_speed: Array) -> Array:
    """Slip of a shaft behind the field: 1 at standstill, below 0 where the shaft is the faster. [1]"""
    return 1 - speed / synchronous_speed


def kloss_torque(slip: Array, breakdown_torque: Array, breakdown_slip: Array, asymmetry: Array) -> Array:
    """Torque at a slip by Kloss's formula. [N·m]

    Notes
    -----
    docs/theory/drive, eq. (25.2), written without s in a denominator, so that it holds at synchronous speed.
    """
    along = slip * breakdown_slip
    around = slip * slip + breakdown_slip * breakdown_slip + asymmetry * along
    return breakdown_torque * (2 + asymmetry) * along / around
