"""Steady running where torques depend on the speed and others jump: solved in the pieces between events."""

import numpy as np

from cranktrain.motion import Array, Coefficient
from cranktrain.numerics.periodic import PeriodicCurve, combined, piecewise_curve
from cranktrain.numerics.piecewise import mean_shares, quintics
from cranktrain.numerics.subintervals import partial_integrals
from cranktrain.questions.evenness.speed_law import MOST_STEPS, SETTLED, SpeedUnderLaw, TorqueLaw, even_speed
from cranktrain.questions.evenness.speed_over_cycle import speed_from_energy

_SHARES, _WEIGHTS = mean_shares()
_TO_SHARES: Array = partial_integrals(2 * _SHARES - 1, len(_SHARES)) / 2
"""From values at a piece's points to its integrals from the piece's start to each, in parts of its width."""


def speed_between_events(law: TorqueLaw, work: PeriodicCurve, inertia: PeriodicCurve) -> SpeedUnderLaw:
    """Speed over a cycle at which all torques balance; as `speed_under_law`, but between events.

    Parameters
    ----------
    law : TorqueLaw, shapes (design, 1)
        All but what `work` holds; some part of it has to depend on the speed.
    work : PeriodicCurve
        A(φ) of the torques that do not depend on the speed, less their mean. [J]
    inertia : PeriodicCurve
        J(φ), in pieces that begin as those of `work`. [kg·m²]

    Returns
    -------
    SpeedUnderLaw
        NaN where the torques balance at no speed, or do not depend on it.

    Notes
    -----
    What is left of the energy, B = T − A, has no corner: B′ = τ(ω). Newton's method, whose every step is a linear
    periodic equation that is solved from piece to piece. docs/theory/evenness, eqs. (17.11) and (17.13).
    """
    assert work.between is not None
    width, cycle = work.between.width, work.cycle
    stored, carried = (np.stack([one.each(share).value for share in _SHARES], axis=-1) for one in (work, inertia))
    # One law for all points of all pieces.
    wide = TorqueLaw(
        law.free[..., np.newaxis],
        tuple(
            one._replace(
                coefficient=one.coefficient[..., np.newaxis], exponent=np.asarray(one.exponent)[..., np.newaxis]
            )
            for one in law.powers
        ),
    )
    with np.errstate(all="ignore"):
        rest = carried * even_speed(law)[..., np.newaxis] ** 2 / 2 - stored
        begins = np.zeros_like(width)
        move = np.full(rest.shape[:-2], np.inf)
        for _ in range(MOST_STEPS):
            energy = stored + rest
            speed = np.sqrt(2 * energy / carried)
            slope = wide.slope(speed) / (carried * speed)
            better, begins = _periodic(-slope, wide.torque(speed) - slope * rest, width)
            # A step that would stop the shaft goes part of the way.
            better = np.maximum(better, energy / 4 - stored)
            move = np.max(np.abs(better - rest) / energy, axis=(-2, -1))
            rest = better
            if not np.any(move > SETTLED):
                break
        begins = np.where((move <= SETTLED)[..., np.newaxis], begins, np.nan)
        ends = np.roll(begins, -1, axis=-1)
        before, after = _rest(law, work, inertia, ends, 1.0), _rest(law, work, inertia, begins, 0.0)
        left = piecewise_curve(quintics(before, after, width), work.between, np.zeros_like(work.samples), cycle)
        left = left._replace(samples=left.value(work.angle))
        found = speed_from_energy(combined(work, np.ones(1), left), inertia)
        slope = law.slope(found.speed) / (inertia.samples * found.speed)
        return SpeedUnderLaw(found, law.torque(found.speed), np.exp(cycle * np.mean(slope, axis=-1)))


def _rest(law: TorqueLaw, work: PeriodicCurve, inertia: PeriodicCurve, rest: Array, share: float) -> Coefficient:
    """What is left of the energy at one end of each piece, with its derivatives: B, τ, τ′ω′."""
    stored, carried = work.each(np.asarray(share)), inertia.each(np.asarray(share))
    speed = np.sqrt(2 * (stored.value + rest) / carried.value)
    torque = law.torque(speed)
    rate = (stored.first + torque - carried.first * speed**2 / 2) / (carried.value * speed)
    return Coefficient(rest, torque, law.slope(speed) * rate)


def _periodic(decay: Array, source: Array, width: Array) -> tuple[Array, Array]:
    """Periodic solution of y′ + g y = h by values of both at Gauss's points of pieces, shape (..., piece, point).

    There, and where pieces begin, shape (..., piece). From piece to piece y goes to ay + b; these are put together two,
    four, … at a time.
    """
    wide = width[..., np.newaxis]
    within, whole = wide * (decay @ _TO_SHARES.T), width * (decay @ _WEIGHTS)
    grown = source * np.exp(within)
    factor, added = np.exp(-whole), np.exp(-whole) * width * (grown @ _WEIGHTS)
    n_pieces = width.shape[-1]
    reach = 1
    while reach < n_pieces:
        before = factor[..., :-reach], added[..., :-reach]
        added = np.concatenate([added[..., :reach], factor[..., reach:] * before[1] + added[..., reach:]], axis=-1)
        factor = np.concatenate([factor[..., :reach], factor[..., reach:] * before[0]], axis=-1)
        reach *= 2
    total = np.sum(whole, axis=-1, keepdims=True)
    first = added[..., -1:] / -np.expm1(-total)
    begins = np.concatenate([first, (factor * first + added)[..., :-1]], axis=-1)
    return np.exp(-within) * (begins[..., np.newaxis] + wide * (grown @ _TO_SHARES.T)), begins
