"""What is computed when it is read: the same whatever is read first, by whom, and wherever the result has been."""

import copy
import gc
import pickle
import platform
import threading
import weakref

import numpy as np
import pytest
from tests.told import texts_of

import cranktrain as ct
from cranktrain.analysis import run, stages_for
from cranktrain.analysis.grids import FACTS_STEP
from cranktrain.analysis.outcomes import StageRun, run_stages
from cranktrain.analysis.parts import parts_of
from cranktrain.analysis.stages import lacking, leading_to
from cranktrain.io.examples import example_names
from cranktrain.layout.question import Stage
from cranktrain.quantities import shown_by, units_by_dimension
from cranktrain.questions.forces.peaks import ForcePeaks
from cranktrain.saying.catalogue import entries, values
from cranktrain.saying.checks import Checked, Flagged

every_example = pytest.mark.parametrize("name", example_names())


def ran(result):
    """Outcomes that were computed."""
    return set(result.computed._shown)


def test_nothing_is_computed_before_it_is_read():
    result = ct.run("3d12")
    at_once = {stage.gives for stage in stages_for(result.machines[0]) if stage.refuses}
    assert ran(result) == at_once, "but for what may refuse the machine"
    assert "largest_bearing_load" in result.catalogue
    assert result.missing
    assert ran(result) == at_once
    assert result.stroke.shape == (12,)
    assert {kind.__name__ for kind in ran(result) - at_once} == {"DeadCentres"}


@pytest.mark.parametrize("name", ["3d12", "tilting_table", "textbook_78x78", "gas_compressor", "pumping_unit_c57"])
def test_what_is_read_last_is_the_same_as_what_is_read_first(name):
    one, other = ct.run(name), ct.run(name)
    one.find_all()
    for kind in reversed(other.computed.kinds):
        for entry in entries(kind):
            first, last = values(one.computed[kind], entry), values(other.computed[kind], entry)
            np.testing.assert_array_equal(first, last, err_msg=entry.name)
    assert dict(one.labels) == dict(other.labels)
    assert texts_of(one.flags) == texts_of(other.flags)


@every_example
def test_a_result_has_the_names_of_its_members_with_it(name):
    """Whatever else was computed: of its own, of the parts, or of what it rests on."""
    machine = ct.load(name)
    stages = stages_for(machine)
    parts = parts_of((machine,), step=FACTS_STEP)
    found = run_stages(stages, parts, lacking(stages, parts))
    of_parts = {dimension for part in parts.values() for dimension in getattr(part, "labels", {})}
    for kind in found:
        rests_on = [one.gives for one in leading_to(stages, [kind]) if one.gives in found]
        named = {dimension for one in rests_on for dimension in getattr(found[one], "labels", {})}
        for entry in entries(kind):
            assert set(entry.dimensions) <= {*of_parts, *named, "crank_angle"}, (kind.__name__, entry.name)


def test_the_answer_computes_what_it_says_and_all_that_checks_or_warns():
    result = ct.run("3d12")
    result.find_answer()
    answered = ran(result)
    assert {one.__name__ for one in result.computed.kinds} - {one.__name__ for one in answered} >= {"JournalWear"}
    assert {kind for kind in result.computed.kinds if issubclass(kind, Checked | Flagged)} <= answered
    assert list(result.rows())
    assert texts_of(result.flags) == texts_of(ct.run("3d12").flags)
    assert ran(result) == answered, "rows and flags needed nothing more"


def test_what_a_result_holds_by_name_cannot_be_written_to_either():
    """Largest forces stand in a mapping, by what they are of."""
    peaks = ct.run("3d12").computed[ForcePeaks].by_class.values()
    assert peaks
    assert not any(part.flags.writeable for peak in peaks for part in peak)


def test_threads_read_one_result():
    result, whole = ct.run("3d12"), ct.run("3d12")
    found, names = {}, ["largest_bearing_load", "journal_wear", "largest_torque", "stroke", "flywheel_inertia"]

    def read(name):
        found[name] = getattr(result, name)

    threads = [threading.Thread(target=read, args=(name,)) for name in names * 3]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for name in names:
        np.testing.assert_array_equal(found[name], getattr(whole, name), err_msg=name)


def test_an_error_in_a_stage_is_told_each_time_it_is_read():
    (first, *_others) = stages_for(ct.load("textbook_78x78"))

    def failing() -> first.gives:
        raise AttributeError("no such thing")

    result = run(ct.load("textbook_78x78"), stages=[Stage(failing)])
    for _again in range(2):
        with pytest.raises(RuntimeError, match=f"{first.outcome} could not be computed: no such thing"):
            result.computed.find([first.gives])


def test_units_are_those_of_whoever_reads():
    """A sentence that holds a number is said when it is read: whatever the units were when it was computed."""
    at_once = ct.run("3d12")
    at_once.find_all()
    later = ct.run("3d12")
    with shown_by(units_by_dimension(["lbf", "in", "psi"], "units")):
        later.find_all()
        assert texts_of(later.flags) == texts_of(at_once.flags)
        assert later.summary() == at_once.summary()
        assert "psi" in later.summary()
    assert texts_of(later.flags) == texts_of(at_once.flags)
    assert later.summary() == at_once.summary()
    assert "psi" not in later.summary()


@every_example
def test_a_result_and_its_machine_can_be_sent_and_copied(name):
    result = ct.run(name, step_degrees=10)
    machine = pickle.loads(pickle.dumps(result.machines[0]))
    assert machine == result.machines[0]
    unread, copied = pickle.loads(pickle.dumps(result)), copy.deepcopy(result)
    result.find_all()
    read = pickle.loads(pickle.dumps(result))
    again = ct.run(machine, step_degrees=10)
    for quantity in result.catalogue:
        for one in (unread, copied, read, again):
            np.testing.assert_array_equal(getattr(one, quantity), getattr(result, quantity), err_msg=quantity)
    assert texts_of(unread.flags) == texts_of(read.flags) == texts_of(result.flags)
    assert texts_of(one.verdict() for one in unread.checks) == texts_of(one.verdict() for one in result.checks)


def test_a_result_outlives_its_machine():
    machine = ct.load("textbook_78x78")
    result = ct.run(machine)
    del machine
    assert result.stroke[0] == pytest.approx(0.078, rel=1e-12)


def test_a_result_goes_with_who_holds_it():
    """Without a garbage collector, whatever was read of it: a page that follows a slider makes one after the other."""
    result = ct.run("burning_cylinder")
    result.find_all()
    assert dict(result.labels)
    gone = weakref.ref(result.computed)
    gc.disable()
    try:
        del result
        assert gone() is None
    finally:
        gc.enable()


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="what is given back is a matter of the C library")
def test_memory_of_a_run_is_there_for_the_next():
    """A run of this machine takes some thousand pages of 4 kB."""
    import resource  # which not every system has

    def run_once():
        ct.run(machine, quantities="piston_force").find_all()

    machine = ct.load("3d12")
    for _warming in range(5):
        run_once()
    before = resource.getrusage(resource.RUSAGE_SELF).ru_minflt
    for _time in range(20):
        run_once()
    assert (resource.getrusage(resource.RUSAGE_SELF).ru_minflt - before) / 20 < 250


def test_a_machine_is_laid_out_once():
    machine = ct.load("burning_cylinder")
    sent = len(pickle.dumps(machine))
    parts = parts_of((machine,), step=FACTS_STEP)
    assert parts_of((machine,), step=FACTS_STEP) is parts
    assert parts_of((machine,), step=2 * FACTS_STEP) is not parts
    assert parts_of((machine.with_({"mechanism.rod_length": "131 mm"}),), step=FACTS_STEP) is not parts
    assert parts_of((copy.copy(machine),), step=FACTS_STEP) is not parts
    assert len(pickle.dumps(machine)) == sent


def test_what_cannot_be_had_is_never_run():
    run_of = StageRun([], {})
    run_of.find([Stage])
    with pytest.raises(KeyError):
        _ = run_of[Stage]


def test_a_result_at_a_speed_of_its_own_can_be_sent():
    result = ct.run("vaz_21213", speed="running", step_degrees=10)
    sent = pickle.loads(pickle.dumps(result))
    np.testing.assert_array_equal(sent.shaft_torque, result.shaft_torque)


def test_flags_and_names_do_not_hang_on_what_was_read_first():
    one, other = (ct.run("deltic", step_degrees=10) for _n in range(2))
    _ = other.crank_acceleration, other.largest_bearing_load
    assert texts_of(one.flags) == texts_of(other.flags)
    assert list(one.labels) == list(other.labels)
    assert repr(one.labels) == repr(dict(one.labels))


def test_a_result_is_sent_while_it_is_read():
    result = ct.run("3d12")
    reading = threading.Thread(target=result.find_all)
    reading.start()
    while reading.is_alive():
        pickle.dumps(result)
    reading.join()
