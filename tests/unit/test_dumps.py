"""Dumps of quantities are told apart, and statements counted, as `benchmarks/` says."""

from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

import numpy as np
import pytest

BENCHMARKS = Path(__file__).parents[2] / "benchmarks"


def script(name):
    """A module of a folder that is no package."""
    spec = spec_from_file_location(name, BENCHMARKS / f"{name}.py")
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


agreement, statements = script("agreement"), script("statements")
RUN = "an engine, ahead"
QUANTITIES = {
    "force": ("N", [2.0, -50.0, 0.0, np.nan]),
    "shaft_angle": ("deg", [0.0, 10.0, 359.0, -90.0]),
    "torque_order_amplitude": ("N*m", [1.0, 2.0, 3.0, 1e-12]),
    "torque_order_phase": ("deg", [10.0, 20.0, 30.0, 40.0]),
    "rim_mass": ("kg", [8.0, 8.0, 8.0, 8.0]),
}


def dump(texts=(), **changed):
    """A dump of one run in which some quantities have other values, or None for not being there."""
    values = {name: changed.get(name, values) for name, (_unit, values) in QUANTITIES.items()}
    arrays = {(RUN, name): np.array(values) for name, values in values.items() if values is not None}
    entries = {(RUN, name): [unit, "order"] for name, (unit, _values) in QUANTITIES.items()}
    return agreement.Dump(arrays, entries, dict(texts))


def moved_too_far(**changed):
    _lines, moved = agreement.report(dump(), dump(**changed))
    return moved


def test_dumps_that_are_the_same():
    lines, moved = agreement.report(dump({"$ run": "5 N"}), dump({"$ run": "5 N"}))
    assert not moved
    assert lines[1:] == [
        "5 of 5 quantities are the same to the last bit",
        "0 moved by more than 1e-13 of their largest member, or 1e-10 where iterated",
        "1 of 1 texts are the same",
    ]


@pytest.mark.parametrize(
    ("name", "values", "is_too_far"),
    [
        ("force", [2.0, -50.0 * (1 + 1e-12), 0.0, np.nan], True),
        ("force", [2.0 + 50e-12, -50.0, 0.0, np.nan], True),
        ("force", [2.0, -50.0, 50e-14, np.nan], False),
        ("force", [2.0, -50.0, 0.0, 0.0], True),
        ("force", [np.nan, -50.0, 0.0, np.nan], True),
        ("force", [2.0, -50.0, 0.0], True),
        ("force", [362.0, -50.0, 0.0, np.nan], True),
        ("shaft_angle", [360.0, -350.0, -1.0, 270.0], False),
        ("shaft_angle", [360.0, 190.0, 359.0, -90.0], True),
        ("torque_order_phase", [10.0, 20.0, 30.0, 77.0], False),
        ("torque_order_phase", [10.0, 20.0, 31.0, 40.0], True),
        ("rim_mass", [8.0, 8.0 + 8e-12, 8.0, 8.0], False),
        ("rim_mass", [8.0, 8.0 + 8e-9, 8.0, 8.0], True),
    ],
)
def test_a_number_that_moves(name, values, is_too_far):
    assert moved_too_far(**{name: values}) is is_too_far


def test_a_quantity_that_is_lost_or_new():
    less = dump(force=None)
    lines, moved = agreement.report(dump(), less)
    assert moved
    assert lines[-3:-1] == ["only before: 1", f"  {RUN} | force"]
    lines, moved = agreement.report(less, dump())
    assert not moved
    assert lines[-3:-1] == ["only after: 1", f"  {RUN} | force"]


def test_a_text_that_differs_is_shown_and_moves_no_number():
    before, after = (dump({"a": f"first\n{word}", "b": f"{word}", "c": "same"}) for word in ("old", "new"))
    lines, moved = agreement.report(before, after)
    assert not moved
    assert lines[-4:] == ["1 of 3 texts are the same", "a and 1 more", "  -old", "  +new"]


def test_statements_are_counted_without_imports_and_docstrings():
    text = '''"""A module."""
import os
from typing import TYPE_CHECKING
if TYPE_CHECKING:
    import sys
SIZE = 3
"""Its size."""
def twice(x):
    """Give twice."""
    if x:
        return 2 * x
    return 0
'''
    assert statements.size(text).statements == 5  # SIZE, def, if and two returns
    assert statements.size("x = 1; y = 2").statements == 2
    assert statements.size("import os").nodes == 0


@pytest.mark.parametrize(("folder", "is_so"), [("a", True), ("a/b", True), ("a/b/", True), ("a/bc", False)])
def test_what_is_in_a_folder(folder, is_so):
    assert statements.is_in("a/b/c.py", folder) is is_so
