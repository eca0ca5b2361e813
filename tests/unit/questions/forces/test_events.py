"""Events of loads are found by the motion alone."""

import importlib

import pytest

import cranktrain as ct
from cranktrain.questions.forces.loaded_machine import LoadedMachine

events = importlib.import_module("cranktrain.questions.forces.events")


@pytest.fixture
def solved(monkeypatch):
    """How often the forces of a machine are solved while its events are looked for."""
    calls, inside = [], []
    solve, find = LoadedMachine.solved, events._turns

    def counted(self, angle, **given):
        calls.extend(inside)
        return solve(self, angle, **given)

    def turns(*given):
        inside.append(1)
        found = find(*given)
        inside.clear()
        return found

    monkeypatch.setattr(LoadedMachine, "solved", counted)
    monkeypatch.setattr(events, "_turns", turns)
    return calls


@pytest.mark.parametrize("machine", ["pumping_unit_c57", "shaper"])
def test_forces_are_not_solved_for_events_of_loads(solved, machine):
    ct.run(machine, quantities="load_work").find_all()
    assert not solved
