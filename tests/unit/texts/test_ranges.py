import numpy as np
import pytest

from cranktrain.references import REFERENCES
from cranktrain.texts.ranges import RANGES

BY_METHOD = {one.method: one for one in RANGES}


def test_every_range_names_a_known_source_and_says_its_condition():
    assert len(BY_METHOD) == len(RANGES)
    for one in RANGES:
        assert one.source in REFERENCES
        assert one.name
        assert one.condition
        assert one.equations


@pytest.mark.parametrize("method", ["two_harmonics", "brix"])
def test_up_to_three_tenths_and_central(method):
    ratio = np.array([0.1, 0.3, 0.03 / 0.1, 0.09 / 0.3, 0.301, 0.5])
    assert BY_METHOD[method].outside(ratio, np.array(0.0)).tolist() == [False, False, False, False, True, True]
    assert BY_METHOD[method].outside(np.array(0.2), np.array([0.0, 1e-3, -1e-3])).tolist() == [False, True, True]


def test_infinite_rod_below_one_tenth_and_central():
    ratio = np.array([0.05, 0.099, 0.1, 0.3 / 3, 0.2])
    assert BY_METHOD["infinite_rod"].outside(ratio, np.array(0.0)).tolist() == [False, False, True, True, True]
    assert BY_METHOD["infinite_rod"].outside(np.array(0.05), np.array([0.0, 1e-3])).tolist() == [False, True]


@pytest.mark.parametrize("method", ["derived", "reconstructed"])
def test_articulated_rod_has_no_range_in_the_source(method):
    flags = BY_METHOD[method].outside(np.array([[0.2], [0.9]]), np.array([0.0, 0.01, 0.02]))
    assert flags.shape == (2, 3)
    assert not flags.any()
    assert "no range" in BY_METHOD[method].condition


def test_reconstructed_is_called_so():
    assert "reconstructed" in BY_METHOD["reconstructed"].name


def test_flags_broadcast():
    ratio, offset = np.array([[0.2], [0.4]]), np.array([0.0, 0.01, 0.0])
    for one in RANGES:
        assert one.outside(ratio, offset).shape == (2, 3)
