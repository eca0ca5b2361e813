"""Loops under Numba: as `linkage.compiled`, but for long functions that are called, not inlined, and by threads."""

from collections.abc import Callable
from functools import cache
from types import CellType, FunctionType
from typing import Any, ParamSpec, TypeVar, cast

from cranktrain.linkage.compile import options_of, teach_choices
from cranktrain.linkage.kept import fingerprint, keep
from cranktrain.motion import chosen

Parameters = ParamSpec("Parameters")
Outcome = TypeVar("Outcome")


_AS_WRITTEN: frozenset[str] = frozenset()
"""No product and sum in one rounding: a run is the same to the last bit whether it is compiled or not."""


def quick(
    function: Callable[Parameters, Outcome], faster: frozenset[str] = _AS_WRITTEN, *, within: bool = False
) -> Callable[Parameters, Outcome]:
    """Compile a function, and those that it calls by its globals or that were joined into it, once.

    What Numba has compiled already is taken as it is. Faster says how sums and products may be put together otherwise
    than they are written, in the words of LLVM; within, whether other compiled code alone calls it, and never Python.
    """
    return cast(Callable[Parameters, Outcome], _quick(function, faster, within=within))


def kept(function: Callable[Parameters, Outcome]) -> Callable[Parameters, Outcome]:
    """Compile a function that Python calls, as `quick` does, and keep on disk what comes out."""
    return cast(Callable[Parameters, Outcome], _kept(function))


@cache
def _kept(function: Any) -> Any:
    made = quick(function)
    keep(made)
    return made


@cache
def _quick(function: Any, faster: frozenset[str], *, within: bool) -> Any:
    if not isinstance(function, FunctionType):
        return function
    import numba

    teach_choices()
    callees = {
        name: _quick(called, faster, within=True)
        for name in function.__code__.co_names
        if isinstance(called := function.__globals__.get(name), FunctionType) and called is not chosen
    }
    copy = FunctionType(
        function.__code__,
        {**function.__globals__, **callees},
        function.__name__,
        closure=_cells(function.__closure__, faster),
    )
    if function.__closure__:
        # By its name what is kept finds what it calls: one for each that others were joined into.
        copy.__qualname__ = f"{function.__qualname__}_{fingerprint([copy])}"
    # private parts are called in one place, and calls cost as many words as their arrays have
    is_part = function.__name__.startswith("_")
    made: Any = numba.njit(
        error_model="numpy",
        nogil=True,
        fastmath=set(faster) or False,
        forceinline=is_part,
        **options_of(within=within),
    )
    return made(copy)


def _cells(closure: tuple[CellType, ...] | None, faster: frozenset[str]) -> tuple[CellType, ...] | None:
    """Cells of a closure with their functions compiled, those in a named tuple too."""
    return closure and tuple(CellType(_inner(cell.cell_contents, faster)) for cell in closure)


def _inner(value: Any, faster: frozenset[str]) -> Any:
    if isinstance(value, FunctionType):
        return _quick(value, faster, within=True)
    if isinstance(value, tuple):
        together: Any = cast(tuple[object, ...], value)
        return type(together)(*(_inner(each, faster) for each in together))
    return value
