"""cranktrain: exact mechanics of any machine with a crank in it.

>>> import cranktrain as ct
>>> machine = ct.Machine(
...     name="a pump", mechanism={"kind": "slider_crank", "stroke": "12 in", "rod_length": "30 in"}
... )
>>> result = ct.run(machine)
>>> print(round(float(result.top_dead_centre[0]), 9), round(float(result.stroke[0]), 4))
0.0 0.3048
"""

from cranktrain.analysis import Result, run
from cranktrain.errors import InputError, Problem
from cranktrain.machine import Machine

__all__ = ["InputError", "Machine", "Problem", "Result", "run"]
