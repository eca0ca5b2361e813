"""Curves by name: the numbers of the result, told apart in grey, and shown by a notebook."""

import io

import numpy as np
import pytest
from matplotlib.figure import Figure
from PIL import Image
from tests.machines import ROCKER, V12, slider

import cranktrain as ct

RADIUS, ROD = 50.0, 180.0
"""Of the test's slider-crank. [mm]"""

SMALL = ct.Machine(name="small", mechanism=slider(), shaft={"main": {"speed": "1500 rpm"}})
LARGE = SMALL.with_({"name": "large", "mechanism.crank_radius": "60 mm", "mechanism.rod_length": "216 mm"})


def travel(angle):
    """Travel of the slider in closed form. [mm]"""
    return RADIUS + ROD - RADIUS * np.cos(angle) - np.sqrt(ROD**2 - (RADIUS * np.sin(angle)) ** 2)


def curves(axes):
    """Lines over the crank angle, without the one at zero."""
    return [line for line in axes.lines if len(line.get_xdata()) > 2]


def problems(action):
    with pytest.raises(ct.InputError) as caught:
        action()
    return caught.value.problems


def test_curve_is_the_travel():
    figure = ct.run(SMALL).plot("piston_displacement")
    (line,) = curves(figure.axes[0])
    angle, values = line.get_data()
    np.testing.assert_allclose(values, travel(np.deg2rad(angle)), atol=1e-9)
    assert (angle[0], angle[-1]) == (0.0, 360.0)
    assert "mm" in figure.axes[0].get_title(loc="left")


def test_main_curves_of_a_machine():
    figure = ct.run("3d12").plot()
    assert isinstance(figure, Figure)
    titles = " ".join(axes.get_title(loc="left") for axes in figure.axes)
    assert len(figure.axes) == 5
    for word in ("Travel", "velocity", "acceleration", "pressure", "Torque"):
        assert word in titles
    # the pistons of the first throw, one of each bank
    assert [text.get_text() for text in figure.axes[0].get_legend().get_texts()] == ["1L", "1R"]


def test_members_that_are_wanted():
    result = ct.run(ct.Machine(**V12))
    axes = result.plot("piston_velocity", piston=["2R", "3L"]).axes[0]
    second = ct.run(ct.Machine(**V12)).piston_velocity
    for line, place in zip(curves(axes), (7, 2), strict=True):
        np.testing.assert_allclose(line.get_ydata()[:-1], second[place])
    assert len({(line.get_linestyle(), line.get_linewidth()) for line in curves(axes)}) == 2


def test_designs():
    result = ct.run([SMALL, LARGE])
    ends = [curves(result.plot("piston_displacement", design=k).axes[0])[0].get_ydata().max() for k in (0, 1)]
    np.testing.assert_allclose(ends, [100.0, 120.0], rtol=1e-9)


@pytest.mark.parametrize(
    ("names", "members", "said"),
    [
        (["stroke"], {}, "has one value for the whole cycle"),
        (["piston_velocit"], {}, "did you mean piston_velocity?"),
        (["gas_pressure"], {}, "needs [cylinder] bore"),
        (["piston_velocity"], {"piston": "7"}, "must be one of: 1"),
        (["piston_velocity"], {"pistn": "1"}, "did you mean piston?"),
    ],
)
def test_mistakes(names, members, said):
    (problem,) = problems(lambda: ct.run(SMALL).plot(*names, **members))
    assert said in str(problem)


def test_what_was_asked_for_is_drawn():
    asked = ct.run(SMALL, quantities=["piston_velocity", "stroke"])
    assert len(asked.plot().axes) == 1
    (problem,) = problems(lambda: ct.run(SMALL, quantities="stroke").plot())
    assert "quantities = stroke: has one value for the whole cycle, and no curve" in str(problem)
    (problem,) = problems(asked.sheet)
    assert "without `quantities`" in str(problem)


def test_sheets_by_name():
    result = ct.run("vaz_21213")
    assert isinstance(result.sheet(), Figure)
    assert isinstance(result.sheet("forces", size="A3"), Figure)
    (problem,) = problems(lambda: result.sheet("force"))
    assert str(problem.repair) == "did you mean forces?"


def test_a_notebook_shows_figures():
    picture = Image.open(io.BytesIO(ct.run(SMALL).plot("piston_displacement")._repr_png_()))
    assert picture.width == 880
    assert Image.open(io.BytesIO(ct.run(SMALL).sheet()._repr_png_())).width > 1000


class TestTwo:
    def test_both_on_one_axis(self):
        (axes, *_rest) = ct.compare(SMALL, LARGE).plot("piston_displacement").axes
        first, second = curves(axes)
        np.testing.assert_allclose(first.get_ydata(), travel(np.deg2rad(first.get_xdata())), atol=1e-9)
        np.testing.assert_allclose(second.get_ydata(), 1.2 * first.get_ydata(), atol=1e-9)  # similar machines

    def test_they_are_written_apart_in_grey(self):
        figure = ct.compare(SMALL, LARGE).plot()
        for axes in figure.axes:
            first, second = curves(axes)
            assert first.get_linewidth() > 1.5 * second.get_linewidth()
            assert (first.get_linestyle(), second.get_linestyle()) == ("-", "--")
        assert [text.get_text() for text in figure.legends[0].get_texts()] == ["small", "large"]

    def test_the_shorter_cycle_is_repeated(self):
        four = SMALL.with_({"cylinder": {"bore": "80 mm", "compression_ratio": 9, "cycle": "four-stroke"}})
        first, second = curves(ct.compare(four, LARGE).plot("piston_displacement").axes[0])
        assert first.get_xdata()[-1] == second.get_xdata()[-1] == 720.0
        np.testing.assert_allclose(second.get_ydata()[:360], second.get_ydata()[360:720], atol=1e-9)

    def test_machines_of_other_kinds(self):
        compared = ct.compare(SMALL, {"name": "rocker", "mechanism": ROCKER})
        titles = [axes.get_title(loc="left") for axes in compared.plot().axes]
        assert any("piston" in title for title in titles)
        assert any("rocker" in title for title in titles)
        (problem,) = problems(lambda: compared.plot("gas_pressure"))
        assert "needs [" in str(problem)

    def test_what_was_asked_for_is_drawn(self):
        assert len(ct.compare(SMALL, LARGE, quantities=["stroke", "piston_velocity"]).plot().axes) == 1
