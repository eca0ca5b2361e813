"""Harmonics of any periodic curve: from equal steps over a cycle to orders, and back."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics.products import product

ComplexArray = NDArray[np.complex128]

TURN = 2 * np.pi


def phasor(angle: Array | float) -> ComplexArray:
    """Unit vector at an angle [rad], as a complex number."""
    return np.asarray(np.exp(1j * np.asarray(angle)), dtype=np.complex128)


class Harmonics(NamedTuple):
    """A periodic curve by its orders: Σ (cosine cos kφ + sine sin kφ).

    Attributes
    ----------
    order : Array, shape (n,)
        Periods to a turn of the crank: 0 (the mean), 1, 2, …; for a cycle of two turns 0, ½, 1, ….
    cosine, sine : Array, shape (..., n)
        In the curve's unit. Phases count from φ = 0, wherever the caller has it.
    """

    order: Array
    cosine: Array
    sine: Array

    @property
    def amplitude(self) -> Array:
        """Amplitude of each order; of order 0 the mean without its sign."""
        return np.hypot(self.cosine, self.sine)

    @property
    def phase(self) -> Array:
        """Phase ψ of each order, amplitude · cos(kφ − ψ): its first peak is at φ = ψ/k. [rad]"""
        return np.arctan2(self.sine, self.cosine)

    @property
    def mean(self) -> Array:
        """Mean over a cycle, shape (...)."""
        return self.cosine[..., 0]

    @property
    def vectors(self) -> ComplexArray:
        """Complex amplitudes c_k, the curve being Re Σ c_k e^{ikφ}."""
        return self.cosine - 1j * self.sine


def harmonics(samples: Array, cycle: float = TURN) -> Harmonics:
    """Harmonics of a periodic curve sampled at equal steps over one cycle, endpoint excluded.

    Parameters
    ----------
    samples : Array, shape (..., n)
        The curve at φ = 0, cycle/n, 2 cycle/n, …. A grid that holds its first point twice has to lose the last one.
    cycle : float
        2π or 4π. [rad]

    Returns
    -------
    Harmonics, shape (..., n//2 + 1)
        Exact for a curve without orders above n/2 periods a cycle; that order itself, which at even n is seen only at
        its cosine's peaks, is counted once.

    Notes
    -----
    docs/theory/harmonics-and-orders, eq. (15.10).

    Examples
    --------
    >>> found = harmonics(3 + 2 * np.cos(np.arange(8) * np.pi / 4))
    >>> found.order[:2], found.amplitude[:2].round(12)
    (array([0., 1.]), array([3., 2.]))
    """
    n_points = samples.shape[-1]
    vectors = np.fft.rfft(samples, axis=-1) / n_points
    vectors[..., 1 : (n_points + 1) // 2] *= 2
    return from_vectors(np.arange(vectors.shape[-1], dtype=float) * (TURN / cycle), vectors)


def from_vectors(order: Array, vectors: ComplexArray) -> Harmonics:
    """Harmonics of the curve Re Σ c_k e^{ikφ}: orders (n,), complex amplitudes (..., n)."""
    return Harmonics(order, vectors.real, -vectors.imag)


def curve(of: Harmonics, angle: Array) -> Array:
    """Sum the harmonics at crank angles.

    Parameters
    ----------
    of : Harmonics, shape (..., n)
    angle : Array, shape (k,) or (..., k)
        Crank angles, the same for all curves or each curve's own. [rad]

    Returns
    -------
    Array, shape (..., k)
    """
    turned = np.asarray(angle)[..., np.newaxis] * of.order
    if turned.ndim == 2:
        return product(of.cosine, np.cos(turned).T) + product(of.sine, np.sin(turned).T)
    parts = of.cosine[..., np.newaxis, :] * np.cos(turned) + of.sine[..., np.newaxis, :] * np.sin(turned)
    return np.sum(parts, axis=-1)


def delayed(of: Harmonics, angle: Array) -> Harmonics:
    """Harmonics of the same curve, later by an angle [rad] of shape (...): f(φ − angle)."""
    return from_vectors(of.order, of.vectors * phasor(-np.asarray(angle)[..., np.newaxis] * of.order))
