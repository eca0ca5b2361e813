"""What other compiled code alone calls is optimised in what calls it, and nowhere else."""

import math

import pytest

from cranktrain.linkage.once import how_compiled
from cranktrain.transient.compiling import quick

pytest.importorskip("numba")


def innermost(number: float) -> float:
    return math.sqrt(number) + 1.0


def inner(number: float) -> float:
    total = 0.0
    for _ in range(3):
        total += innermost(number + total)
    return total


def outer(number: float) -> float:
    return inner(number) * inner(2.0 * number)


def test_parts_have_no_machine_code_and_the_whole_has_them_all():
    """To the last bit as they are in plain Python."""
    compiled = quick(outer)
    for number in (0.1, 2.0, 1e9):
        assert compiled(number) == outer(number)
    (whole,) = compiled.overloads.values()
    callee = compiled.py_func.__globals__["inner"]
    (part,) = callee.overloads.values()
    assert "innermost" in whole.library.get_llvm_str() or "sqrt" in whole.library.get_llvm_str()
    assert "sqrt" not in part.library.get_llvm_str()
    assert part.library.get_pointer_to_function(part.fndesc.llvm_func_name) == 0


def test_one_part_may_be_in_several():
    """And what Python calls may stand in it, too."""
    whole = quick(inner)
    assert whole(3.0) == inner(3.0)
    assert quick(outer)(3.0) == outer(3.0)


def test_sums_put_together_otherwise_are_optimised_once_too():
    """As those of cycles are: no part is optimised by itself."""
    compiled = quick(outer, frozenset({"reassoc"}))
    assert compiled(2.0) == pytest.approx(outer(2.0), rel=1e-15)
    (whole,) = compiled.overloads.values()
    (part,) = compiled.py_func.__globals__["inner"].overloads.values()
    assert whole.library.get_llvm_str().count("alloca") < part.library.get_llvm_str().count("alloca")


@pytest.mark.parametrize(("owner", "name"), [("", "JITCodeLibrary"), ("JITCPUCodegen", "_module_pass_manager")])
def test_another_numba_compiles_as_it_does_by_itself(owner, name, monkeypatch):
    """One that has no such library of compiled code, or optimises it in other words."""
    from numba.core import codegen

    if owner:
        monkeypatch.setattr(codegen, owner, type(owner, (), {}))
    else:
        monkeypatch.delattr(codegen, name)
    assert how_compiled.__wrapped__() == ({}, {})
