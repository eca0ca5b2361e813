"""Panels, tops, means and speeds of the compiled cycle, as plain Python: against closed forms."""

import numpy as np
import pytest

from cranktrain.study.cycle.loops import directions
from cranktrain.study.cycle.nodes import nodes
from cranktrain.study.cycle.panels import CutCycle, cut_cycle, panel_room, sorted_edges
from cranktrain.study.cycle.running import (
    energy_for,
    exact_flywheel,
    fluctuation_of,
    integral_of,
    mean_of,
)
from cranktrain.study.cycle.tops import highest, largest_size, mean_size, room_for_tops, unresolved

TURN = 2 * np.pi
NODES = nodes()
NO_POLES = np.zeros(0)


class Cut:
    """A turn cut at some edges."""

    def __init__(self, edges=(), cycle=TURN, poles=NO_POLES, away=NO_POLES, finer=1.0, zero=0.0):
        self.panels = panel_room(NODES)
        self.panels.edge[: len(edges)] = edges
        n_edges = sorted_edges(self.panels.edge, len(edges), cycle)
        counts = cut_cycle(self.panels, n_edges, cycle, np.asarray(poles), np.asarray(away), finer, NODES)
        self.count, self.n_points = counts
        self.cut = CutCycle(self.panels, NODES, *counts, cycle, zero)
        self.tops = room_for_tops(np.zeros(len(self.panels.angle)), NODES)

    @property
    def angle(self):
        return self.panels.angle[: self.n_points]

    def laid(self, curve):
        """Values at the points, in room for many."""
        values = np.zeros(len(self.panels.angle))
        values[: self.n_points] = curve(self.angle)
        return values

    def highest(self, values, sign, zero=0.0):
        return highest(values, sign, self.cut._replace(zero=zero), self.tops)


@pytest.mark.parametrize("edges", [(), (1.0,), (0.3, 2.0, 2.0 + 1e-13, 7.0, -0.5)])
def test_panels_fill_the_cycle_and_begin_at_edges(edges):
    own = Cut(edges, 2 * TURN)
    start, width = own.panels.start[: own.count], own.panels.width[: own.count]
    np.testing.assert_allclose(np.sum(width), 2 * TURN, rtol=1e-14)
    np.testing.assert_allclose(start[1:], (start + width)[:-1], atol=1e-14)
    for edge in np.mod(edges, 2 * TURN):
        assert np.min(np.abs(np.mod(start, 2 * TURN) - edge)) < 1e-11


def test_panels_are_narrow_beside_a_pole():
    own = Cut((0.0,), TURN, [0.0], [0.01])
    assert own.panels.width[0] < 0.05
    curve = own.laid(lambda phi: 1 / (1.0001 - np.cos(phi)))
    assert not unresolved(curve, own.cut, 1e-9)
    assert unresolved(Cut().laid(lambda phi: 1 / (1.0001 - np.cos(phi))), Cut().cut, 1e-9)
    # ∮ dφ/(a − cos φ) = 2π/√(a² − 1)
    np.testing.assert_allclose(mean_of(curve, own.cut), 1 / np.sqrt(1.0001**2 - 1), rtol=1e-9)


def test_no_room_for_panels_is_said():
    assert Cut((0.0,), TURN, [0.0], [1e-9]).count > 0
    assert Cut((0.0,), TURN, np.linspace(0, TURN, 50), np.full(50, 1e-6)).count == 0


def test_directions_are_cosine_and_sine():
    own = Cut((0.4, 3.0), 2 * TURN)
    cos, sin = np.zeros((2, own.n_points))
    directions(own.angle, cos, sin)
    np.testing.assert_allclose(cos, np.cos(own.angle), atol=4e-16)
    np.testing.assert_allclose(sin, np.sin(own.angle), atol=4e-16)


@pytest.mark.parametrize("at", [0.0, 0.7, 3.1, 6.2])
def test_the_top_of_a_smooth_curve(at):
    own = Cut((1.0, 4.0))
    values = own.laid(lambda phi: 3 + np.cos(phi - at) + 0.2 * np.cos(2 * (phi - at)))
    angle, value = own.highest(values, 1.0)
    assert value == pytest.approx(4.2, rel=1e-13)
    assert (angle - at + 1) % TURN - 1 == pytest.approx(0.0, abs=1e-8)
    assert own.highest(values, 1.0, zero=0.5)[0] == pytest.approx((at - 0.5) % TURN, abs=1e-8)


@pytest.mark.parametrize("beside", [-1e-3, 0.0, 1e-3])
def test_a_top_beside_the_edge_of_a_panel(beside):
    """The point that two panels share is no top, but the highest of either."""
    own = Cut((1.0, 1.9))
    values = own.laid(lambda phi: np.cos(phi - 1.9 - beside))
    angle, value = own.highest(values, 1.0)
    assert (angle, value) == (pytest.approx(1.9 + beside, abs=1e-8), pytest.approx(1.0, rel=1e-15))
    x, y = own.laid(lambda phi: 2 + np.cos(phi - 1.9 - beside)), own.laid(lambda phi: 0.0 * phi)
    angle, value = largest_size(x, y, own.cut, own.tops)
    assert (angle, value) == (pytest.approx(1.9 + beside, abs=1e-8), pytest.approx(3.0, rel=1e-15))


def test_a_top_just_behind_a_jump_down():
    """Between the first two points of the panel, of which the first is lower than what stands before the jump."""
    own = Cut((2.0, 5.0))
    values = own.laid(lambda phi: np.where(phi <= 5.0, 1.01 * np.cos(3 * (phi - 2.005)), -1.0))
    first = own.panels.first[: own.count].tolist()
    for panel, point in enumerate(first):  # each side of the jump has a value of its own
        size = NODES.size[own.panels.size[panel]]
        if own.panels.start[panel] >= 5.0 - 1e-9:
            values[point : point + size] = 1.00995 - 0.1 * (2.0 + TURN - own.panels.angle[point : point + size])
    angle, value = own.highest(values, 1.0)
    assert (angle, value) == (pytest.approx(2.005, abs=1e-8), pytest.approx(1.01, rel=1e-12))
    x, y = values + 0.0, own.laid(lambda phi: 0.0 * phi)
    angle, value = largest_size(x, y, own.cut, own.tops)
    assert (angle, value) == (pytest.approx(2.005, abs=1e-8), pytest.approx(1.01, rel=1e-12))


def test_of_alike_tops_the_first_and_of_a_level_its_beginning():
    own = Cut((0.5, 2.0, 3.0))
    assert own.highest(own.laid(lambda phi: np.cos(3 * phi)), -1.0)[0] == pytest.approx(np.pi / 3, abs=1e-7)
    level = own.laid(lambda phi: np.where((phi >= 2.0 - 1e-9) & (phi <= 3.0 + 1e-9), 1.0, 0.5))
    # one value at each end of a panel is that of the panel's own side
    first = own.panels.first[: own.count].tolist()
    for panel, point in enumerate(first):
        is_high = own.panels.start[panel] == pytest.approx(2.0)
        level[point : point + NODES.size[own.panels.size[panel]]] = 1.0 if is_high else 0.5
    assert own.highest(level, 1.0) == (pytest.approx(2.0), 1.0)
    assert own.highest(level, -1.0)[1] == 0.5


def test_tops_that_are_nearly_alike_are_told_apart():
    """The points of one stand better for its top than those of the other, which is higher by 1e-7."""
    for at in np.linspace(0, 1, 23):
        own = Cut((at,))
        values = own.laid(lambda phi, at=at: np.cos(2 * (phi - 0.3)) + 1e-7 * np.cos(phi - 0.3 - np.pi))
        angle, value = own.highest(values, 1.0)
        assert angle == pytest.approx(0.3 + np.pi, abs=1e-6)
        assert value == pytest.approx(1 + 1e-7, rel=1e-13)


def test_sizes_of_vectors():
    own = Cut((0.2, 2.2))
    x, y = own.laid(lambda phi: 3 * np.cos(phi)), own.laid(lambda phi: 2 * np.sin(phi))
    angle, size = largest_size(x, y, own.cut, own.tops)
    assert (angle % np.pi, size) == (pytest.approx(0.0, abs=1e-8), pytest.approx(3.0, rel=1e-14))
    # half of an ellipse's girth by Legendre's integral
    from scipy.special import ellipe

    assert mean_size(x, y, own.cut, own.tops) == pytest.approx(4 * 3 * ellipe(1 - 4 / 9) / TURN, rel=1e-12)


def test_the_mean_size_of_what_passes_through_nothing():
    own = Cut((0.2, 2.2))
    x = own.laid(np.cos)
    nothing = np.zeros_like(x)
    assert mean_size(x, nothing, own.cut, own.tops) == pytest.approx(2 / np.pi, rel=1e-9)


@pytest.mark.parametrize("slow", [0.007, 0.011])
def test_the_mean_size_of_what_turns_round_and_back_between_two_points(slow):
    """|1 − cos φ + s sin φ| with the corners 0 and −2 arctan s, between which ∫ = φ − sin φ − s cos φ is negative."""
    corner = -2 * np.arctan(slow)
    between = -slow - (corner - np.sin(corner) - slow * np.cos(corner))
    own = Cut((0.2, 2.2))
    nothing = np.zeros(len(own.panels.angle))
    for turn in np.linspace(0.0, TURN, 50):
        x = own.laid(lambda phi, turn=turn: 1 - np.cos(phi - turn) + slow * np.sin(phi - turn))
        assert mean_size(x, nothing, own.cut, own.tops) == pytest.approx(1 - 2 * between / TURN, rel=1e-11)


def test_integrals_from_the_first_panel_on():
    own = Cut((0.2, 2.2))
    integral = np.zeros(len(own.panels.angle))
    integral_of(own.laid(lambda phi: 5 + np.cos(phi)), 5.0, own.cut, integral)
    exact = np.sin(own.angle) - np.sin(own.panels.start[0])
    np.testing.assert_allclose(integral[: own.n_points], exact, atol=1e-13)


def test_speed_by_the_energy():
    """A constant inertia: ω² = ω₀²(1 + a sin φ) has the mean over time of a complete elliptic integral."""
    from scipy.special import ellipk

    a, speed, inertia = 0.3, 40.0, 2.5
    own = Cut((0.1,))
    work = own.laid(lambda phi: 0.5 * inertia * speed**2 * a * np.sin(phi))
    carried = own.laid(lambda phi: np.full(phi.shape, 0.5))
    # ⟨1/√(1 + a sin φ)⟩ = 2 K(m)/(π √(1 + a)), m = 2a/(1 + a)
    mean = speed * np.pi * np.sqrt(1 + a) / (2 * ellipk(2 * a / (1 + a)))
    energy = energy_for(work, carried, inertia - 0.5, mean, own.cut)
    assert energy == pytest.approx(0.5 * inertia * speed**2, rel=1e-12)
    found, square = np.zeros(5), np.zeros(len(own.panels.angle))
    assert fluctuation_of(work, carried, inertia - 0.5, mean, own.cut, square, own.tops, found)
    assert found[0] == pytest.approx(speed * np.sqrt(1 + a), rel=1e-12)
    assert found[2] == pytest.approx(speed * np.sqrt(1 - a), rel=1e-12)
    wanted = (found[0] - found[2]) / mean
    flywheel = exact_flywheel(work, carried, mean, wanted, own.cut, square, own.tops)
    assert flywheel == pytest.approx(inertia - 0.5, rel=1e-9)


def test_a_shaft_that_stops_is_left_to_others():
    own = Cut((0.1,))
    work, carried = own.laid(lambda phi: 100 * np.sin(phi)), own.laid(lambda phi: np.ones(phi.shape))
    found, square = np.zeros(5), np.zeros(len(own.panels.angle))
    assert not fluctuation_of(work, carried, 0.0, 5.0, own.cut, square, own.tops, found)
