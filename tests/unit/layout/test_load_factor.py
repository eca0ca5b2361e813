"""A factor of a load's list or file: the same as sizes that are so many times as large, written out."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

import cranktrain as ct

YOKE = {"kind": "scotch_yoke", "crank_radius": "50 mm"}
CARD = "travel [mm],force [kN],back [kN]\n0,0,0\n60,2,1\n100,8,0\n"
SHAFT = "crank angle [deg],torque [N·m]\n0,10\n120,40\n360,10\n"


def machine(load, **mechanism):
    return ct.Machine(mechanism=YOKE | mechanism, shaft={"main": {"speed": "60 rpm"}}, load={"cut": load})


def listed(factor=1.0, **more):
    out, back = [[f"{factor * size!r} kN" for size in sizes] for sizes in ((0.0, 2.0, 8.0), (0.0, 1.0, 0.0))]
    return {"on": "piston", "travel": ["0 mm", "60 mm", "100 mm"], "force": out, "force_back": back, **more}


def on_shaft(factor=1.0, **more):
    sizes = [f"{factor * size!r} N*m" for size in (10.0, 40.0, 10.0)]
    return {"on": "main", "crank_angles": ["0 deg", "120 deg", "360 deg"], "torque": sizes, **more}


FORMS = {
    "travel": (listed(factor=1.5), listed(), listed(file="cut.csv", text=CARD)),
    "angles": (on_shaft(1.5), on_shaft(), {"on": "main", "file": "fan.csv", "text": SHAFT}),
}
WAYS = ("travel", "force", "force_back")


@pytest.mark.parametrize(("times", "once", "held"), FORMS.values(), ids=FORMS)
def test_a_list_and_a_file_have_one_factor(times, once, held):
    held = {key: one for key, one in held.items() if "file" not in held or key not in WAYS}
    results = [ct.run(machine(load)) for load in (times, once | {"factor": 1.5}, held | {"factor": 1.5})]
    for name in ("load_power", "load_torque_on_crank") if "travel" in times else ("driving_torque",):
        first, *others = (np.asarray(getattr(result, name)) for result in results)
        for other in others:
            assert_allclose(other, first, rtol=1e-13, atol=1e-12 * np.max(np.abs(first)))


def test_the_work_is_that_of_the_area():
    """Polygons of out and back: (60·2/2 + 40·5 + 60·1/2 + 40·0.5) J times the factor, against the motion."""
    found = ct.run(machine(listed(factor=1.0) | {"factor": 1.25}))
    assert_allclose(found.load_work, -1.25 * (60 + 200 + 30 + 20), rtol=1e-12)


def test_designs_have_factors_of_their_own():
    many = ct.run([machine(listed() | {"factor": factor}) for factor in (0, 0.5, 2)])
    assert_allclose(np.ravel(many.load_work), np.array([0, -155, -620]), rtol=1e-12, atol=1e-12)


REFUSED = {
    "one size": ({"on": "piston", "force": "5 kN", "factor": 2}, "factor", "write the one size as it is"),
    "by the speed": (
        {"on": "piston", "force": "5 kN", "at_speed": "1 m/s", "factor": 2},
        "factor",
        "is for a list of sizes or a file",
    ),
    "balanced": (on_shaft(scale="balanced") | {"factor": 2}, "factor", "by which the factor is found"),
    "balanced file": (
        {"on": "main", "file": "f.csv", "text": SHAFT, "scale": "balanced", "factor": 2},
        "factor",
        "by which the factor is found",
    ),
    "less than 0": (listed(factor=1.0) | {"factor": -1}, "factor", "at least 0"),
    "a force": (listed() | {"factor": "2 kN"}, "factor", ""),
    "a word": (listed() | {"factor": "double"}, "factor", ""),
    "a list": (listed() | {"factor": [1, 2, 3]}, "factor", ""),
    "misspelt": (listed() | {"faktor": 2}, "faktor", "did you mean factor"),
}


@pytest.mark.parametrize(("load", "key", "said"), REFUSED.values(), ids=REFUSED)
def test_what_cannot_be_is_refused(load, key, said):
    with pytest.raises(ct.InputError) as caught:
        ct.run(machine(load))
    found = {problem.path: str(problem) for problem in caught.value.problems}
    assert said in found[f"load.cut.{key}"], found
