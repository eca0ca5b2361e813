"""What is compiled is kept on disk, and found again as long as all that it is made of is as it was."""

import hashlib
import os
import sys
from collections.abc import Callable, Iterable, Iterator
from functools import cache
from importlib.metadata import version
from pathlib import Path
from types import CodeType, FunctionType
from typing import Any

import numpy as np


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
    for part in (sys.version, np.__version__, version("numba"), *more):
        found.update(part.encode())
    for line in _made_of(functions):
        found.update(line.encode())
    return found.hexdigest()[:24]


def _made_of(functions: Iterable[Callable[..., Any]]) -> Iterator[str]:
    """What some functions do, and all that they call, with the numbers that they name."""
    open_ends: list[Any] = list(functions)
    seen = set[Any]()
    while open_ends:
        function = open_ends.pop()
        if function in seen:
            continue
        seen.add(function)
        yield f"{function.__module__}.{function.__qualname__}"
        code = function.__code__
        yield from _said_by(code)
        for name in code.co_names:
            used = function.__globals__.get(name)
            if isinstance(used, FunctionType):
                open_ends.append(used)
            elif isinstance(used, int | float | tuple):
                yield f"{name} = {used!r}"


def _said_by(code: CodeType) -> Iterator[str]:
    """What a function does, wherever it stands."""
    yield repr((code.co_code, code.co_names, code.co_varnames))
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _said_by(constant)
        else:
            yield repr(constant)


def keep(compiled: Any, function: Callable[..., Any], *more: str) -> None:
    """Let Numba keep what it makes of a function, by all that this is made of and by more, not by its file alone."""
    compiled._cache = _kept_caches(more)(function)


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

    class KeptCache(caching.FunctionCache):
        _impl_class = Kept

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
