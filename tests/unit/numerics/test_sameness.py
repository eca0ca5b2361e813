"""Data is the same to the last bit, or it is not the same."""

from functools import partial
from types import MappingProxyType

import numpy as np
import pytest

from cranktrain.motion import single
from cranktrain.numerics.sameness import is_same
from cranktrain.record import record


@record
class Rod:
    """A record."""

    length: object

    def stretched(self):
        """A method."""


@pytest.mark.parametrize(
    "make",
    [
        lambda: 0.1 + 0.2,
        lambda: float("nan"),
        lambda: -0.0,
        lambda: "".join(["a", "b"]),
        lambda: 10**30,
        lambda: np.array([[0.5, np.nan], [-0.0, np.inf]]),
        lambda: np.array(["L", "R"]),
        lambda: np.array(["L", 3.0, None], dtype=object),
        lambda: np.array(2.0),
        lambda: (1.0, ("a", single(2.0))),
        lambda: {"a": (1.0, None)},
        lambda: MappingProxyType({"a": 1.0}),
        lambda: Rod(Rod(np.arange(3.0))),
        lambda: partial(np.add, np.arange(2.0), dtype=None),
        lambda: Rod(2.0).stretched,
    ],
)
def test_what_is_made_twice_is_the_same(make):
    assert is_same(make(), make())


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (0.0, -0.0),
        (1, True),
        (1, 1.0),
        (1.0, float("nan")),
        (1.0, None),
        (np.array([0.0]), np.array([-0.0])),
        (np.array([1.0]), np.array([1.0], dtype=np.float32)),
        (np.array([1.0]), np.array([[1.0]])),
        (np.array([1.0]), np.array([1])),
        (np.array([1.0, 2.0]), np.array([1.0, np.nextafter(2.0, 3.0)])),
        (np.array(["L"], dtype=object), np.array(["R"], dtype=object)),
        ((1.0,), (1.0, 2.0)),
        ((1.0,), [1.0]),
        ({"a": 1, "b": 2}, {"b": 2, "a": 1}),
        ({"a": 1}, {"a": 2}),
        (Rod(1.0), Rod(2.0)),
        (Rod(1.0), (1.0,)),
        (lambda: 1, lambda: 1),
        (partial(np.add, 1.0), partial(np.add, 2.0)),
        (partial(np.add, 1.0), partial(np.subtract, 1.0)),
        (Rod(2.0).stretched, Rod(3.0).stretched),
        (Rod(2.0).stretched, Rod(2.0).__repr__),
        (object(), object()),
    ],
)
def test_what_differs_is_not_the_same(one, other):
    assert not is_same(one, other)
    assert not is_same((one,), (other,))
    assert not is_same(Rod(one), Rod(other))
