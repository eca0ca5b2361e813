"""Numbers of designs as arrays: put together, and those of some taken."""

from typing import NamedTuple

import numpy as np
import pytest

from cranktrain.motion import Array
from cranktrain.numerics.designs import by_design, of_designs, over_designs

TWO = np.array([2.0, 3.0])


class Rod(NamedTuple):
    length: Array
    ends: tuple[Array, Array]


def test_one_number_is_that_of_all_designs():
    np.testing.assert_array_equal(by_design([1.0, TWO, np.float64(4.0)], 2), [[1, 2, 4], [1, 3, 4]])
    np.testing.assert_array_equal(by_design([5, True], 3), np.tile([5.0, 1.0], (3, 1)))
    assert by_design([], 3).shape == (3, 0)


def test_a_column_of_other_designs_is_refused():
    with pytest.raises(ValueError, match="broadcast"):
        by_design([TWO], 3)


def test_tuples_have_the_axis_of_crank_angles():
    """Two rods, of which the second is another in each design."""
    found = by_design([Rod(1.0, (10.0, 11.0)), Rod(TWO, (20.0, TWO + 30))], 2)
    assert isinstance(found, Rod)
    np.testing.assert_array_equal(found.length, [[[1], [2]], [[1], [3]]])
    np.testing.assert_array_equal(found.ends[1], [[[11], [32]], [[11], [33]]])


def test_what_is_no_number_is_an_object():
    cards = np.array(["a card", "another"], dtype=np.object_)
    found = by_design([(cards, None, 1.0)], 2)
    assert [one.dtype.kind for one in found] == ["O", "O", "f"]
    assert found[0][:, 0, 0].tolist() == ["a card", "another"]
    assert found[1][:, 0, 0].tolist() == [None, None]


def test_taking_leaves_what_is_of_all_designs():
    spans, is_open = np.array([0, 1, 1]), np.array([True, False, True])
    found = of_designs(Rod(np.array([1.0, 2.0, 3.0]), (spans, is_open)), np.array([2, 0]))
    assert found.length.tolist() == [3.0, 1.0]
    assert found.ends[0] is spans and found.ends[1] is is_open


def test_what_is_put_together_can_be_taken_apart():
    together = by_design([Rod(TWO, (TWO + 1, 7.0))], 2)
    for design, length in enumerate(TWO):
        alone = of_designs(together, np.array([design]))
        assert (alone.length.item(), alone.ends[0].item(), alone.ends[1].item()) == (length, length + 1, 7.0)


def test_designs_one_at_a_time():
    """A sum that asks what it is given, which no array could answer."""
    found = over_designs(lambda pair: (pair[0] + pair[1] if pair[0] < 2.5 else 0.0,), (TWO, 1.0))
    np.testing.assert_array_equal(found[0], [3.0, 0.0])
    assert over_designs(lambda pair: (pair[0] * 2,), (2.0,)) == (4.0,)
