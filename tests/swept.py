"""Sweeps of a small machine that tests of stores and processes share, and what goes wrong with them on purpose."""

import os
import signal
from pathlib import Path

import numpy as np
from tests.machines import slider

import cranktrain as ct
from cranktrain.study.facts_of_rows import FactsOfRows
from cranktrain.study.sweep import Sweep

ROOT = Path(__file__).parents[1]
MACHINE = ct.Machine(mechanism=slider(crank_radius="40 mm", rod_length="136 mm"), shaft={"main": {"speed": "1500 rpm"}})
VARY = {"rod_length": "30..150 mm:13", "speed": "1000, 1500, 2000 rpm"}
WANTED = ["largest_piston_acceleration", "mean_piston_speed", "stroke"]


def same(one: Sweep, other: Sweep) -> None:
    """Both have the same facts to the last bit, and say the same."""
    assert list(one.catalogue) == list(other.catalogue)
    assert dict(one.found.labels) == dict(other.found.labels)
    for name in one.catalogue:
        assert (
            np.ascontiguousarray(getattr(one, name)).tobytes() == np.ascontiguousarray(getattr(other, name)).tobytes()
        )
    assert str(one) == str(other)


def deadly(rows: list[dict[str, object]]) -> FactsOfRows:
    """Facts that nobody can compute who meets a rod of 13 mm."""
    if any(row.get("mechanism.rod_length") == "13 mm" for row in rows):
        os.kill(os.getpid(), signal.SIGKILL)
    nothing = ("",) * len(rows)
    return FactsOfRows({}, {}, {}, (None,) * len(rows), nothing, nothing, ((),) * len(rows))
