"""What hangs on a shaft and the places of its loads alone is found once a run, for all methods and housings."""

import sys

import pytest

import cranktrain as ct
from cranktrain.questions.crankshaft.acting import LoadedShafts
from cranktrain.questions.crankshaft.loads_in_spans import LoadsInSpans

SPANS = sys.modules[LoadsInSpans.__module__]


def counted(monkeypatch, owner, name):
    """Count calls of a function or method that stays what it is."""
    calls, own = [], getattr(owner, name)

    def one_more(*arguments, **named):
        calls.append(arguments)
        return own(*arguments, **named)

    monkeypatch.setattr(owner, name, one_more)
    return calls


@pytest.mark.parametrize("name", ["3d12", "vaz_21213", "deltic", "kamaz_740", "ls3", "mill_engine"])
def test_spans_are_bent_once_and_loads_found_for_grid_points_and_peaks(monkeypatch, name):
    bent, loads = counted(monkeypatch, SPANS, "bent_spans"), counted(monkeypatch, LoadedShafts, "loads")
    cut, torques = counted(monkeypatch, SPANS, "cut_shaft"), counted(monkeypatch, SPANS, "frame_spans")
    ct.run(name)
    assert len(bent) == 1
    assert len(loads) == len(cut) == len(torques) == 3
