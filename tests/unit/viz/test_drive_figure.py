"""The drive's figure: letters of the source, C drawn where it is near, and every curve with its line."""

import numpy as np
import pytest

from cranktrain.texts.drive_errata import drive_example
from cranktrain.viz.plans.drive_figure import drive_figure


def words(figure):
    return {text.get_text() for axes in figure.axes for text in axes.texts}


@pytest.mark.parametrize(("angle", "has_centre"), [(60.0, True), (0.0, True), (107.0, False)])
def test_letters(angle, has_centre):
    """Near 107° crank and rocker are almost parallel, and C is far away."""
    shown = words(drive_figure(drive_example(), "BB", angle))
    assert {"BB", f"At α = {angle:g}°", "AC/BC = sin(α − β) / sin(α₁ − β),  (10)"} <= shown
    assert any(text.strip("$").strip("{}") in ("C", "\\mathit{C}", "mathit{C}") for text in shown) == has_centre


def test_curves():
    """Four torques, three flywheel moments and one on a scale of its own, four idle torques; no two lines are alike."""
    found = drive_figure(drive_example())
    panels = [axes for axes in found.axes if axes.get_xlim() == (0.0, 360.0)]
    curves = [[line for line in axes.lines if len(line.get_xdata()) > 300] for axes in panels]
    assert [len(own) for own in curves] == [4, 3, 1, 4]
    _active, dry, *_others = (line.get_ydata() for line in curves[0])
    assert np.min(dry) >= 0 and np.max(dry) == pytest.approx(35.485, abs=5e-3)
    (printed,) = curves[2]
    assert np.max(printed.get_ydata()) == pytest.approx(4.5305, abs=1e-3)
    active = curves[0][0]
    highest = np.argmax(active.get_ydata())
    assert (active.get_xdata()[highest], active.get_ydata()[highest]) == pytest.approx((113.0, 29.8597), abs=1e-3)
    for own in curves:
        assert len({(line.get_linewidth(), str(line._dash_pattern)) for line in own}) == len(own)
