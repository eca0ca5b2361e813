"""Piston on an articulated rod by the two-harmonic form (I.13) of [bolotin].

The constants are illegible in the source. Two sets stand in for them: `derived` anew, and `reconstructed` as the source
most likely had them; beside them stand those of the exact motion. Derivation, errors and what the source still shows:
docs/theory/textbook-forms.
"""

from typing import NamedTuple

import numpy as np

from cranktrain.mechanisms.articulated_rod import ArticulatedRod, articulated_rod
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import turn_grid

_NEWTON_STEPS, _SETTLED = 8, 1e-9
"""Digits double with each step; from the first harmonic's top, enough for a second harmonic up to 0.6 of the first. And
a step after which the next one is less than rounding. [rad]"""


class SlaveHarmonics(NamedTuple):
    """The constants of (I.13)."""

    first_amplitude: Array
    """E [1]"""
    first_phase: Array
    """Φ [rad]"""
    second_amplitude: Array
    """F [1]"""
    second_phase: Array
    """Θ [rad]"""
    mean_distance: Array
    """K, mean distance of the slave's piston pin from the shaft [m]"""


def derived(rod: ArticulatedRod) -> SlaveHarmonics:
    """Constants of (I.13) derived anew: exact in the offset angle δ = ζ − γ, complete to second order in R.

    Parameters
    ----------
    rod : ArticulatedRod

    Returns
    -------
    SlaveHarmonics, of the broadcast shape of the fields

    Notes
    -----
    With sin φ₀ = (r/l) sin δ, t = tan φ₀, ρ = r/L, ρ̂ = ρ cos δ, g = ρ(sin δ + t cos δ), μ = R/(l cos³ φ₀),
    B = λρ(cos δ − t sin δ) + μρ̂²:

    E cos Φ = 1 + g sin γ,  E sin Φ = t − g cos γ,
    F cos Θ = μ(1 − 2ρ̂ cos γ) + B cos 2γ,  F sin Θ = 2μρ̂ sin γ − B sin 2γ,
    K = r cos δ + l cos φ₀ − (R/4)[μ(1 − 2ρ̂ cos γ) + B].
    """
    R, L, r, l, gamma, zeta = _letters(rod)  # noqa: N806 - the letters of the equations above
    sin_delta, cos_delta = np.sin(zeta - gamma), np.cos(zeta - gamma)
    sin_phi = r / l * sin_delta
    cos_phi = np.sqrt((1 - sin_phi) * (1 + sin_phi))
    t = sin_phi / cos_phi
    rho = r / L
    rho_hat = rho * cos_delta
    g = rho * (sin_delta + t * cos_delta)
    mu = R / (l * cos_phi**3)
    B = R / L * rho * (cos_delta - t * sin_delta) + mu * rho_hat**2  # noqa: N806
    return _harmonics(
        first=(1 + g * np.sin(gamma), t - g * np.cos(gamma)),
        second=(
            mu * (1 - 2 * rho_hat * np.cos(gamma)) + B * np.cos(2 * gamma),
            2 * mu * rho_hat * np.sin(gamma) - B * np.sin(2 * gamma),
        ),
        mean_distance=r * cos_delta + l * cos_phi - R / 4 * (mu * (1 - 2 * rho_hat * np.cos(gamma)) + B),
    )


def reconstructed(rod: ArticulatedRod) -> SlaveHarmonics:
    """Constants of (I.13) as the source most likely had them: cos ψ → 1, sin ψ to first power. Reconstructed.

    Parameters
    ----------
    rod : ArticulatedRod

    Returns
    -------
    SlaveHarmonics, of the broadcast shape of the fields

    Notes
    -----
    With ψ = ζ − γ:

    E cos Φ = 1 + (1 + r/l)(r/L) sin γ sin ψ,  E sin Φ = [r/l − (r/L)(1 + r/l) cos γ] sin ψ,
    F cos Θ = (R/l)(1 − 2(r/L) cos γ) + (R/L)(r/L)(1 + r/l) cos 2γ,
    F sin Θ = 2(r/L)(R/l) sin γ [1 − (1 + r/l)(l/L) cos γ],
    K = l + r cos ψ − (R/4){(R/l)(1 − 2(r/L) cos γ) + (R/L)(r/L)(1 + r/l)}.

    The source divides by cos Φ and sin Θ to get E and F, which fails at γ = 0; hypot and atan2 do not.
    """
    R, L, r, l, gamma, zeta = _letters(rod)  # noqa: N806 - the letters of the equations above
    sin_psi, cos_psi = np.sin(zeta - gamma), np.cos(zeta - gamma)
    rho = r / L
    reach = 1 + r / l
    own_rod = R / l * (1 - 2 * rho * np.cos(gamma))
    master_rod = R / L * rho * reach
    return _harmonics(
        first=(1 + reach * rho * np.sin(gamma) * sin_psi, (r / l - rho * reach * np.cos(gamma)) * sin_psi),
        second=(
            own_rod + master_rod * np.cos(2 * gamma),
            2 * rho * R / l * np.sin(gamma) * (1 - reach * l / L * np.cos(gamma)),
        ),
        mean_distance=l + r * cos_psi - R / 4 * (own_rod + master_rod),
    )


def of_exact_motion(rod: ArticulatedRod) -> SlaveHarmonics:
    """Constants of (I.13) of the exact motion itself: its mean and its first two harmonics.

    Parameters
    ----------
    rod : ArticulatedRod
        Numbers.

    Returns
    -------
    SlaveHarmonics, numbers
        In the mean square the best that two harmonics can do for position.

    Notes
    -----
    With α_l = α − γ the distance K + R[E cos(α_l + Φ) + ¼F cos(2α_l − Θ)] has the harmonics R E e^{i(Φ − γ)} and
    ¼R F e^{−i(2γ + Θ)}.
    """
    distance = articulated_rod(turn_grid(), rod).slider.value
    found = 2 * np.fft.rfft(distance) / distance.size
    R, gamma = rod.master.crank_radius, rod.bank_angle  # noqa: N806 - the letters of the equation
    first, second = found[1] * np.exp(1j * gamma), np.conj(found[2] * np.exp(2j * gamma))
    return SlaveHarmonics(
        np.abs(first) / R, np.angle(first), 4 * np.abs(second) / R, np.angle(second), found[0].real / 2
    )


def own_top_distance(rod: ArticulatedRod, harmonics: SlaveHarmonics) -> Array:
    """Distance from the shaft to the top of the two-harmonic curve itself, H = K + R·max[…].

    Parameters
    ----------
    rod : ArticulatedRod
    harmonics : SlaveHarmonics
        F up to 0.6 E.

    Returns
    -------
    Array, of the broadcast shape
        H [m]; with it the displacement starts from zero. The exact H gives (I.13) as the source means it.
    """
    E, Phi, F, Theta, K = harmonics  # noqa: N806 - the letters of (I.13)
    angle = -Phi
    for _step in range(_NEWTON_STEPS):
        slope = E * np.sin(angle + Phi) + F / 2 * np.sin(2 * angle - Theta)
        move = slope / (E * np.cos(angle + Phi) + F * np.cos(2 * angle - Theta))
        angle = angle - move
        if not np.any(np.abs(move) > _SETTLED):
            break
    return K + rod.master.crank_radius * (E * np.cos(angle + Phi) + F / 4 * np.cos(2 * angle - Theta))


def slave_displacement(
    angle: Array, rod: ArticulatedRod, harmonics: SlaveHarmonics, top_distance: Array
) -> Coefficient:
    """Slave's displacement by (I.13).

    Parameters
    ----------
    angle : Array
        Crank angle α from the master's dead centre. [rad]
    rod : ArticulatedRod, fields broadcastable with angle
    harmonics : SlaveHarmonics, fields broadcastable with angle
    top_distance : Array, broadcastable with angle
        H, from the shaft to the slave's top: exact, or the curve's own (`own_top_distance`). [m]

    Returns
    -------
    Coefficient, of the broadcast shape
        Displacement from the slave's top toward the shaft. [m, m/rad, m/rad²]

    Notes
    -----
    With α_l = α − γ: S = H − K − R[E cos(α_l + Φ) + ¼F cos(2α_l − Θ)],
    v/ω = R[E sin(α_l + Φ) + ½F sin(2α_l − Θ)],  j/ω² = R[E cos(α_l + Φ) + F cos(2α_l − Θ)].
    """
    E, Phi, F, Theta, K = harmonics  # noqa: N806 - the letters of (I.13)
    R = rod.master.crank_radius  # noqa: N806
    first = angle - rod.bank_angle + Phi
    second = 2 * (angle - rod.bank_angle) - Theta
    return Coefficient(
        top_distance - K - R * (E * np.cos(first) + F / 4 * np.cos(second)),
        R * (E * np.sin(first) + F / 2 * np.sin(second)),
        R * (E * np.cos(first) + F * np.cos(second)),
    )


def _harmonics(first: tuple[Array, Array], second: tuple[Array, Array], mean_distance: Array) -> SlaveHarmonics:
    """Amplitudes and phases from the pairs (amplitude·cos phase, amplitude·sin phase)."""
    return SlaveHarmonics(
        np.hypot(*first),
        np.arctan2(first[1], first[0]),
        np.hypot(*second),
        np.arctan2(second[1], second[0]),
        mean_distance,
    )


def _letters(rod: ArticulatedRod) -> tuple[Array, Array, Array, Array, Array, Array]:
    """R, L, r, l, γ, ζ of the equations, which know no offsets."""
    master = rod.master
    return (
        master.crank_radius,
        master.rod_length,
        rod.knuckle_radius,
        rod.rod_length,
        rod.bank_angle,
        rod.articulation_angle,
    )
