"""Excess work: what the shaft takes up and gives back within a cycle."""

from typing import NamedTuple

from cranktrain.motion import ONE, Array
from cranktrain.numerics import Extreme
from cranktrain.numerics.periodic import PeriodicCurve, combined, curve_extremes


class ExcessWork(NamedTuple):
    """Work of the excess torque less its mean, and its extremes.

    Attributes
    ----------
    work : PeriodicCurve
        A(φ), zero at φ = 0. [J]
    mean_excess : Array, shape (...)
        Mean of driving less load torque. Not zero: no steady state with these two curves; A is that of a load larger by
        this constant. [N·m]
    smallest, largest : Extreme, shapes (..., 1)
        Of A, refined. [rad, J]
    """

    work: PeriodicCurve
    mean_excess: Array
    smallest: Extreme
    largest: Extreme

    @property
    def difference(self) -> Array:
        """ΔA, the largest excess work, shape (...). [J]"""
        return (self.largest.value - self.smallest.value)[..., 0]


def excess_of(work: PeriodicCurve, mean: Array) -> ExcessWork:
    """Excess work whose curve, 0 at φ = 0, is known [J], and the mean of the excess torque, shape (...) [N·m].

    A = ∫₀^φ (M_d − M_r) dφ. docs/theory/evenness, eqs. (17.2) and (17.3).

    Examples
    --------
    >>> import numpy as np
    >>> from cranktrain.numerics.periodic import fourier_integral
    >>> from cranktrain.numerics.harmonics import TURN
    >>> excess = 100 + 50 * np.sin(np.arange(36) * np.pi / 18)
    >>> round(float(excess_of(fourier_integral(excess, TURN), np.mean(excess)).difference), 9)
    100.0
    """
    return ExcessWork(work, mean, *curve_extremes(work))


def excess_against(driving: ExcessWork, load_work: PeriodicCurve | None, mean: Array) -> ExcessWork:
    """Excess work of a driving torque against loads.

    Parameters
    ----------
    driving : ExcessWork
        Of the driving torque alone.
    load_work : PeriodicCurve or None
        Of the loads less their mean, on the same grid; None where they are constant. [J]
    mean : Array, shape (...)
        Of the loads. [N·m]

    Returns
    -------
    ExcessWork

    Notes
    -----
    docs/theory/evenness, eq. (17.17).
    """
    left = driving.mean_excess - mean
    if load_work is None:
        return driving._replace(mean_excess=left)
    return excess_of(combined(driving.work, -ONE, load_work), left)
