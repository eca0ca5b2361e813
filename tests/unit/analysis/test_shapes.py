"""A result whose array has another shape than it declares is told by name, and not read by the wrong dimensions."""

import numpy as np
import pytest
from tests.machines import slider

import cranktrain as ct
from cranktrain.analysis import Stage
from cranktrain.analysis.run import run
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.motion import Array, Coefficient
from cranktrain.record import record
from cranktrain.saying.catalogue import coefficients, quantity
from cranktrain.saying.checks import StageResult

ENGINE = ct.Machine(bank={"A": {"mechanism": slider()}}, shaft={"main": {"throws": ["0 deg", "120 deg", "240 deg"]}})


@record
class Tones(StageResult):
    pitch: Array = quantity("p", "1", ("tone", "crank_angle"), "Pitch", "docs/conventions", "definition")
    place: Coefficient = coefficients(
        "x", "m", ("tone",), "Place", "Velocity", "Acceleration", "docs/conventions", "definition"
    )


def stage_of(pitch, first, labels):
    """A stage that gives arrays of these shapes, where "n" stands for the crank angles of the grid."""

    def tones(grid: CrankAngle) -> Tones:
        n_angles = grid.shown.size
        one, other = (np.zeros([n_angles if size == "n" else size for size in shape]) for shape in (pitch, first))
        right = np.zeros((len(grid.zero), 2))
        return Tones(one, Coefficient(right, other, right), labels=labels)

    return Stage(tones)


TWO = {"tone": ("low", "high")}


@pytest.mark.parametrize("step", [0.5, 1.0, 2.5, 10.0])
def test_what_is_as_declared_is_taken(step):
    result = run(ENGINE, stages=[stage_of((1, 2, "n"), (1, 2), TWO)], step_degrees=step)
    assert result.pitch.shape == (2, round(360 / step))


def test_of_several_designs():
    result = run([ENGINE] * 3, stages=[stage_of((3, 2, "n"), (3, 2), TWO)])
    assert result.pitch.shape == (3, 2, 360)
    with pytest.raises(TypeError, match=r"Tones\.pitch.* has the shape \(1, 2, 360\), .* design \(3\), tone \(2\)"):
        run([ENGINE] * 3, stages=[stage_of((1, 2, "n"), (3, 2), TWO)]).find_all()


@pytest.mark.parametrize(
    ("pitch", "first", "labels", "said"),
    [
        ((2, "n"), (1, 2), TWO, r"Tones\.pitch, the quantity pitch, has the shape \(2, 360\)"),
        ((1, "n", 2), (1, 2), TWO, r"the shape \(1, 360, 2\).* along design \(1\), tone \(2\), crank_angle \(360\)\."),
        ((1, 2, 36), (1, 2), TWO, r"\(1, 2, 36\).*crank_angle \(360\)"),
        ((1, 2, "n"), (1,), TWO, r"Tones\.place\.first, the quantity place_velocity_coefficient, has the shape \(1,\)"),
        ((1, 2, "n"), (1, 2), {"tone": ("low",)}, r"pitch.* tone \(1\)"),
        ((1, 2, "n"), (1, 2), {}, r"tone \(no labels\)"),
    ],
)
def test_what_is_not_is_refused_by_name(pitch, first, labels, said):
    result = run(ENGINE, stages=[stage_of(pitch, first, labels)])
    for _again in range(2):
        with pytest.raises(TypeError, match=said):
            _ = result.pitch


def test_curves_of_a_coarser_grid_are_held_against_that():
    """A stage that counts on the grid of the facts is told so, however close the points are that are shown."""

    def tones(grid: CrankAngle) -> Tones:
        two = np.zeros((1, 2))
        return Tones(np.zeros((1, 2, 360)), Coefficient(two, two, two), labels=TWO)

    with pytest.raises(TypeError, match=r"\(1, 2, 360\).* crank_angle \(720\)"):
        _ = run(ENGINE, stages=[Stage(tones)], step_degrees=0.5).pitch
