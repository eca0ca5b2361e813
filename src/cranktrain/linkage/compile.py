"""The same kernels, compiled: for sweeps, transients and whatever calls them a million times."""

import gc
from collections.abc import Callable, Generator
from contextlib import contextmanager
from functools import cache
from types import FunctionType, ModuleType
from typing import Any, ParamSpec, TypeVar, cast

from cranktrain.motion import chosen

Parameters = ParamSpec("Parameters")
Outcome = TypeVar("Outcome")

FROM_PYTHON: dict[str, Any] = {"_nrt": False, "no_cfunc_wrapper": True}
"""Of what Python calls, and no program in C, and makes no arrays: to count who holds those given takes a third of a
loop's time, and a tenth of compiling."""
WITHIN: dict[str, Any] = {**FROM_PYTHON, "no_cpython_wrapper": True}
"""Of what other compiled code calls alone: what lets Python call a function takes as long to compile as itself."""


def compiled(
    kernel: Callable[Parameters, Outcome],
    *,
    faster: frozenset[str] = frozenset(),
    numpy: ModuleType | None = None,
    instead: tuple[tuple[Callable[..., Any], Callable[..., Any]], ...] = (),
    within: bool = False,
) -> Callable[Parameters, Outcome]:
    """Compile a kernel and every kernel that it calls with Numba.

    Parameters
    ----------
    kernel : function
        Any kernel of `linkage`, `mechanisms` or `fluids`.
    faster : frozenset of str
        How sums and products may be put together otherwise than they are written, in the words of LLVM; as written
        unless given, so that what comes out is what the kernel itself gives, to the last bit.
    numpy : module, optional
        What stands for NumPy in the kernels.
    instead : tuple of pairs of functions
        Kernels, and what is called in the place of each.
    within : bool
        Whether it is called by other compiled code alone, and never from Python.

    Returns
    -------
    function
        With the kernel's signature, for numbers: on arrays the kernel itself is as fast. It can be called from other
        compiled code, a loop over designs or the right-hand side of a differential equation. Its first call compiles;
        the same kernel gives the same compiled function.

    Raises
    ------
    InputError
        Where Numba is not installed, with how to have it.
    """
    return cast(Callable[Parameters, Outcome], _compiled(kernel, faster, numpy, instead, within=within))


@cache
def _compiled(
    kernel: FunctionType,
    faster: frozenset[str],
    numpy: ModuleType | None,
    instead: tuple[tuple[Callable[..., Any], Callable[..., Any]], ...],
    *,
    within: bool,
) -> object:
    """Compile a copy of the kernel whose globals hold compiled callees."""
    from cranktrain.extras import imported  # only for who compiles
    from cranktrain.linkage.once import how_compiled

    numba = imported("numba", "compiled")
    teach_choices()
    others: dict[Any, Any] = dict(instead)
    callees = {
        name: _compiled(others.get(called, called), faster, numpy, instead, within=True)
        for name in kernel.__code__.co_names
        if isinstance(called := kernel.__globals__.get(name), FunctionType) and called is not chosen
    }
    known = {**kernel.__globals__, **callees}
    if numpy is not None and "np" in known:
        known["np"] = numpy
    copy = FunctionType(kernel.__code__, known, kernel.__name__)
    # As NumPy: what cannot close is NaN, not an exception. LLVM would not inline a large kernel into a loop by itself,
    # which costs a sixth of its time; a kernel's private parts it may weigh, or long kernels would take minutes.
    # Said in so many words, as else it would take after the function that calls it first.
    inlined = not kernel.__name__.startswith("_")
    options = options_of(within=True) if within else how_compiled().whole
    return numba.njit(error_model="numpy", fastmath=set(faster) or False, forceinline=inlined, **options)(copy)


def options_of(*, within: bool) -> dict[str, Any]:
    """Options for Numba of what Python calls, or other compiled code alone."""
    from cranktrain.linkage.once import how_compiled  # only for who compiles

    return {**WITHIN, **how_compiled().part} if within else {**FROM_PYTHON, **how_compiled().whole}


@contextmanager
def uncollected() -> Generator[None]:
    """Let no garbage be looked for meanwhile: of what a compiler makes nearly all is held until its end.

    To look through that again and again takes a seventh of the time in which something is compiled.
    """
    is_usual = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if is_usual:
            gc.enable()


@cache
def teach_choices() -> None:
    """Tell Numba what `chosen` is: a plain choice, which is a number and lets loops be vectorised."""
    from numba.extending import overload

    def compiled_choice(*_given: object) -> object:
        return _chosen_number

    within: Any = options_of(within=True)
    overload(chosen, strict=False, jit_options=within)(compiled_choice)


def _chosen_number(condition: bool, one: float, other: float) -> float:
    return one if condition else other
