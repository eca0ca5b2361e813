"""What compiled code calls alone is a part of it: the same numbers, and machine code once; no garbage looked for."""

import gc
import math

import pytest

from cranktrain.linkage import compiled
from cranktrain.linkage.compile import uncollected


def scaled(value, by):
    return value * by


def shifted(value, by):
    return scaled(value, by) + math.pi


def twice_shifted(value, by):
    return shifted(shifted(value, by), by) - scaled(by, 2.0)


def test_a_function_and_all_that_it_calls_are_machine_code_once(monkeypatch):
    """Each of three would be by itself."""
    pytest.importorskip("numba")
    from numba.core.codegen import JitEngine

    compiled(scaled)(1.0, 1.0)  # before which Numba makes what it needs itself
    made = []
    usual = JitEngine.finalize_object
    monkeypatch.setattr(JitEngine, "finalize_object", lambda self: made.append(self) or usual(self))
    outer = compiled(twice_shifted)
    assert outer(2.0, 3.0) == twice_shifted(2.0, 3.0) == 3.0 * (6.0 + math.pi) + math.pi - 6.0
    assert len(made) == 1


def test_no_garbage_is_looked_for_meanwhile():
    """As before behind it, whatever ends it; within another one it is the other's end that counts."""
    assert gc.isenabled()
    with uncollected():
        with uncollected():
            assert not gc.isenabled()
        assert not gc.isenabled()
    with pytest.raises(ZeroDivisionError), uncollected():
        raise ZeroDivisionError
    assert gc.isenabled()
