"""Torques through gear and belt stages over crank angles: what the motor must give, how the crank accelerates."""

from collections.abc import Iterator, Sequence
from itertools import product
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.transient.gearing import Gearing, input_torque


class Passed(NamedTuple):
    """What stages pass on.

    Attributes
    ----------
    acceleration : Array, shape (n,)
        Of the crank; NaN where no pattern of signs fits itself, or several do. [rad/s²]
    outputs : Array, shape (stage, n)
        Torque at each stage's output, load and inertia behind it together. [N·m]
    """

    acceleration: Array
    outputs: Array


def torque_through(load: Array, sense: Array, gearing: Gearing) -> Array:
    """Torque on every shaft for one on the crank, without inertia: the motor's first, the crank's last.

    Parameters
    ----------
    load : Array, shape (n,)
        That the crank takes. [N·m]
    sense : Array, broadcastable
        Sign of the speed.
    gearing : Gearing

    Returns
    -------
    Array, shape (stage + 1, n)
        [N·m] docs/theory/transient, eq. (26.1).
    """
    found = [load]
    for stage in reversed(range(len(gearing.ratio))):
        at_input = input_torque(found[0], sense, gearing.ratio[stage], gearing.forward[stage], gearing.backward[stage])
        found.insert(0, at_input + gearing.drag[stage] * sense)
    return np.stack(found)


def through_stages(torque: Array, inertia: Array, load: Array, gearing: Gearing) -> Passed:
    """Acceleration of a crank that turns forward, and what each stage passes on.

    Parameters
    ----------
    torque, inertia, load : Array, shape (n,), or of designs (design, n)
        Of the motor [N·m]; reduced to the crank, without what turns in the gearing [kg·m²]; that load and ½J′ω² take
        at the crank [N·m].
    gearing : Gearing
        Of designs its numbers have the shape (design, 1), those of stages (stage, design, 1).

    Notes
    -----
    docs/theory/transient, eq. (26.5): of all patterns of signs the one that fits itself. Where every stage turns back
    with a loss less than all, torque grows with the acceleration: what fits is the only one, and no other is tried.
    """
    if np.all(gearing.backward > 0):
        return _that_fits(torque, inertia, load, gearing)
    found = np.full(load.shape, np.nan)
    outputs = np.full((len(gearing.ratio), *load.shape), np.nan)
    n_fits = np.zeros(load.shape, dtype=np.intp)
    for signs in product((True, False), repeat=len(gearing.ratio)):
        acceleration, passed, fits = _of_pattern(signs, torque, inertia, load, gearing)
        found[fits], outputs[:, fits] = acceleration[fits], passed[:, fits]
        n_fits[fits] += 1
    return Passed(np.where(n_fits == 1, found, np.nan), outputs)


def _that_fits(torque: Array, inertia: Array, load: Array, gearing: Gearing) -> Passed:
    """What the first pattern gives that fits itself: all stages driven forward, all back, and then the rest."""
    forward, *others = product((True, False), repeat=len(gearing.ratio))
    found, outputs, fits = _of_pattern(forward, torque, inertia, load, gearing)
    for signs in reversed(others):
        if np.all(fits):
            return Passed(found, outputs)
        acceleration, passed, fits_too = _of_pattern(signs, torque, inertia, load, gearing)
        found, outputs = np.where(fits, found, acceleration), np.where(fits, outputs, passed)
        fits |= fits_too
    return Passed(np.where(fits, found, np.nan), np.where(fits, outputs, np.nan))


def lost_torque(outputs: Array, gearing: Gearing) -> Array:
    """Torque at the crank, which turns forward, that losses take: by what each stage passes on, (stage, n) → (n,).

    docs/theory/transient, eq. (26.10). [N·m]
    """
    factor = np.where(outputs > 0, 1 / gearing.forward[:, np.newaxis], gearing.backward[:, np.newaxis])
    turned = np.cumprod(gearing.ratio[::-1])[::-1]  # of each stage's input, for one of the crank
    at_input = outputs * (factor - 1) / gearing.ratio[:, np.newaxis] + gearing.drag[:, np.newaxis]
    return np.sum(at_input * turned[:, np.newaxis], axis=0)


def gearings_together(each: Sequence[Gearing]) -> Gearing:
    """Gearing of designs with as many stages: numbers of shape (design, 1), those of stages (stage, design, 1)."""
    motors, *stages = zip(*each, strict=True)
    motor: Any = np.stack(motors)[:, np.newaxis]
    return Gearing(motor, *(np.stack(part, axis=1)[..., np.newaxis] for part in stages))


def _of_pattern(
    signs: tuple[bool, ...], torque: Array, inertia: Array, load: Array, gearing: Gearing
) -> tuple[Array, Array, NDArray[np.bool_]]:
    """Acceleration where every stage passes on torque of a given sign, these torques, and where they have it."""
    lines = list(_lines(signs, inertia, load, gearing))
    by_acceleration, constant = lines[-1]
    # Of irreversible gearing behind a motor without inertia no acceleration changes the torque that is left.
    nothing = np.full(np.shape(load), np.nan)
    acceleration = np.divide(torque - constant, by_acceleration, out=nothing, where=by_acceleration != 0)
    passed, fits = np.empty((len(signs), *np.shape(load))), np.isfinite(acceleration)
    for stage, (slope, at) in enumerate(reversed(lines[:-1])):
        passed[stage] = slope * acceleration + at
        fits &= (passed[stage] > 0) == signs[stage]
    return acceleration, passed, fits


def _lines(signs: tuple[bool, ...], inertia: Array, load: Array, gearing: Gearing) -> Iterator[tuple[Array, Array]]:
    """Torque at each stage's output from the crank on, and at the motor, as slope by the acceleration and constant."""
    slope: NDArray[np.float64] = inertia + 0.0
    constant, turned = load, 1.0
    for stage in reversed(range(len(signs))):
        slope = slope + gearing.inertia[stage] * turned
        yield slope, constant
        factor = (1 / gearing.forward[stage] if signs[stage] else gearing.backward[stage]) / gearing.ratio[stage]
        slope, constant = factor * slope, factor * constant + gearing.drag[stage]
        turned *= gearing.ratio[stage]
    yield slope + gearing.motor_inertia * turned, constant
