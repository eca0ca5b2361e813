"""The power of the compiled cycle, as plain Python and compiled, against forty digits."""

import mpmath
import numpy as np
import pytest

from cranktrain.study.cycle.powers import power

RANDOM = np.random.default_rng(7)
BASES = np.concatenate([np.exp(RANDOM.uniform(-8, 8, 400)), [0.5, np.sqrt(0.5), 1.0, 2.0, np.nextafter(1.0, 0.0)]])
EXPONENTS = np.concatenate([RANDOM.uniform(-2, 2, 400), [1.3, 1.3, 1.3, 1.3, 1.3]])


def compiled_power():
    pytest.importorskip("numba")
    from cranktrain.study.cycle.compiling import plain_numpy

    return plain_numpy().power


@pytest.mark.parametrize("made", [lambda: power, compiled_power])
def test_a_power_is_that_of_forty_digits(made):
    """Its error is that of a rounded logarithm: some parts of 2⁻⁵³ times the logarithm of the power."""
    found = made()
    with mpmath.workdps(40):
        for base, exponent in zip(BASES.tolist(), EXPONENTS.tolist(), strict=True):
            expected = mpmath.power(mpmath.mpf(base), mpmath.mpf(exponent))
            assert abs(mpmath.mpf(float(found(base, exponent))) / expected - 1) < 4e-15


@pytest.mark.parametrize("made", [lambda: power, compiled_power])
@pytest.mark.parametrize("base", [0.0, -1.0, np.nan, np.inf, -np.inf])
def test_what_is_not_positive_has_none(made, base):
    with np.errstate(all="ignore"):
        assert np.isnan(made()(base, 1.3))


@pytest.mark.parametrize("made", [lambda: power, compiled_power])
def test_what_is_beyond_all_pressures_has_none(made):
    with np.errstate(all="ignore"):
        assert np.isnan(made()(1e300, 2.0))
        assert np.isnan(made()(2.0, np.nan))
        assert np.isnan(made()(2.0, np.inf))
