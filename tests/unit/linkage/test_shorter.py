"""Numba's way to what LLVM is given, in fewer steps: with the same numbers, and its own where steps are missing."""

import numpy as np
import pytest

from cranktrain.linkage.shorter import shorter
from cranktrain.transient.compiling import quick

pytest.importorskip("numba")


def last_of_each(numbers, rounds):
    """Values that are given once, in one block and read in others; in each round; and on one of two ways alone."""
    start, total, before = numbers[0], 0.0, -1.0
    for turn in range(rounds):
        step = numbers[turn % numbers.size]
        for other in range(2):
            if step > start:
                total += step * before + other
            elif other == 0:
                late = step - start
                total -= late * late
        before = step
    return total, before, start


def of_one_place(numbers, place):
    """Both branches give one name a value."""
    chosen_there = numbers[place] if place >= 0 else 7.0
    within = max(chosen_there, 1.0)
    return within * chosen_there


def with_one_within(number):
    """A function of its own within."""

    def twice(value):
        return 2.0 * value

    return twice(number) + 1.0


def first_of_it(numbers, rounds):
    """What another one gives, which stands in it."""
    return last_of_each(numbers, rounds)[2]


NUMBERS = np.array([2.0, 3.5, -1.0, 2.25, 8.0])


@pytest.mark.parametrize("rounds", [0, 1, 2, 9])
def test_values_are_those_of_plain_python(rounds):
    assert quick(last_of_each)(NUMBERS, rounds) == last_of_each(NUMBERS, rounds)


@pytest.mark.parametrize("place", [-1, 0, 4])
def test_a_name_of_two_values_has_the_right_one(place):
    assert quick(of_one_place)(NUMBERS, place) == of_one_place(NUMBERS, place)


def test_what_is_known_of_one_way_to_add_is_not_taken_for_another():
    """The same function with the same types: one is added as it is written, one may be put together otherwise."""

    def largest(one: float, other: float, third: float) -> float:
        return max(one, other) + third - max(one, other)

    exact, loose = quick(largest), quick(largest, frozenset({"reassoc", "nsz"}))
    assert loose(1e17, 1.0, 1.0) == 1.0
    assert exact(1e17, 1.0, 1.0) == largest(1e17, 1.0, 1.0) == 0.0
    assert loose is not exact


def test_numba_types_functions_by_itself_again_behind_it():
    from numba.core import types

    plain = types.BaseFunction.get_call_type
    quick(of_one_place)(NUMBERS, 1)
    assert types.BaseFunction.get_call_type is plain


def test_what_has_one_value_has_no_place_in_memory():
    """Though other blocks read it; what has another one in each round has."""
    from numba.core import compiler

    if shorter(compiler.Compiler) is compiler.Compiler:
        pytest.skip("this Numba is newer than those with which fewer steps were tried")
    whole = quick(first_of_it)
    assert whole(NUMBERS, 3) == NUMBERS[0]
    (part,) = whole.py_func.__globals__["last_of_each"].overloads.values()
    places = [line for line in part.library.get_llvm_str().splitlines() if " = alloca " in line]
    assert not [line for line in places if line.strip().startswith(("%start ", "%step "))]
    assert [line for line in places if line.strip().startswith(("%total", "%before"))]


def test_a_function_within_stands_where_it_is_called():
    assert quick(with_one_within)(4.0) == with_one_within(4.0)


@pytest.mark.parametrize(
    ("module", "owner", "name"),
    [
        ("lowering", "Lower", "_find_singly_assigned_variable"),
        ("lowering", "Lower", "storevar"),
        ("typed_passes", "", "NativeLowering"),
    ],
)
def test_another_numba_goes_its_own_way(module, owner, name, monkeypatch):
    """One whose steps have other names."""
    from importlib import import_module

    from numba.core import compiler

    there = import_module(f"numba.core.{module}")
    monkeypatch.delattr(getattr(there, owner) if owner else there, name)
    assert shorter(compiler.Compiler) is compiler.Compiler


@pytest.mark.parametrize("short", [(0, 60), (0, 69), (1, 0)])
def test_a_numba_that_was_not_tried_goes_its_own_way(short, monkeypatch):
    import numba
    from numba.core import compiler

    monkeypatch.setattr(numba, "version_info", numba.version_info._replace(short=short))
    assert shorter(compiler.Compiler) is compiler.Compiler
