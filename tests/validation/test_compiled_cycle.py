"""The compiled cycle against `run`, which is its judge: random designs of all examples that it knows."""

from collections.abc import Mapping
from functools import cache

import numpy as np
import pytest
from tests import random_designs
from tests.random_designs import EXAMPLES, changed, facts_by_run, facts_of_both, most_apart, numbers_of, parts_apart
from tests.weighed_machines import CLOSED_FORMS, WEIGHED

import cranktrain as ct
from cranktrain.columns import in_columns
from cranktrain.mechanisms import KINDS
from cranktrain.study.cycle.road import CompiledWay, FactsOfCycles, facts_of_cycles, way_to
from cranktrain.study.cycle.structure import CycleStructure

N_DESIGNS = 20


@cache
def designs(name: str) -> list[ct.Machine]:
    return random_designs.designs(name, N_DESIGNS)


def of_shaft(machine: ct.Machine, fact: str) -> bool:
    """Whether one part of a cycle that repeats itself is enough for a fact of the loop."""
    way = way_to(machine, [fact])
    return (
        isinstance(way, CompiledWay)
        and bool(way.asks)
        and CycleStructure((), (), way.asks, has_several=True).may_repeat
    )


@cache
def facts_by_both(name: str) -> tuple[CompiledWay, FactsOfCycles, Mapping[str, np.ndarray]]:
    machines = designs(name)
    wanted = facts_of_both(machines[0])
    exact = facts_by_run(machines, wanted)
    way = way_to(machines[0], wanted)
    assert isinstance(way, CompiledWay)
    return way, facts_of_cycles(in_columns(machines), len(machines), way), exact


@pytest.mark.parametrize("name", EXAMPLES)
def test_facts_are_those_of_run(name):
    way, found, by_run = facts_by_both(name)
    assert {"largest_torque", "largest_crankpin_load", "stroke"} <= way.homes.keys()
    compare(found, by_run)


@pytest.mark.parametrize("name", ["vaz_21213", "3d12", "deltic", "ls3"])
def test_facts_of_the_shaft_are_those_of_run(name):
    """Found of one part of the cycle where that repeats itself; some of the variants do not."""
    machines, by_run = designs(name), facts_by_both(name)[2]
    way = way_to(machines[0], [fact for fact in by_run if of_shaft(machines[0], fact)])
    assert isinstance(way, CompiledWay)
    compare(facts_of_cycles(in_columns(machines), len(machines), way), by_run)


def compare(found: FactsOfCycles, by_run: Mapping[str, np.ndarray]) -> None:
    """Hold facts against those of `run`."""
    assert np.all(found.is_known)
    for fact, values in found.values.items():
        exact, entry = by_run[fact], found.entries[fact]
        np.testing.assert_array_equal(np.isnan(values), np.isnan(exact), err_msg=fact)
        if entry.unit == "deg":
            # tops that are alike stand where rounding has them
            apart = np.abs(np.mod(np.nan_to_num(values - exact) + 180, 360) - 180)
            assert np.median(apart) < 1e-6, fact
            continue
        assert np.max(parts_apart(fact, values, by_run)) <= most_apart(fact), fact


@pytest.mark.parametrize("name", CLOSED_FORMS)
def test_every_closed_form(name):
    """Mechanisms without gas, whatever they are made of."""
    machine = WEIGHED[name].with_({"evenness.flywheel": "5 kg*m^2", "evenness.coefficient": 0.05})
    machines = [machine.with_({"shaft.main.speed": f"{speed} rpm"}) for speed in range(50, 160, 10)]
    wanted = ["largest_torque", "smallest_torque", "largest_joint_force", "coefficient_of_fluctuation"]
    wanted += ["flywheel_inertia"]
    way = way_to(machine, wanted)
    assert isinstance(way, CompiledWay)
    found, exact = facts_of_cycles(in_columns(machines), len(machines), way), ct.run(machines, quantities=wanted)
    assert np.all(found.is_known)
    for fact in wanted:
        by_run = getattr(exact, fact)
        np.testing.assert_allclose(
            found.values[fact], by_run, rtol=0, atol=1e-9 * np.nanmax(np.abs(by_run)), err_msg=fact
        )


@pytest.mark.parametrize(
    ("name", "row", "place", "mean"),
    [
        (
            "vaz_21213",
            {
                "crankshaft.web_width": "77.62119981292722 mm",
                "torsion.disc.flywheel.stiffness": "0.8090882554285745 MN·m/rad",
                "shaft.main.speed": "5346.082376060015 rpm",
                "masses.rod.big_end": "531.3567549116448 g",
                "crankshaft.web_thickness": "19.19271527165504 mm",
                "crankshaft.journal_diameter": "49.72516681517 mm",
            },
            (2, 2),
            9750.825468497635,
        ),
        (
            "kamaz_740",  # whose left cylinders have next to no clearance
            {
                "crankshaft.web_thickness": "26.139739644638276 mm",
                "shaft.main.spacing": "153.11971815056197 mm",
                "gas.cut_off_ratio": 1.4618097867967357,
                "masses.piston.mass": "2.592155019660165 kg",
                "crankshaft.web_width": "128.17679083721583 mm",
                "bank.L.mechanism.rod_length": "232.3425212324325 mm",
            },
            (3, 2),
            246457.6465664846,
        ),
    ],
)
def test_the_mean_of_a_bearing_load_that_nearly_vanishes(name, row, place, mean):
    """The mean by panels of 0.6° and narrower, of which each shows the load's size to 1e-9."""
    machine = ct.load(name).with_(row)
    way = way_to(machine, ["mean_bearing_load"])
    assert isinstance(way, CompiledWay)
    found = facts_of_cycles(in_columns([machine] * 2), 2, way).values["mean_bearing_load"][0]
    by_run = ct.run(machine, quantities="mean_bearing_load").mean_bearing_load
    assert by_run[place] == pytest.approx(mean, rel=1e-11)
    np.testing.assert_allclose(by_run, found, rtol=0, atol=1e-11 * np.max(found))


def test_chains_are_not_compiled():
    ways = {kind.name: way_to(WEIGHED[kind.name], ["largest_torque"]) for kind in KINDS}
    assert {name for name, way in ways.items() if isinstance(way, CompiledWay)} == set(CLOSED_FORMS)


@pytest.mark.parametrize("name", ["vaz_21213", "gas_compressor"])
def test_a_design_is_found_as_it_is_alone(name):
    """Whatever stands beside it: to the last bit."""
    way, found, _result = facts_by_both(name)
    for place in (0, 7, N_DESIGNS - 1):
        alone = facts_of_cycles(in_columns([designs(name)[place]] * 2), 2, way)
        for fact, values in found.values.items():
            np.testing.assert_array_equal(alone.values[fact][1], values[place], err_msg=fact)


@pytest.mark.parametrize(
    ("fact", "path"),
    [("largest_torque", "bank.line.mechanism.rod_length"), ("largest_side_force", "shaft.main.speed")],
)
def test_central_differences_of_facts(fact, path):
    """Of a relative step of 1e-4 against Richardson's of twice and half of it: to 1e-7."""
    machine = ct.load("vaz_21213")
    typed = {".".join(map(str, where)): value for where, value in numbers_of(machine.declared)}[path]
    steps = [-2e-4, -1e-4, -0.5e-4, 0.5e-4, 1e-4, 2e-4]
    machines = [machine.with_({path: changed(typed, 1 + step)}) for step in steps]
    way = way_to(machine, [fact])
    values = facts_of_cycles(in_columns(machines), len(machines), way).values[fact].reshape(len(machines), -1)[:, 0]
    wide, middle, narrow = ((values[5 - i] - values[i]) / (steps[5 - i] - steps[i]) for i in range(3))
    exact = (64 * narrow - 20 * middle + wide) / 45
    assert abs(middle - exact) <= 1e-7 * abs(exact)


@pytest.mark.parametrize(
    ("name", "fact", "words"),
    [
        ("shaper", "largest_torque", "a chain of links"),
        ("mill_engine", "largest_torque", "curve over the cycle"),
        ("burning_cylinder", "largest_torque", "curve over the cycle"),
        ("eccentric_press", "largest_torque", "loads act"),
        ("vaz_21213", "crankpin_wear", "no fact of the compiled cycle"),
        ("vaz_21213", "cycle_time", "of other machines"),
        ("gas_compressor", "peak_pressure_at", "no fact of the compiled cycle"),
    ],
)
def test_it_is_said_what_is_not_compiled(name, fact, words):
    assert words in str(way_to(ct.load(name), [fact]))
