"""No crank angle is said to be at the end of the cycle: there all begins again, at 0."""

import re

import numpy as np
import pytest

import cranktrain as ct

MACHINES = {"burning_cylinder": 720, "mill_engine": 360, "shaper": 360}
OFF = 0.002
"""How much before the end of the cycle what happens is brought to happen. [deg]"""


def places(result):
    """Crank angles at which something is, by name. [deg]"""
    for name, entry in result.catalogue.items():
        if entry.is_place:
            known = np.ravel(getattr(result, name))
            yield from ((name, float(angle)) for angle in known[np.isfinite(known)])


@pytest.mark.parametrize("name", MACHINES)
def test_what_is_just_before_the_end_of_the_cycle_is_said_to_be_at_its_beginning(name):
    cycle = MACHINES[name]
    whole = ct.run(name)
    wanted = sorted({round(angle, 1): angle for _name, angle in places(whole) if angle > 1.0}.values())
    assert len(wanted) > 3
    n_brought = 0
    for angle in wanted[:: max(len(wanted) // 6, 1)]:
        result = ct.run(ct.load(name, set={"crank_zero": f"{angle + OFF!r} deg"}))
        # What is counted within one turn of a cycle of two, as dead centres are, comes to the middle of this.
        n_brought += any(cycle - 0.0049 < at < cycle for _name, at in places(result))
        said = [result.summary(), *map(str, result.page().splitlines())]
        ends = [line for line in said if re.search(rf"\b{cycle}\.00?(?!\d)", line)]
        assert [line for line in ends if not re.search("interval|period", line)] == []
    assert n_brought > 1
