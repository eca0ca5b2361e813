"""Torsional trains against an eigenvalue solver in 40 digits."""

import mpmath as mp
import numpy as np
import pytest

from cranktrain.questions.torsion.train import Train, natural_modes, scaled

DIGITS = 40
LIMIT = 1e-12
"""Of the largest eigenvalue, and of every frequency by itself."""


def drawn(seed):
    """A train of any shape, whose numbers span many decades, as those of gears and propellers beside throws do."""
    draw = np.random.default_rng(seed)
    n = int(draw.integers(2, 15))
    following = np.array([draw.integers(disc + 1, n) for disc in range(n - 1)])
    return Train(10.0 ** draw.uniform(-3, 3, n), 10.0 ** draw.uniform(3, 7, n - 1), following)


def solved(train):
    """Eigenvalues and modes of K a = ω² J a, with √J on both sides, by rising frequency."""
    n = train.inertia.size
    inertia = [mp.mpf(float(value)) for value in train.inertia]
    matrix = mp.zeros(n)
    for one, (other, stiffness) in enumerate(zip(train.following.tolist(), train.stiffness.tolist(), strict=True)):
        for row, column, sign in ((one, one, 1), (other, other, 1), (one, other, -1), (other, one, -1)):
            matrix[row, column] += sign * mp.mpf(stiffness) / mp.sqrt(inertia[row] * inertia[column])
    values, vectors = mp.eigsy(matrix)
    order = sorted(range(n), key=lambda i: values[i])
    return [values[i] for i in order], [[vectors[j, i] / mp.sqrt(inertia[j]) for j in range(n)] for i in order]


@pytest.mark.parametrize("seed", range(12))
def test_natural_frequencies(seed):
    train = drawn(seed)
    with mp.workdps(DIGITS):
        values, _modes = solved(train)
        speeds = [mp.mpf(float(speed)) for speed in natural_modes(train).speed]
        assert abs(values[0]) < mp.mpf(10) ** (5 - DIGITS) * values[-1]
        assert len(speeds) == len(values) - 1
        for speed, value in zip(speeds, values[1:], strict=True):
            assert abs(speed**2 - value) < LIMIT * values[-1]
            assert abs(speed - mp.sqrt(value)) < LIMIT * mp.sqrt(value)


@pytest.mark.parametrize("seed", range(12))
def test_modes(seed):
    """Weighed by the discs' inertia, a mode errs by rounding over its distance from the next one."""
    train = drawn(seed)
    with mp.workdps(DIGITS):
        values, modes = solved(train)
        found = natural_modes(train).shape
        for n, wanted in enumerate(modes[1:], start=1):
            root = [mp.sqrt(value) for value in values]
            gap = min(abs(root[n] - other) for i, other in enumerate(root) if i != n) / root[-1]
            sign = mp.sign(sum(float(a) * b for a, b in zip(found[n - 1], wanted, strict=True)))
            for disc, (one, other) in enumerate(zip(found[n - 1].tolist(), wanted, strict=True)):
                weight = mp.sqrt(mp.mpf(float(train.inertia[disc])))
                assert abs(sign * one - other) * weight < 1e-14 / gap


def test_a_slow_mode_beside_fast_ones_keeps_its_digits():
    """A rotor on a soft coupling: its frequency is 10⁻⁴ of the fastest, its eigenvalue 10⁻⁸ of the largest."""
    train = Train(np.array([0.03] * 6 + [2.0, 800.0]), np.array([1.5e6] * 5 + [2e6, 5.0]), np.arange(1, 8))
    with mp.workdps(DIGITS):
        values, _modes = solved(train)
        found = natural_modes(train)
        assert values[1] / values[-1] < 2e-8
        assert abs(mp.mpf(float(found.speed[0])) / mp.sqrt(values[1]) - 1) < LIMIT
    np.testing.assert_allclose(scaled(found.shape, 0)[0][0, :6], 1.0, rtol=1e-5)
