"""Steady running where torques depend on the speed: loads that rise with its square, motors that fall with it."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import ZERO, Array
from cranktrain.numerics.harmonics import TURN
from cranktrain.numerics.periodic import Interpolation, fourier_curve, fourier_integral
from cranktrain.questions.evenness.speed_over_cycle import SpeedOverCycle, speed_from_energy

MOST_STEPS = 60
_CLOSE = 1e-6
"""A step after which a start is near enough."""
SETTLED = 1e-12
"""A step of Newton's method after which the next one is less than rounding, in parts of the energy."""


class Power(NamedTuple):
    """Torque that goes with a power of the speed, coefficient·ω^exponent; shapes that broadcast to (..., n).

    In [N·m·sᵖ], where p is the exponent, more than 0.
    """

    coefficient: Array
    exponent: Array

    def torque(self, speed: Array) -> Array:
        """Torque at a speed. [N·m]"""
        return self.coefficient * speed**self.exponent

    def times(self, factor: Array) -> "Power":
        """The same times a factor, shape (...)."""
        return self._replace(coefficient=self.coefficient * factor[..., np.newaxis])


class TorqueLaw(NamedTuple):
    """Torque on the shaft by crank angle and speed: what is free of the speed, and powers of it.

    Driving torques count positive, loads negative; laws add by adding their parts. A motor of stiffness c and no-load
    speed ω_s has free = c ω_s and the power −c ω; a fan or a propeller −k ω²; a load over the angle is part of free.

    Attributes
    ----------
    free : Array, broadcastable to (..., n)
        [N·m]
    powers : tuple of Power
    """

    free: Array = ZERO
    powers: tuple[Power, ...] = ()

    def torque(self, speed: Array) -> Array:
        """All of it at speeds on the grid, shape (..., n). [N·m]"""
        return sum((one.torque(speed) for one in self.powers), self.free + 0.0 * speed)

    def slope(self, speed: Array) -> Array:
        """Derivative of that by the speed. [N·m·s]"""
        return sum((c * p * speed ** (p - 1) for c, p in self.powers), 0.0 * speed)


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
    law, carried = _on_one_grid(law, inertia)
    energy = energy_under_law(law, inertia, cycle)
    found = speed_from_energy(by(energy, cycle), by(carried, cycle))
    with np.errstate(all="ignore"):
        slope = law.slope(found.speed) / (carried * found.speed)
        return SpeedUnderLaw(found, law.torque(found.speed), np.exp(cycle * np.mean(slope, axis=-1)))


def energy_under_law(law: TorqueLaw, inertia: Array, cycle: float = TURN) -> Array:
    """Kinetic energy over a cycle at which all torques balance; parameters as `speed_under_law` takes them.

    Returns
    -------
    Array, shape (..., n)
        [J]; NaN where there is none.
    """
    law, carried = _on_one_grid(law, inertia)
    with np.errstate(all="ignore"):
        energy = carried * even_speed(law) ** 2 / 2
        move = np.full(energy.shape, np.inf)
        for _ in range(MOST_STEPS):
            speed = np.sqrt(2 * energy / carried)
            slope = law.slope(speed) / (carried * speed)
            better = linear_periodic(-slope, law.torque(speed) - slope * energy, cycle)
            # A step that would stop the shaft goes part of the way.
            better = np.maximum(better, energy / 4)
            # What has settled stays, however long others take.
            goes_on = ~(np.max(move, axis=-1, keepdims=True) <= SETTLED)
            move = np.where(goes_on, np.abs(better - energy) / energy, move)
            energy = np.where(goes_on, better, energy)
            if not np.any(move > SETTLED):
                break
        return np.where(np.max(move, axis=-1, keepdims=True) <= SETTLED, energy, np.nan)


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


def _on_one_grid(law: TorqueLaw, inertia: Array) -> tuple[TorqueLaw, Array]:
    """The law with its part that is free of the speed, and the inertia, each of shape (..., n)."""
    parts = (part for power in law.powers for part in power)
    shape = np.broadcast_shapes(inertia.shape, np.shape(law.free), *map(np.shape, parts))
    return law._replace(free=np.broadcast_to(law.free, shape)), np.broadcast_to(inertia, shape)


def even_speed(law: TorqueLaw) -> Array:
    """Speed at which the mean torques balance: where Newton's method starts, shape (..., 1).

    By the logarithm of the speed the mean torque falls ever faster, so that Newton's steps from beyond do not pass by.
    """
    free = np.mean(law.free, axis=-1, keepdims=True)
    speed = np.full_like(free, np.inf)
    powers = [Power(*map(_grid_mean, one)) for one in law.powers]
    for coefficient, exponent in powers:
        alone = np.where(coefficient < 0, (free / -coefficient) ** (1 / exponent), np.inf)
        speed = np.minimum(speed, alone)
    goes_on = np.full(speed.shape, fill_value=True)
    for _ in range(MOST_STEPS):
        terms = [one.torque(speed) for one in powers]
        slopes = [one.exponent * term for one, term in zip(powers, terms, strict=True)]
        step = np.where(goes_on, sum(terms, free) / sum(slopes, ZERO), 0.0)
        speed = speed * np.exp(-step)
        goes_on &= ~(np.abs(step) < _CLOSE)
        if not np.any(goes_on):
            break
    return speed


def _grid_mean(part: Array) -> Array:
    """Mean over the grid, shape (..., 1), of what may be one number."""
    return np.mean(part, axis=-1, keepdims=True) if np.ndim(part) else part
