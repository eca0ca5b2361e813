"""cranktrain: exact mechanics of any machine with a crank in it.

A machine from an example, a file or its tables, and what it does:

>>> import cranktrain as ct
>>> ct.run("3d12")
<Result of 3D12 marine diesel, 60° V12 with articulated rods: 154 quantities, 7 checks hold, 1 flag>
"""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from cranktrain import viz
    from cranktrain.analysis import Result
    from cranktrain.analysis.comparison import Comparison
    from cranktrain.errors import InputError, Problem
    from cranktrain.io.any_machine import load
    from cranktrain.machine import Machine
    from cranktrain.public import compare, examples, run

__all__ = [
    "Comparison",
    "InputError",
    "Machine",
    "Problem",
    "Result",
    "__version__",
    "compare",
    "examples",
    "load",
    "run",
    "viz",
]

__version__ = "0.1.0"

# Imported when first asked for: the terminal's help and lists do without NumPy and pydantic.
_HOMES = {
    "Comparison": "analysis.comparison",
    "InputError": "errors",
    "Machine": "machine",
    "Problem": "errors",
    "Result": "analysis",
    "compare": "public",
    "examples": "public",
    "load": "io.any_machine",
    "run": "public",
}


def __getattr__(name: str) -> object:
    if name == "viz":
        return import_module("cranktrain.viz")
    if name in _HOMES:
        return getattr(import_module(f"cranktrain.{_HOMES[name]}"), name)
    if name.startswith("_"):
        raise AttributeError(f"cranktrain has no {name}")
    from cranktrain.quantities import nearest  # only after a mistake

    meant = nearest(name, __all__)
    raise AttributeError(f"cranktrain has no {name}" + (f"; did you mean {meant}?" if meant else ""))


def __dir__() -> list[str]:
    return [*(name for name in globals() if name.startswith("__")), *(name for name in __all__ if name != "__version__")]
