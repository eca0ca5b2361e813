"""A changed number leaves what does not hang on it as it was; all else is found as of the machine by itself."""

import copy
import pickle
from concurrent.futures import ThreadPoolExecutor
from operator import attrgetter

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.analysis.kept_outcomes import KeptOutcomes
from cranktrain.io.examples import example_names
from cranktrain.io.machine_file import inputs_of, read_machine
from cranktrain.layout.question import Stage
from cranktrain.layout.speed import Speed
from cranktrain.questions.cylinders.firing import Cycle
from cranktrain.questions.forces.joint_forces import JointForces
from cranktrain.questions.gas.pressures import GasPressures
from cranktrain.questions.motion.closing import Closing
from cranktrain.questions.motion.dead_centres import PistonTurn
from cranktrain.questions.motion.grid_motion import GridMotion
from cranktrain.saying.catalogue import entries

SPEED, ROD, MASS = "shaft.main.speed", "bank.L.mechanism.rod_length", "masses.piston.mass"


def by_itself(machine):
    """The same machine, which comes from no other."""
    return pickle.loads(pickle.dumps(machine))


def numbers(result):
    """All that a result gives, to the last bit."""
    return {
        (kind.__name__, entry.path): np.asarray(attrgetter(entry.path)(result.computed[kind])).tobytes()
        for kind in result.computed.kinds
        for entry in entries(kind)
    }


@pytest.mark.parametrize("name", example_names())
def test_a_changed_number_gives_what_the_machine_gives_by_itself(name):
    file = read_machine(name)
    inputs = [one for one in inputs_of(file) if one.given.si != 0.0]
    ct.run(file.machine.with_({})).find_all()
    for one in inputs[:: 1 + len(inputs) // 2]:
        value, _, unit = one.given.text.partition(" ")
        try:
            changed = file.machine.with_({one.path: f"{float(value) * 1.001:.9g} {unit}".strip()})
            expected = numbers(ct.run(by_itself(changed)))
        except (ct.InputError, ValueError):  # what has to be whole, or to fit others
            continue
        assert numbers(ct.run(changed)) == expected, one.path


@pytest.mark.parametrize(
    ("path", "value", "kept", "found_anew"),
    [
        (SPEED, "1600 rpm", {Closing, PistonTurn, GasPressures, GridMotion}, {JointForces}),
        (MASS, "5.1 kg", {Closing, GasPressures, GridMotion}, set()),
        ("cylinder.bore", "151 mm", {Closing, GridMotion}, {GasPressures}),
        (ROD, "321 mm", set(), {Closing, GasPressures, GridMotion}),
    ],
)
def test_what_does_not_hang_on_a_number_is_the_same(path, value, kept, found_anew):
    machine = ct.load("3d12")
    before, after = (ct.run(one).computed for one in (machine.with_({}), machine.with_({path: value})))
    for kind in kept | found_anew:
        assert (after[kind] is before[kind]) == (kind in kept), kind


def test_of_a_machine_that_was_never_changed_nothing_is_kept():
    machine = ct.load("burning_cylinder")
    first, second = ct.run(machine), ct.run(machine)
    assert first.computed[Closing] is not second.computed[Closing]
    assert "alike" not in vars(machine)


def test_nothing_that_is_kept_is_sent_or_copied():
    machine = ct.load("burning_cylinder").with_({SPEED: "1510 rpm"})
    ct.run(machine).find_all()
    size = len(pickle.dumps(machine.alike))
    assert size < 200
    for other in (by_itself(machine), copy.copy(machine)):
        assert "alike" not in vars(other)
    assert vars(copy.deepcopy(machine).alike[KeptOutcomes]) == vars(KeptOutcomes())


def test_parts_are_told_apart_by_all_that_is_in_them():
    kept, part = KeptOutcomes(), (1.0, np.array([2.0]), {"a": "b"})
    assert kept.part(part) is part
    assert kept.part((1.0, np.array([2.0]), {"a": "b"})) is part
    for other in ((1.0, np.array([2.5]), {"a": "b"}), (1.0, np.array([2.0]), {"a": "c"}), (lambda: 3,)):
        assert kept.part(other) is other


def test_threads_may_ask_machines_that_come_from_one_another():
    machine = ct.load("burning_cylinder")
    changed = [machine.with_({SPEED: f"{speed} rpm"}) for speed in range(1400, 1412)]
    expected = [numbers(ct.run(by_itself(one))) for one in changed]
    with ThreadPoolExecutor(4) as threads:
        assert list(threads.map(lambda one: numbers(ct.run(one)), changed)) == expected


def test_another_stage_that_gives_the_same_sort_is_asked():
    kept, one, another = KeptOutcomes(), Stage(cycle_of_one), Stage(cycle_of_another)
    speed = Speed(np.ones((1, 1, 1)))
    first = kept.outcome(one, {"speed": speed})
    assert kept.outcome(one, {"speed": speed}) is first
    assert kept.outcome(another, {"speed": speed}).length == 2.0
    assert kept.outcome(one, {"speed": speed}).length == 1.0


def cycle_of_one(speed: Speed | None) -> Cycle:
    return Cycle(1.0, fires=True)


def cycle_of_another(speed: Speed | None) -> Cycle:
    return Cycle(2.0, fires=True)


@pytest.mark.parametrize("name", ["3d12", "burning_cylinder", "gas_compressor"])
def test_whatever_way_numbers_go_each_machine_gives_its_own(name):
    file, rng = read_machine(name), np.random.default_rng(7)
    inputs = [one for one in inputs_of(file) if one.path.endswith(("speed", "rod_length", "bore", "mass"))]
    machine, seen = file.machine, []
    for _change in range(14):
        one = inputs[rng.integers(len(inputs))]
        for _again in range(rng.integers(1, 4)):  # as a slider is moved: what is let go of is found anew
            value, _, unit = one.given.text.partition(" ")
            machine = machine.with_({one.path: f"{float(value) * rng.uniform(0.98, 1.02):.6g} {unit}"})
            seen.append(ct.run(machine))
    for result in seen[::3]:
        assert numbers(result) == numbers(ct.run(by_itself(result.machines[0])))
