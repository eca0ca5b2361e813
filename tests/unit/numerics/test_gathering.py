"""What several have, summed where it acts: by hand, with whole numbers, which are exact in any order."""

import numpy as np
import pytest

from cranktrain.numerics.gathering import gathered

PLACE = np.array([2, 0, 2, 3])
"""Four on four places, of which one has none and one has two."""


@pytest.mark.parametrize("unit", [1.0, 1.0 + 2.0j])
def test_sums_by_hand(unit):
    """Designs lead, and each has its own numbers."""
    values = unit * np.arange(24.0).reshape(2, 4, 3)
    found = gathered(values, PLACE, 4)
    for design in range(2):
        first, second, third, fourth = values[design]
        np.testing.assert_array_equal(found[design], [second, [0.0, 0.0, 0.0], first + third, fourth])
    assert found.dtype == values.dtype


@pytest.mark.parametrize("unit", [1.0, 1.0 + 0.0j])
def test_what_cannot_close_leaves_other_throws_alone(unit):
    """NaN times 0 would be NaN, on every throw."""
    values = unit * np.ones((4, 2))
    values[1] = np.nan
    found = gathered(values, PLACE, 4)
    assert np.all(np.isnan(found[0]))
    np.testing.assert_array_equal(found[1:].real, [[0.0, 0.0], [2.0, 2.0], [1.0, 1.0]])
