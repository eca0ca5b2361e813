"""Steady running where torques depend on the speed: loads that rise with its square, motors that fall with it."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import ZERO, Array
from cranktrain.numerics.harmonics import TURN
from cranktrain.numerics.periodic import Interpolation, fourier_curve, fourier_integral
from cranktrain.questions.evenness.speed_over_cycle import SpeedOverCycle, speed_from_energy

_MOST_STEPS = 60
_SETTLED = 1e-12
"""A step of Newton's method after which the next one is less than rounding, in parts of the energy."""


class TorqueLaw(NamedTuple):
    """Torque on the shaft by crank angle and speed, free + linear·ω + quadratic·ω²; arrays that broadcast to (..., n).

    Driving torques count positive, loads negative; laws add by adding their parts. A motor of stiffness c and no-load
    speed ω_s has free = c ω_s and linear = −c; a fan or a propeller quadratic = −k; a given load curve is part of free.

    Attributes
    ----------
    free, linear, quadratic : Array
        [N·m, N·m·s, N·m·s²]
    """

    free: Array = ZERO
    linear: Array = ZERO
    quadratic: Array = ZERO


class SpeedUnderLaw(NamedTuple):
    """Steady running under a torque law.

    Attributes
    ----------
    speed : SpeedOverCycle
        NaN where there is none.
    torque : Array, shape (..., n)
        Of the law, all of it. [N·m]
    multiplier : Array, shape (...)
        What is left after a cycle of a small departure of the energy: below 1 the running is stable.
    """

    speed: SpeedOverCycle
    torque: Array
    multiplier: Array


def motor(no_load_speed: Array, stiffness: Array) -> TorqueLaw:
    """Linear motor, M = c (ω_s − ω): [rad/s], [N·m·s]."""
    return TorqueLaw(stiffness * no_load_speed, -stiffness)


def speed_under_law(
    law: TorqueLaw, inertia: Array, cycle: float = TURN, by: Interpolation = fourier_curve
) -> SpeedUnderLaw:
    """Speed over a cycle at which all torques balance; the mean comes out.

    Parameters
    ----------
    law : TorqueLaw
        On the grid; some part of it has to depend on the speed.
    inertia : Array, shape (..., n)
        J(φ) in equal steps over the cycle, endpoint excluded: flywheel and moving parts. [kg·m²]
    cycle : float
        2π or 4π. [rad]
    by : Interpolation
        Of energy and inertia between the points of the grid: `fourier_curve` or `spline_curve`.

    Returns
    -------
    SpeedUnderLaw
        NaN where the torques balance at no speed, or do not depend on it.

    Notes
    -----
    The energy obeys T′ = τ(φ, ω). Newton's method, whose every step is a linear periodic equation that is solved as a
    whole by Fourier series: a load kω² alone needs one step. docs/theory/evenness, eqs. (17.11) to (17.13).
    """
    free, linear, quadratic, carried = _on_one_grid(law, inertia)
    energy = energy_under_law(law, inertia, cycle)
    found = speed_from_energy(by(energy, cycle), by(carried, cycle))
    with np.errstate(all="ignore"):
        speed = found.speed
        slope = (linear + 2 * quadratic * speed) / (carried * speed)
        torque = free + (linear + quadratic * speed) * speed
        return SpeedUnderLaw(found, torque, np.exp(cycle * np.mean(slope, axis=-1)))


def energy_under_law(law: TorqueLaw, inertia: Array, cycle: float = TURN) -> Array:
    """Kinetic energy over a cycle at which all torques balance; parameters as `speed_under_law` takes them.

    Returns
    -------
    Array, shape (..., n)
        [J]; NaN where there is none.
    """
    free, linear, quadratic, carried = _on_one_grid(law, inertia)
    with np.errstate(all="ignore"):
        energy = carried * _even_speed(free, linear, quadratic) ** 2 / 2
        move = np.full(energy.shape, np.inf)
        for _ in range(_MOST_STEPS):
            speed = np.sqrt(2 * energy / carried)
            slope = (linear + 2 * quadratic * speed) / (carried * speed)
            torque = free + (linear + quadratic * speed) * speed
            better = linear_periodic(-slope, torque - slope * energy, cycle)
            # A step that would stop the shaft goes part of the way.
            better = np.maximum(better, energy / 4)
            move = np.abs(better - energy) / energy
            energy = better
            if not np.any(move > _SETTLED):
                break
        return np.where(np.max(move, axis=-1, keepdims=True) <= _SETTLED, energy, np.nan)


def linear_periodic(decay: Array, source: Array, cycle: float = TURN) -> Array:
    """Periodic solution of y′ + g(φ) y = h(φ).

    Parameters
    ----------
    decay, source : Array, shape (..., n)
        g and h in equal steps over the cycle, endpoint excluded.
    cycle : float
        [rad]

    Returns
    -------
    Array, shape (..., n)
        y on the same grid; NaN where the mean of g is zero.

    Notes
    -----
    With G the integral of g less its mean ḡ, z = y e^G has constant coefficients, z′ + ḡ z = h e^G, and every order of
    z is that of h e^G divided by ḡ + ik. docs/theory/evenness, eq. (17.12).
    """
    n_points = source.shape[-1]
    weight = np.exp(fourier_integral(decay, cycle).samples)
    mean = np.mean(decay, axis=-1, keepdims=True)
    mean = np.where(mean == 0, np.nan, mean)
    order = np.arange(n_points // 2 + 1, dtype=float) * (TURN / cycle)
    with np.errstate(invalid="ignore"):
        # Of the highest order the inverse transform takes the cosine, which is all of it that the grid sees.
        parts = np.fft.rfft(source * weight, axis=-1) / (mean + 1j * order)
    return np.fft.irfft(parts, n_points, axis=-1) / weight


def _on_one_grid(law: TorqueLaw, inertia: Array) -> tuple[Array, Array, Array, Array]:
    """Parts of the law, and the inertia, each of shape (..., n)."""
    shape = np.broadcast_shapes(inertia.shape, *(np.shape(part) for part in law))
    free, linear, quadratic, carried = (np.broadcast_to(part, shape) for part in (*law, inertia))
    return free, linear, quadratic, carried


def _even_speed(free: Array, linear: Array, quadratic: Array) -> Array:
    """Speed at which the mean torques balance: where Newton's method starts, shape (..., 1)."""
    a, b, c = (np.mean(part, axis=-1, keepdims=True) for part in (free, linear, quadratic))
    return 2 * a / (-b + np.sqrt(b**2 - 4 * a * c))
