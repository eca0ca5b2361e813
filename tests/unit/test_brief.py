"""Values in a line, however much there is of them."""

import numpy as np
import pytest

from cranktrain.brief import LONGEST, brief, brief_fields


@pytest.mark.parametrize(
    ("value", "shown"),
    [
        (3.5, "3.5"),
        ((1,), "(1,)"),
        ([1, 2, 3], "[1, 2, 3]"),
        ([1, 2, 3, 4], "[4 items]"),
        ({"a": (1, 2)}, "{'a': (1, 2)}"),
        (frozenset("ab"), None),
        (np.zeros((2, 3)), "<2 × 3>"),
        (np.float64(2.0), "np.float64(2.0)"),
        ("two\nlines", "'two lines'"),
        (None, "None"),
    ],
)
def test_values(value, shown):
    assert "\n" not in brief(value)
    assert shown is None or brief(value) == shown


def test_long_ones_are_cut():
    assert len(brief("x" * 1000)) < 60
    assert len(brief_fields("Name", {f"field_{i}": i for i in range(100)}.items())) <= LONGEST
