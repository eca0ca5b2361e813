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
    from cranktrain.machine import Machine

__all__ = ["InputError", "Machine", "Problem", "Result", "run"]

_HOMES = {
    "InputError": "cranktrain.errors",
    "Machine": "cranktrain.machine",
    "Problem": "cranktrain.errors",
    "Result": "cranktrain.analysis",
    "run": "cranktrain.analysis",
}


def __getattr__(name: str) -> object:
    """Import a public name when it is first asked for: help and lists of the terminal need no arrays."""
    if name not in _HOMES:
        raise AttributeError(f"module 'cranktrain' has no attribute {name!r}")
    value = getattr(import_module(_HOMES[name]), name)
    globals()[name] = value
    return value
