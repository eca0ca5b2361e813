"""Who computes blocks: facts come in order whoever does, and a process that is killed is replaced."""

import os
import random
import signal
import threading
import time
from functools import partial
from multiprocessing import active_children

import pytest
from tests.swept import MACHINE, ROOT, WANTED, deadly, same

import cranktrain as ct
from cranktrain.study.sweep import computed, swept
from cranktrain.study.sweep.blocks import blocks_of
from cranktrain.study.sweep.crew import Alone, in_order
from cranktrain.study.sweep.processes import Processes
from cranktrain.study.sweep.varied import combined_designs, listed_designs


@pytest.fixture(autouse=True)
def others_find_tests(monkeypatch):
    """Processes find what stands here."""
    monkeypatch.syspath_prepend(str(ROOT))


@pytest.mark.parametrize("shape", [(7,), (5, 13), (3, 1, 40), (2, 3, 4, 5)])
@pytest.mark.parametrize("most", [1, 4, 17, 1000])
def test_blocks_are_boxes_one_behind_the_other(shape, most):
    import numpy as np

    places = np.arange(np.prod(shape)).reshape(shape)
    blocks, after = blocks_of(shape, most), 0
    for number in range(len(blocks)):
        first, before = after, blocks.span(number)
        after = before[1]
        assert before[0] == first
        assert after - first <= most
        np.testing.assert_array_equal(places[blocks.box(number)].ravel(), np.arange(first, after))
    assert after == places.size


def test_one_design_by_its_place():
    several = combined_designs(MACHINE, {"rod_length": "130..150 mm:5", "speed": "1, 2, 3 rpm"})
    assert several.shape == (5, 3)
    assert [several.row(place) for place in range(15)] == list(several.rows)
    listed = listed_designs(MACHINE, [{"rod_length": "130 mm"}, {"speed": "2 rpm"}, {"rod_length": "131 mm"}])
    assert listed.shape == (3,)
    assert [listed.row(place) for place in range(3)] == list(listed.rows)


class _Late(Alone):
    """Somebody who does the last of three blocks first."""

    n_at_once = 3

    def finished(self):
        return list(super().finished())[::-1]


def test_facts_come_in_order():
    blocks = ((number, [{"place": str(number)}] * (number + 1)) for number in range(7))
    with _Late(deadly) as crew:
        found = [(number, len(part.refused)) for number, part in in_order(blocks, crew) if part is not None]
    assert found == [(number, number + 1) for number in range(7)]


def test_a_block_that_kills_three_processes_is_refused():
    rods = [{"mechanism.rod_length": f"{rod} mm"} for rod in range(10, 20)]
    with Processes(deadly, 2) as crew:
        found = dict(in_order(enumerate([rods[:2], rods[2:4], rods[4:7], rods[7:]]), crew))
    assert [None if part is None else len(part.refused) for part in found.values()] == [2, None, 3, 3]
    assert active_children() == []


def test_that_it_was_killed_is_said(monkeypatch, tmp_path):
    """In a store such a block is not done, and a later run tries it again."""
    monkeypatch.setattr(computed, "_designs_of_block", lambda *_known: 4)
    monkeypatch.setattr(computed, "_MEASURED", 0.0)

    class _Killed(Alone):
        def finished(self):
            for number, part in super().finished():
                yield number, None if number == 3 else part

    vary, path = {"rod_length": "100..138 mm:20"}, tmp_path / "rods.zarr"
    with monkeypatch.context() as patched:
        patched.setattr(computed, "Alone", _Killed)
        part = ct.sweep(MACHINE, vary, WANTED, store=path)
    assert list(part.refused) == [12, 13, 14, 15]
    said = " ".join(str(part).split())
    assert "4 of 20 designs: not computed: each process that began with it was killed; is memory short?" in said
    same(ct.sweep(MACHINE, vary, WANTED, store=path, resume=True), swept(MACHINE, vary, WANTED))


def test_processes_that_are_killed_at_any_moment(monkeypatch):
    """Ten times, at random: what they had is computed again, the facts are the same to the last bit."""
    monkeypatch.setattr(computed, "_designs_of_block", lambda *_known: 40)
    monkeypatch.setattr(computed, "_WORTH", 0.0)
    monkeypatch.setattr("cranktrain.study.sweep.processes.TRIES", 100)
    machine, vary = ct.load("vaz_21213"), {"rod_length": "100..170 mm:990"}
    chosen, is_over, kills = random.Random(53), threading.Event(), []

    def kill():
        while len(kills) < 10 and not is_over.wait(chosen.uniform(0.05, 1.0)):
            children = active_children()
            if children:
                victim = chosen.choice(children)
                os.kill(victim.pid, signal.SIGKILL)
                kills.append(victim.pid)

    killer = threading.Thread(target=kill)
    killer.start()
    try:
        found = swept(machine, vary, ["largest_torque"], processes=2)
    finally:
        is_over.set()
        killer.join()
    assert len(kills) >= 5
    same(found, swept(machine, vary, ["largest_torque"]))


def test_what_is_wrong_in_a_process_is_raised_here():
    with Processes(partial(_wrong, "a word"), 1) as crew, pytest.raises(ZeroDivisionError, match="a word"):
        list(in_order(iter([(0, [{}])]), crew))


def _wrong(word, _rows):
    raise ZeroDivisionError(word)


def test_processes_that_cannot_begin_say_so():
    with Processes(_Unreadable(), 2) as crew, pytest.raises(ct.InputError, match="cannot be started: they end before"):
        list(in_order(iter([(0, [{}])]), crew))


class _Unreadable:
    """What no other process can read."""

    def __reduce__(self):
        return time.sleep, ("no time",)
