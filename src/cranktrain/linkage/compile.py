"""The same kernels, compiled: for sweeps, transients and whatever calls them a million times."""

from collections.abc import Callable
from functools import cache
from types import FunctionType
from typing import Any, ParamSpec, TypeVar, cast

from cranktrain.motion import chosen

Parameters = ParamSpec("Parameters")
Outcome = TypeVar("Outcome")


def compiled(kernel: Callable[Parameters, Outcome]) -> Callable[Parameters, Outcome]:
    """Compile a kernel and every kernel that it calls with Numba.

    Parameters
    ----------
    kernel : function
        Any kernel of `linkage`, `mechanisms` or `gas`. Elementwise: compiled, it takes numbers or arrays, gives numbers
        for numbers, and can be called from other compiled code, a loop over designs or the right-hand side of a
        differential equation.

    Returns
    -------
    function
        With the kernel's signature. Its first call compiles; the same kernel gives the same compiled function.

    Raises
    ------
    ImportError
        Where Numba is not installed: `pip install 'cranktrain[fast]'`.
    """
    return cast(Callable[Parameters, Outcome], _compiled(kernel))


@cache
def _compiled(kernel: FunctionType) -> object:
    """Compile a copy of the kernel whose globals hold compiled callees."""
    import numba

    teach_choices()
    callees = {
        name: _compiled(called)
        for name in kernel.__code__.co_names
        if isinstance(called := kernel.__globals__.get(name), FunctionType) and called is not chosen
    }
    copy = FunctionType(kernel.__code__, {**kernel.__globals__, **callees}, kernel.__name__)
    # As NumPy: what cannot close is NaN, not an exception. LLVM would not inline a large kernel into a loop by itself,
    # which costs a sixth of its time; a kernel's private parts it may weigh, or long kernels would take minutes.
    # Said in so many words, as else it would take after the function that calls it first.
    return numba.njit(error_model="numpy", fastmath=False, forceinline=not kernel.__name__.startswith("_"))(copy)


@cache
def teach_choices() -> None:
    """Tell Numba what `chosen` is: between numbers a plain choice, which is a number and lets loops be vectorised.

    Between arrays it is the same choice, element by element: `np.where` would take twenty times as long to compile.
    """
    import numba
    from numba import types
    from numba.extending import overload

    chosen_elements: Callable[..., object] = cast(Any, numba).vectorize(_chosen_number)  # its types are partly unknown

    def of_arrays(condition: object, one: object, other: object) -> object:
        return chosen_elements(condition, one, other)

    def compiled_choice(*given: object) -> object:
        return of_arrays if any(isinstance(each, types.Array) for each in given) else _chosen_number

    overload(chosen, strict=False)(compiled_choice)


def _chosen_number(condition: bool, one: float, other: float) -> float:
    return one if condition else other
