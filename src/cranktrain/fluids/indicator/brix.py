"""Brix's construction read backwards: a card over the stroke unrolled as the steam engine's draughtsmen did it."""

import numpy as np

from cranktrain.motion import Array


def brix_angle(displacement: Array, crank_radius: Array, ratio: Array) -> Array:
    """Crank angle by Brix's construction read backwards, from the displacement: p(S) unrolled into p(φ).

    Parameters
    ----------
    displacement : Array
        S from the head-side dead centre toward the shaft. [m]
    crank_radius : Array, broadcastable with displacement
        R [m]
    ratio : Array, broadcastable with displacement
        λ = R/L [1]

    Returns
    -------
    Array, of the broadcast shape
        φ of the outward stroke, 0 … π [rad]; on the way back it is 2π − φ. NaN outside the stroke.

    Notes
    -----
    With σ = S/R the pin stands at cos φ_O = 1 − σ, sin φ_O = √(σ(2 − σ)), and the ray from the pole to it at
    φ = atan2(sin φ_O, cos φ_O + λ/2).

    Examples
    --------
    >>> round(float(np.degrees(brix_angle(0.1, 0.1, 0.25))), 6)
    82.874984
    """
    travelled = displacement / crank_radius
    return np.arctan2(np.sqrt(travelled * (2 - travelled)), 1 - travelled + ratio / 2)
