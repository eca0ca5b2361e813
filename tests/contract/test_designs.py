"""Several designs at once give what each gives alone, for every kind of mechanism and for an engine of several."""

import re
import sys
import tomllib

import numpy as np
import pytest
from tests.machines import V12

import cranktrain as ct
from cranktrain.mechanisms import KINDS

TURNED_BY_ITS_VALUE = re.compile(r"_at$|closing_angle")
"""Angles of extremes without a slope are as exact as the root of rounding allows."""

WALKED = {"closing_margin": 1e-9, "closing_angle": 1e-3}
"""How far closing margins may differ whose poses are followed step by step, all designs together; their angle [deg]."""


def varied(data, k, place=0):
    """The same machine with every number a little different: k per mille for the first, more for each further one."""
    if isinstance(data, dict):
        return {key: varied(value, k, place + i) for i, (key, value) in enumerate(data.items())}
    if isinstance(data, list):
        return [varied(value, k, place + i) for i, value in enumerate(data)]
    if isinstance(data, float):
        return data * (1 + 1e-3 * k)
    if isinstance(data, str) and (found := re.fullmatch(r"(-?[\d.]+) (mm|rpm)", data)):
        return f"{float(found[1]) * (1 + 1e-3 * k * (1 + place % 7))!r} {found[2]}"
    return data


def machine_of(kind):
    """The kind's own example, made to work at a speed and with points."""
    data = tomllib.loads(kind.example)
    data["shaft"] = {"main": {"speed": "700 rpm"}}
    table = data["mechanism"] if "mechanism" in data else next(reversed(data["bank"].values()))["mechanism"]
    if links := next(place.kind.links for place in ct.Machine(**data).places if place.kind.name == kind.name):
        table["points"] = {"p": {"link": links[0], "along": "30 mm", "across": "11 mm"}}
    if kind.output.has_chambers:
        data["cylinder"] = {"bore": "90 mm", "compression_ratio": 12.0}
    elif "load_radius" in kind.spec.model_fields:
        table["load_radius"] = "300 mm"
    return data


MACHINES = {kind.name: machine_of(kind) for kind in KINDS} | {"V12": V12}


@pytest.fixture(scope="module", params=MACHINES)
def runs(request):
    machines = [ct.Machine(**varied(MACHINES[request.param], k)) for k in range(3)]
    return ct.run(machines), [ct.run(machine) for machine in machines]


def is_walked(result):
    return any(place.kind.openings is not None for place in result.machines[0].places)


def said(result, design):
    """What a result says; where the closing margin is not told to rounding, without it."""
    lines = result.summary(design).splitlines()
    return [line for line in lines if not (is_walked(result) and line.startswith("Closing margin"))]


def test_designs_differ(runs):
    several, _alone = runs
    for name in ("closing_margin", "stroke", "swing"):
        if name in several.catalogue:
            values = getattr(several, name)
            assert np.all(np.isnan(values) | (np.ptp(values, axis=0) > 0))


def test_each_design_is_as_if_alone(runs):
    several, alone = runs
    for design, result in enumerate(alone):
        assert list(several.catalogue) == list(result.catalogue)
        assert several.missing == result.missing
        for name, entry in several.catalogue.items():
            together, single = getattr(several, name)[design], getattr(result, name)
            assert together.shape == single.shape, name
            # Newton and bracketing stop for all rows at once: a few units in the last place.
            scale = np.nanmax(np.abs(single)) if np.any(np.isfinite(single)) else 1.0
            allowed = (
                1e-7 if TURNED_BY_ITS_VALUE.search(name) else 4e-15 * scale + (1e-12 if entry.unit == "deg" else 0)
            )
            if is_walked(result):
                allowed = WALKED.get(name, allowed)
            np.testing.assert_allclose(together, single, rtol=0, atol=allowed, err_msg=name)


def test_sentences_and_checks_of_each_design(runs):
    several, alone = runs
    for design, result in enumerate(alone):
        assert said(several, design) == said(result, 0)
        assert [check.verdict(design) for check in several.checks] == [check.verdict() for check in result.checks]


def test_every_check_holds(runs):
    several, _alone = runs
    assert several.checks
    for check in several.checks:
        assert check.residual.shape == (3,)
        assert np.all(check.passed), (check.name, check.residual)


def calls_of(machines):
    """How many functions a run calls."""
    n_calls = 0

    def count(_frame, event, _argument):
        nonlocal n_calls
        n_calls += event in ("call", "c_call")

    sys.setprofile(count)
    try:
        ct.run(machines, step_degrees=10.0).find_all()
    finally:
        sys.setprofile(None)
    return n_calls


def test_no_step_is_quadratic_in_designs():
    """Twice as many more designs take twice as many more calls: a clock would say so too, on a quiet machine."""
    gas = {"kind": "otto", "start_pressure": "93 kPa", "compression_exponent": 1.3, "expansion_exponent": 1.25}
    data = V12 | {"gas": gas | {"pressure_ratio": 3.0}, "masses": {"piston": {"mass": "5 kg"}}}

    def designs(n):
        return [ct.Machine(**varied(data, 0.01 * k)) for k in range(n)]

    ct.run(designs(2), step_degrees=10.0).find_all()
    few, more, many = (calls_of(designs(n)) for n in (5, 10, 20))
    assert many - more == pytest.approx(2 * (more - few), rel=0.01)
