"""Kernels for plain numbers: as `linkage.compiled`, but without a compiler, for a run that is not worth its wait."""

import math
from collections.abc import Callable
from functools import cache
from types import FunctionType
from typing import Any, ParamSpec, TypeVar, cast

import numpy as np

from cranktrain.motion import chosen

Parameters = ParamSpec("Parameters")
Outcome = TypeVar("Outcome")


def in_floats(kernel: Callable[Parameters, Outcome]) -> Callable[Parameters, Outcome]:
    """Give the same kernel for floats: NumPy's functions of one number are those of `math`, a choice is Python's own.

    Of its own callees by name the same; some ten times as quick as NumPy with single numbers.
    """
    return cast(Callable[Parameters, Outcome], _in_floats(kernel))


@cache
def _in_floats(kernel: Any) -> Any:
    if not isinstance(kernel, FunctionType):
        return kernel
    found = {
        name: _instead(called)
        for name in kernel.__code__.co_names
        if (called := kernel.__globals__.get(name)) is np or isinstance(called, FunctionType)
    }
    return FunctionType(
        kernel.__code__,
        {**kernel.__globals__, **found},
        kernel.__name__,
        kernel.__defaults__,
        kernel.__closure__,
    )


def _instead(called: Any) -> Any:
    """What stands in a kernel for floats in place of a function, or of NumPy."""
    if called is np:
        return _Floats()
    return _of_two if called is chosen else _in_floats(called)


def _of_two(condition: Any, one: Any, other: Any) -> Any:
    """One or the other."""
    return one if condition else other


class _Floats:
    """NumPy for single numbers: what is not here is NumPy's own."""

    abs = staticmethod(abs)
    sqrt = staticmethod(math.sqrt)
    exp = staticmethod(math.exp)
    maximum = staticmethod(max)
    minimum = staticmethod(min)
    where = staticmethod(_of_two)

    @staticmethod
    def sign(number: float) -> float:
        """−1, 0 or 1."""
        return math.copysign(1.0, number) if number else 0.0

    def __getattr__(self, name: str) -> Any:
        return getattr(np, name)
