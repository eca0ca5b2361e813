"""Cubics whose slopes five samples give, kept within limits where these are not smooth: plateaus and corners stay."""

from itertools import pairwise

import numpy as np

from cranktrain.fluids.indicator.curve import CubicCurve, steps_between
from cranktrain.motion import Array

_BESIDE = 2
"""Steps on each side of a sample that give its slope."""
_MONOTONE = 3.0
"""Slope, in parts of the lesser chord beside it, up to which a cubic does not turn back."""
_CURVED = 1.2
"""Slope, in parts of that of the flatter parabola beside it, that smooth samples stay within."""
_CORNER = 2.0
"""A bend more than so many times as sharp as those beside it is a corner rather than a crest."""


def limited_curve(places: Array, values: Array, period: float) -> CubicCurve:
    """Curve through samples of one period that overshoots at smooth crests only.

    Parameters
    ----------
    places : Array, shape (m,)
        Never falling, within one period; a place given twice, before and after, is a jump. [rad]
    values : Array, shape (m,)
    period : float
        [rad]

    Returns
    -------
    CubicCurve
        Nothing of it reaches across a jump.

    Notes
    -----
    The slope at a sample is that of the quartic through it and two on each side, as far as it lies within the modified
    Akima slope, 0, and Huynh's limits. docs/theory/gas, eqs. (14.12) to (14.14).

    Examples
    --------
    >>> curve = limited_curve(np.arange(8.0), np.array([0.0, 0.0, 0.0, 4.0, 4.0, 4.0, 2.0, 1.0]), 8.0)
    >>> [round(float(slope), 3) + 0.0 for slope in curve.start_slopes]
    [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.667, -1.0]
    """
    steps = steps_between(places, values, period)
    chords = (steps.ends - steps.starts) / steps.lengths
    jumps = np.flatnonzero(steps.after_jump).tolist()
    if jumps:
        pieces = [np.arange(jump, after) % len(chords) for jump, after in pairwise([*jumps, jumps[0] + len(chords)])]
        of_pieces = [_slopes_between_jumps(steps.lengths[own], chords[own]) for own in pieces]
    else:
        pieces = [np.arange(len(chords))]
        of_pieces = [_slopes(*(np.pad(part, _BESIDE, mode="wrap") for part in (steps.lengths, chords)))]
    start_slopes, end_slopes = np.empty_like(chords), np.empty_like(chords)
    for own, slopes in zip(pieces, of_pieces, strict=True):
        start_slopes[own], end_slopes[own] = slopes[:-1], slopes[1:]
    return CubicCurve(period, steps.places, steps.starts, steps.ends, start_slopes, end_slopes)


def _slopes_between_jumps(lengths: Array, chords: Array) -> Array:
    """Slopes at all ends of some steps: parabolas go on beyond the outer ones, where none turns against its chord."""
    if len(chords) == 1:
        return np.append(chords, chords)
    beyond = [
        np.array([chord - change, chord]) - 2 * change * length / (length + next_length)
        for chord, change, length, next_length in (
            (chords[0], chords[1] - chords[0], lengths[0], lengths[1]),
            (chords[-1], chords[-2] - chords[-1], lengths[-1], lengths[-2]),
        )
    ]
    slopes = _slopes(np.pad(lengths, _BESIDE, mode="symmetric"), np.concatenate([beyond[0], chords, beyond[1][::-1]]))
    ends = [0, -1]
    steepest = _MONOTONE * chords[ends]
    slopes[ends] = np.clip(slopes[ends], np.minimum(0.0, steepest), np.maximum(0.0, steepest))
    return slopes


def _slopes(lengths: Array, chords: Array) -> Array:
    """Slopes where steps meet, by two steps on each side: of k steps with their chords, at the k − 3 inner ends."""
    # Divided differences of three, four and five samples.
    three = np.diff(chords) / _spans(lengths, 2)
    four = np.diff(three) / _spans(lengths, 3)
    five = np.diff(four) / _spans(lengths, 4)
    (before, after), (left, right) = ((part[1:-2], part[2:-1]) for part in (lengths, chords))
    quartic = left + before * (three[1:-1] - after * (four[:-1] + (before + lengths[:-3]) * five))
    shared = _lesser(three[:-1], three[1:])
    flatter = _lesser(left + before * shared[:-1], right - after * shared[1:])
    akima = akima_slopes(lengths, chords) * _roundness(three)
    limits = np.stack([akima, np.zeros_like(left), _MONOTONE * _lesser(left, right), _CURVED * flatter])
    slopes = np.clip(quartic, np.min(limits, axis=0), np.max(limits, axis=0))
    # A step between two others of one sign has no crest in it, and one between equal samples is a plateau.
    has_crest = (chords[:-2] * chords[2:] <= 0) & (chords[1:-1] != 0)
    most = np.where(has_crest, np.inf, _MONOTONE * np.abs(chords[1:-1]))
    most = np.minimum(most[:-1], most[1:])
    return np.clip(slopes, -most, most)


def akima_slopes(lengths: Array, chords: Array) -> Array:
    """Modified Akima slopes where steps meet.

    Parameters
    ----------
    lengths, chords : Array, shape (k,)
        Of steps one after the other, and the slopes of their chords.

    Returns
    -------
    Array, shape (k − 3,)
        Where steps meet, but for the outer end on each side.

    Notes
    -----
    Between the chords beside, each as far as those on the *other* side are alike; with even steps as SciPy has it.
    docs/theory/gas, eq. (14.13).
    """
    change = np.abs(np.diff(chords)) / _spans(lengths, 2)
    size = np.abs(chords[1:] + chords[:-1]) / 2
    before, after = lengths[1:-2], lengths[2:-1]
    span = before + after
    of_left = after * (span * change[2:] + size[2:])
    of_right = before * (span * change[:-2] + size[:-2])
    total = of_left + of_right
    weighted = of_left * chords[1:-2] + of_right * chords[2:-1]
    return np.where(total > 0, weighted / np.where(total > 0, total, 1.0), 0.0)


def _roundness(bends: Array) -> Array:
    """From 1 where samples bend as much as those beside them, in the same sense, to 0 in a corner."""
    own = bends[1:-1]
    beside = np.maximum(bends[:-2] * np.sign(own), bends[2:] * np.sign(own))
    return np.clip(_CORNER * beside / np.where(own == 0.0, np.inf, np.abs(own)), 0.0, 1.0)


def _spans(lengths: Array, n_steps: int) -> Array:
    """Length of so many steps together, from each on."""
    return np.convolve(lengths, np.ones(n_steps), mode="valid")


def _lesser(one: Array, other: Array) -> Array:
    """The lesser in size of two that have one sign, else 0."""
    return np.where(one * other > 0, np.where(np.abs(one) < np.abs(other), one, other), 0.0)
