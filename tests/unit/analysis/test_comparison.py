"""Two machines side by side: by how much the second is more, from numbers that the files say."""

import numpy as np
import pytest
from tests.machines import ROCKER, V12, slider

import cranktrain as ct
from cranktrain.analysis.figures import difference, percent, shown_in, significant, text_in

SMALL = ct.Machine(name="small", mechanism=slider(), shaft={"main": {"speed": "1500 rpm"}})
LARGE = SMALL.with_({"name": "large", "mechanism.crank_radius": "60 mm", "mechanism.rod_length": "216 mm"})
"""By a fifth larger."""


def row(comparison, quantity, of=""):
    return next(one for one in comparison.rows if (one.quantity, one.of) == (quantity, of))


def test_difference_and_percent():
    compared = ct.compare(SMALL, LARGE)
    stroke, speed = row(compared, "stroke"), row(compared, "mean_piston_speed")
    assert (stroke.question, stroke.unit) == ("motion", "m")
    np.testing.assert_allclose(stroke[4:], (0.1, 0.12, 0.02, 20.0), rtol=1e-9)
    np.testing.assert_allclose(speed[4:], (5.0, 6.0, 1.0, 20.0), rtol=1e-9)  # 2 S n at 25 Hz
    same = row(compared, "closing_margin")  # similar machines
    assert same.percent == pytest.approx(0.0, abs=1e-9)


def test_one_with_other_values():
    compared = ct.compare(SMALL, set={"shaft.main.speed": "3000 rpm"})
    assert row(compared, "mean_piston_speed").percent == pytest.approx(100.0)
    assert row(compared, "stroke").difference == 0.0
    assert "shaft.main.speed = 3000 rpm" in repr(compared)
    assert "changed" in str(compared)


def test_values_of_two_go_for_both():
    compared = ct.compare(SMALL, LARGE, set={"shaft.main.speed": "3000 rpm"}, quantities="mean_piston_speed")
    assert [(one.first, one.second) for one in compared.rows] == [(pytest.approx(10.0), pytest.approx(12.0))]


def test_results_are_compared_as_they_are():
    compared = ct.compare(ct.run(SMALL), ct.run(LARGE), quantities=["stroke"])
    assert compared.rows[0].percent == pytest.approx(20.0)


def test_of_other_structure():
    """A row for what one of them has; where members differ, from the smallest to the largest."""
    compared = ct.compare(ct.Machine(**V12), {"mechanism": ROCKER})
    assert np.isnan(row(compared, "swing").first)
    assert row(compared, "swing").second > 0.5
    of_stroke = {one.of: one for one in compared.rows if one.quantity == "stroke"}
    assert sorted(of_stroke) == ["L", "R"]
    assert all(np.isnan(one.second) for one in of_stroke.values())
    assert "—" in str(compared)
    against = ct.compare(ct.Machine(**V12), SMALL, quantities="stroke")
    assert [one.of for one in against.rows] == ["min", "max"]
    assert against.rows[0].first == pytest.approx(0.18)
    assert [one.second for one in against.rows] == [pytest.approx(0.1)] * 2


def test_same_members_share_a_row():
    wider = ct.Machine(**V12).with_({"bank.L.mechanism.crank_radius": "95 mm"})
    compared = ct.compare(ct.Machine(**V12), wider, quantities="stroke")
    assert [one.of for one in compared.rows] == ["L", "R"]
    np.testing.assert_allclose(compared.rows[0][4:6], (0.18, 0.19), rtol=1e-9)


def test_curves_from_smallest_to_largest():
    compared = ct.compare(SMALL, LARGE, quantities="piston_displacement")
    assert [one.of for one in compared.rows] == ["min", "max"]
    np.testing.assert_allclose([one.first for one in compared.rows], [0.0, 0.1], atol=1e-12)


def test_places_have_no_percent():
    later = SMALL.with_({"crank_zero": "30 deg"})
    compared = ct.compare(SMALL, later, quantities=["top_dead_centre", "largest_piston_speed_at"])
    assert all(np.isnan(one.percent) for one in compared.rows)


def test_numbers_that_are_counted_have_a_row_each():
    torsion = {"torsion": {"stiffness": "3 MN·m/rad", "throw_inertia": "0.2 kg·m²"}}
    engine = ct.load("vaz_21213", set=torsion)
    compared = ct.compare(engine, set={"torsion.stiffness": "12 MN·m/rad"}, quantities="natural_frequency")
    assert [one.of for one in compared.rows] == ["mode 1", "mode 2", "mode 3"]
    # Four times as stiff turns twice as fast to and fro, whatever the discs.
    np.testing.assert_allclose([one.percent for one in compared.rows], 100.0, rtol=1e-6)


def test_the_largest_orders_have_rows():
    """Of an even four-stroke in-line four they are two periods to a turn, and multiples of that."""
    compared = ct.compare("vaz_21213", set={"shaft.main.speed": "4000 rpm"}, quantities="torque_order_amplitude")
    assert {one.of for one in compared.rows} <= {f"order {order}" for order in (2, 4, 6, 8, 10, 12)}
    assert compared.rows[0].of == "order 2"


def test_errors_are_those_of_the_other_methods():
    compared = ct.compare(SMALL, set={"mechanism.rod_length": "360 mm"}, quantities="displacement_error")
    rods = {one.of: one for one in compared.rows}
    assert "exact" not in rods
    # Without a rod the pin's projection misses by r λ sin² φ / 2 of a stroke of 2 r, in first approximation.
    for value, ratio in ((rods["infinite_rod"].first, 50 / 180), (rods["infinite_rod"].second, 50 / 360)):
        assert value == pytest.approx(ratio / 4, rel=0.03)


@pytest.mark.parametrize(
    ("arguments", "options", "path", "said"),
    [
        ((SMALL,), {}, "second", "is missing"),
        ((SMALL,), {"set": "shaft.main.speed=1 rpm"}, "set", "must be a mapping"),
        ((SMALL, LARGE), {"quantities": "swing"}, "quantities", "is a result of neither machine"),
        ((SMALL, LARGE), {"quantities": "gas_pressure"}, "quantities", "it needs [cylinder] bore"),
        ((SMALL, LARGE), {"quantities": "strok"}, "quantities", "is not a quantity"),
        ((SMALL, ct.run([SMALL, LARGE])), {}, "compare", "has several designs"),
    ],
)
def test_what_cannot_be_compared(arguments, options, path, said):
    with pytest.raises(ct.InputError) as caught:
        ct.compare(*arguments, **options)
    assert caught.value.problems[0].path == path
    assert said in str(caught.value)


def test_table():
    lines = str(ct.compare(SMALL, LARGE, quantities=["stroke", "mean_piston_speed"])).splitlines()
    assert lines[0].split() == ["small", "large", "difference", "%"]
    assert lines[1] == "Motion"
    assert lines[2].split() == ["stroke", "100.0", "120.0", "mm", "+20.0", "+20.0", "%"]
    assert lines[3].split() == ["mean", "piston", "speed", "5.000", "6.000", "m/s", "+1.00", "+20.0", "%"]
    assert all(len(line) <= 80 for line in str(ct.compare("3d12", "kamaz_740")).splitlines())
    assert "<td" in ct.compare(SMALL, LARGE)._repr_html_()


def test_files_are_called_without_their_folder(tmp_path):
    for name in ("long_name_of_a_file.toml", "b.toml"):
        text = '[mechanism]\nkind = "slider_crank"\nstroke = "80 mm"\nrod_length = "136 mm"\n'
        (tmp_path / name).write_text(text, encoding="utf-8")
    first, second = (str(tmp_path / name) for name in ("long_name_of_a_file.toml", "b.toml"))
    assert str(ct.compare(first, second)).split()[:2] == ["long_name…", "b"]


def test_machines_of_one_name_are_written_apart():
    heads = str(ct.compare(SMALL, SMALL.with_({"shaft.main.speed": "1 rpm"}))).splitlines()[0]
    assert heads.split()[:2] == ["first", "second"]


@pytest.mark.parametrize(
    ("value", "text"),
    [(180.0, "180.0"), (9.99996, "10.00"), (-0.0123456, "−0.01235"), (123456.0, "123456"), (0.0, "0"), (-1e-12, "0")],
)
def test_four_digits(value, text):
    assert significant(value) == text


def test_differences_are_signed():
    assert (difference(1.0, 3.0), difference(3.0, 1.0), difference(1.0, 1.0 + 1e-14)) == ("+2.00", "−2.00", "0")
    assert (percent(12.345), percent(-0.5), percent(1e-4), percent(0.0)) == ("+12.3 %", "−0.50 %", "< 0.01 %", "0 %")
    assert percent(np.nan) == difference(1.0, np.nan) == "—"


def test_units_of_the_drawing_office():
    assert shown_in("N*m", np.array([1.0])).label == "N·m"
    assert text_in(shown_in("m^3", np.array([1e-5])), 1e-5) == "10.00"  # cm³
    assert text_in(shown_in("1", np.array([0.25])), 0.25) == "25.00"  # %
    assert text_in(shown_in("deg", np.array([90.0])), 90.0) == "90.00"
    assert text_in(shown_in("rad", np.array([np.pi])), np.pi) == "180.0"
