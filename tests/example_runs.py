"""Results of the examples, each computed once for all tests of a process that look at it."""

from functools import cache

import cranktrain as ct


@cache
def ran(name: str) -> ct.Result:
    """An example's whole result; it is frozen, so that no test changes what another one sees."""
    return ct.run(name)
