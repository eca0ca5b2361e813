"""Counterweights of the synthetic in-line four: its sweep through the machine file, and the least of its loads.

The case's sweep balances parts of all that rotates on a throw, in the web planes, on a grid of 4°. What is found as the
least is compared with a search over the case's own forces, which knows neither machine nor synthesis.
"""

import csv
from functools import cache

import numpy as np
import pytest
from scipy.optimize import minimize_scalar
from tests.crankshaft_i4 import CENTRIFUGAL, RADIUS, SPEED, crankshaft, shaft_loads
from tests.reference_case import GOLDEN
from tests.validation.test_crankshaft_of_a_machine import in_line_four

import cranktrain as ct
from cranktrain.questions.crankshaft.methods import BEARING_METHODS
from cranktrain.synthesis.counterweights import counterweights

FULL = (CENTRIFUGAL["rod"] + CENTRIFUGAL["pin"] + sum(CENTRIFUGAL["web"])) / SPEED**2
"""Mass times radius of all that rotates on a throw. [kg·m]"""
LAW = 3e-4
"""A table of pressures in whole degrees and the law that it is of differ by so much in the loads between them."""
with (GOLDEN / "crankshaft_I4" / "counterweight_sweep.csv").open(encoding="utf-8", newline="") as file:
    SWEEP = tuple(csv.DictReader(file))


@cache
def swept():
    """All fractions of the sweep as designs of one machine, at the sweep's own crank angles."""
    fractions = sorted({float(row["fraction_balanced"]) for row in SWEEP if float(row["fraction_balanced"]) > 0})
    machines = []
    for fraction in fractions:
        machine = in_line_four()
        webs = machine.declared["balance"]["weight"]
        mass, radius = f"{fraction * FULL / RADIUS!r} kg", f"{RADIUS!r} m"
        own = [{"mass": mass, "radius": radius, "throw": throw} for throw in range(1, 5)]
        machines.append(machine.with_({"balance.weight": [*webs, *own]}))
    quantities = ("main_bearing_load_x", "main_bearing_load_y")
    return fractions, ct.run(machines, quantities=quantities, step_degrees=4)


@pytest.mark.parametrize(
    "row",
    [row for row in SWEEP if float(row["fraction_balanced"]) > 0],
    ids=lambda row: f"{row['method']}-{row['fraction_balanced']}",
)
def test_sweep(row):
    fractions, result = swept()
    at = fractions.index(float(row["fraction_balanced"])), result.labels["bearing_method"].index(row["method"])
    sizes = np.hypot(result.main_bearing_load_x[at], result.main_bearing_load_y[at])
    for bearing, own in enumerate(sizes, start=1):
        assert np.max(own) / 1e3 == pytest.approx(float(row[f"max_Q{bearing}_kN"]), abs=1e-4)
        assert np.mean(own) / 1e3 == pytest.approx(float(row[f"mean_Q{bearing}_kN"]), abs=2e-4)


@cache
def case_loads(method):
    """Loads of all bearings by the case's own forces at every quarter of a degree, and what full weights change."""
    degrees = np.arange(0, 720, 0.25)
    kernel = next(one for one in BEARING_METHODS if one.name == method)
    bare, full = (kernel.loads(crankshaft(), shaft_loads(degrees, balanced)).load[0] for balanced in (0.0, 1.0))
    return bare, full - bare


def case_size(method, bearings, aim, fraction):
    bare, change = case_loads(method)
    sizes = np.hypot(*np.moveaxis(bare + fraction * change, 1, 0))[bearings]
    return np.max(sizes) if aim == "largest" else np.mean(sizes)


ASKED = [
    (method, ("largest", "mean")[(n + m) % 2], bearing)
    for n, method in enumerate(("frame_elastic", "split", "three_moment"))
    for m, bearing in enumerate(("1", "3", "all"))
]
"""Every method with every choice of bearings, and each of these with both aims."""


@pytest.mark.parametrize(("method", "aim", "bearing"), ASKED)
def test_one_weight_for_all_throws_as_a_search_finds_it(method, aim, bearing):
    bearings = list(range(5)) if bearing == "all" else [int(bearing) - 1]
    found = counterweights(in_line_four(), bearing, aim, method=method, weights="alike")
    other = minimize_scalar(
        lambda fraction: case_size(method, bearings, aim, fraction), bounds=(0, 2), options={"xatol": 1e-9}
    )
    reached = found.value("load" if aim == "largest" else "mean_load")
    assert reached == pytest.approx(other.fun, rel=LAW)
    assert case_size(method, bearings, aim, found.value("share(1)")) == pytest.approx(other.fun, rel=LAW)


@pytest.mark.parametrize(("bearing", "near"), [("1", 1.0), ("3", 1.25), ("5", 1.0)])
def test_optimum_lies_where_the_sweep_has_it(bearing, near):
    """By the elastic frame: about 1.25 for the middle bearing and 1.0 for the outer ones, in steps of 0.25."""
    found = counterweights(in_line_four(), bearing, weights="alike")
    swept_loads = {
        float(row["fraction_balanced"]): 1e3 * float(row[f"max_Q{bearing}_kN"])
        for row in SWEEP
        if row["method"] == "frame_elastic"
    }
    assert min(swept_loads, key=swept_loads.get) == near
    assert abs(found.value("share") - near) < 0.25
    # The sweep's 4° miss a little of the peaks.
    assert found.value("load") <= min(swept_loads.values()) * 1.001
    assert found.value(f"largest_before({bearing})") == pytest.approx(swept_loads[0.0], rel=1e-3)
