"""What the benchmarks time is what a run does."""

import sys
from pathlib import Path

import numpy as np

import cranktrain as ct
from cranktrain.analysis import every_stage

BENCHMARKS = Path(__file__).parents[2] / "benchmarks"


def test_stages_of_the_crankshaft_are_those_of_a_run(monkeypatch):
    monkeypatch.syspath_prepend(BENCHMARKS)
    from run import is_of_crankshaft
    from steps import ready_stages

    monkeypatch.delitem(sys.modules, "run")
    result, ready = ct.run([ct.load("vaz_21213")]), ready_stages("vaz_21213")
    own = [one for one in every_stage() if is_of_crankshaft(one) and one.function.__name__ in ready]
    numbers = {
        name: value
        for one in own
        for name, value in vars(ready[one.function.__name__]()).items()
        if name in result.catalogue and isinstance(value, np.ndarray)
    }
    assert len(own) > 10 and len(numbers) > 20
    for name, value in numbers.items():
        if result.catalogue[name].unit == "deg":
            np.testing.assert_allclose(np.rad2deg(value), getattr(result, name), rtol=4e-16, err_msg=name)
        else:
            np.testing.assert_array_equal(value, getattr(result, name), err_msg=name)


def test_random_tables_can_say_whatever_the_schema_has(monkeypatch):
    monkeypatch.syspath_prepend(BENCHMARKS)
    from random_tables import SCHEMA, Maker

    numbers = [name for name, one in SCHEMA["$defs"].items() if "-above-0" in name and "properties" not in one]
    assert len(numbers) > 15
    for name in numbers:
        assert Maker(1).quantity(name) is not None, name


def test_what_pays_for_thousands_of_commands_is_there(monkeypatch):
    monkeypatch.syspath_prepend(BENCHMARKS)
    from fuzz import many_commands

    with many_commands():
        assert ct.load("vaz_21213").name
