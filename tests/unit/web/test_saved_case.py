"""A saved case beside a machine: facts with their difference, curves among the machine's, and by how much more."""

import numpy as np
import pytest
from tests.unit.web.test_page import EXAMPLES, result

import cranktrain as ct
from cranktrain.panels.shapes import Curve, Panel
from cranktrain.web.packed import packed
from cranktrain.web.page import tab_content, tab_names
from cranktrain.web.parts import PageCurves
from cranktrain.web.saved_curves import differences, with_saved


def curves_of(content):
    parts = [part for sheet in content.sheets for column in sheet.columns for part in column]
    return [part for part in parts if isinstance(part, PageCurves)]


@pytest.fixture(scope="module")
def longer():
    """The V12 with a stroke that is a tenth longer."""
    return ct.run("3d12", set={"bank.L.mechanism.stroke": "198 mm"})


def test_a_longer_stroke_is_more_by_what_it_was_made_longer(longer):
    content = tab_content(longer, "Motion", result("3d12"))
    row = next(row for row in content.beside.rows if row[0].startswith("stroke, L"))
    assert row == ("stroke, L", "180.0", "198.0", "mm", "+18.0", "+10.0 %")


def test_curves_of_the_saved_case_are_those_that_it_has_alone(longer):
    (beside,) = curves_of(tab_content(longer, "Motion", result("3d12")))
    (alone,) = curves_of(tab_content(result("3d12"), "Motion"))
    for panel, own in zip(beside.panels, alone.panels, strict=True):
        if panel.unit != own.unit:
            continue
        saved = [curve for curve in panel.curves if curve.role == "saved"]
        assert len(saved) == len(own.curves)
        for one, other in zip(saved, own.curves, strict=True):
            np.testing.assert_array_equal(one.values, other.values)
    assert all(curve.role != "saved" for panel in alone.panels for curve in panel.curves)
    assert alone.differences == ()


def test_speeds_at_another_speed_of_the_shaft_differ_in_its_proportion():
    quick = ct.run("burning_cylinder", set={"shaft.main.speed": "3000 rpm"})
    slow = ct.run("burning_cylinder", set={"shaft.main.speed": "2000 rpm"})
    (stack,) = curves_of(tab_content(quick, "Motion", slow))
    (alone,) = curves_of(tab_content(quick, "Motion"))
    velocity = next(place for place, panel in enumerate(alone.panels) if panel.curves[0].letter == "v")
    own, more = alone.panels[velocity].curves[0].values, stack.differences[velocity].curves[0].values
    np.testing.assert_allclose(more, own / 3.0, atol=1e-12 * np.max(np.abs(own)))
    assert str(stack.differences[velocity].title).endswith("now less saved")


def test_nothing_differs_from_itself():
    for name in EXAMPLES:
        for tab in tab_names(result(name)):
            content = tab_content(result(name), tab, result(name))
            for row in content.beside.rows if content.beside else ():
                assert row[4] in ("0", "—"), row
            for part in curves_of(content):
                for panel in part.differences:
                    assert all(np.nanmax(np.abs(curve.values), initial=0.0) == 0.0 for curve in panel.curves)


@pytest.mark.parametrize("names", [("jaw_crusher", "3d12"), ("3d12", "jaw_crusher"), ("shaper", "deltic")])
def test_machines_that_have_little_in_common_stand_beside_each_other(names):
    one, other = map(result, names)
    for tab in tab_names(one):
        beside, alone = (tab_content(one, tab, saved).answer for saved in (other, None))
        assert packed(beside).data == packed(alone).data


def test_a_curve_over_other_places_is_read_between_its_points_and_nowhere_else():
    def panel(across, values):
        return Panel("x", "m", np.array(across), (Curve(np.array(values), "first", "s"),))

    now, saved = panel([0.0, 10.0, 20.0], [1.0, 2.0, 3.0]), panel([0.0, 20.0], [0.0, 1.0])
    (more,) = differences([now], [saved])
    np.testing.assert_allclose(more.curves[0].values, [1.0, 1.5, 2.0])
    (shorter,) = differences([now], [panel([0.0, 10.0], [0.0, 1.0])])
    assert np.isnan(shorter.curves[0].values[2])
    assert differences([now], [panel([0.0, 20.0, 10.0], [0.0, 1.0, 2.0])]) == ()
    (kept,) = with_saved([now], [])
    assert kept is now
