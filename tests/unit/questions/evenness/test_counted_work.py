"""Work on both sides of events is found once for each kind of chamber, whatever asks for it."""

import importlib

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.motion import Coefficient
from cranktrain.numerics.periodic import piecewise_curve
from cranktrain.numerics.piecewise import piece_extremes, pieces_from, quintics

subintervals = importlib.import_module("cranktrain.numerics.subintervals")


@pytest.mark.parametrize(("machine", "n_kinds"), [("r_1340", 9), ("gas_compressor", 2), ("3d12", 2)])
def test_each_kind_of_chamber_is_asked_once(monkeypatch, machine, n_kinds):
    asked = []
    beside = subintervals._beside
    monkeypatch.setattr(subintervals, "_beside", lambda *given: asked.append(1) or beside(*given))
    ct.run(machine, quantities="excess_work").find_all()
    assert len(asked) == n_kinds


def test_extremes_are_looked_for_where_the_curve_turns():
    """Of 100 pieces of a sine two have its extremes; a corner has the largest value."""
    starts = np.linspace(0.0, 2 * np.pi, 100, endpoint=False)[np.newaxis]
    pieces = pieces_from(starts, 2 * np.pi)

    def motion(angle):
        corner = 1.5 * np.exp(-np.abs(angle - starts[0, 30]) * 9)
        slope = -9 * corner
        return Coefficient(np.sin(angle) + corner, np.cos(angle) + slope, -np.sin(angle) + 81 * corner)

    ends = starts + pieces.width
    after, before = motion(starts), motion(ends)
    curve = piecewise_curve(quintics(before, after, pieces.width), pieces, np.zeros((1, 100)), 2 * np.pi)
    looked = []

    def among(chosen):
        own = curve.among(chosen)
        looked.append(chosen if chosen is None else np.count_nonzero(chosen))
        return own

    least, most = piece_extremes(among, pieces)
    assert looked[0] is None
    assert looked[1] <= 3
    assert least.value == pytest.approx(-1.0, rel=1e-9)
    assert most.angle == pytest.approx(starts[0, 30], abs=1e-12)
