"""Written cycles on disk: one module for all machines of a structure, found by what it and its kernels are made of."""

import hashlib
import os
import sys
from collections.abc import Callable, Iterable, Iterator
from functools import cache
from importlib.metadata import version
from importlib.util import module_from_spec, spec_from_file_location
from inspect import getsource
from pathlib import Path
from tempfile import gettempdir
from types import CodeType, FunctionType, ModuleType
from typing import Any

import numpy as np

from cranktrain.study.cycle import chambers, compiling, loops, nodes, panels, running, tops
from cranktrain.study.cycle.compiling import FASTER
from cranktrain.study.cycle.source import Written

_LOOPS = (chambers, compiling, loops, nodes, panels, running, tops)


def written_module(written: Written) -> ModuleType:
    """Give a module that was written, as a file if it is not there.

    It is found again as long as its source, and that of every kernel that it calls, whatever calls whatever, are as
    they were; what Numba made of it is kept beside it.
    """
    return _imported(_folder() / f"cycle_{_fingerprint(written)}.py", written.source)


def _folder() -> Path:
    """Where cycles are kept: `CRANKTRAIN_CACHE`, or the user's own cache."""
    named = os.environ.get("CRANKTRAIN_CACHE")
    if named:
        return Path(named) / "cycles"
    home = os.environ.get("XDG_CACHE_HOME") or (Path.home() / ".cache")
    return Path(home) / "cranktrain" / "cycles"


def _fingerprint(written: Written) -> str:
    """Name of a module, by all that it is made of."""
    found = hashlib.sha256(written.source.encode())
    for part in (sys.version, np.__version__, version("numba"), *sorted(FASTER)):
        found.update(str(part).encode())
    for module in _LOOPS:
        found.update(getsource(module).encode())
    for line in _made_of(written.calls):
        found.update(line.encode())
    return found.hexdigest()[:24]


def _made_of(functions: Iterable[Callable[..., Any]]) -> Iterator[str]:
    """Sources of some functions, and of all that they call, with the numbers that they name."""
    open_ends, seen = list(functions), set[Any]()
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


@cache
def _imported(path: Path, source: str) -> ModuleType:
    """Import a module from its file, which is written whole or not at all."""
    try:
        _write(path, source)
    except OSError:  # no room of one's own: for this process alone
        path = Path(gettempdir()) / f"cranktrain-{os.getpid()}" / path.name
        _write(path, source)
    spec = spec_from_file_location(path.stem, path)
    assert spec is not None
    assert spec.loader is not None
    module = module_from_spec(spec)
    sys.modules[path.stem] = module
    spec.loader.exec_module(module)
    return module


def _write(path: Path, source: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    if path.exists() and path.read_text(encoding="utf-8") == source:
        return
    beside = path.with_name(f"{path.name}.{os.getpid()}")
    beside.write_text(source, encoding="utf-8")
    beside.replace(path)
