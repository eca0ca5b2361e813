"""In which units pictures are: those of the machine's file, or those that were asked for."""

import re

import numpy as np
import pytest
from tests.words_on_paper import words_of as words_with_boxes

import cranktrain as ct
from cranktrain import viz
from cranktrain.plans.polygons import velocity_polygons
from cranktrain.quantities import shown_by, units_by_dimension


def words_of(figure):
    return [text for text, _box in words_with_boxes(figure)]


NAMED = re.compile(r"(?:^|, |\d |(?<=pressure in )|(?<=volume in ))([^\s,\d()=]+?)(?:/mm)?(?= over|,|$)")
KNOWN = {"mm", "in", "m/s", "ft/s", "m/s²", "ft/s²", "kN", "N", "lbf", "kgf", "N·m", "lbf·ft", "bar", "psi", "L"}


def units_of(figure):
    """Units that a picture names: behind a comma or a number, alone in the head of a table, in a heading."""
    return {unit for words in words_of(figure) for unit in NAMED.findall(words)} & KNOWN


PLANS = {
    "positions": ({"in", "m/s", "m/s²"}, {"in", "ft/s", "ft/s²"}),
    "velocities": ({"in", "m/s"}, {"in", "ft/s"}),
    "accelerations": ({"in", "m/s²"}, {"in", "ft/s²"}),
    "klein": ({"in", "m/s", "m/s²"}, {"in", "ft/s", "ft/s²"}),
    "centres": ({"in"}, {"in"}),
    "arc": ({"in"}, {"in"}),
    "brix-backward": ({"in"}, {"in"}),
}


@pytest.mark.parametrize("plan", PLANS)
def test_a_plan_of_a_file_in_inches(plan):
    """The great_northern is all in inches; lengths on paper are millimetres, as its scale says."""
    machine = ct.load("great_northern")
    draw = getattr(viz, f"plan_{plan.replace('-', '_')}")
    own, asked = PLANS[plan]
    assert units_of(draw(machine)) - {"mm"} == own - {"mm"}
    with ct.units("ft/s,ft/s²"):
        assert units_of(draw(machine)) - {"mm"} == asked - {"mm"}


@pytest.mark.parametrize(
    ("plan", "asked"), [("forces", {"lbf", "lbf·ft"}), ("zhukovsky", {"lbf", "lbf·ft"}), ("polar", {"lbf"})]
)
def test_a_plan_of_forces(plan, asked):
    machine = ct.load("3d12")
    forces = {"N", "kN", "kgf", "lbf", "N·m", "lbf·ft"}
    draw = getattr(viz, f"plan_{plan}")
    assert units_of(draw(machine)) & forces <= {"kN", "N·m"}
    with ct.units("lbf, lbf·ft"):
        assert units_of(draw(machine)) & forces == asked


def test_a_scale_factor_is_round_in_the_unit_that_is_shown():
    """One foot is 0.3048 m: 1, 2, 2.5, 4 or 5 of its tenths and hundredths are a millimetre of paper."""
    machine = ct.load("3d12")
    with shown_by(units_by_dimension(["ft/s"])):
        scale = velocity_polygons(machine, [30.0])[0].scale / 0.3048
    digits = scale / 10 ** np.floor(np.log10(scale))
    assert min(abs(digits - step) for step in (1, 2, 2.5, 4, 5, 10)) < 1e-12
    assert velocity_polygons(machine, [30.0])[0].scale in (0.1, 0.2, 0.25, 0.4, 0.5, 1.0)


def test_sheets_and_curves_are_in_the_units_asked_for():
    result = ct.run("3d12")
    with ct.units("psi,in,lbf,lbf·ft,ft/s,ft/s²"):
        forces, sheet, curves = result.sheet("forces"), result.sheet(), result.plot()
    assert units_of(forces) - {"N"} == {"psi", "lbf", "lbf·ft", "L"}  # N is the side force, too
    assert units_of(sheet) == {"in", "ft/s", "ft/s²"}
    assert units_of(curves) == {"in", "ft/s", "ft/s²", "psi", "lbf·ft"}
    assert units_of(result.sheet("forces")) - {"N"} == {"bar", "kN", "N·m", "L"}


def test_curves_of_a_sheet_are_drawn_in_its_unit():
    """The stroke of 180 mm is 7.0866 in."""
    with ct.units("in"):
        figure = ct.run("3d12").sheet()
    travel = next(axes for axes in figure.axes if axes.lines and axes.axison)
    heights = np.concatenate([line.get_ydata() for line in travel.lines if line.get_linewidth() > 1.5])
    assert np.nanmax(heights) == pytest.approx(180 / 25.4, rel=1e-6)
