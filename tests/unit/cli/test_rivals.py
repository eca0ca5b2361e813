"""No table takes anything over methods: it has the one that is meant, or names whose a number is."""

import re

import numpy as np
import pytest
from tests.dimensions import DIMENSIONS

import cranktrain as ct
from cranktrain.analysis.dimensions import rivals

RIVALS = {
    **dict.fromkeys(("force_method", "rod_method", "flywheel_method", "motion_method", "bearing_method"), 0),
    **dict.fromkeys(("throw_method", "loss_rule"), 0),
    "balance": -1,
}
"""What are other answers to one question, and which is meant: the exact, the given, what transmitted torque tells, the
machine with its weights."""


def test_every_dimension_of_methods_says_which_is_meant():
    assert {name: one.own for name, one in DIMENSIONS.items() if one.own is not None} == RIVALS
    assert {name for name in DIMENSIONS if "method" in name or "rule" in name} <= RIVALS.keys()


def test_rivals_are_parted_and_others_stay_together():
    each = list(rivals({"balance": ("without", "with"), "bearing": ("1", "2")}))
    assert each == [((1, slice(None)), "with"), ((0, slice(None)), "without")]
    assert list(rivals({"bearing": ("1", "2")})) == [((slice(None),), "")]
    assert list(rivals({"force_method": ("exact",), "piston": ("1",)})) == [((0, slice(None)), "")]


@pytest.mark.parametrize("name", ["vaz_21213", "ls3", "jaw_crusher", "3d12"])
def test_largest_values_of_curves(name, typed):
    """Each row is of one method, whose name it has; the largest is taken here, over the members of that one alone."""
    result = ct.run(name)
    curves = [
        (one, entry)
        for one, entry in result.catalogue.items()
        if not entry.is_fact and entry.unit in {"N", "N*m"} and RIVALS.keys() & set(entry.dimensions)
    ]
    assert curves
    said = typed("run", name, "--quantities", ",".join(one for one, _entry in curves)).output
    rows = joined(said.partition("Largest values")[2])
    for one, entry in curves:
        dimension = entry.dimensions[0]
        methods = result.titles_of(entry)[dimension]
        own = [row for row in rows if row.split()[0] == one]
        assert len(own) == len(methods)
        for row in own:
            method = methods[0] if len(methods) == 1 else next((each for each in methods if named(each, row)), None)
            assert method is not None, row
            at = np.abs(getattr(result, one)[methods.index(method)])
            shown = re.search(r"−?(\d[\d.]*) +(kN·m|N·m|kN|N) ", row)
            size = float(shown[1]) * (1000 if shown[2].startswith("k") else 1)
            # Between two steps a curve can be larger than at either, by less than a thousandth here.
            assert size == pytest.approx(np.nanmax(at), rel=1e-3, abs=1e-4), row
        if len(methods) > 1:
            assert named(methods[RIVALS[dimension]], own[0])


def joined(table):
    """Rows of a table, with what goes on below in the last column."""
    rows = []
    for line in table.splitlines()[2:]:
        if re.match(r"  \w", line):
            rows.append(line)
        elif rows and line.strip():
            rows[-1] += line.strip() if rows[-1].endswith("_") else f" {line.strip()}"
    return rows


def named(method, row):
    return f" {method}," in f"{row}," or row.endswith(f" {method}")


def test_several_designs():
    """The largest load is that of the best method, which is named where it is not exact."""
    designs = [ct.load("vaz_21213", set={"shaft.main.speed": speed}) for speed in ("4000 rpm", "5600 rpm")]
    result = ct.run(designs, quantities=["largest_bearing_load", "side_force_error"])
    line = next(line for line in result.summary().splitlines() if line.startswith("largest bearing load"))
    own = result.labels["bearing_method"][0]
    assert line.startswith(f"largest bearing load, {own}: ")
    most = np.nanmax(result.largest_bearing_load[:, 0], axis=-1) / 1000
    least, largest = (float(one) for one in re.findall(r"(\d+\.\d+) kN", line))
    errors = [line.partition(":")[0] for line in result.summary().splitlines() if line.startswith("side force error")]
    assert errors == [f"side force error, {method}" for method in result.labels["rod_method"][1:]]
    assert (least, largest) == (pytest.approx(min(most), rel=1e-3), pytest.approx(max(most), rel=1e-3))


def test_two_machines_with_weights_and_without(typed):
    """A V8 as it stands, with its weights: not the largest of both."""
    compared = str(ct.compare("ls3", set={"shaft.main.speed": "5000 rpm"}, quantities="rolling_moment"))
    least, most = (float(np.min(one)) for one in (ct.run("ls3").rolling_moment[1], -ct.run("ls3").rolling_moment[1]))
    numbers = [float(one.replace("−", "-")) for one in re.findall(r"−?\d[\d.]+", compared)]
    assert any(one == pytest.approx(least, rel=1e-3) for one in numbers), compared
    assert any(one == pytest.approx(-most, rel=1e-3) for one in numbers), compared
