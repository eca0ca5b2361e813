"""How a written cycle is compiled: kernels into its loops, long parts beside them, and all of it kept on disk.

Kernels take a crank angle for its cosine and its sine alone. So an angle may be both of these, found once for all
mechanisms; and the value of an angle that is found back from its sine and cosine is asked by no force, and is NaN.
"""

import operator
from collections.abc import Callable
from functools import cache
from inspect import getsource
from types import ModuleType
from typing import Any, NamedTuple, ParamSpec, TypeVar

import numpy as np

from cranktrain.linkage import compiled as compiled_kernel
from cranktrain.linkage.compile import options_of
from cranktrain.linkage.forces import Friction
from cranktrain.linkage.forces.guide import Guided, friction_force
from cranktrain.linkage.kept import keep
from cranktrain.motion import Array
from cranktrain.study.cycle import given, nodes, panels
from cranktrain.study.cycle.powers import power
from cranktrain.transient.compiling import quick

Parameters = ParamSpec("Parameters")
Outcome = TypeVar("Outcome")

FASTER = frozenset({"contract", "reassoc", "arcp", "nsz"})
"""What sums and products may be made of; what is no number stays so."""
_AS_WRITTEN = frozenset({"contract"})
"""Of what is exact in its own order alone."""


class Direction(NamedTuple):
    """An angle by its cosine and its sine."""

    cos: Array
    sin: Array


def cosine(angle: Any) -> Array:
    """Cosine of an angle."""
    return angle.cos if isinstance(angle, Direction) else np.cos(angle)


def sine(angle: Any) -> Array:
    """Sine of an angle."""
    return angle.sin if isinstance(angle, Direction) else np.sin(angle)


def not_asked(_sine: Array, _cosine: Array) -> float:
    """Value of an angle that nobody asks for."""
    return np.nan


def no_friction(_guided: Guided, _friction: Friction) -> float:
    """Force of friction in a guide: machines in which something rubs are not compiled."""
    return 0.0


def _cos_known(angle: Direction) -> Array:
    return angle.cos


def _sin_known(angle: Direction) -> Array:
    return angle.sin


def _cos(angle: Array) -> Array:
    return np.cos(angle)


def _sin(angle: Array) -> Array:
    return np.sin(angle)


def _turned(angle: Direction, by: Array) -> Direction:
    cos, sin = np.cos(by), np.sin(by)
    return Direction(angle.cos * cos - angle.sin * sin, angle.sin * cos + angle.cos * sin)


@cache
def plain_numpy() -> ModuleType:
    """Give what stands for NumPy in the kernels."""
    from numba.extending import overload

    def of_direction(angle: object) -> bool:
        return getattr(angle, "instance_class", None) is Direction

    def compiled_cosine(angle: object) -> object:
        return _cos_known if of_direction(angle) else _cos

    def compiled_sine(angle: object) -> object:
        return _sin_known if of_direction(angle) else _sin

    def compiled_nothing(*_given: object) -> object:
        return not_asked

    def compiled_sum(angle: object, _by: object) -> object:
        return _turned if of_direction(angle) else None

    within: Any = options_of(within=True)
    overload(cosine, strict=False, jit_options=within)(compiled_cosine)
    overload(sine, strict=False, jit_options=within)(compiled_sine)
    overload(not_asked, strict=False, jit_options=within)(compiled_nothing)
    overload(operator.add, strict=False, jit_options=within)(compiled_sum)
    module = ModuleType("plain_numpy")
    vars(module).update({name: thing for name, thing in vars(np).items() if isinstance(thing, np.ufunc | float)})
    vars(module).update(cos=cosine, sin=sine, arctan2=not_asked, power=compiled_kernel(power, faster=_AS_WRITTEN))
    return module


def kernel(function: Callable[Parameters, Outcome]) -> Callable[Parameters, Outcome]:
    """Compile a kernel, to stand in the loop that calls it."""
    return compiled_kernel(
        function, faster=FASTER, numpy=plain_numpy(), instead=((friction_force, no_friction),), within=True
    )


def called(function: Callable[Parameters, Outcome], *, within: bool = True) -> Callable[Parameters, Outcome]:
    """Compile a long loop, which is called, within compiled code or from Python; what Python calls is kept."""
    compiled = quick(function, FASTER, within=within)
    if not within:
        keep(compiled, *map(getsource, (given, nodes, panels)))
    return compiled


def part(function: Callable[Parameters, Outcome]) -> Callable[Parameters, Outcome]:
    """Compile a part of a written module, to stand where it is called."""
    return _compiled(function, forceinline=True, **options_of(within=True))


def loop(function: Callable[Parameters, Outcome]) -> Callable[Parameters, Outcome]:
    """Compile the outermost loop of a written file, whose name says what it is made of, and keep what comes out."""
    compiled = _compiled(function, nogil=True, **options_of(within=False))
    keep(compiled)
    return compiled


def _compiled(function: Callable[Parameters, Outcome], **options: Any) -> Callable[Parameters, Outcome]:
    import numba

    njit: Any = numba.njit
    return njit(error_model="numpy", fastmath=set(FASTER), **options)(function)
