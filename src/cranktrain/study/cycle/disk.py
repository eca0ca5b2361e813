"""Written loops: one file for all machines of a structure, by what it and its kernels are made of."""

import os
import sys
from functools import cache
from importlib.util import module_from_spec, spec_from_file_location
from inspect import getsource
from pathlib import Path
from tempfile import gettempdir
from types import ModuleType

from cranktrain.linkage.kept import fingerprint, folder
from cranktrain.study.cycle import chambers, compiling, given, loops, nodes, panels, repeats, running, tops
from cranktrain.study.cycle.source import WrittenLoops

_LOOPS = (chambers, compiling, given, loops, nodes, panels, repeats, running, tops)


def loaded_loops(written: WrittenLoops) -> ModuleType:
    """Give a module that was written, as a file if it is not there."""
    name = fingerprint(written.calls, written.source, *sorted(compiling.FASTER), *map(getsource, _LOOPS))
    return _imported(folder() / "cycles" / f"cycle_{name}.py", written.source)


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
