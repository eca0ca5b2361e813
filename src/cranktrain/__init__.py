"""cranktrain: exact mechanics of any machine with a crank in it.

>>> import cranktrain as ct
>>> machine = ct.Machine(
...     name="a pump", mechanism={"kind": "slider_crank", "stroke": "12 in", "rod_length": "30 in"}
... )
>>> result = ct.run(machine)
>>> print(round(float(result.top_dead_centre[0]), 9), round(float(result.stroke[0]), 4))
0.0 0.3048
"""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from cranktrain.analysis import Result, run
    from cranktrain.errors import InputError, Problem
    from cranktrain.io.machine_file import load
    from cranktrain.machine import Machine

__all__ = ["InputError", "Machine", "Problem", "Result", "__version__", "load", "run"]

__version__ = "0.1.0"

# Imported when first asked for: the terminal's help and lists do without NumPy and pydantic.
_HOMES = {
    "InputError": "cranktrain.errors",
    "Machine": "cranktrain.machine",
    "Problem": "cranktrain.errors",
    "Result": "cranktrain.analysis",
    "load": "cranktrain.io.machine_file",
    "run": "cranktrain.analysis",
}


def __getattr__(name: str) -> object:
    if name not in _HOMES:
        raise AttributeError(f"cranktrain has no {name}")
    return getattr(import_module(_HOMES[name]), name)


def __dir__() -> list[str]:
    return [*globals(), *_HOMES]
