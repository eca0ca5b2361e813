"""What is compiled is kept on disk, and found again as long as all that it is made of is as it was."""

import hashlib
import os
import re
import sys
from collections.abc import Callable, Iterable, Iterator
from functools import cache
from importlib.metadata import version
from pathlib import Path
from types import CodeType, FunctionType
from typing import Any, cast

import numpy as np

_ADDRESS = re.compile(r"numba\.dynamic\.globals\.([0-9a-f]+)")
"""What Numba calls a place in this process's memory within what it makes."""


def folder() -> Path:
    """Where it is kept: `CRANKTRAIN_CACHE`, or the user's own cache."""
    named = os.environ.get("CRANKTRAIN_CACHE")
    if named:
        return Path(named)
    home = os.environ.get("XDG_CACHE_HOME") or (Path.home() / ".cache")
    return Path(home) / "cranktrain"


def fingerprint(functions: Iterable[Callable[..., Any]], *more: str) -> str:
    """Name of what is made of some functions, of all that they call, whatever calls whatever, and of more."""
    found = hashlib.sha256()
    for part in (sys.version, np.__version__, version("numba"), version("llvmlite"), *more):
        found.update(part.encode())
    for line in _made_of(functions):
        found.update(line.encode())
    return found.hexdigest()[:24]


def _made_of(functions: Iterable[Callable[..., Any]]) -> Iterator[str]:
    """What some functions do, and all that they call, with the numbers that they name; how what is compiled is so."""
    for function in _called_by(functions):
        if hasattr(function, "py_func"):
            yield from _compiled_as(function)
            continue
        yield f"{function.__module__}.{function.__qualname__}"
        yield from _said_by(function.__code__)
        for name, used in _used_by(function):
            if isinstance(used, int | float | str):
                yield f"{name} = {used!r}"


def _called_by(functions: Iterable[Callable[..., Any]]) -> Iterator[Any]:
    """Some functions and all that they call, each once, compiled ones and behind each what it is made of."""
    open_ends: list[Any] = list(functions)
    seen = set[Any]()
    while open_ends:
        function = open_ends.pop()
        if function in seen:
            continue
        seen.add(function)
        yield function
        if hasattr(function, "py_func"):
            open_ends.append(function.py_func)
        else:
            open_ends += [used for _name, used in _used_by(function) if not isinstance(used, int | float | str)]


def _used_by(function: FunctionType) -> Iterator[tuple[str, Any]]:
    """Functions, numbers and words that one names, and those that were joined into it."""
    code, cells = function.__code__, function.__closure__ or ()
    for name in code.co_names:
        yield from _each_in(name, function.__globals__.get(name))
    for name, cell in zip(code.co_freevars, cells, strict=True):
        yield from _each_in(name, cell.cell_contents)


def _each_in(name: str, used: Any) -> Iterator[tuple[str, Any]]:
    """What stands under a name, of a tuple all that is in it."""
    if isinstance(used, tuple):
        for each in cast(tuple[object, ...], used):
            yield from _each_in(name, each)
    elif isinstance(used, FunctionType | int | float | str) or hasattr(used, "py_func"):
        yield name, used


def _compiled_as(compiled: Any) -> Iterator[str]:
    """Options of what is compiled."""
    options: dict[str, Any] = compiled.targetoptions
    for name, option in sorted(options.items()):
        yield f"{name} = {sorted(cast(set[str], option)) if isinstance(option, set) else option}"


def _said_by(code: CodeType) -> Iterator[str]:
    """What a function does, wherever it stands."""
    yield repr((code.co_code, code.co_names, code.co_varnames, code.co_freevars))
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _said_by(constant)
        else:
            yield repr(constant)


def keep(compiled: Any, *more: str) -> None:
    """Let Numba keep what it makes of a function, by all that this is made of and by more, not by its file alone."""
    compiled._cache = _kept_caches(more)(compiled.py_func)


def is_kept(compiled: Any) -> bool:
    """Whether what is made of a function that is to be kept is there already, from whichever process."""
    return compiled._cache.is_any


@cache
def _kept_caches(more: tuple[str, ...]) -> Any:
    """Class of Numba's caches that know a function by what it is made of."""
    from numba.core import caching as untyped

    caching: Any = untyped

    class Place(caching._CacheLocator):
        """Where a function is kept, and what its name there is."""

        def __init__(self, function: Any) -> None:
            self._made_of = fingerprint([function], *more)

        @classmethod
        def from_function(cls, py_func: Any, py_file: str) -> Any:
            del py_file
            return cls(py_func)

        def get_cache_path(self) -> str:
            return str(folder() / "loops")

        def get_source_stamp(self) -> str:
            return self._made_of

        def get_disambiguator(self) -> str:
            return self._made_of

    class Kept(caching.CompileResultCacheImpl):
        _locator_classes = (Place,)

        def __init__(self, py_func: Any) -> None:
            known: Any = super()
            known.__init__(py_func)
            self._function = py_func

        def check_cachable(self, cres: Any) -> bool:
            """Whether it holds in other processes, as the only places in memory that it names are of functions.

            Those of functions that are passed on: which one is called is settled when it is compiled.
            """
            if not cres.library.has_dynamic_globals:
                return True
            named = {int(at, base=16) for at in _ADDRESS.findall(cres.library.get_llvm_str())}
            return named <= {id(each) for each in _called_by([self._function])}

    class KeptCache(caching.FunctionCache):
        _impl_class = Kept

        @property
        def is_any(self) -> bool:
            """Whether anything is kept that can be read."""
            try:
                return bool(self._cache_file._load_index())
            except Exception:  # as below: what cannot be read is not there
                return False

        def _index_key(self, sig: Any, codegen: Any) -> object:
            """By which it is found: what it is given, with the names of fields, and for which processor it is."""
            return sig, codegen.magic_tuple(), tuple(_fields_of(getattr(sig, "args", sig)))

        def load_overload(self, sig: Any, target_context: Any) -> Any:
            """Give what is kept; nothing where it cannot be read, as what a version left whose classes are gone."""
            known: Any = super()
            try:
                return known.load_overload(sig, target_context)
            except Exception:  # unpickling raises whatever it likes; what cannot be read is made anew
                return None

        def save_overload(self, sig: Any, data: Any) -> None:
            """Keep it, in place of what cannot be read; not where there is no room."""
            known: Any = super()
            for _attempt in range(2):
                try:
                    known.save_overload(sig, data)
                except OSError:
                    return
                except Exception:  # as above: an index that cannot be read is begun anew
                    self.flush()
                else:
                    return

    return KeptCache


def _fields_of(types: Iterable[Any]) -> Iterator[tuple[str, ...]]:
    """Names of fields of all named tuples among types of arguments, which compiled code knows by their places."""
    for each in types:
        yield tuple(getattr(each, "fields", ()))
        yield from _fields_of(getattr(each, "types", ()))
