"""A turn in pieces: tops in closed form, of level curves too, and the counterbalance that is best in a few trials."""

import numpy as np
import pytest

from cranktrain.questions.pumping.balanced import balanced
from cranktrain.questions.pumping.turn_pieces import TurnPieces, highest, turn_pieces

TURN = 2 * np.pi


@pytest.fixture
def pieces():
    return turn_pieces(np.array([0.5, np.nan, 0.52, 2.0, 4.0001]), TURN)


def test_tops_are_exact(pieces):
    angle = pieces.cut.angle
    curves = np.stack([np.sin(angle) + 0.1 * np.cos(3 * angle), -np.cos(angle - 5.0)])
    found = highest(pieces.tops(curves), pieces.within(0.5, 2.0))
    # cos φ = 0.3 sin 3φ, which is 0.3 (3 s − 4 s³).
    way = 1.5
    for _step in range(60):
        way = np.arccos(0.3 * np.sin(3 * way))
    inside = way if 0.5 < way < 2.0 else TURN - way
    assert abs(np.cos(inside) - 0.3 * np.sin(3 * inside)) < 1e-14
    assert found.angle[0] == pytest.approx(inside, abs=1e-12)
    assert found.value[0] == pytest.approx(np.sin(inside) + 0.1 * np.cos(3 * inside), rel=1e-14)
    assert found.angle[1] == pytest.approx(5.0 - np.pi, abs=1e-12)
    assert found.value[1] == pytest.approx(1.0, rel=1e-14)


def test_top_at_a_break_is_the_limit_from_its_side(pieces):
    angle = pieces.cut.angle
    rising = np.where((angle > 0.52) & (angle < 2.0), angle, 0.0)
    found = highest(pieces.tops(rising[np.newaxis]), pieces.within(0.5, 4.0001))
    assert found.angle[0] == pytest.approx(2.0, abs=1e-14)
    assert found.value[0] == pytest.approx(2.0, rel=1e-14)


def test_of_a_level_curve_the_first_angle_counts(pieces):
    level = np.where(pieces.cut.angle > 2.0, 3.0, 1.0)
    found = highest(pieces.tops(level[np.newaxis]), pieces.within(0.5, TURN))
    assert found.angle[0] == pytest.approx(2.0, abs=1e-14)
    assert found.value[0] == pytest.approx(3.0, rel=1e-14)


def test_within_is_a_part_of_the_turn_and_the_rest_of_it(pieces):
    up = pieces.within(2.0, 4.0001)
    assert np.array_equal(up, ~pieces.within(4.0001, 2.0 + TURN))
    middle = np.mod(pieces.cut.start + pieces.cut.width / 2, TURN)
    assert np.array_equal(up, (middle > 2.0) & (middle < 4.0001))


@pytest.mark.parametrize("share", [0.3, 0.9, 1.0, 1.1, 3.0])
def test_best_weights_take_a_few_trials(monkeypatch, share):
    """Two lobes of 7 and 4 with −share·sin φ: equal where both are 5.5."""
    pieces = turn_pieces(np.array([0.0, np.pi]), TURN)
    sine = np.sin(pieces.cut.angle)
    rod = np.where(sine > 0, 7.0, -4.0) * sine
    trials = []
    tops = TurnPieces.tops
    monkeypatch.setattr(TurnPieces, "tops", lambda self, curves: trials.append(len(curves)) or tops(self, curves))
    found = balanced(pieces, rod, -share * sine, (0.0, np.pi))
    assert found.equal_peaks == pytest.approx(1.5 / share, rel=1e-12)
    assert sum(trials) <= 5


def test_weights_at_a_right_angle_make_no_peaks_equal():
    pieces = turn_pieces(np.array([0.0, np.pi]), TURN)
    sine, cosine = np.sin(pieces.cut.angle), np.cos(pieces.cut.angle)
    found = balanced(pieces, np.where(sine > 0, 7.0, -4.0) * sine, cosine, (0.0, np.pi))
    assert np.isnan(found.equal_peaks)
