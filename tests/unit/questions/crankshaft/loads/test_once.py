"""What hangs on a shaft and the places of its loads alone is found once a run, for all methods and housings."""

import sys

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.questions.crankshaft.bending.loads_in_spans import LoadsInSpans
from cranktrain.questions.crankshaft.loads.loaded_shafts import LoadedShafts

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
    """Frames and straight shafts by unit loads; the split shaft alone by the loads as they are."""
    bent, loads = counted(monkeypatch, SPANS, "bent_spans"), counted(monkeypatch, LoadedShafts, "loads")
    cut, frames = counted(monkeypatch, SPANS, "cut_shaft"), counted(monkeypatch, SPANS, "frame_spans")
    ct.run(name).find_all()
    assert len(bent) == len(frames) == 1
    assert len(loads) == 3
    assert len(cut) == 1 + 3


@pytest.mark.parametrize("name", ["deltic", "vaz_21213"])
def test_no_sample_is_beyond_the_extremes_at_the_running_speed(name):
    """Its curve is made of pieces, whose ends are kinks of what inertia takes."""
    found = ct.run(name, speed="running", step_degrees=0.25)
    curve, size = found.section_torque, np.max(np.abs(found.section_torque))
    for ends, sign in ((found.largest_section_torque, 1.0), (found.least_section_torque, -1.0)):
        beyond = np.max(sign * curve, axis=-1) - sign * ends
        assert np.max(beyond) < 1e-13 * size
