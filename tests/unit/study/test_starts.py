"""Starts of several designs: each to the last bit as it is alone, plain and compiled; what cannot be, at its place."""

import os
import pickle
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.columns import in_columns
from cranktrain.how_far import listened_to
from cranktrain.machine import machine_problems
from cranktrain.questions.start import together
from cranktrain.questions.start.record import ReadyStarts
from cranktrain.study import facts_of_starts as road
from cranktrain.study.start import over_time_of_designs
from cranktrain.study.sweep.machines import wrong_machines

RATIO = "drive.stage[0].ratio"


def designs(name, *values):
    machine = ct.load(name)
    return [machine.with_(one) for one in values]


def held_to_each_alone(found):
    """Every fact of every design, and every event, is that of the design alone."""
    for design, machine in enumerate(found.machines):
        alone = ct.start(machine)
        assert str(found.reasons[design]) == str(alone.run.reason)
        for name, entry in found.catalogue.items():
            values, own = getattr(found, name)[design], getattr(alone, name)
            if entry.dimensions:
                own_labels = [found.labels["event"].index(label) for label in alone.labels["event"]]
                np.testing.assert_array_equal(values[own_labels], own, err_msg=name)
                assert np.isnan(np.delete(values, own_labels)).all()
            else:
                np.testing.assert_array_equal(values, own, err_msg=name)


def test_facts_stand_along_designs_and_curves_come_when_asked():
    """One runs up, one stalls; neither is kept but for its facts."""
    found = ct.start(designs("tilting_table", {RATIO: 40}, {RATIO: 10}))
    assert found.start_duration.shape == (2,)
    assert found.dataset.start_duration.dims == ("design",)
    assert found.event_time.shape == (2, len(found.labels["event"]))
    held_to_each_alone(found)
    np.testing.assert_array_equal(found[1].crank_speed, ct.start(found.machines[1]).crank_speed)
    assert "1 of 2 starts: it stands still" in str(found.page())
    assert len(pickle.dumps(found.found)) < 20_000  # curves of one alone are a hundred times as much


def test_strokes_of_a_press():
    """Whose longest stop is looked for as it is of one alone."""
    values = ({}, {"drive.part.flywheel.inertia": "12 kg·m²"})
    found = ct.start(designs("high_slip_press", *values))
    held_to_each_alone(found)
    assert {"slip_time", "longest_stop_time"} <= set(found.catalogue)


def test_what_cannot_be_is_a_sentence_at_its_place():
    """A crank that cannot turn, and a motor that reaches what nobody can: the others are computed."""
    fit, open_, other = designs("tilting_table", {RATIO: 40}, {RATIO: 40, "mechanism.crank_radius": "5 m"}, {RATIO: 30})
    found = ct.start([fit, open_, other])
    assert list(found.refused) == [1]
    assert found.refused[1].path == "mechanism.rod_length"
    assert np.isnan(found.start_duration[1])
    assert found.reasons[1] == ""
    assert found.start_duration[[0, 2]].tolist() == [ct.start(one).start_duration for one in (fit, other)]
    assert "design 2: mechanism.rod_length" in str(found.page())
    with pytest.raises(ct.InputError, match="rod_length"):
        ct.start([open_, open_])


def test_a_pressure_that_no_valve_leaves_is_refused_alone():
    """What is found only when a design is made ready does not stop the others either."""
    pressures = ({"drive.start.gas_pressure": "3 bar"}, {"drive.start.gas_pressure": "30 bar"})
    found = ct.start(designs("compressor_start", *pressures))
    assert list(found.refused) == [1]
    assert found.refused[1].path == "drive.start.gas_pressure"
    assert found.start_duration[0] == ct.start(found.machines[0]).start_duration


def test_only_numbers_may_differ():
    with pytest.raises(ct.InputError, match="may differ in numbers alone"):
        ct.start(["tilting_table", "jaw_crusher"])
    with pytest.raises(ct.InputError, match="at least one"):
        ct.start([])
    with pytest.raises(ct.InputError, match="one machine alone"):
        ct.start(["tilting_table"], progress=print)
    with pytest.raises(ct.InputError, match="a start needs what drives the crank"):
        ct.start(["eccentric_press", "eccentric_press"])


def test_compiled_they_are_the_same_to_the_last_bit(monkeypatch):
    """Loaded on the way, held and let go by a starter, stalled, plugged; more than there are threads."""
    pytest.importorskip("numba")
    monkeypatch.setattr(road, "_COMPILING", 0.0)
    wheel = "drive.part.flywheel.inertia"
    star = {"drive.motor.starter.kind": "star_delta", "drive.motor.starter.change_time": "1 s"}
    for name, values in (
        ("compressor_start", [{wheel: f"{inertia} kg*m^2"} for inertia in (0.08, 0.05, 0.06, 0.1, 0.2)]),
        ("compressor_start", [{"drive.start.unloaded_until": f"{until} s"} for until in (0.5, 0.1, 0.3)]),
        ("compressor_start", [{"drive.start.motor_reversed": f"{at} s"} for at in (1.0, 0.9, 0.2)]),
        ("tilting_table", [{RATIO: ratio} for ratio in (30, 10, 40)]),
        ("compressor_start", [{wheel: f"{inertia} kg*m^2", **star} for inertia in (0.08, 0.05, 0.3)]),
    ):
        held_to_each_alone(ct.start(designs(name, *values)))
    assert road._compiled


def test_compiled_there_is_room_for_what_takes_more(monkeypatch):
    """Room grows with steps and samples; what takes far too much goes alone, and is refused as it is alone."""
    pytest.importorskip("numba")
    monkeypatch.setattr(road, "_COMPILING", 0.0)
    monkeypatch.setattr(together, "_N_STEPS", 100)
    monkeypatch.setattr(together, "_N_SAMPLES", 1500)
    monkeypatch.setattr(together, "_left_rooms", [])
    intervals = ("0.01 s", "0.001 s", "1e-7 s", "0.02 s")
    found = ct.start(designs("compressor_start", *({"drive.start.interval": each} for each in intervals)))
    assert list(found.refused) == [2]
    assert found.refused[2].path == "drive.start.interval"
    for place in (0, 1, 3):
        alone = ct.start(found.machines[place])
        for name in road.FACTS_SHOWN:
            assert getattr(found, name)[place] == getattr(alone, name)


def in_one_loop(machines):
    """Whether they are one group of what is run together."""
    ready = over_time_of_designs(machines, [ReadyStarts])[ReadyStarts]
    return ready.in_short.groups(range(len(machines))) == [[*range(len(machines))]]


def test_motors_of_other_sizes_run_in_one_loop(monkeypatch):
    """With bores that are mixed with them; more than are run at once."""
    pytest.importorskip("numba")
    monkeypatch.setattr(road, "_COMPILING", 0.0)
    sizes, bores = ("1.5 kW", "2.2 kW", "3 kW", "2.2 kW"), ("3.125 in", "3.125 in", "3 in", "3.125 in")
    each = [{"drive.motor.size": size, "cylinder.bore": bore} for size, bore in zip(sizes, bores, strict=True)]
    values = [
        one | {"drive.part.flywheel.inertia": f"{wheel} kg*m^2"}
        for wheel in (0.05, 0.06, 0.07, 0.08, 0.09)
        for one in each
    ]
    machines = designs("compressor_start", *values)
    assert in_one_loop(machines)
    held_to_each_alone(ct.start(machines))


def test_motors_of_other_points_run_in_one_loop(monkeypatch):
    pytest.importorskip("numba")
    monkeypatch.setattr(road, "_COMPILING", 0.0)
    motor = {"kind": "table", "speeds": ["0 rpm", "1200 rpm", "1500 rpm"], "inertia": "0.02 kg*m^2"}
    torques = (["40 N*m", "60 N*m", "0 N*m"], ["50 N*m", "70 N*m", "0 N*m"], ["60 N*m", "50 N*m", "0 N*m"])
    machines = designs("compressor_start", *({"drive.motor": {**motor, "torques": own}} for own in torques))
    assert in_one_loop(machines)
    held_to_each_alone(ct.start(machines))


def test_machines_that_differ_run_in_one_loop(monkeypatch):
    """Of other cylinders, with corners at other angles, with and without their valves held open at first."""
    pytest.importorskip("numba")
    monkeypatch.setattr(road, "_COMPILING", 0.0)
    sizes = ((3.5, "3.125 in", 0.1), (3.5, "3 in", 0.0), (5.0, "3.125 in", 0.0), (4.0, "3 in", 0.3))
    values = [
        {"mechanism.rod_to_crank_ratio": rod, "cylinder.bore": bore, "drive.start.unloaded_until": f"{until} s"}
        for rod, bore, until in sizes
    ]
    machines = designs("compressor_start", *values)
    assert in_one_loop(machines)
    held_to_each_alone(ct.start(machines))


def test_what_one_block_gave_is_given_to_the_next_where_it_is_the_same(monkeypatch):
    """Blocks of two: of the same machine, of another wheel, of another bore, and of one that is refused."""
    monkeypatch.setattr(road, "MOST_AT_ONCE", 2)
    wheels, bores = (0.05, 0.08, 0.08, 0.05, 0.05, 0.08, 0.08), (3.0, 3.0, 3.0, 3.1, 3.0, 3.0, 3.0)
    values = [
        {"drive.part.flywheel.inertia": f"{wheel} kg*m^2", "cylinder.bore": f"{bore} in"}
        for wheel, bore in zip(wheels, bores, strict=True)
    ]
    values[5]["drive.start.gas_pressure"] = "20 bar"
    for one in values:
        one.setdefault("drive.start.gas_pressure", "14.7 psi")
    found = ct.start(designs("compressor_start", *values))
    assert list(found.refused) == [5]
    for place in (0, 3, 4, 6):
        alone = ct.start(found.machines[place])
        for name in road.FACTS_SHOWN:
            assert getattr(found, name)[place] == getattr(alone, name)


@pytest.mark.parametrize("wanted", [["start_duration", "energy_left_over"], ["effective_motor_torque", "event_time"]])
def test_a_sweep_has_the_facts_that_are_wanted_as_each_start_alone(wanted):
    """From columns of designs that are never made one by one, with and without the machine's inertia along the way."""
    ratios = np.linspace(28.0, 42.0, 30)
    found = ct.sweep("tilting_table", {RATIO: ratios.tolist()}, wanted, over_time=True)
    assert set(found.found.values) == set(wanted)
    for place in (0, 17, 29):
        alone = ct.start(ct.load("tilting_table").with_({RATIO: float(ratios[place])}))
        for name in wanted:
            values, own = found.found.values[name][place], getattr(alone, name)
            if name == "event_time":
                values = values[[found.found.labels["event"].index(label) for label in alone.labels["event"]]]
            np.testing.assert_array_equal(values, own)


IN_ANOTHER = """
from numba.core import event
from cranktrain.study import facts_of_starts as road
from cranktrain.study.facts_of_starts import facts_of_starts
from tests.unit.study.test_starts import RATIO, designs

road._LOADING = 0.0
with event.install_recorder("numba:compile") as compilations:
    found = facts_of_starts(designs("tilting_table", *({RATIO: ratio} for ratio in (30, 10, 40))))
print(found.values["effective_motor_torque"].tobytes().hex(), len(compilations.buffer), len(road._compiled))
"""


def test_another_process_compiles_nothing(monkeypatch):
    """What this one compiled is kept: facts are the same to the last bit."""
    pytest.importorskip("numba")
    monkeypatch.setattr(road, "_COMPILING", 0.0)
    found = ct.start(designs("tilting_table", *({RATIO: ratio} for ratio in (30, 10, 40))))
    environment = {**os.environ, "PYTHONPATH": str(Path(__file__).parents[3])}
    ended = subprocess.run(
        [sys.executable, "-c", IN_ANOTHER], env=environment, check=True, capture_output=True, text=True
    )
    assert ended.stdout.split() == [found.effective_motor_torque.tobytes().hex(), "0", "1"]


def test_without_numba_they_are_plain_and_that_is_said(monkeypatch):
    """However many there are."""
    monkeypatch.setattr(road, "is_there", lambda _name: False)
    monkeypatch.setattr(road, "_COMPILING", 0.0)
    monkeypatch.setattr(road, "_compiled", set())
    said = []
    with listened_to(lambda words: said.append(str(words[-1]()))):
        found = ct.start(designs("tilting_table", {RATIO: 40}, {RATIO: 30}))
    assert said[0] == "0 of 2 starts, without Numba one by one"
    assert road._compiled == set()
    assert found.start_duration[1] == ct.start(found.machines[1]).start_duration


def test_many_machines_are_judged_as_each_alone():
    """Some of whose links cannot close, each at its place, as it says itself."""
    radii = np.linspace(200.0, 1200.0, 40)
    machine = ct.load("tilting_table")
    each = [machine.with_({"mechanism.crank_radius": f"{radius!r} mm", RATIO: 40}) for radius in radii.tolist()]
    found = wrong_machines(each, in_columns(each))
    own = {place: problems[0] for place, one in enumerate(each) if (problems := machine_problems(one))}
    assert 0 < len(own) < len(each)
    assert {place: str(problem) for place, problem in found.items()} == {n: str(one) for n, one in own.items()}
