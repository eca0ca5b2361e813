"""Designs that are there as machines, judged at once: what is wrong with each, as it says itself."""

from collections.abc import Mapping, Sequence

import numpy as np

from cranktrain.columns import numbers_of
from cranktrain.errors import Problem
from cranktrain.machine import Machine, machine_problems
from cranktrain.study.sweep.numbers import bits
from cranktrain.study.sweep.rules import judged_together

_FEW = 24
"""Machines of which fewer are asked one by one."""
_ASKED = 4
"""Of those that are right, so many are asked by themselves, too."""


def wrong_machines(machines: Sequence[Machine], together: Machine) -> Mapping[int, Problem]:
    """Find the first of what is wrong with each of some machines.

    Parameters
    ----------
    machines : sequence of Machine
        Whose tables differ in numbers alone.
    together : Machine
        Their numbers in columns, as `in_columns` puts them.

    Returns
    -------
    mapping of int to Problem
        By places of the machines with which anything is wrong. Rules are asked of all at once, and again of each that
        is not right.
    """
    asked: Sequence[int] = range(len(machines))
    if len(machines) >= _FEW:
        each = ((where, given.array) for where, given in numbers_of(together))
        differing = {where: column for where, column in each if np.any(bits(column) != bits(column[:1]))}
        judged = judged_together(machines[0], differing, len(machines))
        is_right = ~judged.is_wrong & ~judged.is_unknown
        right = np.flatnonzero(is_right)
        some: list[int] = right[np.linspace(0, right.size - 1, min(_ASKED, right.size)).astype(np.intp)].tolist()
        if not any(machine_problems(machines[place]) for place in some):
            asked = [int(place) for place in np.flatnonzero(~is_right)]
    return {place: found[0] for place in asked if (found := machine_problems(machines[place]))}
