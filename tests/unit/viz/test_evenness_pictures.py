"""Diagrams of the flywheel on paper: nothing overlaps, and what they say is there."""

import numpy as np
import pytest
from tests.unit.questions.evenness.test_evenness import ENGINE, MASSES_ALONE
from tests.words_on_paper import assert_words_are_readable, words_of

import cranktrain as ct
from cranktrain.viz import plan_mertsalov, plan_wittenbauer

WITHOUT_MASS = {name: table for name, table in ENGINE.items() if name != "masses"}
MACHINES = {"engine": (ENGINE, 0.02), "masses alone": (MASSES_ALONE, 0.001), "no masses": (WITHOUT_MASS, 0.3)}


@pytest.fixture(scope="module", params=MACHINES)
def result(request):
    machine, coefficient = MACHINES[request.param]
    return ct.run(ct.Machine(**machine, evenness={"coefficient": coefficient}), step_degrees=2)


@pytest.mark.parametrize("draw", [plan_wittenbauer, plan_mertsalov])
@pytest.mark.parametrize("size", ["A4", "A3"])
def test_diagram_is_readable(result, draw, size):
    figure = draw(result, size=size)
    assert_words_are_readable(figure)
    words = " | ".join(text for text, _box in words_of(figure))
    for part in ("exact", "Mertsalov", "textbook", "J, kg·m²", "GD², kg·m²", "J"):
        assert part in words


def test_of_one_of_several_designs():
    machines = [ct.Machine(**ENGINE, evenness={"coefficient": delta}) for delta in (0.02, 0.05)]
    both = ct.run(machines, step_degrees=2)
    for draw in (plan_wittenbauer, plan_mertsalov):
        of_second = [text for text, _box in words_of(draw(both, design=1))]
        alone = [text for text, _box in words_of(draw(ct.run(machines[1], step_degrees=2)))]
        assert of_second == alone
        assert "0.05" in of_second


EVEN_BY_ITSELF = {"deltic": 0.005, "10d100": 0.005}


@pytest.mark.parametrize("name", EVEN_BY_ITSELF)
def test_inertia_that_does_not_change_is_drawn_as_a_line(name):
    """Rounding of the reduced inertia must not fill the sheet: the tangents' slope sets the scale."""
    wanted = ct.load(name).with_({"evenness.coefficient": EVEN_BY_ITSELF[name]})
    result = ct.run(wanted, step_degrees=2)
    close = plan_wittenbauer(result).axes[1]
    curve = next(line for line in close.lines if len(line.get_xdata()) > 2)
    assert np.ptp(curve.get_xdata()) < 1e-4 * np.ptp(close.get_xlim())
    words = [text for text, _box in words_of(plan_wittenbauer(result))]
    assert not any("e−" in text or "e-" in text for text in words)


def test_flywheel_that_is_not_needed_has_no_size():
    deltic = ct.load("deltic").with_({"evenness.coefficient": EVEN_BY_ITSELF["deltic"]})
    words = [text for text, _box in words_of(plan_mertsalov(ct.run(deltic, step_degrees=2)))]
    assert "not needed" in words
    assert not any("%" in text for text in words)


def test_crank_angles_of_one_point_share_a_label():
    words = [text for text, _box in words_of(plan_wittenbauer(ct.run(ct.load("vaz_21213"), step_degrees=2)))]
    assert {"0° + 180°k", "60° + 180°k", "120° + 180°k"} <= set(words)


def test_tangents_are_drawn_at_both_speeds():
    result = ct.run(ct.Machine(**ENGINE, evenness={"coefficient": 0.05}))
    close = plan_wittenbauer(result).axes[1]
    slopes = [
        float(np.diff(line.get_ydata())[0] / np.diff(line.get_xdata())[0])
        for line in close.lines
        if len(line.get_xdata()) == 2
    ]
    fast, slow = (np.sqrt(2 * slope) for slope in slopes)
    assert fast - slow == pytest.approx(0.05 * 30 * np.pi, rel=1e-9)
