"""Check of a speed over the cycle: what the torques work against what the inertia takes."""

import numpy as np
from numpy.typing import NDArray

from cranktrain.checks import Check
from cranktrain.language import _
from cranktrain.motion import Array
from cranktrain.numerics import spectral_derivative
from cranktrain.numerics.periodic import PeriodicCurve, fourier_integral

_MOTION_LIMIT = 0.1
"""Of the equation of motion, for each radian of the grid's step: torques with jumps leave a tenth of that."""
_LAST_ORDERS = 0.1
"""Share of the upper half of a grid's orders in a torque that the grid shows."""
_ROUNDING = 1e-9
"""Of the energy of all that turns; work of less within a cycle is rounding, or as good as none."""


def motion_check(speed: Array, inertia: Array, slope: Array, work: PeriodicCurve) -> Check:
    """Compare the work of the torques with that of the inertia, whose ε is of the series of ω², and with J′."""
    cycle = work.cycle
    acceleration = spectral_derivative(speed**2) * (np.pi / cycle)
    of_inertia = slope * speed**2 / 2
    left = fourier_integral(inertia * acceleration + of_inertia, cycle).samples
    energy = inertia * speed**2 / 2
    # Torques that do no work within the cycle leave the energy that moving parts hand over at a constant speed.
    spread: Array = np.ptp(work.samples, axis=-1)
    handed_over: Array = np.ptp(inertia, axis=-1) * np.mean(speed**2, axis=-1) / 2
    least = _ROUNDING * np.max(energy, axis=-1)
    works = spread > least
    scale = np.where(works, spread, handed_over)
    says_something = ~(scale <= least)
    residual = np.max(np.abs(left - work.samples), axis=-1) / np.where(says_something, scale, 1.0)
    # A shaft that hardly turns where J is least has a sharper speed than its torques.
    by_torque = np.where(works, _is_shown(work.slope(work.angle)), _is_shown(of_inertia))
    limit = _MOTION_LIMIT * float(work.angle[1])
    is_shown = by_torque & ((residual <= limit) | _is_shown(acceleration))
    closes, runs = (np.all(np.isfinite(curve), axis=-1) for curve in (inertia, speed))
    grid, nothing = (
        _("has torques that whole degrees do not show"),
        _("has nothing to compare: the work of a cycle is rounding beside the energy"),
    )
    reasons = np.where(says_something, grid, nothing)
    return Check(
        "motion",
        _("Work of Jε + ½J′ω², with the speed that was found, against that of all torques, relative to its range"),
        np.where(closes, np.where(runs & is_shown & says_something, residual, np.inf), np.nan),
        limit,
        tuple(np.where(runs, reasons, _("needs steady running")).tolist()),
    )


def _is_shown(torque: Array) -> NDArray[np.bool_]:
    """Whether a grid shows the orders of a torque: one that shows the last ones only says nothing of the others."""
    orders = np.abs(np.fft.rfft(torque, axis=-1))[..., 1:]
    return np.sum(orders[..., orders.shape[-1] // 2 :], axis=-1) <= _LAST_ORDERS * np.sum(orders, axis=-1)
